/* SPDX-License-Identifier: MIT */
/* Geodesics on the WGS84 ellipsoid: how far and in which direction one place is from another, and where one gets. */
#ifndef GEODESIC_H
#define GEODESIC_H

#include <glib.h>

#define GEODESIC_A 6378137.0             /* the ellipsoid's equatorial radius, m */
#define GEODESIC_F (1 / 298.257223563)   /* its flattening */
#define GEODESIC_B (GEODESIC_A * (1 - GEODESIC_F))

/* Degrees: longitude from -180 to 180, latitude from -90 to 90. */
typedef struct GeoPlace {
    double lon, lat;
} GeoPlace;

/* NULL, or what is wrong with it. */
const char *geodesic_check(GeoPlace place);

/*
 * The distance in metres, and the direction in which one leaves, in radians clockwise from north. FALSE for places so nearly
 * opposite that the iteration does not settle.
 */
gboolean geodesic_inverse(GeoPlace from, GeoPlace to, double *distance, double *azimuth);

/* Where one gets from `from` in the direction `azimuth` after `distance` metres. */
GeoPlace geodesic_direct(GeoPlace from, double azimuth, double distance);

/* A longitude, or a difference of two, brought into -180 to 180. */
double geodesic_turned(double degrees);

#endif
