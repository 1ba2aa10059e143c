/* SPDX-License-Identifier: MIT */
/* A wall about the destination: the argument is in enclosure.h. */
#include "search/enclosure.h"

/* So many discs about the destination are looked at, or a few more. */
#define WALL 256u

/* A way out is sought with bounds so heavy, because any will do ... */
#define WEIGHT 2.0

/* ... and with so many chunks of rides for each disc. */
#define PATIENCE 4u

/* Discs count as this share smaller than they are, so that a touch is no wall. */
#define TOUCH 1e-9

/* From where, to where and when a robot comes. */
typedef struct wall_view {
    const tdsp_scene *scene;
    const scene_ends *ends;
    double time; /* of the frame */
} wall_view;

/* The least radius that the disc has when a robot from the source is near it. */
static double least_radius(const wall_view *view, const geom_disc *disc)
{
    double time = view->time, away = point_distance(disc->center, view->ends->source);
    double first = disc_radius(disc, time), met = (disc->radius + disc->rate * (time + away)) / (1.0 + disc->rate);
    double until = view->ends->destination_cover.time / view->scene->time, covered = until < INFINITY ? disc_radius(disc, until) : INFINITY;
    return math_min(math_max(first, met), covered) * (1.0 - TOUCH);
}

/* The rings about the destination. */
static tdsp_status rings_about_destination(neighbourhood *around, const wall_view *view, uint32_t *place)
{
    const tdsp_scene *scene = view->scene;
    int added = 1;
    tdsp_status status = around->set == &scene->all ? TDSP_OK : neighbours_begin(around, &scene->allocator, &scene->all);
    if (status == TDSP_OK) status = neighbours_of_point(around, &scene->allocator, view->ends->destination, place);
    while (status == TDSP_OK && added) status = neighbours_widen(around, &scene->allocator, *place, WALL, &added);
    return status;
}

static void wall_add_ring(disc_set *wall, const neighbourhood *around, const neighbour_ring *ring, const wall_view *view)
{
    for (uint32_t i = 0; i < ring->count; ++i) {
        const neighbour_block *block = &around->blocks[ring->first + i / NEIGHBOUR_BLOCK];
        const geom_disc *disc = &view->scene->all.forward[block->disc[i % NEIGHBOUR_BLOCK]];
        double radius = least_radius(view, disc);
        if (radius >= point_distance(disc->center, view->ends->destination)) continue;
        wall->forward[wall->count] = disc_make(disc->center, radius, 0.0);
        wall->origin[wall->count] = wall->count;
        ++wall->count;
    }
}

static tdsp_status wall_build(enclosure *self, neighbourhood *around, const wall_view *view)
{
    uint32_t place;
    tdsp_status status = rings_about_destination(around, view, &place);
    if (status != TDSP_OK) return status;
    const neighbour_rings *rings = &around->rings[place];
    status = set_reserve(&self->wall, &view->scene->allocator, rings->disc_count);
    if (status != TDSP_OK) return status;
    self->wall.count = 0;
    for (uint32_t i = 0; i < rings->ring_count; ++i) wall_add_ring(&self->wall, around, &rings->rings[i], view);
    return set_prepare(&self->wall, &view->scene->allocator);
}

tdsp_status enclosure_test(enclosure *self, disc_engine *engine, const scene_ends *ends, double time, int *enclosed)
{
    const wall_view view = {engine->scene, ends, time};
    *enclosed = 0;
    tdsp_status status = wall_build(self, &engine->around_all, &view);
    if (status != TDSP_OK) return status;
    engine_question question = {ENGINE_FORWARD, ends->destination, ends->source, 0.0, -INFINITY, INFINITY, INFINITY, WEIGHT,
                                PATIENCE * (uint64_t)self->wall.count + 1, 0, NULL, 0};
    status = engine_run(engine, &self->wall, &question);
    *enclosed = status == TDSP_OK && engine->arrived == ENGINE_NONE && !engine->gave_up;
    engine->arrived = ENGINE_NONE;
    return status;
}

void enclosure_free(enclosure *self, const tdsp_allocator *allocator)
{
    set_free(&self->wall, allocator);
}
