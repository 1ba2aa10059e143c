/* SPDX-License-Identifier: MIT */
/*
 * The prepared scene: what the search sees.
 *
 * Frame: the origin is the middle of the journey, its length |sd| is 1 and the robot's speed is 1, so that times and the
 * lengths travelled in them are the same numbers. A journey of length 0 takes its unit from the discs. Discs that can never
 * matter are left out.
 */
#ifndef SCENE_SCENE_H
#define SCENE_SCENE_H

#include "geom/disc.h"
#include "geom/law.h"
#include "scene/allocator.h"
#include "scene/disc_set.h"
#include "tdsp/scene.h"

/* When an end of the journey is covered first, in the user's units, and by which of the user's discs. */
typedef struct scene_cover {
    double time;
    uint32_t disc;
} scene_cover;

/* The ends of a journey, among the discs of a scene. */
typedef struct scene_ends {
    tdsp_ends given;   /* in the user's units */
    tdsp_point source; /* in the frame */
    tdsp_point destination;
    scene_cover source_cover;
    scene_cover destination_cover;
    double time; /* what errors are stated in besides the travel time, in the user's units */
} scene_ends;

struct tdsp_scene {
    tdsp_allocator allocator;
    tdsp_journey journey;
    tdsp_disc *discs; /* as given */
    size_t count;
    uint64_t hash;
    tdsp_point origin;
    double length; /* of the frame's unit, in the user's */
    double time;   /* likewise */
    scene_ends ends; /* of its own journey */
    disc_set all; /* the discs that matter; origin: the index in `discs`. Empty where there are pieces */

    law_piece *pieces;     /* of all discs, in the user's units, without the robot's radius; NULL where every disc has one rate */
    uint32_t *first_piece; /* disc i has those from first_piece[i] to before first_piece[i + 1] */
    double valid_until;    /* the first moment at which a radius would shrink, ... */
    uint32_t shrinks;      /* ... and that disc */
};

/*
 * A scene with room for `count` discs, which scene_finish() expects to be filled in, pieces too where there are any. TDSP_OK, TDSP_INVALID_ARGUMENT,
 * TDSP_BAD_SCENE for the journey, or TDSP_NO_MEMORY.
 */
tdsp_status scene_begin(const tdsp_journey *journey, size_t count, const tdsp_allocator *allocator, tdsp_scene **out);

/* Prepare it and hand it over, or free it. */
tdsp_status scene_finish(tdsp_scene *scene, tdsp_status status, tdsp_scene **out);

/* How a disc grows, in the user's units. Only where there are pieces. */
static inline geom_law scene_law(const tdsp_scene *scene, uint32_t disc)
{
    geom_law law = {scene->pieces + scene->first_piece[disc], scene->first_piece[disc + 1] - scene->first_piece[disc]};
    return law;
}

/* When a place is covered first, where there are pieces; and their part of the scene's hash. */
scene_cover scene_law_cover(const tdsp_scene *scene, tdsp_point place);
uint64_t scene_law_hash(const tdsp_scene *scene, uint64_t hash);

/* Is this end inside a disc at a time in the user's units? */
static inline int scene_covered(scene_cover cover, double time)
{
    return time > cover.time;
}

/* Does nothing grow? */
static inline int scene_is_still(const tdsp_scene *scene)
{
    if (scene->pieces) return 0;
    return scene->all.count == 0 || scene->all.index.nodes[0].rate == 0.0;
}

/* Do they coincide? */
static inline int ends_meet(const scene_ends *ends)
{
    return point_distance(ends->source, ends->destination) == 0.0;
}

/* When a place, in the user's units, is covered first. Expected O(log n). */
scene_cover scene_cover_of(const tdsp_scene *scene, tdsp_point place);

/* TDSP_OK, or why these cannot be asked about: as tdsp_solver_set_ends(). */
tdsp_status scene_ends_make(const tdsp_scene *scene, const tdsp_ends *given, scene_ends *out);

/* Are there discs so far away, or so large, that the frame's unit is not the journey but a share of them? */
static inline int scene_is_too_wide(const tdsp_scene *scene)
{
    double straight = point_distance(scene->journey.source, scene->journey.destination);
    return straight > 0.0 && straight < scene->length;
}

static inline tdsp_point scene_frame_point(const tdsp_scene *scene, tdsp_point place)
{
    return point_scale(1.0 / scene->length, point_sub(place, scene->origin));
}

/* A point of the frame in the user's units. */
static inline tdsp_point scene_place(const tdsp_scene *scene, tdsp_point point)
{
    return point_along(scene->origin, scene->length, point);
}

#endif
