/* SPDX-License-Identifier: MIT */
/*
 * CSV: a line a disc, with named columns in any order; the ends are lines whose role says so, and the robot stands at the source. Of a path, a line a point.
 * Numbers are written so that they read back as the same doubles.
 */
#include <math.h>
#include <string.h>

#include "cli.h"
#include "convert.h"
#include "csv.h"
#include "growth_json.h"
#include "numbers.h"

/* Columns by what they mean, and whether there is one: its index, or -1. */
typedef enum Column { ROLE, X, Y, RADIUS, GROWTH, SPEED, COLUMNS } Column;

typedef struct Header {
    guint width;
    int at[COLUMNS];
    const char *says[COLUMNS]; /* what the column is called */
} Header;

/* --------------------------------------------------------------------------------------------------------------- the header */

/* The column of that name, whatever the case of its letters: -1 without one, -2 where there are two. */
static int find_column(const Csv *csv, const char *name)
{
    int found = -1;
    for (guint i = 0; i < csv->fields->len; i++) {
        if (g_ascii_strcasecmp(g_ptr_array_index(csv->fields, i), name) != 0) continue;
        if (found >= 0) return -2;
        found = (int)i;
    }
    return found;
}

/* The first column with one of the names (NULL-terminated), or with `chosen` where that is given. */
static gboolean take_column(const Csv *csv, const char *chosen, const char *const *names, Column column, Header *header, GError **error)
{
    const char *const only[] = {chosen, NULL};
    header->at[column] = -1;
    for (const char *const *name = chosen ? only : names; *name && header->at[column] < 0; name++) {
        header->says[column] = *name;
        header->at[column] = find_column(csv, *name);
        if (header->at[column] == -2) return csv_fail(csv, error, "two columns named \"%s\"", *name);
    }
    if (chosen && header->at[column] < 0) return csv_fail(csv, error, "no column \"%s\"", chosen);
    return TRUE;
}

static const char *const usual_x[] = {"x", NULL}, *const usual_y[] = {"y", NULL};
static const char *const usual_lon[] = {"lon", "longitude", "lng", "long", NULL}, *const usual_lat[] = {"lat", "latitude", NULL};

/* Both columns of a place. `geographic` or not: the other pair must not be there too, for who is to say which is meant. */
static gboolean take_place(const Csv *csv, const DraftFields *fields, Header *header, gboolean *geographic, GError **error)
{
    const gboolean says_plane = fields->x || fields->y, says_earth = fields->lon || fields->lat;
    Header plane = *header, earth = *header;
    if (!take_column(csv, fields->x, usual_x, X, &plane, error) || !take_column(csv, fields->y, usual_y, Y, &plane, error) ||
        !take_column(csv, fields->lon, usual_lon, X, &earth, error) || !take_column(csv, fields->lat, usual_lat, Y, &earth, error))
        return FALSE;
    const gboolean is_plane = !says_earth && plane.at[X] >= 0 && plane.at[Y] >= 0, is_earth = !says_plane && earth.at[X] >= 0 && earth.at[Y] >= 0;
    if (is_plane && is_earth)
        return csv_fail(csv, error, "columns x, y and %s, %s: say which by --x-field and --y-field, or --lon-field and --lat-field", earth.says[X], earth.says[Y]);
    if (!is_plane && !is_earth) return csv_fail(csv, error, "the first line must name the columns, among them x and y, or lon and lat");
    *header = is_earth ? earth : plane;
    *geographic = is_earth;
    return TRUE;
}

static gboolean read_header(Csv *csv, const DraftFields *fields, SceneDraft *draft, Header *header, GError **error)
{
    static const char *const speed[] = {"speed", NULL};
    const char *const role[] = {fields->role, NULL}, *const radius[] = {fields->radius, NULL}, *const growth[] = {fields->growth, NULL};
    if (!csv_next(csv, error)) return FALSE;
    header->width = csv->fields->len;
    if (!take_place(csv, fields, header, &draft->geographic, error) || !take_column(csv, NULL, role, ROLE, header, error) ||
        !take_column(csv, NULL, radius, RADIUS, header, error) || !take_column(csv, NULL, growth, GROWTH, header, error) ||
        !take_column(csv, NULL, speed, SPEED, header, error))
        return FALSE;
    for (guint i = 0; i < csv->fields->len; i++) {
        gboolean used = FALSE;
        for (int column = 0; column < COLUMNS; column++) used = used || header->at[column] == (int)i;
        if (!used) g_hash_table_add(draft->ignored, g_strdup(g_ptr_array_index(csv->fields, i)));
    }
    return TRUE;
}

/* ---------------------------------------------------------------------------------------------------------------- the lines */

/* A number, or NAN where there is nothing. */
static gboolean read_number(const Csv *csv, const Header *header, Column column, double *number, GError **error)
{
    const char *text = header->at[column] < 0 ? "" : g_ptr_array_index(csv->fields, header->at[column]);
    *number = NAN;
    const char *wrong = *text ? number_parse(text, number) : NULL;
    return wrong ? csv_fail(csv, error, "%s: \"%.60s\": %s", header->says[column], text, wrong) : TRUE;
}

static gboolean read_coordinate(const Csv *csv, const Header *header, Column column, double *number, GError **error)
{
    if (!read_number(csv, header, column, number, error)) return FALSE;
    return isnan(*number) ? csv_fail(csv, error, "%s: missing", header->says[column]) : TRUE;
}

static gboolean read_line(const Csv *csv, const Header *header, const DraftFields *fields, SceneDraft *draft, GError **error)
{
    DraftItem item = {.item = csv->line, .role = header->at[ROLE] < 0 ? "" : g_ptr_array_index(csv->fields, header->at[ROLE])};
    if (csv->fields->len != header->width)
        return csv_fail(csv, error, "%u fields, where the header has %u", csv->fields->len, header->width);
    if (!read_coordinate(csv, header, X, &item.place.x, error) || !read_coordinate(csv, header, Y, &item.place.y, error) ||
        !read_number(csv, header, RADIUS, &item.radius, error) || !read_number(csv, header, GROWTH, &item.growth.rate, error) ||
        !read_number(csv, header, SPEED, &item.speed, error))
        return FALSE;
    item.has_growth = !isnan(item.growth.rate);
    const char *wrong = scene_draft_add(draft, &item, fields);
    return wrong ? csv_fail(csv, error, "%s", wrong) : TRUE;
}

gboolean convert_csv_read(const char *text, gsize length, const DraftFields *fields, SceneDraft *draft, GError **error)
{
    g_auto(Csv) csv = {0};
    Header header = {0};
    if (!csv_begin(draft->file, text, length, &csv, error) || !read_header(&csv, fields, draft, &header, error)) return FALSE;
    while (csv_next(&csv, error)) {
        if (csv.fields->len == 0) return TRUE;
        if (!read_line(&csv, &header, fields, draft, error)) return FALSE;
    }
    return FALSE;
}

/* ------------------------------------------------------------------------------------------------------------------ writing */

static void append_number(GString *into, double number, char behind)
{
    char buffer[NUMBER_ROOM];
    g_string_append_printf(into, "%s%c", number_format(buffer, number), behind);
}

static void append_place(GString *into, const char *role, tdsp_point place)
{
    g_string_append_printf(into, "%s,", role);
    append_number(into, place.x, ',');
    append_number(into, place.y, ',');
}

static void warn_left_out(const char *file, const SceneDescription *scene)
{
    const gboolean units = *scene->length_unit || *scene->time_unit, name = *scene->name != '\0', earth = scene->georeference.known;
    const char *const has[] = {name ? "its name" : NULL, units ? "its units" : NULL, earth ? "its georeference" : NULL};
    g_autoptr(GString) list = g_string_new(NULL);
    for (gsize i = 0; i < G_N_ELEMENTS(has); i++)
        if (has[i]) g_string_append_printf(list, "%s%s", list->len > 0 ? ", " : "", has[i]);
    if (list->len > 0) cli_warn("%s: CSV has no place for %s; --scene brings them back", file, list->str);
}

gboolean convert_csv_scene(const char *file, const SceneDescription *scene, GString *into, GError **error)
{
    const tdsp_journey *journey = &scene->journey;
    g_string_append(into, "role,x,y,radius,growth,speed\n");
    append_place(into, "source", journey->source);
    append_number(into, journey->radius, ',');
    g_string_append_c(into, ',');
    append_number(into, journey->speed, '\n');
    append_place(into, "destination", journey->destination);
    g_string_append(into, ",,\n");
    for (guint i = 0; i < scene->discs->len; i++) {
        const tdsp_growing_disc *disc = &g_array_index(scene->discs, tdsp_growing_disc, i);
        double rate;
        if (!growth_json_is_rate(&disc->growth, &rate))
            return cli_fail(error, CLI_INPUT, "%s: discs[%u].growth: CSV holds one rate a disc (GeoJSON holds laws)", file, i);
        append_place(into, "disc", disc->center);
        append_number(into, disc->radius, ',');
        append_number(into, rate, ',');
        g_string_append_c(into, '\n');
    }
    warn_left_out(file, scene);
    return TRUE;
}

static void append_point(const ConvertPath *path, const PathPoint *point, GString *into)
{
    char instant[INSTANT_ROOM];
    const tdsp_leg *leg = convert_leg(path, point);
    append_number(into, point->time, ',');
    append_number(into, point->place.x, ',');
    append_number(into, point->place.y, ',');
    if (path->scene->georeference.known) {
        append_number(into, point->geo.lon, ',');
        append_number(into, point->geo.lat, ',');
    }
    if (path->epoch.known) g_string_append_printf(into, "%s,", convert_instant(instant, path, point));
    g_string_append_printf(into, "%u,%s,", point->leg, leg->kind == TDSP_LEG_LINE ? "line" : "arc");
    if (leg->kind != TDSP_LEG_LINE) g_string_append_printf(into, "%u", leg->disc);
    g_string_append_c(into, '\n');
}

void convert_csv_path(const ConvertPath *path, GString *into)
{
    g_string_append_printf(into, "time,x,y,%s%sleg,type,disc\n", path->scene->georeference.known ? "lon,lat," : "", path->epoch.known ? "instant," : "");
    for (guint i = 0; i < path->points->points->len; i++) append_point(path, &g_array_index(path->points->points, PathPoint, i), into);
}
