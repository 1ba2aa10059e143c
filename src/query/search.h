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
#ifndef QUERY_SEARCH_H
#define QUERY_SEARCH_H

#include "table/guide.h"

#define SEARCH_STEPS 7

static inline uint64_t search_bits(double x)
{
    uint64_t bits;
    memcpy(&bits, &x, sizeof bits);
    return bits;
}

/* Is the departure over 0 and not after the last? One comparison, which also turns away NaN, negative numbers and -0. */
static inline int search_is_inside(const tdsp_table *table, double departure)
{
    return search_bits(departure) - 1 < table->last;
}

static inline uint64_t search_cell(const tdsp_table *table, double departure)
{
    return guide_cell(0, table->by_departure.scale, departure);
}

/* The row of a departure whose bits are given: when those before `first` in its cell are too early, and without a guide. */
uint64_t search_crowd(const tdsp_table *table, uint64_t cell, uint64_t first, uint64_t departure);
uint64_t search_all(const tdsp_table *table, uint64_t departure);

/* The row of a departure that is inside, given its cell and where that starts. */
static inline uint64_t search_from(const tdsp_table *table, uint64_t cell, uint64_t start, double departure)
{
    uint64_t bits = search_bits(departure);
    for (uint64_t row = start; row < table->rows; row++) {
        if (table_departure_bits(table, row) >= bits) return row;
        if (row == start + SEARCH_STEPS) break;
    }
    return search_crowd(table, cell, start, bits);
}

/* The row of a departure that is inside. */
static inline uint64_t search_row(const tdsp_table *table, double departure)
{
    if (!table->by_departure.bases) return search_all(table, search_bits(departure));
    uint64_t cell = search_cell(table, departure);
    return search_from(table, cell, guide_start(&table->by_departure, cell), departure);
}

/* The earliest row at `departure` or later, which is not NaN; table->rows when all are earlier. */
static inline uint64_t search_first_row(const tdsp_table *table, double departure)
{
    if (search_is_inside(table, departure)) return search_row(table, departure);
    return departure > 0 ? table->rows : 0;
}

#endif
