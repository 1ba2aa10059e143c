/* SPDX-License-Identifier: MIT */
/*
 * The fastest disc that a leg stays clear of.
 *
 * A disc around O with the radius R at time 0 that grows at the rate W stays clear of a motion when |x(t) - O| >= R + W t all the time. So the largest such
 * rate is the least of
 *
 *     g(t) = (|x(t) - O| - R) / t
 *
 * over the motion: the slope of the line from (0, R) to the curve of the distance over time. A time 0 sets no limit when the disc is clear then, and allows
 * no rate when it is not.
 *
 * On a line the distance is convex in time, so g falls and then rises: its least value is at the tangent from (0, R), or at an end. Let q be the
 * robot's place at time 0 if it had moved like this for ever, seen from O, w its speed, m and h the parts of q along and across the heading, Q = |q|^2,
 * E = sqrt(Q - R^2). The slope of the distance, (w t + m) w / |x - O|, equals g where R |x - O| = w m t + Q; with |x - O| = R + g t
 *
 *     t = Q E / (w (R h - m E))
 *
 * when that is positive, and no such t exists when Q <= R^2.
 *
 * On an arc around the disc's own centre the distance is linear, and g monotone: the ends decide. Around another centre the distance d on a part [a, b] of
 * the arc is at least the chord between its ends less k = K (b - a)^2 / 8, where K bounds its bending (w^2 / (least d) + w u / r, with u the tangential speed and r the
 * least radius of the arc), and at least (d(a) + d(b) - w (b - a)) / 2. Either bound, less R and over t, is monotone: its ends bound g from
 * below. Parts are halved until nothing lower than the resolution is left to find.
 */
#ifndef MARGIN_TOUCH_H
#define MARGIN_TOUCH_H

#include "margin/way.h"

typedef struct touch {
    double rate; /* the least g, or a bound from below; infinite where only time 0 was looked at */
    double time; /* where it is */
} touch;

/* The least g over the leg for a disc with this centre and this radius at time 0 (negative: a disc that has yet to be born). */
touch touch_of(const way *leg, tdsp_point center, double radius, double resolution);

#endif
