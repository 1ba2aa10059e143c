/* SPDX-License-Identifier: MIT */
/*
 * The projection: a place lies in the plane where its geodesic from the origin leads, at its distance and in its direction.
 *
 * Along rays from the origin lengths are true. Across them, at the distance r, a length is too long by r / m(r), m being the reduced length, which by
 * comparison of curvatures (Rauch) is at least b sin(r / b): no curvature of the ellipsoid is over 1 / b^2. Hence the share x / sin x - 1 with x = r / b.
 */
#include "georeference.h"

#include <math.h>
#include <string.h>

#include "cli.h"
#include "numbers.h"

#define PROJECTION "azimuthal equidistant"
#define ELLIPSOID "WGS84"
#define ROUND 1e4 /* of a derived origin: parts of a degree, 11 m */

gboolean georeference_forward(const Georeference *geo, double metres, GeoPlace place, tdsp_point *point)
{
    double distance, azimuth;
    if (!geodesic_inverse(geo->origin, place, &distance, &azimuth) || !(distance <= GEOREFERENCE_REFUSE)) return FALSE;
    *point = (tdsp_point){distance / metres * sin(azimuth), distance / metres * cos(azimuth)};
    return TRUE;
}

GeoPlace georeference_inverse(const Georeference *geo, double metres, tdsp_point point)
{
    return geodesic_direct(geo->origin, atan2(point.x, point.y), hypot(point.x, point.y) * metres);
}

const char *georeference_about(const GeoPlace *places, gsize count, Georeference *geo)
{
    double x = 0, y = 0, z = 0;
    for (gsize i = 0; i < count; i++) {
        double lon = places[i].lon * G_PI / 180, lat = places[i].lat * G_PI / 180;
        x += cos(lat) * cos(lon);
        y += cos(lat) * sin(lon);
        z += sin(lat);
    }
    double across = hypot(x, y);
    if (!(hypot(across, z) > 1e-9 * (double)count)) return "the places have no middle";
    /* + 0.0: no minus in front of a zero */
    geo->origin.lon = rint(atan2(y, x) * 180 / G_PI * ROUND) / ROUND + 0.0;
    geo->origin.lat = rint(atan2(z, across) * 180 / G_PI * ROUND) / ROUND + 0.0;
    geo->known = TRUE;
    return NULL;
}

double georeference_distortion(double extent)
{
    double x = extent / GEODESIC_B;
    return x > 0 ? x / sin(x) - 1 : x;
}

gboolean georeference_fits(const char *what, double extent, GError **error)
{
    char share[NUMBER_ROOM];
    number_brief(share, 100 * georeference_distortion(extent), 2);
    if (extent > GEOREFERENCE_REFUSE)
        return cli_fail(error, CLI_INPUT, "%s reaches %.0f km from the origin, where a plane is none any more: at most %.0f km", what, extent / 1000,
                        GEOREFERENCE_REFUSE / 1000);
    if (extent > GEOREFERENCE_WARN)
        cli_warn("%s reaches %.0f km from the origin: distances in the plane are too long by up to %s %%", what, extent / 1000, share);
    return TRUE;
}

/* An optional member that can have one value only. */
static gboolean read_only(const JsonValue *object, const char *name, const char *only, GError **error)
{
    JsonValue member;
    const char *word = only;
    if (json_read_optional(object, name, &member) && !json_read_string(&member, &word, error)) return FALSE;
    return strcmp(word, only) == 0 ? TRUE : json_read_fail(&member.place, error, "must be \"%s\"", only);
}

gboolean georeference_read(const JsonValue *value, Georeference *geo, GHashTable *warned, GError **error)
{
    static const char *const known[] = {"origin", "projection", "ellipsoid", NULL};
    JsonValue origin;
    tdsp_point place;
    if (!json_read_object(value, error) || !json_read_member(value, "origin", &origin, error) || !json_read_point(&origin, &place, error) ||
        !read_only(value, "projection", PROJECTION, error) || !read_only(value, "ellipsoid", ELLIPSOID, error))
        return FALSE;
    const GeoPlace read = {place.x, place.y};
    const char *wrong = geodesic_check(read);
    if (wrong) return json_read_fail(&origin.place, error, "%s", wrong);
    json_read_warn_unknown(value, known, warned);
    *geo = (Georeference){TRUE, read};
    return TRUE;
}

void georeference_write(const Georeference *geo, JsonOut *out)
{
    json_out_begin(out, '{');
    json_out_member_point(out, "origin", (tdsp_point){geo->origin.lon, geo->origin.lat});
    json_out_member_string(out, "projection", PROJECTION);
    json_out_member_string(out, "ellipsoid", ELLIPSOID);
    json_out_end(out, '}');
}
