/* SPDX-License-Identifier: MIT */
/*
 * Reading matrices: everything is checked once, from the outside in, so that each check may rely on the ones before.
 *
 *   magic, major version, lengths -> checksums -> sections inside the bytes -> places and names -> pairs, and the table of each
 *
 * Every place is kept inside the bytes as it is read, as in read.h: so no read leaves them even when they change afterwards, and tests/proof can see it.
 */
#include "table/matrix.h"

#include "base/bytes.h"
#include "base/hash.h"
#include "base/round.h"
#include "base/text.h"
#include "table/check.h"
#include "table/format.h"
#include "tdsp/matrix.h"

/* *header becomes the header's length, read once: what was checked is what is used, whatever becomes of the bytes. */
static tdsp_status matrix_lengths(const unsigned char *bytes, size_t length, uint32_t *header)
{
    if (length < MATRIX_MAGIC_LENGTH || memcmp(bytes, MATRIX_MAGIC, MATRIX_MAGIC_LENGTH) != 0) return TDSP_BAD_MAGIC;
    if (length < MATRIX_AT_HEADER_LENGTH) return TDSP_BAD_LENGTH;
    if (bytes_get_u16(bytes + MATRIX_AT_MAJOR) != MATRIX_MAJOR) return TDSP_BAD_VERSION;
    if (length < MATRIX_HEADER_LENGTH || bytes_get_u64(bytes + MATRIX_AT_LENGTH) != length) return TDSP_BAD_LENGTH;
    *header = bytes_get_u32(bytes + MATRIX_AT_HEADER_LENGTH);
    int known = bytes_get_u16(bytes + MATRIX_AT_MINOR) <= MATRIX_MINOR;
    if (known ? *header != MATRIX_HEADER_LENGTH : *header < MATRIX_HEADER_LENGTH) return TDSP_BAD_TABLE;
    return *header % 8 == 0 && *header <= length ? TDSP_OK : TDSP_BAD_TABLE;
}

static tdsp_status matrix_checksums(const unsigned char *bytes, size_t length, uint32_t header)
{
    uint32_t crc = hash_crc32c(0, bytes, 0, MATRIX_AT_HEADER_CRC);
    crc = hash_crc32c(crc, bytes, MATRIX_AFTER_HEADER_CRC, header);
    if (crc != bytes_get_u32(bytes + MATRIX_AT_HEADER_CRC)) return TDSP_BAD_CHECKSUM;
    crc = hash_crc32c(0, bytes, header, length);
    return crc == bytes_get_u32(bytes + MATRIX_AT_BODY_CRC) ? TDSP_OK : TDSP_BAD_CHECKSUM;
}

/* What begins behind `end` begins at the next multiple of 8, which is inside the bytes: *cursor becomes that. */
static int matrix_pad(const tdsp_matrix *view, uint64_t end, uint64_t *cursor)
{
    uint64_t next = (end + 7) / 8 * 8;
    if (next > view->length) return 0;
    for (uint64_t i = end; i < next; i++)
        if (view->bytes[i] != 0) return 0;
    *cursor = next;
    return 1;
}

/* `size` bytes of the matrix, at most a header's, from offset `at` on; the header's first instead of any outside. */
static const unsigned char *matrix_at(const tdsp_matrix *matrix, uint64_t at, uint64_t size)
{
    return matrix->bytes + (at <= matrix->length - size ? at : 0);
}

static tdsp_point matrix_place(const tdsp_matrix *matrix, uint64_t end)
{
    const unsigned char *p = matrix_at(matrix, matrix->points + MATRIX_POINT_SIZE * end, MATRIX_POINT_SIZE);
    tdsp_point place = {bytes_get_f64(p), bytes_get_f64(p + 8)};
    return place;
}

static uint64_t matrix_name_end(const tdsp_matrix *matrix, uint64_t end)
{
    return bytes_get_u64(matrix_at(matrix, matrix->name_ends + 8 * end, 8));
}

/* Have the bytes room for so many pairs, so for so many ends? Only then do their sizes fit in 64 bits. */
static int matrix_counts_are_good(const tdsp_matrix *view)
{
    if (view->sources == 0 || view->destinations == 0 || view->sources > MATRIX_MOST_ENDS || view->destinations > MATRIX_MOST_ENDS) return 0;
    return view->destinations <= view->length / MATRIX_PAIR_SIZE / view->sources;
}

/* A section begins at *cursor, which the header says at `stated_at`: *offset becomes that, and *cursor where the next begins. */
static int matrix_section(const tdsp_matrix *view, size_t stated_at, uint64_t size, uint64_t *cursor, uint64_t *offset)
{
    *offset = bytes_get_u64(view->bytes + stated_at);
    if (*offset != *cursor || size > view->length - *offset) return 0;
    return matrix_pad(view, *offset + size, cursor);
}

/* The sections one after the other from *cursor on, which becomes where the tables begin. */
static int matrix_sections(tdsp_matrix *view, uint64_t *cursor)
{
    if (!matrix_counts_are_good(view)) return 0;
    uint64_t ends = view->sources + view->destinations, pairs = MATRIX_PAIR_SIZE * view->sources * view->destinations;
    if (!matrix_section(view, MATRIX_AT_POINTS, MATRIX_POINT_SIZE * ends, cursor, &view->points)) return 0;
    if (!matrix_section(view, MATRIX_AT_NAME_ENDS, 8 * ends, cursor, &view->name_ends)) return 0;
    if (!matrix_section(view, MATRIX_AT_NAMES, matrix_name_end(view, ends - 1), cursor, &view->names)) return 0;
    return matrix_section(view, MATRIX_AT_PAIRS, pairs, cursor, &view->pairs) && bytes_get_u64(view->bytes + MATRIX_AT_TABLES) == *cursor;
}

/* A name lies from the names' offset on and before the pairs'; one that does not, as only changed bytes have, is empty. */
static tdsp_matrix_end matrix_end(const tdsp_matrix *matrix, uint64_t end)
{
    tdsp_matrix_end out = {matrix_place(matrix, end), NULL, 0};
    uint64_t at = matrix->names + (end > 0 ? matrix_name_end(matrix, end - 1) : 0);
    uint64_t next = matrix->names + matrix_name_end(matrix, end);
    if (at < matrix->names || at > matrix->pairs) at = matrix->names;
    if (next < at || next > matrix->pairs) next = at;
    out.name = (const char *)matrix->bytes + at;
    out.name_length = (size_t)(next - at);
    return out;
}

/* Names follow one another. */
static int matrix_ends_are_good(const tdsp_matrix *view)
{
    uint64_t ends = view->sources + view->destinations, at = view->names;
    for (uint64_t i = 0; i < ends; i++) {
        tdsp_point place = matrix_place(view, i);
        uint64_t next = view->names + matrix_name_end(view, i);
        if (next < at || next > view->pairs) return 0;
        if (!round_is_finite(place.x) || !round_is_finite(place.y)) return 0;
        if (!text_is_utf8(view->bytes, (size_t)at, (size_t)next)) return 0;
        at = next;
    }
    return 1;
}

static const unsigned char *matrix_pair(const tdsp_matrix *matrix, uint64_t i, uint64_t j)
{
    return matrix_at(matrix, matrix->pairs + MATRIX_PAIR_SIZE * (i * matrix->destinations + j), MATRIX_PAIR_SIZE);
}

/* Does a table's header have this place at an offset? */
static int names_place(const unsigned char *table, size_t at, tdsp_point place)
{
    return bytes_get_f64(table + at) == place.x && bytes_get_f64(table + at + 8) == place.y;
}

static int matrix_is_reason(uint32_t status)
{
    return status == TDSP_SOURCE_COVERED || status == TDSP_DESTINATION_COVERED || status == TDSP_CUT_OFF || status == TDSP_UNREACHABLE;
}

/* A pair's table begins at *cursor and leads from the one end to the other. */
static int matrix_pair_is_good(const tdsp_matrix *view, uint64_t i, uint64_t j, uint64_t *cursor)
{
    const unsigned char *pair = matrix_pair(view, i, j);
    uint64_t offset = bytes_get_u64(pair + MATRIX_PAIR_AT_OFFSET), length = bytes_get_u64(pair + MATRIX_PAIR_AT_LENGTH);
    uint32_t status = bytes_get_u32(pair + MATRIX_PAIR_AT_STATUS);
    tdsp_table table;
    if (bytes_get_u32(pair + MATRIX_PAIR_AT_ZERO) != 0) return 0;
    if (status != TDSP_OK) return offset == 0 && length == 0 && matrix_is_reason(status);
    if (offset != *cursor || length > view->length - offset || !matrix_pad(view, offset + length, cursor)) return 0;
    const unsigned char *bytes = view->bytes + offset;
    if (table_open_into(&table, bytes, (size_t)length) != TDSP_OK) return 0;
    return names_place(bytes, FORMAT_AT_SOURCE, matrix_place(view, i)) &&
           names_place(bytes, FORMAT_AT_DESTINATION, matrix_place(view, view->sources + j));
}

static int matrix_pairs_are_good(const tdsp_matrix *view, uint64_t cursor)
{
    for (uint64_t i = 0; i < view->sources; i++)
        for (uint64_t j = 0; j < view->destinations; j++)
            if (!matrix_pair_is_good(view, i, j, &cursor)) return 0;
    return cursor == view->length || bytes_get_u16(view->bytes + MATRIX_AT_MINOR) > MATRIX_MINOR;
}

tdsp_status tdsp_matrix_open(tdsp_matrix *matrix, const void *bytes, size_t length)
{
    uint32_t header;
    if (!matrix || !bytes) return TDSP_INVALID_ARGUMENT;
    tdsp_status status = matrix_lengths(bytes, length, &header);
    if (status == TDSP_OK) status = matrix_checksums(bytes, length, header);
    if (status != TDSP_OK) return status;
    uint64_t cursor = header;
    tdsp_matrix view = {.bytes = bytes, .length = length};
    view.sources = bytes_get_u64(view.bytes + MATRIX_AT_SOURCES);
    view.destinations = bytes_get_u64(view.bytes + MATRIX_AT_DESTINATIONS);
    if (!matrix_sections(&view, &cursor) || !matrix_ends_are_good(&view) || !matrix_pairs_are_good(&view, cursor)) return TDSP_BAD_TABLE;
    *matrix = view;
    return TDSP_OK;
}

tdsp_status tdsp_matrix_size(const tdsp_matrix *matrix, uint64_t *sources, uint64_t *destinations)
{
    if (!matrix) return TDSP_INVALID_ARGUMENT;
    if (sources) *sources = matrix->sources;
    if (destinations) *destinations = matrix->destinations;
    return TDSP_OK;
}

tdsp_status tdsp_matrix_source(const tdsp_matrix *matrix, uint64_t i, tdsp_matrix_end *out)
{
    if (!matrix || !out || i >= matrix->sources) return TDSP_INVALID_ARGUMENT;
    *out = matrix_end(matrix, i);
    return TDSP_OK;
}

tdsp_status tdsp_matrix_destination(const tdsp_matrix *matrix, uint64_t j, tdsp_matrix_end *out)
{
    if (!matrix || !out || j >= matrix->destinations) return TDSP_INVALID_ARGUMENT;
    *out = matrix_end(matrix, matrix->sources + j);
    return TDSP_OK;
}

tdsp_status tdsp_matrix_table(const tdsp_matrix *matrix, uint64_t i, uint64_t j, tdsp_table *table)
{
    if (!matrix || !table || i >= matrix->sources || j >= matrix->destinations) return TDSP_INVALID_ARGUMENT;
    const unsigned char *pair = matrix_pair(matrix, i, j);
    uint32_t status = bytes_get_u32(pair + MATRIX_PAIR_AT_STATUS);
    if (status != TDSP_OK) return matrix_is_reason(status) ? (tdsp_status)status : TDSP_BAD_TABLE;
    uint64_t offset = bytes_get_u64(pair + MATRIX_PAIR_AT_OFFSET), length = bytes_get_u64(pair + MATRIX_PAIR_AT_LENGTH);
    if (offset > matrix->length) return TDSP_BAD_TABLE; /* this and the next only when the bytes have changed */
    if (length > matrix->length - offset) return TDSP_BAD_TABLE;
    return tdsp_table_reopen(table, matrix->bytes + offset, (size_t)length);
}
