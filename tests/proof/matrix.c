/* SPDX-License-Identifier: MIT */
/*
 * What the proof of the matrix reader runs: every matrix of LENGTH bytes, and every question to it; as table.c does for tables.
 *
 * The tables in it are opened by what stands below for the table reader: it reads the first and the last of the bytes that it is given, and answers anything. So an
 * alarm-free analysis says that the table reader is only given bytes inside the matrix; that it keeps to the bytes it is given is what table.c proves, and that it
 * accepts none that are shorter than a header.
 *
 * Between opening and each question all bytes may change.
 */
#include <stdlib.h>

#include "__fc_builtin.h"

#include "proof/any.h"
#include "table/check.h"
#include "table/format.h"
#include "tdsp/matrix.h"

static unsigned char *bytes;

/* Nothing of them is known any more. */
static void change_all(void)
{
    any_bytes(bytes, LENGTH);
}

static void touch(const void *first, size_t length)
{
    unsigned char touched;
    if (length == 0) return;
    touched = ((const unsigned char *)first)[0];
    touched = ((const unsigned char *)first)[length - 1];
    (void)touched;
}

static tdsp_status any_status(void)
{
    return (tdsp_status)Frama_C_interval(TDSP_OK, TDSP_UNREACHABLE);
}

static tdsp_status open_any(tdsp_table *table, const void *first, size_t length)
{
    touch(first, length);
    any_bytes(table, sizeof *table);
    return length < FORMAT_HEADER_LENGTH ? TDSP_BAD_LENGTH : any_status();
}

tdsp_status table_open_into(tdsp_table *view, const void *first, size_t length)
{
    return open_any(view, first, length);
}

tdsp_status tdsp_table_reopen(tdsp_table *table, const void *first, size_t length)
{
    return open_any(table, first, length);
}

static void ask_sizes(const tdsp_matrix *matrix)
{
    uint64_t sources, destinations;
    tdsp_matrix_size(matrix, any_bit() ? &sources : NULL, any_bit() ? &destinations : NULL);
}

static void ask_ends(const tdsp_matrix *matrix)
{
    tdsp_matrix_end end;
    change_all();
    tdsp_matrix_source(matrix, any_u64(), &end);
    change_all();
    tdsp_matrix_destination(matrix, any_u64(), &end);
}

static void ask_table(const tdsp_matrix *matrix)
{
    tdsp_table table;
    change_all();
    tdsp_matrix_table(matrix, any_u64(), any_u64(), &table);
}

static size_t told_length(void)
{
    return LENGTH == LONGEST ? LENGTH : (size_t)Frama_C_interval(LENGTH, LONGEST);
}

int main(void)
{
    tdsp_matrix matrix = {0};
    bytes = malloc(LENGTH);
    if (!bytes) return 0;
    change_all();
    if (tdsp_matrix_open(&matrix, bytes, told_length()) == TDSP_OK) {
        ask_sizes(&matrix);
        ask_ends(&matrix);
        ask_table(&matrix);
    }
    free(bytes);
    return 0;
}
