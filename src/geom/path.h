/* SPDX-License-Identifier: MIT */
/*
 * The motion of a leg, number by number: for a leg (tdsp/path.h), and for one that is read where it lies in a table (query/path.c). Both are at the same place, to the bit.
 *
 * `x` is the share of the leg's duration that has passed.
 */
#ifndef GEOM_PATH_H
#define GEOM_PATH_H

#include "tdsp/types.h"

/* On a line: one coordinate. A convex combination, which cannot overflow where a difference of coordinates can. */
static inline double path_between(double from, double to, double x)
{
    return (1 - x) * from + x * to;
}

/* On a disc: *at, its centre, becomes the place at a distance and an angle from there. */
void path_go_around(tdsp_point *at, double radius, double angle);

static inline double path_arc_distance(double radius_from, double radius_to, double x)
{
    return radius_from + (radius_to - radius_from) * x;
}

/* Which part of its sweep an arc has turned. */
double path_arc_share(double radius_from, double radius_to, double x);

/* What a curve is fitted to at one of its ends: first the distance, and its first two derivatives by time. */
typedef struct path_end {
    double value;
    double slope;
    double bend;
} path_end;

/* ... to the distance by the share of the leg's duration, or to the angle turned by it. */
void path_end_scale(path_end *end, double duration);
void path_end_turn(path_end *end, double turned, double speed, double duration);

/* Distance or angle turned between two such ends, of which *to is used up. */
double path_hermite(const path_end *from, path_end *to, double x);

#endif
