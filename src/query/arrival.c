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

#include "base/round.h"
#include "query/search.h"
#include "tdsp/table.h"

tdsp_status tdsp_table_find(const tdsp_table *table, double departure, uint64_t *row)
{
    if (!table || !table->bytes || !row || !(departure >= 0)) return TDSP_INVALID_ARGUMENT;
    uint64_t found = query_row(table, departure);
    if (found == table->rows) return table_last_reason(table);
    *row = found;
    return TDSP_OK;
}

static double arrival_lower(const tdsp_table *table, uint64_t row, double departure)
{
    if (row == 0) return table_header_f64(table, FORMAT_AT_FIRST_LOWER);
    double right = table_right(table, row - 1);
    if (table->monotone == TDSP_MONOTONE_TRAVEL) return round_add_down(departure, right);
    double lower = round_add_down(table_departure(table, row - 1), right);
    return lower > departure ? lower : departure;
}

static double arrival_upper(const tdsp_table *table, uint64_t row, double departure)
{
    double from = table->monotone == TDSP_MONOTONE_TRAVEL ? departure : table_departure(table, row);
    return round_add_up(from, table_left(table, row));
}

tdsp_status tdsp_table_arrival(const tdsp_table *table, double departure, double *lower, double *upper)
{
    uint64_t row;
    tdsp_status status = tdsp_table_find(table, departure, &row);
    if (status != TDSP_OK) return status;
    if (lower) *lower = arrival_lower(table, row, departure);
    if (upper) *upper = arrival_upper(table, row, departure);
    return TDSP_OK;
}

tdsp_status tdsp_table_arrivals(const tdsp_table *table, const double *departures, size_t count, double *lower, double *upper,
                                tdsp_status *statuses)
{
    if (!table || !table->bytes || !departures) return TDSP_INVALID_ARGUMENT;
    for (size_t i = 0; i < count; i++) {
        double low = INFINITY;
        double high = INFINITY;
        tdsp_status status = tdsp_table_arrival(table, departures[i], &low, &high);
        if (lower) lower[i] = low;
        if (upper) upper[i] = high;
        if (statuses) statuses[i] = status;
    }
    return TDSP_OK;
}
