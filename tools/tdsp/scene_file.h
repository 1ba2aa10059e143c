/* SPDX-License-Identifier: MIT */
/* Scene files: JSON in, a prepared scene out. */
#ifndef SCENE_FILE_H
#define SCENE_FILE_H

#include <glib.h>

#include "file_in.h"
#include "tdsp/scene.h"
#include "tdsp/status.h"

typedef struct SceneFile {
    char *file;        /* its name, for messages */
    char *name;        /* "" where the file has none */
    char *length_unit; /* "" likewise */
    char *time_unit;
    tdsp_scene *scene;
    double prepare_seconds;
} SceneFile;

/* Other ends for the scene's journey, "X,Y" as given; NULL: the scene's own. */
typedef struct SceneEnds {
    char *from, *to;
} SceneEnds;
#define SCENE_ENDS_ENTRIES(ends)                                                                                                 \
    {"from", 0, 0, G_OPTION_ARG_STRING, &(ends)->from, "Leave from here instead of the scene's source", "X,Y"},                 \
    {"to", 0, 0, G_OPTION_ARG_STRING, &(ends)->to, "Go here instead of to the scene's destination", "X,Y"}
void scene_ends_clear(SceneEnds *ends);
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC(SceneEnds, scene_ends_clear)

/* An error where ends are given beside a table, which has its own. */
gboolean scene_ends_fit(const SceneEnds *ends, const FileIn *file, GError **error);

/* The two below with other ends; `ends` may be NULL. */
gboolean scene_file_load_between(const char *path, const SceneEnds *ends, SceneFile *scene, GError **error);
gboolean scene_file_parse_between(const char *file, const char *text, gsize length, const SceneEnds *ends, SceneFile *scene, GError **error);

/* Read the scene file `path` ("-": standard input). */
gboolean scene_file_load(const char *path, SceneFile *scene, GError **error);

/* Read a scene from `text`, which messages call `file`. */
gboolean scene_file_parse(const char *file, const char *text, gsize length, SceneFile *scene, GError **error);

/* Turn a library status that is no answer about this scene into an error: about the disc that shrinks, or about `what`. Returns FALSE. */
gboolean scene_file_fail(const SceneFile *scene, const char *what, tdsp_status status, GError **error);

void scene_file_clear(SceneFile *scene);
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC(SceneFile, scene_file_clear)

#endif
