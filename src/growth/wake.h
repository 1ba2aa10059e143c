/* SPDX-License-Identifier: MIT */
/*
 * What has been ridden already, on each disc: the argument of src/search/sweep.h, which asks of a law only that on one run the boundary moves outwards slower than the
 * robot. Who passed a place earlier goes straight outwards to where the later one is, if that way is free, and waits there (backwards in time: waits first, then goes).
 */
#ifndef GROWTH_WAKE_H
#define GROWTH_WAKE_H

#include "growth/rider.h"

/*
 * Was the angle `normal` on the ride's run passed before this moment, by another ride than `self` (GROWTH_NONE for none)? What stops a robot first is asked among
 * riders of one side only.
 */
int wake_covers(growth_engine *engine, const growth_ride *rider, double normal, const growth_moment *moment, uint32_t self);

/* The parameter of the chunk from which on the ride need not be followed: its end, or where it comes upon a place passed before. */
double wake_cut(growth_engine *engine, const growth_chunk *chunk, uint32_t self);

#endif
