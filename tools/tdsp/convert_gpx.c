/* SPDX-License-Identifier: MIT */
/*
 * GPX 1.1: a path as one track, every point with its instant. Degrees are written without an exponent, which the schema's decimals do not have, to 1e-10: a hundredth of a
 * millimetre.
 */
#include <math.h>
#include <string.h>

#include "cli.h"
#include "convert.h"
#include "numbers.h"

static void append_degrees(GString *into, const char *name, double degrees)
{
    char text[NUMBER_ROOM];
    g_ascii_formatd(text, sizeof text, "%.10f", degrees);
    gsize length = strlen(text);
    while (text[length - 1] == '0') length--;
    if (text[length - 1] == '.') length--;
    text[length] = '\0';
    g_string_append_printf(into, " %s=\"%s\"", name, strcmp(text, "-0") == 0 ? "0" : text);
}

/* The schema's longitudes end before 180. */
static double western(double longitude)
{
    return longitude > 180 - 5e-11 ? -180 : longitude;
}

static void append_point(const ConvertPath *path, const PathPoint *point, GString *into)
{
    char instant[INSTANT_ROOM];
    g_string_append(into, "   <trkpt");
    append_degrees(into, "lat", point->geo.lat);
    append_degrees(into, "lon", western(point->geo.lon));
    g_string_append_printf(into, "><time>%s</time></trkpt>\n", convert_instant(instant, path, point));
}

/* XML has no control characters, nor U+FFFE and U+FFFF, not even written as references. */
static void append_name(const ConvertPath *path, const char *before, GString *into)
{
    if (!*path->scene->name) return;
    GString *plain = cli_plain(path->scene->name, strlen(path->scene->name), "");
    g_string_replace(plain, "\xef\xbf\xbe", "\xef\xbf\xbd", 0);
    g_string_replace(plain, "\xef\xbf\xbf", "\xef\xbf\xbd", 0);
    g_autofree char *escaped = g_markup_escape_text(plain->str, (gssize)plain->len);
    g_string_append_printf(into, "%s<name>%s</name>\n", before, escaped);
    g_string_free(plain, TRUE);
}

void convert_gpx_path(const ConvertPath *path, GString *into)
{
    g_string_append_printf(into,
                           "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
                           "<gpx version=\"1.1\" creator=\"tdsp %s\" xmlns=\"http://www.topografix.com/GPX/1/1\""
                           " xmlns:xsi=\"http://www.w3.org/2001/XMLSchema-instance\""
                           " xsi:schemaLocation=\"http://www.topografix.com/GPX/1/1 http://www.topografix.com/GPX/1/1/gpx.xsd\">\n <trk>\n",
                           tdsp_version());
    append_name(path, "  ", into);
    g_string_append(into, "  <trkseg>\n");
    for (guint i = 0; i < path->points->points->len; i++) append_point(path, &g_array_index(path->points->points, PathPoint, i), into);
    g_string_append(into, "  </trkseg>\n </trk>\n</gpx>\n");
}
