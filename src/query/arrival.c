/* SPDX-License-Identifier: MIT */
/* When does a departure arrive? Find its row, and take the bounds of arrival.h. */
#include "query/arrival.h"
#include "query/locate.h"

#define ARRIVAL_INFINITY (UINT64_C(0x7ff) << 52) /* its bits: over those are NaN and what is negative */

/* What is asked less often: departure 0, one after the last, one that is none, of a table that was never opened. */
static tdsp_status arrival_find_outside(const tdsp_table *table, double departure, uint64_t *row)
{
    uint64_t bits = locate_bits(departure);
    int zero = bits << 1 == 0;
    if (!table->bytes || (!zero && bits > ARRIVAL_INFINITY)) return TDSP_INVALID_ARGUMENT;
    if (!zero) return table_last_reason(table);
    *row = 0;
    return TDSP_OK;
}

tdsp_status tdsp_table_find(const tdsp_table *table, double departure, uint64_t *row)
{
    if (!table || !row) return TDSP_INVALID_ARGUMENT;
    if (!locate_is_inside(table, departure)) return arrival_find_outside(table, departure, row);
    if (!locate_by_guide(table)) return locate_rest(table, 0, 0, departure, row);
    uint64_t cell = locate_cell(table, departure);
    uint64_t start = locate_start(table, cell);
    if (start >= table->rows || !locate_answers(table, start, departure)) return locate_rest(table, cell, start, departure, row);
    *row = start;
    return TDSP_OK;
}

static inline tdsp_status arrival_bounds(const tdsp_table *table, uint64_t row, double departure, double *lower, double *upper)
{
    if (lower) *lower = arrival_lower(table, row, departure);
    if (upper) *upper = arrival_upper(table, row, departure);
    return TDSP_OK;
}

/* Apart, and called last, so that the likely way has nothing to save and restore. */
static tdsp_status arrival_search(const tdsp_table *table, double departure, double *lower, double *upper)
{
    uint64_t row = 0;
    tdsp_status status = tdsp_table_find(table, departure, &row);
    return status == TDSP_OK ? arrival_bounds(table, row, departure, lower, upper) : status;
}

tdsp_status tdsp_table_arrival(const tdsp_table *table, double departure, double *lower, double *upper)
{
    if (!table) return TDSP_INVALID_ARGUMENT;
    if (!locate_is_inside(table, departure) || !locate_by_guide(table)) return arrival_search(table, departure, lower, upper);
    uint64_t start = locate_start(table, locate_cell(table, departure));
    if (start >= table->rows || !locate_answers(table, start, departure)) return arrival_search(table, departure, lower, upper);
    return arrival_bounds(table, start, departure, lower, upper);
}
