/* SPDX-License-Identifier: MIT */
/*
 * How far a chunk of a ride is free.
 *
 * On a part [a, b] of the chunk the robot's way is a curve whose heading turns by D: it stays within (b - a)/2 tan(D/2) of its chord. With a unit
 * vector r from the other disc's centre towards the middle of the chord, |x - O| >= (x - O) . r; and the other's radius lies under its own chord but for at most
 * |R''| (b - a)^2 / 8. So
 *
 *     |x - O| - R >= min over both ends of ((x - O) . r - R)  -  (b - a)/2 tan(D/2)  -  max |R''| (b - a)^2 / 8,
 *
 * which is quadratic in the length of the part: halving settles every part but those at a true contact, the first of which is the answer.
 */
#ifndef GROWTH_RIDE_H
#define GROWTH_RIDE_H

#include "growth/rider.h"

/* Where a chunk passes another disc at a touch, and could as well ride on that disc. */
typedef struct ride_change {
    uint32_t disc;
    uint32_t span;    /* of that disc */
    int is_at_corner; /* at the span's end, where the rate falls */
    double at;        /* the chunk's parameter; INFINITY: nowhere */
} ride_change;

typedef struct ride_meeting {
    double free_until; /* the parameter up to which the chunk is free of the other disc; its end where it always is */
    int is_stopped;    /* ... by the disc, not by the chunk's end */
    ride_change change;
} ride_meeting;

ride_meeting ride_meets(const growth_chunk *chunk, const growth_shape *other);

/*
 * The run of a disc that a ride came over from at a touch, and which a line that leaves the ride comes out of, no deeper in it than what is forgiven to the ride: as on the run that it leaves, nothing else
 * happens on that one. SHAPE_NONE for all others.
 */
uint32_t ride_left(const growth_engine *engine, const growth_ride *ride, const sight_line *line, uint32_t disc);

/* More on one chunk are left out. */
#define RIDE_CHANGES 8

typedef struct ride_changes {
    uint32_t count;
    ride_change at[RIDE_CHANGES];
} ride_changes;

/* The parameter up to which the chunk is free of all other members. */
double ride_free_until(growth_engine *engine, const growth_chunk *chunk, ride_changes *touches);

#endif
