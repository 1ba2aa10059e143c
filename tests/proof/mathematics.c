/* SPDX-License-Identifier: MIT */
/*
 * Functions that are taken as returning anything: one of the C library's of which Eva knows nothing, and the library's own mathematics. That these stay
 * within their tables rests on the bits of a double, of which Eva knows nothing either: tests/unit/test_math.c tries every exponent.
 */
#include <math.h>

#include "base/math.h"
#include "proof/any.h"

int signbit(double x)
{
    (void)x;
    return any_bit();
}

double math_log(double x)
{
    (void)x;
    return any_double();
}

double math_log1p(double x)
{
    (void)x;
    return any_double();
}

void math_sincos(double x, double *sine, double *cosine)
{
    (void)x;
    *sine = any_double();
    *cosine = any_double();
}
