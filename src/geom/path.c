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
 */
#include "tdsp/path.h"

#include <math.h>

static double path_arc_share(double radius_from, double radius_to, double x)
{
    double g = (radius_to - radius_from) / radius_from;
    if (fabs(g) < 1e-8) return x * (1 + g * (1 - x) / 2);
    if (isfinite(g)) return log1p(g * x) / log1p(g);
    double r = radius_from + (radius_to - radius_from) * x;
    return (log(r) - log(radius_from)) / (log(radius_to) - log(radius_from));
}

static tdsp_point path_on_arc(const tdsp_leg *leg, double x)
{
    double r = leg->radius_from + (leg->radius_to - leg->radius_from) * x;
    double angle = leg->angle_from + leg->turn * leg->sweep * path_arc_share(leg->radius_from, leg->radius_to, x);
    tdsp_point p = {leg->center.x + r * cos(angle), leg->center.y + r * sin(angle)};
    return p;
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
    double x = (time - leg->start_time) / (leg->end_time - leg->start_time);
    return leg->kind == TDSP_LEG_ARC ? path_on_arc(leg, x) : path_on_line(leg, x);
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
        size_t middle = low + (high - low) / 2;
        if (legs[middle].start_time <= time)
            low = middle;
        else
            high = middle;
    }
    *out = tdsp_leg_position(&legs[low], time);
    return TDSP_OK;
}
