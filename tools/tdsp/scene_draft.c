/* SPDX-License-Identifier: MIT */
/*
 * Putting a scene together. Of each thing the first that says it counts: option, file, the other scene. Only what would change the meaning of numbers, a unit or
 * an origin, must not be said twice and differently.
 */
#include "scene_draft.h"

#include <math.h>
#include <string.h>

#include "cli.h"
#include "growth_json.h"
#include "units.h"

SceneDraft scene_draft_new(const char *file)
{
    return (SceneDraft){.file = file,
                        .scene = scene_description_new(),
                        .items = g_array_new(FALSE, FALSE, sizeof(guint)),
                        .ignored = g_hash_table_new_full(g_str_hash, g_str_equal, g_free, NULL)};
}

void scene_draft_clear(SceneDraft *draft)
{
    scene_description_clear(&draft->scene);
    g_clear_pointer(&draft->items, g_array_unref);
    g_clear_pointer(&draft->ignored, g_hash_table_unref);
}

/* ------------------------------------------------------------------------------------------------------------------- items */

static const char *add_disc(SceneDraft *draft, const DraftItem *item, const DraftFields *fields)
{
    tdsp_growing_disc disc = {.center = item->place, .radius = isnan(item->radius) ? fields->missing_radius : item->radius, .growth = item->growth};
    if (!isnan(item->speed)) return "speed is the robot's: it stands with the source";
    if (isnan(item->radius) && disc.radius < 0) return "no radius (--radius R stands in for those that are missing)";
    if (!item->has_growth) disc.growth.rate = fields->missing_growth;
    if (!item->has_growth && disc.growth.rate < 0) return "no growth (--growth G stands in for those that are missing)";
    const char *wrong = tdsp_growing_disc_check(&disc);
    if (wrong) return wrong;
    g_array_append_val(draft->scene.discs, disc);
    g_array_append_val(draft->items, item->item);
    return NULL;
}

static gboolean says_growth(const DraftItem *item)
{
    double rate;
    return item->has_growth && !(growth_json_is_rate(&item->growth, &rate) && rate == 0);
}

/* The source is where the robot stands: its radius and its speed are the robot's. */
static const char *set_source(SceneDraft *draft, const DraftItem *item)
{
    tdsp_journey *journey = &draft->scene.journey;
    if (draft->has_source) return "a second source";
    if (says_growth(item)) return "a source does not grow";
    if (item->speed <= 0) return "the robot's speed must be greater than zero";
    if (item->radius < 0) return "the robot's radius must not be negative";
    draft->has_source = TRUE;
    draft->source_item = item->item;
    journey->source = item->place;
    if (!isnan(item->speed)) journey->speed = item->speed;
    if (!isnan(item->radius)) journey->radius = item->radius;
    return NULL;
}

static const char *set_destination(SceneDraft *draft, const DraftItem *item)
{
    if (draft->has_destination) return "a second destination";
    if (says_growth(item) || item->radius > 0 || !isnan(item->speed)) return "a destination is a point: it has no radius, growth or speed";
    draft->has_destination = TRUE;
    draft->destination_item = item->item;
    draft->scene.journey.destination = item->place;
    return NULL;
}

const char *scene_draft_add(SceneDraft *draft, const DraftItem *item, const DraftFields *fields)
{
    const char *wrong = draft->geographic ? geodesic_check((GeoPlace){item->place.x, item->place.y}) : NULL;
    if (wrong) return wrong;
    if (*item->role == '\0' || strcmp(item->role, "disc") == 0) return add_disc(draft, item, fields);
    if (strcmp(item->role, "source") == 0) return set_source(draft, item);
    if (strcmp(item->role, "destination") == 0) return set_destination(draft, item);
    return "the role is none of disc, source, destination";
}

/* -------------------------------------------------------------------------------------------------------- names and numbers */

static gboolean merge_unit(char **unit, const char *option, const char *like, GError **error)
{
    const char *const others[] = {option, like};
    for (gsize i = 0; i < G_N_ELEMENTS(others); i++) {
        if (!others[i] || !*others[i]) continue;
        if (**unit && strcmp(*unit, others[i]) != 0)
            return cli_fail(error, CLI_USAGE, "the unit is \"%s\", and \"%s\" by %s: nothing is converted", *unit, others[i], i == 0 ? "--units" : "--scene");
        g_free(*unit);
        *unit = g_strdup(others[i]);
    }
    return TRUE;
}

/* What lies on the earth has units, if nobody says which. */
static void measure(SceneDescription *scene)
{
    if (!*scene->length_unit) {
        g_free(scene->length_unit);
        scene->length_unit = g_strdup("m");
    }
    if (!*scene->time_unit) {
        g_free(scene->time_unit);
        scene->time_unit = g_strdup("s");
    }
}

static gboolean merge_units(SceneDraft *draft, const char *option, const SceneDescription *like, GError **error)
{
    SceneDescription *scene = &draft->scene;
    g_auto(GStrv) parts = g_strsplit(option ? option : ",", ",", 0);
    if (g_strv_length(parts) != 2 || (option && (!*parts[0] || !*parts[1])))
        return cli_fail(error, CLI_USAGE, "--units \"%s\": must be two units, LENGTH,TIME", option);
    if (!merge_unit(&scene->length_unit, parts[0], like ? like->length_unit : NULL, error) ||
        !merge_unit(&scene->time_unit, parts[1], like ? like->time_unit : NULL, error))
        return FALSE;
    if (draft->geographic) measure(scene);
    return TRUE;
}

static void merge_name(SceneDescription *scene, const char *option, const SceneDescription *like)
{
    const char *name = option ? option : like && !*scene->name ? like->name : scene->name;
    char *chosen = g_strdup(name);
    g_free(scene->name);
    scene->name = chosen;
}

static gboolean merge_robot(SceneDraft *draft, const DraftOptions *options, const SceneDescription *like, GError **error)
{
    tdsp_journey *journey = &draft->scene.journey;
    if (like && !(journey->speed > 0)) journey->speed = like->journey.speed;
    if (like && !(journey->radius > 0)) journey->radius = like->journey.radius;
    if (!cli_option_number("--speed", options->speed, &journey->speed, error) ||
        !cli_option_number("--robot-radius", options->robot_radius, &journey->radius, error))
        return FALSE;
    if (journey->speed > 0) return TRUE;
    return cli_fail(error, CLI_USAGE, options->speed ? "--speed must be greater than zero" : "%s does not say how fast the robot is: --speed V", draft->file);
}

/* ------------------------------------------------------------------------------------------------------------------ the earth */

static gboolean same_origin(const Georeference *one, const Georeference *other)
{
    return one->origin.lon == other->origin.lon && one->origin.lat == other->origin.lat;
}

static gboolean parse_geographic(const char *option, const char *text, tdsp_point *place, GError **error)
{
    if (!cli_option_point(option, text, "LON,LAT", place, error)) return FALSE;
    const char *wrong = geodesic_check((GeoPlace){place->x, place->y});
    return wrong ? cli_fail(error, CLI_USAGE, "%s \"%s\": %s", option, text, wrong) : TRUE;
}

/* The plane that is asked for, by option or by the other scene; unknown where neither says one. */
static gboolean asked_plane(const DraftOptions *options, const SceneDescription *like, Georeference *plane, GError **error)
{
    *plane = like ? like->georeference : (Georeference){0};
    if (!options->origin) return TRUE;
    tdsp_point origin;
    if (!parse_geographic("--origin", options->origin, &origin, error)) return FALSE;
    const Georeference asked = {TRUE, {origin.x, origin.y}};
    if (plane->known && !same_origin(plane, &asked)) return cli_fail(error, CLI_USAGE, "--origin and --scene contradict each other");
    *plane = asked;
    return TRUE;
}

static gboolean parse_end(const SceneDraft *draft, const char *option, const char *text, tdsp_point *place, GError **error)
{
    return draft->geographic ? parse_geographic(option, text, place, error) : cli_option_point(option, text, "X,Y", place, error);
}

/* The ends as far as the options say them; they have no item. */
static gboolean ends_from_options(SceneDraft *draft, const DraftOptions *options, GError **error)
{
    tdsp_journey *journey = &draft->scene.journey;
    if (options->from) {
        if (!parse_end(draft, "--from", options->from, &journey->source, error)) return FALSE;
        draft->has_source = TRUE;
        draft->source_item = G_MAXUINT;
    }
    if (options->to) {
        if (!parse_end(draft, "--to", options->to, &journey->destination, error)) return FALSE;
        draft->has_destination = TRUE;
        draft->destination_item = G_MAXUINT;
    }
    return TRUE;
}

/* An origin where none is asked for: the file's, or the middle; both ends are places of the file or of options then. */
static gboolean find_origin(SceneDraft *draft, Georeference *plane, GError **error)
{
    if (!plane->known) *plane = draft->scene.georeference;
    if (plane->known) return TRUE;
    const tdsp_journey *journey = &draft->scene.journey;
    g_autoptr(GArray) places = g_array_new(FALSE, FALSE, sizeof(tdsp_point));
    for (guint i = 0; i < draft->scene.discs->len; i++)
        g_array_append_val(places, g_array_index(draft->scene.discs, tdsp_growing_disc, i).center);
    g_array_append_val(places, journey->source);
    g_array_append_val(places, journey->destination);
    const char *wrong = georeference_about((const GeoPlace *)places->data, places->len, plane);
    return wrong ? cli_fail(error, CLI_INPUT, "%s: %s to project about: --origin LON,LAT", draft->file, wrong) : TRUE;
}

static gboolean fail_far(const SceneDraft *draft, guint item, GError **error)
{
    const double most = GEOREFERENCE_REFUSE / 1000;
    if (item == G_MAXUINT) return cli_fail(error, CLI_USAGE, "--from, --to: over %.0f km from the origin", most);
    return cli_fail(error, CLI_INPUT, draft->features ? "%s: features[%u]: over %.0f km from the origin, where a plane is none any more" :
                                                        "%s:%u: over %.0f km from the origin, where a plane is none any more", draft->file, item, most);
}

typedef struct Projecting {
    const SceneDraft *draft;
    const Georeference *plane;
    double metres, extent;
} Projecting;

static gboolean project(Projecting *to, tdsp_point *place, guint item, GError **error)
{
    if (!georeference_forward(to->plane, to->metres, (GeoPlace){place->x, place->y}, place)) return fail_far(to->draft, item, error);
    to->extent = fmax(to->extent, hypot(place->x, place->y) * to->metres);
    return TRUE;
}

/* All places of the file into the plane. */
static gboolean project_all(SceneDraft *draft, Projecting *to, GError **error)
{
    tdsp_journey *journey = &draft->scene.journey;
    for (guint i = 0; i < draft->scene.discs->len; i++) {
        tdsp_point *center = &g_array_index(draft->scene.discs, tdsp_growing_disc, i).center;
        if (!project(to, center, g_array_index(draft->items, guint, i), error)) return FALSE;
    }
    if (draft->has_source && !project(to, &journey->source, draft->source_item, error)) return FALSE;
    return !draft->has_destination || project(to, &journey->destination, draft->destination_item, error);
}

static gboolean lay_on_earth(SceneDraft *draft, Georeference plane, GError **error)
{
    Projecting to = {.draft = draft, .plane = &plane};
    if (!plane.known && (!draft->has_source || !draft->has_destination))
        return cli_fail(error, CLI_USAGE, "--scene does not say where on the earth its ends are: give --origin, or --from and --to");
    if (!find_origin(draft, &plane, error) || !unit_metres(draft->file, draft->scene.length_unit, &to.metres, error) ||
        !project_all(draft, &to, error))
        return FALSE;
    draft->scene.georeference = plane;
    return georeference_fits(draft->file, to.extent, error);
}

/* A plane is a plane: an origin only says where it lies. */
static gboolean keep_plane(SceneDraft *draft, const Georeference *plane, GError **error)
{
    Georeference *own = &draft->scene.georeference;
    if (own->known && plane->known && !same_origin(own, plane))
        return cli_fail(error, CLI_USAGE, "%s lies about another origin than is asked for: nothing is moved", draft->file);
    if (plane->known) *own = *plane;
    return TRUE;
}

static gboolean merge_ends(SceneDraft *draft, const SceneDescription *like, GError **error)
{
    tdsp_journey *journey = &draft->scene.journey;
    if (like && !draft->has_source) journey->source = like->journey.source;
    if (like && !draft->has_destination) journey->destination = like->journey.destination;
    if (!like && !draft->has_source) return cli_fail(error, CLI_USAGE, "%s has no source: --from %s", draft->file, draft->geographic ? "LON,LAT" : "X,Y");
    if (!like && !draft->has_destination) return cli_fail(error, CLI_USAGE, "%s has no destination: --to %s", draft->file, draft->geographic ? "LON,LAT" : "X,Y");
    return TRUE;
}

gboolean scene_draft_head(SceneDraft *draft, const DraftOptions *options, const SceneDescription *like, Georeference *plane, GError **error)
{
    merge_name(&draft->scene, options->name, like);
    return merge_units(draft, options->units, like, error) && asked_plane(options, like, plane, error);
}

gboolean scene_draft_finish(SceneDraft *draft, const DraftOptions *options, const SceneDescription *like, GError **error)
{
    Georeference plane;
    if (!scene_draft_head(draft, options, like, &plane, error) || !merge_robot(draft, options, like, error) ||
        !ends_from_options(draft, options, error) || !merge_ends(draft, like, error) ||
        !(draft->geographic ? lay_on_earth(draft, plane, error) : keep_plane(draft, &plane, error)))
        return FALSE;
    const char *wrong = tdsp_journey_check(&draft->scene.journey);
    return wrong ? cli_fail(error, CLI_INPUT, "%s: %s", draft->file, wrong) : TRUE;
}
