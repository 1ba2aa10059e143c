/* SPDX-License-Identifier: MIT */
/*
 * A scene from bytes: twelve bytes for the journey and for what is asked, then eight for each disc, so that changing, dropping or copying a record changes one
 * disc and leaves the others.
 *
 * Places, radii and rates are drawn from those that have gone wrong before: boundaries through an end, discs that touch, coincide or lie in each other, rates
 * equal to the robot's speed or to another disc's but for the last bits, radii of nothing, coordinates far from the journey.
 */
#ifndef FUZZ_WORLD_H
#define FUZZ_WORLD_H

#include "input.h"
#include "tdsp/growth.h"
#include "tdsp/scene.h"

#define WORLD_DISCS 8
#define WORLD_VALUES 3

typedef struct world_law {
    double radius, rate, span; /* R(t) = radius + rate t / (1 + t / span) */
} world_law;

typedef struct world {
    tdsp_journey journey;
    double unit;            /* |sd| / speed, or what stands for it where both ends are one place */
    double departure;       /* what to ask about: a departure, */
    double wait;            /* how much later than the first arrival one may arrive, */
    tdsp_point other;       /* another place, */
    unsigned asked, choice; /* and bits that choose among questions and their options */
    size_t count;
    tdsp_growing_disc discs[WORLD_DISCS];
    double values[WORLD_DISCS][WORLD_VALUES], times[WORLD_DISCS][WORLD_VALUES];
    world_law laws[WORLD_DISCS];
} world;

/* Always a scene in its range. Its discs point into it. */
void world_read(world *w, fuzz_input *in);

/* The scene; NULL where the library takes it for one out of its range, which only a law by callback can be. */
tdsp_scene *world_scene(const world *w);

/* The scene as a file for the command, with laws as rates, to standard error. */
void world_print(const world *w);

/* As fuzz_require(), with the scene and two numbers. */
void world_require(const world *w, int holds, const char *wrong, double a, double b);

#endif
