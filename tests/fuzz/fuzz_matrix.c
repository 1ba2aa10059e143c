/* SPDX-License-Identifier: MIT */
/*
 * Any bytes at all as a matrix: opening must refuse them or every answer must hold together; and bytes that change after opening must
 * not lead a read astray. As fuzz_table.c.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "support/matrix_walk.h"
#include "table/matrix.h"

int LLVMFuzzerTestOneInput(const unsigned char *data, size_t size);

static void fuzz_require(const char *wrong)
{
    if (!wrong) return;
    fprintf(stderr, "%s\n", wrong);
    abort();
}

static void fuzz_bytes(unsigned char *bytes, size_t size)
{
    tdsp_matrix matrix;
    if (tdsp_matrix_open(&matrix, bytes, size) != TDSP_OK) return;
    fuzz_require(matrix_walk(&matrix));
    unsigned char step = (unsigned char)(bytes[size - 1] | 1);
    for (size_t i = 0; i < size; i += 1 + step % 13) bytes[i] = (unsigned char)(bytes[i] * 31 + step);
    (void)matrix_walk(&matrix);
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
    matrix_seal(block + 1, size);
    fuzz_bytes(block + 1, size);
    free(block);
    return 0;
}
