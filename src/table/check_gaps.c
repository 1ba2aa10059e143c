/* SPDX-License-Identifier: MIT */
/* The gaps of jumps: rows in order, which a binary search rests on, and finite numbers. */
#include "base/round.h"
#include "table/check.h"
#include "table/read.h"

static int check_gap(const tdsp_gap *gap)
{
    return gap->first != FORMAT_NONE && round_is_finite(gap->time) && round_is_finite(gap->place.x) && round_is_finite(gap->place.y);
}

int check_gaps(const tdsp_table *table)
{
    for (uint64_t i = 0; i < table->gap_count; i++) {
        uint64_t row = table_gap_row(table, i);
        tdsp_gap gap = table_gap(table, i);
        if (row >= table->rows || (i > 0 && row <= table_gap_row(table, i - 1)) || !check_gap(&gap)) return 0;
    }
    return 1;
}
