/* SPDX-License-Identifier: MIT */
/*
 * When does a departure arrive, in floats? As in arrival.h, with each time and each sum rounded outward to a float.
 *
 * The departure is a float, so it is one moment, also as a double, and its row is exact. The bounds are then a few roundings wider.
 */
#include "query/single.h"

#include "table/read.h"
#include "tdsp/table.h"

/* `departure` is the float's bits, those of 0 for -0. */
static uint32_t single_lower(const tdsp_table *table, uint64_t row, uint32_t departure)
{
    if (row == 0) return single_narrow(table_header_f64(table, FORMAT_AT_FIRST_LOWER), 0);
    double right = table_right(table, row - 1);
    if (table->monotone == TDSP_MONOTONE_TRAVEL) return single_add(departure, right, 0);
    uint32_t lower = single_add(single_narrow(table_departure(table, row - 1), 0), right, 0);
    return lower > departure ? lower : departure;
}

static uint32_t single_upper(const tdsp_table *table, uint64_t row, uint32_t departure)
{
    if (table->monotone != TDSP_MONOTONE_TRAVEL) departure = single_narrow(table_departure(table, row), 1);
    return single_add(departure, table_left(table, row), 1);
}

tdsp_status tdsp_table_arrival_float(const tdsp_table *table, float departure, float *lower, float *upper)
{
    uint64_t row = 0;
    uint32_t bits = single_bits(departure) & ~(UINT32_C(1) << 31);
    tdsp_status status = tdsp_table_find(table, single_widen(departure), &row);
    if (status != TDSP_OK) return status;
    if (lower) *lower = single_of(single_lower(table, row, bits));
    if (upper) *upper = single_of(single_upper(table, row, bits));
    return TDSP_OK;
}
