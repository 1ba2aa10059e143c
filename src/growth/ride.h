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

/* The parameter up to which the chunk does not touch another disc; its end where it never does, and then *hit is 0. */
double ride_touches(const growth_chunk *chunk, const growth_shape *other, int *hit);

/* The parameter up to which the chunk touches no other member. */
double ride_free_until(growth_engine *engine, const growth_chunk *chunk);

#endif
