/* SPDX-License-Identifier: MIT */
/* A path as points in time, dense enough that going straight from one to the next is the path within a tolerance. */
#ifndef PATH_POINTS_H
#define PATH_POINTS_H

#include <glib.h>

#include "georeference.h"
#include "path_json.h"

#define PATH_POINTS_MOST 1000000
#define PATH_POINTS_FINEST 1e-6 /* m: a tolerance that degrees can keep */

typedef struct PathPoint {
    double time;
    tdsp_point place;
    GeoPlace geo; /* where there is a georeference */
    guint leg;    /* that the robot comes on; 0 for the first point */
} PathPoint;

typedef struct PathPoints {
    GArray *points; /* of PathPoint */
    double tolerance;
    double extent; /* m: how far from the origin they reach at most; 0 without a georeference */
} PathPoints;

/* An error where times run backwards or legs do not join. */
gboolean path_points_check(const char *file, const PathFile *path, GError **error);

/*
 * The points of a path: both ends of every leg, and between them as many as `tolerance` (a length; 0: a hundred thousandth of the path's length) asks
 * for. Moving evenly from point to point, in the plane and, where `geo` is known, along longitude and latitude, one is at any time no farther from the robot.
 * `metres` is the unit of length.
 */
gboolean path_points_make(const char *file, const PathFile *path, const Georeference *geo, double metres, double tolerance, PathPoints *out,
                          GError **error);

void path_points_clear(PathPoints *points);
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC(PathPoints, path_points_clear)

#endif
