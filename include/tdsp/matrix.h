/* SPDX-License-Identifier: MIT */
/*
 * Matrices: the tables between many sources and many destinations in one file. Open the bytes once, then ask for the table of a pair. No heap, no
 * stdio, no recursion, no state; firmware may use everything here. The format is specified in docs/format.md.
 */
#ifndef TDSP_MATRIX_H
#define TDSP_MATRIX_H

#include "tdsp/status.h"
#include "tdsp/table.h"
#include "tdsp/types.h"

#ifdef __cplusplus
extern "C" {
#endif

/** An opened matrix: a view of the caller's bytes, with the rules of tdsp_table. Members are private. */
typedef struct tdsp_matrix {
    const unsigned char *bytes;
    uint64_t length;
    uint64_t sources;
    uint64_t destinations;
    uint64_t points; /* offsets of the sections */
    uint64_t name_ends;
    uint64_t names;
    uint64_t pairs;
    uint64_t reserved[4];
} tdsp_matrix;

/**
 * Check the bytes whole, every table in them included, and open them.
 *
 * @param matrix  receives the view; untouched on error
 * @param bytes   at any alignment; not copied
 * @param length  the exact length of the matrix
 * @return TDSP_OK; TDSP_INVALID_ARGUMENT; TDSP_BAD_MAGIC, TDSP_BAD_VERSION, TDSP_BAD_LENGTH, TDSP_BAD_CHECKSUM, TDSP_BAD_TABLE (also when a
 *         table in it is bad, whatever is bad about it)
 *
 * O(length). After TDSP_OK no function here can read outside the bytes. Since 0.1.
 */
TDSP_API tdsp_status tdsp_matrix_open(tdsp_matrix *matrix, const void *bytes, size_t length);

/** How many sources and destinations there are. Either may be NULL. TDSP_OK or TDSP_INVALID_ARGUMENT. O(1). Since 0.1. */
TDSP_API tdsp_status tdsp_matrix_size(const tdsp_matrix *matrix, uint64_t *sources, uint64_t *destinations);

/** An end of the pairs. */
typedef struct tdsp_matrix_end {
    tdsp_point place; /* finite */
    const char *name; /* UTF-8 in the matrix's bytes, without a zero byte behind it */
    size_t name_length; /* 0: no name */
} tdsp_matrix_end;

/** Source i, destination j. TDSP_OK or TDSP_INVALID_ARGUMENT. O(1). Since 0.1. */
TDSP_API tdsp_status tdsp_matrix_source(const tdsp_matrix *matrix, uint64_t i, tdsp_matrix_end *out);
TDSP_API tdsp_status tdsp_matrix_destination(const tdsp_matrix *matrix, uint64_t j, tdsp_matrix_end *out);

/**
 * The table from source i to destination j, opened.
 *
 * @return TDSP_OK; where there is no way at departure 0 and so no table, why: TDSP_SOURCE_COVERED, TDSP_DESTINATION_COVERED, TDSP_CUT_OFF or
 *         TDSP_UNREACHABLE; TDSP_INVALID_ARGUMENT. `table` is untouched unless TDSP_OK.
 *
 * O(1): what it needs was checked when the matrix was opened. Since 0.1.
 */
TDSP_API tdsp_status tdsp_matrix_table(const tdsp_matrix *matrix, uint64_t i, uint64_t j, tdsp_table *table);

#ifdef __cplusplus
}
#endif

#endif
