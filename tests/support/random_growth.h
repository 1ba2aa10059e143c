/* SPDX-License-Identifier: MIT */
/*
 * Seeded scenes of discs with every growth law, as random_scene.h has them for discs of one rate. The same seed gives the same scene on every
 * machine.
 */
#ifndef SUPPORT_RANDOM_GROWTH_H
#define SUPPORT_RANDOM_GROWTH_H

#include <stddef.h>
#include <stdint.h>

#include "tdsp/growth.h"
#include "tdsp/scene.h"

/* One line each: the name, and what it is for. */
#define GROWTH_MIXES(X)                                                                                                          \
    X(CONVEX, convex, "polynomials whose rate rises, some above the robot's speed")                                              \
    X(CONCAVE, concave, "polynomials whose rate falls to 0, and some shrink after that")                                         \
    X(S_SHAPED, s_shaped, "polynomials whose rate rises and falls")                                                              \
    X(WAVY, wavy, "polynomials whose rate goes up and down several times")                                                       \
    X(BOUNCING, bouncing, "laws by callback whose rate rises and falls on the way")                                              \
    X(STEEP, steep, "polynomials whose rate comes close to the robot's speed, or passes it for a while")                         \
    X(NEARLY_ONE_RATE, nearly_one_rate, "polynomials that hardly differ from one rate")                                          \
    X(RATES, rates, "rates that change at given times, up and down")                                                             \
    X(PULSES, pulses, "rates that are 0 for a while and above the robot's speed for a while")                                    \
    X(DELAYED, delayed, "discs that begin to grow at a given time, many of them points")                                         \
    X(CAPPED, capped, "discs that grow to a final radius")                                                                       \
    X(BY_LAW, by_law, "laws by callback, with and without kinks")                                                                \
    X(ASSORTED, assorted, "all of these beside discs of one rate, and a robot with a radius")                                    \
    X(CLUSTER, cluster, "overlapping discs between the ends, of all laws")                                                       \
    X(WALL, wall, "a wall whose gaps close at different times, of all laws")                                                     \
    X(RIPPLES, ripples, "rates that change by next to nothing, up and down")

typedef enum grown_mix {
#define X(upper, lower, text) GROWTH_MIX_##upper,
    GROWTH_MIXES(X)
#undef X
        GROWTH_MIX_COUNT
} grown_mix;

#define GROWTH_MOST_DISCS 16
#define GROWTH_MOST_VALUES 8

/* What a law by callback goes by: `kinks` parts, each with a share of the final growth, a begin and a time constant. */
typedef struct grown_parts {
    size_t count;
    int sharp; /* the rate jumps where a part begins */
    double radius;
    double begins[3], shares[3], spans[3];
} grown_parts;

typedef struct grown_scene {
    tdsp_journey journey;
    size_t count;
    double unit; /* |sd| / speed */
    tdsp_growing_disc discs[GROWTH_MOST_DISCS];
    double values[GROWTH_MOST_DISCS][GROWTH_MOST_VALUES];
    double times[GROWTH_MOST_DISCS][GROWTH_MOST_VALUES];
    grown_parts parts[GROWTH_MOST_DISCS];
} grown_scene;

const char *grown_mix_name(grown_mix mix);

/* A scene of `count` discs, at most GROWTH_MOST_DISCS. Its discs point into it: do not copy it. */
void random_growth(uint64_t seed, grown_mix mix, size_t count, grown_scene *scene);

/* Its discs point into the copy. */
void grown_copy(const grown_scene *scene, grown_scene *copy);

/* The scene turned by the unit vector, mirrored before where asked, in other units of length and of time, moved. */
typedef struct grown_change {
    tdsp_point turn;
    tdsp_point shift;
    double length, time;
    int mirror;
} grown_change;

void grown_place(grown_scene *scene, const grown_change *change);

/* The disc's radius at a time, by its definition. */
double grown_radius(const tdsp_growing_disc *disc, double time);

#endif
