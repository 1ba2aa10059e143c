/* SPDX-License-Identifier: MIT */
/*
 * Bounded reads of an opened table.
 *
 * Rows are read without a check: their three sections were measured against the length when the table was opened, and the caller's row is
 * below table->rows. Every other place is kept inside the length as it is read, and indices that stand in the bytes themselves are
 * checked at each use as well as at opening, so that no read leaves the buffer even when the bytes change afterwards, as a mapped file's can.
 * Places are added up as offsets, and halving takes the mean of its ends: so each stays within the bounds of what it is made of, which
 * is what tests/proof needs to see.
 */
#ifndef TABLE_READ_H
#define TABLE_READ_H

#include "base/bytes.h"
#include "table/format.h"
#include "tdsp/table.h"

static inline double table_departure(const tdsp_table *table, uint64_t row)
{
    return bytes_get_f64(table->bytes + (table->departures + 8 * row));
}

/* The bits of doubles that are not negative are in the order of the doubles, and whole numbers compare faster. */
static inline uint64_t table_departure_bits(const tdsp_table *table, uint64_t row)
{
    return bytes_get_u64(table->bytes + (table->departures + 8 * row));
}

static inline double table_left(const tdsp_table *table, uint64_t row)
{
    return bytes_get_f64(table->bytes + (table->left + 8 * row));
}

static inline double table_right(const tdsp_table *table, uint64_t row)
{
    return bytes_get_f64(table->bytes + (table->right + 8 * row));
}

/* `size` bytes of the table, at most a header's, from offset `at` on; the header's first instead of any outside. */
static inline const unsigned char *table_at(const tdsp_table *table, uint64_t at, uint64_t size)
{
    return table->bytes + (at <= table->length - size ? at : 0);
}

static inline double table_header_f64(const tdsp_table *table, size_t at)
{
    return bytes_get_f64(table->bytes + at);
}

static inline uint32_t table_header_u32(const tdsp_table *table, size_t at)
{
    return bytes_get_u32(table->bytes + at);
}

/* Why there is no answer after the last departure. */
tdsp_status table_last_reason(const tdsp_table *table);

/* The entries of a row and of the next in the index of waypoints, in that of opaque bytes; any bytes where there is none. */
static inline const unsigned char *table_waypoint_bounds(const tdsp_table *table, uint64_t row)
{
    return table_at(table, table->first_waypoint + 4 * row, 8);
}

static inline const unsigned char *table_opaque_bounds(const tdsp_table *table, uint64_t row)
{
    return table_at(table, table->first_byte + 8 * row, 16);
}

static inline const unsigned char *table_waypoint(const tdsp_table *table, uint64_t waypoint)
{
    return table_at(table, table->waypoints + FORMAT_WAYPOINT_SIZE * waypoint, FORMAT_WAYPOINT_SIZE);
}

static inline const unsigned char *table_arc(const tdsp_table *table, uint64_t arc)
{
    return table_at(table, table->arcs + FORMAT_ARC_SIZE * arc, FORMAT_ARC_SIZE);
}

static inline const unsigned char *table_curve(const tdsp_table *table, uint64_t curve)
{
    return table_at(table, table->curves + FORMAT_CURVE_SIZE * curve, FORMAT_CURVE_SIZE);
}

static inline tdsp_point table_point(const unsigned char *p)
{
    tdsp_point point = {bytes_get_f64(p), bytes_get_f64(p + 8)};
    return point;
}

/* The row of gap i < table->gap_count, and the gap. */
uint64_t table_gap_row(const tdsp_table *table, uint64_t i);
tdsp_gap table_gap(const tdsp_table *table, uint64_t i);

/* The waypoints of a row's path, first to before end. */
typedef struct table_path {
    uint32_t first;
    uint32_t legs; /* 0: no path */
} table_path;

table_path table_row_path(const tdsp_table *table, uint64_t row);

/* The waypoints at which leg `leg` < path.legs starts and ends. */
static inline const unsigned char *table_leg_from(const tdsp_table *table, table_path path, uint64_t leg)
{
    return table_waypoint(table, path.first + leg * table->joint);
}

static inline const unsigned char *table_leg_to(const tdsp_table *table, table_path path, uint64_t leg)
{
    return table_waypoint(table, path.first + leg * table->joint + 1);
}

static inline double table_waypoint_time(const unsigned char *waypoint)
{
    return bytes_get_f64(waypoint + FORMAT_WAYPOINT_AT_TIME);
}

static inline tdsp_point table_waypoint_point(const unsigned char *waypoint)
{
    return table_point(waypoint + FORMAT_WAYPOINT_AT_X);
}

/* The kind of a leg whose waypoint names this arc; curves are numbered behind the arcs. */
uint32_t table_arc_kind(const tdsp_table *table, uint64_t arc);

/* Leg `leg` < path.legs. */
void table_path_leg(const tdsp_table *table, table_path path, uint64_t leg, tdsp_leg *out);

/* Curve `curve` < table->curve_count, put into a leg whose ends it leaves alone. */
void table_add_curve(const tdsp_table *table, uint64_t curve, tdsp_leg *leg);

#endif
