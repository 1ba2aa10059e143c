/* Scene files: JSON in, a prepared scene out. */
#ifndef SCENE_FILE_H
#define SCENE_FILE_H

#include <glib.h>

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

/* Read the scene file `path` ("-": standard input). */
gboolean scene_file_load(const char *path, SceneFile *scene, GError **error);

/* Read a scene from `text`, which messages call `file`. */
gboolean scene_file_parse(const char *file, const char *text, gsize length, SceneFile *scene, GError **error);

/* Turn a library status that is no answer about this scene into an error: about the disc that shrinks, or about `what`. Returns FALSE. */
gboolean scene_file_fail(const SceneFile *scene, const char *what, tdsp_status status, GError **error);

void scene_file_clear(SceneFile *scene);
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC(SceneFile, scene_file_clear)

#endif
