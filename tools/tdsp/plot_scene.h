/* SPDX-License-Identifier: MIT */
/* The picture of a scene. */
#ifndef PLOT_SCENE_H
#define PLOT_SCENE_H

#include "scene_file.h"
#include "tdsp/shape.h"

/* What is drawn: the scene for a robot that leaves at `departure`, and its path. */
typedef struct ScenePicture {
    const SceneFile *scene;
    double departure;
    double arrival; /* infinite when there is no path */
    tdsp_status status;
    const GArray *legs; /* of tdsp_leg */
    const tdsp_jumps *jumps; /* to be marked; NULL for none */
} ScenePicture;

gboolean plot_scene(const ScenePicture *picture, const char *path, GError **error);

#endif
