/* SPDX-License-Identifier: MIT */
/* Rides on a disc that grows by a polynomial, as curves: the angle by numerical integration, nothing from the library. */
#ifndef SUPPORT_CURVE_H
#define SUPPORT_CURVE_H

#include "tdsp/types.h"

/* R(t) = c[0] + c[1] t + ... + c[4] t^4 */
typedef struct curve_law {
    double c[5];
} curve_law;

/* The `order`-th derivative of the radius. */
double curve_law_at(const curve_law *law, double time, int order);

/* The angle that a robot of that speed turns while it rides from one time to another, to about 1e-17 of it. */
double curve_law_turned(const curve_law *law, double speed, double from, double to);

/* Where a ride is. */
tdsp_point curve_law_place(const curve_law *law, tdsp_point center, double time, double angle);

/* The ride over [start, end] as one curve on disc 0. */
tdsp_leg curve_leg(const curve_law *law, tdsp_point center, double speed, double start, double end, double angle, int turn);

/* The same as `count` curves of equal duration, each starting where the one before ends. */
void curve_legs(const curve_law *law, tdsp_point center, double speed, double start, double end, double angle, int turn,
                tdsp_leg *legs, int count);

#endif
