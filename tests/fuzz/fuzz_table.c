/* SPDX-License-Identifier: MIT */
/*
 * Any bytes at all: opening must refuse them or every answer must hold together; and bytes that change after opening must
 * not lead a read astray.
 *
 * The input is taken three times: as it is; with the checksums put right, which lets the fuzzer through to what lies behind them;
 * and, when that opens, with bytes changed afterwards.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "support/golden.h"
#include "support/walk.h"

int LLVMFuzzerTestOneInput(const unsigned char *data, size_t size);

static void fuzz_require(const char *wrong)
{
    if (!wrong) return;
    fprintf(stderr, "%s\n", wrong);
    abort();
}

/* The header stays: it was turned into offsets when the table was opened, and is read at fixed places only. */
static void fuzz_change_later(const tdsp_table *table, unsigned char *bytes, size_t size)
{
    unsigned char step = (unsigned char)(bytes[size - 1] | 1);
    for (size_t i = 0; i < size; i += 1 + step % 13)
        bytes[i] = (unsigned char)(bytes[i] * 31 + step);
    (void)walk_table(table);
}

/* Bytes that were never accepted: answers may be wrong, reads may not. */
static void fuzz_reopen(const unsigned char *bytes, size_t size)
{
    tdsp_table table;
    if (tdsp_table_reopen(&table, bytes, size) == TDSP_OK) (void)walk_table(&table);
}

static void fuzz_bytes(unsigned char *bytes, size_t size)
{
    tdsp_table table;
    fuzz_reopen(bytes, size);
    if (tdsp_table_open(&table, bytes, size) != TDSP_OK) return;
    fuzz_require(walk_table(&table));
    fuzz_change_later(&table, bytes, size);
}

/* A block of exactly the input's size, at an odd address, so that a read past either end is seen. */
int LLVMFuzzerTestOneInput(const unsigned char *data, size_t size)
{
    unsigned char *block = malloc(size + 1);
    if (!block || size == 0) {
        free(block);
        return 0;
    }
    memcpy(block + 1, data, size);
    fuzz_bytes(block + 1, size);
    memcpy(block + 1, data, size);
    golden_seal(block + 1, size);
    fuzz_bytes(block + 1, size);
    free(block);
    return 0;
}
