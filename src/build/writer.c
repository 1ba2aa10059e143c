/* SPDX-License-Identifier: MIT */
/*
 * Rows are collected as they come and laid out at the end, when the counts are known: the sections of docs/format.md one
 * behind the other, then the header with both checksums. See writer.h for the invariant.
 *
 * Where every leg starts at the place where the one before ends, a joint is one waypoint, else (for the whole table) two.
 */
#include "build/writer.h"

#include "base/bytes.h"
#include "base/hash.h"
#include "base/round.h"
#include "base/sizes.h"
#include "build/gap_list.h"
#include "build/leg.h"
#include "scene/allocator.h"
#include "table/guide.h"
#include "tdsp/table.h"

typedef struct writer_kept {
    double departure;
    double left;
    double right;
    size_t leg_end;  /* the row's legs end here; they start where those of the row before end */
    size_t byte_end; /* likewise */
} writer_kept;

struct writer {
    tdsp_allocator allocator;
    writer_kept *rows;
    size_t row_count, row_capacity;
    tdsp_leg *legs;
    size_t leg_count, leg_capacity;
    unsigned char *bytes;
    size_t byte_count, byte_capacity;
    uint64_t arc_count;
    uint64_t curve_count;
    uint64_t path_count; /* rows with legs */
    uint32_t joint;
    gap_list gaps;
};

tdsp_status writer_create(const tdsp_allocator *allocator, writer **out)
{
    tdsp_allocator keep = memory_allocator(allocator);
    writer *w = memory_resize(&keep, NULL, 0, sizeof *w);
    if (!w) return TDSP_NO_MEMORY;
    memset(w, 0, sizeof *w);
    w->allocator = keep;
    w->joint = 1;
    *out = w;
    return TDSP_OK;
}

void writer_free(writer *w)
{
    if (!w) return;
    tdsp_allocator allocator = w->allocator;
    memory_free(&allocator, w->rows, w->row_capacity * sizeof *w->rows);
    memory_free(&allocator, w->legs, w->leg_capacity * sizeof *w->legs);
    memory_free(&allocator, w->bytes, w->byte_capacity);
    gap_list_free(&w->gaps, &allocator);
    memory_free(&allocator, w, sizeof *w);
}

/* ------------------------------------------------------------------------------------------------------ adding rows */

static int writer_path_is_good(const writer_row *row)
{
    for (size_t i = 0; i < row->leg_count; i++) {
        double begins = i == 0 ? row->departure : row->legs[i - 1].end_time;
        if (!leg_is_good(&row->legs[i]) || row->legs[i].start_time != begins) return 0;
    }
    if (row->leg_count == 0) return 1;
    return row->legs[row->leg_count - 1].end_time <= round_add_up(row->departure, row->left);
}

static uint32_t writer_row_joint(const writer_row *row)
{
    for (size_t i = 1; i < row->leg_count; i++) {
        tdsp_point end = row->legs[i - 1].to;
        tdsp_point start = row->legs[i].from;
        if (end.x != start.x || end.y != start.y) return 2;
    }
    return 1;
}

static tdsp_status writer_make_room(writer *w, const writer_row *row)
{
    void *rows = w->rows;
    void *legs = w->legs;
    void *bytes = w->bytes;
    if (row->leg_count > SIZE_MAX - w->leg_count || row->byte_count > SIZE_MAX - w->byte_count) return TDSP_NO_MEMORY;
    tdsp_status status = memory_reserve(&w->allocator, &rows, &w->row_capacity, w->row_count + 1, sizeof *w->rows);
    w->rows = rows;
    if (status != TDSP_OK) return status;
    status = memory_reserve(&w->allocator, &legs, &w->leg_capacity, w->leg_count + row->leg_count, sizeof *w->legs);
    w->legs = legs;
    if (status != TDSP_OK) return status;
    status = memory_reserve(&w->allocator, &bytes, &w->byte_capacity, w->byte_count + row->byte_count, 1);
    w->bytes = bytes;
    return status;
}

static void writer_append(writer *w, const writer_row *row)
{
    if (row->leg_count > 0) memcpy(w->legs + w->leg_count, row->legs, row->leg_count * sizeof *w->legs);
    if (row->byte_count > 0) memcpy(w->bytes + w->byte_count, row->bytes, row->byte_count);
    w->leg_count += row->leg_count;
    w->byte_count += row->byte_count;
    for (size_t i = 0; i < row->leg_count; i++) {
        w->arc_count += row->legs[i].kind == TDSP_LEG_ARC;
        w->curve_count += row->legs[i].kind == TDSP_LEG_CURVE;
    }
    if (row->leg_count > 0) w->path_count++;
    if (writer_row_joint(row) == 2) w->joint = 2;
    writer_kept kept = {row->departure + 0.0, row->left, row->right, w->leg_count, w->byte_count}; /* -0 becomes 0 */
    w->rows[w->row_count++] = kept;
}

tdsp_status writer_add(writer *w, const writer_row *row)
{
    if (!w || !row || (!row->legs && row->leg_count > 0) || (!row->bytes && row->byte_count > 0)) return TDSP_INVALID_ARGUMENT;
    if (row->byte_count > FORMAT_MAX_ROW_BYTES) return TDSP_INVALID_ARGUMENT;
    if (w->row_count == TDSP_MAX_ROWS) return TDSP_TOO_MANY_ROWS;
    if (!writer_path_is_good(row)) return TDSP_BAD_PATH;
    tdsp_status status = writer_make_room(w, row);
    if (status != TDSP_OK) return status;
    writer_append(w, row);
    return TDSP_OK;
}

tdsp_status writer_add_gap(writer *w, size_t row, const tdsp_gap *gap)
{
    return row < w->row_count ? gap_list_add(&w->gaps, &w->allocator, row, gap) : TDSP_INVALID_ARGUMENT;
}

size_t writer_count(const writer *w)
{
    return w->row_count;
}

writer_row writer_row_at(const writer *w, size_t row)
{
    writer_row out = {w->rows[row].departure, w->rows[row].left, w->rows[row].right, NULL, 0, NULL, 0};
    return out;
}

/* ------------------------------------------------------------------------------------------------------- laying out */

/*
 * Cells a row. Fine ones leave a look-up nothing to do but to confirm the row: with eight a departure is at the first row of its cell 19
 * times in 20. A guide that outgrows the nearer caches costs more than it saves, therefore fewer in large tables. Arrivals are asked
 * less. Tables of a few rows are searched as fast without (docs/decisions/0006).
 */
#define WRITER_CELLS 8.0
#define WRITER_CELLS_MEDIUM 4.0
#define WRITER_CELLS_LARGE 1.0
#define WRITER_CELLS_ARRIVAL 2.0
#define WRITER_MEDIUM 8192u /* rows, from which on a table is that */
#define WRITER_LARGE 131072u
#define WRITER_GUIDE_MIN_ROWS 16u

typedef struct writer_guide {
    uint64_t cells; /* 0: no guide */
    double first;
    double scale;
} writer_guide;

static double writer_key(const writer *w, size_t section, size_t row)
{
    const writer_kept *kept = &w->rows[row];
    return section == FORMAT_BY_DEPARTURE ? kept->departure : kept->departure + kept->left;
}

static int writer_keys_rise(const writer *w, size_t section)
{
    for (size_t row = 1; row < w->row_count; row++) {
        if (!(writer_key(w, section, row - 1) <= writer_key(w, section, row))) return 0;
    }
    return round_is_finite(writer_key(w, section, w->row_count - 1));
}

static double writer_cells_per_row(const writer *w, size_t section)
{
    if (section == FORMAT_BY_ARRIVAL) return WRITER_CELLS_ARRIVAL;
    if (w->row_count < WRITER_MEDIUM) return WRITER_CELLS;
    return w->row_count < WRITER_LARGE ? WRITER_CELLS_MEDIUM : WRITER_CELLS_LARGE;
}

/* None where the span is 0 or so small that the cells in a unit are no double. */
static writer_guide writer_lay_out_guide(const writer *w, size_t section)
{
    writer_guide none = {0, 0, 0};
    if (w->row_count < WRITER_GUIDE_MIN_ROWS || !writer_keys_rise(w, section)) return none;
    writer_guide guide = {0, writer_key(w, section, 0), 0};
    double last = writer_key(w, section, w->row_count - 1);
    guide.scale = writer_cells_per_row(w, section) * (double)w->row_count / (last - guide.first);
    if (!round_is_finite(guide.scale)) return none;
    guide.cells = guide_cell(guide.first, guide.scale, last) + 1;
    return guide;
}

typedef struct writer_layout {
    uint64_t waypoints;
    unsigned minor;
    uint64_t header;
    uint64_t offsets[FORMAT_SECTIONS_2];
    uint64_t length;
    writer_guide guides[FORMAT_SECTIONS_1 - FORMAT_SECTIONS];
} writer_layout;

static void writer_lay_out_guides(const writer *w, writer_layout *out, uint64_t sizes[FORMAT_SECTIONS_2])
{
    for (size_t i = FORMAT_SECTIONS; i < FORMAT_SECTIONS_1; i++) {
        writer_guide guide = writer_lay_out_guide(w, i);
        sizes[i] = guide_size(guide.cells);
        out->guides[i - FORMAT_SECTIONS] = guide;
    }
}

/* The lowest version that has every section with anything in it. */
static unsigned writer_minor(const uint64_t sizes[FORMAT_SECTIONS_2])
{
    unsigned minor = 0;
    for (size_t i = FORMAT_SECTIONS; i < FORMAT_SECTIONS_2; i++)
        while (sizes[i] > 0 && i >= format_sections(minor)) minor++;
    return minor;
}

static tdsp_status writer_place_sections(writer_layout *out, const uint64_t sizes[FORMAT_SECTIONS_2])
{
    out->minor = writer_minor(sizes);
    out->header = format_header_length(out->minor);
    out->length = out->header;
    for (size_t i = 0; i < FORMAT_SECTIONS_2; i++) {
        out->offsets[i] = out->length;
        if (!sizes_add(out->length, sizes[i], &out->length) || !sizes_align8(out->length, &out->length)) return TDSP_NO_MEMORY;
    }
    return out->length <= SIZE_MAX ? TDSP_OK : TDSP_NO_MEMORY;
}

/* Waypoints are numbered by 32 bits, of which the last number means none; so are arcs and curves together. */
static tdsp_status writer_lay_out(const writer *w, writer_layout *out)
{
    uint64_t legs = w->leg_count;
    out->waypoints = w->joint == 1 ? legs + w->path_count : 2 * legs;
    if (out->waypoints >= FORMAT_NONE || w->arc_count + w->curve_count >= FORMAT_NONE) return TDSP_NOT_SUPPORTED;
    uint64_t rows = w->row_count;
    uint64_t sizes[FORMAT_SECTIONS_2];
    sizes[FORMAT_DEPARTURES] = sizes[FORMAT_LEFT] = sizes[FORMAT_RIGHT] = 8 * rows;
    sizes[FORMAT_FIRST_WAYPOINT] = legs > 0 ? 4 * (rows + 1) : 0;
    sizes[FORMAT_WAYPOINTS] = FORMAT_WAYPOINT_SIZE * out->waypoints;
    sizes[FORMAT_ARCS] = FORMAT_ARC_SIZE * w->arc_count;
    sizes[FORMAT_FIRST_BYTE] = w->byte_count > 0 ? 8 * (rows + 1) : 0;
    sizes[FORMAT_OPAQUE] = w->byte_count;
    writer_lay_out_guides(w, out, sizes);
    sizes[FORMAT_CURVES] = FORMAT_CURVE_SIZE * w->curve_count;
    sizes[FORMAT_GAPS] = FORMAT_GAP_SIZE * w->gaps.count;
    return writer_place_sections(out, sizes);
}

static void writer_put_paths(const writer *w, const writer_layout *layout, unsigned char *bytes)
{
    leg_cursor at = {.waypoint = bytes + layout->offsets[FORMAT_WAYPOINTS],
                        .arc = bytes + layout->offsets[FORMAT_ARCS],
                        .curve = bytes + layout->offsets[FORMAT_CURVES],
                        .curves = (uint32_t)w->arc_count};
    size_t leg = 0;
    if (w->leg_count == 0) return;
    for (size_t row = 0; row < w->row_count; row++) {
        for (; leg < w->rows[row].leg_end; leg++) {
            leg_put(&at, &w->legs[leg], w->joint == 2 || leg + 1 == w->rows[row].leg_end);
        }
        bytes_put_u32(bytes + layout->offsets[FORMAT_FIRST_WAYPOINT] + 4 * (row + 1), at.waypoints);
    }
}

static void writer_put_rows(const writer *w, const writer_layout *layout, unsigned char *bytes)
{
    for (size_t row = 0; row < w->row_count; row++) {
        bytes_put_f64(bytes + layout->offsets[FORMAT_DEPARTURES] + 8 * row, w->rows[row].departure);
        bytes_put_f64(bytes + layout->offsets[FORMAT_LEFT] + 8 * row, w->rows[row].left);
        bytes_put_f64(bytes + layout->offsets[FORMAT_RIGHT] + 8 * row, w->rows[row].right);
        if (w->byte_count > 0) bytes_put_u64(bytes + layout->offsets[FORMAT_FIRST_BYTE] + 8 * (row + 1), w->rows[row].byte_end);
    }
    if (w->byte_count > 0) memcpy(bytes + layout->offsets[FORMAT_OPAQUE], w->bytes, w->byte_count);
}

/* How many rows are in the cells before each cell: at a block's first cell in full, at each cell what came since, up to a byte. */
static void writer_put_guide(const writer *w, const writer_layout *layout, size_t section, unsigned char *bytes)
{
    const writer_guide *guide = &layout->guides[section - FORMAT_SECTIONS];
    if (guide->cells == 0) return;
    unsigned char *bases = bytes + layout->offsets[section];
    unsigned char *counts = bases + guide_bases_size(guide->cells);
    size_t row = 0, base = 0;
    for (uint64_t cell = 0; cell < guide->cells; cell++) {
        while (guide_cell(guide->first, guide->scale, writer_key(w, section, row)) < cell) row++;
        if (cell % FORMAT_GUIDE_BLOCK == 0) base = row;
        bytes_put_u32(bases + 4 * (cell / FORMAT_GUIDE_BLOCK), (uint32_t)base);
        counts[cell] = (unsigned char)(row - base < FORMAT_GUIDE_FULL ? row - base : FORMAT_GUIDE_FULL);
    }
    bytes_put_u32(counts - 4, (uint32_t)w->row_count);
}

/* ------------------------------------------------------------------------------------------------------- the header */

static tdsp_status writer_put_unit(unsigned char *p, const char *unit)
{
    size_t length = unit ? strlen(unit) : 0;
    if (length >= FORMAT_UNIT_SIZE) return TDSP_INVALID_ARGUMENT;
    if (length > 0) memcpy(p, unit, length); /* NOLINT(bugprone-not-null-terminated-result): the header is zeros up to now */
    return TDSP_OK;
}

static tdsp_status writer_put_world(const tdsp_build_world *world, unsigned char *bytes)
{
    bytes_put_u64(bytes + FORMAT_AT_SCENE_HASH, world->scene_hash);
    bytes_put_f64(bytes + FORMAT_AT_SPEED, world->speed);
    leg_put_point(bytes + FORMAT_AT_SOURCE, world->source);
    leg_put_point(bytes + FORMAT_AT_DESTINATION, world->destination);
    tdsp_status status = writer_put_unit(bytes + FORMAT_AT_LENGTH_UNIT, world->length_unit);
    return status != TDSP_OK ? status : writer_put_unit(bytes + FORMAT_AT_TIME_UNIT, world->time_unit);
}

static void writer_put_promises(const writer_header *header, unsigned char *bytes)
{
    bytes_put_u32(bytes + FORMAT_AT_MONOTONE, (uint32_t)header->monotone);
    bytes_put_u32(bytes + FORMAT_AT_GUARANTEE, (uint32_t)header->guarantee);
    bytes_put_u32(bytes + FORMAT_AT_SAMPLING, (uint32_t)header->sampling);
    bytes_put_u32(bytes + FORMAT_AT_LAST_REASON, (uint32_t)header->last_reason);
    bytes_put_f64(bytes + FORMAT_AT_EPSILON, header->epsilon);
    bytes_put_f64(bytes + FORMAT_AT_DELTA, header->delta);
    bytes_put_f64(bytes + FORMAT_AT_ERROR, header->error);
    bytes_put_f64(bytes + FORMAT_AT_TIME_SCALE, header->time_scale);
    bytes_put_f64(bytes + FORMAT_AT_FIRST_LOWER, header->first_lower);
}

static void writer_put_counts(const writer *w, const writer_layout *layout, unsigned char *bytes)
{
    memcpy(bytes, FORMAT_MAGIC, FORMAT_MAGIC_LENGTH); /* NOLINT(bugprone-not-null-terminated-result): eight bytes, no text */
    bytes_put_u16(bytes + FORMAT_AT_MAJOR, FORMAT_MAJOR);
    bytes_put_u16(bytes + FORMAT_AT_MINOR, (uint16_t)layout->minor);
    bytes_put_u32(bytes + FORMAT_AT_HEADER_LENGTH, (uint32_t)layout->header);
    bytes_put_u64(bytes + FORMAT_AT_LENGTH, layout->length);
    bytes_put_f64(bytes + FORMAT_AT_FIRST_DEPARTURE, w->rows[0].departure);
    bytes_put_f64(bytes + FORMAT_AT_LAST_DEPARTURE, w->rows[w->row_count - 1].departure);
    bytes_put_u64(bytes + FORMAT_AT_ROWS, w->row_count);
    bytes_put_u64(bytes + FORMAT_AT_LEGS, w->leg_count);
    bytes_put_u64(bytes + FORMAT_AT_WAYPOINTS, layout->waypoints);
    bytes_put_u64(bytes + FORMAT_AT_ARCS, w->arc_count);
    bytes_put_u64(bytes + FORMAT_AT_OPAQUE_LENGTH, w->byte_count);
    for (size_t i = 0; i < FORMAT_SECTIONS; i++) bytes_put_u64(bytes + FORMAT_AT_OFFSETS + 8 * i, layout->offsets[i]);
    bytes_put_u32(bytes + FORMAT_AT_JOINT, w->joint);
}

static void writer_put_guide_places(const writer_layout *layout, unsigned char *bytes)
{
    for (size_t i = FORMAT_SECTIONS; i < FORMAT_SECTIONS_1 && layout->minor >= 1; i++) {
        const writer_guide *guide = &layout->guides[i - FORMAT_SECTIONS];
        bytes_put_u64(bytes + format_at_offset(i), layout->offsets[i]);
        bytes_put_u64(bytes + format_at_offset(i) + FORMAT_GUIDE_AT_CELLS, guide->cells);
        bytes_put_f64(bytes + format_at_offset(i) + FORMAT_GUIDE_AT_SCALE, guide->cells > 0 ? guide->scale : 0);
    }
}

static void writer_put_further(const writer *w, const writer_layout *layout, unsigned char *bytes)
{
    const uint64_t counts[] = {w->curve_count, w->gaps.count};
    for (size_t i = FORMAT_SECTIONS_1; i < format_sections(layout->minor); i++) {
        bytes_put_u64(bytes + format_at_offset(i), layout->offsets[i]);
        bytes_put_u64(bytes + format_at_offset(i) + FORMAT_FURTHER_AT_COUNT, counts[i - FORMAT_SECTIONS_1]);
    }
}

/* The header's checksum covers the body's, so the body's is first. */
static void writer_seal(unsigned char *bytes, size_t header, size_t length)
{
    bytes_put_u32(bytes + FORMAT_AT_BODY_CRC, hash_crc32c(0, bytes, header, length));
    uint32_t crc = hash_crc32c(0, bytes, 0, FORMAT_AT_HEADER_CRC);
    crc = hash_crc32c(crc, bytes, FORMAT_AFTER_HEADER_CRC, header);
    bytes_put_u32(bytes + FORMAT_AT_HEADER_CRC, crc);
}

static tdsp_status writer_fill(const writer *w, const writer_header *header, const writer_layout *layout, unsigned char *bytes)
{
    tdsp_table check;
    memset(bytes, 0, (size_t)layout->length);
    writer_put_counts(w, layout, bytes);
    writer_put_promises(header, bytes);
    tdsp_status status = writer_put_world(&header->world, bytes);
    if (status != TDSP_OK) return status;
    writer_put_rows(w, layout, bytes);
    writer_put_paths(w, layout, bytes);
    writer_put_guide_places(layout, bytes);
    writer_put_further(w, layout, bytes);
    for (size_t i = FORMAT_SECTIONS; i < FORMAT_SECTIONS_1; i++) writer_put_guide(w, layout, i, bytes);
    gap_list_put(&w->gaps, bytes + layout->offsets[FORMAT_GAPS]);
    writer_seal(bytes, (size_t)layout->header, (size_t)layout->length);
    return tdsp_table_open(&check, bytes, (size_t)layout->length);
}

tdsp_status writer_finish(const writer *w, const writer_header *header, void **bytes, size_t *length)
{
    writer_layout layout;
    if (!w || !header || !bytes || !length || w->row_count == 0) return TDSP_INVALID_ARGUMENT;
    tdsp_status status = writer_lay_out(w, &layout);
    if (status != TDSP_OK) return status;
    unsigned char *made = memory_resize(&w->allocator, NULL, 0, (size_t)layout.length);
    if (!made) return TDSP_NO_MEMORY;
    status = writer_fill(w, header, &layout, made);
    if (status != TDSP_OK) {
        memory_free(&w->allocator, made, (size_t)layout.length);
        return status;
    }
    *bytes = made;
    *length = (size_t)layout.length;
    return TDSP_OK;
}

void tdsp_bytes_free(const tdsp_allocator *allocator, void *bytes, size_t length)
{
    tdsp_allocator from = memory_allocator(allocator);
    memory_free(&from, bytes, length);
}
