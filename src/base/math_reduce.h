/* SPDX-License-Identifier: MIT */
/* Large angles, brought into a quarter of a turn. */
#ifndef BASE_MATH_REDUCE_H
#define BASE_MATH_REDUCE_H

/* x - quarters pi / 2 = high + low with |high| at most pi / 4 and a rounding, and |low| at most half a unit in the last place of high. Of `quarters` only the last two bits are told. */
typedef struct reduce_rest {
    double high;
    double low;
    unsigned quarters;
} reduce_rest;

/* From here on 16 bits of quarters are not enough. */
#define REDUCE_FAR 1e5

/* For x >= REDUCE_FAR. `high` is a NaN for an infinity and a NaN. */
reduce_rest reduce_far(double x);

#endif
