/* SPDX-License-Identifier: MIT */
/*
 * Is the destination enclosed?
 *
 * A robot that leaves the source at t is not at a place x before t + |x - s|. So it never comes nearer to disc j than the radius Q that solves
 * Q = R_j(t + |O_j - s| - Q), which is what the disc has grown to when the robot can first be there: the robot moves in a world where nothing grows and
 * disc j has the radius Q. When the discs about the destination leave no way out of there in that world, there is none in the real one. Discs count no larger
 * than they are when the destination is first covered: whether only that cover stops a robot is another question.
 */
#ifndef SEARCH_ENCLOSURE_H
#define SEARCH_ENCLOSURE_H

#include "search/engine.h"

typedef struct enclosure {
    disc_set wall; /* the discs about the destination as they are at least */
} enclosure;

/* *enclosed is 1 when there is no way from the source at `time` (of the frame) to the destination; 0 says nothing. Uses the engine. */
tdsp_status enclosure_test(enclosure *self, disc_engine *engine, const scene_ends *ends, double time, int *enclosed);

void enclosure_free(enclosure *self, const tdsp_allocator *allocator);

#endif
