/* SPDX-License-Identifier: MIT */
/* Where the travel time jumps between a row's two sides. */
#ifndef QUERY_JUMP_H
#define QUERY_JUMP_H

#include "base/round.h"

/*
 * T(b) <= left and right <= T(b+) are rounded outward, so right over left already proves that T rises between b and the next
 * double. What is called a jump rises by more than error and resolution explain: twice the stated error once more,
 * and 2^-40 of the arrival, since right may have been taken at the next double, where a steep T has risen a little.
 */
static inline int jump_between(double departure, double left, double right, double error, double time_scale)
{
    double resolution = (departure + left) / 1099511627776.0;
    return round_is_finite(right) && right - left > 2 * (error * (left + time_scale)) + resolution;
}

#endif
