/* SPDX-License-Identifier: MIT */
/*
 * The length of (x, y), after Borges ("An improved algorithm for hypot(a, b)", 2019): h = sqrt(x^2 + y^2) as it is rounded, less (h^2 - x^2 - y^2) / (2 h). That
 * difference is taken apart so that what cancels is exact: with d = h - y where h <= 2 y, else d = h - x, both exact,
 *
 *     h^2 - x^2 - y^2  =  x (2 d - x) + (d - 2 (x - y)) d          =  2 d (x - 2 y) + (4 d - y) y + d^2
 */
#include "base/math.h"

#define HYPOT_LEAST 0x1p-500
#define HYPOT_MOST 0x1p500

/* x >= y, both between HYPOT_LEAST and HYPOT_MOST. */
static inline double hypot_of(double x, double y)
{
    double h = sqrt(x * x + y * y), d, over;
    if (h <= 2.0 * y) {
        d = h - y;
        over = x * (2.0 * d - x) + (d - 2.0 * (x - y)) * d;
    } else {
        d = h - x;
        over = 2.0 * d * (x - 2.0 * y) + ((4.0 * d - y) * y + d * d);
    }
    return h - over / (2.0 * h);
}

/* Where a square would overflow or be lost, or is a NaN, which every way but the first hands on. */
static double hypot_of_extremes(double x, double y)
{
    if (x > DBL_MAX || y > DBL_MAX) return INFINITY;
    if (y <= 0x1p-60 * x) return x;
    return x > 1.0 ? hypot_of(x * 0x1p-600, y * 0x1p-600) * 0x1p600 : hypot_of(x * 0x1p600, y * 0x1p600) * 0x1p-600;
}

double math_hypot(double x, double y)
{
    double ax = fabs(x), ay = fabs(y), big = ax > ay ? ax : ay, small = ax > ay ? ay : ax;
    if (!(small >= HYPOT_LEAST && big <= HYPOT_MOST)) return hypot_of_extremes(big, small);
    return hypot_of(big, small);
}
