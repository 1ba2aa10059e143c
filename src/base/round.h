/* SPDX-License-Identifier: MIT */
/*
 * Sums and differences rounded outward, so that a certified bound stays one after rounding.
 *
 * Knuth's TwoSum gives a + b = s + e exactly with s the rounded sum, in rounding to nearest and without overflow. So
 * the sum rounded up is s where e <= 0 and the next double where e > 0: one step, and only where the sum was inexact.
 * The same with the sign turned rounds down. An infinite s is returned as it is: its error is no number.
 */
#ifndef BASE_ROUND_H
#define BASE_ROUND_H

#include <float.h>
#include <stdint.h>
#include <string.h>

#if defined(__FAST_MATH__)
#error "certified bounds need IEEE arithmetic: compile without -ffast-math"
#endif
#if defined(FLT_EVAL_METHOD) && (FLT_EVAL_METHOD < 0 || FLT_EVAL_METHOD == 2)
#error "certified bounds need doubles evaluated as doubles: on i386 compile with -msse2 -mfpmath=sse"
#endif

static inline int round_is_finite(double x)
{
    return x >= -DBL_MAX && x <= DBL_MAX;
}

/* The next double towards +infinity; infinities and NaN stay. The bits of doubles of one sign are in order of size. */
static inline double round_next_up(double x)
{
    uint64_t bits;
    if (x == 0)
        bits = 1;
    else {
        memcpy(&bits, &x, sizeof bits);
        if (!round_is_finite(x)) return x;
        bits = x > 0 ? bits + 1 : bits - 1;
    }
    memcpy(&x, &bits, sizeof x);
    return x;
}

static inline double round_next_down(double x)
{
    return -round_next_up(-x);
}

/* The error of s = fl(a + b). */
static inline double round_sum_error(double a, double b, double s)
{
    double b_seen = s - a;
    return (a - (s - b_seen)) + (b - b_seen);
}

static inline double round_add_up(double a, double b)
{
    double s = a + b;
    return round_sum_error(a, b, s) > 0 ? round_next_up(s) : s;
}

static inline double round_add_down(double a, double b)
{
    double s = a + b;
    return round_sum_error(a, b, s) < 0 ? round_next_down(s) : s;
}

/* Is the real number a + b at most c? */
static inline int round_sum_at_most(double a, double b, double c)
{
    double s = a + b;
    return (s < c) | ((s == c) & !(round_sum_error(a, b, s) > 0));
}

static inline double round_subtract_up(double a, double b)
{
    return round_add_up(a, -b);
}

static inline double round_subtract_down(double a, double b)
{
    return round_add_down(a, -b);
}

#endif
