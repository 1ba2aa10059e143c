/* SPDX-License-Identifier: MIT */
/*
 * The slow solver's world: the source is the origin, the robot's speed is 1, the journey's length is 1 (or what is given
 * where the journey has none). Discs carry the robot's radius.
 */
#ifndef SLOW_WORLD_H
#define SLOW_WORLD_H

#include <stddef.h>

#include "slow/slow_real.h"
#include "tdsp/scene.h"
#include "tdsp/types.h"

#define SLOW_DISCS 64
/* A contact less deep than this share of the sizes that meet is no collision; nor is one less deep than the other share of the journey: 1e-12 and 1e-14 for a double, as the library has it,
   as little as rounding allows for what is to be precise. */
#ifdef SLOW_PRECISE
#define SLOW_TOUCH (64.0 * SLOW_EPSILON)
#define SLOW_ROUNDING (64.0 * SLOW_EPSILON)
#else
#define SLOW_TOUCH 1e-12
#define SLOW_ROUNDING 1e-14
#endif

typedef struct slow_disc {
    slow_real x, y;
    slow_real radius; /* at time 0 */
    slow_real rate;   /* in units of the robot's speed */
} slow_disc;

typedef struct slow_world {
    slow_disc discs[SLOW_DISCS];
    size_t count;
    slow_real to_x, to_y; /* the destination */
    tdsp_point origin; /* the rest turns answers back into the user's units */
    slow_real length;
    slow_real time;
} slow_world;

void slow_world_make(slow_world *world, const tdsp_journey *journey, const tdsp_disc *discs, size_t count);

slow_real slow_radius(const slow_disc *disc, slow_real time);

/* Distance of a point from a disc's boundary, negative inside. */
slow_real slow_clearance(const slow_disc *disc, slow_real x, slow_real y, slow_real time);

/* How deep a touch of this disc at this place is still no collision. */
slow_real slow_slack(const slow_disc *disc, slow_real x, slow_real y, slow_real time);

/* Is the point in no disc? */
int slow_point_free(const slow_world *world, slow_real x, slow_real y, slow_real time);

/* Is the straight motion from there at speed 1, for `length`, in no disc? */
int slow_line_free(const slow_world *world, slow_real x, slow_real y, slow_real heading, slow_real time, slow_real length);

/*
 * The tangent from a point to a disc on a side: +1 has the disc on the left at the contact, -1 on the right. Returns 0 where
 * there is none: the disc is as fast as the robot, is a mere point for ever, or contains the point.
 */
int slow_tangent(const slow_disc *disc, int side, slow_real x, slow_real y, slow_real time, slow_real *heading, slow_real *length);

/* An angle brought into (-pi, pi]; into [0, 2 pi). */
slow_real slow_wrap(slow_real angle);
slow_real slow_wrap_positive(slow_real angle);

/* A ride: `turned` is the angle since its begin, counted in its own sense. */
typedef struct slow_ride {
    size_t disc;
    int side;     /* +1 counter-clockwise */
    slow_real angle; /* where it begins, seen from the centre */
    slow_real time;  /* when */
} slow_ride;

typedef struct slow_moment {
    slow_real x, y;
    slow_real time;
    slow_real heading; /* of the robot */
} slow_moment;

slow_moment slow_ride_at(const slow_world *world, const slow_ride *ride, slow_real turned);

/* The angle turned up to a time. */
slow_real slow_ride_turned(const slow_world *world, const slow_ride *ride, slow_real time);

#endif
