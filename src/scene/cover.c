/* Discs that can never matter: the argument is in cover.h. */
#include "scene/cover.h"

#include <stdlib.h>

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
    double half = acos(fmax(-1.0, fmin(1.0, cosine))) - OVERLAP;
    if (half <= 0.0) return 1;
    double from = angle_positive(atan2(between.y, between.x) - half), to = from + 2.0 * half;
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
    for (size_t i = 0; i < count && arcs[i].from <= reached; ++i) reached = fmax(reached, arcs[i].to);
    return reached >= GEOM_TURN;
}

static int cover_enclosed(cover_job *job, const index_view *view, uint32_t self)
{
    const geom_disc *disc = &job->items.discs[self];
    if (disc->radius == 0.0 && disc->rate == 0.0) return 1;
    job->self = self;
    job->inside = 0;
    job->arc_count = 0;
    index_near(view, disc->center, disc->radius, 0.0, cover_visit, job);
    return job->inside || (job->arc_count > 1 && arcs_close(job->arcs, job->arc_count));
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
    for (uint32_t i = 0; i < items.count; ++i) job.dropped[i] = 0;
    index_view view = {index, items.discs, 1.0};
    for (uint32_t i = 0; i < items.count && job.status == TDSP_OK; ++i)
        job.dropped[i] = (unsigned char)cover_enclosed(&job, &view, i);
    if (job.status == TDSP_OK) *kept = items_keep(items, job.dropped);
    memory_free(allocator, job.arcs, job.arc_capacity * sizeof *job.arcs);
    memory_free(allocator, job.dropped, items.count);
    return job.status;
}
