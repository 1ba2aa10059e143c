/* SPDX-License-Identifier: MIT */
/*
 * The path that answers a departure.
 *
 * Monotone in travel, the path of row i leaves at b_i; moved earlier by b_i - t it leaves at t, and stays safe. A time s of
 * the stored path becomes t + (s - b_i): exactly t at the start, s itself for t = b_i, and in the same order, since each step rounds
 * monotonically. The end is at most the certified arrival; where rounding would take it past, it is cut to it.
 * Monotone in arrival, the robot waits until b_i and the stored path serves as it is.
 *
 * For a place the numbers of its leg are read where they lie, each when it is needed: a whole leg would be most of the stack that a small machine has to spare.
 */
#include <math.h>

#include "base/apart.h"
#include "geom/path.h"
#include "query/locate.h"
#include "query/outward.h"
#include "tdsp/path.h"
#include "tdsp/table.h"

/* A row's path and how its times move. */
typedef struct query_path {
    table_path stored;
    double departure; /* of the row */
    double moved_to;  /* the departure asked for, or the row's where nothing moves */
    double latest;    /* the certified arrival */
} query_path;

/* Of row `row` < table->rows. */
static APART void path_of_row(query_path *path, const tdsp_table *table, uint64_t row, double departure)
{
    path->stored = table_row_path(table, row);
    path->departure = table_departure(table, row);
    path->moved_to = table->monotone == TDSP_MONOTONE_TRAVEL ? departure : path->departure;
    path->latest = outward_add_up(path->moved_to, table_left(table, row));
}

static APART double path_moved(const query_path *path, double time)
{
    if (path->moved_to == path->departure) return time;
    double moved = path->moved_to + (time - path->departure);
    return moved < path->latest ? moved : path->latest;
}

static void path_leg(const tdsp_table *table, const query_path *path, uint64_t leg, tdsp_leg *out)
{
    table_path_leg(table, path->stored, leg, out);
    out->start_time = path_moved(path, out->start_time);
    out->end_time = path_moved(path, out->end_time);
}

tdsp_status tdsp_table_leg(const tdsp_table *table, double departure, uint64_t leg, tdsp_leg *out)
{
    query_path path;
    uint64_t row;
    if (!out) return TDSP_INVALID_ARGUMENT;
    tdsp_status status = tdsp_table_find(table, departure, &row);
    if (status != TDSP_OK) return status;
    path_of_row(&path, table, row, departure);
    if (leg >= path.stored.legs) return TDSP_NO_ANSWER;
    path_leg(table, &path, leg, out);
    return TDSP_OK;
}

tdsp_status tdsp_table_path(const tdsp_table *table, double departure, tdsp_leg *legs, size_t capacity, size_t *count)
{
    query_path path;
    uint64_t row;
    if (!count || (!legs && capacity > 0)) return TDSP_INVALID_ARGUMENT;
    tdsp_status status = tdsp_table_find(table, departure, &row);
    if (status != TDSP_OK) return status;
    path_of_row(&path, table, row, departure);
    *count = (size_t)path.stored.legs;
    if (*count > capacity) return TDSP_BUFFER_TOO_SMALL;
    for (size_t i = 0; i < *count; i++) path_leg(table, &path, i, &legs[i]);
    return TDSP_OK;
}

/* Where a robot is on its path: the share x of the time from one waypoint to the next has passed, or it is at `from`, and the duration is 0. */
typedef struct path_span {
    const unsigned char *from;
    const unsigned char *to;
    double duration;
    double x;
} path_span;

/* The last leg that starts at `time` or before, or the first. Invariant: leg `low` is that or earlier; leg `high` is past the end or starts after `time`. */
static APART uint32_t path_leg_at(const tdsp_table *table, const query_path *path, double time)
{
    uint32_t low = 0;
    uint32_t high = path->stored.legs;
    while (high - low > 1) {
        uint32_t middle = low + (high - low) / 2;
        if (path_moved(path, table_waypoint_time(table_leg_from(table, path->stored, middle))) <= time)
            low = middle;
        else
            high = middle;
    }
    return low;
}

static APART void path_read_line(const path_span *span, tdsp_point *out)
{
    tdsp_point from = table_waypoint_point(span->from), to = table_waypoint_point(span->to);
    out->x = path_between(from.x, to.x, span->x);
    out->y = path_between(from.y, to.y, span->x);
}

static APART double path_read_arc_radius(const unsigned char *arc, const path_span *span)
{
    return path_arc_distance(bytes_get_f64(arc + FORMAT_ARC_AT_RADIUS_FROM), bytes_get_f64(arc + FORMAT_ARC_AT_RADIUS_TO), span->x);
}

static APART double path_read_arc_angle(const unsigned char *arc, const path_span *span)
{
    double share = path_arc_share(bytes_get_f64(arc + FORMAT_ARC_AT_RADIUS_FROM), bytes_get_f64(arc + FORMAT_ARC_AT_RADIUS_TO), span->x);
    return bytes_get_f64(arc + FORMAT_ARC_AT_ANGLE_FROM) + bytes_get_f64(arc + FORMAT_ARC_AT_TURNED) * share;
}

static void path_read_ends(const unsigned char *curve, path_end *from, path_end *to)
{
    from->value = bytes_get_f64(curve + FORMAT_ARC_AT_RADIUS_FROM);
    from->slope = bytes_get_f64(curve + FORMAT_CURVE_AT_RATE_FROM);
    from->bend = bytes_get_f64(curve + FORMAT_CURVE_AT_BEND_FROM);
    to->value = bytes_get_f64(curve + FORMAT_ARC_AT_RADIUS_TO);
    to->slope = bytes_get_f64(curve + FORMAT_CURVE_AT_RATE_TO);
    to->bend = bytes_get_f64(curve + FORMAT_CURVE_AT_BEND_TO);
}

static APART double path_read_curve_radius(const unsigned char *curve, const path_span *span)
{
    path_end from, to;
    path_read_ends(curve, &from, &to);
    path_end_scale(&from, span->duration);
    path_end_scale(&to, span->duration);
    return path_hermite(&from, &to, span->x);
}

static APART double path_read_curve_angle(const unsigned char *curve, const path_span *span)
{
    path_end from, to;
    double turned = bytes_get_f64(curve + FORMAT_ARC_AT_TURNED);
    path_read_ends(curve, &from, &to);
    path_end_turn(&from, 0, bytes_get_f64(curve + FORMAT_CURVE_AT_SPEED), span->duration);
    path_end_turn(&to, fabs(turned), bytes_get_f64(curve + FORMAT_CURVE_AT_SPEED), span->duration);
    double angle = path_hermite(&from, &to, span->x);
    return bytes_get_f64(curve + FORMAT_ARC_AT_ANGLE_FROM) + (signbit(turned) ? -angle : angle);
}

static void path_read_span(const tdsp_table *table, const path_span *span, tdsp_point *out)
{
    double radius, angle;
    const unsigned char *p;
    uint64_t arc = bytes_get_u32(span->from + FORMAT_WAYPOINT_AT_ARC);
    switch (table_arc_kind(table, arc)) {
    case TDSP_LEG_ARC:
        p = table_arc(table, arc);
        radius = path_read_arc_radius(p, span);
        angle = path_read_arc_angle(p, span);
        break;
    case TDSP_LEG_CURVE:
        p = table_curve(table, arc - table->arc_count);
        radius = path_read_curve_radius(p, span);
        angle = path_read_curve_angle(p, span);
        break;
    default: path_read_line(span, out); return;
    }
    *out = table_point(p + FORMAT_ARC_AT_CENTER);
    path_go_around(out, radius, angle);
}

static APART tdsp_status path_span_at(const tdsp_table *table, double departure, double time, path_span *out)
{
    query_path path;
    uint64_t row;
    tdsp_status status = tdsp_table_find(table, departure, &row);
    if (status != TDSP_OK) return status;
    path_of_row(&path, table, row, departure);
    if (path.stored.legs == 0) return TDSP_NO_ANSWER;
    uint32_t leg = path_leg_at(table, &path, time);
    out->from = table_leg_from(table, path.stored, leg);
    out->to = table_leg_to(table, path.stored, leg);
    out->duration = out->x = 0;
    double start = path_moved(&path, table_waypoint_time(out->from));
    if (!(time > start)) return TDSP_OK;
    double end = path_moved(&path, table_waypoint_time(out->to));
    if (time >= end) {
        out->from = out->to;
        return TDSP_OK;
    }
    out->duration = end - start;
    out->x = (time - start) / out->duration;
    return TDSP_OK;
}

tdsp_status tdsp_table_position(const tdsp_table *table, double departure, double time, tdsp_point *out)
{
    path_span span;
    if (!out || !isfinite(time)) return TDSP_INVALID_ARGUMENT;
    tdsp_status status = path_span_at(table, departure, time, &span);
    if (status != TDSP_OK) return status;
    if (span.duration > 0)
        path_read_span(table, &span, out);
    else
        *out = table_waypoint_point(span.from);
    return TDSP_OK;
}
