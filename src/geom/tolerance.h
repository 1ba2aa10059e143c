/* SPDX-License-Identifier: MIT */
/*
 * The one tolerance policy of the geometry.
 *
 * All lengths are in units of the journey's straight line, all speeds in units of the robot's, so that a time and the
 * length travelled in it are the same number. Rounding makes positions uncertain by a few 1e-16 of the largest
 * coordinate in a formula, and a solved departure angle by GEOM_ANGLE. A contact is therefore no collision when it is no
 * deeper than GEOM_CONTACT of the sizes that meet: a path that only touches is free.
 */
#ifndef GEOM_TOLERANCE_H
#define GEOM_TOLERANCE_H

#include <math.h>

#include "geom/point.h"

/* Depth of a touch that is not yet a collision, relative to distance plus radius. */
#define GEOM_CONTACT 1e-12

/* ... and relative to the coordinates: those of a disc much smaller than the journey are rounded as those of a large one are. */
#define GEOM_PLACE 4e-15

/* Of a disc hundreds of journeys large that would be more than a path may be wrong by: there it is so much of a journey, and a hundred roundings of the sizes. */
#define GEOM_CONTACT_LARGE 5e-10
#define GEOM_ROUNDING 2e-14

/* Where an angle equation counts as solved; round-off of the terms is just below. */
#define GEOM_ANGLE 2e-14

/* A departure point this far behind a rider who only starts there still counts as met. */
#define GEOM_ANGLE_START 1e-11

/*
 * ... where the disc ridden is `radius` large. On one hundreds of journeys large GEOM_ANGLE_START would be far behind: there it is so much of a journey, and what an angle is solved to.
 */
static inline double tolerance_behind(double radius)
{
    return math_min(GEOM_ANGLE_START, GEOM_ANGLE + GEOM_CONTACT_LARGE / radius);
}

/* Relative slack of the closed ends of a tangent's domain, so that legs of length 0 are not lost. */
#define GEOM_DOMAIN 1e-13

/* How well a length is known that was computed from coordinates. */
static inline double tolerance_place(tdsp_point center)
{
    return GEOM_PLACE * (1.0 + fabs(center.x) + fabs(center.y));
}

/* The depth that is still a touch for a disc at `center`, `sizes` being distance plus radius. */
static inline double tolerance_touch(tdsp_point center, double sizes)
{
    double depth = GEOM_CONTACT * sizes, most = GEOM_CONTACT_LARGE + GEOM_ROUNDING * sizes;
    return (depth < most ? depth : most) + tolerance_place(center);
}

/* Rounding of a moment that is counted from time 0, relative to it: of when a disc covers a place, and of a departure. */
#define GEOM_TIME 0x1p-50

#endif
