/* SPDX-License-Identifier: MIT */
/* tdsp margin: what a departure has to spare, in time and in growth. */
#include <math.h>

#include "commands.h"
#include "file_in.h"
#include "margins.h"
#include "path_json.h"
#include "progress.h"
#include "scene_solver.h"
#include "table_path.h"
#include "tdsp/path.h"
#include "times.h"

/* Whose path is looked at: the fastest, or that of a file. */
typedef struct GivenPath {
    gboolean is_given;
    FileIn file;
    PathFile path; /* of a file that is no table */
} GivenPath;

static void given_path_clear(GivenPath *given)
{
    file_in_clear(&given->file);
    path_file_clear(&given->path);
}
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC(GivenPath, given_path_clear)

static gboolean given_path_load(const char *name, double speed, GivenPath *given, GError **error)
{
    if (!name) return TRUE;
    given->is_given = TRUE;
    if (!file_in_load(name, &given->file, error)) return FALSE;
    if (given->file.kind == FILE_TABLE) return TRUE;
    if (!path_json_parse(cli_file_name(name), given->file.text, given->file.length, speed, &given->path, error)) return FALSE;
    if (isfinite(given->path.arrival)) return TRUE;
    return cli_fail(error, CLI_INPUT, "%s: the file holds no path: its status is %s", cli_file_name(name), given->path.status);
}

/* The path moved so that it starts at `departure`. */
static GArray *moved_path(const PathFile *path, double departure)
{
    GArray *legs = g_array_sized_new(FALSE, TRUE, sizeof(tdsp_leg), path->legs->len);
    for (guint i = 0; i < path->legs->len; i++) {
        tdsp_leg leg = g_array_index(path->legs, tdsp_leg, i);
        if (departure != path->departure) leg = tdsp_leg_shifted(&leg, departure - path->departure);
        g_array_append_val(legs, leg);
    }
    return legs;
}

/* The legs to look at; *status says why there are none. NULL on failure. */
static GArray *choose_path(const SceneSolver *solver, const GivenPath *given, double departure, tdsp_status *status,
                           GError **error)
{
    *status = TDSP_OK;
    if (!given->is_given) {
        double arrival;
        if (!scene_solver_arrival(solver, departure, &arrival, status, error)) return NULL;
        return scene_solver_path_if(solver->solver, *status, error);
    }
    if (given->file.kind != FILE_TABLE) return moved_path(&given->path, departure);
    TablePath row;
    if (!table_path_find(&given->file.table, departure, &row, error)) return NULL;
    *status = row.status;
    return row.legs;
}

static gboolean ask_path(const SceneSolver *solver, const GivenPath *given, DepartureMargins *one, GError **error)
{
    g_autoptr(GArray) legs = choose_path(solver, given, one->departure, &one->path_status, error);
    if (!legs) return FALSE;
    for (guint how = 0; how < 2 && one->path_status == TDSP_OK; how++) {
        tdsp_status status = tdsp_path_margin(solver->file.scene, (tdsp_raise)how, (const tdsp_leg *)legs->data,
                                              legs->len, one->departure, &one->path[how]);
        if (status == TDSP_NOT_SUPPORTED)
            one->path_status = status; /* growth that changes */
        else if (status != TDSP_OK)
            return cli_fail_status(error, "path", status);
    }
    return TRUE;
}

/* An added rate may be more than is known of growth that bends: that is no failure of the rest. */
static gboolean ask_margin(const SceneSolver *solver, tdsp_raise how, double deadline, DepartureMargins *one, GError **error)
{
    tdsp_margin *margin = &one->anew[how];
    *margin = (tdsp_margin){
        -INFINITY, TDSP_NOT_SUPPORTED, INFINITY, {TDSP_LIMIT_NONE, TDSP_NO_DISC, TDSP_NO_DISC, INFINITY, {0, 0}}, 0};
    tdsp_status status = tdsp_departure_margin(solver->file.scene, how, one->departure, deadline, margin);
    return status == TDSP_OK || status == TDSP_NOT_SUPPORTED || scene_solver_fail(solver, status, error);
}

static gboolean ask(const SceneSolver *solver, const GivenPath *given, double deadline, DepartureMargins *one, GError **error)
{
    Stopwatch watch = stopwatch_start();
    tdsp_status status = tdsp_solver_slack(solver->solver, one->departure, deadline, &one->slack);
    if (status != TDSP_OK) return scene_solver_fail(solver, status, error);
    for (guint how = 0; how < 2; how++)
        if (!ask_margin(solver, (tdsp_raise)how, deadline, one, error)) return FALSE;
    if (!ask_path(solver, given, one, error)) return FALSE;
    one->seconds = stopwatch_seconds(watch);
    return TRUE;
}

static gboolean ask_all(const SceneSolver *solver, const GivenPath *given, double deadline, const GArray *times, GArray *all,
                        GError **error)
{
    Progress progress = progress_begin("margin");
    gboolean done = TRUE;
    for (guint i = 0; done && i < times->len; i++) {
        DepartureMargins one = {.departure = g_array_index(times, double, i)};
        done = ask(solver, given, deadline, &one, error);
        g_array_append_val(all, one);
        progress_show(&progress, i + 1, times->len);
    }
    progress_end(&progress);
    return done;
}

/* Does any departure arrive in time? */
static gboolean any_in_time(const GArray *all)
{
    for (guint i = 0; i < all->len; i++)
        if (g_array_index(all, DepartureMargins, i).slack.early >= 0) return TRUE;
    return FALSE;
}

/* Without a departure, which only goes with a path, the path's own. */
static gboolean own_departure(const CliCommand *command, int argc, const GivenPath *given, GArray *times, GError **error)
{
    if (times->len > 0) return TRUE;
    if (given->file.kind == FILE_TABLE) return cli_positional(command, argc, 2, -1, error);
    g_array_append_val(times, given->path.departure);
    return TRUE;
}

int cmd_margin(const CliCommand *command, int argc, char **argv, GError **error)
{
    gboolean json = FALSE;
    g_autofree char *deadline_text = NULL, *path_name = NULL;
    const GOptionEntry entries[] = {
        {"deadline", 0, 0, G_OPTION_ARG_STRING, &deadline_text, "Arrive by A (default: arrive at all)", "A"},
        {"path", 0, 0, G_OPTION_ARG_FILENAME, &path_name, "Look at this path, or this table's, instead of the fastest", "FILE"},
        G_OPTION_ENTRY_NULL,
    };
    g_autoptr(GArray) times = times_new();
    g_autoptr(GArray) limits = times_new();
    g_autoptr(GArray) all = g_array_new(FALSE, TRUE, sizeof(DepartureMargins));
    g_auto(SceneSolver) solver = {0};
    g_auto(GivenPath) given = {0};
    if (!cli_parse(command, entries, &json, &argc, &argv, error) ||
        !cli_positional(command, argc, path_name ? 1 : 2, -1, error) ||
        !times_add_all(times, argc, argv, 2, "departure", error) ||
        (deadline_text && !times_add(limits, deadline_text, "--deadline", error)) ||
        !scene_solver_load(argv[1], &solver, error) ||
        !given_path_load(path_name, tdsp_scene_journey(solver.file.scene)->speed, &given, error) ||
        !own_departure(command, argc, &given, times, error))
        return CLI_FAILED;
    double deadline = limits->len > 0 ? g_array_index(limits, double, 0) : INFINITY;
    if (!ask_all(&solver, &given, deadline, times, all, error) ||
        !(json ? margins_print_json(all, deadline, solver.prepare_seconds, error) : margins_print_text(all, error)))
        return CLI_FAILED;
    return cli_answer(any_in_time(all));
}
