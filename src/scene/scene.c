/* SPDX-License-Identifier: MIT */
/* Making, checking and reading scenes. */
#include "scene/scene.h"

#include <string.h>

#include "base/hash.h"

/* No number of a scene may be larger: squares and products of lengths then stay far from overflow. */
#define LARGEST 1e100
#define SMALLEST_SPEED 1e-100

/* The frame's unit is at least this share of the scene's extent, so that coordinates in it stay moderate. */
#define LEAST_UNIT 1e-12

static int is_moderate(double x)
{
    return x >= -LARGEST && x <= LARGEST;
}

static int is_size(double x)
{
    return x >= 0.0 && x <= LARGEST;
}

const char *tdsp_journey_check(const tdsp_journey *journey)
{
    if (!(journey->speed >= SMALLEST_SPEED && journey->speed <= LARGEST))
        return "the robot's speed is not between 1e-100 and 1e100";
    if (!is_size(journey->radius)) return "the robot's radius is not between 0 and 1e100";
    if (!is_moderate(journey->source.x) || !is_moderate(journey->source.y)) return "the source is not finite, or beyond 1e100";
    if (!is_moderate(journey->destination.x) || !is_moderate(journey->destination.y))
        return "the destination is not finite, or beyond 1e100";
    return NULL;
}

const char *tdsp_disc_check(const tdsp_disc *disc)
{
    if (!is_moderate(disc->center.x) || !is_moderate(disc->center.y)) return "the centre is not finite, or beyond 1e100";
    if (!is_size(disc->radius)) return "the radius is not between 0 and 1e100";
    if (!is_size(disc->growth)) return "the growth is not between 0 and 1e100";
    return NULL;
}

static uint64_t hash_point(uint64_t hash, tdsp_point point)
{
    return hash_double(hash_double(hash, point.x), point.y);
}

/* The scene's hash if these were the ends of its journey. */
static uint64_t scene_hash(const tdsp_scene *scene, const tdsp_ends *ends)
{
    uint64_t hash = hash_double(hash_double(HASH_FNV1A_SEED, scene->journey.speed), scene->journey.radius);
    hash = hash_point(hash_point(hash, ends->source), ends->destination);
    if (scene->pieces) return scene_law_hash(scene, hash);
    for (size_t i = 0; i < scene->count; ++i) {
        hash = hash_point(hash, scene->discs[i].center);
        hash = hash_double(hash_double(hash, scene->discs[i].radius), scene->discs[i].growth);
    }
    return hash;
}

static double scene_extent(const tdsp_scene *scene)
{
    double extent = 0.0;
    for (size_t i = 0; i < scene->count; ++i) {
        tdsp_point from_origin = point_sub(scene->discs[i].center, scene->origin);
        double across = fabs(from_origin.x) > fabs(from_origin.y) ? fabs(from_origin.x) : fabs(from_origin.y);
        double radius = scene->discs[i].radius + scene->journey.radius;
        if (across > extent) extent = across;
        if (radius > extent) extent = radius;
    }
    return extent;
}

static void scene_set_frame(tdsp_scene *scene)
{
    tdsp_point s = scene->journey.source, d = scene->journey.destination;
    scene->origin = point_make(0.5 * s.x + 0.5 * d.x, 0.5 * s.y + 0.5 * d.y);
    double extent = scene_extent(scene), straight = point_distance(s, d);
    scene->length = math_max(straight, straight > 0.0 ? LEAST_UNIT * extent : extent);
    if (!(scene->length > 0.0)) scene->length = 1.0;
    scene->time = scene->length / scene->journey.speed;
}

/* The discs in the frame, as far as the index needs them. */
static void frame_discs(const tdsp_scene *scene, disc_set *all)
{
    for (uint32_t i = 0; i < all->count; ++i) {
        const tdsp_disc *disc = &scene->discs[i];
        geom_disc framed = {scene_frame_point(scene, disc->center), (disc->radius + scene->journey.radius) / scene->length,
                            disc->growth / scene->journey.speed, 0.0, 0.0};
        all->forward[i] = framed;
        all->origin[i] = i;
    }
}

static tdsp_status scene_prepare_discs(tdsp_scene *scene)
{
    disc_set *all = &scene->all;
    tdsp_status status = set_reserve(all, &scene->allocator, scene->count);
    if (status != TDSP_OK) return status;
    all->count = (uint32_t)scene->count;
    frame_discs(scene, all);
    return set_prepare_whole(all, &scene->allocator);
}

static tdsp_status scene_prepare(tdsp_scene *scene)
{
    const tdsp_ends own = {scene->journey.source, scene->journey.destination};
    scene->hash = scene_hash(scene, &own);
    scene_set_frame(scene);
    tdsp_status status = scene->pieces ? TDSP_OK : scene_prepare_discs(scene);
    return status == TDSP_OK ? scene_ends_make(scene, &own, &scene->ends) : status;
}

tdsp_status scene_begin(const tdsp_journey *journey, size_t count, const tdsp_allocator *allocator, tdsp_scene **out)
{
    if (count > 0x7fffffff) return TDSP_INVALID_ARGUMENT;
    if (tdsp_journey_check(journey)) return TDSP_BAD_SCENE;
    tdsp_allocator memory = memory_allocator(allocator);
    tdsp_scene *scene = memory_array(&memory, 1, sizeof *scene);
    if (!scene) return TDSP_NO_MEMORY;
    memset(scene, 0, sizeof *scene);
    scene->allocator = memory;
    scene->journey = *journey;
    scene->count = count;
    scene->valid_until = INFINITY;
    scene->shrinks = TDSP_NO_DISC;
    scene->discs = memory_array(&memory, count, sizeof *scene->discs);
    if (count > 0 && !scene->discs) {
        tdsp_scene_free(scene);
        return TDSP_NO_MEMORY;
    }
    *out = scene;
    return TDSP_OK;
}

tdsp_status scene_finish(tdsp_scene *scene, tdsp_status status, tdsp_scene **out)
{
    if (status == TDSP_OK) status = scene_prepare(scene);
    if (status == TDSP_OK) *out = scene;
    else tdsp_scene_free(scene);
    return status;
}

tdsp_status tdsp_scene_create(const tdsp_journey *journey, const tdsp_disc *discs, size_t count, const tdsp_allocator *allocator,
                              tdsp_scene **out)
{
    tdsp_scene *scene;
    if (!journey || !out || (count && !discs)) return TDSP_INVALID_ARGUMENT;
    tdsp_status status = scene_begin(journey, count, allocator, &scene);
    if (status != TDSP_OK) return status;
    if (count > 0) memcpy(scene->discs, discs, count * sizeof *discs);
    for (size_t i = 0; i < count && status == TDSP_OK; ++i)
        if (tdsp_disc_check(&discs[i])) status = TDSP_BAD_SCENE;
    return scene_finish(scene, status, out);
}

void tdsp_scene_free(tdsp_scene *scene)
{
    if (!scene) return;
    tdsp_allocator memory = scene->allocator;
    memory_free(&memory, scene->discs, scene->count * sizeof *scene->discs);
    memory_free(&memory, scene->pieces, scene->pieces ? scene->first_piece[scene->count] * sizeof *scene->pieces : 0);
    memory_free(&memory, scene->first_piece, (scene->count + 1) * sizeof *scene->first_piece);
    set_free(&scene->all, &memory);
    memory_free(&memory, scene, sizeof *scene);
}

const tdsp_journey *tdsp_scene_journey(const tdsp_scene *scene)
{
    return &scene->journey;
}

const tdsp_disc *tdsp_scene_discs(const tdsp_scene *scene, size_t *count)
{
    if (count) *count = scene->count;
    return scene->discs;
}

uint64_t tdsp_scene_hash(const tdsp_scene *scene)
{
    return scene->hash;
}

uint64_t tdsp_scene_hash_for(const tdsp_scene *scene, const tdsp_ends *ends)
{
    return ends ? scene_hash(scene, ends) : scene->hash;
}

static double cover_report(scene_cover cover, uint32_t *disc)
{
    if (disc) *disc = cover.disc;
    return cover.time;
}

double tdsp_scene_source_free_until(const tdsp_scene *scene, uint32_t *disc)
{
    return cover_report(scene->ends.source_cover, disc);
}

double tdsp_scene_destination_free_until(const tdsp_scene *scene, uint32_t *disc)
{
    return cover_report(scene->ends.destination_cover, disc);
}
