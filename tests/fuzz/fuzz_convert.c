/* SPDX-License-Identifier: MIT */
/*
 * Any text at all as a file to convert: a message, or a scene that comes back from a scene file as it is, from CSV too where its discs have one rate each, and from GeoJSON within
 * a millionth of a metre; or a path whose points run from its first leg to its last in time.
 */
#include <math.h>
#include <string.h>

#include "input.h"
#include "tdsp/convert.h"
#include "tdsp/convert_asked.h"
#include "tdsp/growth_json.h"

enum { FEW = 64 }; /* discs that are written as GeoJSON */

static const DraftFields fields = {"role", "radius", "growth", NULL, NULL, NULL, NULL, 1.0, 0.1};

static gboolean read_draft(ConvertKind kind, const char *text, gsize length, SceneDraft *draft, GError **error)
{
    if (kind == CONVERT_CSV) return convert_csv_read(text, length, &fields, draft, error);
    if (kind == CONVERT_GEOJSON) return convert_geojson_read(text, length, &fields, draft, error);
    scene_description_clear(&draft->scene);
    draft->has_source = draft->has_destination = TRUE;
    return scene_description_parse("input", text, length, &draft->scene, error);
}

/* Whatever the file leaves open, options say. */
static gboolean read_scene(ConvertKind kind, const char *text, gsize length, SceneDraft *draft, GError **error)
{
    char from[] = "0,0", to[] = "0.5,0.25", speed[] = "1";
    DraftOptions options = {0};
    if (!read_draft(kind, text, length, draft, error)) return FALSE;
    if (!draft->has_source) options.from = from;
    if (!draft->has_destination) options.to = to;
    if (!(draft->scene.journey.speed > 0.0)) options.speed = speed;
    return scene_draft_finish(draft, &options, NULL, error);
}

static const tdsp_growing_disc *disc_of(const SceneDescription *scene, guint i)
{
    return &g_array_index(scene->discs, tdsp_growing_disc, i);
}

static gboolean all_rates(const SceneDescription *scene)
{
    double rate;
    for (guint i = 0; i < scene->discs->len; i++)
        if (!growth_json_is_rate(&disc_of(scene, i)->growth, &rate)) return FALSE;
    return TRUE;
}

static gboolean near(tdsp_point a, tdsp_point b, double within)
{
    return a.x == b.x ? fabs(a.y - b.y) <= within : hypot(a.x - b.x, a.y - b.y) <= within;
}

/* Do two scenes say the same? Places within a length, 0 for exactly. */
static void check_same(const SceneDescription *a, const SceneDescription *b, double within)
{
    fuzz_require(a->discs->len == b->discs->len, "another number of discs");
    fuzz_require(a->journey.speed == b->journey.speed && a->journey.radius == b->journey.radius, "another robot");
    fuzz_require(near(a->journey.source, b->journey.source, within) && near(a->journey.destination, b->journey.destination, within), "other ends");
    for (guint i = 0; i < a->discs->len; i++) {
        const tdsp_growing_disc *one = disc_of(a, i), *other = disc_of(b, i);
        double rate, again;
        fuzz_require(near(one->center, other->center, within) && one->radius == other->radius, "another disc");
        fuzz_require(growth_json_is_rate(&one->growth, &rate) == growth_json_is_rate(&other->growth, &again) && rate == again, "another growth");
    }
}

static void check_again(ConvertKind kind, const GString *text, const SceneDescription *scene, double within)
{
    g_auto(SceneDraft) again = scene_draft_new("again");
    g_autoptr(GError) error = NULL;
    fuzz_require(read_scene(kind, text->str, text->len, &again, &error), error ? error->message : "refused without a message");
    check_same(scene, &again.scene, within);
}

static void check_scene_file(const SceneDescription *scene)
{
    g_autoptr(GString) text = g_string_new(NULL);
    JsonOut out = {text, FALSE};
    scene_description_write(scene, &out);
    check_again(CONVERT_JSON, text, scene, 0.0);
}

static void check_csv(const SceneDescription *scene)
{
    g_autoptr(GString) text = g_string_new(NULL);
    g_autoptr(GError) error = NULL;
    const gboolean written = convert_csv_scene("input", scene, text, &error);
    fuzz_require(written == all_rates(scene), "CSV holds discs of one rate, and no others");
    if (written) check_again(CONVERT_CSV, text, scene, 0.0);
}

static void check_geojson(const SceneDescription *scene)
{
    g_autoptr(GString) text = g_string_new(NULL);
    g_autoptr(GError) error = NULL;
    if (!scene->georeference.known || scene->discs->len > FEW || strcmp(scene->length_unit, "m") != 0) return;
    /* at the very limit the way there and back may cross it */
    if (scene_description_extent(scene) < 0.999999 * GEOREFERENCE_REFUSE) {
        fuzz_require(convert_geojson_scene("input", scene, text, &error), "not written");
        check_again(CONVERT_GEOJSON, text, scene, 1e-6);
    }
}

static void check_scene(ConvertKind kind, const char *text, gsize length)
{
    g_auto(SceneDraft) draft = scene_draft_new("input");
    g_autoptr(GError) error = NULL;
    const gboolean read = read_scene(kind, text, length, &draft, &error);
    fuzz_require(read ? !error : error != NULL, "no message, or one too many");
    if (!read) return;
    check_scene_file(&draft.scene);
    check_csv(&draft.scene);
    check_geojson(&draft.scene);
}

static void check_points(const PathFile *path, const Georeference *geo)
{
    g_auto(PathPoints) points = {0};
    g_autoptr(GError) error = NULL;
    const gboolean made = path_points_make("input", path, geo, 1.0, 0.0, &points, &error);
    fuzz_require(made ? !error : error != NULL, "no message, or one too many");
    if (!made || points.points->len == 0) return;
    const PathPoint *all = (const PathPoint *)(void *)points.points->data, *last = &all[points.points->len - 1];
    fuzz_require(last->leg + 1 == path->legs->len || last->time == g_array_index(path->legs, tdsp_leg, path->legs->len - 1).end_time, "ends early");
    for (guint i = 1; i < points.points->len; i++) fuzz_require(all[i].leg > all[i - 1].leg || all[i].time >= all[i - 1].time, "time runs backwards");
}

static void check_path(const char *text, gsize length)
{
    static const Georeference somewhere = {TRUE, {179.0, -80.0}}, nowhere = {0};
    g_auto(PathFile) path = {0};
    g_autoptr(GError) error = NULL;
    if (!path_json_parse("input", text, length, 1.0, &path, &error)) return;
    check_points(&path, &nowhere);
    if (path.legs->len < FEW) check_points(&path, &somewhere);
}

int LLVMFuzzerTestOneInput(const unsigned char *data, size_t size)
{
    g_autoptr(GError) error = NULL;
    ConvertKind kind;
    g_autofree char *text = g_malloc(size + 1); /* exactly as long as it is, so that a read past its end is seen */
    if (size) memcpy(text, data, size);
    text[size] = '\0';
    const gboolean known = convert_kind_of("input", text, size, &kind, &error);
    fuzz_require(known ? !error : error != NULL, "no message, or one too many");
    if (!known) return 0;
    if (kind == CONVERT_PATH)
        check_path(text, size);
    else
        check_scene(kind, text, size);
    return 0;
}
