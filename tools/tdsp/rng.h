/* SPDX-License-Identifier: MIT */
/* A small random number generator, the same on every machine: SplitMix64 (Steele, Lea, Flood 2014). */
#ifndef RNG_H
#define RNG_H

#include <stdint.h>

typedef struct Rng {
    uint64_t state;
} Rng;

static inline uint64_t rng_next(Rng *rng)
{
    uint64_t z = (rng->state += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

/* From [low, high). */
static inline double rng_uniform(Rng *rng, double low, double high)
{
    return low + (high - low) * ((double)(rng_next(rng) >> 11) * 0x1p-53);
}

/* From 0 to count - 1; the bias is below count / 2^64. */
static inline uint64_t rng_below(Rng *rng, uint64_t count)
{
    return rng_next(rng) % count;
}

#endif
