/* SPDX-License-Identifier: MIT */
/* See motion.h for the derivation. */
#include "verify/motion.h"

#include "base/math.h"
#include "verify/curve.h"

static int point_finite(tdsp_point p)
{
    return isfinite(p.x) && isfinite(p.y);
}

static int ride_well_formed(const tdsp_leg *leg)
{
    if (leg->turn != 1 && leg->turn != -1) return 0;
    if (!point_finite(leg->center) || !isfinite(leg->angle_from)) return 0;
    if (!isfinite(leg->radius_from) || !(leg->radius_from > 0.0)) return 0;
    if (!isfinite(leg->radius_to) || !(leg->radius_to > 0.0)) return 0;
    return isfinite(leg->sweep) && leg->sweep >= 0.0;
}

int motion_well_formed(const tdsp_leg *leg)
{
    if (leg->kind > TDSP_LEG_CURVE) return 0;
    if (!isfinite(leg->start_time) || !isfinite(leg->end_time)) return 0;
    if (leg->end_time < leg->start_time) return 0;
    if (!point_finite(leg->from) || !point_finite(leg->to)) return 0;
    if (leg->kind == TDSP_LEG_LINE) return 1;
    return ride_well_formed(leg) && (leg->kind == TDSP_LEG_ARC || curve_well_formed(leg));
}

double motion_distance(tdsp_point a, tdsp_point b)
{
    return math_hypot(b.x - a.x, b.y - a.y);
}

/* The members that only a curve has are filled in only for one. */
motion motion_of(const tdsp_leg *leg)
{
    motion m;
    double across = 0.0;
    m.leg = *leg;
    m.duration = leg->end_time - leg->start_time;
    m.speed = m.tangential = m.growth = m.log_growth = m.bend = 0.0;
    if (leg->kind == TDSP_LEG_CURVE) {
        curve_fill(&m);
        return m;
    }
    if (leg->kind == TDSP_LEG_LINE) {
        m.length = motion_distance(leg->from, leg->to);
    } else {
        m.growth = (leg->radius_to - leg->radius_from) / leg->radius_from;
        m.log_growth = math_log1p(m.growth);
        across = leg->sweep * leg->radius_from * (m.log_growth == 0.0 ? 1.0 : m.growth / m.log_growth);
        m.length = math_hypot(leg->radius_to - leg->radius_from, across);
    }
    if (m.duration > 0.0) {
        m.speed = m.length / m.duration;
        m.tangential = across / m.duration;
    }
    return m;
}

double motion_radius(const motion *m, double elapsed)
{
    if (m->leg.kind == TDSP_LEG_CURVE) return curve_distance_at(m, motion_share(m, elapsed));
    return m->leg.radius_from + (m->leg.radius_to - m->leg.radius_from) * motion_share(m, elapsed);
}

double motion_bend(const motion *m, double from, double to)
{
    if (m->leg.kind == TDSP_LEG_LINE) return 0.0;
    if (m->leg.kind == TDSP_LEG_CURVE) return m->bend;
    return m->speed * m->tangential / math_min(motion_radius(m, from), motion_radius(m, to));
}

static double motion_turned(const motion *m, double share)
{
    if (m->leg.kind == TDSP_LEG_CURVE) return curve_turned_at(m, share);
    return m->leg.sweep * (m->log_growth == 0.0 ? share : math_log1p(m->growth * share) / m->log_growth);
}

tdsp_point motion_position(const motion *m, double elapsed)
{
    const tdsp_leg *leg = &m->leg;
    const double x = motion_share(m, elapsed);
    if (leg->kind == TDSP_LEG_LINE) {
        if (x == 1.0) return leg->to;
        return (tdsp_point){leg->from.x + (leg->to.x - leg->from.x) * x, leg->from.y + (leg->to.y - leg->from.y) * x};
    }
    const double angle = leg->angle_from + (double)leg->turn * motion_turned(m, x);
    const double radius = motion_radius(m, elapsed);
    double sine, cosine;
    math_sincos(angle, &sine, &cosine);
    return (tdsp_point){leg->center.x + radius * cosine, leg->center.y + radius * sine};
}

double motion_nearest(const motion *m, tdsp_point center, double growth)
{
    if (!(m->speed > growth)) return NAN;
    const double ux = (m->leg.to.x - m->leg.from.x) / m->length, uy = (m->leg.to.y - m->leg.from.y) / m->length;
    const double dx = center.x - m->leg.from.x, dy = center.y - m->leg.from.y;
    const double foot = dx * ux + dy * uy, height = fabs(dx * uy - dy * ux);
    const double past = height * growth / sqrt((m->speed - growth) * (m->speed + growth));
    return (foot + past) / m->speed;
}

motion_circle motion_bound(const motion *m)
{
    /* No point of the way is farther from its middle, counted in time, than half its length. */
    const motion_circle half = {motion_position(m, 0.5 * m->duration), 0.5 * m->length};
    if (m->leg.kind == TDSP_LEG_LINE) return half;
    if (m->leg.kind == TDSP_LEG_CURVE) return half;
    const motion_circle whole = {m->leg.center, math_max(m->leg.radius_from, m->leg.radius_to)};
    return whole.radius < half.radius ? whole : half;
}
