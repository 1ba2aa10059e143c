/* SPDX-License-Identifier: MIT */
/*
 * Points by halving: a stretch of a leg is two points when, a quarter, half and three quarters of its time on, going straight is within the tolerance, and two stretches
 * otherwise. The deviation of a smooth motion over a short time is a parabola with its greatest value at the half, plus a cubic whose greatest value is within
 * 3 % of that at a quarter; so nine tenths of the tolerance at the three places are the tolerance everywhere. Stretches begin short of half a radian.
 */
#include "path_points.h"

#include <math.h>

#include "cli.h"
#include "tdsp/path.h"

#define SHORT 0.5        /* rad that a stretch of an arc turns at most */
#define KEPT 0.9         /* of the tolerance */
#define DEFAULT_SHARE 1e-5
#define JOIN 1e-6        /* of the path's size or duration: legs that are farther apart do not join */

typedef struct Sampler {
    const Georeference *geo;
    double metres, tolerance;
    const tdsp_leg *leg;
    guint number;
    gboolean lost; /* the robot was nowhere, or too far away */
    PathPoints *out;
} Sampler;

static PathPoint point_at(const Sampler *s, double time, tdsp_point place)
{
    PathPoint point = {.time = time, .place = place, .leg = s->number};
    if (s->geo->known) point.geo = georeference_inverse(s->geo, s->metres, place);
    return point;
}

static double apart(tdsp_point a, tdsp_point b)
{
    return hypot(a.x - b.x, a.y - b.y);
}

static gboolean is_somewhere(const Sampler *s, tdsp_point robot)
{
    return isfinite(robot.x + robot.y) && !(s->geo->known && hypot(robot.x, robot.y) * s->metres > GEOREFERENCE_REFUSE);
}

/* How far from the robot one is, having gone straight for the share `x` of the time between two points. */
static double deviation(Sampler *s, const PathPoint *from, const PathPoint *to, double x)
{
    tdsp_point robot = tdsp_leg_position(s->leg, from->time + (to->time - from->time) * x), laid;
    s->lost = s->lost || !is_somewhere(s, robot);
    if (s->lost) return 0;
    tdsp_point straight = {from->place.x + (to->place.x - from->place.x) * x, from->place.y + (to->place.y - from->place.y) * x};
    double off = apart(robot, straight);
    if (!s->geo->known) return off;
    GeoPlace between = {geodesic_turned(from->geo.lon + geodesic_turned(to->geo.lon - from->geo.lon) * x), from->geo.lat + (to->geo.lat - from->geo.lat) * x};
    if (!georeference_forward(s->geo, s->metres, between, &laid)) return INFINITY;
    return fmax(off, apart(robot, laid));
}

static double farthest(Sampler *s, const PathPoint *from, const PathPoint *to)
{
    return fmax(deviation(s, from, to, 0.5), fmax(deviation(s, from, to, 0.25), deviation(s, from, to, 0.75)));
}

/* A point at the time of the one before is where a leg begins that begins where the last one ended. FALSE when there are too many. */
static gboolean add(const Sampler *s, const PathPoint *point)
{
    GArray *points = s->out->points;
    const PathPoint *last = points->len > 0 ? &g_array_index(points, PathPoint, points->len - 1) : NULL;
    if (last && last->time == point->time) return TRUE;
    if (points->len == PATH_POINTS_MOST) return FALSE;
    g_array_append_vals(points, point, 1);
    return TRUE;
}

/* The points behind `from`, up to `to`. Halving ends where time has no number in between any more. */
static gboolean add_stretch(Sampler *s, const PathPoint *from, const PathPoint *to)
{
    double middle = from->time + (to->time - from->time) / 2;
    if (!(from->time < middle && middle < to->time) || farthest(s, from, to) <= KEPT * s->tolerance) return add(s, to);
    PathPoint half = point_at(s, middle, tdsp_leg_position(s->leg, middle));
    return add_stretch(s, from, &half) && add_stretch(s, &half, to);
}

static gboolean add_leg(Sampler *s)
{
    const tdsp_leg *leg = s->leg;
    double stretches = fmax(1, ceil(leg->sweep / SHORT)), duration = leg->end_time - leg->start_time;
    PathPoint from = point_at(s, leg->start_time, leg->from);
    if (!(stretches <= PATH_POINTS_MOST) || !add(s, &from)) return FALSE;
    for (double i = 1; i <= stretches; i++) {
        double time = leg->start_time + duration * (i / stretches);
        PathPoint to = i < stretches ? point_at(s, time, tdsp_leg_position(leg, time)) : point_at(s, leg->end_time, leg->to);
        if (!add_stretch(s, &from, &to) || s->lost) return FALSE;
        from = to;
    }
    return TRUE;
}

static const tdsp_leg *leg_at(const PathFile *path, guint i)
{
    return &g_array_index(path->legs, tdsp_leg, i);
}

/* The length of the way, arcs by their mean radius. */
static double way(const PathFile *path)
{
    double sum = 0;
    for (guint i = 0; i < path->legs->len; i++) {
        const tdsp_leg *leg = leg_at(path, i);
        sum += fmax(apart(leg->from, leg->to), leg->sweep * (leg->radius_from + leg->radius_to) / 2);
    }
    return sum;
}

/* How far from the origin of the plane a path may get at most. */
static double reach(const PathFile *path)
{
    const tdsp_point origin = {0, 0};
    double most = 0;
    for (guint i = 0; i < path->legs->len; i++) {
        const tdsp_leg *leg = leg_at(path, i);
        double arc = leg->kind == TDSP_LEG_LINE ? 0 : apart(origin, leg->center) + fmax(leg->radius_from, leg->radius_to);
        most = fmax(most, fmax(arc, fmax(apart(origin, leg->from), apart(origin, leg->to))));
    }
    return most;
}

static gboolean fail_leg(const char *file, guint i, const char *what, GError **error)
{
    return cli_fail(error, CLI_INPUT, "%s: legs[%u]: %s", file, i, what);
}

static gboolean check_radii(const char *file, const PathFile *path, GError **error)
{
    for (guint i = 0; i < path->legs->len; i++) {
        const tdsp_leg *leg = leg_at(path, i);
        if (leg->kind != TDSP_LEG_LINE && !(leg->radius_from > 0 && leg->radius_to > 0)) return fail_leg(file, i, "radii must be over zero", error);
    }
    return TRUE;
}

gboolean path_points_check(const char *file, const PathFile *path, GError **error)
{
    if (!check_radii(file, path, error)) return FALSE;
    const double size = way(path), lasts = path->arrival - path->departure;
    double time = path->departure;
    if (!isfinite(size)) return cli_fail(error, CLI_INPUT, "%s: a path without a finite length", file);
    for (guint i = 0; i < path->legs->len; i++) {
        const tdsp_leg *leg = leg_at(path, i);
        if (!(leg->end_time >= leg->start_time)) return fail_leg(file, i, "ends before it starts", error);
        if (!(fabs(leg->start_time - time) <= JOIN * lasts)) return fail_leg(file, i, "does not start when the one before ends", error);
        if (i > 0 && !(apart(leg->from, leg_at(path, i - 1)->to) <= JOIN * size)) return fail_leg(file, i, "does not start where the one before ends", error);
        if (leg->end_time == leg->start_time && !(apart(leg->from, leg->to) <= JOIN * size)) return fail_leg(file, i, "takes no time to get elsewhere", error);
        time = leg->end_time;
    }
    return TRUE;
}

static gboolean add_legs(Sampler *s, const PathFile *path)
{
    for (s->number = 0; s->number < path->legs->len; s->number++) {
        s->leg = leg_at(path, s->number);
        if (!add_leg(s)) return FALSE;
    }
    return TRUE;
}

gboolean path_points_make(const char *file, const PathFile *path, const Georeference *geo, double metres, double tolerance, PathPoints *out,
                          GError **error)
{
    if (!path_points_check(file, path, error)) return FALSE;
    const double finest = geo->known ? PATH_POINTS_FINEST / metres : 0;
    PathPoints made = {.tolerance = tolerance > 0 ? tolerance : fmax(finest, way(path) * DEFAULT_SHARE), .extent = geo->known ? reach(path) * metres : 0};
    if (made.tolerance < finest) return cli_fail(error, CLI_USAGE, "--tolerance: on the earth at least a micrometre");
    if (!georeference_fits(file, made.extent, error)) return FALSE;
    made.points = g_array_new(FALSE, FALSE, sizeof(PathPoint));
    Sampler s = {.geo = geo, .metres = metres, .tolerance = made.tolerance, .out = &made};
    if (!add_legs(&s, path)) {
        path_points_clear(&made);
        if (s.lost) return fail_leg(file, s.number, "leads out of the plane", error);
        return cli_fail(error, CLI_INPUT, "%s: more than %d points within the tolerance (--tolerance allows more)", file, PATH_POINTS_MOST);
    }
    *out = made;
    return TRUE;
}

void path_points_clear(PathPoints *points)
{
    g_clear_pointer(&points->points, g_array_unref);
}
