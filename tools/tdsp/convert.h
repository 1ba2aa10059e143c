/* SPDX-License-Identifier: MIT */
/* The formats that tdsp convert reads and writes, one file each. A reader fills a draft; a writer appends the whole text of a file. */
#ifndef CONVERT_H
#define CONVERT_H

#include <glib.h>

#include "instant.h"
#include "path_points.h"
#include "scene_draft.h"

gboolean convert_csv_read(const char *text, gsize length, const DraftFields *fields, SceneDraft *draft, GError **error);
gboolean convert_geojson_read(const char *text, gsize length, const DraftFields *fields, SceneDraft *draft, GError **error);

/* Scenes. `file` is what messages call the scene. */
gboolean convert_csv_scene(const char *file, const SceneDescription *scene, GString *into, GError **error);
gboolean convert_geojson_scene(const char *file, const SceneDescription *scene, GString *into, GError **error);

/* A path with what is known of it beside its points. */
typedef struct ConvertPath {
    const SceneDescription *scene; /* its name, units and georeference, as far as they are known */
    const PathFile *path;
    const PathPoints *points;
    Epoch epoch;
} ConvertPath;

void convert_csv_path(const ConvertPath *path, GString *into);
void convert_geojson_path(const ConvertPath *path, GString *into);
void convert_gpx_path(const ConvertPath *path, GString *into);

/* The instant of a point; the path's ends are known to be instants. */
const char *convert_instant(char buffer[INSTANT_ROOM], const ConvertPath *path, const PathPoint *point);

/* Of the leg that a point was reached on. */
const tdsp_leg *convert_leg(const ConvertPath *path, const PathPoint *point);

#endif
