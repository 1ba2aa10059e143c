/* SPDX-License-Identifier: MIT */
/*
 * Discs that can never matter: the argument is in cover.h.
 *
 * Almost all discs can matter, and that must be cheap to see: the discs of a leaf are compared with those that overlap its box. One that
 * lies inside another is dropped at once; one that has eight points on its boundary of which some lie in no other disc is kept. Only for the rest
 * are the arcs of the boundary looked at that others cover.
 *
 * Who is dropped covers nobody from then on, so that of two equal discs one stays.
 */
#include "scene/cover.h"

#include <stdlib.h>
#include <string.h>

/* Neighbouring arcs must overlap by this angle to count as one: no hole of rounding between them. */
#define OVERLAP 1e-9

typedef struct cover_arc {
    double from;
    double to;
} cover_arc;

typedef struct cover_job {
    const tdsp_allocator *allocator;
    index_items items;
    unsigned char *dropped;
    uint32_t self;
    int inside; /* wholly inside one other disc */
    cover_arc *arcs;
    size_t arc_count;
    size_t arc_capacity;
    tdsp_status status;
} cover_job;

static int cover_add(cover_job *job, double from, double to)
{
    job->status = memory_reserve(job->allocator, (void **)&job->arcs, &job->arc_capacity, job->arc_count + 1, sizeof *job->arcs);
    if (job->status != TDSP_OK) return 0;
    job->arcs[job->arc_count].from = from;
    job->arcs[job->arc_count++].to = to;
    return 1;
}

/* The arc of the disc's boundary inside the disc k. */
static int cover_visit(void *ctx, uint32_t k)
{
    cover_job *job = ctx;
    const geom_disc *disc = &job->items.discs[job->self], *other = &job->items.discs[k];
    if (k == job->self || job->dropped[k] || other->rate < disc->rate) return 1;
    tdsp_point between = point_sub(other->center, disc->center);
    double distance = point_length(between), r = disc->radius, reach = other->radius;
    job->inside = distance + r <= reach;
    if (job->inside) return 0;
    if (distance >= r + reach || distance + reach <= r) return 1;
    double cosine = (r * r + distance * distance - reach * reach) / (2.0 * r * distance);
    double half = math_acos(math_max(-1.0, math_min(1.0, cosine))) - OVERLAP;
    if (half <= 0.0) return 1;
    double from = angle_positive(math_atan2(between.y, between.x) - half), to = from + 2.0 * half;
    if (to <= GEOM_TURN) return cover_add(job, from, to);
    return cover_add(job, from, GEOM_TURN) && cover_add(job, 0.0, to - GEOM_TURN);
}

static int arc_order(const void *a, const void *b)
{
    double x = ((const cover_arc *)a)->from, y = ((const cover_arc *)b)->from;
    return (x > y) - (x < y);
}

static int arcs_close(cover_arc *arcs, size_t count)
{
    double reached = 0.0;
    qsort(arcs, count, sizeof *arcs, arc_order);
    for (size_t i = 0; i < count && arcs[i].from <= reached; ++i) reached = math_max(reached, arcs[i].to);
    return reached >= GEOM_TURN;
}

/* By the arcs: is the boundary closed? */
static int cover_enclosed(cover_job *job, const index_view *view, uint32_t self)
{
    const geom_disc *disc = &job->items.discs[self];
    job->self = self;
    job->inside = 0;
    job->arc_count = 0;
    index_near(view, disc->center, disc->radius, 0.0, cover_visit, job);
    return job->inside || (job->arc_count > 1 && arcs_close(job->arcs, job->arc_count));
}

#define POINTS 8

/* The discs of a leaf, and which of a few points on their boundaries lie in no disc that was looked at. */
typedef struct cover_probe {
    uint32_t first, count;
    uint32_t left; /* not dropped */
    unsigned open[INDEX_LEAF];
} cover_probe;

static cover_probe probe_make(const index_node *leaf)
{
    cover_probe probe = {leaf->first, leaf->count, leaf->count, {0}};
    for (uint32_t i = 0; i < leaf->count; ++i) probe.open[i] = (1u << POINTS) - 1u;
    return probe;
}

/* The points of a disc's boundary that lie outside another, which stands at `between` from it. */
static unsigned points_outside(const geom_disc *disc, const geom_disc *other, tdsp_point between)
{
    static const double diagonal = 0.70710678118654752440;
    static const tdsp_point unit[POINTS] = {{1.0, 0.0},  {diagonal, diagonal},   {0.0, 1.0},  {-diagonal, diagonal},
                                            {-1.0, 0.0}, {-diagonal, -diagonal}, {0.0, -1.0}, {diagonal, -diagonal}};
    unsigned outside = 0;
    double squared = other->radius * other->radius * (1.0 + OVERLAP);
    for (int p = 0; p < POINTS; ++p) {
        tdsp_point offset = point_sub(point_scale(disc->radius, unit[p]), between);
        outside |= (unsigned)(point_dot(offset, offset) > squared) << p;
    }
    return outside;
}

static void probe_compare(cover_probe *probe, cover_job *job, uint32_t i, uint32_t k)
{
    uint32_t self = probe->first + i;
    const geom_disc *disc = &job->items.discs[self], *other = &job->items.discs[k];
    if (k == self || job->dropped[self] || other->rate < disc->rate) return;
    tdsp_point between = point_sub(other->center, disc->center);
    double squared = point_dot(between, between), reach = disc->radius + other->radius;
    if (squared > reach * reach) return;
    if (sqrt(squared) + disc->radius <= other->radius) {
        job->dropped[self] = 1;
        --probe->left;
        return;
    }
    probe->open[i] &= points_outside(disc, other, between);
}

static void probe_leaf(cover_probe *probe, cover_job *job, const index_node *own, const index_node *leaf)
{
    for (uint32_t k = leaf->first; k < leaf->first + leaf->count; ++k) {
        const geom_disc *other = &job->items.discs[k];
        if (job->dropped[k] || fabs(other->center.x - own->middle.x) > own->half_x + other->radius) continue;
        if (fabs(other->center.y - own->middle.y) > own->half_y + other->radius) continue;
        for (uint32_t i = 0; i < probe->count; ++i) probe_compare(probe, job, i, k);
    }
}

/* Compare the leaf's discs with all that overlap its box. Right children first: where a branch divides by reach, they reach farther. */
static void probe_walk(cover_probe *probe, cover_job *job, const index_node *nodes, const index_node *own)
{
    uint32_t later[INDEX_DEPTH], next = 0;
    int top = 0;
    while (probe->left > 0) {
        const index_node *node = &nodes[next];
        int meets = fabs(node->middle.x - own->middle.x) <= node->half_x + own->half_x &&
                    fabs(node->middle.y - own->middle.y) <= node->half_y + own->half_y;
        if (meets && !node->count) {
            later[top++] = next + 1;
            next = node->right;
            continue;
        }
        if (meets) probe_leaf(probe, job, own, node);
        if (top == 0) return;
        next = later[--top];
    }
}

static void cover_leaf(cover_job *job, const index_view *view, const index_node *leaf)
{
    cover_probe probe = probe_make(leaf);
    probe_walk(&probe, job, view->index->nodes, leaf);
    for (uint32_t i = 0; i < leaf->count && job->status == TDSP_OK; ++i) {
        uint32_t self = leaf->first + i;
        const geom_disc *disc = &job->items.discs[self];
        if (disc->radius == 0.0 && disc->rate == 0.0) job->dropped[self] = 1;
        if (!job->dropped[self] && !probe.open[i]) job->dropped[self] = (unsigned char)cover_enclosed(job, view, self);
    }
}

static uint32_t items_keep(index_items items, const unsigned char *dropped)
{
    uint32_t kept = 0;
    for (uint32_t i = 0; i < items.count; ++i) {
        if (dropped[i]) continue;
        items.discs[kept] = items.discs[i];
        items.given[kept++] = items.given[i];
    }
    return kept;
}

tdsp_status cover_drop(const scene_index *index, const tdsp_allocator *allocator, index_items items, uint32_t *kept)
{
    *kept = 0;
    if (items.count == 0) return TDSP_OK;
    cover_job job = {allocator, items, memory_array(allocator, items.count, 1), 0, 0, NULL, 0, 0, TDSP_OK};
    if (!job.dropped) return TDSP_NO_MEMORY;
    memset(job.dropped, 0, items.count);
    index_view view = {index, items.discs, 1.0};
    for (uint32_t k = 0; k < index->node_count && job.status == TDSP_OK; ++k)
        if (index->nodes[k].count) cover_leaf(&job, &view, &index->nodes[k]);
    if (job.status == TDSP_OK) *kept = items_keep(items, job.dropped);
    memory_free(allocator, job.arcs, job.arc_capacity * sizeof *job.arcs);
    memory_free(allocator, job.dropped, items.count);
    return job.status;
}
