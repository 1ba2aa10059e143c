/* SPDX-License-Identifier: MIT */
/*
 * Small tables made by hand, one for each way a table can be. Their bytes stand in tests/independent/golden/NAME.tdsp and what is
 * in them, written by hand too, in NAME.json.
 */
#ifndef SUPPORT_GOLDEN_H
#define SUPPORT_GOLDEN_H

#include "build/gap_list.h"
#include "build/writer.h"

typedef struct golden_table {
    const char *name;
    writer_header header;
    const writer_row *rows;
    size_t row_count;
    const gap_entry *gaps;
    size_t gap_count;
} golden_table;

#define GOLDEN_COUNT 7

/*
 * 0 gap:   monotone in travel, lines and arcs of both turns, a jump at row 2, ends cut off
 * 1 road:  monotone in arrival, opaque bytes instead of legs, a flat arrival, ends at a horizon
 * 2 loose: absolute bound, legs that join only up to rounding, a row without a path, an arc that turns by -0
 * 3 still: one row, no path, source and destination the same
 * 4 crowd: enough rows for guides (version 1.1), nearly all in a part of the time
 * 5 swell: curves beside an arc, one of no duration that turns by -0 (version 1.2; those before crowd are 1.0)
 * 6 squeeze: two jumps whose gaps are told, one that is not, and guides and curves of nothing (version 1.2)
 */
extern const golden_table golden_tables[GOLDEN_COUNT];

/* A writer that holds the table's rows; NULL when anything fails. */
writer *golden_fill(const golden_table *golden, const tdsp_allocator *allocator);

/* The table's bytes from the C library's heap, or NULL. */
unsigned char *golden_write(const golden_table *golden, size_t *length);

/* Put both checksums right after a change of the bytes. */
void golden_seal(unsigned char *bytes, size_t length);

/* A table of `count` rows without paths, from the C library's heap, or NULL. */
unsigned char *golden_rows(const writer_header *header, const writer_row *rows, size_t count, size_t *length);

#endif
