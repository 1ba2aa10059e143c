/* SPDX-License-Identifier: MIT */
/*
 * Scenes whose discs grow in any way.
 *
 * Where every disc comes down to one rate there are no pieces, and the scene is that of tdsp_scene_create(). Elsewhere every disc has pieces, those
 * with one rate too, and nothing else is prepared: which discs can never matter, and boxes that hold whatever grows, are arguments about constant
 * rates (cover.h, index.h); the search among pieces looks at each disc's own radius at the times in question.
 */
#include <string.h>

#include "base/hash.h"
#include "scene/growth.h"
#include "scene/scene.h"

static tdsp_disc disc_at_start(const tdsp_growing_disc *disc, double rate)
{
    tdsp_disc made = {disc->center, disc->radius, rate};
    return made;
}

/* Every disc at one rate, and no law to be called? Then they are filled in, unchecked. */
static int scene_take_rates(tdsp_scene *scene, const tdsp_growing_disc *discs)
{
    for (size_t i = 0; i < scene->count; ++i) {
        double rate;
        if (!growth_is_rate(&discs[i].growth, &rate)) return 0;
        scene->discs[i] = disc_at_start(&discs[i], rate);
    }
    return 1;
}

static tdsp_status scene_check_all(const tdsp_growing_disc *discs, size_t count)
{
    for (size_t i = 0; i < count; ++i)
        if (tdsp_growing_disc_check(&discs[i])) return TDSP_BAD_SCENE;
    return TDSP_OK;
}

static tdsp_status scene_add_pieces(tdsp_scene *scene, const tdsp_growing_disc *discs, piece_list *list)
{
    for (size_t i = 0; i < scene->count; ++i) {
        double shrinks;
        const char *wrong = growth_add(&discs[i], list, &shrinks);
        if (list->status != TDSP_OK) return list->status;
        if (wrong) return TDSP_BAD_SCENE;
        if (list->count > UINT32_MAX) return TDSP_NO_MEMORY;
        scene->first_piece[i + 1] = (uint32_t)list->count;
        scene->discs[i] = disc_at_start(&discs[i], list->pieces[scene->first_piece[i]].c[1]);
        if (shrinks >= scene->valid_until) continue;
        scene->valid_until = shrinks;
        scene->shrinks = (uint32_t)i;
    }
    return memory_shrink(list->allocator, (void **)&list->pieces, &list->capacity, list->count, sizeof *list->pieces);
}

static int pieces_are_rates(const piece_list *list, size_t discs)
{
    int rates = list->count == discs;
    for (size_t k = 0; rates && k < list->count; ++k) rates = list->pieces[k].degree <= 1;
    return rates;
}

static tdsp_status scene_take_pieces(tdsp_scene *scene, const tdsp_growing_disc *discs)
{
    piece_list list = {&scene->allocator, NULL, 0, 0, 0, {0.0, {0.0}, 0}, TDSP_OK};
    size_t starts = scene->count + 1;
    scene->first_piece = memory_array(&scene->allocator, starts, sizeof *scene->first_piece);
    if (!scene->first_piece) return TDSP_NO_MEMORY;
    scene->first_piece[0] = 0;
    tdsp_status status = scene_add_pieces(scene, discs, &list);
    if (status == TDSP_OK && !pieces_are_rates(&list, scene->count)) {
        scene->pieces = list.pieces;
        return TDSP_OK;
    }
    pieces_free(&list);
    memory_free(&scene->allocator, scene->first_piece, starts * sizeof *scene->first_piece);
    scene->first_piece = NULL;
    return status;
}

tdsp_status tdsp_scene_create_growing(const tdsp_journey *journey, const tdsp_growing_disc *discs, size_t count,
                                      const tdsp_allocator *allocator, tdsp_scene **out)
{
    tdsp_scene *scene;
    if (!journey || !out || (count && !discs)) return TDSP_INVALID_ARGUMENT;
    tdsp_status status = scene_begin(journey, count, allocator, &scene);
    if (status != TDSP_OK) return status;
    status = scene_take_rates(scene, discs) ? scene_check_all(discs, count) : scene_take_pieces(scene, discs);
    return scene_finish(scene, status, out);
}

int tdsp_scene_has_rates_only(const tdsp_scene *scene)
{
    return !scene->pieces;
}

/* The jet of a disc at a time in the user's units. */
static law_jet disc_jet(const tdsp_scene *scene, uint32_t disc, double time)
{
    if (!scene->pieces) {
        law_jet jet = {scene->discs[disc].radius + scene->discs[disc].growth * time, scene->discs[disc].growth, 0.0};
        return jet;
    }
    geom_law law = scene_law(scene, disc);
    return law_piece_jet(&law.pieces[law_piece_at(&law, time)], time);
}

tdsp_status tdsp_scene_disc_at(const tdsp_scene *scene, uint32_t disc, double time, double *radius, double *rate)
{
    if (!scene || disc >= scene->count || !(time >= 0.0) || isinf(time)) return TDSP_INVALID_ARGUMENT;
    law_jet jet = disc_jet(scene, disc, time);
    if (radius) *radius = jet.radius;
    if (rate) *rate = jet.rate;
    return TDSP_OK;
}

double tdsp_scene_valid_until(const tdsp_scene *scene, uint32_t *disc)
{
    if (disc) *disc = scene->shrinks;
    return scene->valid_until;
}

scene_cover scene_law_cover(const tdsp_scene *scene, tdsp_point place)
{
    scene_cover cover = {INFINITY, TDSP_NO_DISC};
    for (uint32_t i = 0; i < scene->count; ++i) {
        double reach = point_distance_in_scene(place, scene->discs[i].center) - scene->journey.radius;
        if (cover.time >= 0.0 && !isinf(cover.time) && disc_jet(scene, i, cover.time).radius < reach) continue;
        geom_law law = scene_law(scene, i);
        double until = law_within_until(&law, reach);
        if (until >= cover.time) continue;
        cover.time = until;
        cover.disc = i;
    }
    return cover;
}

static uint64_t hash_law(uint64_t hash, geom_law law)
{
    hash = hash_double(hash, law.count);
    for (uint32_t k = 0; k < law.count; ++k) {
        const law_piece *piece = &law.pieces[k];
        hash = hash_double(hash_double(hash, piece->start), piece->degree);
        for (uint32_t i = 0; i <= piece->degree; ++i) hash = hash_double(hash, piece->c[i]);
    }
    return hash;
}

uint64_t scene_law_hash(const tdsp_scene *scene, uint64_t hash)
{
    for (uint32_t i = 0; i < scene->count; ++i) {
        hash = hash_double(hash_double(hash, scene->discs[i].center.x), scene->discs[i].center.y);
        hash = hash_law(hash, scene_law(scene, i));
    }
    return hash;
}
