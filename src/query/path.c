/* SPDX-License-Identifier: MIT */
/*
 * The path that answers a departure.
 *
 * Monotone in travel, the path of row i leaves at b_i; moved earlier by b_i - t it leaves at t, and stays safe. A time s of
 * the stored path becomes t + (s - b_i): exactly t at the start, s itself for t = b_i, and in the same order, since each step rounds
 * monotonically. The end is at most the certified arrival; where rounding would take it past, it is cut to it.
 * Monotone in arrival, the robot waits until b_i and the stored path serves as it is.
 */
#include <math.h>

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

static tdsp_status path_find(const tdsp_table *table, double departure, query_path *out)
{
    uint64_t row;
    tdsp_status status = tdsp_table_find(table, departure, &row);
    if (status != TDSP_OK) return status;
    out->stored = table_row_path(table, row);
    out->departure = table_departure(table, row);
    out->moved_to = table->monotone == TDSP_MONOTONE_TRAVEL ? departure : out->departure;
    out->latest = outward_add_up(out->moved_to, table_left(table, row));
    return TDSP_OK;
}

static double path_moved(const query_path *path, double time)
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
    if (!out) return TDSP_INVALID_ARGUMENT;
    tdsp_status status = path_find(table, departure, &path);
    if (status != TDSP_OK) return status;
    if (leg >= path.stored.legs) return TDSP_NO_ANSWER;
    path_leg(table, &path, leg, out);
    return TDSP_OK;
}

tdsp_status tdsp_table_path(const tdsp_table *table, double departure, tdsp_leg *legs, size_t capacity, size_t *count)
{
    query_path path;
    if (!count || (!legs && capacity > 0)) return TDSP_INVALID_ARGUMENT;
    tdsp_status status = path_find(table, departure, &path);
    if (status != TDSP_OK) return status;
    *count = (size_t)path.stored.legs;
    if (*count > capacity) return TDSP_BUFFER_TOO_SMALL;
    for (size_t i = 0; i < *count; i++) path_leg(table, &path, i, &legs[i]);
    return TDSP_OK;
}

/* Invariant: leg `low` is the first or starts at `time` or before; leg `high` is past the end or starts after it. */
tdsp_status tdsp_table_position(const tdsp_table *table, double departure, double time, tdsp_point *out)
{
    query_path path;
    if (!out || !isfinite(time)) return TDSP_INVALID_ARGUMENT;
    tdsp_status status = path_find(table, departure, &path);
    if (status != TDSP_OK) return status;
    if (path.stored.legs == 0) return TDSP_NO_ANSWER;
    uint64_t low = 0;
    uint64_t high = path.stored.legs;
    while (high - low > 1) {
        uint64_t middle = low + (high - low) / 2;
        if (path_moved(&path, table_path_time(table, path.stored, middle)) <= time)
            low = middle;
        else
            high = middle;
    }
    tdsp_leg leg;
    path_leg(table, &path, low, &leg);
    *out = tdsp_leg_position(&leg, time);
    return TDSP_OK;
}
