/* SPDX-License-Identifier: MIT */
/*
 * Reading GeoJSON (RFC 7946): points become discs, or an end where their role says so; anything else that has an extent is refused, for a disc is a point with a radius.
 * The members of a FeatureCollection that are not GeoJSON's own, name, units and georeference, are those of a scene file.
 */
#include <math.h>
#include <string.h>

#include "convert.h"
#include "growth_json.h"
#include "json_read.h"

typedef struct Reading {
    const DraftFields *fields;
    SceneDraft *draft;
    GHashTable *warned;
} Reading;

static gboolean is_null(const JsonValue *value)
{
    return JSON_NODE_HOLDS_NULL(value->node);
}

static gboolean read_type(const JsonValue *object, const char **type, JsonValue *member, GError **error)
{
    return json_read_object(object, error) && json_read_member(object, "type", member, error) && json_read_string(member, type, error);
}

/* [lon, lat] or [lon, lat, height]. */
static gboolean read_position(const JsonValue *value, tdsp_point *place, GError **error)
{
    guint length;
    if (!json_read_array(value, &length, error)) return FALSE;
    if (length < 2) return json_read_fail(&value->place, error, "a position has a longitude and a latitude");
    JsonValue lon = json_read_item(value, 0), lat = json_read_item(value, 1);
    if (!json_read_number(&lon, &place->x, error) || !json_read_number(&lat, &place->y, error)) return FALSE;
    const char *wrong = geodesic_check((GeoPlace){place->x, place->y});
    return wrong ? json_read_fail(&value->place, error, "%s", wrong) : TRUE;
}

/* ------------------------------------------------------------------------------------------------------------- properties */

/* A property that is neither missing nor null. */
static gboolean has_property(const JsonValue *properties, const char *name, JsonValue *value)
{
    return properties->node && json_read_optional(properties, name, value) && !is_null(value);
}

static gboolean read_number(const JsonValue *properties, const char *name, double *number, GError **error)
{
    JsonValue value;
    *number = NAN;
    return !has_property(properties, name, &value) || json_read_number(&value, number, error);
}

/* The growth is read with the radius of the disc that it belongs to. */
static gboolean read_growth(const JsonValue *properties, Reading *reading, DraftItem *item, GError **error)
{
    JsonValue value;
    tdsp_growing_disc disc = {.radius = item->radius >= 0 ? item->radius : 0};
    item->has_growth = has_property(properties, reading->fields->growth, &value);
    if (!item->has_growth) return TRUE;
    if (!growth_json_read(&value, &disc, reading->draft->scene.kept, reading->warned, error)) return FALSE;
    item->growth = disc.growth;
    return TRUE;
}

static void note_ignored(const JsonValue *properties, Reading *reading)
{
    const DraftFields *fields = reading->fields;
    const char *const used[] = {fields->role, fields->radius, fields->growth, "speed", NULL};
    JsonObjectIter iter;
    const char *name;
    json_object_iter_init(&iter, json_node_get_object(properties->node));
    while (json_object_iter_next(&iter, &name, NULL))
        if (!g_strv_contains(used, name) && !g_hash_table_contains(reading->draft->ignored, name))
            g_hash_table_add(reading->draft->ignored, g_strdup(name));
}

static gboolean read_properties(const JsonValue *feature, Reading *reading, DraftItem *item, GError **error)
{
    JsonValue properties = {0}, role;
    item->role = "";
    if (!json_read_optional(feature, "properties", &properties) || is_null(&properties))
        properties.node = NULL;
    else if (!json_read_object(&properties, error))
        return FALSE;
    if (has_property(&properties, reading->fields->role, &role) && !json_read_string(&role, &item->role, error)) return FALSE;
    if (!read_number(&properties, reading->fields->radius, &item->radius, error) || !read_number(&properties, "speed", &item->speed, error) ||
        !read_growth(&properties, reading, item, error))
        return FALSE;
    if (properties.node) note_ignored(&properties, reading);
    return TRUE;
}

/* --------------------------------------------------------------------------------------------------------------- features */

static gboolean add_item(const JsonValue *feature, const JsonValue *coordinates, DraftItem *item, Reading *reading, GError **error)
{
    if (!read_position(coordinates, &item->place, error)) return FALSE;
    const char *wrong = scene_draft_add(reading->draft, item, reading->fields);
    return wrong ? json_read_fail(&feature->place, error, "%s", wrong) : TRUE;
}

static gboolean add_items(const JsonValue *feature, const JsonValue *coordinates, DraftItem *item, Reading *reading, GError **error)
{
    guint length;
    if (!json_read_array(coordinates, &length, error)) return FALSE;
    for (guint i = 0; i < length; i++) {
        JsonValue position = json_read_item(coordinates, i);
        if (!add_item(feature, &position, item, reading, error)) return FALSE;
    }
    return TRUE;
}

static gboolean read_feature(const JsonValue *feature, guint number, Reading *reading, GError **error)
{
    JsonValue type, geometry, coordinates;
    const char *word;
    DraftItem item = {.item = number};
    if (!read_type(feature, &word, &type, error)) return FALSE;
    if (strcmp(word, "Feature") != 0) return json_read_fail(&type.place, error, "must be \"Feature\"");
    if (!json_read_member(feature, "geometry", &geometry, error) || !read_type(&geometry, &word, &type, error)) return FALSE;
    gboolean many = strcmp(word, "MultiPoint") == 0;
    if (!many && strcmp(word, "Point") != 0)
        return json_read_fail(&geometry.place, error, "a %s: a disc is a Point with a radius (convert to centroids first)", word);
    if (!json_read_member(&geometry, "coordinates", &coordinates, error) || !read_properties(feature, reading, &item, error)) return FALSE;
    return (many ? add_items : add_item)(feature, &coordinates, &item, reading, error);
}

/* GeoJSON is longitude and latitude on WGS84; before it was RFC 7946, a member could say otherwise, and some programs still write it. */
static gboolean check_crs(const JsonValue *root, GError **error)
{
    static const char *const same[] = {"urn:ogc:def:crs:OGC:1.3:CRS84", "urn:ogc:def:crs:OGC::CRS84", "urn:ogc:def:crs:EPSG::4326", "EPSG:4326", NULL};
    JsonValue crs, properties, name;
    const char *word;
    if (!json_read_optional(root, "crs", &crs) || is_null(&crs)) return TRUE;
    if (!json_read_object(&crs, error) || !json_read_member(&crs, "properties", &properties, error) || !json_read_object(&properties, error) ||
        !json_read_member(&properties, "name", &name, error) || !json_read_string(&name, &word, error))
        return FALSE;
    return g_strv_contains(same, word) ? TRUE : json_read_fail(&name.place, error, "GeoJSON has WGS84 longitudes and latitudes, not %s", word);
}

static gboolean read_collection(const JsonValue *root, Reading *reading, GError **error)
{
    JsonValue features;
    guint length;
    if (!check_crs(root, error) || !scene_description_read_header(root, &reading->draft->scene, reading->warned, error) ||
        !json_read_member(root, "features", &features, error) || !json_read_array(&features, &length, error))
        return FALSE;
    for (guint i = 0; i < length; i++) {
        JsonValue feature = json_read_item(&features, i);
        if (!read_feature(&feature, i, reading, error)) return FALSE;
    }
    return TRUE;
}

static gboolean read_root(const JsonValue *root, Reading *reading, GError **error)
{
    JsonValue type;
    const char *word;
    if (!read_type(root, &word, &type, error)) return FALSE;
    if (strcmp(word, "FeatureCollection") == 0) return read_collection(root, reading, error);
    return json_read_fail(&type.place, error, "must be \"FeatureCollection\", not \"%s\"", word);
}

gboolean convert_geojson_read(const char *text, gsize length, const DraftFields *fields, SceneDraft *draft, GError **error)
{
    g_autoptr(JsonParser) parser = NULL;
    JsonValue root;
    draft->geographic = draft->features = TRUE;
    if (!json_read_document(draft->file, text, length, &parser, &root, error)) return FALSE;
    Reading reading = {fields, draft, g_hash_table_new_full(g_str_hash, g_str_equal, g_free, NULL)};
    gboolean read = read_root(&root, &reading, error);
    g_hash_table_unref(reading.warned);
    return read;
}
