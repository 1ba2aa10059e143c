/* SPDX-License-Identifier: MIT */
/*
 * A rider on a disc's boundary: its normal turns by the run's angle, its heading stands at theta from the normal, cos(theta) = R', to the left of it on side +1
 * (counter-clockwise) and to the right on side -1.
 *
 * A chunk is a part of a ride with one parameter that rises: time on a span, theta in a fan. Over either the heading turns one way only, to
 * the side of the ride.
 */
#ifndef GROWTH_RIDER_H
#define GROWTH_RIDER_H

#include "growth/engine.h"

typedef struct growth_chunk {
    const growth_shape *shape;
    const growth_ride *ride;
    double sign;
    growth_moment base; /* of a fan; on a span only its span counts */
    double from, to;    /* of the parameter */
} growth_chunk;

/* The moment at a value of the chunk's parameter. */
growth_moment chunk_moment(const growth_chunk *chunk, double at);

/* theta on a span at a time. */
double rider_theta(const growth_shape *shape, double sign, uint32_t span, double time);

/* The angle of the normal at a moment of the ride's run. */
double rider_normal(const growth_shape *shape, double sign, const growth_ride *ride, const growth_moment *moment);

double rider_heading(const growth_shape *shape, double sign, const growth_ride *ride, const growth_moment *moment);

/* The straight motion of a robot that leaves the ride at a moment. */
sight_line rider_leaves(const growth_shape *shape, double sign, const growth_ride *ride, const growth_moment *moment);

tdsp_point rider_place(const growth_shape *shape, double sign, const growth_ride *ride, const growth_moment *moment);

/* The angle turned by the ride up to a moment, not negative. */
double rider_turned(const growth_shape *shape, double sign, const growth_ride *ride, const growth_moment *moment);

/* The next chunk from the ride's `now`, not over a corner and not turning the heading by more than so much; 0 when the run is over. */
int rider_next_chunk(const growth_shape *shape, double sign, const growth_ride *ride, growth_chunk *chunk);

/* Does a chunk on a span come to the direction in which a place lies from the centre? *at: the parameter, to rounding. */
int rider_passes(const growth_chunk *chunk, tdsp_point place, double *at);

/* The moment at the end of a chunk, past the corner where the span ends there. *is_over where the run does. */
growth_moment rider_after(const growth_chunk *chunk, int *is_over);

#endif
