/* SPDX-License-Identifier: MIT */
/* Jumps of the travel time, and what closes there. */
#include "query/jump.h"

#include "query/locate.h"
#include "tdsp/table.h"

/* The first gap at `row` or later, by halving. */
static uint64_t jump_first_gap(const tdsp_table *table, uint64_t row)
{
    uint64_t low = 0, high = table->gap_count;
    while (low < high) {
        uint64_t middle = (low + high) / 2;
        if (table_gap_row(table, middle) < row)
            low = middle + 1;
        else
            high = middle;
    }
    return high;
}

static tdsp_gap jump_gap(const tdsp_table *table, uint64_t row)
{
    tdsp_gap unknown = {TDSP_NO_DISC, TDSP_NO_DISC, 0, {0, 0}};
    uint64_t i = jump_first_gap(table, row);
    if (i < table->gap_count && table_gap_row(table, i) == row) return table_gap(table, i);
    return unknown;
}

static int jump_at(const tdsp_table *table, uint64_t row, tdsp_jump *out)
{
    double departure = table_departure(table, row);
    double left = table_left(table, row);
    double right = table_right(table, row);
    double error = table_header_f64(table, FORMAT_AT_ERROR);
    if (!jump_between(departure, left, right, error, table_header_f64(table, FORMAT_AT_TIME_SCALE))) return 0;
    out->row = row;
    out->departure = departure;
    out->before = left;
    out->after = right;
    out->gap = jump_gap(table, row);
    return 1;
}

static int jump_asked(const tdsp_table *table, double departure, const tdsp_jump *out)
{
    return table && table->bytes && out && departure == departure;
}

tdsp_status tdsp_table_next_jump(const tdsp_table *table, double departure, tdsp_jump *out)
{
    if (!jump_asked(table, departure, out)) return TDSP_INVALID_ARGUMENT;
    for (uint64_t row = locate_first_row(table, departure); row < table->rows; row++) {
        if (jump_at(table, row, out)) return TDSP_OK;
    }
    return TDSP_NO_ANSWER;
}

tdsp_status tdsp_table_previous_jump(const tdsp_table *table, double departure, tdsp_jump *out)
{
    if (!jump_asked(table, departure, out)) return TDSP_INVALID_ARGUMENT;
    for (uint64_t row = locate_first_row(table, departure); row > 0; row--) {
        if (jump_at(table, row - 1, out)) return TDSP_OK;
    }
    return TDSP_NO_ANSWER;
}
