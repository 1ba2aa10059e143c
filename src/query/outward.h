/* SPDX-License-Identifier: MIT */
/*
 * Sums and differences rounded outward as in base/round.h, to the bit, without a branch: for finite results that are not negative.
 *
 * Every other sum is inexact, at random, and a branch on its error costs more than the rest of a look-up. With a >= b >= 0 the error of
 * s = fl(a + b) is b - (s - a) exactly, and that of s = fl(a - b) is (a - s) - b (Dekker). A result s >= 0 has its neighbours one step
 * of its bits away; 0 is exact.
 *
 * Where doubles are done in software, a sum is done in whole numbers instead: cut off below, it is rounded down, and whether something
 * was cut off says whether the next double is the sum rounded up. The cost is that of less than one addition in software.
 */
#ifndef QUERY_OUTWARD_H
#define QUERY_OUTWARD_H

#include <stdint.h>

#include "base/math.h"
#include "base/soft.h"

/* The bits of x >= 0; of 0, where it is -0. */
static inline uint64_t outward_whole(double x)
{
    return math_bits(x) & (UINT64_MAX >> 1);
}

static inline double outward_step(double s, uint64_t up, uint64_t down)
{
    return math_of_bits(math_bits(s) + (up - down));
}

/* ------------------------------------------------------------------------------------------------------ in doubles */

/* a, b >= 0 */
static inline double outward_sum_error(double a, double b, double s)
{
    double high = a > b ? a : b;
    double low = a > b ? b : a;
    return low - (s - high);
}

static inline double outward_hard_up(double a, double b)
{
    double s = a + b;
    return outward_step(s, outward_sum_error(a, b, s) > 0, 0);
}

static inline double outward_hard_down(double a, double b)
{
    double s = a + b;
    return outward_step(s, 0, outward_sum_error(a, b, s) < 0);
}

/* ------------------------------------------------------------------------------------------------ in whole numbers */

#define OUTWARD_ONE (UINT64_C(1) << 52) /* the bit that is not stored, and the lowest of the exponent */

/* The exponent that the lowest bit of a significand stands for, 1 also where the exponent's bits are 0. */
static inline unsigned outward_exponent(uint64_t bits)
{
    unsigned exponent = (unsigned)(bits >> 52);
    return exponent > 0 ? exponent : 1;
}

/* The whole number of those bits. */
static inline uint64_t outward_significand(uint64_t bits)
{
    return bits < OUTWARD_ONE ? bits : (bits & (OUTWARD_ONE - 1)) | OUTWARD_ONE;
}

/* a, b >= 0 with a finite sum: rounded up or, by cutting off, down. */
static inline double outward_soft_sum(double a, double b, unsigned up)
{
    uint64_t x = outward_whole(a), y = outward_whole(b);
    uint64_t high = x > y ? x : y, low = x > y ? y : x;
    unsigned exponent = outward_exponent(high), apart = exponent - outward_exponent(low);
    if (apart > 63) apart = 63; /* nothing is left of 53 bits either way */
    uint64_t part = outward_significand(low), whole = part >> apart, sum = outward_significand(high) + whole;
    unsigned cut = whole << apart != part;
    if (sum >> 53) {
        cut |= (unsigned)sum & 1;
        sum >>= 1;
        exponent++;
    }
    /* The bit that is not stored adds the exponent's last 1. */
    return math_of_bits(((uint64_t)(exponent - 1) << 52) + sum + (cut & up));
}

/* ---------------------------------------------------------------------------------------------- whatever is better */

/* a, b >= 0 */
static inline double outward_add_up(double a, double b)
{
    return SOFT_DOUBLE ? outward_soft_sum(a, b, 1) : outward_hard_up(a, b);
}

static inline double outward_add_down(double a, double b)
{
    return SOFT_DOUBLE ? outward_soft_sum(a, b, 0) : outward_hard_down(a, b);
}

/* The greater of a, b >= 0. */
static inline double outward_later(double a, double b)
{
    int later = SOFT_DOUBLE ? outward_whole(a) > outward_whole(b) : a > b;
    return later ? a : b;
}

/* a >= b >= 0; a may be infinite, and so is the difference then. Where a < b something negative comes out. */
static inline double outward_subtract_up(double a, double b)
{
    double s = a - b;
    return outward_step(s, (a - s) - b > 0, 0);
}

static inline double outward_subtract_down(double a, double b)
{
    double s = a - b;
    return outward_step(s, 0, (a - s) - b < 0);
}

#endif
