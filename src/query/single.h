/* SPDX-License-Identifier: MIT */
/*
 * Floats rounded outward, in whole numbers of 32 bits: times that are not negative.
 *
 * A double cut off to a float's bits is rounded down, and the next float is the one rounded up where something was cut off. So with sums. Whatever the
 * order of these steps, each is outward, so the result is. Below the least normal float there are only 0 and that float; over the greatest there
 * are only that one and infinity.
 */
#ifndef QUERY_SINGLE_H
#define QUERY_SINGLE_H

#include <math.h>

#include "query/outward.h"

#define SINGLE_MIN UINT32_C(0x00800000) /* the bits of FLT_MIN, and of FLT_MAX; the next are those of infinity */
#define SINGLE_MAX UINT32_C(0x7f7fffff)
#define SINGLE_CUT 29u                        /* bits that a double has behind those of a float */
#define SINGLE_BIAS (UINT64_C(896) << 52)       /* how much more the exponent of a double is: 1023 - 127 */

static inline float single_of(uint32_t bits)
{
    float x;
    memcpy(&x, &bits, sizeof x);
    return x;
}

static inline uint32_t single_bits(float x)
{
    uint32_t bits;
    memcpy(&bits, &x, sizeof bits);
    return bits;
}

/* The float as a double, exactly; something below 0 for one that is NaN. -0 becomes 0. */
static inline double single_widen(float x)
{
    uint32_t bits = single_bits(x), exponent = 0;
    if (bits > SINGLE_MAX) return bits == UINT32_C(1) << 31 ? 0.0 : bits == SINGLE_MAX + 1 ? INFINITY : -1.0;
    if (bits == 0) return 0.0;
    /* Below the least normal float, as a larger one and an exponent that is lower by as much. */
    for (; bits < SINGLE_MIN; bits <<= 1) exponent++;
    return outward_double(((uint64_t)bits << SINGLE_CUT) + SINGLE_BIAS - ((uint64_t)exponent << 52));
}

/* A float's bits for a double >= 0, also -0, rounded down or up. */
static inline uint32_t single_narrow(double x, uint32_t up)
{
    uint64_t bits = outward_whole(x);
    if (bits < SINGLE_BIAS + ((uint64_t)SINGLE_MIN << SINGLE_CUT)) return up && bits > 0 ? SINGLE_MIN : 0;
    bits -= SINGLE_BIAS;
    if (bits > (uint64_t)SINGLE_MAX << SINGLE_CUT) return SINGLE_MAX + up;
    return (uint32_t)(bits >> SINGLE_CUT) + ((bits << (64 - SINGLE_CUT) != 0) & up);
}

/* The sum of two floats that are 0 or at least the least normal one, rounded alike. What is below that counts as 0. */
static inline uint32_t single_sum(uint32_t a, uint32_t b, uint32_t up)
{
    uint32_t high = a > b ? a : b, low = a > b ? b : a;
    if (low < SINGLE_MIN) return high;
    uint32_t apart = (high >> 23) - (low >> 23);
    uint32_t part = (low & (SINGLE_MIN - 1)) | SINGLE_MIN;
    uint32_t whole = apart < 32 ? part >> apart : 0;
    uint32_t sum = ((high & (SINGLE_MIN - 1)) | SINGLE_MIN) + whole;
    uint32_t carry = sum >> 24;
    uint32_t cut = ((apart < 32 ? whole << apart : 0) != part) | (sum & carry);
    uint32_t bits = (((high >> 23) - 1 + carry) << 23) + (sum >> carry) + (cut & up);
    return bits > SINGLE_MAX ? SINGLE_MAX + up : bits;
}

#endif
