/*
 * Binary search over the rows.
 *
 * `before` is true for some rows from the first on and false for all others. Invariant: rows below `base` are before;
 * base + count is the number of rows or a row that is not. Each step halves what is open, whatever the data: there is
 * nothing for a branch to mispredict but the end of the loop.
 */
#ifndef QUERY_SEARCH_H
#define QUERY_SEARCH_H

#include "table/read.h"

typedef int query_before(const tdsp_table *table, uint64_t row, double x);

/* How many rows are before x. */
static inline uint64_t query_count(const tdsp_table *table, double x, query_before *before)
{
    uint64_t base = 0;
    uint64_t count = table->rows;
    while (count > 1) {
        uint64_t half = count / 2;
        base += before(table, base + half - 1, x) ? half : 0;
        count -= half;
    }
    return base + (uint64_t)(before(table, base, x) ? 1 : 0);
}

/* The earliest row at `departure` or later; table->rows when all are earlier. */
static inline int query_departs_before(const tdsp_table *table, uint64_t row, double departure)
{
    return table_departure(table, row) < departure;
}

static inline uint64_t query_row(const tdsp_table *table, double departure)
{
    return query_count(table, departure, query_departs_before);
}

#endif
