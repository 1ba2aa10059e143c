/* SPDX-License-Identifier: MIT */
/* The matrix format's numbers: docs/format.md in C. Reader and writer both take them from here. */
#ifndef TABLE_MATRIX_H
#define TABLE_MATRIX_H

#define MATRIX_MAGIC "\x89TDSM\r\n\x1a" /* 8 bytes; a table's, but for one letter */
#define MATRIX_MAGIC_LENGTH 8
#define MATRIX_MAJOR 1
#define MATRIX_MINOR 0
#define MATRIX_HEADER_LENGTH 88 /* of version 1.0 */

/* Places in the header; up to the checksums as in a table's. */
#define MATRIX_AT_MAJOR 8          /* u16 */
#define MATRIX_AT_MINOR 10         /* u16 */
#define MATRIX_AT_HEADER_LENGTH 12 /* u32 */
#define MATRIX_AT_LENGTH 16        /* u64 */
#define MATRIX_AT_BODY_CRC 24      /* u32, CRC-32C of everything after the header */
#define MATRIX_AT_HEADER_CRC 28    /* u32, CRC-32C of the header without these four bytes */
#define MATRIX_AFTER_HEADER_CRC 32
#define MATRIX_AT_SOURCES 32      /* u64, as all that follow */
#define MATRIX_AT_DESTINATIONS 40
#define MATRIX_AT_POINTS 48    /* offset: x, y of each source, then of each destination */
#define MATRIX_AT_NAME_ENDS 56 /* offset: for each of them where its name ends among the names */
#define MATRIX_AT_NAMES 64     /* offset */
#define MATRIX_AT_PAIRS 72     /* offset */
#define MATRIX_AT_TABLES 80    /* offset */

#define MATRIX_POINT_SIZE 16

/* A pair: its table, or why there is none. Row by row, the destinations of one source in a row. */
#define MATRIX_PAIR_SIZE 24
#define MATRIX_PAIR_AT_OFFSET 0  /* u64, 0 without a table */
#define MATRIX_PAIR_AT_LENGTH 8  /* u64, likewise */
#define MATRIX_PAIR_AT_STATUS 16 /* u32 */
#define MATRIX_PAIR_AT_ZERO 20   /* u32 */

/* The largest number of sources, and of destinations: so the number of pairs fits in 64 bits. */
#define MATRIX_MOST_ENDS 0xffffffffu

#endif
