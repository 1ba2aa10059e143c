/* SPDX-License-Identifier: MIT */
/*
 * Random scenes of all mixes: those of support/random_scene.h and support/random_growth.h, and others that are degenerate on purpose. The same
 * seed and number give the same scene on every machine with the same C library.
 */
#ifndef SOAK_MIXES_H
#define SOAK_MIXES_H

#include "soak/scene.h"
#include "support/random_scene.h"

/* One line each: the name, and what it is for. */
#define SOAK_MIXES(X)                                                                                                            \
    X(tangent_triple, "a line that is tangent to three discs or more at the moment at which it is travelled")                    \
    X(closing_exactly, "gaps that close in the very moment of a passage, by touch or by their corner's speed")                   \
    X(needle, "gaps as thin as 1e-6 to 1e-13, on the way and beside it")                                                         \
    X(kissing, "discs that touch one another from outside or inside, at time 0 or later")                                        \
    X(coincident, "centres that are equal to each other, to the source or to the destination; the same disc twice")              \
    X(equal_radii, "equal radii and rates, centres anywhere or around a ring")                                                   \
    X(lattice, "a lattice of equal discs that touch at some time, the journey along a row or between two")                       \
    X(huge, "coordinates of 1e9")                                                                                                \
    X(tiny, "coordinates of 1e-9")                                                                                               \
    X(far_away, "a journey of 1 at coordinates of up to 1e9")                                                                    \
    X(unlike_sizes, "radii from 1e-9 to 1e9 in one scene")                                                                       \
    X(near_equal_rates, "rates that differ by 1e-16 to 1e-9 of themselves")                                                      \
    X(near_speed, "rates within 1e-12 of the robot's speed, below, equal and above")                                             \
    X(crowd, "hundreds of overlapping discs")                                                                                    \
    X(snapped, "any mix of discs of one rate, its numbers rounded to multiples of 1/16 or 1/64 of the journey")                  \
    X(snapped_growth, "likewise of discs whose rates change")                                                                    \
    X(elsewhere, "any mix, of changing rates too, at coordinates of 1e9 or 1e-9, or a journey of 1 at up to 1e9")                \
    X(near_ends, "a source and a destination that are equal, or next to each other")

typedef enum soak_mix {
#define X(lower, text) SOAK_MIX_##lower,
    SOAK_MIXES(X)
#undef X
        SOAK_MIX_COUNT
} soak_mix;

#define SOAK_ALL_MIXES ((size_t)RANDOM_MIX_COUNT + (size_t)GROWTH_MIX_COUNT + (size_t)SOAK_MIX_COUNT)

/* By number below SOAK_ALL_MIXES. Those of changing rates begin with "growth_". */
const char *soak_mix_name(size_t mix);

/* Scene `number` of a seed, of the mix `only` where that is below SOAK_ALL_MIXES, else of any; returns which. */
size_t soak_make(uint64_t seed, uint64_t number, size_t only, soak_scene *scene);

/* The degenerate ones (degenerate.c). The scene has a journey from (-1, 0) to (1, 0) with speed 1, no disc, and is placed afterwards. */
void soak_degenerate(soak_mix mix, uint64_t *chance, size_t count, soak_scene *scene);

#endif
