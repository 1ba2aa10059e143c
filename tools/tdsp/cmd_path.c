/* SPDX-License-Identifier: MIT */
/* tdsp path: the path that answers a departure, from a scene (the best, or within a share of it) or a table (the row's path, moved earlier). */
#include <math.h>

#include "commands.h"
#include "file_in.h"
#include "numbers.h"
#include "path_json.h"
#include "scene_solver.h"
#include "table_path.h"
#include "tdsp/path.h"
#include "text_table.h"
#include "times.h"

typedef struct Path {
    const SceneEnds *ends;
    double departure, arrival;
    double within, lower; /* 0: exact, without a lower bound */
    tdsp_status status;
    GArray *legs; /* of tdsp_leg; empty without a path */
    gboolean from_table;
    TablePath row; /* of a table */
} Path;

static void path_clear(Path *path)
{
    g_clear_pointer(&path->legs, g_array_unref);
}
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC(Path, path_clear)

static gboolean solve(const SceneSolver *solver, Path *path, GError **error)
{
    if (path->within > 0)
        return scene_solver_arrival_within(solver, path->departure, path->within, &path->arrival, &path->lower, &path->status,
                                           error);
    return scene_solver_arrival(solver, path->departure, &path->arrival, &path->status, error);
}

static gboolean from_scene(const FileIn *file, Path *path, GError **error)
{
    g_auto(SceneSolver) solver = {0};
    if (!scene_solver_parse(file, path->ends, &solver, error) || !solve(&solver, path, error)) return FALSE;
    path->legs = scene_solver_path_if(solver.solver, path->status, error);
    return path->legs != NULL;
}

static gboolean from_table(const FileIn *file, Path *path, GError **error)
{
    path->from_table = TRUE;
    if (path->within > 0) return cli_fail(error, CLI_USAGE, "--within goes with a scene; the paths of a table are made already");
    if (!table_path_find(&file->table, path->departure, &path->row, error)) return FALSE;
    path->status = path->row.status;
    path->arrival = path->row.arrival;
    path->legs = g_steal_pointer(&path->row.legs);
    return TRUE;
}

/* Where the robot is at `time`; at the source before it leaves, at the destination once it is there. */
static gboolean position(const Path *path, double time, tdsp_point *place, GError **error)
{
    if (path->legs->len == 0) return cli_fail(error, CLI_NO, "no leg to be on at that time");
    tdsp_status status = tdsp_path_position((const tdsp_leg *)path->legs->data, path->legs->len, time, place);
    return status == TDSP_OK ? TRUE : cli_fail_status(error, "position", status);
}

static void table_leg(TextTable *table, const tdsp_leg *leg)
{
    gboolean arc = leg->kind != TDSP_LEG_LINE;
    g_autofree char *disc = g_strdup_printf("%u", leg->disc);
    text_table_number(table, leg->start_time);
    text_table_number(table, leg->end_time);
    text_table_string(table, arc ? (leg->turn > 0 ? "arc-ccw" : "arc-cw") : "line");
    text_table_number(table, leg->from.x);
    text_table_number(table, leg->from.y);
    text_table_number(table, leg->to.x);
    text_table_number(table, leg->to.y);
    text_table_string(table, arc ? disc : "-");
}

static gboolean print_text(const Path *path, GError **error)
{
    static const char *const heading[] = {"start_time", "end_time", "leg", "from_x", "from_y", "to_x", "to_y", "disc", NULL};
    char departure[NUMBER_ROOM], arrival[NUMBER_ROOM];
    g_auto(TextTable) table = text_table_new(heading);
    g_autoptr(GString) text = g_string_new(NULL);
    g_string_printf(text, "# departure %s  arrival %s  %s\n", number_format(departure, path->departure),
                    number_format(arrival, path->arrival), tdsp_status_name(path->status));
    if (path->within > 0)
        g_string_append_printf(text, "# lower %s  within %s\n", number_format(departure, path->lower),
                               number_format(arrival, path->within));
    if (path->from_table && path->status == TDSP_OK)
        g_string_append_printf(text, "# row %" G_GUINT64_FORMAT ", computed for departure %s\n", path->row.row,
                               number_format(departure, path->row.computed_for));
    for (guint i = 0; i < path->legs->len; i++) table_leg(&table, &g_array_index(path->legs, tdsp_leg, i));
    text_table_append(&table, text);
    return cli_print(text, error);
}

static gboolean print_position(tdsp_point place, GError **error)
{
    char x[NUMBER_ROOM], y[NUMBER_ROOM];
    g_autoptr(GString) text = g_string_new(NULL);
    g_string_printf(text, "%s %s\n", number_format(x, place.x), number_format(y, place.y));
    return cli_print(text, error);
}

static void json_row(JsonOut *out, const Path *path)
{
    gboolean found = path->status == TDSP_OK;
    json_out_key(out, "row");
    if (found)
        json_out_whole(out, path->row.row);
    else
        json_out_null(out);
    json_out_member_number(out, "computed_for", found ? path->row.computed_for : INFINITY);
}

static gboolean print_json(const Path *path, const double *at, const tdsp_point *place, GError **error)
{
    g_auto(JsonOut) out = json_out_new();
    json_out_begin(&out, '{');
    json_out_member_number(&out, "departure", path->departure);
    json_out_member_number(&out, "arrival", path->arrival);
    if (path->within > 0) {
        json_out_member_number(&out, "lower", path->lower);
        json_out_member_number(&out, "within", path->within);
    }
    json_out_member_string(&out, "status", tdsp_status_name(path->status));
    if (path->from_table) json_row(&out, path);
    if (at) {
        json_out_member_number(&out, "time", *at);
        json_out_member_point(&out, "position", *place);
    }
    json_out_key(&out, "legs");
    path_json_legs(&out, (const tdsp_leg *)path->legs->data, path->legs->len);
    json_out_end(&out, '}');
    return json_out_print(&out, error);
}

static gboolean print(const Path *path, const double *at, gboolean json, GError **error)
{
    tdsp_point place = {0, 0};
    if (path->status != TDSP_OK) at = NULL;
    if (at && !position(path, *at, &place, error)) return FALSE;
    if (json) return print_json(path, at, &place, error);
    return at ? print_position(place, error) : print_text(path, error);
}

int cmd_path(const CliCommand *command, int argc, char **argv, GError **error)
{
    gboolean json = FALSE;
    g_autofree char *at_text = NULL, *within = NULL;
    g_auto(SceneEnds) ends = {0};
    const GOptionEntry entries[] = {
        {"at", 0, 0, G_OPTION_ARG_STRING, &at_text, "Print where the robot is at TIME", "TIME"},
        SCENE_SOLVER_WITHIN(&within),
        SCENE_ENDS_ENTRIES(&ends),
        G_OPTION_ENTRY_NULL,
    };
    g_autoptr(GArray) times = times_new();
    g_auto(FileIn) file = {0};
    g_auto(Path) path = {0};
    if (!cli_parse(command, entries, &json, &argc, &argv, error) || !cli_positional(command, argc, 2, 2, error) ||
        !times_add(times, argv[2], "departure", error) || (at_text && !times_add(times, at_text, "--at", error)) ||
        !scene_solver_parse_within(within, &path.within, error) || !file_in_load(argv[1], &file, error))
        return CLI_FAILED;
    path.departure = g_array_index(times, double, 0);
    path.ends = &ends;
    if (!scene_ends_fit(&ends, &file, error)) return CLI_FAILED;
    if (!(file.kind == FILE_TABLE ? from_table(&file, &path, error) : from_scene(&file, &path, error))) return CLI_FAILED;
    if (!print(&path, at_text ? &g_array_index(times, double, 1) : NULL, json, error)) return CLI_FAILED;
    return cli_answer(path.status == TDSP_OK);
}
