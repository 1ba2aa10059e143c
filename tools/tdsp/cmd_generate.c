/* SPDX-License-Identifier: MIT */
/* tdsp generate: made-up scenes. */
#include "commands.h"
#include "file_out.h"
#include "generate.h"
#include "json_out.h"
#include "numbers.h"
#include "scene_description.h"

typedef struct Wanted {
    gboolean json;
    char *n, *seed, *growth, *output; /* as given; NULL: not given */
    const GenerateKind *kind;
    GenerateOptions options;
} Wanted;

static void wanted_clear(Wanted *wanted)
{
    g_free(wanted->n);
    g_free(wanted->seed);
    g_free(wanted->growth);
    g_free(wanted->output);
}
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC(Wanted, wanted_clear)

static gboolean parse_growth(Wanted *wanted, GError **error)
{
    wanted->options.growth = wanted->kind->growth;
    if (!wanted->growth) return TRUE;
    if (wanted->kind->growth < 0)
        return cli_fail(error, CLI_USAGE, "--growth: the construction %s sets its own growth", wanted->kind->name);
    return cli_option_number("--growth", wanted->growth, &wanted->options.growth, error);
}

static gboolean parse_wanted(Wanted *wanted, const char *kind, GError **error)
{
    wanted->kind = generate_kind(kind);
    if (!wanted->kind) {
        g_autofree char *names = generate_kinds();
        return cli_fail(error, CLI_USAGE, "no kind \"%s\"; there are %s", kind, names);
    }
    guint least = wanted->kind->least, most = wanted->kind->most;
    guint64 n = 100;
    const char *wrong = wanted->n ? number_parse_whole(wanted->n, least, most, &n) : NULL;
    if (wrong) return cli_fail(error, CLI_USAGE, "--n \"%s\": %s (%u to %u)", wanted->n, wrong, least, most);
    wanted->options.n = (guint)n;
    wanted->options.seed = 1;
    wrong = wanted->seed ? number_parse_whole(wanted->seed, 0, G_MAXUINT64, &wanted->options.seed) : NULL;
    if (wrong) return cli_fail(error, CLI_USAGE, "--seed \"%s\": %s", wanted->seed, wrong);
    return parse_growth(wanted, error);
}

/* As it is written down; takes the name over. */
static SceneDescription description_of(const Generated *scene, char *name)
{
    SceneDescription description = scene_description_new();
    g_free(description.name);
    description.name = name;
    description.journey = scene->journey;
    for (guint i = 0; i < scene->discs->len; i++) {
        const tdsp_disc *disc = &g_array_index(scene->discs, tdsp_disc, i);
        tdsp_growing_disc growing = {disc->center, disc->radius, {.kind = TDSP_GROWTH_RATE, .rate = disc->growth}};
        g_array_append_val(description.discs, growing);
    }
    return description;
}

static gboolean report(const Wanted *wanted, guint discs, GError **error)
{
    g_auto(JsonOut) out = json_out_new();
    if (!wanted->json) return TRUE;
    json_out_begin(&out, '{');
    json_out_member_string(&out, "file", wanted->output);
    json_out_member_string(&out, "kind", wanted->kind->name);
    json_out_member_whole(&out, "discs", discs);
    json_out_member_whole(&out, "seed", wanted->options.seed);
    json_out_end(&out, '}');
    return json_out_print(&out, error);
}

static gboolean generate(const Wanted *wanted, GError **error)
{
    static const char *const no_inputs[] = {NULL};
    g_auto(JsonOut) out = json_out_new();
    if (wanted->output && !file_out_check(wanted->output, no_inputs, error)) return FALSE;
    Generated scene = {.discs = g_array_new(FALSE, FALSE, sizeof(tdsp_disc))};
    wanted->kind->make(&wanted->options, &scene);
    guint discs = scene.discs->len;
    g_auto(SceneDescription) description =
        description_of(&scene, g_strdup_printf("%s-n%u-seed%" G_GUINT64_FORMAT, wanted->kind->name, discs, wanted->options.seed));
    g_array_unref(scene.discs);
    scene_description_write(&description, &out);
    if (!wanted->output) return json_out_print(&out, error);
    g_string_append_c(out.text, '\n');
    return file_out_write(wanted->output, out.text->str, out.text->len, error) && report(wanted, discs, error);
}

int cmd_generate(const CliCommand *command, int argc, char **argv, GError **error)
{
    g_auto(Wanted) wanted = {0};
    const GOptionEntry entries[] = {
        {"n", 'n', 0, G_OPTION_ARG_STRING, &wanted.n, "Number of discs (default 100; columns: a multiple of 3; nsquared: gaps, and discs of the chain)", "N"},
        {"seed", 0, 0, G_OPTION_ARG_STRING, &wanted.seed, "Seed of the random numbers (default 1)", "SEED"},
        {"growth", 0, 0, G_OPTION_ARG_STRING, &wanted.growth,
         "How many mean spacings a radius gains while the robot crosses the scene once; 0: nothing grows", "G"},
        {"output", 'o', 0, G_OPTION_ARG_FILENAME, &wanted.output, "Write to FILE, not to standard output", "FILE"},
        G_OPTION_ENTRY_NULL,
    };
    if (!cli_parse(command, entries, &wanted.json, &argc, &argv, error) || !cli_positional(command, argc, 1, 1, error) ||
        !parse_wanted(&wanted, argv[1], error))
        return CLI_FAILED;
    return generate(&wanted, error) ? CLI_DONE : CLI_FAILED;
}
