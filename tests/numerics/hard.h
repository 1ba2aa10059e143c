/* SPDX-License-Identifier: MIT */
/*
 * Scenes in which arithmetic is hard: what is decided lies within rounding, or what is solved is badly conditioned. Few discs, for the slow solver
 * has to answer them too.
 */
#ifndef NUMERICS_HARD_H
#define NUMERICS_HARD_H

#include <stddef.h>
#include <stdint.h>

#include "tdsp/scene.h"
#include "tdsp/types.h"

#define HARD_MIXES(X)                                                                                      \
    X(TANGENT, tangent, "discs that the straight way passes within 1e-3 to 1e-17, either side")            \
    X(NEEDLES, needles, "gaps of 1e-3 to 1e-15 when they are passed")                                      \
    X(SAME_RATES, same_rates, "rates that differ by 1e-5 to 1e-16")                                        \
    X(NEAR_SPEED, near_speed, "rates below the robot's by 1e-3 to 1e-12")                                  \
    X(FAR_AWAY, far_away, "coordinates a thousand to a billion journeys from the origin")                  \
    X(TINY, tiny, "lengths of 1e-9, speeds of 1e-6 to 1e6")                                                \
    X(HUGE_UNITS, huge_units, "lengths of 1e9, speeds of 1e-6 to 1e6")                                     \
    X(LONG_RIDES, long_rides, "spirals whose radius grows a millionfold, and rides around all of the way") \
    X(SLALOM, slalom, "a dozen discs in the way, one after the other")                                     \
    X(LATE, late, "departures a thousand to a hundred million journeys after time 0")

typedef enum hard_mix {
#define X(upper, lower, text) HARD_##upper,
    HARD_MIXES(X)
#undef X
        HARD_MIX_COUNT
} hard_mix;

const char *hard_mix_name(hard_mix mix);
const char *hard_mix_text(hard_mix mix);

#define HARD_MOST_DISCS 12

/* Returns the number of discs. Departures of interest lie between *first and *first plus a few journeys. */
size_t hard_scene(uint64_t seed, hard_mix mix, tdsp_journey *journey, tdsp_disc discs[HARD_MOST_DISCS], double *first);

#endif
