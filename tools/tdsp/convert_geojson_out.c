/* SPDX-License-Identifier: MIT */
/*
 * Writing GeoJSON: a scene as points whose properties say what they are; a path as a line with the time of each of its points. A line across the antimeridian is cut there
 * (RFC 7946, 3.1.9) and becomes a MultiLineString.
 */
#include <math.h>

#include "convert.h"
#include "growth_json.h"
#include "units.h"

static void begin_collection(JsonOut *out)
{
    json_out_begin(out, '{');
    json_out_member_string(out, "type", "FeatureCollection");
}

static void begin_features(JsonOut *out)
{
    json_out_line(out);
    json_out_key(out, "features");
    json_out_begin(out, '[');
}

static void begin_feature(JsonOut *out, const char *geometry)
{
    json_out_line(out);
    json_out_begin(out, '{');
    json_out_member_string(out, "type", "Feature");
    json_out_key(out, "geometry");
    json_out_begin(out, '{');
    json_out_member_string(out, "type", geometry);
    json_out_key(out, "coordinates");
}

static void begin_properties(JsonOut *out)
{
    json_out_end(out, '}');
    json_out_key(out, "properties");
    json_out_begin(out, '{');
}

static void end_collection(JsonOut *out)
{
    json_out_end(out, ']');
    json_out_end(out, '}');
    g_string_append_c(out->text, '\n');
}

static void put_position(JsonOut *out, GeoPlace place)
{
    json_out_point(out, (tdsp_point){place.lon, place.lat});
}

/* ------------------------------------------------------------------------------------------------------------------ scenes */

typedef struct Writing {
    const SceneDescription *scene;
    double metres;
    JsonOut out;
} Writing;

static void begin_point(Writing *to, tdsp_point place, const char *role)
{
    begin_feature(&to->out, "Point");
    put_position(&to->out, georeference_inverse(&to->scene->georeference, to->metres, place));
    begin_properties(&to->out);
    json_out_member_string(&to->out, "role", role);
}

static void end_point(Writing *to)
{
    json_out_end(&to->out, '}');
    json_out_end(&to->out, '}');
}

static void put_ends(Writing *to)
{
    const tdsp_journey *journey = &to->scene->journey;
    begin_point(to, journey->source, "source");
    json_out_member_number(&to->out, "speed", journey->speed);
    json_out_member_number(&to->out, "radius", journey->radius);
    end_point(to);
    begin_point(to, journey->destination, "destination");
    end_point(to);
}

static void put_disc(Writing *to, const tdsp_growing_disc *disc)
{
    begin_point(to, disc->center, "disc");
    json_out_member_number(&to->out, "radius", disc->radius);
    json_out_key(&to->out, "growth");
    growth_json_write(&disc->growth, &to->out);
    end_point(to);
}

gboolean convert_geojson_scene(const char *file, const SceneDescription *scene, GString *into, GError **error)
{
    Writing to = {.scene = scene, .out = {into, FALSE}};
    if (!unit_metres(file, scene->length_unit, &to.metres, error) || !georeference_fits(file, scene_description_extent(scene) * to.metres, error)) return FALSE;
    begin_collection(&to.out);
    scene_description_write_header(scene, &to.out);
    begin_features(&to.out);
    put_ends(&to);
    for (guint i = 0; i < scene->discs->len; i++) put_disc(&to, &g_array_index(scene->discs, tdsp_growing_disc, i));
    end_collection(&to.out);
    return TRUE;
}

/* ------------------------------------------------------------------------------------------------------------------- paths */

/* The points of a path in lines that stay on one side of the antimeridian. */
typedef struct Lines {
    GArray *points; /* of PathPoint */
    GArray *ends;   /* of guint: where each line ends */
} Lines;

static void end_line(Lines *lines)
{
    g_array_append_val(lines->ends, lines->points->len);
}

/* The point between two at which the antimeridian is met, on the side of the first and then of the second. */
static void cut(Lines *lines, const PathPoint *from, const PathPoint *to)
{
    double side = from->geo.lon > 0 ? 180 : -180, whole = geodesic_turned(to->geo.lon - from->geo.lon);
    double share = whole != 0 ? (side - from->geo.lon) / whole : 0;
    PathPoint at = *to;
    at.time = from->time + (to->time - from->time) * share;
    at.geo = (GeoPlace){side, from->geo.lat + (to->geo.lat - from->geo.lat) * share};
    g_array_append_val(lines->points, at);
    end_line(lines);
    at.geo.lon = -side;
    g_array_append_val(lines->points, at);
}

static Lines lines_of(const PathPoints *path)
{
    Lines lines = {g_array_new(FALSE, FALSE, sizeof(PathPoint)), g_array_new(FALSE, FALSE, sizeof(guint))};
    for (guint i = 0; i < path->points->len; i++) {
        const PathPoint *point = &g_array_index(path->points, PathPoint, i), *last = point - 1;
        if (i > 0 && fabs(point->geo.lon - last->geo.lon) > 180) cut(&lines, last, point);
        g_array_append_vals(lines.points, point, 1);
    }
    /* A line has two positions at least. */
    if (lines.points->len == 1) g_array_append_vals(lines.points, &g_array_index(path->points, PathPoint, 0), 1);
    end_line(&lines);
    return lines;
}

typedef void (*PutPoint)(const ConvertPath *path, const PathPoint *point, JsonOut *out);

static void put_place(const ConvertPath *path, const PathPoint *point, JsonOut *out)
{
    (void)path;
    put_position(out, point->geo);
}

static void put_time(const ConvertPath *path, const PathPoint *point, JsonOut *out)
{
    (void)path;
    json_out_number(out, point->time);
}

static void put_instant(const ConvertPath *path, const PathPoint *point, JsonOut *out)
{
    char instant[INSTANT_ROOM];
    json_out_string(out, convert_instant(instant, path, point));
}

/* One array for a line; an array of them for several. */
static void put_lines(const ConvertPath *path, const Lines *lines, PutPoint put, JsonOut *out)
{
    guint from = 0;
    if (lines->ends->len > 1) json_out_begin(out, '[');
    for (guint line = 0; line < lines->ends->len; line++) {
        json_out_begin(out, '[');
        for (; from < g_array_index(lines->ends, guint, line); from++) put(path, &g_array_index(lines->points, PathPoint, from), out);
        json_out_end(out, ']');
    }
    if (lines->ends->len > 1) json_out_end(out, ']');
}

static void put_leg_list(const ConvertPath *path, JsonOut *out)
{
    json_out_key(out, "legs");
    json_out_begin(out, '[');
    for (guint i = 0; i < path->path->legs->len; i++) {
        const tdsp_leg *leg = &g_array_index(path->path->legs, tdsp_leg, i);
        json_out_begin(out, '{');
        json_out_member_string(out, "type", leg->kind == TDSP_LEG_LINE ? "line" : "arc");
        json_out_member_number(out, "start_time", leg->start_time);
        json_out_member_number(out, "end_time", leg->end_time);
        if (leg->kind != TDSP_LEG_LINE) json_out_member_whole(out, "disc", leg->disc);
        json_out_end(out, '}');
    }
    json_out_end(out, ']');
}

static void put_properties(const ConvertPath *path, const Lines *lines, JsonOut *out)
{
    begin_properties(out);
    json_out_member_string(out, "role", "path");
    json_out_member_number(out, "departure", path->path->departure);
    json_out_member_number(out, "arrival", path->path->arrival);
    json_out_member_number(out, "tolerance", path->points->tolerance);
    put_leg_list(path, out);
    json_out_key(out, "times");
    put_lines(path, lines, put_time, out);
    if (path->epoch.known) {
        json_out_key(out, "coordTimes");
        put_lines(path, lines, put_instant, out);
    }
    json_out_end(out, '}');
}

void convert_geojson_path(const ConvertPath *path, GString *into)
{
    JsonOut out = {into, FALSE};
    Lines lines = lines_of(path->points);
    begin_collection(&out);
    scene_description_write_header(path->scene, &out);
    begin_features(&out);
    begin_feature(&out, lines.ends->len > 1 ? "MultiLineString" : "LineString");
    put_lines(path, &lines, put_place, &out);
    put_properties(path, &lines, &out);
    json_out_end(&out, '}');
    end_collection(&out);
    g_array_unref(lines.points);
    g_array_unref(lines.ends);
}
