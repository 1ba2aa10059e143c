/* SPDX-License-Identifier: MIT */
/*
 * The order of the rows, which every certificate rests on.
 *
 * T(b_i) <= left_i, right_i <= T(b_i+), and T never decreases (monotone in travel) or A never decreases (monotone in
 * arrival). So right_i <= T(b_i+) <= T(b_j) <= left_j for every j > i, likewise with arrivals; a table that breaks
 * this contradicts itself. left_i may be over right_i: both are rounded outward. That left and right do not decrease
 * is not needed for the certificates but makes binary search find the best answer.
 *
 * Arrivals are sums: b + left is not exact, so arrivals that are equal are stored as travel times whose sums differ by the
 * rounding. Their order is therefore checked between one sum rounded down and the next rounded up.
 */
#include "base/round.h"
#include "table/check.h"
#include "table/read.h"

typedef struct check_row {
    double departure;
    double left;
    double right;
} check_row;

static check_row check_read_row(const tdsp_table *table, uint64_t row)
{
    check_row out = {table_departure(table, row), table_left(table, row), table_right(table, row)};
    return out;
}

/* The last right is infinite where nothing follows, and finite where a horizon hides what follows. Departures rise from 0: that is looked at elsewhere. */
static int check_row_range(const tdsp_table *table, uint64_t row, check_row at)
{
    uint32_t reason = table_header_u32(table, FORMAT_AT_LAST_REASON);
    int open_end = reason == TDSP_HORIZON || reason == TDSP_OUTSIDE_TABLE;
    int right_finite = row + 1 < table->rows || open_end;
    if (!(at.left >= 0) || !(at.right >= 0)) return 0;
    if (!round_is_finite(round_add_up(at.departure, at.left))) return 0;
    return round_is_finite(round_add_up(at.departure, at.right)) == right_finite && (right_finite || at.right > DBL_MAX);
}

static int check_travel_order(check_row a, check_row b)
{
    return a.left <= b.left && a.right <= b.right && a.right <= b.left;
}

static int check_arrival_order(check_row a, check_row b)
{
    double next_left = round_add_up(b.departure, b.left);
    return round_add_down(a.departure, a.left) <= next_left && round_add_down(a.departure, a.right) <= next_left &&
           round_add_down(a.departure, a.right) <= round_add_up(b.departure, b.right);
}

static int check_ends(const tdsp_table *table)
{
    double first_lower = table_header_f64(table, FORMAT_AT_FIRST_LOWER);
    return table_departure(table, 0) == 0 && table_header_f64(table, FORMAT_AT_FIRST_DEPARTURE) == 0 &&
           table_header_f64(table, FORMAT_AT_LAST_DEPARTURE) == table_departure(table, table->rows - 1) && first_lower >= 0 &&
           first_lower <= table_left(table, 0);
}

int check_rows(const tdsp_table *table)
{
    if (!check_ends(table)) return 0;
    check_row before = check_read_row(table, 0);
    if (!check_row_range(table, 0, before)) return 0;
    for (uint64_t row = 1; row < table->rows; row++) {
        check_row at = check_read_row(table, row);
        if (!check_row_range(table, row, at) || !(before.departure < at.departure)) return 0;
        int ordered = table->monotone == TDSP_MONOTONE_TRAVEL ? check_travel_order(before, at) : check_arrival_order(before, at);
        if (!ordered) return 0;
        before = at;
    }
    return 1;
}
