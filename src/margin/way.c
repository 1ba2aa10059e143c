/* SPDX-License-Identifier: MIT */
/* Legs as motions. */
#include "margin/way.h"

#include "base/math.h"
#include "tdsp/path.h"

static int is_place(tdsp_point p)
{
    return isfinite(p.x) && isfinite(p.y);
}

static int is_radius(double r)
{
    return isfinite(r) && r > 0.0;
}

int way_well_formed(const tdsp_leg *leg)
{
    if (!(leg->start_time >= 0.0) || !(leg->end_time >= leg->start_time) || !isfinite(leg->end_time)) return 0;
    if (!is_place(leg->from) || !is_place(leg->to)) return 0;
    if (leg->kind == TDSP_LEG_LINE) return 1;
    if (leg->kind != TDSP_LEG_ARC || (leg->turn != 1 && leg->turn != -1)) return 0;
    if (!is_place(leg->center) || !is_radius(leg->radius_from) || !is_radius(leg->radius_to)) return 0;
    return isfinite(leg->angle_from) && isfinite(leg->sweep) && leg->sweep >= 0.0;
}

double way_distance(tdsp_point a, tdsp_point b)
{
    return math_hypot(b.x - a.x, b.y - a.y);
}

/* How far the arc goes across the radius: sweep times the logarithmic mean of the radii. */
static double arc_across(const tdsp_leg *leg)
{
    const double gain = leg->radius_to - leg->radius_from, growth = gain / leg->radius_from;
    if (growth == 0.0) return leg->sweep * leg->radius_from;
    return leg->sweep * gain / (isfinite(growth) ? math_log1p(growth) : math_log(leg->radius_to) - math_log(leg->radius_from));
}

way way_of(const tdsp_leg *leg)
{
    const double duration = leg->end_time - leg->start_time;
    way w = {leg, way_distance(leg->from, leg->to), 0.0, 0.0, tdsp_leg_position(leg, leg->start_time + 0.5 * duration)};
    double across = 0.0;
    if (leg->kind == TDSP_LEG_ARC) {
        across = arc_across(leg);
        w.length = math_hypot(leg->radius_to - leg->radius_from, across);
    }
    if (duration > 0.0) {
        w.speed = w.length / duration;
        w.across = across / duration;
    }
    return w;
}

double way_radius(const way *w, double time)
{
    const tdsp_leg *leg = w->leg;
    if (!(time > leg->start_time)) return leg->radius_from;
    if (time >= leg->end_time) return leg->radius_to;
    return leg->radius_from +
           (leg->radius_to - leg->radius_from) * ((time - leg->start_time) / (leg->end_time - leg->start_time));
}
