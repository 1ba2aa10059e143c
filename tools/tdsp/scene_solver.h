/* SPDX-License-Identifier: MIT */
/* A scene file with a solver for it. */
#ifndef SCENE_SOLVER_H
#define SCENE_SOLVER_H

#include "scene_file.h"
#include "tdsp/solver.h"

typedef struct SceneSolver {
    SceneFile file;
    tdsp_solver *solver;
    double prepare_seconds; /* of the scene and the solver; reading the file is not counted */
} SceneSolver;

gboolean scene_solver_load(const char *path, SceneSolver *out, GError **error);
/* The same between other ends (NULL: its own) and with a method; one that does not apply to the scene is a usage error. */
gboolean scene_solver_load_for(const char *path, const SceneEnds *ends, tdsp_method method, SceneSolver *out, GError **error);
/* The same for a file that was loaded already. */
gboolean scene_solver_parse(const FileIn *file, const SceneEnds *ends, SceneSolver *out, GError **error);
/* Make a solver for a scene file that was read; takes the file over. */
gboolean scene_solver_take(SceneFile *file, SceneSolver *out, GError **error);
void scene_solver_clear(SceneSolver *solver);
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC(SceneSolver, scene_solver_clear)

/* The legs of the solver's last answer (of tdsp_leg). NULL on failure. */
GArray *scene_solver_path(const tdsp_solver *solver, GError **error);
/* The same for an answer of that status: no legs where it is that there is no path. */
GArray *scene_solver_path_if(const tdsp_solver *solver, tdsp_status status, GError **error);

/* Turn the solver's status that is no answer into an error. Returns FALSE. */
gboolean scene_solver_fail(const SceneSolver *solver, tdsp_status status, GError **error);

/* A(departure), infinite when there is no way, and the answer. FALSE for an error. */
gboolean scene_solver_arrival(const SceneSolver *solver, double departure, double *arrival, tdsp_status *status, GError **error);

/* The same within a share of the best: nothing arrives before *lower, which is infinite too when there is no way. */
gboolean scene_solver_arrival_within(const SceneSolver *solver, double departure, double within, double *arrival, double *lower,
                                     tdsp_status *status, GError **error);

/* The option for it; `text` receives what was given, which scene_solver_parse_within() turns into a share (NULL: 0, exact). */
#define SCENE_SOLVER_WITHIN(text)                                                                                                \
    {"within", 0, 0, G_OPTION_ARG_STRING, (text), "Travel time at most 1 + DELTA times the least, found sooner", "DELTA"}
/* The option for the method; words_parse_method() reads what was given. */
#define SCENE_SOLVER_METHOD(text)                                                                                                \
    {"method", 0, 0, G_OPTION_ARG_STRING, (text), "auto, same-speed, different-speeds or general (default auto)", "METHOD"}
gboolean scene_solver_parse_within(const char *text, double *within, GError **error);

#endif
