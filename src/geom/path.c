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
#include "tdsp/path.h"

#include "base/math.h"

static double path_arc_share(double radius_from, double radius_to, double x)
{
    double g = (radius_to - radius_from) / radius_from;
    if (fabs(g) < 1e-8) return x * (1 + g * (1 - x) / 2);
    if (isfinite(g)) return math_log1p(g * x) / math_log1p(g);
    double r = radius_from + (radius_to - radius_from) * x;
    return (math_log(r) - math_log(radius_from)) / (math_log(radius_to) - math_log(radius_from));
}

/* The place at a distance and an angle from a centre. */
static tdsp_point path_around(tdsp_point center, double radius, double angle)
{
    double sine, cosine;
    math_sincos(angle, &sine, &cosine);
    tdsp_point p = {center.x + radius * cosine, center.y + radius * sine};
    return p;
}

static tdsp_point path_on_arc(const tdsp_leg *leg, double x)
{
    double r = leg->radius_from + (leg->radius_to - leg->radius_from) * x;
    double angle = leg->angle_from + leg->turn * leg->sweep * path_arc_share(leg->radius_from, leg->radius_to, x);
    return path_around(leg->center, r, angle);
}

/* The motion at one end of a curve, per leg's duration instead of per time. */
typedef struct path_end {
    double value;
    double slope;
    double bend;
} path_end;

static double path_hermite(const path_end *from, const path_end *to, double x)
{
    double d = to->value - from->value - from->slope - from->bend / 2;
    double e = to->slope - from->slope - from->bend;
    double f = to->bend - from->bend;
    double cubic = 10 * d - 4 * e + f / 2 + x * (-15 * d + 7 * e - f + x * (6 * d - 3 * e + f / 2));
    return from->value + x * (from->slope + x * (from->bend / 2 + x * cubic));
}

/*
 * The angle turned at an end: w = s / r with s = sqrt(v^2 - r'^2), and w' = -r' r'' / (s r) - r' w / r. The factors of s^2 are exact where
 * r' is near v, and so ordered nothing overflows that is not as large itself.
 */
static path_end path_turned(double turned, double speed, double radius, double rate, double bend, double duration)
{
    double across = speed * sqrt((speed - rate) / speed * ((speed + rate) / speed));
    double w = across / radius;
    path_end end = {turned, w * duration, (-(rate / across) * (bend / radius) - rate / radius * w) * duration * duration};
    return end;
}

static double path_curve_distance(const tdsp_leg *leg, double duration, double x)
{
    double square = duration * duration;
    path_end from = {leg->radius_from, leg->rate_from * duration, leg->bend_from * square};
    path_end to = {leg->radius_to, leg->rate_to * duration, leg->bend_to * square};
    return path_hermite(&from, &to, x);
}

static double path_curve_turned(const tdsp_leg *leg, double duration, double x)
{
    path_end from = path_turned(0, leg->speed, leg->radius_from, leg->rate_from, leg->bend_from, duration);
    path_end to = path_turned(leg->sweep, leg->speed, leg->radius_to, leg->rate_to, leg->bend_to, duration);
    return path_hermite(&from, &to, x);
}

static tdsp_point path_on_curve(const tdsp_leg *leg, double duration, double x)
{
    double r = path_curve_distance(leg, duration, x);
    double angle = leg->angle_from + leg->turn * path_curve_turned(leg, duration, x);
    return path_around(leg->center, r, angle);
}

/* A convex combination, which cannot overflow where a difference of coordinates can. */
static tdsp_point path_on_line(const tdsp_leg *leg, double x)
{
    tdsp_point p = {(1 - x) * leg->from.x + x * leg->to.x, (1 - x) * leg->from.y + x * leg->to.y};
    return p;
}

tdsp_point tdsp_leg_position(const tdsp_leg *leg, double time)
{
    if (!(time > leg->start_time)) return leg->from;
    if (time >= leg->end_time) return leg->to;
    double duration = leg->end_time - leg->start_time;
    double x = (time - leg->start_time) / duration;
    switch (leg->kind) {
    case TDSP_LEG_ARC: return path_on_arc(leg, x);
    case TDSP_LEG_CURVE: return path_on_curve(leg, duration, x);
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
