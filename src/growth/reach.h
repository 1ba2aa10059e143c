/* SPDX-License-Identifier: MIT */
/*
 * Who may be met at all, found before any law is looked at.
 *
 * Within a window of true time each law lies below a line r + c t. With the window cut into steps, R on a step is at most what it is at the step's end, as radii never
 * fall; c is the mean rate over the window, and r the least that puts the line above every step. Discs that grow so stand in the index of the scenes with constant rates
 * (scene/index.h). They are a little larger than needed, so that tolerances do not count: what is not met there is not met.
 */
#ifndef GROWTH_REACH_H
#define GROWTH_REACH_H

#include "growth/sight.h"
#include "scene/index.h"

typedef struct growth_reach {
    scene_index index;
    geom_disc *discs;  /* above the laws, in index order, as the direction of travel sees them */
    geom_disc *spare;
    uint32_t *given;   /* their shapes */
    double *largest;   /* no boundary that can still be met before the limit is larger */
    size_t disc_capacity, spare_capacity, given_capacity, largest_capacity;
    uint32_t count;
    double sign;
    double from, until; /* the window, in true time */
} growth_reach;

/* What a search looks at: these members between two moments of true time. */
typedef struct reach_question {
    const growth_shape *shapes;
    const uint32_t *members;
    uint32_t count;
    double sign;
    double from, until;
} reach_question;

/* Replaces what was there before. TDSP_OK or TDSP_NO_MEMORY. O(n log n). */
tdsp_status reach_build(growth_reach *reach, const tdsp_allocator *allocator, const reach_question *question);

/* Work out `largest` for a limit on the arrival at the goal, in the direction of travel. */
void reach_limit(growth_reach *reach, tdsp_point goal, double limit);

void reach_free(growth_reach *reach, const tdsp_allocator *allocator);
size_t reach_bytes(const growth_reach *reach);

/* Calls visit with each shape that a motion may enter, or all there are if it is not within the window; stops when it returns 0. */
typedef int (*reach_visit)(void *ctx, uint32_t shape);
void reach_line(const growth_reach *reach, const sight_line *line, double end, reach_visit visit, void *ctx);

/* The same for whoever is within `margin` of a place between two moments of travel. */
void reach_near(const growth_reach *reach, tdsp_point place, double margin, double from, double to, reach_visit visit, void *ctx);

#endif
