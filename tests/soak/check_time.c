/* SPDX-License-Identifier: MIT */
/* What holds between departures: the travel time never falls, and the latest departure is the inverse of the earliest arrival. */
#include <math.h>

#include "soak/checks.h"
#include "soak/departures.h"

#include "tdsp/verify.h"

/* Latest departures are looked past by this share of the times at hand. */
#define PAST 1e-9

/* The sides of a jump are seen from this share of the times at hand: so near that a steep rise beside it does not matter. */
#define SIDES 1e-10

enum { RISES = 3 };

static double past(const soak_case *c, double departure)
{
    return departure + PAST * (c->world.unit + departure);
}

void soak_check_bounds(soak_case *c)
{
    const double t = c->departure, source = tdsp_scene_source_free_until(c->world.scene, NULL);
    double arrival = -1.0;
    const tdsp_status status = tdsp_earliest_arrival(c->world.solver, t, &arrival);
    if (status == TDSP_SHRINKS || soak_is_far(&c->world, status, t)) return;
    if (!tdsp_status_is_answer(status)) soak_fail(c, INFINITY, "status %s at departure %.17g", tdsp_status_name(status), t);
    if ((status == TDSP_SOURCE_COVERED) != (t > source))
        soak_fail(c, fabs(t - source), "status %s at departure %.17g, and the source is free until %.17g",
                  tdsp_status_name(status), t, source);
    if (status != TDSP_OK) return;
    const double slack = soak_slack(c, &c->world, t, arrival), least = t + c->world.unit,
                 most = tdsp_scene_destination_free_until(c->world.scene, NULL);
    if (arrival < least - slack) soak_fail(c, least - arrival, "arrival %.17g before a straight line's, %.17g", arrival, least);
    if (arrival > most + slack)
        soak_fail(c, arrival - most, "arrival %.17g after the destination is covered, %.17g", arrival, most);
}

/*
 * The travel time of `later` is no shorter than that of `before`. Touches excuse nothing here: both are decided by the same engine in the same scene. Only
 * a jump may lie elsewhere by its rounding, and places by theirs.
 */
static void rises(soak_case *c, double before, double later)
{
    const double travel = soak_ask(c, &c->world, later) - later, least = soak_ask(c, &c->world, before) - before;
    const double slack = soak_slack(c, &c->world, later, later + travel),
                 jump = fmax(0.0, before - soak_step(c, &c->world, before));
    soak_world smaller;
    if (isnan(travel) || isnan(least) || !(travel < least - slack)) return;
    c->forgiven++;
    c->touches = 0.0;
    if (!soak_open_moved(c, &c->world, jump, -1.0, &smaller)) return;
    const double bound = soak_ask(c, &smaller, jump) - jump;
    soak_close(&smaller);
    if (travel < bound - slack)
        soak_fail(c, bound - travel, "the travel time falls by %.3g: %.17g at %.17g, %.17g at %.17g", bound - travel, least,
                  before, travel, later);
}

void soak_check_rise(soak_case *c)
{
    double before = c->departure;
    for (int k = 1; k <= RISES; k++) {
        const double then = k == RISES ? c->later : c->departure + (c->later - c->departure) * soak_pick_between(c, 0.0, 1.0);
        rises(c, fmin(before, then), fmax(before, then));
        before = then;
    }
}

/*
 * At a jump the answer is that of one of its sides: never a third, and never none where both have one. A boundary that comes over the source is no jump: arrivals
 * rise steeply there.
 */
static void has_two_sides(soak_case *c, const soak_world *world)
{
    const double t = c->departure, width = SIDES * (world->unit + t), from = t - width, to = t + width;
    if (from < 0.0 || to > tdsp_scene_source_free_until(world->scene, NULL)) return;
    const double low = soak_ask(c, world, from) - from, high = soak_ask(c, world, to) - to;
    if (!(high > low + 1e-3 * world->unit)) return;
    const double jump = soak_find_jump(world, from, to), next = nextafter(jump, INFINITY);
    if (jump < 0.0 || !(soak_ask(c, world, next) - soak_ask(c, world, jump) > 0.3 * fmin(high - low, 1e3 * world->unit))) return;
    const double seen = soak_ask(c, world, t) - t, same = 1e-4 * world->unit;
    if (isnan(seen) || seen == low || seen == high || fabs(seen - low) <= same || fabs(seen - high) <= same) return;
    soak_fail(c, fmin(fabs(seen - low), fabs(seen - high)),
              "a third travel time %.17g at a jump from %.17g to %.17g, departure %.17g", seen, low, high, t);
}

void soak_check_sides(soak_case *c)
{
    has_two_sides(c, &c->world);
}

void soak_check_general_sides(soak_case *c)
{
    soak_world general;
    if (!soak_has_rates_only(c->scene) || soak_open(c->scene, TDSP_METHOD_GENERAL, &general) != TDSP_OK) return;
    has_two_sides(c, &general);
    soak_close(&general);
}

void soak_check_repeat(soak_case *c)
{
    double latest;
    const double first = soak_ask(c, &c->world, c->departure);
    (void)soak_ask(c, &c->world, c->later);
    (void)tdsp_latest_departure(c->world.solver, 2.0 * c->world.unit + c->departure, &latest, NULL);
    const double second = soak_ask(c, &c->world, c->departure);
    if (first != second && !isnan(first))
        soak_fail(c, fabs(second - first), "first %.17g, then %.17g, at departure %.17g", first, second, c->departure);
}

/* The latest departure in a world for an arrival; NAN where it has none. */
static double latest_in(soak_case *c, const soak_world *world, double arrival, double *arrives)
{
    double departure = NAN;
    *arrives = NAN;
    const tdsp_status status = tdsp_latest_departure(world->solver, arrival, &departure, arrives);
    if (!tdsp_status_is_answer(status) && status != TDSP_SHRINKS && !soak_is_far(world, status, arrival))
        soak_fail(c, INFINITY, "latest departure for %.17g: status %s", arrival, tdsp_status_name(status));
    return status == TDSP_OK ? departure : NAN;
}

/* The departure `t` arrives by `a`; the latest one is not before. Where discs that are larger by a touch say otherwise, they are asked. */
static void is_no_earlier(soak_case *c, double t, double a, double latest)
{
    const double least = t - soak_slack(c, &c->world, t, a);
    soak_world larger;
    double arrives;
    if (latest >= least) return;
    if (!soak_open_moved(c, &c->world, t, 1.0, &larger)) return;
    double bound = latest_in(c, &larger, a, &arrives);
    soak_close(&larger);
    c->forgiven++;
    if (isnan(bound)) bound = -INFINITY;
    bound = fmin(bound, t) - soak_slack(c, &c->world, t, a) - soak_step(c, &c->world, t);
    if (!(latest >= bound)) soak_fail(c, bound - latest, "latest departure %.17g for %.17g, which %.17g reaches", latest, a, t);
}

static void path_is_good(soak_case *c, double departure, double arrives)
{
    static tdsp_leg legs[4096];
    size_t count;
    tdsp_verdict verdict;
    if (tdsp_solver_path(c->world.solver, legs, 4096, &count) != TDSP_OK) {
        soak_fail(c, INFINITY, "no path of the latest departure %.17g", departure);
        return;
    }
    if (tdsp_verify_path(c->world.scene, legs, count, departure, arrives, &verdict) != TDSP_OK || verdict.problems)
        soak_fail(c, fabs(verdict.min_clearance) / c->scene->journey.speed,
                  "the path of the latest departure %.17g is rejected: problems %u, clearance %.3g", departure, verdict.problems,
                  verdict.min_clearance);
}

void soak_check_latest(soak_case *c)
{
    const double t = c->departure, arrival = soak_ask(c, &c->world, t);
    double arrives;
    if (!(arrival < INFINITY)) return;
    /* In part of the cases somewhat later, so that some are inside a jump. */
    const double a = (arrival + (soak_pick(c, 2) ? 0.0 : c->world.unit * soak_pick_between(c, 0.0, 0.5))) * (1.0 + 1e-15);
    const double latest = latest_in(c, &c->world, a, &arrives), slack = soak_slack(c, &c->world, t, a);
    if (isnan(latest)) {
        /* Where a radius shrinks on the way, or what is a touch is decided otherwise. */
        if (tdsp_scene_valid_until(c->world.scene, NULL) == INFINITY) is_no_earlier(c, t, a, -INFINITY);
        return;
    }
    is_no_earlier(c, t, a, latest);
    path_is_good(c, latest, arrives);
    if (!(arrives <= a + slack))
        soak_fail(c, arrives - a, "latest departure %.17g for %.17g arrives at %.17g", latest, a, arrives);
    soak_agrees(c, &c->world, latest, arrives, "the arrival of the latest departure");
    if (latest < INFINITY && arrives < INFINITY)
        soak_not_after(c, &c->world, past(c, latest), a, "later than the latest departure");
}

void soak_check_too_early(soak_case *c)
{
    const double first = soak_ask(c, &c->world, 0.0), early = first - 1e-6 * c->world.unit;
    double latest = NAN, arrives;
    if (!(first < INFINITY) || !(early >= 0.0) || early == first) return;
    const tdsp_status status = tdsp_latest_departure(c->world.solver, early, &latest, &arrives);
    if (status == TDSP_ARRIVAL_TOO_EARLY || status == TDSP_SHRINKS) return;
    if (status == TDSP_OK)
        soak_not_before(c, &c->world, 0.0, early, "a latest departure for what is too early");
    else
        soak_fail(c, INFINITY, "latest departure for %.17g, too early: status %s", early, tdsp_status_name(status));
}

/* Where the last robot arrives as the destination is covered, that is the reason, unless the source is covered in the same moment. */
static void cover_is_the_reason(soak_case *c, const tdsp_last_departure *last)
{
    const double most = tdsp_scene_destination_free_until(c->world.scene, NULL);
    if (last->reason == TDSP_CUT_OFF && last->arrival == most)
        soak_fail(c, INFINITY, "the last departure %.17g arrives as the destination is covered, and the reason is cut_off", last->departure);
}

void soak_check_last(soak_case *c)
{
    tdsp_last_departure last;
    double arrival;
    const double first = soak_ask(c, &c->world, 0.0);
    const tdsp_status status = tdsp_solver_last_departure(c->world.solver, &last);
    /* Among discs that hardly grow the last departure may be too many journeys away. */
    if (status == TDSP_SHRINKS || status == TDSP_NOT_SUPPORTED || isnan(first)) return;
    if (!(first < INFINITY)) {
        if (status == TDSP_OK && last.departure >= 0.0)
            soak_fail(c, INFINITY, "last departure %.17g, and none at 0", last.departure);
        return;
    }
    if (status != TDSP_OK || last.departure < 0.0) {
        soak_fail(c, INFINITY, "last departure: status %s, and one at 0", tdsp_status_name(status));
        return;
    }
    if (last.departure == INFINITY) {
        if (!(soak_ask(c, &c->world, 1e3 * c->world.unit) < INFINITY))
            soak_fail(c, INFINITY, "nothing ends the departures, and a late one has no way");
        return;
    }
    cover_is_the_reason(c, &last);
    soak_agrees(c, &c->world, last.departure, last.arrival, "the arrival of the last departure");
    soak_not_after(c, &c->world, past(c, last.departure), INFINITY, "later than the last departure");
    const tdsp_status after = tdsp_earliest_arrival(c->world.solver, past(c, last.departure), &arrival);
    /* The source may be covered in the same moment. */
    const int both = after == TDSP_SOURCE_COVERED && tdsp_scene_source_free_until(c->world.scene, NULL) >= last.departure;
    if (after != TDSP_OK && after != TDSP_SHRINKS && after != last.reason && !both)
        soak_fail(c, INFINITY, "after the last departure %.17g it is %s, and the reason is %s", last.departure,
                  tdsp_status_name(after), tdsp_status_name(last.reason));
}
