/* SPDX-License-Identifier: MIT */
/* The rare parts of finding a row: see locate.h. */
#include "query/locate.h"

/*
 * The first row from `first` on that does not depart before; `end` does not. Each step halves what is open, whatever the data: there is
 * nothing for a branch to mispredict but the end of the loop.
 */
static uint64_t locate_halving(const tdsp_table *table, size_t first, size_t end, uint64_t departure)
{
    while (first < end) {
        size_t middle = (first + end) / 2;
        int before = table_departure_bits(table, middle) < departure;
        first = before ? middle + 1 : first;
        end = before ? end : middle;
    }
    return end;
}

/* A few rows one by one, the rest of the cell halved. */
#define LOCATE_STEPS 7

static uint64_t locate_in_cell(const tdsp_table *table, uint64_t cell, uint64_t start, uint64_t departure)
{
    uint64_t row = start;
    for (; row < table->rows && row < start + LOCATE_STEPS; row++) {
        if (table_departure_bits(table, row) >= departure) return row;
    }
    uint64_t end = guide_end(table, &table->by_departure, cell);
    if (end > table->rows - 1) end = table->rows - 1;
    return row < end ? locate_halving(table, (size_t)row, (size_t)end, departure) : end;
}

/* Row 0 departs before: it is left out, since its bits are those of -0 where it was written so. The last row does not. */
static uint64_t locate_all(const tdsp_table *table, uint64_t departure)
{
    return locate_halving(table, 1, (size_t)(table->rows - 1), departure);
}

tdsp_status locate_rest(const tdsp_table *table, uint64_t cell, uint64_t start, double departure, uint64_t *row)
{
    uint64_t bits = locate_bits(departure);
    *row = locate_by_guide(table) ? locate_in_cell(table, cell, start, bits) : locate_all(table, bits);
    return TDSP_OK;
}
