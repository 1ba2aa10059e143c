/* SPDX-License-Identifier: MIT */
/*
 * The discs of random scenes as the engine for changing rates sees them, and what they are by their pieces alone, in more digits: nothing
 * from that engine.
 */
#ifndef SUPPORT_SHAPES_H
#define SUPPORT_SHAPES_H

#include "growth/growth.h"
#include "support/chance.h"
#include "support/random_growth.h"

typedef struct shape_world {
    grown_scene grown;
    tdsp_scene *scene;
    growth_solver *growth;
    const growth_shape *shapes; /* in the frame */
    uint64_t chance;
} shape_world;

/* Call `check` with so many scenes of each mix, of `count` discs each. */
void shapes_each(int scenes, size_t count, uint64_t seed, void (*check)(shape_world *w));

/* One scene; any failure fails the test. */
void shapes_open(shape_world *w, uint64_t seed, grown_mix mix, size_t count);
void shapes_close(shape_world *w);

/* The `order`-th derivative of the radius: on the piece that holds right after the time, or on one that is given. */
long double shape_law(const growth_shape *shape, long double time, int order);
long double piece_law(const law_piece *piece, long double time, int order);

/* The angle that a rider on one piece turns, by Gauss's rule on parts that are halved until that makes no difference. */
long double piece_turned(const law_piece *piece, long double from, long double to);

/* |x - O| - R of a place at a true time. */
double shape_clearance(const growth_shape *shape, tdsp_point place, double time);

#endif
