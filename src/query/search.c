/* The rare parts of finding a row: see search.h. */
#include "query/search.h"

/*
 * The first row from `first` on that does not depart before; `end` does not. Each step halves what is open, whatever the data: there is
 * nothing for a branch to mispredict but the end of the loop.
 */
static uint64_t search_halving(const tdsp_table *table, uint64_t first, uint64_t end, uint64_t departure)
{
    uint64_t count = end - first;
    while (count > 0) {
        uint64_t half = (count + 1) / 2;
        uint64_t before = table_departure_bits(table, first + half - 1) < departure;
        first += half & (0 - before);
        count -= half;
    }
    return first;
}

uint64_t search_crowd(const tdsp_table *table, uint64_t cell, uint64_t first, uint64_t departure)
{
    uint64_t end = guide_end(&table->by_departure, cell);
    if (end > table->rows - 1) end = table->rows - 1;
    return first < end ? search_halving(table, first, end, departure) : end;
}

/* Row 0 departs before: it is left out, since its bits are those of -0 where it was written so. The last row does not. */
uint64_t search_all(const tdsp_table *table, uint64_t departure)
{
    return search_halving(table, 1, table->rows - 1, departure);
}
