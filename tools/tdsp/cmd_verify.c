/* SPDX-License-Identifier: MIT */
/* tdsp verify: a table or a path against its scene. */
#include <math.h>

#include "commands.h"
#include "file_in.h"
#include "json_out.h"
#include "matrix_pair.h"
#include "numbers.h"
#include "scene_solver.h"
#include "verify_report.h"

#define MOST_DEEP 1000000

static gboolean print_json(const VerifyReport *report, GError **error)
{
    g_auto(JsonOut) out = json_out_new();
    json_out_begin(&out, '{');
    json_out_key(&out, "ok");
    json_out_boolean(&out, verify_report_ok(report));
    json_out_member_number(&out, "min_clearance", report->min_clearance);
    json_out_member_number(&out, "time", report->time);
    json_out_key(&out, "disc");
    if (report->disc == TDSP_NO_DISC)
        json_out_null(&out);
    else
        json_out_whole(&out, report->disc);
    json_out_key(&out, "problems");
    verify_report_json(report->problems, &out);
    json_out_key(&out, "checked");
    verify_report_json(report->checked, &out);
    json_out_end(&out, '}');
    return json_out_print(&out, error);
}

static gboolean print_text(const VerifyReport *report, GError **error)
{
    char clearance[NUMBER_ROOM], time[NUMBER_ROOM];
    g_autoptr(GString) text = g_string_new(verify_report_ok(report) ? "ok\n" : "NOT OK\n");
    for (guint i = 0; i < report->problems->len; i++)
        g_string_append_printf(text, "problem: %s\n", (const char *)g_ptr_array_index(report->problems, i));
    if (report->disc != TDSP_NO_DISC)
        g_string_append_printf(text, "least clearance: %s to disc %u at time %s\n",
                               number_format(clearance, report->min_clearance), report->disc, number_format(time, report->time));
    for (guint i = 0; i < report->checked->len; i++)
        g_string_append_printf(text, "checked: %s\n", (const char *)g_ptr_array_index(report->checked, i));
    return cli_print(text, error);
}

static gboolean check_path(const FileIn *file, const SceneSolver *solver, guint deep, VerifyReport *report, GError **error)
{
    g_auto(PathFile) path = {0};
    double speed = tdsp_scene_journey(solver->file.scene)->speed;
    if (!path_json_parse(cli_file_name(file->path), file->text, file->length, speed, &path, error)) return FALSE;
    if (!verify_report_path(report, solver->file.scene, &path, error)) return FALSE;
    return deep == 0 || verify_deep_path(report, solver, &path, error);
}

static gboolean check_table(const FileIn *file, const SceneSolver *solver, guint deep, VerifyReport *report, GError **error)
{
    if (!verify_report_table(report, solver->file.scene, &file->table, error)) return FALSE;
    return deep == 0 || verify_deep_table(report, solver, &file->table, deep, error);
}

static gboolean check_matrix(const FileIn *file, const SceneSolver *solver, guint deep, VerifyReport *report, GError **error)
{
    if (deep > 0) return cli_fail(error, CLI_USAGE, "--deep goes with a table or a path");
    return matrix_pair_verify(report, solver->file.scene, &file->matrix, error);
}

static gboolean parse_deep(const char *text, guint *deep, GError **error)
{
    guint64 number = 0;
    const char *wrong = text ? number_parse_whole(text, 0, MOST_DEEP, &number) : NULL;
    if (wrong) return cli_fail(error, CLI_USAGE, "--deep \"%s\": %s (0 to %d)", text, wrong, MOST_DEEP);
    *deep = (guint)number;
    return TRUE;
}

int cmd_verify(const CliCommand *command, int argc, char **argv, GError **error)
{
    gboolean json = FALSE;
    guint deep = 0;
    g_autofree char *deep_text = NULL;
    g_auto(SceneEnds) ends = {0};
    const GOptionEntry entries[] = {
        {"deep", 0, 0, G_OPTION_ARG_STRING, &deep_text, "Solve N departures again, forwards and backwards in time", "N"},
        SCENE_ENDS_ENTRIES(&ends),
        G_OPTION_ENTRY_NULL,
    };
    g_auto(SceneSolver) solver = {0};
    g_auto(FileIn) file = {0};
    g_auto(VerifyReport) report = verify_report_new();
    if (!cli_parse(command, entries, &json, &argc, &argv, error) || !cli_positional(command, argc, 2, 2, error) ||
        !parse_deep(deep_text, &deep, error) || !scene_solver_load_for(argv[1], &ends, TDSP_METHOD_AUTO, &solver, error) ||
        !file_in_load_any(argv[2], &file, error))
        return CLI_FAILED;
    gboolean done = file.kind == FILE_TABLE    ? check_table(&file, &solver, deep, &report, error)
                    : file.kind == FILE_MATRIX ? check_matrix(&file, &solver, deep, &report, error)
                                               : check_path(&file, &solver, deep, &report, error);
    if (!done || !(json ? print_json(&report, error) : print_text(&report, error))) return CLI_FAILED;
    return cli_answer(verify_report_ok(&report));
}
