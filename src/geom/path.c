/* SPDX-License-Identifier: MIT */
/*
 * Where a robot is on its path.
 *
 * On an arc the radius is linear in time, r(x) = r0 + (r1 - r0) x for the share x of the leg's duration, and the angle
 * turned is proportional to ln r (the logarithmic spiral). With g = (r1 - r0) / r0 the share of the angle is
 *
 *     log1p(g x) / log1p(g)  =  x (1 + g (1 - x) / 2 + O(g^2)),
 *
 * which loses nothing as g -> 0, where ln(r / r0) / ln(r1 / r0) would become 0 / 0. Below |g| = 1e-8 the O(g^2) is
 * under rounding and the series is used. Both ends are returned as stored, so that legs join exactly.
 *
 * On a curve distance and angle are the quintic Hermite polynomials of tdsp/types.h. For an f with f(0) = f0 and f(1) = f1, first derivatives a, b
 * and second derivatives c, d with respect to the share x, take away the parabola that fits the start: what is left is x^3 times a parabola whose
 * value, slope and bend at 1 are those of D = f1 - f0 - a - c / 2, E = b - a - c and F = d - c:
 *
 *     f(x) = f0 + x (a + x (c / 2 + x ((10 D - 4 E + F / 2) + x ((-15 D + 7 E - F) + x (6 D - 3 E + F / 2)))))
 */
#include "geom/path.h"

#include "base/apart.h"
#include "base/math.h"
#include "tdsp/path.h"

APART double path_arc_share(double radius_from, double radius_to, double x)
{
    double g = (radius_to - radius_from) / radius_from;
    if (fabs(g) < 1e-8) return x * (1 + g * (1 - x) / 2);
    if (isfinite(g)) return math_log1p(g * x) / math_log1p(g);
    double r = radius_from + (radius_to - radius_from) * x;
    return (math_log(r) - math_log(radius_from)) / (math_log(radius_to) - math_log(radius_from));
}

APART void path_go_around(tdsp_point *at, double radius, double angle)
{
    double sine, cosine;
    math_sincos(angle, &sine, &cosine);
    at->x += radius * cosine;
    at->y += radius * sine;
}

static APART double path_arc_angle(const tdsp_leg *leg, double x)
{
    return leg->angle_from + leg->turn * leg->sweep * path_arc_share(leg->radius_from, leg->radius_to, x);
}

/* D, E and F take the place of `to`. */
APART double path_hermite(const path_end *from, path_end *to, double x)
{
    to->value = to->value - from->value - from->slope - from->bend / 2;
    to->slope = to->slope - from->slope - from->bend;
    to->bend = to->bend - from->bend;
    double cubic = 10 * to->value - 4 * to->slope + to->bend / 2 + x * (-15 * to->value + 7 * to->slope - to->bend + x * (6 * to->value - 3 * to->slope + to->bend / 2));
    return from->value + x * (from->slope + x * (from->bend / 2 + x * cubic));
}

void path_end_scale(path_end *end, double duration)
{
    end->slope *= duration;
    end->bend *= duration * duration;
}

/*
 * The angle turned at an end: w = s / r with s = sqrt(v^2 - r'^2), and w' = -r' r'' / (s r) - r' w / r. The factors of s^2 are exact where
 * r' is near v, and so ordered nothing overflows that is not as large itself.
 */
APART void path_end_turn(path_end *end, double turned, double speed, double duration)
{
    double radius = end->value, rate = end->slope;
    double across = speed * sqrt((speed - rate) / speed * ((speed + rate) / speed));
    double w = across / radius;
    end->value = turned;
    end->slope = w * duration;
    end->bend = (-(rate / across) * (end->bend / radius) - rate / radius * w) * duration * duration;
}

static APART double path_curve_distance(const tdsp_leg *leg, double duration, double x)
{
    path_end from = {leg->radius_from, leg->rate_from, leg->bend_from}, to = {leg->radius_to, leg->rate_to, leg->bend_to};
    path_end_scale(&from, duration);
    path_end_scale(&to, duration);
    return path_hermite(&from, &to, x);
}

static APART double path_curve_angle(const tdsp_leg *leg, double duration, double x)
{
    path_end from = {leg->radius_from, leg->rate_from, leg->bend_from}, to = {leg->radius_to, leg->rate_to, leg->bend_to};
    path_end_turn(&from, 0, leg->speed, duration);
    path_end_turn(&to, leg->sweep, leg->speed, duration);
    return leg->angle_from + leg->turn * path_hermite(&from, &to, x);
}

static APART tdsp_point path_on_line(const tdsp_leg *leg, double x)
{
    tdsp_point p = {path_between(leg->from.x, leg->to.x, x), path_between(leg->from.y, leg->to.y, x)};
    return p;
}

tdsp_point tdsp_leg_position(const tdsp_leg *leg, double time)
{
    if (!(time > leg->start_time)) return leg->from;
    if (time >= leg->end_time) return leg->to;
    double duration = leg->end_time - leg->start_time;
    double x = (time - leg->start_time) / duration;
    tdsp_point at = leg->center;
    switch (leg->kind) {
    case TDSP_LEG_ARC: path_go_around(&at, path_arc_distance(leg->radius_from, leg->radius_to, x), path_arc_angle(leg, x)); return at;
    case TDSP_LEG_CURVE: path_go_around(&at, path_curve_distance(leg, duration, x), path_curve_angle(leg, duration, x)); return at;
    default: return path_on_line(leg, x);
    }
}

tdsp_leg tdsp_leg_shifted(const tdsp_leg *leg, double delay)
{
    tdsp_leg shifted = *leg;
    shifted.start_time += delay;
    shifted.end_time += delay;
    return shifted;
}

/* Invariant of the search: legs[low] is the first leg or starts at `time` or before, legs[high] starts after it. */
tdsp_status tdsp_path_position(const tdsp_leg *legs, size_t count, double time, tdsp_point *out)
{
    if (!legs || count == 0 || !out || !isfinite(time)) return TDSP_INVALID_ARGUMENT;
    size_t low = 0;
    size_t high = count;
    while (high - low > 1) {
        size_t middle = (low + high) / 2;
        if (legs[middle].start_time <= time)
            low = middle;
        else
            high = middle;
    }
    *out = tdsp_leg_position(&legs[low], time);
    return TDSP_OK;
}
