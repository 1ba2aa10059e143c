/* SPDX-License-Identifier: MIT */
/* The sampler's options on the command line. */
#include "build_asked.h"

#include <math.h>
#include <string.h>

#include "cli.h"
#include "numbers.h"
#include "words.h"

#define UNIT_BYTES 15 /* what a table holds of a unit's name */
#define MOST_THREADS 256

void build_asked_clear(BuildAsked *asked)
{
    char *texts[] = {asked->guarantee, asked->sampling, asked->epsilon, asked->delta, asked->horizon,
                     asked->max_rows,  asked->threads,  asked->output};
    for (gsize i = 0; i < G_N_ELEMENTS(texts); i++) g_free(texts[i]);
}

static gboolean parse_number(const char *option, const char *text, double *value, GError **error)
{
    const char *wrong = number_parse(text, value);
    return wrong ? cli_fail(error, CLI_USAGE, "%s \"%s\": %s", option, text, wrong) : TRUE;
}

static gboolean parse_bound(BuildAsked *asked, GError **error)
{
    tdsp_build_options *options = &asked->options;
    gboolean absolute = options->guarantee == TDSP_GUARANTEE_ABSOLUTE;
    if (absolute && asked->epsilon)
        return cli_fail(error, CLI_USAGE, "--epsilon bounds a ratio; --guarantee absolute takes --delta");
    if (!absolute && asked->delta) return cli_fail(error, CLI_USAGE, "--delta goes with --guarantee absolute only");
    if (absolute && !asked->delta) return cli_fail(error, CLI_USAGE, "--guarantee absolute needs --delta D");
    if (asked->delta) {
        if (!parse_number("--delta", asked->delta, &options->delta, error)) return FALSE;
        if (!(options->delta > 0)) return cli_fail(error, CLI_USAGE, "--delta \"%s\": must be greater than zero", asked->delta);
    }
    if (asked->epsilon) {
        if (!parse_number("--epsilon", asked->epsilon, &options->epsilon, error)) return FALSE;
        if (!(options->epsilon >= 1e-9 && options->epsilon <= 1))
            return cli_fail(error, CLI_USAGE, "--epsilon \"%s\": must be from 1e-9 to 1", asked->epsilon);
    }
    return TRUE;
}

static gboolean parse_rest(BuildAsked *asked, const char *file, GError **error)
{
    guint64 threads = MIN((guint64)g_get_num_processors(), MOST_THREADS);
    const char *wrong = asked->threads ? number_parse_whole(asked->threads, 1, MOST_THREADS, &threads) : NULL;
    if (wrong) return cli_fail(error, CLI_USAGE, "--threads \"%s\": %s (1 to %d)", asked->threads, wrong, MOST_THREADS);
    asked->threads_count = (guint)threads;
    if (!cli_option_number("--horizon", asked->horizon, &asked->options.horizon, error)) return FALSE;
    guint64 rows = TDSP_MAX_ROWS;
    wrong = asked->max_rows ? number_parse_whole(asked->max_rows, 1, TDSP_MAX_ROWS, &rows) : NULL;
    if (wrong) return cli_fail(error, CLI_USAGE, "--max-rows \"%s\": %s (1 to %u)", asked->max_rows, wrong, TDSP_MAX_ROWS);
    asked->options.max_rows = (guint32)rows;
    if (!asked->output) return cli_fail(error, CLI_USAGE, "-o %s is missing: where to write it", file);
    return TRUE;
}

gboolean build_asked_parse(BuildAsked *asked, const char *file, GError **error)
{
    guint32 guarantee, sampling;
    tdsp_build_options_init(&asked->options);
    if (!words_parse_guarantee("--guarantee", asked->guarantee, &guarantee, error) ||
        !words_parse_sampling("--sampling", asked->sampling, &sampling, error))
        return FALSE;
    asked->options.guarantee = (tdsp_guarantee)guarantee;
    asked->options.sampling = (tdsp_sampling)sampling;
    if (asked->exact) asked->options.oracle_share = 0;
    if (sampling == TDSP_SAMPLING_GEOMETRIC && guarantee != TDSP_GUARANTEE_ARRIVAL)
        return cli_fail(error, CLI_USAGE, "--sampling geometric gives the guarantee arrival only: add --guarantee arrival");
    return parse_bound(asked, error) && parse_rest(asked, file, error);
}

gboolean build_asked_world(const char *path, const SceneFile *scene, tdsp_build_world *world, GError **error)
{
    const tdsp_journey *journey = tdsp_scene_journey(scene->scene);
    if (strlen(scene->length_unit) > UNIT_BYTES || strlen(scene->time_unit) > UNIT_BYTES)
        return cli_fail(error, CLI_INPUT, "%s: units.%s: longer than the %d bytes a table holds", cli_file_name(path),
                        strlen(scene->length_unit) > UNIT_BYTES ? "length" : "time", UNIT_BYTES);
    *world = (tdsp_build_world){tdsp_scene_hash(scene->scene), journey->speed,     journey->source,
                                journey->destination,          scene->length_unit, scene->time_unit};
    return TRUE;
}

gboolean build_asked_fail(const BuildAsked *asked, const SceneFile *scene, tdsp_status status, GError **error)
{
    switch ((int)status) {
    case TDSP_NEEDS_HORIZON:
        return cli_fail(error, CLI_USAGE, "no disc ever ends the departures of this scene: say how far to go with --horizon H");
    case TDSP_TOO_MANY_ROWS:
        return cli_fail(error, CLI_USAGE, "the guarantee needs more than %u rows: ask for a weaker one%s", asked->options.max_rows,
                        isinf(asked->options.horizon) ? "" : ", or a nearer --horizon");
    case TDSP_NOT_SUPPORTED:
        if (asked->options.sampling == TDSP_SAMPLING_GEOMETRIC)
            return cli_fail(error, CLI_USAGE, "--sampling geometric needs a journey that takes time: source and destination are one");
        return cli_fail(error, CLI_USAGE, "%s: departures reach too many journeys away: end them with a nearer --horizon", scene->file);
    default: return scene_file_fail(scene, "build", status, error);
    }
}
