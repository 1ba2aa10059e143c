/* SPDX-License-Identifier: MIT */
/* Rides: where they are, how far they go, and where they can be left. */
#ifndef SLOW_LAW_RIDE_H
#define SLOW_LAW_RIDE_H

#include <stddef.h>

#include "slow/law_world.h"

typedef struct law_ride {
    size_t disc;
    int side;     /* +1 counter-clockwise */
    double angle; /* where it begins, seen from the centre */
    double time;  /* when */
} law_ride;

typedef struct law_moment {
    double x, y;
    double time;
    double heading; /* of the robot */
} law_moment;

/* The panels of a disc; 0 when memory fails. */
int law_ride_prepare(law_world *world, size_t disc);

/* The panel of a disc that a rider is on from a time on. */
const law_panel *law_ride_panel(const law_world *world, size_t disc, double time);

/* The ride at a time, with the rate that holds in `piece`. */
law_moment law_ride_at(const law_world *world, const law_ride *ride, size_t piece, double time);

/* The angle turned up to a time; the time when an angle has been turned, at most `end`. */
double law_ride_turned(const law_world *world, const law_ride *ride, double time);
double law_ride_time(const law_world *world, const law_ride *ride, double turned, double end);

/* Until when the ride goes on, at most `limit`: the boundary can be ridden, nothing is met, and it turns once round at most. */
double law_ride_end(const law_world *world, const law_ride *ride, double limit);

/* In how many steps a part of a panel is looked at, and where the steps begin. */
size_t law_ride_steps(const law_world *world, const law_ride *ride, double from, double to);
double law_ride_step(double from, double to, size_t i, size_t steps);

#define LAW_DESTINATION ((size_t)-1)

/* A place to leave: on a straight line to a spot of disc `target` on its side `side`, or to the destination. */
typedef struct law_leave {
    law_moment at;
    size_t target;
    size_t spot;
    int side;
} law_leave;

typedef void (*law_visitor)(void *ctx, const law_leave *leave);

/* Every place where the ride up to `end` runs along such a line, or can turn into it at a kink. */
void law_ride_leaves(const law_world *world, const law_ride *ride, double end, law_visitor visitor, void *ctx);

#endif
