/*
 * The reader of scene files (docs/cli.md). Everything is checked before the library sees it, so that a mistake is answered with
 * the place where it stands; the library's own checks stay the last word.
 */
#include "scene_file.h"

#include <string.h>

#include "cli.h"
#include "file_in.h"
#include "json_read.h"
#include "stopwatch.h"

typedef struct Reading {
    GHashTable *warned; /* kinds of unknown keys that were warned of */
    SceneFile out;
    tdsp_journey journey;
    GArray *discs; /* of tdsp_disc */
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

static gboolean fail_growth(const JsonPlace *place, GError **error)
{
    return json_read_fail(place, error,
                          "growth that changes with time is not supported yet; supported are a rate r, [r], and "
                          "{\"times\": [0], \"rates\": [r]}");
}

/* [c1, c2, ...]: R(t) = radius + c1 t + c2 t^2 + ... */
static gboolean read_polynomial(const JsonValue *growth, double *rate, GError **error)
{
    guint length;
    if (!json_read_array(growth, &length, error)) return FALSE;
    if (length == 0) return json_read_fail(&growth->place, error, "has no coefficient");
    for (guint i = 0; i < length; i++) {
        double number;
        JsonValue item = json_read_item(growth, i);
        if (!json_read_number(&item, &number, error)) return FALSE;
        if (i == 0) *rate = number;
        if (i > 0 && number != 0) return fail_growth(&item.place, error);
    }
    return TRUE;
}

static gboolean read_times(const JsonValue *growth, guint *length, GError **error)
{
    JsonValue times;
    double last = 0;
    if (!json_read_member(growth, "times", &times, error) || !json_read_array(&times, length, error)) return FALSE;
    if (*length == 0) return json_read_fail(&times.place, error, "is empty");
    for (guint i = 0; i < *length; i++) {
        double time;
        JsonValue item = json_read_item(&times, i);
        if (!json_read_number(&item, &time, error)) return FALSE;
        if (i == 0 && time != 0) return json_read_fail(&item.place, error, "the first time must be 0");
        if (i > 0 && !(time > last)) return json_read_fail(&item.place, error, "times must increase");
        last = time;
    }
    return TRUE;
}

/* {"times": [0, t1, ...], "rates": [r0, r1, ...]} */
static gboolean read_piecewise(const JsonValue *growth, Reading *reading, double *rate, GError **error)
{
    static const char *const known[] = {"times", "rates", NULL};
    JsonValue rates;
    guint times, length;
    if (!read_times(growth, &times, error)) return FALSE;
    if (!json_read_member(growth, "rates", &rates, error) || !json_read_array(&rates, &length, error)) return FALSE;
    if (length != times) return json_read_fail(&rates.place, error, "%u rates for %u times", length, times);
    for (guint i = 0; i < length; i++) {
        double number;
        JsonValue item = json_read_item(&rates, i);
        if (!json_read_number(&item, &number, error)) return FALSE;
        if (i == 0) *rate = number;
        if (number != *rate) return fail_growth(&item.place, error);
    }
    json_read_warn_unknown(growth, known, reading->warned);
    return TRUE;
}

static gboolean read_growth(const JsonValue *disc, Reading *reading, double *rate, GError **error)
{
    JsonValue growth;
    gboolean read;
    if (!json_read_member(disc, "growth", &growth, error)) return FALSE;
    if (JSON_NODE_HOLDS_ARRAY(growth.node))
        read = read_polynomial(&growth, rate, error);
    else if (JSON_NODE_HOLDS_OBJECT(growth.node))
        read = read_piecewise(&growth, reading, rate, error);
    else
        read = json_read_number(&growth, rate, error);
    if (!read) return FALSE;
    return *rate >= 0 ? TRUE : json_read_fail(&growth.place, error, "must not be negative: discs never shrink");
}

static gboolean read_disc(const JsonValue *value, Reading *reading, GError **error)
{
    static const char *const known[] = {"center", "radius", "growth", NULL};
    tdsp_disc disc;
    if (!json_read_object(value, error) || !json_read_member_point(value, "center", &disc.center, error) ||
        !read_not_negative(value, "radius", &disc.radius, error) || !read_growth(value, reading, &disc.growth, error))
        return FALSE;
    json_read_warn_unknown(value, known, reading->warned);
    const char *wrong = tdsp_disc_check(&disc);
    if (wrong) return json_read_fail(&value->place, error, "%s", wrong);
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

static gboolean prepare(const char *file, Reading *reading, GError **error)
{
    Stopwatch watch = stopwatch_start();
    tdsp_status status = tdsp_scene_create(&reading->journey, (const tdsp_disc *)(void *)reading->discs->data,
                                           reading->discs->len, NULL, &reading->out.scene);
    reading->out.prepare_seconds = stopwatch_seconds(watch);
    return status == TDSP_OK ? TRUE : cli_fail_status(error, file, status);
}

gboolean scene_file_parse(const char *file, const char *text, gsize length, SceneFile *scene, GError **error)
{
    g_autoptr(JsonParser) parser = NULL;
    JsonValue root;
    if (!json_read_document(file, text, length, &parser, &root, error)) return FALSE;
    Reading reading = {.warned = g_hash_table_new_full(g_str_hash, g_str_equal, g_free, NULL),
                       .discs = g_array_new(FALSE, FALSE, sizeof(tdsp_disc))};
    gboolean read = read_root(&root, &reading, error) && prepare(file, &reading, error);
    g_hash_table_unref(reading.warned);
    g_array_unref(reading.discs);
    if (read)
        *scene = reading.out;
    else
        scene_file_clear(&reading.out);
    return read;
}

gboolean scene_file_load(const char *path, SceneFile *scene, GError **error)
{
    g_auto(FileIn) file = {0};
    if (!file_in_load(path, &file, error)) return FALSE;
    if (file.kind == FILE_TABLE) return cli_fail(error, CLI_INPUT, "%s: a table, where a scene is needed", cli_file_name(path));
    return scene_file_parse(cli_file_name(path), file.text, file.length, scene, error);
}

void scene_file_clear(SceneFile *scene)
{
    g_clear_pointer(&scene->name, g_free);
    g_clear_pointer(&scene->length_unit, g_free);
    g_clear_pointer(&scene->time_unit, g_free);
    g_clear_pointer(&scene->scene, tdsp_scene_free);
}
