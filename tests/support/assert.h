/* SPDX-License-Identifier: MIT */
/*
 * Assertions on doubles for CMocka, whose own assert_float_equal compares floats and prints six digits.
 *
 * Include after <cmocka.h>. Each argument is evaluated once.
 */
#ifndef SUPPORT_ASSERT_H
#define SUPPORT_ASSERT_H

#include <math.h>
#include <string.h>

static inline void assert_near_at(double actual, double expected, double tolerance, const char *text, const char *file, int line)
{
    int equal_infinity = isinf(expected) && actual == expected;
    if (equal_infinity || fabs(actual - expected) <= tolerance) return;
    print_error("%s: %.17g is not within %.3g of %.17g (off by %.3g)\n", text, actual, tolerance, expected, actual - expected);
    _fail(file, line);
}

static inline void assert_exact_at(double actual, double expected, const char *text, const char *file, int line)
{
    if (memcmp(&actual, &expected, sizeof actual) == 0) return;
    print_error("%s: %.17g (%a) is not %.17g (%a)\n", text, actual, actual, expected, expected);
    _fail(file, line);
}

/* |actual - expected| <= tolerance; infinities match themselves, NaN matches nothing. */
#define assert_near(actual, expected, tolerance) assert_near_at((actual), (expected), (tolerance), #actual, __FILE__, __LINE__)

/* The same double to the bit: -0 is not 0, a NaN is the same NaN. */
#define assert_exact(actual, expected) assert_exact_at((actual), (expected), #actual, __FILE__, __LINE__)

#endif
