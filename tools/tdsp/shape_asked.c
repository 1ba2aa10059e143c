/* SPDX-License-Identifier: MIT */
/* Options and outcomes of the questions about the shape of A(t). */
#include "shape_asked.h"

#include <math.h>

#include "cli.h"
#include "numbers.h"

void shape_asked_clear(ShapeAsked *asked)
{
    g_free(asked->horizon);
    g_free(asked->fineness);
    scene_solver_clear(&asked->solver);
}

gboolean shape_asked_fineness(const ShapeAsked *asked, const char *option, double *value, GError **error)
{
    *value = 0;
    if (!asked->fineness) return TRUE;
    const char *wrong = number_parse_time(asked->fineness, value);
    if (!wrong && !(*value > 0)) wrong = "must be greater than 0";
    return wrong ? cli_fail(error, CLI_USAGE, "%s \"%s\": %s", option, asked->fineness, wrong) : TRUE;
}

static int show(void *ctx, double settled, double all)
{
    progress_show(ctx, settled, all);
    return 0;
}

gboolean shape_asked_begin(ShapeAsked *asked, const char *path, const char *what, GError **error)
{
    tdsp_shape_options defaults;
    tdsp_shape_options_init(&defaults);
    defaults.least = asked->options.least;
    defaults.resolution = asked->options.resolution;
    asked->options = defaults;
    if (!cli_option_number("--horizon", asked->horizon, &asked->options.until, error) || !scene_solver_load(path, &asked->solver, error)) return FALSE;
    asked->progress = progress_begin(what);
    asked->options.progress = show;
    asked->options.progress_ctx = &asked->progress;
    return TRUE;
}

gboolean shape_asked_done(ShapeAsked *asked, tdsp_status status, GError **error)
{
    progress_end(&asked->progress);
    if (tdsp_status_is_answer(status)) return TRUE;
    if (status == TDSP_NEEDS_HORIZON)
        return cli_fail(error, CLI_USAGE, "no disc ever ends the departures of this scene: say how far to go with --horizon H");
    if (status == TDSP_INVALID_ARGUMENT && asked->options.least > 0)
        return cli_fail(error, CLI_USAGE, "--least \"%s\": less than a thousand-millionth of the longest travel time", asked->fineness);
    return scene_solver_fail(&asked->solver, status, error);
}

void shape_json_gap(JsonOut *out, const tdsp_gap *gap)
{
    if (gap->first == TDSP_NO_DISC) {
        static const char *const names[] = {"first", "second", "time", "place"};
        for (gsize i = 0; i < G_N_ELEMENTS(names); i++) json_out_member_string(out, names[i], NULL);
        return;
    }
    json_out_member_whole(out, "first", gap->first);
    json_out_member_whole(out, "second", gap->second);
    json_out_member_number(out, "time", gap->time);
    json_out_member_point(out, "place", gap->place);
}

char *shape_gap_discs(const tdsp_gap *gap)
{
    if (gap->first == TDSP_NO_DISC) return g_strdup("unknown");
    return g_strdup_printf("%u and %u", gap->first, gap->second);
}
