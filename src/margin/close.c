/* SPDX-License-Identifier: MIT */
/* Touches and their tolerance. */
#include "margin/close.h"

#include "base/math.h"
#include "tdsp/verify.h"

#define FINE_SHARE 1e-3 /* of the tolerance: the resolution of a touch */

static double place_magnitude(tdsp_point p)
{
    return math_max(fabs(p.x), fabs(p.y));
}

static double leg_magnitude(const tdsp_leg *leg, double speed)
{
    const double size = math_max(math_max(place_magnitude(leg->from), place_magnitude(leg->to)), speed * leg->end_time);
    if (leg->kind == TDSP_LEG_LINE) return size;
    return math_max(math_max(size, place_magnitude(leg->center)), math_max(leg->radius_from, leg->radius_to));
}

closeness close_scales(const tdsp_scene *scene, const tdsp_leg *legs, size_t count)
{
    const tdsp_journey *journey = tdsp_scene_journey(scene);
    double length = 0.0, magnitude = math_max(place_magnitude(journey->source), place_magnitude(journey->destination));
    for (size_t i = 0; i < count; i++) {
        length += way_of(&legs[i]).length;
        magnitude = math_max(magnitude, leg_magnitude(&legs[i], journey->speed));
    }
    length = math_max(length, way_distance(journey->source, journey->destination));
    return (closeness){journey->radius, TDSP_VERIFY_TOLERANCE * length + TDSP_VERIFY_ROUNDING * magnitude, magnitude};
}

/*
 * A leg that is clear of the disc made larger by the tolerance does not touch it; the distances in g are then far above rounding. A leg that is not clear
 * of the disc made smaller is inside. Anything between is a touch, of just the rate that the disc has: rounding must not make a plan look worse
 * than it is.
 */
touch close_look(const closeness *scales, const way *leg, const tdsp_disc *disc)
{
    const double radius = disc->radius + scales->robot, rate = disc->growth;
    const double magnitude = math_max(place_magnitude(disc->center), radius + rate * leg->leg->end_time);
    const double tolerance = scales->tolerance + TDSP_VERIFY_ROUNDING * math_max(magnitude - scales->magnitude, 0.0);
    const double resolution = FINE_SHARE * tolerance;
    const touch larger = touch_of(leg, disc->center, radius + tolerance, resolution);
    if (larger.rate > rate) return touch_of(leg, disc->center, radius, resolution);
    const touch smaller = touch_of(leg, disc->center, radius - tolerance, resolution);
    if (smaller.rate < rate) return smaller;
    return (touch){rate, larger.time};
}

int close_is_far(const closeness *scales, const way *leg, const tdsp_disc *disc, double rate)
{
    const double reach = disc->radius + scales->robot + rate * leg->leg->end_time + 0.5 * leg->length;
    const double away = way_distance(leg->middle, disc->center);
    return away - reach > scales->tolerance + 2.0 * TDSP_VERIFY_ROUNDING * (scales->magnitude + away + reach);
}
