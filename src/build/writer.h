/* SPDX-License-Identifier: MIT */
/*
 * The writer: rows in, the bytes of a table out (docs/format.md).
 *
 * Invariant: what writer_finish() hands out is accepted by tdsp_table_open(); it is asked before the bytes leave, so there
 * is one definition of a valid table. The bytes are a function of the rows and the header alone.
 *
 * What the rows must satisfy (else TDSP_BAD_TABLE), with up() and down() the roundings of base/round.h:
 *   - the first departure is 0, departures increase strictly, all numbers are finite except the last right;
 *   - left_i >= T(b_i) and right_i <= T(b_i+): round outward by the oracle's stated error before adding a row; a left may
 *     therefore be over its right where A does not jump; neither is negative;
 *   - monotone in travel:  left and right never decrease, right_i <= left_(i+1). Computed travel times wobble by the stated
 *     error where T is flat: carry the running maximum of left and of right, both stay certified;
 *   - monotone in arrival: the same of the arrivals b_i + left_i and b_i + right_i, up to the rounding of the sum;
 *   - the last right is infinite, unless last_reason is TDSP_HORIZON or TDSP_OUTSIDE_TABLE: then it is finite;
 *   - 0 <= first_lower <= left_0.
 */
#ifndef BUILD_WRITER_H
#define BUILD_WRITER_H

#include <stddef.h>

#include "tdsp/build.h"
#include "tdsp/status.h"
#include "tdsp/types.h"

typedef struct writer writer;

typedef struct writer_row {
    double departure;     /* b_i */
    double left;          /* T(b_i), rounded up */
    double right;         /* T(b_i+), rounded down */
    const tdsp_leg *legs; /* may be NULL when leg_count is 0 */
    size_t leg_count;
    const void *bytes; /* opaque; may be NULL when byte_count is 0 */
    size_t byte_count; /* at most 2^31 - 1 */
} writer_row;

/* What the header says besides the rows. */
typedef struct writer_header {
    tdsp_monotone monotone;
    tdsp_guarantee guarantee;
    tdsp_sampling sampling;
    double epsilon;     /* 0 for the guarantee absolute */
    double delta;       /* 0 for the others */
    double error;       /* the oracle's */
    double time_scale;  /* the oracle's */
    double first_lower; /* T(0), rounded down */
    tdsp_status last_reason;
    tdsp_build_world world;
} writer_header;

/* An empty writer; NULL is the C library's allocator. TDSP_OK or TDSP_NO_MEMORY. */
tdsp_status writer_create(const tdsp_allocator *allocator, writer **out);

/* NULL is allowed. */
void writer_free(writer *w);

/*
 * Append a row; everything is copied. TDSP_BAD_PATH when a leg is not well formed, the first leg does not start at the
 * departure, a leg does not start when the one before ends, or the path ends after up(departure + left). TDSP_NO_MEMORY,
 * TDSP_TOO_MANY_ROWS, TDSP_INVALID_ARGUMENT. The writer is as before unless TDSP_OK.
 */
tdsp_status writer_add(writer *w, const writer_row *row);

/* Say what closes at the jump of a row that was added, in the order of rows. As gap_list_add(). */
tdsp_status writer_add_gap(writer *w, size_t row, const tdsp_gap *gap);

/* How many rows were added, and the numbers of one of them; its path and bytes are not handed out. */
size_t writer_count(const writer *w);
writer_row writer_row_at(const writer *w, size_t row);

/* The finished table; free with tdsp_bytes_free() and the same allocator. The writer stays as it is. */
tdsp_status writer_finish(const writer *w, const writer_header *header, void **bytes, size_t *length);

#endif
