/* SPDX-License-Identifier: MIT */
/*
 * When does a departure arrive, in floats? As in arrival.h, with each time and each sum rounded outward to a float.
 *
 * The departure is a float, so it is one moment, also as a double, and its row is exact. The bounds are then a few roundings wider.
 */
#include "query/single.h"

#include "table/read.h"
#include "tdsp/table.h"

static uint32_t single_lower(const tdsp_table *table, uint64_t row, double departure)
{
    if (row == 0) return single_narrow(table_header_f64(table, FORMAT_AT_FIRST_LOWER), 0);
    uint32_t right = single_narrow(table_right(table, row - 1), 0);
    uint32_t at = single_narrow(departure, 0);
    if (table->monotone == TDSP_MONOTONE_TRAVEL) return single_sum(at, right, 0);
    uint32_t lower = single_sum(single_narrow(table_departure(table, row - 1), 0), right, 0);
    return lower > at ? lower : at;
}

static uint32_t single_upper(const tdsp_table *table, uint64_t row, double departure)
{
    double from = table->monotone == TDSP_MONOTONE_TRAVEL ? departure : table_departure(table, row);
    return single_sum(single_narrow(from, 1), single_narrow(table_left(table, row), 1), 1);
}

tdsp_status tdsp_table_arrival_float(const tdsp_table *table, float departure, float *lower, float *upper)
{
    uint64_t row = 0;
    double wide = single_widen(departure);
    tdsp_status status = tdsp_table_find(table, wide, &row);
    if (status != TDSP_OK) return status;
    if (lower) *lower = single_of(single_lower(table, row, wide));
    if (upper) *upper = single_of(single_upper(table, row, wide));
    return TDSP_OK;
}
