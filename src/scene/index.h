/*
 * The spatial index: a binary tree of boxes around the discs' centres. A node also knows the largest radius at time 0 and the
 * largest rate below it, so that at the (true) time t everything under it lies within radius + rate * t of its box.
 * Discs whose rates are far apart are separated before places are, so that one fast disc does not blow up a whole branch.
 *
 * Nodes stand in depth-first order: a node's left child follows it.
 */
#ifndef SCENE_INDEX_H
#define SCENE_INDEX_H

#include "geom/contact.h"
#include "scene/allocator.h"

typedef struct index_node {
    double min_x, min_y, max_x, max_y; /* of the centres */
    double radius;   /* largest, at time 0 */
    double rate;     /* largest */
    double rate_min; /* least */
    tdsp_point middle; /* of the box */
    double half;       /* of its diagonal */
    uint32_t first;  /* leaf: the first of its discs */
    uint32_t count;  /* leaf: how many; 0 for an inner node */
    uint32_t right;  /* inner node: its right child */
} index_node;

typedef struct scene_index {
    index_node *nodes;
    uint32_t node_count;
    size_t node_capacity;
} scene_index;

/* The depth that no tree of up to 2^31 discs exceeds. */
#define INDEX_DEPTH 128

/* What to build from: the index orders these arrays as it likes, all in the same way. */
typedef struct index_items {
    geom_disc *discs;
    uint32_t *given;
    uint32_t count;
} index_items;

/* Build over the items, reordering them; an index built before is replaced and its memory used again. TDSP_OK or TDSP_NO_MEMORY. O(n log n) expected. */
tdsp_status index_build(scene_index *index, const tdsp_allocator *allocator, index_items items);
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
void index_line_visit(const index_view *view, const geom_line *line, uint32_t skip, uint32_t other_skip, index_visit visit, void *ctx);

/* Calls visit for each disc that the ride enters; stops when it returns 0. */
void index_ride_visit(const index_view *view, const geom_ride *ride, uint32_t self, index_visit visit, void *ctx);

/* When a ride on disc `self` first enters another; infinite when it does not. */
double index_ride_contact(const index_view *view, const geom_ride *ride, uint32_t self);

/* Calls visit for each disc whose boundary may come within `margin` of a place at the true time; stops when it returns 0. */
void index_near(const index_view *view, tdsp_point place, double margin, double true_time, index_visit visit, void *ctx);

/* Distance from a place to the node's box: 0 inside. */
double index_node_distance(const index_node *node, tdsp_point place);

/* No disc below the node reaches farther than this from its box at the true time. */
static inline double index_node_reach(const index_node *node, double true_time)
{
    return node->radius + node->rate * true_time;
}

#endif
