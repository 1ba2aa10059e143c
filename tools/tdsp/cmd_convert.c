/* SPDX-License-Identifier: MIT */
/* tdsp convert: scenes from and to CSV, GeoJSON and scene files; paths to CSV, GeoJSON and GPX. */
#include <math.h>
#include <string.h>

#include "commands.h"
#include "convert.h"
#include "convert_asked.h"
#include "file_in.h"
#include "file_out.h"
#include "units.h"

typedef struct Converting {
    const char *file; /* its name, for messages */
    char *text;
    gsize length;
    ConvertKind from, to;
    gboolean has_like;
    SceneDescription like; /* of --scene */
    SceneDraft draft;      /* the scene; of a path only its name, units and georeference */
    guint legs, points;
    double extent, tolerance; /* m; NAN: not known */
    GString *out;
} Converting;

static void converting_clear(Converting *work)
{
    g_clear_pointer(&work->text, g_free);
    scene_description_clear(&work->like);
    scene_draft_clear(&work->draft);
    if (work->out) g_string_free(g_steal_pointer(&work->out), TRUE);
}
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC(Converting, converting_clear)

static const SceneDescription *like_of(const Converting *work)
{
    return work->has_like ? &work->like : NULL;
}

static gboolean load_like(const char *path, Converting *work, GError **error)
{
    g_autofree char *text = NULL;
    gsize length;
    if (!path) return TRUE;
    if (!file_in_read(path, &text, &length, error) || !scene_description_parse(cli_file_name(path), text, length, &work->like, error)) return FALSE;
    work->has_like = TRUE;
    return TRUE;
}

/* ------------------------------------------------------------------------------------------------------------------ scenes */

/* A scene file says everything itself; options may change its names, ends and robot. */
static gboolean read_scene_file(Converting *work, GError **error)
{
    SceneDescription scene;
    if (!scene_description_parse(work->file, work->text, work->length, &scene, error)) return FALSE;
    scene_description_clear(&work->draft.scene);
    work->draft.scene = scene;
    work->draft.has_source = work->draft.has_destination = TRUE;
    return TRUE;
}

static gboolean read_scene(const ConvertAsked *asked, Converting *work, GError **error)
{
    if (work->from == CONVERT_CSV) return convert_csv_read(work->text, work->length, &asked->fields, &work->draft, error);
    if (work->from == CONVERT_GEOJSON) return convert_geojson_read(work->text, work->length, &asked->fields, &work->draft, error);
    return read_scene_file(work, error);
}

static void write_scene_file(const SceneDescription *scene, GString *into)
{
    JsonOut out = {into, FALSE};
    scene_description_write(scene, &out);
    g_string_append_c(into, '\n');
}

static gboolean need_origin(const Converting *work, const char *format, GError **error)
{
    if (work->draft.scene.georeference.known) return TRUE;
    return cli_fail(error, CLI_USAGE, "%s has longitudes and latitudes, and nothing says where %s is on the earth: --origin LON,LAT", format, work->file);
}

static gboolean write_scene(Converting *work, GError **error)
{
    const SceneDescription *scene = &work->draft.scene;
    g_autoptr(GError) unknown = NULL;
    double metres;
    if (scene->georeference.known && unit_metres(work->file, scene->length_unit, &metres, &unknown)) work->extent = scene_description_extent(scene) * metres;
    if (work->to == CONVERT_CSV) return convert_csv_scene(work->file, scene, work->out, error);
    if (work->to == CONVERT_GEOJSON) return need_origin(work, "GeoJSON", error) && convert_geojson_scene(work->file, scene, work->out, error);
    write_scene_file(scene, work->out);
    return TRUE;
}

static gboolean convert_scene(const ConvertAsked *asked, Converting *work, GError **error)
{
    return read_scene(asked, work, error) && scene_draft_finish(&work->draft, &asked->draft, like_of(work), error) && write_scene(work, error);
}

/* ------------------------------------------------------------------------------------------------------------------- paths */

/* The robot's speed, which tells laps around a disc: of the scene, as given, or of a line, which is run at full speed; 0 where nothing tells. */
static double speed_of(const Converting *work, double given, const PathFile *path)
{
    if (work->has_like) return work->like.journey.speed;
    for (guint i = 0; i < path->legs->len && !(given > 0); i++) {
        const tdsp_leg *leg = &g_array_index(path->legs, tdsp_leg, i);
        double time = leg->end_time - leg->start_time;
        if (leg->kind == TDSP_LEG_LINE && time > 0) given = hypot(leg->to.x - leg->from.x, leg->to.y - leg->from.y) / time;
    }
    return given;
}

static gboolean read_path(const ConvertAsked *asked, Converting *work, PathFile *path, GError **error)
{
    double given = 0;
    g_auto(PathFile) rough = {0};
    if (!cli_option_number("--speed", asked->draft.speed, &given, error) ||
        !path_json_parse(work->file, work->text, work->length, 0, &rough, error))
        return FALSE;
    if (!isfinite(rough.arrival)) return cli_fail(error, CLI_NO, "%s: no path to convert: %s", work->file, rough.status);
    if (rough.legs->len == 0) return cli_fail(error, CLI_NO, "%s: a path that stays where it is has no legs to convert", work->file);
    double speed = speed_of(work, given, &rough);
    if (!(speed > 0)) return cli_fail(error, CLI_USAGE, "%s does not tell how fast the robot is: --scene SCENE or --speed V", work->file);
    return path_json_parse(work->file, work->text, work->length, speed, path, error);
}

/* Both ends have to be instants, and what is between them is then. */
static gboolean find_epoch(const ConvertAsked *asked, const Converting *work, const PathFile *path, Epoch *epoch, GError **error)
{
    double unit;
    char instant[INSTANT_ROOM];
    if (!asked->epoch)
        return work->to != CONVERT_GPX ? TRUE : cli_fail(error, CLI_USAGE, "GPX has instants: --epoch says which one the scene's time 0 is");
    if (!unit_seconds(work->file, work->draft.scene.time_unit, &unit, error)) return FALSE;
    const char *wrong = epoch_parse(asked->epoch, unit, epoch);
    if (!wrong && (!instant_format(instant, epoch, path->departure) || !instant_format(instant, epoch, path->arrival))) wrong = "the path is beyond the year 9999";
    return wrong ? cli_fail(error, CLI_USAGE, "--epoch \"%s\": %s", asked->epoch, wrong) : TRUE;
}

static void write_path(const Converting *work, const PathFile *path, const PathPoints *points, Epoch epoch)
{
    static void (*const writers[CONVERT_KINDS])(const ConvertPath *, GString *) = {
        [CONVERT_CSV] = convert_csv_path, [CONVERT_GEOJSON] = convert_geojson_path, [CONVERT_GPX] = convert_gpx_path};
    ConvertPath all = {&work->draft.scene, path, points, epoch};
    writers[work->to](&all, work->out);
}

static gboolean convert_path(const ConvertAsked *asked, Converting *work, GError **error)
{
    g_auto(PathFile) path = {0};
    g_auto(PathPoints) points = {0};
    Georeference *plane = &work->draft.scene.georeference;
    Epoch epoch = {0};
    double metres = 1;
    if (!scene_draft_head(&work->draft, &asked->draft, like_of(work), plane, error) || !read_path(asked, work, &path, error) ||
        (work->to != CONVERT_CSV && !need_origin(work, work->to == CONVERT_GPX ? "GPX" : "GeoJSON", error)) ||
        (plane->known && !unit_metres(work->file, work->draft.scene.length_unit, &metres, error)) ||
        !find_epoch(asked, work, &path, &epoch, error) ||
        !path_points_make(work->file, &path, plane, metres, asked->tolerance_length, &points, error))
        return FALSE;
    work->legs = path.legs->len;
    work->points = points.points->len;
    work->tolerance = points.tolerance;
    if (plane->known) work->extent = points.extent;
    write_path(work, &path, &points, epoch);
    return TRUE;
}

/* ------------------------------------------------------------------------------------------------------------------ output */

static void report_units(const SceneDescription *scene, JsonOut *out)
{
    json_out_key(out, "units");
    json_out_begin(out, '{');
    json_out_member_string(out, "length", *scene->length_unit ? scene->length_unit : NULL);
    json_out_member_string(out, "time", *scene->time_unit ? scene->time_unit : NULL);
    json_out_end(out, '}');
}

static void report_origin(const Converting *work, JsonOut *out)
{
    const Georeference *plane = &work->draft.scene.georeference;
    json_out_key(out, "origin");
    if (plane->known)
        json_out_point(out, (tdsp_point){plane->origin.lon, plane->origin.lat});
    else
        json_out_null(out);
    json_out_member_number(out, "extent", work->extent);
    json_out_member_number(out, "distortion", georeference_distortion(work->extent));
}

static void report_counts(const Converting *work, JsonOut *out)
{
    if (work->from == CONVERT_PATH) {
        json_out_member_whole(out, "legs", work->legs);
        json_out_member_whole(out, "points", work->points);
        json_out_member_number(out, "tolerance", work->tolerance);
    } else {
        json_out_member_whole(out, "discs", work->draft.scene.discs->len);
    }
}

static gint compare_names(gconstpointer one, gconstpointer other)
{
    return strcmp(one, other);
}

/* In the order of the alphabet, so that the same file has the same report. */
static void report_ignored(const Converting *work, JsonOut *out)
{
    GList *names = g_list_sort(g_hash_table_get_keys(work->draft.ignored), compare_names);
    json_out_key(out, "ignored");
    json_out_begin(out, '[');
    for (GList *name = names; name; name = name->next) json_out_string(out, name->data);
    json_out_end(out, ']');
    g_list_free(names);
}

static gboolean report(const ConvertAsked *asked, const Converting *work, GError **error)
{
    g_auto(JsonOut) out = json_out_new();
    if (!asked->json) return TRUE;
    json_out_begin(&out, '{');
    json_out_member_string(&out, "file", asked->output);
    json_out_member_string(&out, "from", convert_kind_word(work->from));
    json_out_member_string(&out, "to", convert_kind_word(work->to));
    report_counts(work, &out);
    report_units(&work->draft.scene, &out);
    report_origin(work, &out);
    report_ignored(work, &out);
    json_out_end(&out, '}');
    return json_out_print(&out, error);
}

static gboolean begin(ConvertAsked *asked, const char *path, Converting *work, GError **error)
{
    const char *const inputs[] = {path, asked->scene, NULL};
    if (asked->scene && strcmp(path, "-") == 0 && strcmp(asked->scene, "-") == 0)
        return cli_fail(error, CLI_USAGE, "only one of FILE and --scene can be standard input");
    if (asked->output && !file_out_check(asked->output, inputs, error)) return FALSE;
    work->file = cli_file_name(path);
    work->draft = scene_draft_new(work->file);
    work->out = g_string_new(NULL);
    work->extent = NAN;
    return file_in_read(path, &work->text, &work->length, error) && convert_kind_of(work->file, work->text, work->length, &work->from, error) &&
           convert_asked_check(asked, work->file, work->from, &work->to, error) && load_like(asked->scene, work, error);
}

static gboolean finish(const ConvertAsked *asked, const Converting *work, GError **error)
{
    if (!asked->output) return cli_print(work->out, error);
    return file_out_write(asked->output, work->out->str, work->out->len, error) && report(asked, work, error);
}

int cmd_convert(const CliCommand *command, int argc, char **argv, GError **error)
{
    g_auto(ConvertAsked) asked = {0};
    g_auto(Converting) work = {0};
    g_autofree GOptionEntry *entries = convert_asked_entries(&asked);
    if (!cli_parse(command, entries, &asked.json, &argc, &argv, error) || !cli_positional(command, argc, 1, 1, error) ||
        !begin(&asked, argv[1], &work, error))
        return CLI_FAILED;
    gboolean done = work.from == CONVERT_PATH ? convert_path(&asked, &work, error) : convert_scene(&asked, &work, error);
    return done && finish(&asked, &work, error) ? CLI_DONE : CLI_FAILED;
}
