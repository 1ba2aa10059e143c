/* SPDX-License-Identifier: MIT */
/* A table does not store what a kind of leg does not have, so that must be zero: what goes in comes out. */
#include "build/leg.h"

#include <math.h>

#include "base/bytes.h"
#include "base/round.h"
#include "table/check.h"
#include "table/format.h"

static int leg_is_bare(const tdsp_leg *leg)
{
    return leg->disc == TDSP_NO_DISC && leg->turn == 0 && leg->center.x == 0 && leg->center.y == 0 && leg->radius_from == 0 &&
           leg->radius_to == 0 && leg->angle_from == 0 && leg->sweep == 0;
}

static int leg_has_no_rates(const tdsp_leg *leg)
{
    return leg->rate_from == 0 && leg->rate_to == 0 && leg->bend_from == 0 && leg->bend_to == 0 && leg->speed == 0;
}

static int leg_is_finite(const tdsp_leg *leg)
{
    const double numbers[] = {leg->start_time, leg->end_time, leg->from.x,      leg->from.y,    leg->to.x,       leg->to.y,
                              leg->center.x,   leg->center.y, leg->radius_from, leg->radius_to, leg->angle_from, leg->sweep};
    for (size_t i = 0; i < sizeof numbers / sizeof numbers[0]; i++) {
        if (!round_is_finite(numbers[i])) return 0;
    }
    return 1;
}

static int leg_is_ride(const tdsp_leg *leg)
{
    return (leg->turn == 1 || leg->turn == -1) && leg->sweep >= 0 && leg->radius_from > 0 && leg->radius_to > 0;
}

int leg_is_good(const tdsp_leg *leg)
{
    if (leg->reserved != 0 || !leg_is_finite(leg) || !(leg->start_time <= leg->end_time)) return 0;
    switch (leg->kind) {
    case TDSP_LEG_LINE: return leg_is_bare(leg) && leg_has_no_rates(leg);
    case TDSP_LEG_ARC: return leg_is_ride(leg) && leg_has_no_rates(leg);
    case TDSP_LEG_CURVE: return leg_is_ride(leg) && check_curve(leg);
    default: return 0;
    }
}

void leg_put_point(unsigned char *p, tdsp_point point)
{
    bytes_put_f64(p, point.x);
    bytes_put_f64(p + 8, point.y);
}

static void leg_put_waypoint(unsigned char *p, double time, tdsp_point place, uint32_t disc, uint32_t arc)
{
    bytes_put_f64(p + FORMAT_WAYPOINT_AT_TIME, time);
    leg_put_point(p + FORMAT_WAYPOINT_AT_X, place);
    bytes_put_u32(p + FORMAT_WAYPOINT_AT_DISC, disc);
    bytes_put_u32(p + FORMAT_WAYPOINT_AT_ARC, arc);
}

static void leg_put_arc(unsigned char *p, const tdsp_leg *leg)
{
    leg_put_point(p + FORMAT_ARC_AT_CENTER, leg->center);
    bytes_put_f64(p + FORMAT_ARC_AT_RADIUS_FROM, leg->radius_from);
    bytes_put_f64(p + FORMAT_ARC_AT_RADIUS_TO, leg->radius_to);
    bytes_put_f64(p + FORMAT_ARC_AT_ANGLE_FROM, leg->angle_from);
    bytes_put_f64(p + FORMAT_ARC_AT_TURNED, copysign(leg->sweep, leg->turn));
}

static void leg_put_curve(unsigned char *p, const tdsp_leg *leg)
{
    leg_put_arc(p, leg);
    bytes_put_f64(p + FORMAT_CURVE_AT_RATE_FROM, leg->rate_from);
    bytes_put_f64(p + FORMAT_CURVE_AT_RATE_TO, leg->rate_to);
    bytes_put_f64(p + FORMAT_CURVE_AT_BEND_FROM, leg->bend_from);
    bytes_put_f64(p + FORMAT_CURVE_AT_BEND_TO, leg->bend_to);
    bytes_put_f64(p + FORMAT_CURVE_AT_SPEED, leg->speed);
}

static void leg_put_next(leg_cursor *at, double time, tdsp_point place, uint32_t disc, uint32_t arc)
{
    leg_put_waypoint(at->waypoint, time, place, disc, arc);
    at->waypoint += FORMAT_WAYPOINT_SIZE;
    at->waypoints++;
}

/* The number that the waypoint gets. */
static uint32_t leg_put_ride(leg_cursor *at, const tdsp_leg *leg)
{
    if (leg->kind == TDSP_LEG_LINE) return FORMAT_NONE;
    if (leg->kind == TDSP_LEG_ARC) {
        leg_put_arc(at->arc, leg);
        at->arc += FORMAT_ARC_SIZE;
        return at->arcs++;
    }
    leg_put_curve(at->curve, leg);
    at->curve += FORMAT_CURVE_SIZE;
    return at->curves++;
}

void leg_put(leg_cursor *at, const tdsp_leg *leg, int with_end)
{
    uint32_t ride = leg_put_ride(at, leg);
    leg_put_next(at, leg->start_time, leg->from, leg->disc, ride);
    if (with_end) leg_put_next(at, leg->end_time, leg->to, FORMAT_NONE, FORMAT_NONE);
}
