/* SPDX-License-Identifier: MIT */
/* Functions of the C library that Eva knows nothing of, as functions that may return anything. */
#include <math.h>

#include "proof/any.h"

int signbit(double x)
{
    (void)x;
    return any_bit();
}

double log1p(double x)
{
    (void)x;
    return any_double();
}
