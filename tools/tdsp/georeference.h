/* SPDX-License-Identifier: MIT */
/*
 * Where a scene's plane lies on the earth: the azimuthal equidistant projection of WGS84 about a stated origin. Distance and direction of every place from the
 * origin are exact; x points east there and y north. Any other distance in the plane is never shorter than on the ellipsoid, and longer by the share of
 * georeference_distortion() at most.
 */
#ifndef GEOREFERENCE_H
#define GEOREFERENCE_H

#include <glib.h>

#include "geodesic.h"
#include "json_out.h"
#include "json_read.h"
#include "tdsp/types.h"

#define GEOREFERENCE_WARN 500e3    /* m from the origin: over a thousandth of distortion */
#define GEOREFERENCE_REFUSE 1500e3 /* m: nearly a hundredth */

typedef struct Georeference {
    gboolean known;
    GeoPlace origin;
} Georeference;

/* A place in the plane, in units of `metres` metres. FALSE beyond GEOREFERENCE_REFUSE from the origin. */
gboolean georeference_forward(const Georeference *geo, double metres, GeoPlace place, tdsp_point *point);
GeoPlace georeference_inverse(const Georeference *geo, double metres, tdsp_point point);

/*
 * An origin for places: the middle of them as directions in space, so that neither the antimeridian nor a pole is anything special, rounded to 1e-4 degrees
 * so that it can be stated. NULL, or why there is none.
 */
const char *georeference_about(const GeoPlace *places, gsize count, Georeference *geo);

/* The largest share by which a distance between places within `extent` metres of the origin is too long in the plane. */
double georeference_distortion(double extent);

/* Warn of, or refuse, what reaches `extent` metres from the origin. `what` is what reaches there. */
gboolean georeference_fits(const char *what, double extent, GError **error);

/* The member `georeference` of a scene: {"origin": [lon, lat], "projection": "azimuthal equidistant", "ellipsoid": "WGS84"}. */
gboolean georeference_read(const JsonValue *value, Georeference *geo, GHashTable *warned, GError **error);
void georeference_write(const Georeference *geo, JsonOut *out);

#endif
