/* SPDX-License-Identifier: MIT */
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
#ifndef QUERY_ARRIVAL_H
#define QUERY_ARRIVAL_H

#include "query/outward.h"
#include "table/read.h"

static inline double arrival_lower(const tdsp_table *table, uint64_t row, double departure)
{
    if (row == 0) return table_header_f64(table, FORMAT_AT_FIRST_LOWER);
    double right = table_right(table, row - 1);
    if (table->monotone == TDSP_MONOTONE_TRAVEL) return outward_add_down(departure, right);
    double lower = outward_add_down(table_departure(table, row - 1), right);
    return outward_later(lower, departure);
}

static inline double arrival_upper(const tdsp_table *table, uint64_t row, double departure)
{
    double from = table->monotone == TDSP_MONOTONE_TRAVEL ? departure : table_departure(table, row);
    return outward_add_up(from, table_left(table, row));
}

#endif
