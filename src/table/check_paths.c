/* SPDX-License-Identifier: MIT */
/*
 * Paths and opaque bytes: each row's part follows the part of the row before, and a path starts at the row's departure, runs
 * forward in time, and is over by the arrival that the row certifies.
 */
#include "base/round.h"
#include "table/check.h"
#include "table/read.h"

static double check_time(const tdsp_table *table, uint64_t waypoint)
{
    return bytes_get_f64(table_waypoint(table, waypoint) + FORMAT_WAYPOINT_AT_TIME);
}

static int check_finite(const unsigned char *p, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        if (!round_is_finite(bytes_get_f64(p + 8 * i))) return 0;
    }
    return 1;
}

static int check_arcs(const tdsp_table *table)
{
    for (uint64_t i = 0; i < table->arc_count; i++) {
        const unsigned char *arc = table_arc(table, i);
        if (!check_finite(arc, FORMAT_ARC_SIZE / 8)) return 0;
        if (!(bytes_get_f64(arc + FORMAT_ARC_AT_RADIUS_FROM) > 0) || !(bytes_get_f64(arc + FORMAT_ARC_AT_RADIUS_TO) > 0))
            return 0;
    }
    return 1;
}

static int check_curves(const tdsp_table *table)
{
    for (uint64_t i = 0; i < table->curve_count; i++) {
        tdsp_leg leg = {0};
        table_add_curve(table, i, &leg);
        if (!check_curve(&leg)) return 0;
    }
    return 1;
}

/* Where no leg starts there is neither disc nor arc; a line has no disc. */
static int check_waypoint_kind(const tdsp_table *table, const unsigned char *waypoint, int starts_leg)
{
    uint32_t disc = bytes_get_u32(waypoint + FORMAT_WAYPOINT_AT_DISC);
    uint32_t arc = bytes_get_u32(waypoint + FORMAT_WAYPOINT_AT_ARC);
    if (arc == FORMAT_NONE) return disc == FORMAT_NONE;
    return starts_leg && arc < table->arc_count + table->curve_count;
}

/* A curve's polynomials depend on how long it takes. */
static int check_legs(const tdsp_table *table, uint64_t row)
{
    table_path path = table_row_path(table, row);
    for (uint64_t i = 0; i < path.legs && table->curve_count > 0; i++) {
        tdsp_leg leg;
        table_path_leg(table, path, i, &leg);
        if (leg.kind == TDSP_LEG_CURVE && !check_curve(&leg)) return 0;
    }
    return 1;
}

/* Waypoints [first, end) of a row: at a joint of two waypoints both have the same time. */
static int check_path(const tdsp_table *table, uint64_t row, uint64_t first, uint64_t end)
{
    if (first == end) return 1;
    if (end - first < 2 || (table->joint == 2 && (end - first) % 2 != 0)) return 0;
    for (uint64_t i = first; i < end; i++) {
        const unsigned char *waypoint = table_waypoint(table, i);
        int inside = table->joint == 1 || (i - first) % 2 == 0;
        int starts_leg = inside && i + 1 < end;
        if (!check_finite(waypoint, 3) || !check_waypoint_kind(table, waypoint, starts_leg)) return 0;
        if (i == first) continue;
        double before = check_time(table, i - 1);
        double time = check_time(table, i);
        if (!(before <= time) || (table->joint == 2 && inside && before != time)) return 0;
    }
    double departure = table_departure(table, row);
    return check_time(table, first) == departure && check_time(table, end - 1) <= round_add_up(departure, table_left(table, row));
}

int check_paths(const tdsp_table *table)
{
    uint64_t legs = 0;
    uint64_t end = 0;
    if (!check_arcs(table) || !check_curves(table)) return 0;
    for (uint64_t row = 0; row < table->rows && table->waypoint_count > 0; row++) {
        const unsigned char *p = table_waypoint_bounds(table, row);
        if (bytes_get_u32(p) != end || bytes_get_u32(p + 4) < end || bytes_get_u32(p + 4) > table->waypoint_count) return 0;
        if (!check_path(table, row, end, bytes_get_u32(p + 4)) || !check_legs(table, row)) return 0;
        end = bytes_get_u32(p + 4);
        legs += table_row_path(table, row).legs;
    }
    return end == table->waypoint_count && legs == bytes_get_u64(table->bytes + FORMAT_AT_LEGS);
}

int check_opaque(const tdsp_table *table)
{
    uint64_t end = 0;
    for (uint64_t row = 0; row < table->rows && table->opaque_length > 0; row++) {
        const unsigned char *p = table_opaque_bounds(table, row);
        uint64_t next = bytes_get_u64(p + 8);
        if (bytes_get_u64(p) != end || next < end || next > table->opaque_length || next - end > FORMAT_MAX_ROW_BYTES) return 0;
        end = next;
    }
    return end == table->opaque_length;
}
