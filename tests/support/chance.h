/* SPDX-License-Identifier: MIT */
/* Repeatable pseudo-random numbers for tests: SplitMix64, one state a test, seeded by the test. */
#ifndef SUPPORT_CHANCE_H
#define SUPPORT_CHANCE_H

#include <stddef.h>
#include <stdint.h>

static inline uint64_t chance_u64(uint64_t *state)
{
    uint64_t z = (*state += UINT64_C(0x9e3779b97f4a7c15));
    z = (z ^ z >> 30) * UINT64_C(0xbf58476d1ce4e5b9);
    z = (z ^ z >> 27) * UINT64_C(0x94d049bb133111eb);
    return z ^ z >> 31;
}

/* In [0, 1). */
static inline double chance_unit(uint64_t *state)
{
    return (double)(chance_u64(state) >> 11) / 9007199254740992.0;
}

static inline double chance_between(uint64_t *state, double low, double high)
{
    return low + (high - low) * chance_unit(state);
}

/* Below count. */
static inline size_t chance_below(uint64_t *state, size_t count)
{
    return (size_t)(chance_u64(state) % count);
}

#endif
