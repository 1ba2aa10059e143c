/* SPDX-License-Identifier: MIT */
/*
 * Which row answers a departure?
 *
 * With a guide (table/guide.h) the row where the departure's cell starts answers it nearly always: cells are finer than rows. Else a few
 * rows are looked at one by one, and where departures crowd in one cell what is left of it is halved. So is the whole table
 * without a guide. O(log rows) whatever the departures.
 *
 * Branches that are nearly always taken alike are better here than none: the processor goes on with the likely row while the departure
 * that proves it is still on its way from memory.
 *
 * Nothing trusts the guide further than the size of the table, so that no read leaves the bytes even when they change after opening.
 */
#ifndef QUERY_LOCATE_H
#define QUERY_LOCATE_H

#include "base/soft.h"
#include "table/guide.h"

static inline uint64_t locate_bits(double x)
{
    uint64_t bits;
    memcpy(&bits, &x, sizeof bits);
    return bits;
}

/* Finding a cell takes arithmetic: in software as long as halving 256 rows. */
static inline int locate_by_guide(const tdsp_table *table)
{
    return SOFT_DOUBLE ? 0 : table->by_departure.bases != 0;
}

/* Is the departure over 0 and not after the last? One comparison, which also turns away NaN, negative numbers and -0. */
static inline int locate_is_inside(const tdsp_table *table, double departure)
{
    return locate_bits(departure) - 1 < table->last;
}

static inline uint64_t locate_cell(const tdsp_table *table, double departure)
{
    return guide_cell(0, table->by_departure.scale, departure);
}

static inline uint64_t locate_start(const tdsp_table *table, uint64_t cell)
{
    return guide_start(table, &table->by_departure, cell);
}

/* The row where the cell starts is nearly always the one that answers a departure in it: does it, where there is one? */
static inline int locate_answers(const tdsp_table *table, uint64_t row, double departure)
{
    return table_departure_bits(table, row) >= locate_bits(departure);
}

/*
 * The rest: *row of a departure inside, which the first row of its cell does not answer or which is in a table without a guide. Returns TDSP_OK,
 * and is apart, so that what calls it last has nothing to save and restore.
 */
tdsp_status locate_rest(const tdsp_table *table, uint64_t cell, uint64_t start, double departure, uint64_t *row);

/* The row of a departure that is inside, given its cell and where that starts. */
static inline uint64_t locate_from(const tdsp_table *table, uint64_t cell, uint64_t start, double departure)
{
    uint64_t row;
    if (start < table->rows && locate_answers(table, start, departure)) return start;
    locate_rest(table, cell, start, departure, &row);
    return row;
}

/* The row of a departure that is inside. */
static inline uint64_t locate_row(const tdsp_table *table, double departure)
{
    if (!locate_by_guide(table)) return locate_from(table, 0, table->rows, departure);
    uint64_t cell = locate_cell(table, departure);
    return locate_from(table, cell, locate_start(table, cell), departure);
}

/* The earliest row at `departure` or later, which is not NaN; table->rows when all are earlier. */
static inline uint64_t locate_first_row(const tdsp_table *table, double departure)
{
    if (locate_is_inside(table, departure)) return locate_row(table, departure);
    return departure > 0 ? table->rows : 0;
}

#endif
