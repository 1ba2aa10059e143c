/* SPDX-License-Identifier: MIT */
/*
 * Floats rounded outward: times that are not negative.
 *
 * A double cut off to a float's bits is rounded down, and the next float is the one rounded up where something was cut off. Every
 * step is outward, so the result is. Below the least normal float there are only 0 and that float; over the greatest there
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
    return math_of_bits(((uint64_t)bits << SINGLE_CUT) + SINGLE_BIAS - ((uint64_t)exponent << 52));
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

/* The significand of a float that is at least the least normal one. */
static inline uint32_t single_significand(uint32_t bits)
{
    return (bits & (SINGLE_MIN - 1)) | SINGLE_MIN;
}

/* The sum of two such floats, in whole numbers. */
static inline uint32_t single_soft_sum(uint32_t a, uint32_t b, uint32_t up)
{
    uint32_t high = a > b ? a : b, low = a > b ? b : a;
    if (low == 0) return high;
    uint32_t exponent = high >> 23, apart = exponent - (low >> 23);
    if (apart > 31) apart = 31; /* nothing is left of 24 bits either way */
    uint32_t part = single_significand(low), whole = part >> apart, sum = single_significand(high) + whole;
    uint32_t cut = whole << apart != part, carry = sum >> 24;
    cut |= sum & carry;
    uint32_t bits = ((exponent - 1 + carry) << 23) + (sum >> carry) + (cut & up);
    return bits > SINGLE_MAX ? SINGLE_MAX + up : bits;
}

/* ... and in floats, by the error of the sum, as in outward.h. */
static inline uint32_t single_hard_sum(uint32_t a, uint32_t b, uint32_t up)
{
    float high = single_of(a > b ? a : b), low = single_of(a > b ? b : a), sum = high + low;
    float error = low - (sum - high);
    return single_bits(sum) + (up ? error > 0 : -(uint32_t)(error < 0));
}

/* A float's bits and a double >= 0: their sum, rounded as single_narrow() does. */
static inline uint32_t single_add(uint32_t a, double b, uint32_t up)
{
    uint32_t x = a < SINGLE_MIN ? (a > 0 ? up * SINGLE_MIN : 0) : a, y = single_narrow(b, up);
    return SOFT_FLOAT ? single_soft_sum(x, y, up) : single_hard_sum(x, y, up);
}

#endif
