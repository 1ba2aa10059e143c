/* SPDX-License-Identifier: MIT */
/*
 * Rows on their way to the writer, and the guarantee between neighbours.
 *
 * A row is held back until the next one is known: its right side may still rise, when it turns out that the value jumps just after it.
 */
#ifndef BUILD_ROWS_H
#define BUILD_ROWS_H

#include "build/kept_path.h"
#include "build/writer.h"
#include "tdsp/build.h"

typedef struct row {
    double departure;
    double left;
    double right;
} row;

typedef struct rows {
    const tdsp_build_options *options;
    tdsp_monotone monotone;
    tdsp_allocator allocator;
    writer *writer;
    row held;       /* the last row; the writer has those before */
    kept_path path; /* of the row held */
    uint64_t count; /* with the row held; 0 at the beginning */
} rows;

tdsp_status rows_begin(rows *r, const tdsp_build_options *options, tdsp_monotone monotone, const tdsp_allocator *allocator);
void rows_release(rows *r);

/*
 * Add a row after the one held, with its path, which is exchanged for an old one. Left and right are raised to those of
 * the row before: values never decrease. TDSP_BAD_ORACLE when the guarantee does not hold between the two, or the departure is not later.
 */
tdsp_status rows_add(rows *r, const row *next, kept_path *path);

/* A row as it stands after `before`: values never decrease, so that a bound which holds for the row before holds for it too. */
row rows_raised(tdsp_monotone monotone, const row *before, const row *next);

/* T(b+) of the row held is at least this. */
void rows_raise_right(rows *r, double right);

/* Write the row held; nothing may be added afterwards. */
tdsp_status rows_end(rows *r);

/*
 * The largest travel time (monotone in travel) or arrival (monotone in arrival) at the end of a row that starts after `departure` with the
 * certified lower bound `lower` of the same kind.
 */
double rows_cap(const tdsp_build_options *options, tdsp_monotone monotone, double departure, double lower);

#endif
