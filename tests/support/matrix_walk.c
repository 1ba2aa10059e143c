/* SPDX-License-Identifier: MIT */
/* See matrix_walk.h. */
#include "support/matrix_walk.h"

#include "base/bytes.h"
#include "base/hash.h"
#include "support/golden.h"
#include "support/walk.h"
#include "table/format.h"
#include "table/matrix.h"

static void seal_tables(unsigned char *bytes, size_t length)
{
    uint64_t at = bytes_get_u64(bytes + MATRIX_AT_PAIRS), end = bytes_get_u64(bytes + MATRIX_AT_TABLES);
    for (; at < end && end <= length && end - at >= MATRIX_PAIR_SIZE; at += MATRIX_PAIR_SIZE) {
        uint64_t offset = bytes_get_u64(bytes + at + MATRIX_PAIR_AT_OFFSET), size = bytes_get_u64(bytes + at + MATRIX_PAIR_AT_LENGTH);
        if (offset >= end && offset <= length && size <= length - offset && size >= FORMAT_HEADER_LENGTH) golden_seal(bytes + offset, (size_t)size);
    }
}

void matrix_seal(unsigned char *bytes, size_t length)
{
    if (length < MATRIX_HEADER_LENGTH) return;
    uint32_t header = bytes_get_u32(bytes + MATRIX_AT_HEADER_LENGTH);
    seal_tables(bytes, length);
    if (header < MATRIX_AFTER_HEADER_CRC || header > length) return;
    bytes_put_u32(bytes + MATRIX_AT_BODY_CRC, hash_crc32c(0, bytes, header, length));
    uint32_t crc = hash_crc32c(0, bytes, 0, MATRIX_AT_HEADER_CRC);
    bytes_put_u32(bytes + MATRIX_AT_HEADER_CRC, hash_crc32c(crc, bytes, MATRIX_AFTER_HEADER_CRC, header));
}

static const char *walk_end(const tdsp_matrix_end *end)
{
    unsigned sum = 0;
    for (size_t i = 0; i < end->name_length; ++i) sum += (unsigned char)end->name[i];
    return sum > 255u * end->name_length ? "a name's bytes" : NULL;
}

const char *matrix_walk(const tdsp_matrix *matrix)
{
    uint64_t sources, destinations;
    tdsp_matrix_end end;
    tdsp_table table;
    const char *wrong = NULL;
    if (tdsp_matrix_size(matrix, &sources, &destinations) != TDSP_OK) return "size";
    for (uint64_t i = 0; i < sources && !wrong; ++i) wrong = tdsp_matrix_source(matrix, i, &end) == TDSP_OK ? walk_end(&end) : "source";
    for (uint64_t j = 0; j < destinations && !wrong; ++j) wrong = tdsp_matrix_destination(matrix, j, &end) == TDSP_OK ? walk_end(&end) : "destination";
    for (uint64_t i = 0; i < sources && !wrong; ++i)
        for (uint64_t j = 0; j < destinations && !wrong; ++j)
            if (tdsp_matrix_table(matrix, i, j, &table) == TDSP_OK) wrong = walk_table(&table);
    return wrong;
}
