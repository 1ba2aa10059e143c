/* SPDX-License-Identifier: MIT */
/*
 * The guides, entry by entry: a wrong one would give wrong answers. What each cell's start must be is counted anew along the rows.
 *
 * That counts right when the times are in order. Departures are; arrivals of a table that is monotone in arrival may decrease by
 * a rounding, and such a table must not have a guide for them.
 */
#include "table/check.h"
#include "table/guide.h"

typedef double check_key(const tdsp_table *table, uint64_t row);

/* No time is after the last cell; which is one of fewer than 2^32, whose numbers a double holds exactly. */
static int check_cells(const tdsp_guide *guide)
{
    return guide->scale > 0 && guide_cell(guide->first, guide->scale, guide->last) < guide->cells;
}

static inline int check_order(const tdsp_table *table, check_key *key)
{
    for (uint64_t row = 1; row < table->rows; row++) {
        if (!(key(table, row - 1) <= key(table, row))) return 0;
    }
    return 1;
}

static inline uint64_t check_row_cell(const tdsp_table *table, const tdsp_guide *guide, check_key *key, uint64_t row)
{
    return guide_cell(guide->first, guide->scale, key(table, row));
}

/*
 * Where the last cell starts of the block from `cell` on, given a row at or before its first cell's start; no row when an entry is wrong, or when the
 * cells go on behind the last row's.
 */
static inline uint64_t check_block(const tdsp_table *table, const tdsp_guide *guide, check_key *key, uint64_t cell, uint64_t row)
{
    uint64_t end = cell + FORMAT_GUIDE_BLOCK < guide->cells ? cell + FORMAT_GUIDE_BLOCK : guide->cells;
    uint64_t base = bytes_get_u32(table_at(table, guide_base_at(guide, cell), 4));
    uint64_t row_cell = check_row_cell(table, guide, key, row);
    for (uint64_t k = cell; k < end; k++) {
        for (; row_cell < k; row_cell = check_row_cell(table, guide, key, row)) {
            if (++row >= table->rows) return table->rows;
        }
        if (k == cell && row != base) return table->rows;
        uint64_t count = row - base;
        if (*table_at(table, guide_count_at(guide, k), 1) != (count < FORMAT_GUIDE_FULL ? count : FORMAT_GUIDE_FULL)) return table->rows;
    }
    return row;
}

/* The last base, which is a u32, says how many rows there are: so there are no more than it can number. */
static inline int check_guide(const tdsp_table *table, const tdsp_guide *guide, check_key *key)
{
    uint64_t row = 0;
    if (guide->cells == 0) return guide->scale == 0;
    if (bytes_get_u32(table_at(table, guide_base_at(guide, guide->cells - 1) + 4, 4)) != table->rows) return 0;
    if (!check_order(table, key) || !check_cells(guide)) return 0;
    for (uint64_t cell = 0; cell < guide->cells; cell += FORMAT_GUIDE_BLOCK) {
        row = check_block(table, guide, key, cell, row);
        if (row >= table->rows) return 0;
    }
    return 1;
}

/* Whole numbers compare as departures do only where the first is +0. */
int check_guides(const tdsp_table *table)
{
    if (table->by_departure.cells > 0 && table_departure_bits(table, 0) != 0) return 0;
    return check_guide(table, &table->by_departure, table_departure) && check_guide(table, &table->by_arrival, guide_arrival);
}
