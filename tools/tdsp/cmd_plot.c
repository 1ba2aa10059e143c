/* SPDX-License-Identifier: MIT */
/* tdsp plot: pictures of scenes and tables. */
#include <math.h>

#include "commands.h"
#include "file_in.h"
#include "file_out.h"
#include "json_out.h"
#include "plot_canvas.h"
#include "plot_curve.h"
#include "plot_scene.h"
#include "scene_solver.h"

#define SECONDS 8.0 /* what a journey takes in a picture that moves, unless it is said */
#define LEAST_SECONDS 1.0
#define MOST_SECONDS 600.0

typedef struct Wanted {
    gboolean json;
    gboolean jumps, animate;
    SceneEnds ends;
    char *output, *depart_text, *beside_text, *horizon_text, *seconds_text;
    double departure, beside, horizon;
    double seconds; /* 0: the picture stands still */
} Wanted;

static void wanted_clear(Wanted *wanted)
{
    g_free(wanted->output);
    g_free(wanted->depart_text);
    g_free(wanted->beside_text);
    g_free(wanted->horizon_text);
    g_free(wanted->seconds_text);
    scene_ends_clear(&wanted->ends);
}
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC(Wanted, wanted_clear)

typedef struct Drawn {
    double arrival; /* of a scene; infinite when there is no path */
    tdsp_status status;
    gboolean moves;
} Drawn;

/* The jumps to mark, where they are wanted; none where there is no way at all. */
static gboolean find_jumps(const Wanted *wanted, tdsp_solver *solver, tdsp_jumps **jumps, GError **error)
{
    tdsp_shape_options options;
    if (!wanted->jumps) return TRUE;
    tdsp_shape_options_init(&options);
    if (wanted->horizon_text) options.until = wanted->horizon;
    tdsp_status status = tdsp_jumps_find(solver, &options, jumps);
    if (status == TDSP_NEEDS_HORIZON)
        return cli_fail(error, CLI_USAGE, "no disc ever ends the departures of this scene: say how far to look for jumps with --horizon H");
    return tdsp_status_is_answer(status) ? TRUE : cli_fail_status(error, "solver", status);
}

/* A scene without a path is drawn too, for that is when one wants to look at it. */
static gboolean solve(const SceneSolver *solver, double departure, PictureJourney *journey, GError **error)
{
    PictureJourney solved = {.departure = departure};
    if (!scene_solver_arrival(solver, departure, &solved.arrival, &solved.status, error)) return FALSE;
    solved.legs = scene_solver_path_if(solver->solver, solved.status, error);
    *journey = solved;
    return solved.legs != NULL;
}

static gboolean draw_picture(const SceneSolver *solver, const Wanted *wanted, ScenePicture *picture, Drawn *drawn, GError **error)
{
    tdsp_jumps *jumps = NULL;
    if (!find_jumps(wanted, solver->solver, &jumps, error)) return FALSE;
    picture->jumps = jumps;
    picture->seconds = wanted->seconds;
    *drawn = (Drawn){picture->journeys[0].arrival, picture->journeys[0].status, plot_scene_moves(picture)};
    gboolean done = plot_scene(picture, wanted->output, error);
    tdsp_jumps_free(jumps);
    return done;
}

static gboolean draw_scene(const FileIn *file, const Wanted *wanted, Drawn *drawn, GError **error)
{
    g_auto(SceneSolver) solver = {0};
    ScenePicture picture = {.scene = &solver.file, .count = wanted->beside_text ? 2 : 1};
    if (!scene_solver_parse(file, &wanted->ends, &solver, error)) return FALSE;
    gboolean done = solve(&solver, wanted->departure, &picture.journeys[0], error) &&
                    (picture.count < 2 || solve(&solver, wanted->beside, &picture.journeys[1], error)) &&
                    draw_picture(&solver, wanted, &picture, drawn, error);
    for (guint i = 0; i < picture.count; i++)
        if (picture.journeys[i].legs) g_array_unref((GArray *)picture.journeys[i].legs);
    return done;
}

static gboolean draw_table(const FileIn *file, const Wanted *wanted, Drawn *drawn, GError **error)
{
    g_autofree char *name = g_path_get_basename(file->path);
    const double *departure = wanted->depart_text ? &wanted->departure : NULL;
    *drawn = (Drawn){INFINITY, TDSP_OK, FALSE};
    if (wanted->animate || wanted->beside_text)
        return cli_fail(error, CLI_USAGE, "%s goes with a scene; the picture of a table is a curve over all departures",
                        wanted->animate ? "--animate" : "--beside");
    if (departure) {
        drawn->status = tdsp_table_arrival(&file->table, *departure, NULL, &drawn->arrival);
        if (!tdsp_status_is_answer(drawn->status)) return cli_fail_status(error, "table", drawn->status);
    }
    return plot_curve(&file->table, name, departure, wanted->output, error);
}

static gboolean print(const Wanted *wanted, const FileIn *file, const Drawn *drawn, GError **error)
{
    g_auto(JsonOut) out = json_out_new();
    if (!wanted->json) return TRUE;
    json_out_begin(&out, '{');
    json_out_member_string(&out, "file", wanted->output);
    json_out_member_string(&out, "of", file->kind == FILE_TABLE ? "table" : "scene");
    json_out_member_number(&out, "departure", file->kind == FILE_TABLE && !wanted->depart_text ? INFINITY : wanted->departure);
    json_out_member_number(&out, "arrival", drawn->arrival);
    json_out_member_string(&out, "status", tdsp_status_name(drawn->status));
    json_out_member_number(&out, "seconds", drawn->moves ? wanted->seconds : INFINITY);
    json_out_end(&out, '}');
    return json_out_print(&out, error);
}

static gboolean parse_seconds(Wanted *wanted, GError **error)
{
    wanted->seconds = wanted->animate ? SECONDS : 0;
    if (!wanted->seconds_text) return TRUE;
    if (!wanted->animate) return cli_fail(error, CLI_USAGE, "--seconds goes with --animate");
    if (!cli_option_number("--seconds", wanted->seconds_text, &wanted->seconds, error)) return FALSE;
    if (wanted->seconds >= LEAST_SECONDS && wanted->seconds <= MOST_SECONDS) return TRUE;
    return cli_fail(error, CLI_USAGE, "--seconds \"%s\": must be from %g to %g", wanted->seconds_text, LEAST_SECONDS, MOST_SECONDS);
}

static gboolean parse_wanted(Wanted *wanted, GError **error)
{
    if (!wanted->output) return cli_fail(error, CLI_USAGE, "-o FILE is missing: where to draw, .svg or .png");
    if (!canvas_check_name(wanted->output, wanted->animate, error) || !parse_seconds(wanted, error)) return FALSE;
    if (!cli_option_number("--horizon", wanted->horizon_text, &wanted->horizon, error) ||
        !cli_option_number("--depart", wanted->depart_text, &wanted->departure, error) ||
        !cli_option_number("--beside", wanted->beside_text, &wanted->beside, error))
        return FALSE;
    if (wanted->beside_text && wanted->beside < wanted->departure)
        return cli_fail(error, CLI_USAGE, "--beside \"%s\": must not be before the departure of --depart", wanted->beside_text);
    return TRUE;
}

int cmd_plot(const CliCommand *command, int argc, char **argv, GError **error)
{
    g_auto(Wanted) wanted = {0};
    g_auto(FileIn) file = {0};
    Drawn drawn = {INFINITY, TDSP_OK, FALSE};
    const GOptionEntry entries[] = {
        {"output", 'o', 0, G_OPTION_ARG_FILENAME, &wanted.output, "Draw to FILE, which ends in .svg or .png", "FILE"},
        {"depart", 0, 0, G_OPTION_ARG_STRING, &wanted.depart_text, "Departure to draw (default 0), or to mark in a table", "T"},
        {"beside", 0, 0, G_OPTION_ARG_STRING, &wanted.beside_text, "Show the path of this later departure too, to compare", "T"},
        {"jumps", 0, 0, G_OPTION_ARG_NONE, &wanted.jumps, "Mark in a scene the gaps whose closing makes the travel time jump", NULL},
        {"horizon", 0, 0, G_OPTION_ARG_STRING, &wanted.horizon_text, "Look for jumps up to this departure (with --jumps)", "H"},
        {"animate", 0, 0, G_OPTION_ARG_NONE, &wanted.animate, "Let the discs of a scene grow and the robot go, in an SVG that browsers play", NULL},
        {"seconds", 0, 0, G_OPTION_ARG_STRING, &wanted.seconds_text, "How long the journey takes in it (default 8)", "S"},
        SCENE_ENDS_ENTRIES(&wanted.ends),
        G_OPTION_ENTRY_NULL,
    };
    if (!cli_parse(command, entries, &wanted.json, &argc, &argv, error) || !cli_positional(command, argc, 1, 1, error) ||
        !parse_wanted(&wanted, error))
        return CLI_FAILED;
    const char *const inputs[] = {argv[1], NULL};
    if (!file_out_check(wanted.output, inputs, error) || !file_in_load(argv[1], &file, error) ||
        !scene_ends_fit(&wanted.ends, &file, error))
        return CLI_FAILED;
    gboolean done =
        file.kind == FILE_TABLE ? draw_table(&file, &wanted, &drawn, error) : draw_scene(&file, &wanted, &drawn, error);
    if (!done || !print(&wanted, &file, &drawn, error)) return CLI_FAILED;
    g_autofree char *reason = cli_reason(drawn.status);
    if (drawn.status != TDSP_OK) cli_warn("no path at this departure: %s", reason);
    if (wanted.seconds > 0 && !drawn.moves) cli_warn("nobody goes anywhere, so the picture stands still");
    return CLI_DONE;
}
