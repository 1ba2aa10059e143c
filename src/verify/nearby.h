/* SPDX-License-Identifier: MIT */
/*
 * Inflated discs in a balanced tree of boxes, to leave out at once all those that cannot come near a leg.
 *
 * Node k has the children 2k + 1 and 2k + 2 and halves its range of discs, so that ranges and shape need no storing. Every
 * node knows the box of its centres and the largest radius and growth below it: at time t nothing below comes closer to a
 * point than (distance to the box) - (largest radius) - (largest growth) * t.
 *
 * Where rates change, a node knows the largest radius below it at NEARBY_STEPS times instead, evenly spread up to the last moment that will be asked for; up to
 * a time between two of them no disc is larger than at the next one.
 */
#ifndef VERIFY_NEARBY_H
#define VERIFY_NEARBY_H

#include <stddef.h>
#include <stdint.h>

#include "tdsp/scene.h"
#include "tdsp/status.h"
#include "tdsp/types.h"
#include "verify/motion.h"

#define NEARBY_STEPS 32

typedef struct nearby_disc {
    tdsp_point center;
    double radius;  /* at t = 0, the robot's radius included */
    double growth;  /* the rate, of a disc that has one */
    uint32_t index; /* in the scene */
} nearby_disc;

typedef struct nearby_node {
    tdsp_point low; /* of the box of the centres */
    tdsp_point high;
    double growth; /* the largest; 0 where rates change */
} nearby_node;

typedef struct nearby_index {
    nearby_disc *discs;
    nearby_node *nodes;
    size_t count;
    size_t node_count;
    tdsp_allocator allocator;
    double *radii;           /* of the nodes, the largest: at t = 0, or at one step after the other */
    size_t steps;            /* 1, or NEARBY_STEPS */
    const tdsp_scene *scene; /* NULL where every disc grows at one rate */
    double until;
} nearby_index;

/* For times up to `until`, not negative. TDSP_OK or TDSP_NO_MEMORY. Free with nearby_free(), also an index of no discs. */
tdsp_status nearby_build(const tdsp_scene *scene, double until, const tdsp_allocator *allocator, nearby_index *out);

void nearby_free(nearby_index *index);

/* Called with each disc that may come closer than *limit to the circle up to `time`; may lower *limit. After `until` all may. */
typedef void (*nearby_visitor)(void *ctx, const nearby_disc *disc);

void nearby_visit(const nearby_index *index, const motion_circle *circle, double time, const double *limit,
                  nearby_visitor visitor, void *ctx);

#endif
