/* SPDX-License-Identifier: MIT */
/*
 * Paths, by the library's verifier and by samples. The samples share nothing with it: a place on a leg is computed from what tdsp/types.h says of
 * legs, and measured against the discs one by one.
 */
#include "soak/checks.h"

#include <math.h>

#include "tdsp/verify.h"

enum { MOST_LEGS = 4096, SAMPLES = 9 };

static tdsp_leg legs[MOST_LEGS];

static size_t take_path(soak_case *c)
{
    size_t count = 0;
    const tdsp_status status = tdsp_solver_path(c->world.solver, legs, MOST_LEGS, &count);
    if (status != TDSP_OK) soak_fail(c, INFINITY, "no path: %s", tdsp_status_name(status));
    return status == TDSP_OK ? count : 0;
}

static void verify(soak_case *c, double departure, double arrival, const char *text)
{
    tdsp_verdict verdict;
    const size_t count = take_path(c);
    if (c->failed) return;
    const tdsp_status status = tdsp_verify_path(c->world.scene, legs, count, departure, arrival, &verdict);
    if (status != TDSP_OK) {
        soak_fail(c, INFINITY, "the verifier says %s", tdsp_status_name(status));
        return;
    }
    if (verdict.problems)
        soak_fail(c, -verdict.min_clearance / c->scene->journey.speed,
                  "%s is rejected: problems %u, clearance %.3g, tolerance %.3g, leg %zu of %zu, departure %.17g", text,
                  verdict.problems, verdict.min_clearance, verdict.tolerance, verdict.leg, count, departure);
}

void soak_check_path(soak_case *c)
{
    const double arrival = soak_ask(c, &c->world, c->departure);
    if (arrival < INFINITY) verify(c, c->departure, arrival, "the path");
}

/* -------------------------------------------------------------------------------------------------------------- samples */

/* The polynomial of degree 5 with values, first and second derivatives at both ends of a unit. */
static double hermite(double x, const double at[2], const double first[2], const double second[2])
{
    const double x3 = x * x * x, x4 = x3 * x, x5 = x4 * x, rise = 10.0 * x3 - 15.0 * x4 + 6.0 * x5;
    return at[0] + (at[1] - at[0]) * rise + first[0] * (x - 6.0 * x3 + 8.0 * x4 - 3.0 * x5) +
           first[1] * (-4.0 * x3 + 7.0 * x4 - 3.0 * x5) + second[0] * (0.5 * x * x - 1.5 * x3 + 1.5 * x4 - 0.5 * x5) +
           second[1] * (0.5 * x3 - x4 + 0.5 * x5);
}

/* The rate of the angle and its derivative, on a curve. */
static void turning(double speed, double radius, double rate, double bend, double *first, double *second)
{
    const double across = sqrt(fmax(0.0, speed * speed - rate * rate));
    *first = across / radius;
    *second = (across > 0.0 ? -rate * bend / (across * radius) : 0.0) - across * rate / (radius * radius);
}

static tdsp_point around(const tdsp_leg *leg, double radius, double turned)
{
    const double angle = leg->angle_from + leg->turn * turned;
    return (tdsp_point){leg->center.x + radius * cos(angle), leg->center.y + radius * sin(angle)};
}

static tdsp_point place_on_curve(const tdsp_leg *leg, double x)
{
    const double time = leg->end_time - leg->start_time, radii[2] = {leg->radius_from, leg->radius_to},
                 angles[2] = {0.0, leg->sweep};
    const double rates[2] = {leg->rate_from * time, leg->rate_to * time},
                 bends[2] = {leg->bend_from * time * time, leg->bend_to * time * time};
    double first[2], second[2];
    turning(leg->speed, leg->radius_from, leg->rate_from, leg->bend_from, &first[0], &second[0]);
    turning(leg->speed, leg->radius_to, leg->rate_to, leg->bend_to, &first[1], &second[1]);
    for (int k = 0; k < 2; k++) {
        first[k] *= time;
        second[k] *= time * time;
    }
    return around(leg, hermite(x, radii, rates, bends), hermite(x, angles, first, second));
}

static tdsp_point place_on_arc(const tdsp_leg *leg, double x)
{
    const double grown = leg->radius_to - leg->radius_from, radius = leg->radius_from + grown * x;
    const double share = grown == 0.0 ? x : log1p(grown * x / leg->radius_from) / log1p(grown / leg->radius_from);
    return around(leg, radius, leg->sweep * share);
}

static tdsp_point place_on(const tdsp_leg *leg, double x)
{
    if (leg->kind == TDSP_LEG_CURVE) return place_on_curve(leg, x);
    if (leg->kind == TDSP_LEG_ARC) return place_on_arc(leg, x);
    return (tdsp_point){leg->from.x + (leg->to.x - leg->from.x) * x, leg->from.y + (leg->to.y - leg->from.y) * x};
}

/* As tdsp/verify.h grants it: 1e-9 of the journey or the way, and 1e-13 of the greatest number that comes into it. */
static double tolerance_of(const soak_case *c, double departure, double arrival)
{
    const double way = (arrival - departure) * c->scene->journey.speed;
    return 1e-9 * fmax(soak_distance(c->scene), way) + 1e-13 * (soak_magnitude(c->scene) + c->scene->journey.speed * arrival);
}

static void is_clear(soak_case *c, tdsp_point at, double time, double tolerance)
{
    for (size_t i = 0; i < c->scene->count; i++) {
        const tdsp_point center = c->scene->discs[i].center;
        const double radius = soak_radius(c->scene, i, time), clearance = hypot(at.x - center.x, at.y - center.y) - radius;
        /* A radius may be far greater than all coordinates by then. */
        if (radius > 0.0 && clearance < -tolerance - 1e-13 * radius)
            soak_fail(c, -clearance / c->scene->journey.speed,
                      "a sample at time %.17g is %.3g inside disc %zu (tolerance %.3g), departure %.17g", time, -clearance, i,
                      tolerance, c->departure);
    }
}

/* The robot went from one place to another in this time. */
static void is_reachable(soak_case *c, tdsp_point from, tdsp_point to, double time, double tolerance)
{
    const double length = hypot(to.x - from.x, to.y - from.y), most = c->scene->journey.speed * time * (1.0 + 1e-9) + tolerance;
    if (length > most)
        soak_fail(c, (length - most) / c->scene->journey.speed, "a sample is %.3g farther than the robot goes, departure %.17g",
                  length - most, c->departure);
}

void soak_check_sample(soak_case *c)
{
    const double arrival = soak_ask(c, &c->world, c->departure);
    if (!(arrival < INFINITY)) return;
    const size_t count = take_path(c);
    const double tolerance = tolerance_of(c, c->departure, arrival);
    tdsp_point at = c->scene->journey.source;
    double time = c->departure;
    for (size_t i = 0; i < count; i++)
        for (int k = 0; k <= SAMPLES; k++) {
            const double x = k / (double)SAMPLES, then = legs[i].start_time + (legs[i].end_time - legs[i].start_time) * x;
            const tdsp_point next = place_on(&legs[i], x);
            is_reachable(c, at, next, then - time, tolerance);
            is_clear(c, next, then, tolerance);
            at = next;
            time = then;
        }
    is_reachable(c, at, c->scene->journey.destination, arrival - time, tolerance);
}

/* --------------------------------------------------------------------------------------------------------------- within */

void soak_check_within(soak_case *c)
{
    static const double deltas[] = {0.0, 1e-9, 1e-3, 0.05, 0.3, 1.0};
    const double delta = deltas[soak_pick(c, 6)], t = c->departure;
    double arrival = -1.0, lower = -1.0;
    const tdsp_status status = tdsp_earliest_arrival_within(c->world.solver, t, delta, &arrival, &lower);
    if (status == TDSP_SHRINKS || soak_is_far(&c->world, status, t)) return;
    if (!tdsp_status_is_answer(status)) soak_fail(c, INFINITY, "within %g: status %s", delta, tdsp_status_name(status));
    if (status == TDSP_OK) {
        verify(c, t, arrival, "the path within a share");
        const double most = (1.0 + delta) * (lower - t) + soak_slack(c, &c->world, t, arrival);
        if (!(arrival - t <= most && lower <= arrival))
            soak_fail(c, arrival - t - most, "within %g: from %.17g to %.17g, departure %.17g", delta, lower, arrival, t);
    }
    soak_not_after(c, &c->world, t, lower, "the lower end within a share");
    soak_not_before(c, &c->world, t, arrival, "the upper end within a share");
}
