/* SPDX-License-Identifier: MIT */
/*
 * Straight motions at the robot's speed past a disc with any growth law.
 *
 * Times are those of the direction of travel: true time = sign * time. F = |x - O|^2 - R^2 is a straight line less g (shape.h): convex where g is concave, so
 * that its least value over a run is found by a bracketed Newton on its slope, and concave elsewhere, so that an end is lowest.
 */
#ifndef GROWTH_SIGHT_H
#define GROWTH_SIGHT_H

#include "growth/shape.h"

typedef struct sight_line {
    tdsp_point from;
    tdsp_point unit; /* heading */
    double start;    /* when it is at `from` */
} sight_line;

/* Where a straight motion comes nearest to a disc. */
typedef struct sight_nearest {
    double value;     /* F there */
    double time;
    uint32_t span;    /* ... of the disc's law */
    int is_at_corner; /* at the end of the span, in the direction of travel, where the rate falls */
} sight_nearest;

static inline tdsp_point sight_place(const sight_line *line, double time)
{
    return point_along(line->from, time - line->start, line->unit);
}

/* The rate as the direction of travel sees it. */
static inline double sight_rate(const growth_shape *shape, double sign, uint32_t span, double time)
{
    return sign * shape_jet(shape, span, sign * time).rate;
}

/* The ends of a span and of a run in the direction of travel. */
static inline double span_begins(const shape_span *span, double sign)
{
    return sign > 0.0 ? span->from : -span->to;
}

static inline double span_ends(const shape_span *span, double sign)
{
    return sign > 0.0 ? span->to : -span->from;
}

double run_begins(const growth_shape *shape, double sign, uint32_t run);
double run_ends(const growth_shape *shape, double sign, uint32_t run);

/* The span that holds at a moment of travel and right after it. */
uint32_t sight_span_at(const growth_shape *shape, double sign, double time);

/* F of a place at a moment. */
double sight_value(const growth_shape *shape, double sign, uint32_t span, tdsp_point place, double time);

/*
 * The least F within a run, not before `from`, which is not after the run's end. The value is exact to rounding even where the time is not, as F is flat there:
 * only who needs the time itself asks for it to be precise.
 */
sight_nearest sight_pass(const growth_shape *shape, double sign, const sight_line *line, uint32_t run, double from, int is_precise);

/*
 * Does the motion enter the disc by `end`, deeper than a touch? *hit receives when. The runs left and met, or SHAPE_NONE, are those that the
 * motion touches at either end: nothing else happens on them.
 */
int sight_is_blocked(const growth_shape *shape, double sign, const sight_line *line, double end, uint32_t left, uint32_t met, double *hit);

/* Is a place inside the disc at a moment, deeper than a touch? */
int sight_is_inside(const growth_shape *shape, double sign, tdsp_point place, double time);

#endif
