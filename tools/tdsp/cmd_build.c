/* tdsp build: sample the exact oracle of a scene into a table. */
#include <math.h>
#include <string.h>

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

#define UNIT_BYTES 15 /* what a table holds of a unit's name */
#define MOST_THREADS 256

typedef struct Wanted {
    gboolean json, exact;
    char *guarantee, *sampling, *epsilon, *delta, *horizon, *threads, *output; /* as given; NULL: not given */
    guint threads_count;
    tdsp_build_options options;
} Wanted;

static void wanted_clear(Wanted *wanted)
{
    char *texts[] = {wanted->guarantee, wanted->sampling, wanted->epsilon, wanted->delta,
                     wanted->horizon,   wanted->threads,  wanted->output};
    for (gsize i = 0; i < G_N_ELEMENTS(texts); i++) g_free(texts[i]);
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

static gboolean parse_number(const char *option, const char *text, double *value, GError **error)
{
    const char *wrong = number_parse(text, value);
    return wrong ? cli_fail(error, CLI_USAGE, "%s \"%s\": %s", option, text, wrong) : TRUE;
}

static gboolean parse_bound(Wanted *wanted, GError **error)
{
    tdsp_build_options *options = &wanted->options;
    gboolean absolute = options->guarantee == TDSP_GUARANTEE_ABSOLUTE;
    if (absolute && wanted->epsilon)
        return cli_fail(error, CLI_USAGE, "--epsilon bounds a ratio; --guarantee absolute takes --delta");
    if (!absolute && wanted->delta) return cli_fail(error, CLI_USAGE, "--delta goes with --guarantee absolute only");
    if (absolute && !wanted->delta) return cli_fail(error, CLI_USAGE, "--guarantee absolute needs --delta D");
    if (wanted->delta) {
        if (!parse_number("--delta", wanted->delta, &options->delta, error)) return FALSE;
        if (!(options->delta > 0)) return cli_fail(error, CLI_USAGE, "--delta \"%s\": must be greater than zero", wanted->delta);
    }
    if (wanted->epsilon) {
        if (!parse_number("--epsilon", wanted->epsilon, &options->epsilon, error)) return FALSE;
        if (!(options->epsilon >= 1e-9 && options->epsilon <= 1))
            return cli_fail(error, CLI_USAGE, "--epsilon \"%s\": must be from 1e-9 to 1", wanted->epsilon);
    }
    return TRUE;
}

static gboolean parse_rest(Wanted *wanted, GError **error)
{
    guint64 threads = MIN((guint64)g_get_num_processors(), MOST_THREADS);
    const char *wrong = wanted->threads ? number_parse_whole(wanted->threads, 1, MOST_THREADS, &threads) : NULL;
    if (wrong) return cli_fail(error, CLI_USAGE, "--threads \"%s\": %s (1 to %d)", wanted->threads, wrong, MOST_THREADS);
    wanted->threads_count = (guint)threads;
    wrong = wanted->horizon ? number_parse_time(wanted->horizon, &wanted->options.horizon) : NULL;
    if (wrong) return cli_fail(error, CLI_USAGE, "--horizon \"%s\": %s", wanted->horizon, wrong);
    if (!wanted->output) return cli_fail(error, CLI_USAGE, "-o TABLE is missing: where to write the table");
    return TRUE;
}

static gboolean parse_wanted(Wanted *wanted, GError **error)
{
    guint32 guarantee, sampling;
    tdsp_build_options_init(&wanted->options);
    if (!words_parse_guarantee("--guarantee", wanted->guarantee, &guarantee, error) ||
        !words_parse_sampling("--sampling", wanted->sampling, &sampling, error))
        return FALSE;
    wanted->options.guarantee = (tdsp_guarantee)guarantee;
    wanted->options.sampling = (tdsp_sampling)sampling;
    if (wanted->exact) wanted->options.oracle_share = 0;
    if (sampling == TDSP_SAMPLING_GEOMETRIC && guarantee != TDSP_GUARANTEE_ARRIVAL)
        return cli_fail(error, CLI_USAGE, "--sampling geometric gives the guarantee arrival only: add --guarantee arrival");
    return parse_bound(wanted, error) && parse_rest(wanted, error);
}

static gboolean describe_world(const char *path, const SceneFile *scene, tdsp_build_world *world, GError **error)
{
    const tdsp_journey *journey = tdsp_scene_journey(scene->scene);
    if (strlen(scene->length_unit) > UNIT_BYTES || strlen(scene->time_unit) > UNIT_BYTES)
        return cli_fail(error, CLI_INPUT, "%s: units.%s: longer than the %d bytes a table holds", cli_file_name(path),
                        strlen(scene->length_unit) > UNIT_BYTES ? "length" : "time", UNIT_BYTES);
    *world = (tdsp_build_world){tdsp_scene_hash(scene->scene), journey->speed,     journey->source,
                                journey->destination,          scene->length_unit, scene->time_unit};
    return TRUE;
}

static int show_progress(void *progress, double settled, double all)
{
    progress_show(progress, settled, all);
    return 0;
}

static gboolean fail_build(const Wanted *wanted, const SceneFile *scene, tdsp_status status, GError **error)
{
    switch ((int)status) {
    case TDSP_NEEDS_HORIZON:
        return cli_fail(error, CLI_USAGE, "no disc ever ends the departures of this scene: say how far to go with --horizon H");
    case TDSP_TOO_MANY_ROWS:
        return cli_fail(error, CLI_USAGE, "the guarantee needs more than %u rows: ask for a weaker one%s", TDSP_MAX_ROWS,
                        isinf(wanted->options.horizon) ? "" : ", or a nearer --horizon");
    case TDSP_NOT_SUPPORTED:
        return cli_fail(error, CLI_USAGE, "--sampling geometric needs a journey that takes time: source and destination are one");
    default: return scene_file_fail(scene, "build", status, error);
    }
}

static gboolean build(Wanted *wanted, const SceneFile *scene, Built *built, GError **error)
{
    g_autoptr(Workers) workers = workers_new(scene->scene, wanted->threads_count, error);
    if (!workers) return FALSE;
    Progress progress = progress_begin("build");
    Stopwatch watch = stopwatch_start();
    tdsp_build_options *options = &wanted->options;
    options->progress = show_progress;
    options->progress_ctx = &progress;
    options->run_tasks = workers_run;
    options->run_tasks_ctx = workers;
    options->workers = workers_oracles(workers);
    options->worker_count = workers_count(workers);
    built->status = tdsp_build(workers_oracles(workers), options, NULL, &built->bytes, &built->length, &built->report);
    built->seconds = stopwatch_seconds(watch);
    progress_end(&progress);
    return tdsp_status_is_answer(built->status) ? TRUE : fail_build(wanted, scene, built->status, error);
}

static gboolean print_json(const Wanted *wanted, const Built *built, GError **error)
{
    const tdsp_build_options *options = &wanted->options;
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
    json_out_member_string(&out, "table", done ? wanted->output : NULL);
    json_out_end(&out, '}');
    return json_out_print(&out, error);
}

static gboolean print_text(const Wanted *wanted, const Built *built, GError **error)
{
    const tdsp_build_options *options = &wanted->options;
    const tdsp_build_report *report = &built->report;
    gboolean absolute = options->guarantee == TDSP_GUARANTEE_ABSOLUTE;
    char bound[NUMBER_ROOM], last[NUMBER_ROOM], seconds[NUMBER_ROOM];
    g_autoptr(GString) text = g_string_new(NULL);
    if (built->status != TDSP_OK) return TRUE;
    g_string_printf(text, "%s: %" G_GUINT64_FORMAT " rows, %" G_GUINT64_FORMAT " bytes\n", wanted->output, report->rows,
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
    if (!file_out_check(wanted->output, inputs, error) || !scene_file_load(path, &scene, error) ||
        !describe_world(path, &scene, &wanted->options.world, error) || !build(wanted, &scene, &built, error))
        return CLI_FAILED;
    if (built.status == TDSP_OK && !file_out_write(wanted->output, built.bytes, built.length, error)) return CLI_FAILED;
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
        {"output", 'o', 0, G_OPTION_ARG_FILENAME, &wanted.output, "Write the table to TABLE", "TABLE"},
        {"guarantee", 0, 0, G_OPTION_ARG_STRING, &wanted.guarantee, "travel (default), arrival or absolute", "GUARANTEE"},
        {"epsilon", 0, 0, G_OPTION_ARG_STRING, &wanted.epsilon,
         "Travel and arrival: bound of the ratio, 1e-9 to 1 (default 0.01)", "E"},
        {"delta", 0, 0, G_OPTION_ARG_STRING, &wanted.delta, "Absolute: bound of the difference, in the scene's unit of time",
         "D"},
        {"sampling", 0, 0, G_OPTION_ARG_STRING, &wanted.sampling, "adaptive (default), or geometric (guarantee arrival)",
         "SAMPLING"},
        {"horizon", 0, 0, G_OPTION_ARG_STRING, &wanted.horizon, "Latest departure; needed where no disc ever ends them", "H"},
        {"exact", 0, 0, G_OPTION_ARG_NONE, &wanted.exact,
         "Ask for exact arrivals only, also where nearly the best would do and cost far less", NULL},
        {"threads", 0, 0, G_OPTION_ARG_STRING, &wanted.threads, "Threads (default: one a processor); never changes the table",
         "N"},
        G_OPTION_ENTRY_NULL,
    };
    if (!cli_parse(command, entries, &wanted.json, &argc, &argv, error) || !cli_positional(command, argc, 1, 1, error) ||
        !parse_wanted(&wanted, error))
        return CLI_FAILED;
    return build_to_file(&wanted, argv[1], error);
}
