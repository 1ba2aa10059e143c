/* SPDX-License-Identifier: MIT */
/*
 * The reader of scene files (docs/cli.md). Everything is checked before the library sees it, so that a mistake is answered with
 * the place where it stands; the library's own checks stay the last word.
 */
#include "scene_file.h"

#include <string.h>

#include "cli.h"
#include "file_in.h"
#include "growth_json.h"
#include "json_read.h"
#include "numbers.h"
#include "stopwatch.h"

typedef struct Reading {
    GHashTable *warned; /* kinds of unknown keys that were warned of */
    SceneFile out;
    tdsp_journey journey;
    GArray *discs;   /* of tdsp_growing_disc */
    GPtrArray *kept; /* arrays of numbers that the discs point to */
} Reading;

static gboolean read_not_negative(const JsonValue *object, const char *name, double *number, GError **error)
{
    JsonValue member;
    if (!json_read_member(object, name, &member, error) || !json_read_number(&member, number, error)) return FALSE;
    return *number >= 0 ? TRUE : json_read_fail(&member.place, error, "must not be negative");
}

static gboolean read_robot(const JsonValue *root, Reading *reading, GError **error)
{
    static const char *const known[] = {"speed", "radius", NULL};
    JsonValue robot, speed, radius;
    if (!json_read_member(root, "robot", &robot, error) || !json_read_object(&robot, error)) return FALSE;
    if (!json_read_member(&robot, "speed", &speed, error) || !json_read_number(&speed, &reading->journey.speed, error))
        return FALSE;
    if (!(reading->journey.speed > 0)) return json_read_fail(&speed.place, error, "must be greater than zero");
    if (json_read_optional(&robot, "radius", &radius) && !read_not_negative(&robot, "radius", &reading->journey.radius, error))
        return FALSE;
    json_read_warn_unknown(&robot, known, reading->warned);
    return TRUE;
}

static gboolean read_disc(const JsonValue *value, Reading *reading, GError **error)
{
    static const char *const known[] = {"center", "radius", "growth", NULL};
    tdsp_disc place = {{0, 0}, 0, 0};
    JsonValue growth;
    if (!json_read_object(value, error) || !json_read_member_point(value, "center", &place.center, error) ||
        !read_not_negative(value, "radius", &place.radius, error) || !json_read_member(value, "growth", &growth, error))
        return FALSE;
    const char *wrong = tdsp_disc_check(&place);
    if (wrong) return json_read_fail(&value->place, error, "%s", wrong);
    tdsp_growing_disc disc = {.center = place.center, .radius = place.radius};
    if (!growth_json_read(&growth, &disc, reading->kept, reading->warned, error)) return FALSE;
    json_read_warn_unknown(value, known, reading->warned);
    g_array_append_val(reading->discs, disc);
    return TRUE;
}

static gboolean read_discs(const JsonValue *root, Reading *reading, GError **error)
{
    JsonValue discs;
    guint length;
    if (!json_read_member(root, "discs", &discs, error) || !json_read_array(&discs, &length, error)) return FALSE;
    for (guint i = 0; i < length; i++) {
        JsonValue disc = json_read_item(&discs, i);
        if (!read_disc(&disc, reading, error)) return FALSE;
    }
    return TRUE;
}

/* An optional string; "" where it is missing. */
static gboolean read_text(const JsonValue *object, const char *name, char **text, GError **error)
{
    JsonValue member;
    const char *string = "";
    if (json_read_optional(object, name, &member) && !json_read_string(&member, &string, error)) return FALSE;
    *text = g_strdup(string);
    return TRUE;
}

static gboolean read_units(const JsonValue *root, Reading *reading, GError **error)
{
    static const char *const known[] = {"length", "time", NULL};
    JsonValue units;
    if (!json_read_optional(root, "units", &units)) {
        reading->out.length_unit = g_strdup("");
        reading->out.time_unit = g_strdup("");
        return TRUE;
    }
    if (!json_read_object(&units, error) || !read_text(&units, "length", &reading->out.length_unit, error) ||
        !read_text(&units, "time", &reading->out.time_unit, error))
        return FALSE;
    json_read_warn_unknown(&units, known, reading->warned);
    return TRUE;
}

static gboolean read_root(const JsonValue *root, Reading *reading, GError **error)
{
    static const char *const known[] = {"name", "units", "robot", "source", "destination", "discs", NULL};
    if (!json_read_object(root, error) || !read_text(root, "name", &reading->out.name, error) ||
        !read_units(root, reading, error) || !read_robot(root, reading, error) ||
        !json_read_member_point(root, "source", &reading->journey.source, error) ||
        !json_read_member_point(root, "destination", &reading->journey.destination, error) || !read_discs(root, reading, error))
        return FALSE;
    json_read_warn_unknown(root, known, reading->warned);
    const char *wrong = tdsp_journey_check(&reading->journey);
    return wrong ? json_read_fail(&root->place, error, "%s", wrong) : TRUE;
}

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

/* "X,Y" */
static gboolean parse_end(const char *option, const char *text, tdsp_point *place, GError **error)
{
    g_auto(GStrv) parts = text ? g_strsplit(text, ",", 0) : NULL;
    if (!parts) return TRUE;
    const char *wrong = g_strv_length(parts) == 2 ? number_parse(g_strstrip(parts[0]), &place->x) : "must be two numbers, X,Y";
    if (!wrong) wrong = number_parse(g_strstrip(parts[1]), &place->y);
    return wrong ? cli_fail(error, CLI_USAGE, "%s \"%s\": %s", option, text, wrong) : TRUE;
}

static gboolean replace_ends(const SceneEnds *ends, tdsp_journey *journey, GError **error)
{
    if (!ends) return TRUE;
    if (!parse_end("--from", ends->from, &journey->source, error) || !parse_end("--to", ends->to, &journey->destination, error)) return FALSE;
    const char *wrong = tdsp_journey_check(journey);
    return wrong ? cli_fail(error, CLI_USAGE, "--from, --to: %s", wrong) : TRUE;
}

static gboolean prepare(const char *file, Reading *reading, GError **error)
{
    Stopwatch watch = stopwatch_start();
    tdsp_status status = tdsp_scene_create_growing(&reading->journey, (const tdsp_growing_disc *)(void *)reading->discs->data,
                                                   reading->discs->len, NULL, &reading->out.scene);
    reading->out.prepare_seconds = stopwatch_seconds(watch);
    return status == TDSP_OK ? TRUE : cli_fail_status(error, file, status);
}

gboolean scene_file_parse_between(const char *file, const char *text, gsize length, const SceneEnds *ends, SceneFile *scene, GError **error)
{
    g_autoptr(JsonParser) parser = NULL;
    JsonValue root;
    if (!json_read_document(file, text, length, &parser, &root, error)) return FALSE;
    Reading reading = {.warned = g_hash_table_new_full(g_str_hash, g_str_equal, g_free, NULL),
                       .discs = g_array_new(FALSE, FALSE, sizeof(tdsp_growing_disc)),
                       .kept = g_ptr_array_new_with_free_func(g_free)};
    reading.out.file = g_strdup(file);
    gboolean read = read_root(&root, &reading, error) && replace_ends(ends, &reading.journey, error) && prepare(file, &reading, error);
    g_hash_table_unref(reading.warned);
    g_array_unref(reading.discs);
    g_ptr_array_unref(reading.kept);
    if (read)
        *scene = reading.out;
    else
        scene_file_clear(&reading.out);
    return read;
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
