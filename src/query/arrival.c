/*
 * When does a departure arrive? Comparisons and additions only.
 *
 * For t in (b_(i-1), b_i]:
 *   monotone in travel    right_(i-1) <= T(b_(i-1)+) <= T(t) <= T(b_i) <= left_i. So
 *                         lower = t + right_(i-1), upper = t + left_i.
 *   monotone in arrival   b_(i-1) + right_(i-1) <= A(b_(i-1)+) <= A(t) <= A(b_i) <= b_i + left_i, and no arrival is before its
 *                         departure. So lower = max(t, b_(i-1) + right_(i-1)), upper = b_i + left_i.
 * For t = 0 = b_0 the header keeps T(0) rounded down, and upper = left_0. Sums are rounded outward.
 */
#include <math.h>

#include "query/outward.h"
#include "query/search.h"
#include "tdsp/table.h"

/* What is asked less often: departure 0, one after the last, one that is none, of a table that was never opened. */
static tdsp_status arrival_find_outside(const tdsp_table *table, double departure, uint64_t *row)
{
    if (!table->bytes || !(departure >= 0)) return TDSP_INVALID_ARGUMENT;
    if (departure > 0) return table_last_reason(table);
    *row = 0;
    return TDSP_OK;
}

tdsp_status tdsp_table_find(const tdsp_table *table, double departure, uint64_t *row)
{
    if (!table || !row) return TDSP_INVALID_ARGUMENT;
    if (!search_is_inside(table, departure)) return arrival_find_outside(table, departure, row);
    *row = search_row(table, departure);
    return TDSP_OK;
}

static inline double arrival_lower(const tdsp_table *table, uint64_t row, double departure)
{
    if (row == 0) return table_header_f64(table, FORMAT_AT_FIRST_LOWER);
    double right = table_right(table, row - 1);
    if (table->monotone == TDSP_MONOTONE_TRAVEL) return outward_add_down(departure, right);
    double lower = outward_add_down(table_departure(table, row - 1), right);
    return lower > departure ? lower : departure;
}

static inline double arrival_upper(const tdsp_table *table, uint64_t row, double departure)
{
    double from = table->monotone == TDSP_MONOTONE_TRAVEL ? departure : table_departure(table, row);
    return outward_add_up(from, table_left(table, row));
}

tdsp_status tdsp_table_arrival(const tdsp_table *table, double departure, double *lower, double *upper)
{
    uint64_t row;
    if (!table) return TDSP_INVALID_ARGUMENT;
    if (search_is_inside(table, departure))
        row = search_row(table, departure);
    else {
        tdsp_status status = arrival_find_outside(table, departure, &row);
        if (status != TDSP_OK) return status;
    }
    if (lower) *lower = arrival_lower(table, row, departure);
    if (upper) *upper = arrival_upper(table, row, departure);
    return TDSP_OK;
}
