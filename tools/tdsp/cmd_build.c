/* SPDX-License-Identifier: MIT */
/* tdsp build: sample the exact oracle of a scene into a table. */
#include <math.h>

#include "build_asked.h"
#include "commands.h"
#include "file_out.h"
#include "json_out.h"
#include "numbers.h"
#include "progress.h"
#include "scene_file.h"
#include "stopwatch.h"
#include "tdsp/build.h"
#include "words.h"
#include "workers.h"

typedef struct Wanted {
    gboolean json;
    BuildAsked asked;
    SceneEnds ends;
} Wanted;

static void wanted_clear(Wanted *wanted)
{
    build_asked_clear(&wanted->asked);
    scene_ends_clear(&wanted->ends);
}
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC(Wanted, wanted_clear)

typedef struct Built {
    tdsp_status status; /* TDSP_OK, or the answer that there is nothing to build */
    void *bytes;
    size_t length;
    tdsp_build_report report;
    double seconds;
} Built;

static void built_clear(Built *built)
{
    tdsp_bytes_free(NULL, built->bytes, built->length);
}
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC(Built, built_clear)

static int show_progress(void *progress, double settled, double all)
{
    progress_show(progress, settled, all);
    return 0;
}

static gboolean build(Wanted *wanted, const SceneFile *scene, Built *built, GError **error)
{
    g_autoptr(Workers) workers = workers_new(scene->scene, wanted->asked.threads_count, error);
    if (!workers) return FALSE;
    Progress progress = progress_begin("build");
    Stopwatch watch = stopwatch_start();
    tdsp_build_options *options = &wanted->asked.options;
    options->progress = show_progress;
    options->progress_ctx = &progress;
    options->run_tasks = workers_run;
    options->run_tasks_ctx = workers;
    options->workers = workers_oracles(workers);
    options->worker_count = workers_count(workers);
    built->status = tdsp_build(workers_oracles(workers), options, NULL, &built->bytes, &built->length, &built->report);
    built->seconds = stopwatch_seconds(watch);
    progress_end(&progress);
    return tdsp_status_is_answer(built->status) ? TRUE : build_asked_fail(&wanted->asked, scene, built->status, error);
}

static gboolean print_json(const Wanted *wanted, const Built *built, GError **error)
{
    const tdsp_build_options *options = &wanted->asked.options;
    gboolean absolute = options->guarantee == TDSP_GUARANTEE_ABSOLUTE, done = built->status == TDSP_OK;
    g_auto(JsonOut) out = json_out_new();
    json_out_begin(&out, '{');
    json_out_member_whole(&out, "rows", built->report.rows);
    json_out_member_whole(&out, "bytes", built->report.bytes);
    json_out_member_whole(&out, "forward_calls", built->report.forward_calls);
    json_out_member_whole(&out, "reverse_calls", built->report.reverse_calls);
    json_out_member_number(&out, "oracle_delta", built->report.oracle_delta);
    json_out_member_whole(&out, "rough_calls", built->report.rough_calls);
    json_out_member_number(&out, "seconds", built->seconds);
    json_out_member_number(&out, "last_departure", done ? built->report.last_departure : INFINITY);
    json_out_member_string(&out, "last_reason", tdsp_status_name(done ? built->report.last_reason : built->status));
    json_out_member_string(&out, "guarantee", words_guarantee(options->guarantee));
    json_out_member_number(&out, "epsilon", absolute ? INFINITY : options->epsilon);
    json_out_member_number(&out, "delta", absolute ? options->delta : INFINITY);
    json_out_member_string(&out, "sampling", words_sampling(options->sampling));
    json_out_member_string(&out, "table", done ? wanted->asked.output : NULL);
    json_out_end(&out, '}');
    return json_out_print(&out, error);
}

static gboolean print_text(const Wanted *wanted, const Built *built, GError **error)
{
    const tdsp_build_options *options = &wanted->asked.options;
    const tdsp_build_report *report = &built->report;
    gboolean absolute = options->guarantee == TDSP_GUARANTEE_ABSOLUTE;
    char bound[NUMBER_ROOM], last[NUMBER_ROOM], seconds[NUMBER_ROOM];
    g_autoptr(GString) text = g_string_new(NULL);
    if (built->status != TDSP_OK) return TRUE;
    g_string_printf(text, "%s: %" G_GUINT64_FORMAT " rows, %" G_GUINT64_FORMAT " bytes\n", wanted->asked.output, report->rows,
                    report->bytes);
    g_string_append_printf(text, "guarantee      %s, %s %s, %s sampling\n", words_guarantee(options->guarantee),
                           absolute ? "delta" : "epsilon", number_format(bound, absolute ? options->delta : options->epsilon),
                           words_sampling(options->sampling));
    g_string_append_printf(text, "last departure %s, then %s\n", number_format(last, report->last_departure),
                           tdsp_status_name(report->last_reason));
    g_string_append_printf(text, "oracle calls   %" G_GUINT64_FORMAT " forward, %" G_GUINT64_FORMAT " reverse\n",
                           report->forward_calls, report->reverse_calls);
    if (report->oracle_delta > 0)
        g_string_append_printf(text, "               %" G_GUINT64_FORMAT " of them within %s of the best, the others exact\n",
                               report->rough_calls, number_format(bound, report->oracle_delta));
    g_string_append_printf(text, "seconds        %s\n", number_brief(seconds, built->seconds, 4));
    return cli_print(text, error);
}

static int build_to_file(Wanted *wanted, const char *path, GError **error)
{
    const char *const inputs[] = {path, NULL};
    g_auto(SceneFile) scene = {0};
    g_auto(Built) built = {0};
    if (!file_out_check(wanted->asked.output, inputs, error) || !scene_file_load_between(path, &wanted->ends, &scene, error) ||
        !build_asked_world(path, &scene, &wanted->asked.options.world, error) || !build(wanted, &scene, &built, error))
        return CLI_FAILED;
    if (built.status == TDSP_OK && !file_out_write(wanted->asked.output, built.bytes, built.length, error)) return CLI_FAILED;
    if (!(wanted->json ? print_json(wanted, &built, error) : print_text(wanted, &built, error))) return CLI_FAILED;
    if (built.status != TDSP_OK) {
        g_autofree char *reason = cli_reason(built.status);
        cli_fail(error, CLI_NO, "nothing to build: no path at departure 0: %s", reason);
        return CLI_FAILED;
    }
    return CLI_DONE;
}

int cmd_build(const CliCommand *command, int argc, char **argv, GError **error)
{
    g_auto(Wanted) wanted = {0};
    const GOptionEntry entries[] = {
        BUILD_ASKED_ENTRIES(&wanted.asked, "TABLE", "table"),
        SCENE_ENDS_ENTRIES(&wanted.ends),
        G_OPTION_ENTRY_NULL,
    };
    if (!cli_parse(command, entries, &wanted.json, &argc, &argv, error) || !cli_positional(command, argc, 1, 1, error) ||
        !build_asked_parse(&wanted.asked, "TABLE", error))
        return CLI_FAILED;
    return build_to_file(&wanted, argv[1], error);
}
