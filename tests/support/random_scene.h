/* SPDX-License-Identifier: MIT */
/*
 * Seeded scenes for property tests: mixes that force what is rare. The same seed gives the same scene on every machine: only
 * integer arithmetic and sums, products and square roots of doubles make them.
 */
#ifndef SUPPORT_RANDOM_SCENE_H
#define SUPPORT_RANDOM_SCENE_H

#include <stddef.h>
#include <stdint.h>

#include "tdsp/scene.h"
#include "tdsp/types.h"

/* One line each: the name, and what it is for. */
#define RANDOM_MIXES(X)                                                                                                      \
    X(EQUAL_RATES, equal_rates, "one rate for all")                                                                          \
    X(MIXED_RATES, mixed_rates, "rates from 0 to almost the robot's speed")                                                  \
    X(STATIC, static, "no disc grows")                                                                                       \
    X(SOME_STATIC, some_static, "growing and standing discs")                                                                \
    X(TOO_FAST, too_fast, "some discs as fast as the robot or faster")                                                       \
    X(NEARLY_AS_FAST, nearly_as_fast, "rates just below the robot's speed")                                                  \
    X(NEARLY_STATIC, nearly_static, "rates so small that they hardly differ from 0")                                         \
    X(POINTS, points, "radius 0 at departure 0")                                                                             \
    X(CLUSTER, cluster, "overlapping discs between the ends")                                                                \
    X(NESTED, nested, "discs inside discs")                                                                                  \
    X(CONCENTRIC, concentric, "several discs around one centre")                                                             \
    X(TOUCHING, touching, "discs that touch one another at time 0")                                                          \
    X(WALL, wall, "a wall whose gaps close one after the other")                                                             \
    X(TWO_WALLS, two_walls, "two walls with gaps")                                                                           \
    X(EMERGING, emerging, "a fast disc comes out of a slow one")                                                             \
    X(SWALLOWED, swallowed, "a fast disc swallows slow ones beside its way")                                                 \
    X(ON_SOURCE, on_source, "the source on a boundary, or on a point disc")                                                  \
    X(ON_DESTINATION, on_destination, "the destination on a boundary")                                                       \
    X(COLLINEAR, collinear, "centres on the line of the journey, and on a grid")                                             \
    X(LARGE_UNITS, large_units, "lengths of a million")                                                                      \
    X(SMALL_UNITS, small_units, "lengths of a thousandth")                                                                   \
    X(FAR_ORIGIN, far_origin, "coordinates far from the origin, and a robot with a radius")                                  \
    X(PRISON, prison, "the source ringed by discs that close")                                                               \
    X(FORTRESS, fortress, "the destination ringed by discs, slow and fast")

typedef enum random_mix {
#define X(upper, lower, text) RANDOM_##upper,
    RANDOM_MIXES(X)
#undef X
        RANDOM_MIX_COUNT
} random_mix;

const char *random_mix_name(random_mix mix);

/* A scene of `count` discs (1 to RANDOM_MOST_DISCS). The source is not covered at departure 0. */
#define RANDOM_MOST_DISCS 64
void random_scene(uint64_t seed, random_mix mix, size_t count, tdsp_journey *journey, tdsp_disc *discs);

#endif
