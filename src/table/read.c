/* SPDX-License-Identifier: MIT */
/* Waypoints, arcs and curves put together to legs. With one waypoint at a joint leg k goes from waypoint k to k + 1, with two from 2k to 2k + 1. */
#include "table/read.h"

#include <math.h>

/* A reason that opening refuses can stand here only when the bytes changed since. */
tdsp_status table_last_reason(const tdsp_table *table)
{
    uint32_t stored = table_header_u32(table, FORMAT_AT_LAST_REASON);
    return stored > TDSP_OK && stored <= TDSP_UNREACHABLE ? (tdsp_status)stored : TDSP_OUTSIDE_TABLE;
}

table_path table_row_path(const tdsp_table *table, uint64_t row)
{
    table_path path = {0, 0};
    const unsigned char *p = table_waypoint_bounds(table, row);
    uint32_t first = bytes_get_u32(p);
    uint32_t end = bytes_get_u32(p + 4);
    /* Where there are no waypoints this holds whatever was read. */
    if (end > table->waypoint_count || end < (uint64_t)first + 2) return path;
    path.first = first;
    path.legs = table->joint == 1 ? end - first - 1 : (end - first) / 2;
    return path;
}

uint32_t table_arc_kind(const tdsp_table *table, uint64_t arc)
{
    if (arc < table->arc_count) return TDSP_LEG_ARC;
    return arc - table->arc_count < table->curve_count ? TDSP_LEG_CURVE : TDSP_LEG_LINE;
}

static void table_add_arc(const unsigned char *p, tdsp_leg *leg)
{
    double turned = bytes_get_f64(p + FORMAT_ARC_AT_TURNED);
    leg->kind = TDSP_LEG_ARC;
    leg->turn = signbit(turned) ? -1 : 1;
    leg->center = table_point(p + FORMAT_ARC_AT_CENTER);
    leg->radius_from = bytes_get_f64(p + FORMAT_ARC_AT_RADIUS_FROM);
    leg->radius_to = bytes_get_f64(p + FORMAT_ARC_AT_RADIUS_TO);
    leg->angle_from = bytes_get_f64(p + FORMAT_ARC_AT_ANGLE_FROM);
    leg->sweep = fabs(turned);
}

/* A curve begins as an arc. */
void table_add_curve(const tdsp_table *table, uint64_t curve, tdsp_leg *leg)
{
    const unsigned char *p = table_curve(table, curve);
    table_add_arc(p, leg);
    leg->kind = TDSP_LEG_CURVE;
    leg->rate_from = bytes_get_f64(p + FORMAT_CURVE_AT_RATE_FROM);
    leg->rate_to = bytes_get_f64(p + FORMAT_CURVE_AT_RATE_TO);
    leg->bend_from = bytes_get_f64(p + FORMAT_CURVE_AT_BEND_FROM);
    leg->bend_to = bytes_get_f64(p + FORMAT_CURVE_AT_BEND_TO);
    leg->speed = bytes_get_f64(p + FORMAT_CURVE_AT_SPEED);
}

void table_path_leg(const tdsp_table *table, table_path path, uint64_t leg, tdsp_leg *out)
{
    const unsigned char *from = table_leg_from(table, path, leg), *to = table_leg_to(table, path, leg);
    memset(out, 0, sizeof *out);
    out->kind = TDSP_LEG_LINE;
    out->disc = bytes_get_u32(from + FORMAT_WAYPOINT_AT_DISC);
    out->start_time = table_waypoint_time(from);
    out->end_time = table_waypoint_time(to);
    out->from = table_waypoint_point(from);
    out->to = table_waypoint_point(to);
    uint64_t arc = bytes_get_u32(from + FORMAT_WAYPOINT_AT_ARC);
    uint32_t kind = table_arc_kind(table, arc);
    if (kind == TDSP_LEG_ARC) table_add_arc(table_arc(table, arc), out);
    if (kind == TDSP_LEG_CURVE) table_add_curve(table, arc - table->arc_count, out);
}

static const unsigned char *table_gap_at(const tdsp_table *table, uint64_t i)
{
    return table_at(table, table->gaps + FORMAT_GAP_SIZE * i, FORMAT_GAP_SIZE);
}

uint64_t table_gap_row(const tdsp_table *table, uint64_t i)
{
    return bytes_get_u64(table_gap_at(table, i) + FORMAT_GAP_AT_ROW);
}

tdsp_gap table_gap(const tdsp_table *table, uint64_t i)
{
    const unsigned char *p = table_gap_at(table, i);
    tdsp_gap gap = {bytes_get_u32(p + FORMAT_GAP_AT_FIRST), bytes_get_u32(p + FORMAT_GAP_AT_SECOND), bytes_get_f64(p + FORMAT_GAP_AT_TIME),
                    {bytes_get_f64(p + FORMAT_GAP_AT_PLACE), bytes_get_f64(p + FORMAT_GAP_AT_PLACE + 8)}};
    return gap;
}
