/* SPDX-License-Identifier: MIT */
/* Scene files, read and prepared. */
#include "scene_file.h"

#include <string.h>

#include "cli.h"
#include "file_in.h"
#include "numbers.h"
#include "scene_description.h"
#include "stopwatch.h"

void scene_ends_clear(SceneEnds *ends)
{
    g_clear_pointer(&ends->from, g_free);
    g_clear_pointer(&ends->to, g_free);
}

gboolean scene_ends_fit(const SceneEnds *ends, const FileIn *file, GError **error)
{
    if (file->kind == FILE_JSON || (!ends->from && !ends->to)) return TRUE;
    return cli_fail(error, CLI_USAGE, "--from and --to go with a scene; %s is a table", cli_file_name(file->path));
}

static gboolean replace_ends(const SceneEnds *ends, tdsp_journey *journey, GError **error)
{
    if (!ends) return TRUE;
    if (!cli_option_point("--from", ends->from, "X,Y", &journey->source, error) || !cli_option_point("--to", ends->to, "X,Y", &journey->destination, error))
        return FALSE;
    const char *wrong = tdsp_journey_check(journey);
    return wrong ? cli_fail(error, CLI_USAGE, "--from, --to: %s", wrong) : TRUE;
}

static gboolean prepare(const SceneDescription *scene, SceneFile *out, GError **error)
{
    Stopwatch watch = stopwatch_start();
    tdsp_status status = tdsp_scene_create_growing(&scene->journey, (const tdsp_growing_disc *)scene->discs->data,
                                                   scene->discs->len, NULL, &out->scene);
    out->prepare_seconds = stopwatch_seconds(watch);
    return status == TDSP_OK ? TRUE : cli_fail_status(error, out->file, status);
}

gboolean scene_file_parse_between(const char *file, const char *text, gsize length, const SceneEnds *ends, SceneFile *scene, GError **error)
{
    g_auto(SceneDescription) described = {0};
    if (!scene_description_parse(file, text, length, &described, error)) return FALSE;
    SceneFile out = {.file = g_strdup(file)};
    if (!replace_ends(ends, &described.journey, error) || !prepare(&described, &out, error)) {
        scene_file_clear(&out);
        return FALSE;
    }
    out.name = g_steal_pointer(&described.name);
    out.length_unit = g_steal_pointer(&described.length_unit);
    out.time_unit = g_steal_pointer(&described.time_unit);
    *scene = out;
    return TRUE;
}

gboolean scene_file_parse(const char *file, const char *text, gsize length, SceneFile *scene, GError **error)
{
    return scene_file_parse_between(file, text, length, NULL, scene, error);
}

gboolean scene_file_load(const char *path, SceneFile *scene, GError **error)
{
    return scene_file_load_between(path, NULL, scene, error);
}

gboolean scene_file_load_between(const char *path, const SceneEnds *ends, SceneFile *scene, GError **error)
{
    g_auto(FileIn) file = {0};
    if (!file_in_load(path, &file, error)) return FALSE;
    if (file.kind == FILE_TABLE) return cli_fail(error, CLI_INPUT, "%s: a table, where a scene is needed", cli_file_name(path));
    return scene_file_parse_between(cli_file_name(path), file.text, file.length, ends, scene, error);
}

gboolean scene_file_fail(const SceneFile *scene, const char *what, tdsp_status status, GError **error)
{
    uint32_t disc;
    double until = tdsp_scene_valid_until(scene->scene, &disc);
    char number[NUMBER_ROOM];
    if (status != TDSP_SHRINKS || disc == TDSP_NO_DISC) return cli_fail_status(error, what, status);
    return cli_fail(error, CLI_INPUT, "%s: discs[%u].growth: the radius shrinks after t = %s, and this question reaches beyond",
                    scene->file, disc, number_format(number, until));
}

void scene_file_clear(SceneFile *scene)
{
    g_clear_pointer(&scene->file, g_free);
    g_clear_pointer(&scene->name, g_free);
    g_clear_pointer(&scene->length_unit, g_free);
    g_clear_pointer(&scene->time_unit, g_free);
    g_clear_pointer(&scene->scene, tdsp_scene_free);
}
