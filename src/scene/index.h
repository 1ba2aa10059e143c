/* SPDX-License-Identifier: MIT */
/*
 * The spatial index: a binary tree of boxes around the discs as they are at time 0. A node also knows the largest rate below it, so that
 * at the (true) time t >= 0 everything under it lies within rate * t of its box, and within that of a circle around its middle.
 *
 * Where a branch divides, a disc is a point with three coordinates: its place, and how far it reaches after one unit of time. The widest
 * of the three is halved, so that a large or fast disc gets a branch of its own instead of blowing up those of its neighbours.
 *
 * Nodes stand in depth-first order: a node's left child follows it. Sizes are floats rounded up: a node has 48 bytes.
 */
#ifndef SCENE_INDEX_H
#define SCENE_INDEX_H

#include "geom/contact.h"
#include "scene/allocator.h"

typedef struct index_node {
    tdsp_point middle;    /* of the box, and of the circle */
    float half;           /* radius of a circle around all the discs at time 0 */
    float half_x, half_y; /* of the box's sides */
    float rate;           /* largest */
    uint32_t first;       /* the first of the discs below */
    uint32_t count;       /* leaf: how many; 0 for an inner node */
    uint32_t right;       /* inner node: its right child */
} index_node;

/* What the order of the discs is found from. */
typedef struct index_key {
    float place[3]; /* x, y, and the reach */
    uint32_t disc;  /* where it stood before */
} index_key;

typedef struct scene_index {
    index_node *nodes;
    uint32_t node_count;
    size_t node_capacity;
    index_key *keys; /* while building */
    size_t key_capacity;
} scene_index;

/* No leaf has more discs. Measured: docs/decisions/0007-an-index-of-boxes-around-discs.md. */
#define INDEX_LEAF 6u

/* The depth that no tree of up to 2^31 discs exceeds. */
#define INDEX_DEPTH 128

/* What to build from: the index orders these arrays as it likes, all in the same way. */
typedef struct index_items {
    geom_disc *discs;
    uint32_t *given;
    geom_disc *spare; /* room for as many discs */
    uint32_t count;
} index_items;

/*
 * Build over the items, reordering them; an index built before is replaced and its memory used again. Equal items in equal
 * order give the same index everywhere. TDSP_OK or TDSP_NO_MEMORY. O(n log n) expected.
 */
tdsp_status index_build(scene_index *index, const tdsp_allocator *allocator, index_items items);

/* Give back the memory that only building needs. TDSP_OK or TDSP_NO_MEMORY. */
tdsp_status index_trim(scene_index *index, const tdsp_allocator *allocator);

static inline size_t index_bytes(const scene_index *index)
{
    return index->node_capacity * sizeof(index_node) + index->key_capacity * sizeof(index_key);
}

void index_free(scene_index *index, const tdsp_allocator *allocator);

/* The discs under an index as one direction of time sees them. */
typedef struct index_view {
    const scene_index *index;
    const geom_disc *discs; /* in index order */
    double sign;            /* +1 when time runs forwards, -1 when backwards: true time = sign * time */
} index_view;

#define INDEX_NONE 0xffffffffu

/* Does a straight motion enter any disc besides the two it is tangent to (INDEX_NONE: none)? Expected O(log n + discs near it). */
int index_line_blocked(const index_view *view, const geom_line *line, uint32_t skip, uint32_t other_skip);

/* The disc that it enters first, after *length; INDEX_NONE when none. */
uint32_t index_line_first(const index_view *view, const geom_line *line, uint32_t skip, double *length);

/* Calls visit for each disc that the motion enters, besides the two it is tangent to; stops when it returns 0. */
typedef int (*index_visit)(void *ctx, uint32_t disc);
void index_line_visit(const index_view *view, const geom_line *line, uint32_t skip, uint32_t other_skip, index_visit visit,
                      void *ctx);

/* Calls visit for each disc that the ride enters; stops when it returns 0. */
void index_ride_visit(const index_view *view, const geom_ride *ride, uint32_t self, index_visit visit, void *ctx);

/* When a ride on disc `self` first enters another; infinite when it does not. */
double index_ride_contact(const index_view *view, const geom_ride *ride, uint32_t self);

/* Calls visit for each disc whose boundary may come within `margin` of a place at the true time; stops when it returns 0. */
void index_near(const index_view *view, tdsp_point place, double margin, double true_time, index_visit visit, void *ctx);

/* Distance from a place to the node's box: 0 inside. */
static inline double index_node_distance(const index_node *node, tdsp_point place)
{
    double dx = fabs(place.x - node->middle.x) - node->half_x, dy = fabs(place.y - node->middle.y) - node->half_y;
    if (dx <= 0.0) return dy <= 0.0 ? 0.0 : dy;
    return dy <= 0.0 ? dx : sqrt(dx * dx + dy * dy);
}

/* No disc below the node reaches farther than this from its box, or its circle, at the true time. */
static inline double index_node_reach(const index_node *node, double true_time)
{
    return node->rate * true_time;
}

#endif
