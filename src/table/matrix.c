/* SPDX-License-Identifier: MIT */
/*
 * Reading matrices: everything is checked once, from the outside in, so that each check may rely on the ones before.
 *
 *   magic, major version, lengths -> checksums -> sections inside the bytes -> places and names -> pairs, and the table of each
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

/* A section of this size begins at *cursor, and the next at the multiple of 8 behind it, which is inside the bytes like *cursor itself. */
static int matrix_take(const tdsp_matrix *view, uint64_t offset, uint64_t size, uint64_t *cursor)
{
    if (offset != *cursor || size > view->length - offset) return 0;
    uint64_t end = offset + size, next = (end + 7) / 8 * 8;
    if (next > view->length) return 0;
    for (uint64_t i = end; i < next; i++)
        if (view->bytes[i] != 0) return 0;
    *cursor = next;
    return 1;
}

static uint64_t matrix_name_end(const tdsp_matrix *matrix, uint64_t end)
{
    return bytes_get_u64(matrix->bytes + matrix->name_ends + 8 * end);
}

/* Have the bytes room for so many pairs, so for so many ends? Only then do their sizes fit in 64 bits. */
static int matrix_counts_are_good(const tdsp_matrix *view)
{
    if (view->sources == 0 || view->destinations == 0 || view->sources > MATRIX_MOST_ENDS || view->destinations > MATRIX_MOST_ENDS) return 0;
    return view->destinations <= view->length / MATRIX_PAIR_SIZE / view->sources;
}

/* The sections one after the other from *cursor on, which becomes where the tables begin. */
static int matrix_sections(const tdsp_matrix *view, uint64_t *cursor)
{
    if (!matrix_counts_are_good(view)) return 0;
    uint64_t ends = view->sources + view->destinations, pairs = MATRIX_PAIR_SIZE * view->sources * view->destinations;
    if (!matrix_take(view, view->points, MATRIX_POINT_SIZE * ends, cursor) || !matrix_take(view, view->name_ends, 8 * ends, cursor)) return 0;
    if (!matrix_take(view, view->names, matrix_name_end(view, ends - 1), cursor)) return 0;
    return matrix_take(view, view->pairs, pairs, cursor) && bytes_get_u64(view->bytes + MATRIX_AT_TABLES) == *cursor;
}

static tdsp_matrix_end matrix_end(const tdsp_matrix *matrix, uint64_t end)
{
    const unsigned char *place = matrix->bytes + matrix->points + MATRIX_POINT_SIZE * end;
    uint64_t first = end > 0 ? matrix_name_end(matrix, end - 1) : 0, last = matrix_name_end(matrix, end);
    if (last < first || last > matrix->pairs - matrix->names) first = last = 0; /* until that was looked at, and when the bytes have changed since */
    tdsp_matrix_end out = {{bytes_get_f64(place), bytes_get_f64(place + 8)}, (const char *)matrix->bytes + matrix->names + first,
                           (size_t)(last - first)};
    return out;
}

/* Names follow one another, so none ends behind the last, whose end was checked against the bytes. */
static int matrix_ends_are_good(const tdsp_matrix *view)
{
    uint64_t ends = view->sources + view->destinations, before = 0;
    for (uint64_t i = 0; i < ends; i++) {
        uint64_t end = matrix_name_end(view, i);
        if (end < before) return 0;
        tdsp_matrix_end at = matrix_end(view, i);
        if (!round_is_finite(at.place.x) || !round_is_finite(at.place.y)) return 0;
        if (!text_is_utf8((const unsigned char *)at.name, at.name_length)) return 0;
        before = end;
    }
    return 1;
}

static const unsigned char *matrix_pair(const tdsp_matrix *matrix, uint64_t i, uint64_t j)
{
    return matrix->bytes + matrix->pairs + MATRIX_PAIR_SIZE * (i * matrix->destinations + j);
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
    if (!matrix_take(view, offset, length, cursor)) return 0;
    const unsigned char *bytes = view->bytes + offset;
    if (table_open_into(&table, bytes, (size_t)length) != TDSP_OK) return 0;
    return names_place(bytes, FORMAT_AT_SOURCE, matrix_end(view, i).place) &&
           names_place(bytes, FORMAT_AT_DESTINATION, matrix_end(view, view->sources + j).place);
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
    view.points = bytes_get_u64(view.bytes + MATRIX_AT_POINTS);
    view.name_ends = bytes_get_u64(view.bytes + MATRIX_AT_NAME_ENDS);
    view.names = bytes_get_u64(view.bytes + MATRIX_AT_NAMES);
    view.pairs = bytes_get_u64(view.bytes + MATRIX_AT_PAIRS);
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
    if (length > matrix->length || offset > matrix->length - length) return TDSP_BAD_TABLE; /* only when the bytes have changed */
    return tdsp_table_reopen(table, matrix->bytes + offset, (size_t)length);
}
