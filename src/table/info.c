/* SPDX-License-Identifier: MIT */
/* The header, as the caller sees it. */
#include "table/guide.h"

static tdsp_point info_point(const tdsp_table *table, size_t at)
{
    tdsp_point point = {table_header_f64(table, at), table_header_f64(table, at + 8)};
    return point;
}

static void info_unit(const tdsp_table *table, size_t at, char unit[FORMAT_UNIT_SIZE])
{
    memcpy(unit, table->bytes + at, FORMAT_UNIT_SIZE);
    unit[FORMAT_UNIT_SIZE - 1] = 0;
}

tdsp_status tdsp_table_get_info(const tdsp_table *table, tdsp_table_info *out)
{
    if (!table || !table->bytes || !out) return TDSP_INVALID_ARGUMENT;
    out->version_major = bytes_get_u16(table->bytes + FORMAT_AT_MAJOR);
    out->version_minor = bytes_get_u16(table->bytes + FORMAT_AT_MINOR);
    out->monotone = table->monotone;
    out->guarantee = table_header_u32(table, FORMAT_AT_GUARANTEE);
    out->sampling = table_header_u32(table, FORMAT_AT_SAMPLING);
    out->rows = table->rows;
    out->legs = bytes_get_u64(table->bytes + FORMAT_AT_LEGS);
    out->length = table->length;
    out->scene_hash = bytes_get_u64(table->bytes + FORMAT_AT_SCENE_HASH);
    out->epsilon = table_header_f64(table, FORMAT_AT_EPSILON);
    out->delta = table_header_f64(table, FORMAT_AT_DELTA);
    out->error = table_header_f64(table, FORMAT_AT_ERROR);
    out->time_scale = table_header_f64(table, FORMAT_AT_TIME_SCALE);
    out->speed = table_header_f64(table, FORMAT_AT_SPEED);
    out->source = info_point(table, FORMAT_AT_SOURCE);
    out->destination = info_point(table, FORMAT_AT_DESTINATION);
    out->first_lower = table_header_f64(table, FORMAT_AT_FIRST_LOWER);
    out->first_departure = table_header_f64(table, FORMAT_AT_FIRST_DEPARTURE);
    out->last_departure = table_header_f64(table, FORMAT_AT_LAST_DEPARTURE);
    out->last_reason = table_last_reason(table);
    info_unit(table, FORMAT_AT_LENGTH_UNIT, out->length_unit);
    info_unit(table, FORMAT_AT_TIME_UNIT, out->time_unit);
    out->guide_length = guide_size(table->by_departure.cells) + guide_size(table->by_arrival.cells);
    out->curves = table->curve_count;
    out->gaps = table->gap_count;
    return TDSP_OK;
}
