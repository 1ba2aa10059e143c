/* SPDX-License-Identifier: MIT */
/* The picture of a scene. */
#ifndef PLOT_SCENE_H
#define PLOT_SCENE_H

#include "plot_route.h"
#include "scene_file.h"
#include "tdsp/shape.h"

typedef struct PictureJourney {
    double departure;
    double arrival; /* infinite when there is no path */
    tdsp_status status;
    const GArray *legs; /* of tdsp_leg; empty when there is no path */
} PictureJourney;

#define PICTURE_JOURNEYS 2 /* at most */

/* What is drawn: the scene for a robot that leaves at the first journey's departure, its path, and beside it that of another departure. */
typedef struct ScenePicture {
    const SceneFile *scene;
    PictureJourney journeys[PICTURE_JOURNEYS];
    guint count;             /* of journeys: 1 or 2, in order of departure */
    const tdsp_jumps *jumps; /* to be marked; NULL for none */
    double seconds;          /* how long the journeys take in a picture that moves; 0: it is to stand still */
} ScenePicture;

/* When the last robot arrives; infinite when none does. */
double plot_scene_end(const ScenePicture *picture);

/* Does it move? Not where nobody goes anywhere, whatever is asked for. */
gboolean plot_scene_moves(const ScenePicture *picture);

/* The path of a journey, without legs where there is none, and what it is drawn with. */
Route plot_scene_route(const ScenePicture *picture, guint journey);

gboolean plot_scene(const ScenePicture *picture, const char *path, GError **error);

#endif
