/* SPDX-License-Identifier: MIT */
/* tdsp matrix: the tables between lists of sources and destinations, in one file. */
#include <math.h>

#include "build_asked.h"
#include "commands.h"
#include "ends_file.h"
#include "file_out.h"
#include "json_out.h"
#include "numbers.h"
#include "progress.h"
#include "stopwatch.h"
#include "words.h"
#include "workers.h"

typedef struct Wanted {
    gboolean json;
    char *sources, *destinations; /* file names */
    BuildAsked asked;
} Wanted;

static void wanted_clear(Wanted *wanted)
{
    g_free(wanted->sources);
    g_free(wanted->destinations);
    build_asked_clear(&wanted->asked);
}
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC(Wanted, wanted_clear)

typedef struct Built {
    void *bytes;
    size_t length;
    tdsp_matrix_report report;
    double seconds;
} Built;

static void built_clear(Built *built)
{
    tdsp_bytes_free(NULL, built->bytes, built->length);
}
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC(Built, built_clear)

/* What the oracles of the pairs come from. */
typedef struct Pairs {
    const tdsp_scene *scene;
    const Workers *workers;
    const tdsp_matrix_end *sources, *destinations;
} Pairs;

static tdsp_status pair_oracle(void *ctx, size_t i, size_t j, size_t worker, tdsp_oracle *oracle, uint64_t *scene_hash)
{
    const Pairs *pairs = ctx;
    const tdsp_ends ends = {pairs->sources[i].place, pairs->destinations[j].place};
    tdsp_solver *solver = workers_solver(pairs->workers, worker);
    tdsp_status status = tdsp_solver_set_ends(solver, &ends);
    *scene_hash = tdsp_scene_hash_for(pairs->scene, &ends);
    return status == TDSP_OK ? tdsp_solver_oracle(solver, oracle) : status;
}

static int show_progress(void *progress, double done, double all)
{
    progress_show(progress, done, all);
    return 0;
}

static gboolean fail_pair(const Wanted *wanted, const SceneFile *scene, const Built *built, tdsp_status status, GError **error)
{
    g_autoptr(GError) why = NULL;
    if (status == TDSP_NO_MEMORY) return cli_fail_status(error, "matrix", status);
    build_asked_fail(&wanted->asked, scene, status, &why);
    return cli_fail(error, why->code, "source %" G_GSIZE_FORMAT " to destination %" G_GSIZE_FORMAT ": %s", built->report.source,
                    built->report.destination, why->message);
}

static gboolean build(Wanted *wanted, const SceneFile *scene, const EndsFile *sources, const EndsFile *destinations, Built *built,
                      GError **error)
{
    g_autoptr(Workers) workers = workers_new(scene->scene, wanted->asked.threads_count, error);
    if (!workers) return FALSE;
    Progress progress = progress_begin("matrix");
    Stopwatch watch = stopwatch_start();
    tdsp_build_options *options = &wanted->asked.options;
    options->progress = show_progress;
    options->progress_ctx = &progress;
    options->run_tasks = workers_run;
    options->run_tasks_ctx = workers;
    options->worker_count = workers_count(workers);
    const tdsp_matrix_end *from = (const tdsp_matrix_end *)sources->ends->data,
                          *to = (const tdsp_matrix_end *)destinations->ends->data;
    Pairs pairs = {scene->scene, workers, from, to};
    const tdsp_matrix_plan plan = {from, sources->ends->len, to, destinations->ends->len, pair_oracle, &pairs};
    tdsp_status status = tdsp_matrix_build(&plan, options, NULL, &built->bytes, &built->length, &built->report);
    built->seconds = stopwatch_seconds(watch);
    progress_end(&progress);
    return status == TDSP_OK ? TRUE : fail_pair(wanted, scene, built, status, error);
}

static gboolean print_json(const Wanted *wanted, const Built *built, GError **error)
{
    const tdsp_build_options *options = &wanted->asked.options;
    const tdsp_matrix_report *report = &built->report;
    gboolean absolute = options->guarantee == TDSP_GUARANTEE_ABSOLUTE;
    g_auto(JsonOut) out = json_out_new();
    json_out_begin(&out, '{');
    json_out_member_whole(&out, "sources", report->source);
    json_out_member_whole(&out, "destinations", report->destination);
    json_out_member_whole(&out, "tables", report->tables);
    json_out_member_whole(&out, "rows", report->rows);
    json_out_member_whole(&out, "bytes", report->bytes);
    json_out_member_whole(&out, "forward_calls", report->forward_calls);
    json_out_member_whole(&out, "reverse_calls", report->reverse_calls);
    json_out_member_number(&out, "seconds", built->seconds);
    json_out_member_string(&out, "guarantee", words_guarantee(options->guarantee));
    json_out_member_number(&out, "epsilon", absolute ? INFINITY : options->epsilon);
    json_out_member_number(&out, "delta", absolute ? options->delta : INFINITY);
    json_out_member_string(&out, "sampling", words_sampling(options->sampling));
    json_out_member_string(&out, "matrix", report->tables > 0 ? wanted->asked.output : NULL);
    json_out_end(&out, '}');
    return json_out_print(&out, error);
}

static gboolean print_text(const Wanted *wanted, const Built *built, GError **error)
{
    const tdsp_matrix_report *report = &built->report;
    char seconds[NUMBER_ROOM];
    g_autoptr(GString) text = g_string_new(NULL);
    if (report->tables == 0) return TRUE;
    g_string_printf(text, "%s: %" G_GUINT64_FORMAT " tables, %" G_GUINT64_FORMAT " rows, %" G_GUINT64_FORMAT " bytes\n", wanted->asked.output,
                    report->tables, report->rows, report->bytes);
    g_string_append_printf(text, "pairs          %" G_GSIZE_FORMAT " sources to %" G_GSIZE_FORMAT " destinations, %" G_GUINT64_FORMAT " without a way\n",
                           report->source, report->destination, (guint64)report->source * report->destination - report->tables);
    g_string_append_printf(text, "oracle calls   %" G_GUINT64_FORMAT " forward, %" G_GUINT64_FORMAT " reverse\n", report->forward_calls,
                           report->reverse_calls);
    g_string_append_printf(text, "seconds        %s\n", number_brief(seconds, built->seconds, 4));
    return cli_print(text, error);
}

static int matrix_to_file(Wanted *wanted, const char *path, GError **error)
{
    const char *const inputs[] = {path, wanted->sources, wanted->destinations, NULL};
    g_auto(SceneFile) scene = {0};
    g_auto(EndsFile) sources = {0};
    g_auto(EndsFile) destinations = {0};
    g_auto(Built) built = {0};
    if (!file_out_check(wanted->asked.output, inputs, error) || !scene_file_load(path, &scene, error) ||
        !build_asked_world(path, &scene, &wanted->asked.options.world, error) || !ends_file_load(wanted->sources, &sources, error) ||
        !ends_file_load(wanted->destinations, &destinations, error) || !build(wanted, &scene, &sources, &destinations, &built, error))
        return CLI_FAILED;
    gboolean any = built.report.tables > 0;
    if (any && !file_out_write(wanted->asked.output, built.bytes, built.length, error)) return CLI_FAILED;
    if (!(wanted->json ? print_json(wanted, &built, error) : print_text(wanted, &built, error))) return CLI_FAILED;
    if (any) return CLI_DONE;
    cli_fail(error, CLI_NO, "nothing to build: no pair has a path at departure 0");
    return CLI_FAILED;
}

int cmd_matrix(const CliCommand *command, int argc, char **argv, GError **error)
{
    g_auto(Wanted) wanted = {0};
    const GOptionEntry entries[] = {
        {"sources", 0, 0, G_OPTION_ARG_FILENAME, &wanted.sources, "Places to leave from: x,y and a name if wanted, one a line", "FILE"},
        {"destinations", 0, 0, G_OPTION_ARG_FILENAME, &wanted.destinations, "Places to go to, likewise", "FILE"},
        BUILD_ASKED_ENTRIES(&wanted.asked, "MATRIX", "matrix"),
        G_OPTION_ENTRY_NULL,
    };
    if (!cli_parse(command, entries, &wanted.json, &argc, &argv, error) || !cli_positional(command, argc, 1, 1, error) ||
        !build_asked_parse(&wanted.asked, "MATRIX", error))
        return CLI_FAILED;
    if (!wanted.sources || !wanted.destinations) {
        cli_fail(error, CLI_USAGE, "--%s FILE is missing: the places", wanted.sources ? "destinations" : "sources");
        return CLI_FAILED;
    }
    return matrix_to_file(&wanted, argv[1], error);
}
