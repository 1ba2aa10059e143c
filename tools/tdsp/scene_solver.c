/* SPDX-License-Identifier: MIT */
/* A scene file with a solver for it. */
#include "scene_solver.h"

#include <math.h>

#include "cli.h"
#include "numbers.h"
#include "stopwatch.h"
#include "words.h"

static gboolean take_for(SceneFile *file, tdsp_method method, SceneSolver *out, GError **error)
{
    SceneSolver made = {.file = *file};
    *file = (SceneFile){0};
    Stopwatch watch = stopwatch_start();
    tdsp_status status = tdsp_solver_create_for(made.file.scene, method, &made.solver);
    made.prepare_seconds = made.file.prepare_seconds + stopwatch_seconds(watch);
    if (status != TDSP_OK) {
        if (status == TDSP_NOT_SUPPORTED)
            cli_fail(error, CLI_USAGE, "--method %s: does not apply to discs that grow as those of %s", words_method(method), made.file.file);
        else
            cli_fail_status(error, "solver", status);
        scene_solver_clear(&made);
        return FALSE;
    }
    *out = made;
    return TRUE;
}

gboolean scene_solver_take(SceneFile *file, SceneSolver *out, GError **error)
{
    return take_for(file, TDSP_METHOD_AUTO, out, error);
}

gboolean scene_solver_parse(const FileIn *file, const SceneEnds *ends, SceneSolver *out, GError **error)
{
    SceneFile scene;
    return scene_file_parse_between(cli_file_name(file->path), file->text, file->length, ends, &scene, error) &&
           scene_solver_take(&scene, out, error);
}

gboolean scene_solver_load_for(const char *path, const SceneEnds *ends, tdsp_method method, SceneSolver *out, GError **error)
{
    SceneFile file;
    return scene_file_load_between(path, ends, &file, error) && take_for(&file, method, out, error);
}

gboolean scene_solver_load(const char *path, SceneSolver *out, GError **error)
{
    return scene_solver_load_for(path, NULL, TDSP_METHOD_AUTO, out, error);
}

void scene_solver_clear(SceneSolver *solver)
{
    g_clear_pointer(&solver->solver, tdsp_solver_free);
    scene_file_clear(&solver->file);
}

GArray *scene_solver_path(const tdsp_solver *solver, GError **error)
{
    size_t count;
    tdsp_status status = tdsp_solver_path(solver, NULL, 0, &count);
    if (status != TDSP_OK && status != TDSP_BUFFER_TOO_SMALL) {
        cli_fail_status(error, "path", status);
        return NULL;
    }
    GArray *legs = g_array_sized_new(FALSE, TRUE, sizeof(tdsp_leg), (guint)count);
    g_array_set_size(legs, (guint)count);
    status = tdsp_solver_path(solver, (tdsp_leg *)legs->data, count, &count);
    if (status == TDSP_OK) return legs;
    g_array_unref(legs);
    cli_fail_status(error, "path", status);
    return NULL;
}

GArray *scene_solver_path_if(const tdsp_solver *solver, tdsp_status status, GError **error)
{
    return status == TDSP_OK ? scene_solver_path(solver, error) : g_array_new(FALSE, TRUE, sizeof(tdsp_leg));
}

gboolean scene_solver_fail(const SceneSolver *solver, tdsp_status status, GError **error)
{
    return scene_file_fail(&solver->file, "solver", status, error);
}

gboolean scene_solver_arrival(const SceneSolver *solver, double departure, double *arrival, tdsp_status *status, GError **error)
{
    *status = tdsp_earliest_arrival(solver->solver, departure, arrival);
    if (!tdsp_status_is_answer(*status)) return scene_solver_fail(solver, *status, error);
    if (*status != TDSP_OK) *arrival = INFINITY;
    return TRUE;
}

gboolean scene_solver_arrival_within(const SceneSolver *solver, double departure, double within, double *arrival, double *lower,
                                     tdsp_status *status, GError **error)
{
    *status = tdsp_earliest_arrival_within(solver->solver, departure, within, arrival, lower);
    if (!tdsp_status_is_answer(*status)) return scene_solver_fail(solver, *status, error);
    if (*status != TDSP_OK) *arrival = *lower = INFINITY;
    return TRUE;
}

gboolean scene_solver_parse_within(const char *text, double *within, GError **error)
{
    *within = 0;
    if (!text) return TRUE;
    const char *wrong = number_parse(text, within);
    if (wrong) return cli_fail(error, CLI_USAGE, "--within \"%s\": %s", text, wrong);
    if (*within > 0 && *within <= 1) return TRUE;
    return cli_fail(error, CLI_USAGE, "--within \"%s\": must be greater than 0 and at most 1", text);
}
