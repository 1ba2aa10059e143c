/* SPDX-License-Identifier: MIT */
/*
 * Discs in the engine's frame: the robot's speed is 1, and a rate is negative when time runs backwards.
 *
 * For a rate c with |c| < 1, c = cos(theta): a robot that touches the disc tangentially, in space and time, heads at the
 * angle theta from the outward normal, to the left of it when it rides counter-clockwise (side +1), to the right when
 * clockwise (side -1).
 */
#ifndef GEOM_DISC_H
#define GEOM_DISC_H

#include <stdint.h>

#include "geom/point.h"

typedef struct geom_disc {
    tdsp_point center;
    double radius; /* at time 0 */
    double rate;   /* cos theta */
    double sine;   /* sin theta; 0 where |rate| >= 1 */
    double theta;
} geom_disc;

static inline geom_disc disc_make(tdsp_point center, double radius, double rate)
{
    double squared = (1.0 - rate) * (1.0 + rate);
    geom_disc disc = {center, radius, rate, squared > 0.0 ? sqrt(squared) : 0.0, 0.0};
    disc.theta = math_atan2(disc.sine, rate);
    return disc;
}

/* A place to leave from or to arrive at: a disc that blocks nobody. */
static inline geom_disc disc_point(tdsp_point place)
{
    return disc_make(place, 0.0, 0.0);
}

static inline double disc_radius(const geom_disc *disc, double time)
{
    double radius = disc->radius + disc->rate * time;
    return radius > 0.0 ? radius : 0.0;
}

/* Can a robot ride on its boundary? */
static inline int disc_ridable(const geom_disc *disc)
{
    return disc->sine > 0.0;
}

/* The heading of a rider at the normal `angle`, as an angle. */
static inline double disc_heading(const geom_disc *disc, int side, double angle)
{
    return angle + side * disc->theta;
}

static inline tdsp_point disc_boundary(const geom_disc *disc, double angle, double time)
{
    return point_along(disc->center, disc_radius(disc, time), point_unit(angle));
}

#endif
