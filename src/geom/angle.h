/* SPDX-License-Identifier: MIT */
/*
 * Angles, where a few digits will do: cheap formulas whose errors are stated, for finding out what cannot matter.
 */
#ifndef GEOM_ANGLE_H
#define GEOM_ANGLE_H

#include "geom/point.h"

/* No angle given here is farther than this from the true one. */
#define GEOM_ANGLE_NEAR 2e-4

/* atan2(y, x), by a polynomial on each octant; error 2e-6. */
static inline double angle_near(double y, double x)
{
    double ax = x < 0.0 ? -x : x, ay = y < 0.0 ? -y : y;
    double low = ax < ay ? ax : ay, high = ax < ay ? ay : ax;
    double a = high > 0.0 ? low / high : 0.0, b = a * a;
    double angle = a * (0.99997726 + b * (-0.33262347 + b * (0.19354346 + b * (-0.11643287 + b * (0.05265332 - b * 0.01172120)))));
    if (ay > ax) angle = 0.5 * GEOM_PI - angle;
    if (x < 0.0) angle = GEOM_PI - angle;
    return y < 0.0 ? -angle : angle;
}

/* asin(x), and the nearest end for an |x| over 1; a series, and a formula of Hastings (Abramowitz and Stegun, 4.4.45): error 5e-5. */
static inline double asin_near(double x)
{
    double a = x < 0.0 ? -x : x, b = x * x;
    if (a <= 0.5) return x * (1.0 + b * (1.0 / 6.0 + b * (3.0 / 40.0 + b * (15.0 / 336.0 + b * 0.0495))));
    double angle = 0.5 * GEOM_PI;
    if (a < 1.0) angle -= sqrt(1.0 - a) * (1.5707288 + a * (-0.2121144 + a * (0.0742610 - a * 0.0187293)));
    return x < 0.0 ? -angle : angle;
}

/* An angle in [-3 pi, 3 pi], brought into [-pi, pi]. */
static inline double angle_wrap(double angle)
{
    if (angle > GEOM_PI) return angle - GEOM_TURN;
    return angle < -GEOM_PI ? angle + GEOM_TURN : angle;
}

#endif
