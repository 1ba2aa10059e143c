/*
 * A guide: where among the rows to look for a time.
 *
 * The time from the first row's to the last row's is cut into cells of equal length, cell(x) = floor((x - first) * scale) in double. Each
 * rounding and the floor never decrease, so cell() does not. With start(k) = the number of rows in cells below k,
 *
 *     the rows before start(cell(x)) are before x, and the row at start(cell(x) + 1) is not.
 *
 * Stored are start() of every 64th cell, and for each cell by how much its start is over that, 255 standing for 255 or more: about one byte
 * a cell, so that cells can be finer than rows and the guide stays in the fast caches.
 *
 * There is one for the departures b_i and one for the arrivals b_i + left_i, rounded to nearest. Opening checks every entry. What is
 * read here is still only a hint, to be kept inside the table: the bytes may have changed since.
 */
#ifndef TABLE_GUIDE_H
#define TABLE_GUIDE_H

#include "table/read.h"

static inline double guide_arrival(const tdsp_table *table, uint64_t row)
{
    return table_departure(table, row) + table_left(table, row);
}

/* For first <= x <= last: below guide->cells. `first` is 0 for departures, where the compiler leaves the difference out. */
static inline uint64_t guide_cell(double first, double scale, double x)
{
    return (uint64_t)(int64_t)((x - first) * scale);
}

static inline uint64_t guide_bases_size(uint64_t cells)
{
    return 4 * ((cells + FORMAT_GUIDE_BLOCK - 1) / FORMAT_GUIDE_BLOCK + 1);
}

static inline uint64_t guide_size(uint64_t cells)
{
    return cells > 0 ? guide_bases_size(cells) + cells : 0;
}

static inline const unsigned char *guide_base_at(const tdsp_guide *guide, uint64_t cell)
{
    return guide->bases + 4 * (cell / FORMAT_GUIDE_BLOCK);
}

/* No row before this is in the cell or after it. */
static inline uint64_t guide_start(const tdsp_guide *guide, uint64_t cell)
{
    return (uint64_t)bytes_get_u32(guide_base_at(guide, cell)) + guide->counts[cell];
}

/* No row from this on is in the cell or before it. */
static inline uint64_t guide_end(const tdsp_guide *guide, uint64_t cell)
{
    uint64_t next = cell + 1;
    int stored = next < guide->cells && next % FORMAT_GUIDE_BLOCK != 0 && guide->counts[next] < FORMAT_GUIDE_FULL;
    return stored ? guide_start(guide, next) : bytes_get_u32(guide_base_at(guide, cell) + 4);
}

#endif
