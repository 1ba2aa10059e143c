/* SPDX-License-Identifier: MIT */
/* What `envelope` and `jumps` share: a scene, how far and how finely to look, and the gaps that close. */
#ifndef SHAPE_ASKED_H
#define SHAPE_ASKED_H

#include "json_out.h"
#include "progress.h"
#include "scene_solver.h"
#include "tdsp/shape.h"

typedef struct ShapeAsked {
    gboolean json;
    char *horizon, *fineness; /* as given; NULL: not given */
    tdsp_shape_options options;
    SceneSolver solver;
    Progress progress;
} ShapeAsked;

void shape_asked_clear(ShapeAsked *asked);
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC(ShapeAsked, shape_asked_clear)

#define SHAPE_ASKED_HORIZON(text)                                                                                                \
    {"horizon", 0, 0, G_OPTION_ARG_STRING, (text), "Latest departure; needed where no disc ever ends them", "H"}

/* A length of time over 0 from an option, where given. */
gboolean shape_asked_fineness(const ShapeAsked *asked, const char *option, double *value, GError **error);

/* Load the scene and set up the options. A bar named `what` is shown until shape_asked_done(). */
gboolean shape_asked_begin(ShapeAsked *asked, const char *path, const char *what, GError **error);

/* What became of it: FALSE with an error, unless `status` is an answer. */
gboolean shape_asked_done(ShapeAsked *asked, tdsp_status status, GError **error);

/* Its members: "first", "second", "time", "place", all null where it is not known. */
void shape_json_gap(JsonOut *out, const tdsp_gap *gap);

/* "3 and 7", or "unknown". Free with g_free(). */
char *shape_gap_discs(const tdsp_gap *gap);

#endif
