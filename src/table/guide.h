/* SPDX-License-Identifier: MIT */
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
 * read here is still only a hint, to be kept inside the table: the bytes may have changed since. An entry outside the bytes, which no
 * opened table has, is not read.
 */
#ifndef TABLE_GUIDE_H
#define TABLE_GUIDE_H

#include "table/read.h"

static inline double guide_arrival(const tdsp_table *table, uint64_t row)
{
    return table_departure(table, row) + table_left(table, row);
}

/*
 * For first <= x <= last of a checked guide: below guide->cells. `first` is 0 for departures, where the compiler leaves the difference out. Of a place
 * that has no number, as only an unchecked guide gives, it is GUIDE_NOWHERE.
 */
#define GUIDE_NOWHERE UINT64_MAX

static inline uint64_t guide_cell(double first, double scale, double x)
{
    double place = (x - first) * scale;
    return place == place && place > -1.0 && !(place >= 0x1p32) ? (uint64_t)(int64_t)place : GUIDE_NOWHERE;
}

static inline uint64_t guide_bases_size(uint64_t cells)
{
    return 4 * ((cells + FORMAT_GUIDE_BLOCK - 1) / FORMAT_GUIDE_BLOCK + 1);
}

static inline uint64_t guide_size(uint64_t cells)
{
    return cells > 0 ? guide_bases_size(cells) + cells : 0;
}

/* Where a cell's block says its start, and the next block behind it; where the cell says by how much it starts later. */
static inline uint64_t guide_base_at(const tdsp_guide *guide, uint64_t cell)
{
    return guide->bases + 4 * (cell / FORMAT_GUIDE_BLOCK);
}

static inline uint64_t guide_count_at(const tdsp_guide *guide, uint64_t cell)
{
    return guide->counts + cell;
}

static inline uint64_t guide_base(const tdsp_table *table, uint64_t at)
{
    return bytes_get_u32(table->bytes + at);
}

/* No row before this is in the cell or after it. GUIDE_NOWHERE, which is no row, where the guide has no such cell. */
static inline uint64_t guide_start(const tdsp_table *table, const tdsp_guide *guide, uint64_t cell)
{
    uint64_t base = guide_base_at(guide, cell);
    uint64_t count = guide_count_at(guide, cell);
    if (base > table->last_word || count >= table->length) return GUIDE_NOWHERE;
    return guide_base(table, base) + table->bytes[count];
}

/* No row from this on is in the cell or before it; GUIDE_NOWHERE likewise. */
static inline uint64_t guide_end(const tdsp_table *table, const tdsp_guide *guide, uint64_t cell)
{
    uint64_t base = guide_base_at(guide, cell);
    uint64_t next = guide_count_at(guide, cell + 1);
    if (base > table->last_word) return GUIDE_NOWHERE;
    int same_block = cell + 1 < guide->cells && (cell + 1) % FORMAT_GUIDE_BLOCK != 0;
    if (same_block && next < table->length && table->bytes[next] < FORMAT_GUIDE_FULL) return guide_base(table, base) + table->bytes[next];
    return guide_base(table, base + 4);
}

#endif
