/* SPDX-License-Identifier: MIT */
/*
 * A disc with any growth law, as the engine for changing rates sees it: in the frame, where the robot's speed is 1.
 *
 * A straight motion keeps |x - O|^2 - t^2 linear in time. With g(t) = R(t)^2 - t^2 it avoids the disc as long as that line stays above g; so what
 * matters of a law is where g is concave, that is where
 *
 *     R'^2 + R R'' < 1.
 *
 * There a tangent line stays outside nearby, and the boundary can be ridden as long as R' < 1; elsewhere a line touches nothing, and comes nearest at an end.
 * A law is therefore cut into spans, on each of which one polynomial holds and g is either concave or convex. Neighbouring spans that can be ridden, and between which the
 * rate does not rise, make a run: over a run g is concave, with a corner where the rate falls. A rider comes from one run to another of the same disc by a straight leg
 * only. Where the rate falls a rider may turn on the spot, from the heading of the one rate to that of the other: a fan. Such a corner can be touched even if what comes
 * before or after cannot be ridden; a span of no duration then stands in for it.
 *
 * Times here are true times. Backwards in time the same spans serve, with rates negated.
 */
#ifndef GROWTH_SHAPE_H
#define GROWTH_SHAPE_H

#include "geom/law.h"
#include "geom/point.h"
#include "scene/allocator.h"

/* The angle turned over a part of a span, as a Chebyshev series that is 0 at `from`. */
#define SHAPE_SERIES 14

typedef struct shape_panel {
    double from, to;
    double turned; /* by all of it */
    double c[SHAPE_SERIES + 1];
} shape_panel;

typedef struct shape_span {
    double from, to; /* `to` may be infinite */
    uint32_t piece;
    uint32_t run;    /* SHAPE_NONE where it cannot be ridden */
    int is_concave;  /* g is */
    uint32_t first_panel, panel_count; /* none where the rate is constant */
} shape_span;

#define SHAPE_NONE 0xffffffffu

/* Spans first to last, in true time. */
typedef struct shape_run {
    uint32_t first, last;
    int is_measured; /* the angles are known */
} shape_run;

typedef struct growth_shape {
    tdsp_point center;
    law_piece *pieces; /* the robot's radius included */
    uint32_t piece_count;
    shape_span *spans;
    uint32_t span_count;
    size_t span_capacity;
    shape_run *runs;
    uint32_t run_count;
    size_t run_capacity;
    shape_panel *panels;
    uint32_t panel_count;
    size_t panel_capacity;
    double *turned; /* by whole spans of measured runs, 2 span_count sums (shape.c); NULL as long as no run of several is measured */
} growth_shape;

/* A boundary smaller than this is no place to ride: nobody has to go round it. */
#define SHAPE_LEAST_RIDE 1e-12

/*
 * From a law in the user's units to the frame's: lengths and times divided by these, the robot's radius (the user's) added. TDSP_OK or TDSP_NO_MEMORY; what was
 * made until then is freed by shape_free(). O(pieces).
 */
typedef struct shape_units {
    tdsp_point origin;
    double length, time, robot_radius;
} shape_units;

tdsp_status shape_make(growth_shape *shape, const tdsp_allocator *allocator, tdsp_point center, geom_law law, shape_units units);
void shape_free(growth_shape *shape, const tdsp_allocator *allocator);
size_t shape_bytes(const growth_shape *shape);

/* The span that holds at a true time, and right after it. O(log spans). */
uint32_t shape_span_at(const growth_shape *shape, double time);

/* Radius, rate and bend on a span's polynomial. */
static inline law_jet shape_jet(const growth_shape *shape, uint32_t span, double time)
{
    return law_piece_jet(&shape->pieces[shape->spans[span].piece], time);
}

/* The radius at a true time. */
double shape_radius(const growth_shape *shape, double time);

/* Can the span's radius be written r + c t? */
static inline int shape_is_linear(const growth_shape *shape, uint32_t span)
{
    return shape->pieces[shape->spans[span].piece].degree < 2;
}

/* Make the angles of a run known. TDSP_OK or TDSP_NO_MEMORY. */
tdsp_status shape_measure(growth_shape *shape, const tdsp_allocator *allocator, uint32_t run);

/* The angle that a rider turns between two moments of a measured run, the second not before the first, to the rounding of what it is. O(log spans). */
double shape_turned(const growth_shape *shape, uint32_t from_span, double from, uint32_t to_span, double to);

#endif
