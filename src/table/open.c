/* SPDX-License-Identifier: MIT */
/*
 * Opening a table: everything is checked once, from the outside in, so that each check may rely on the ones before.
 *
 *   magic, major version, lengths -> checksums -> sections inside the bytes -> header values -> rows -> paths, opaque bytes -> guides, gaps
 */
#include "base/bytes.h"
#include "base/hash.h"
#include "table/check.h"
#include "table/guide.h"
#include "tdsp/table.h"

static unsigned open_minor(const unsigned char *bytes)
{
    return bytes_get_u16(bytes + FORMAT_AT_MINOR);
}

/* *header becomes the header's length, read once: what was checked is what is used, whatever becomes of the bytes. */
static tdsp_status open_lengths(const unsigned char *bytes, size_t length, uint32_t *header)
{
    if (length < FORMAT_MAGIC_LENGTH || memcmp(bytes, FORMAT_MAGIC, FORMAT_MAGIC_LENGTH) != 0) return TDSP_BAD_MAGIC;
    if (length < FORMAT_AT_HEADER_LENGTH) return TDSP_BAD_LENGTH;
    if (bytes_get_u16(bytes + FORMAT_AT_MAJOR) != FORMAT_MAJOR) return TDSP_BAD_VERSION;
    if (length < FORMAT_HEADER_LENGTH || bytes_get_u64(bytes + FORMAT_AT_LENGTH) != length) return TDSP_BAD_LENGTH;
    *header = bytes_get_u32(bytes + FORMAT_AT_HEADER_LENGTH);
    uint32_t least = (uint32_t)format_header_length(open_minor(bytes));
    if (*header < least || (open_minor(bytes) <= FORMAT_MINOR && *header > least)) return TDSP_BAD_TABLE;
    return *header % 8 == 0 && *header <= length ? TDSP_OK : TDSP_BAD_TABLE;
}

static tdsp_status open_checksums(const unsigned char *bytes, size_t length, uint32_t header)
{
    uint32_t crc = hash_crc32c(0, bytes, 0, FORMAT_AT_HEADER_CRC);
    crc = hash_crc32c(crc, bytes, FORMAT_AFTER_HEADER_CRC, header);
    if (crc != bytes_get_u32(bytes + FORMAT_AT_HEADER_CRC)) return TDSP_BAD_CHECKSUM;
    crc = hash_crc32c(0, bytes, header, length);
    return crc == bytes_get_u32(bytes + FORMAT_AT_BODY_CRC) ? TDSP_OK : TDSP_BAD_CHECKSUM;
}

/*
 * Have the bytes room for so many items, wherever they are? Only then is what they take a size. The length came as a size_t, which a small machine
 * divides much faster; and each number is compared where it stands, as the proof needs.
 */
static int open_counts_are_good(const tdsp_table *table)
{
    size_t length = (size_t)table->length;
    if (table->by_departure.cells > FORMAT_GUIDE_MAX || table->by_arrival.cells > FORMAT_GUIDE_MAX) return 0;
    if (table->arc_count > FORMAT_NONE || table->curve_count > FORMAT_NONE - table->arc_count) return 0;
    return table->rows > 0 && table->rows <= length / (3 * 8) && table->waypoint_count <= length / FORMAT_WAYPOINT_SIZE &&
           table->arc_count <= length / FORMAT_ARC_SIZE && table->opaque_length <= length && table->by_departure.cells <= length &&
           table->by_arrival.cells <= length && table->curve_count <= length / FORMAT_CURVE_SIZE &&
           table->gap_count <= length / FORMAT_GAP_SIZE;
}

/* Sizes of the sections; the optional ones are empty when there is nothing to index. */
static void open_sizes(const tdsp_table *table, uint64_t sizes[FORMAT_SECTIONS_2])
{
    sizes[FORMAT_DEPARTURES] = sizes[FORMAT_LEFT] = sizes[FORMAT_RIGHT] = 8 * table->rows;
    sizes[FORMAT_FIRST_WAYPOINT] = table->waypoint_count > 0 ? 4 * (table->rows + 1) : 0;
    sizes[FORMAT_WAYPOINTS] = FORMAT_WAYPOINT_SIZE * table->waypoint_count;
    sizes[FORMAT_ARCS] = FORMAT_ARC_SIZE * table->arc_count;
    sizes[FORMAT_FIRST_BYTE] = table->opaque_length > 0 ? 8 * (table->rows + 1) : 0;
    sizes[FORMAT_OPAQUE] = table->opaque_length;
    sizes[FORMAT_BY_DEPARTURE] = guide_size(table->by_departure.cells);
    sizes[FORMAT_BY_ARRIVAL] = guide_size(table->by_arrival.cells);
    sizes[FORMAT_CURVES] = FORMAT_CURVE_SIZE * table->curve_count;
    sizes[FORMAT_GAPS] = FORMAT_GAP_SIZE * table->gap_count;
}

static int open_padding_is_zero(const unsigned char *bytes, uint64_t from, uint64_t to)
{
    for (uint64_t i = from; i < to; i++) {
        if (bytes[i] != 0) return 0;
    }
    return 1;
}

/*
 * One section, from *cursor on in the versions known here; a later minor version may put something between or behind the sections. On
 * success *offset is where it starts, and *cursor the next multiple of 8 behind it, which is inside the bytes.
 */
static int open_section(const tdsp_table *table, size_t section, uint64_t size, uint64_t *cursor, uint64_t *offset)
{
    uint64_t length = table->length;
    uint64_t at = bytes_get_u64(table_at(table, format_at_offset(section), 8));
    if (at < *cursor || at % 8 != 0) return 0;
    if (open_minor(table->bytes) <= FORMAT_MINOR && at > *cursor) return 0;
    if (size > length || at > length - size) return 0;
    uint64_t next = (at + size + 7) / 8 * 8;
    if (next > length || !open_padding_is_zero(table->bytes, at + size, next)) return 0;
    *offset = at;
    *cursor = next;
    return 1;
}

static int open_sections(const tdsp_table *table, uint32_t header, uint64_t offsets[FORMAT_SECTIONS_2])
{
    uint64_t sizes[FORMAT_SECTIONS_2];
    uint64_t cursor = header;
    unsigned minor = open_minor(table->bytes);
    size_t sections = format_sections(minor);
    if (!open_counts_are_good(table)) return 0;
    open_sizes(table, sizes);
    for (size_t i = 0; i < sections; i++) {
        if (!open_section(table, i, sizes[i], &cursor, &offsets[i])) return 0;
    }
    return minor > FORMAT_MINOR || cursor == table->length;
}

/* The times a guide spans are put in when the rows are known to be good. */
static void open_guide(const tdsp_table *table, size_t section, tdsp_guide *guide)
{
    memset(guide, 0, sizeof *guide);
    if (open_minor(table->bytes) == 0) return;
    const unsigned char *p = table_at(table, format_at_offset(section), FORMAT_GUIDE_SIZE);
    guide->cells = bytes_get_u64(p + FORMAT_GUIDE_AT_CELLS);
    guide->scale = bytes_get_f64(p + FORMAT_GUIDE_AT_SCALE);
}

/* How many items a section has that came with version 1.2. */
static uint64_t open_count(const tdsp_table *table, size_t section)
{
    if (section >= format_sections(open_minor(table->bytes))) return 0;
    return bytes_get_u64(table_at(table, format_at_offset(section), FORMAT_FURTHER_SIZE) + FORMAT_FURTHER_AT_COUNT);
}

static void open_view(tdsp_table *table, const unsigned char *bytes, size_t length)
{
    table->bytes = bytes;
    table->length = length;
    table->last_word = length - 8;
    table->rows = bytes_get_u64(bytes + FORMAT_AT_ROWS);
    table->waypoint_count = bytes_get_u64(bytes + FORMAT_AT_WAYPOINTS);
    table->arc_count = bytes_get_u64(bytes + FORMAT_AT_ARCS);
    table->opaque_length = bytes_get_u64(bytes + FORMAT_AT_OPAQUE_LENGTH);
    table->monotone = bytes_get_u32(bytes + FORMAT_AT_MONOTONE);
    table->joint = bytes_get_u32(bytes + FORMAT_AT_JOINT);
    open_guide(table, FORMAT_BY_DEPARTURE, &table->by_departure);
    open_guide(table, FORMAT_BY_ARRIVAL, &table->by_arrival);
    table->curve_count = open_count(table, FORMAT_CURVES);
    table->gap_count = open_count(table, FORMAT_GAPS);
}

static void open_place_guide(tdsp_guide *guide, uint64_t offset)
{
    if (guide->cells == 0) return;
    guide->bases = offset;
    guide->counts = offset + guide_bases_size(guide->cells);
}

static void open_place(tdsp_table *table, const uint64_t offsets[FORMAT_SECTIONS_2])
{
    table->departures = offsets[FORMAT_DEPARTURES];
    table->left = offsets[FORMAT_LEFT];
    table->right = offsets[FORMAT_RIGHT];
    table->first_waypoint = offsets[FORMAT_FIRST_WAYPOINT];
    table->waypoints = offsets[FORMAT_WAYPOINTS];
    table->arcs = offsets[FORMAT_ARCS];
    table->first_byte = offsets[FORMAT_FIRST_BYTE];
    table->opaque = offsets[FORMAT_OPAQUE];
    table->curves = offsets[FORMAT_CURVES];
    table->gaps = offsets[FORMAT_GAPS];
    open_place_guide(&table->by_departure, offsets[FORMAT_BY_DEPARTURE]);
    open_place_guide(&table->by_arrival, offsets[FORMAT_BY_ARRIVAL]);
}

/* The rows are good: departures rise from 0. (Should the first be -0 and the only one, its bits would not be 0.) */
static void open_span(tdsp_table *table)
{
    uint64_t row = table->rows - 1;
    double last = table_departure(table, row);
    table->last = row > 0 ? table_departure_bits(table, row) : 0;
    table->by_departure.last = last;
    table->by_arrival.first = guide_arrival(table, 0);
    table->by_arrival.last = guide_arrival(table, row);
}

/* The view of bytes whose sections lie inside them. */
static int open_view_placed(tdsp_table *view, const unsigned char *bytes, size_t length, uint32_t header)
{
    uint64_t offsets[FORMAT_SECTIONS_2] = {0};
    open_view(view, bytes, length);
    if (!open_sections(view, header, offsets)) return 0;
    open_place(view, offsets);
    return 1;
}

tdsp_status table_open_into(tdsp_table *view, const void *bytes, size_t length)
{
    uint32_t header;
    tdsp_status status = open_lengths(bytes, length, &header);
    if (status == TDSP_OK) status = open_checksums(bytes, length, header);
    if (status != TDSP_OK) return status;
    memset(view, 0, sizeof *view);
    if (!open_view_placed(view, bytes, length, header)) return TDSP_BAD_TABLE;
    if (!check_header(view) || !check_rows(view) || !check_paths(view) || !check_opaque(view)) return TDSP_BAD_TABLE;
    open_span(view);
    return check_guides(view) && check_gaps(view) ? TDSP_OK : TDSP_BAD_TABLE;
}

tdsp_status tdsp_table_open(tdsp_table *table, const void *bytes, size_t length)
{
    tdsp_table view;
    if (!table || !bytes) return TDSP_INVALID_ARGUMENT;
    tdsp_status status = table_open_into(&view, bytes, length);
    if (status == TDSP_OK) *table = view;
    return status;
}

/* Only what keeps reads inside the bytes is checked anew. */
tdsp_status tdsp_table_reopen(tdsp_table *table, const void *bytes, size_t length)
{
    tdsp_table view = {0};
    uint32_t header;
    if (!table || !bytes) return TDSP_INVALID_ARGUMENT;
    tdsp_status status = open_lengths(bytes, length, &header);
    if (status != TDSP_OK) return status;
    if (!open_view_placed(&view, bytes, length, header)) return TDSP_BAD_TABLE;
    open_span(&view);
    *table = view;
    return TDSP_OK;
}
