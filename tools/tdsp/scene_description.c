/* SPDX-License-Identifier: MIT */
/*
 * The reader and the writer of scene files (docs/cli.md). Everything is checked before the library sees it, so that a mistake is answered with the place
 * where it stands; the library's own checks stay the last word.
 */
#include "scene_description.h"

#include <math.h>

#include "cli.h"
#include "growth_json.h"
#include "json_read.h"

typedef struct Reading {
    GHashTable *warned; /* kinds of unknown keys that were warned of */
    SceneDescription out;
} Reading;

SceneDescription scene_description_new(void)
{
    return (SceneDescription){.name = g_strdup(""),
                              .length_unit = g_strdup(""),
                              .time_unit = g_strdup(""),
                              .discs = g_array_new(FALSE, FALSE, sizeof(tdsp_growing_disc)),
                              .kept = g_ptr_array_new_with_free_func(g_free)};
}

static gboolean read_not_negative(const JsonValue *object, const char *name, double *number, GError **error)
{
    JsonValue member;
    if (!json_read_member(object, name, &member, error) || !json_read_number(&member, number, error)) return FALSE;
    return *number >= 0 ? TRUE : json_read_fail(&member.place, error, "must not be negative");
}

static gboolean read_robot(const JsonValue *root, Reading *reading, GError **error)
{
    static const char *const known[] = {"speed", "radius", NULL};
    tdsp_journey *journey = &reading->out.journey;
    JsonValue robot, speed, radius;
    if (!json_read_member(root, "robot", &robot, error) || !json_read_object(&robot, error)) return FALSE;
    if (!json_read_member(&robot, "speed", &speed, error) || !json_read_number(&speed, &journey->speed, error)) return FALSE;
    if (!(journey->speed > 0)) return json_read_fail(&speed.place, error, "must be greater than zero");
    if (json_read_optional(&robot, "radius", &radius) && !read_not_negative(&robot, "radius", &journey->radius, error)) return FALSE;
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
    if (!growth_json_read(&growth, &disc, reading->out.kept, reading->warned, error)) return FALSE;
    json_read_warn_unknown(value, known, reading->warned);
    g_array_append_val(reading->out.discs, disc);
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

/* An optional string; *text stays where it is missing. */
static gboolean read_text(const JsonValue *object, const char *name, char **text, GError **error)
{
    JsonValue member;
    const char *string;
    if (!json_read_optional(object, name, &member)) return TRUE;
    if (!json_read_string(&member, &string, error)) return FALSE;
    g_free(*text);
    *text = g_strdup(string);
    return TRUE;
}

static gboolean read_units(const JsonValue *root, SceneDescription *scene, GHashTable *warned, GError **error)
{
    static const char *const known[] = {"length", "time", NULL};
    JsonValue units;
    if (!json_read_optional(root, "units", &units)) return TRUE;
    if (!json_read_object(&units, error) || !read_text(&units, "length", &scene->length_unit, error) ||
        !read_text(&units, "time", &scene->time_unit, error))
        return FALSE;
    json_read_warn_unknown(&units, known, warned);
    return TRUE;
}

gboolean scene_description_read_header(const JsonValue *object, SceneDescription *scene, GHashTable *warned, GError **error)
{
    JsonValue georeference;
    if (!read_text(object, "name", &scene->name, error) || !read_units(object, scene, warned, error)) return FALSE;
    return !json_read_optional(object, "georeference", &georeference) ||
           georeference_read(&georeference, &scene->georeference, warned, error);
}

static gboolean read_root(const JsonValue *root, Reading *reading, GError **error)
{
    static const char *const known[] = {"name", "units", "georeference", "robot", "source", "destination", "discs", NULL};
    tdsp_journey *journey = &reading->out.journey;
    if (!json_read_object(root, error) || !scene_description_read_header(root, &reading->out, reading->warned, error) ||
        !read_robot(root, reading, error) || !json_read_member_point(root, "source", &journey->source, error) ||
        !json_read_member_point(root, "destination", &journey->destination, error) || !read_discs(root, reading, error))
        return FALSE;
    json_read_warn_unknown(root, known, reading->warned);
    const char *wrong = tdsp_journey_check(journey);
    return wrong ? json_read_fail(&root->place, error, "%s", wrong) : TRUE;
}

gboolean scene_description_parse(const char *file, const char *text, gsize length, SceneDescription *scene, GError **error)
{
    g_autoptr(JsonParser) parser = NULL;
    JsonValue root;
    if (!json_read_document(file, text, length, &parser, &root, error)) return FALSE;
    Reading reading = {g_hash_table_new_full(g_str_hash, g_str_equal, g_free, NULL), scene_description_new()};
    gboolean read = read_root(&root, &reading, error);
    g_hash_table_unref(reading.warned);
    if (read)
        *scene = reading.out;
    else
        scene_description_clear(&reading.out);
    return read;
}

double scene_description_extent(const SceneDescription *scene)
{
    const tdsp_journey *journey = &scene->journey;
    double most = fmax(hypot(journey->source.x, journey->source.y), hypot(journey->destination.x, journey->destination.y));
    for (guint i = 0; i < scene->discs->len; i++) {
        tdsp_point center = g_array_index(scene->discs, tdsp_growing_disc, i).center;
        most = fmax(most, hypot(center.x, center.y));
    }
    return most;
}

static void write_units(const SceneDescription *scene, JsonOut *out)
{
    if (!*scene->length_unit && !*scene->time_unit) return;
    json_out_key(out, "units");
    json_out_begin(out, '{');
    if (*scene->length_unit) json_out_member_string(out, "length", scene->length_unit);
    if (*scene->time_unit) json_out_member_string(out, "time", scene->time_unit);
    json_out_end(out, '}');
}

void scene_description_write_header(const SceneDescription *scene, JsonOut *out)
{
    if (*scene->name) json_out_member_string(out, "name", scene->name);
    write_units(scene, out);
    if (!scene->georeference.known) return;
    json_out_key(out, "georeference");
    georeference_write(&scene->georeference, out);
}

static void write_robot(const tdsp_journey *journey, JsonOut *out)
{
    json_out_key(out, "robot");
    json_out_begin(out, '{');
    json_out_member_number(out, "speed", journey->speed);
    if (journey->radius > 0) json_out_member_number(out, "radius", journey->radius);
    json_out_end(out, '}');
}

static void write_disc(const tdsp_growing_disc *disc, JsonOut *out)
{
    json_out_line(out);
    json_out_begin(out, '{');
    json_out_member_point(out, "center", disc->center);
    json_out_member_number(out, "radius", disc->radius);
    json_out_key(out, "growth");
    growth_json_write(&disc->growth, out);
    json_out_end(out, '}');
}

void scene_description_write(const SceneDescription *scene, JsonOut *out)
{
    json_out_begin(out, '{');
    scene_description_write_header(scene, out);
    json_out_line(out);
    write_robot(&scene->journey, out);
    json_out_line(out);
    json_out_member_point(out, "source", scene->journey.source);
    json_out_member_point(out, "destination", scene->journey.destination);
    json_out_line(out);
    json_out_key(out, "discs");
    json_out_begin(out, '[');
    for (guint i = 0; i < scene->discs->len; i++) write_disc(&g_array_index(scene->discs, tdsp_growing_disc, i), out);
    json_out_end(out, ']');
    json_out_end(out, '}');
}

void scene_description_clear(SceneDescription *scene)
{
    g_clear_pointer(&scene->name, g_free);
    g_clear_pointer(&scene->length_unit, g_free);
    g_clear_pointer(&scene->time_unit, g_free);
    g_clear_pointer(&scene->discs, g_array_unref);
    g_clear_pointer(&scene->kept, g_ptr_array_unref);
}
