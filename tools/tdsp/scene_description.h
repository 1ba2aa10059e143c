/* SPDX-License-Identifier: MIT */
/*
 * A scene as it is written down, before it is prepared: what a scene file says, and what other formats are converted to and from.
 */
#ifndef SCENE_DESCRIPTION_H
#define SCENE_DESCRIPTION_H

#include <glib.h>

#include "georeference.h"
#include "json_out.h"
#include "tdsp/growth.h"
#include "tdsp/scene.h"

typedef struct SceneDescription {
    char *name;        /* "" where there is none */
    char *length_unit; /* "" likewise */
    char *time_unit;
    tdsp_journey journey;
    GArray *discs;   /* of tdsp_growing_disc */
    GPtrArray *kept; /* arrays of numbers that the discs point to */
    Georeference georeference;
} SceneDescription;

/* Without discs, names and numbers. */
SceneDescription scene_description_new(void);

/* Read the text of a scene file, which messages call `file`. */
gboolean scene_description_parse(const char *file, const char *text, gsize length, SceneDescription *scene, GError **error);

/* The scene as a scene file. */
void scene_description_write(const SceneDescription *scene, JsonOut *out);

/* The members `name`, `units` and `georeference`, as far as there are any, for another format. */
void scene_description_write_header(const SceneDescription *scene, JsonOut *out);

/* Read these three, each of them optional, from the object that any format keeps them in. */
gboolean scene_description_read_header(const JsonValue *object, SceneDescription *scene, GHashTable *warned, GError **error);

/* How far from the origin of the plane centres and ends reach, a length. */
double scene_description_extent(const SceneDescription *scene);

void scene_description_clear(SceneDescription *scene);
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC(SceneDescription, scene_description_clear)

#endif
