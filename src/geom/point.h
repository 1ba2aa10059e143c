/* SPDX-License-Identifier: MIT */
/* Plane vectors by value. */
#ifndef GEOM_POINT_H
#define GEOM_POINT_H

#include "base/math.h"
#include "tdsp/types.h"

#define GEOM_PI 3.14159265358979323846
#define GEOM_TURN 6.28318530717958647693

static inline tdsp_point point_make(double x, double y)
{
    tdsp_point p = {x, y};
    return p;
}

static inline tdsp_point point_add(tdsp_point a, tdsp_point b)
{
    return point_make(a.x + b.x, a.y + b.y);
}

static inline tdsp_point point_sub(tdsp_point a, tdsp_point b)
{
    return point_make(a.x - b.x, a.y - b.y);
}

static inline tdsp_point point_scale(double k, tdsp_point a)
{
    return point_make(k * a.x, k * a.y);
}

/* p + k u */
static inline tdsp_point point_along(tdsp_point p, double k, tdsp_point u)
{
    return point_make(p.x + k * u.x, p.y + k * u.y);
}

static inline double point_dot(tdsp_point a, tdsp_point b)
{
    return a.x * b.x + a.y * b.y;
}

static inline double point_cross(tdsp_point a, tdsp_point b)
{
    return a.x * b.y - a.y * b.x;
}

static inline double point_length(tdsp_point a)
{
    return sqrt(a.x * a.x + a.y * a.y);
}

static inline double point_distance(tdsp_point a, tdsp_point b)
{
    return point_length(point_sub(a, b));
}

/* Below this the square of a length loses bits, or all of them. The scale is a power of two, so that nothing is rounded twice. */
#define POINT_TINY 1e-140
#define POINT_SCALE 0x1p600

/* The same where lengths are in a scene's own unit, and so may be that small; to the bit the same where they are not. */
static inline double point_distance_in_scene(tdsp_point a, tdsp_point b)
{
    tdsp_point between = point_sub(a, b);
    if (fabs(between.x) > POINT_TINY || fabs(between.y) > POINT_TINY) return point_length(between);
    return point_length(point_scale(POINT_SCALE, between)) / POINT_SCALE;
}

/* The unit vector in a direction. */
static inline tdsp_point point_unit(double angle)
{
    double sine, cosine;
    math_sincos(angle, &sine, &cosine);
    return point_make(cosine, sine);
}

/* An angle's value in [0, 2 pi); where rounding leads out of that it is 0. */
static inline double angle_positive(double angle)
{
    double turned = angle - GEOM_TURN * floor(angle / GEOM_TURN);
    return turned > 0.0 && turned < GEOM_TURN ? turned : 0.0;
}

#endif
