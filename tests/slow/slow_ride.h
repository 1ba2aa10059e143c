/* SPDX-License-Identifier: MIT */
/* What can be done on a ride: how far it goes, and where it can be left. */
#ifndef SLOW_RIDE_H
#define SLOW_RIDE_H

#include <stddef.h>

#include "slow/slow_world.h"

/* How far the ride is free, at most `limit`. */
slow_real slow_ride_free(const slow_world *world, const slow_ride *ride, slow_real limit);

#define SLOW_DESTINATION ((size_t)-1)

/* A place to leave: to disc `target` on its side `side`, or to the destination. */
typedef struct slow_leave {
    slow_real turned;
    size_t target;
    int side;
} slow_leave;

typedef void (*slow_visitor)(void *ctx, const slow_leave *leave);

/* Every place where the ride up to `end` runs along a tangent to another disc, or towards the destination. */
void slow_ride_leaves(const slow_world *world, const slow_ride *ride, slow_real end, slow_visitor visitor, void *ctx);

#endif
