/* SPDX-License-Identifier: MIT */
/*
 * Sums and differences rounded outward as in base/round.h, to the bit, without a branch: for finite results that are not negative.
 *
 * Every other sum is inexact, at random, and a branch on its error costs more than the rest of a look-up. With a >= b >= 0 the error of
 * s = fl(a + b) is b - (s - a) exactly, and that of s = fl(a - b) is (a - s) - b (Dekker). A result s >= 0 has its neighbours one step
 * of its bits away; 0 is exact.
 */
#ifndef QUERY_OUTWARD_H
#define QUERY_OUTWARD_H

#include <stdint.h>
#include <string.h>

static inline double outward_step(double s, uint64_t up, uint64_t down)
{
    uint64_t bits;
    memcpy(&bits, &s, sizeof bits);
    bits += up - down;
    memcpy(&s, &bits, sizeof s);
    return s;
}

/* a, b >= 0 */
static inline double outward_sum_error(double a, double b, double s)
{
    double high = a > b ? a : b;
    double low = a > b ? b : a;
    return low - (s - high);
}

static inline double outward_add_up(double a, double b)
{
    double s = a + b;
    return outward_step(s, outward_sum_error(a, b, s) > 0, 0);
}

static inline double outward_add_down(double a, double b)
{
    double s = a + b;
    return outward_step(s, 0, outward_sum_error(a, b, s) < 0);
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
