/* SPDX-License-Identifier: MIT */
/*
 * Matrices that break one rule of the format where every other rule is kept and the checksums fit: what only that rule refuses.
 *
 * All are laid out from one sheet of numbers, from two sources to two destinations. Where a rule is about sections, no pair has a table, so that
 * what is left of the file is right wherever it lies. Those that a reader without the rule would read past lie right before memory that must not be read.
 */
#include "support/cmocka_all.h"

#include <stdlib.h>

#include "base/bytes.h"
#include "support/brink.h"
#include "support/golden.h"
#include "support/matrix_walk.h"
#include "table/format.h"
#include "table/matrix.h"

#define ROOM 4096
#define BEHIND 64 /* bytes behind the matrix, of a pattern */
#define NAMES 8 /* "a", "bc", "", "d" and four zeros */

enum { SOURCES = 2, ENDS = 4, PAIRS = 4 };
enum { GAP, ROAD, LOOSE, STILL, CROWD, SWELL, SQUEEZE };

typedef struct edge {
    unsigned char bytes[ROOM + BEHIND];
    size_t length;
    size_t points, name_ends, names, pairs, tables;
} edge;

static const tdsp_point places[ENDS] = {{1.0, 2.0}, {-3.0, 4.5}, {0.0, 7.0}, {8.0, 0x1p-1074}}; /* the last, as a whole number, is 1 */
static const uint64_t name_ends[ENDS] = {1, 3, 3, 4};

static unsigned char *pair_at(edge *e, size_t i)
{
    return e->bytes + e->pairs + MATRIX_PAIR_SIZE * i;
}

static void put_place(unsigned char *at, tdsp_point place)
{
    bytes_put_f64(at, place.x);
    bytes_put_f64(at + 8, place.y);
}

static tdsp_point get_place(const unsigned char *at)
{
    return (tdsp_point){bytes_get_f64(at), bytes_get_f64(at + 8)};
}

static void edge_put_offsets(edge *e)
{
    const size_t offsets[] = {e->points, e->name_ends, e->names, e->pairs, e->tables};
    bytes_put_u64(e->bytes + MATRIX_AT_LENGTH, e->length);
    for (size_t i = 0; i < 5; i++) bytes_put_u64(e->bytes + MATRIX_AT_POINTS + 8 * i, offsets[i]);
}

/* What the offsets say is written there. */
static void edge_write(edge *e)
{
    edge_put_offsets(e);
    for (size_t i = 0; i < ENDS; i++) {
        put_place(e->bytes + e->points + MATRIX_POINT_SIZE * i, places[i]);
        bytes_put_u64(e->bytes + e->name_ends + 8 * i, name_ends[i]);
    }
    memcpy(e->bytes + e->names, "abcd\0\0\0\0", NAMES);
    for (size_t i = 0; i < PAIRS; i++) bytes_put_u32(pair_at(e, i) + MATRIX_PAIR_AT_STATUS, TDSP_UNREACHABLE);
}

/* The sections one after the other from `at` on, and the end behind them. */
static void edge_lay(edge *e, size_t at)
{
    e->points = at;
    e->name_ends = (e->points + MATRIX_POINT_SIZE * ENDS + 7) / 8 * 8;
    e->names = e->name_ends + 8 * ENDS;
    e->pairs = e->names + NAMES;
    e->length = e->tables = e->pairs + MATRIX_PAIR_SIZE * PAIRS;
}

static edge edge_of(unsigned minor, uint32_t header)
{
    edge e = {.length = 0};
    memset(e.bytes + ROOM, 0x5a, BEHIND);
    memcpy(e.bytes, MATRIX_MAGIC, MATRIX_MAGIC_LENGTH);
    bytes_put_u16(e.bytes + MATRIX_AT_MAJOR, MATRIX_MAJOR);
    bytes_put_u16(e.bytes + MATRIX_AT_MINOR, (uint16_t)minor);
    bytes_put_u32(e.bytes + MATRIX_AT_HEADER_LENGTH, header);
    bytes_put_u64(e.bytes + MATRIX_AT_SOURCES, SOURCES);
    bytes_put_u64(e.bytes + MATRIX_AT_DESTINATIONS, ENDS - SOURCES);
    edge_lay(&e, header);
    return e;
}

static edge edge_plain(void)
{
    edge e = edge_of(MATRIX_MINOR, MATRIX_HEADER_LENGTH);
    edge_write(&e);
    return e;
}

/* A table from the first source to the first destination: whose places are the table's, then. */
static edge edge_with(size_t which)
{
    edge e = edge_plain();
    size_t length;
    unsigned char *table = golden_write(&golden_tables[which], &length), *pair = pair_at(&e, 0);
    assert_non_null(table);
    assert_true(e.tables + length <= ROOM);
    memcpy(e.bytes + e.tables, table, length);
    put_place(e.bytes + e.points, get_place(table + FORMAT_AT_SOURCE));
    put_place(e.bytes + e.points + MATRIX_POINT_SIZE * SOURCES, get_place(table + FORMAT_AT_DESTINATION));
    bytes_put_u64(pair + MATRIX_PAIR_AT_OFFSET, e.tables);
    bytes_put_u64(pair + MATRIX_PAIR_AT_LENGTH, length);
    bytes_put_u32(pair + MATRIX_PAIR_AT_STATUS, TDSP_OK);
    e.length += length;
    bytes_put_u64(e.bytes + MATRIX_AT_LENGTH, e.length);
    free(table);
    return e;
}

static tdsp_status edge_open(edge *e, tdsp_matrix *matrix)
{
    matrix_seal(e->bytes, e->length);
    return tdsp_matrix_open(matrix, e->bytes, e->length);
}

static tdsp_status brink_open(edge *e)
{
    tdsp_matrix matrix;
    matrix_seal(e->bytes, e->length);
    brink b = brink_of(e->bytes, e->length);
    tdsp_status status = tdsp_matrix_open(&matrix, b.bytes, e->length);
    brink_free(b);
    return status;
}

static void assert_opens(edge e, tdsp_status status)
{
    tdsp_matrix matrix;
    assert_int_equal(edge_open(&e, &matrix), status);
    if (status == TDSP_OK) assert_null(matrix_walk(&matrix));
}

/* ------------------------------------------------------------------------------------------------------------- whole */

static void a_sheet_with_nothing_wrong_opens_and_says_what_is_on_it(void **state)
{
    (void)state;
    static const char *const names[ENDS] = {"a", "bc", "", "d"};
    edge e = edge_with(GAP);
    tdsp_matrix matrix;
    tdsp_matrix_end end;
    tdsp_table table;
    assert_opens(edge_plain(), TDSP_OK);
    assert_int_equal(edge_open(&e, &matrix), TDSP_OK);
    for (uint64_t i = 0; i < ENDS; i++) {
        assert_int_equal(i < SOURCES ? tdsp_matrix_source(&matrix, i, &end) : tdsp_matrix_destination(&matrix, i - SOURCES, &end), TDSP_OK);
        assert_int_equal(end.name_length, strlen(names[i]));
        assert_memory_equal(end.name, names[i], end.name_length);
    }
    assert_int_equal(tdsp_matrix_table(&matrix, 0, 0, &table), TDSP_OK);
    assert_int_equal(tdsp_matrix_table(&matrix, 0, 1, &table), TDSP_UNREACHABLE);
    assert_int_equal(tdsp_matrix_table(&matrix, 0, 1, NULL), TDSP_INVALID_ARGUMENT);
}

/* ------------------------------------------------------------------------------------------------------------ lengths */

/* What is behind the bytes would do for what they lack. */
static void bytes_that_end_within_what_is_read_first_are_refused(void **state)
{
    (void)state;
    edge e = edge_plain();
    tdsp_matrix matrix;
    assert_int_equal(tdsp_matrix_open(&matrix, e.bytes, MATRIX_MAGIC_LENGTH - 1), TDSP_BAD_MAGIC);
    for (size_t length = MATRIX_AT_HEADER_LENGTH; length < MATRIX_HEADER_LENGTH; length++) {
        bytes_put_u64(e.bytes + MATRIX_AT_LENGTH, length);
        assert_int_equal(tdsp_matrix_open(&matrix, e.bytes, length), TDSP_BAD_LENGTH);
    }
    bytes_put_u16(e.bytes + MATRIX_AT_MAJOR, MATRIX_MAJOR + 1);
    for (size_t length = MATRIX_MAGIC_LENGTH; length < MATRIX_AT_HEADER_LENGTH; length++)
        assert_int_equal(tdsp_matrix_open(&matrix, e.bytes, length), TDSP_BAD_LENGTH);
}

static void what_is_right_but_for_its_magic_or_its_length_is_refused(void **state)
{
    (void)state;
    edge e = edge_plain();
    bytes_put_u64(e.bytes + MATRIX_AT_LENGTH, e.length + 8);
    assert_opens(e, TDSP_BAD_LENGTH);
    for (size_t i = 0; i < MATRIX_MAGIC_LENGTH; i++) {
        e = edge_plain();
        e.bytes[i] ^= 1;
        assert_opens(e, TDSP_BAD_MAGIC);
    }
}

static void a_header_is_as_long_as_its_version_says(void **state)
{
    (void)state;
    static const struct {
        unsigned minor;
        uint32_t header;
        tdsp_status status;
    } cases[] = {{MATRIX_MINOR, MATRIX_HEADER_LENGTH + 8, TDSP_BAD_TABLE},
                 {MATRIX_MINOR + 1, MATRIX_HEADER_LENGTH, TDSP_OK},
                 {MATRIX_MINOR + 1, MATRIX_HEADER_LENGTH + 8, TDSP_OK},
                 {MATRIX_MINOR + 1, MATRIX_HEADER_LENGTH + 4, TDSP_BAD_TABLE}};
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        edge e = edge_of(cases[i].minor, cases[i].header);
        edge_write(&e);
        assert_opens(e, cases[i].status);
    }
}

/* The first place lies over the header's last number, as it may not. */
static void a_header_shorter_than_that_of_the_first_version_is_refused(void **state)
{
    (void)state;
    for (unsigned minor = MATRIX_MINOR; minor <= MATRIX_MINOR + 1; minor++) {
        edge e = edge_of(minor, MATRIX_HEADER_LENGTH - 8);
        edge_write(&e);
        bytes_put_u64(e.bytes + MATRIX_AT_TABLES, e.tables);
        assert_opens(e, TDSP_BAD_TABLE);
    }
}

/* ----------------------------------------------------------------------------------------------------------- sections */

/* Where one section lies behind the others, and they close the gap, which a later version's bytes behind the tables have room for. */
static void each_section_begins_where_the_one_before_it_ends(void **state)
{
    (void)state;
    for (size_t section = 0; section < 4; section++) {
        edge e = edge_of(MATRIX_MINOR + 1, MATRIX_HEADER_LENGTH);
        size_t *const at[] = {&e.points, &e.name_ends, &e.names, &e.pairs};
        const size_t sizes[] = {MATRIX_POINT_SIZE * ENDS, 8 * ENDS, NAMES, MATRIX_PAIR_SIZE * PAIRS};
        size_t cursor = MATRIX_HEADER_LENGTH;
        for (size_t i = 0; i < 4; i++) {
            *at[i] = i == section ? e.length : cursor;
            if (i != section) cursor += sizes[i];
        }
        e.tables = cursor;
        e.length += sizes[section];
        edge_write(&e);
        assert_opens(e, TDSP_BAD_TABLE);
    }
}

static void names_that_begin_before_the_names_ends_are_refused_even_if_all_are_empty(void **state)
{
    (void)state;
    edge e = edge_of(MATRIX_MINOR, MATRIX_HEADER_LENGTH);
    e.pairs = e.names;
    e.length = e.tables = e.pairs + MATRIX_PAIR_SIZE * PAIRS;
    edge_write(&e);
    memset(e.bytes + e.name_ends, 0, 8 * ENDS + 8);
    assert_opens(e, TDSP_OK);
    bytes_put_u64(e.bytes + MATRIX_AT_NAMES, e.points);
    assert_opens(e, TDSP_BAD_TABLE);
}

static void the_tables_begin_behind_the_pairs(void **state)
{
    (void)state;
    edge e = edge_plain();
    bytes_put_u64(e.bytes + MATRIX_AT_TABLES, e.tables - 8);
    assert_opens(e, TDSP_BAD_TABLE);
}

/* Ends on one side only, with their places and names, and no pairs. */
static void a_matrix_without_sources_or_destinations_is_refused(void **state)
{
    (void)state;
    for (size_t sources = 0; sources <= ENDS; sources += ENDS) {
        edge e = edge_plain();
        bytes_put_u64(e.bytes + MATRIX_AT_SOURCES, sources);
        bytes_put_u64(e.bytes + MATRIX_AT_DESTINATIONS, ENDS - sources);
        e.tables = e.length = e.pairs;
        edge_put_offsets(&e);
        assert_opens(e, TDSP_BAD_TABLE);
    }
}

/*
 * 2^61 ends on one side and 8 on the other: in 64 bits their places take as much room as 8 places, their names' ends likewise, and their pairs none. All
 * else is 0: eight ends without a name, and the end of the memory behind them.
 */
static void numbers_of_ends_whose_sizes_wrap_around_are_refused(void **state)
{
    (void)state;
    const size_t ends = 8;
    for (int side = 0; side < 2; side++) {
        edge e = edge_of(MATRIX_MINOR, MATRIX_HEADER_LENGTH);
        bytes_put_u64(e.bytes + MATRIX_AT_SOURCES, side == 0 ? UINT64_C(1) << 61 : ends);
        bytes_put_u64(e.bytes + MATRIX_AT_DESTINATIONS, side == 0 ? ends : UINT64_C(1) << 61);
        e.name_ends = e.points + MATRIX_POINT_SIZE * ends;
        e.length = e.tables = e.pairs = e.names = e.name_ends + 8 * ends;
        edge_put_offsets(&e);
        assert_int_equal(brink_open(&e), TDSP_BAD_TABLE);
    }
}

/* So many that the pairs have no room, but their size in 64 bits has. */
static void pairs_whose_size_wraps_around_are_refused(void **state)
{
    (void)state;
    edge e = edge_plain();
    bytes_put_u64(e.bytes + MATRIX_AT_SOURCES, MATRIX_MOST_ENDS);
    bytes_put_u64(e.bytes + MATRIX_AT_DESTINATIONS, MATRIX_MOST_ENDS);
    assert_int_equal(brink_open(&e), TDSP_BAD_TABLE);
}

/* Names that end behind 2^64, or so near to it that there is no multiple of 8 behind them, with the pairs where the names begin. */
static void names_whose_end_wraps_around_are_refused(void **state)
{
    (void)state;
    for (uint64_t past = 0; past < 2; past++) {
        edge e = edge_of(MATRIX_MINOR, MATRIX_HEADER_LENGTH);
        e.pairs = e.names;
        e.length = e.tables = e.pairs + MATRIX_PAIR_SIZE * PAIRS;
        edge_write(&e);
        memset(e.bytes + e.pairs, 0, 8);
        for (size_t i = 0; i < ENDS; i++) bytes_put_u64(e.bytes + e.name_ends + 8 * i, UINT64_MAX - (past ? 0 : e.names));
        assert_opens(e, TDSP_BAD_TABLE);
    }
}

/*
 * One source and three destinations, and names so long that in 64 bits they end where the places begin. There the pairs lie as well, three of them over the
 * places and the first name's end: 7, which is why there is no way.
 */
static void names_that_end_before_the_section_begins_are_refused(void **state)
{
    (void)state;
    edge e = edge_of(MATRIX_MINOR + 1, MATRIX_HEADER_LENGTH);
    bytes_put_u64(e.bytes + MATRIX_AT_SOURCES, 1);
    bytes_put_u64(e.bytes + MATRIX_AT_DESTINATIONS, ENDS - 1);
    for (size_t i = 0; i < 3; i++) bytes_put_u64(e.bytes + e.points + MATRIX_PAIR_SIZE * i + MATRIX_PAIR_AT_STATUS, TDSP_UNREACHABLE);
    for (size_t i = 1; i < 3; i++) bytes_put_u64(e.bytes + e.name_ends + 8 * i, TDSP_UNREACHABLE);
    bytes_put_u64(e.bytes + e.name_ends + 8 * 3, e.points - e.names);
    e.pairs = e.points;
    e.tables = e.pairs + MATRIX_PAIR_SIZE * 3;
    edge_put_offsets(&e);
    assert_int_equal(brink_open(&e), TDSP_BAD_TABLE);
}

/* A table of a later version, three bytes longer than whole words, where the memory ends. */
static void a_last_table_that_is_not_filled_up_is_refused(void **state)
{
    (void)state;
    edge e = edge_with(SQUEEZE);
    unsigned char *length = pair_at(&e, 0) + MATRIX_PAIR_AT_LENGTH, *table = e.bytes + e.tables;
    bytes_put_u16(e.bytes + MATRIX_AT_MINOR, MATRIX_MINOR + 1);
    bytes_put_u16(table + FORMAT_AT_MINOR, FORMAT_MINOR + 1);
    bytes_put_u64(length, bytes_get_u64(length) + 3);
    bytes_put_u64(table + FORMAT_AT_LENGTH, bytes_get_u64(length));
    e.length += 8;
    edge_put_offsets(&e);
    assert_int_equal(brink_open(&e), TDSP_OK);
    e.length -= 5;
    edge_put_offsets(&e);
    assert_int_equal(brink_open(&e), TDSP_BAD_TABLE);
}

/* --------------------------------------------------------------------------------------------------------------- ends */

/* Of ends that no table leads from or to. */
static void a_place_that_is_no_number_or_infinite_is_refused_at_every_end(void **state)
{
    (void)state;
    const double values[] = {NAN, INFINITY, -INFINITY};
    for (size_t at = 0; at < 2 * ENDS; at++) {
        for (size_t i = 0; i < 3; i++) {
            edge e = edge_plain();
            bytes_put_f64(e.bytes + e.points + 8 * at, values[i]);
            assert_opens(e, TDSP_BAD_TABLE);
        }
    }
}

static void names_that_end_before_they_begin_or_behind_the_last_are_refused(void **state)
{
    (void)state;
    static const uint64_t ends[][ENDS] = {{3, 1, 3, 4}, {1, 3, 2, 4}, {1, 5, 5, 4}, {5, 3, 3, 4}, {1, 3, UINT64_MAX, 4}, {1, 3, 3 * ROOM, 4}};
    for (size_t i = 0; i < sizeof ends / sizeof ends[0]; i++) {
        edge e = edge_plain();
        for (size_t k = 0; k < ENDS; k++) bytes_put_u64(e.bytes + e.name_ends + 8 * k, ends[i][k]);
        assert_int_equal(brink_open(&e), TDSP_BAD_TABLE);
    }
}

/* The two bytes of a character, each in a name of its own, are no names; in one name they are one. */
static void every_name_is_text_by_itself(void **state)
{
    (void)state;
    edge e = edge_plain();
    memcpy(e.bytes + e.names + 1, "\xc3\xa9", 2);
    assert_opens(e, TDSP_OK);
    bytes_put_u64(e.bytes + e.name_ends, 2);
    assert_opens(e, TDSP_BAD_TABLE);
    e = edge_plain();
    e.bytes[e.names + 3] = 0xff;
    assert_opens(e, TDSP_BAD_TABLE);
}

/* -------------------------------------------------------------------------------------------------------------- pairs */

static void a_pair_without_a_table_says_nothing_but_why(void **state)
{
    (void)state;
    for (size_t i = 0; i < PAIRS; i++) {
        for (size_t at = 0; at < MATRIX_PAIR_SIZE; at += at < MATRIX_PAIR_AT_STATUS ? 8 : 4) {
            edge e = edge_plain();
            bytes_put_u32(pair_at(&e, i) + at, at == MATRIX_PAIR_AT_STATUS ? TDSP_HORIZON : 8);
            assert_opens(e, TDSP_BAD_TABLE);
        }
    }
}

static void a_table_that_is_bad_in_itself_is_refused(void **state)
{
    (void)state;
    edge e = edge_with(GAP);
    bytes_put_u32(e.bytes + e.tables + FORMAT_AT_MONOTONE, 7);
    assert_opens(e, TDSP_BAD_TABLE);
}

static void a_table_leads_from_its_source_to_its_destination(void **state)
{
    (void)state;
    const size_t ends[] = {0, SOURCES};
    for (size_t i = 0; i < 4; i++) {
        edge e = edge_with(GAP);
        unsigned char *at = e.bytes + e.points + MATRIX_POINT_SIZE * ends[i / 2] + 8 * (i % 2);
        bytes_put_f64(at, bytes_get_f64(at) + 1.0);
        assert_opens(e, TDSP_BAD_TABLE);
    }
}

/* -------------------------------------------------------------------------------------------------------- afterwards */

static void a_pair_that_changes_after_opening_to_wrap_around_is_refused(void **state)
{
    (void)state;
    edge e = edge_with(GAP);
    tdsp_matrix matrix;
    tdsp_table table;
    assert_int_equal(edge_open(&e, &matrix), TDSP_OK);
    bytes_put_u64(pair_at(&e, 0) + MATRIX_PAIR_AT_LENGTH, UINT64_MAX - e.tables + 1);
    assert_int_equal(tdsp_matrix_table(&matrix, 0, 0, &table), TDSP_BAD_TABLE);
    bytes_put_u64(pair_at(&e, 0) + MATRIX_PAIR_AT_OFFSET, UINT64_MAX - 7);
    bytes_put_u64(pair_at(&e, 0) + MATRIX_PAIR_AT_LENGTH, 16);
    assert_int_equal(tdsp_matrix_table(&matrix, 0, 0, &table), TDSP_BAD_TABLE);
}

static void a_name_that_changes_after_opening_stays_between_the_names_and_the_pairs(void **state)
{
    (void)state;
    const uint64_t ends[] = {NAMES + 1, ROOM, UINT64_MAX, UINT64_MAX - ROOM};
    edge e = edge_plain();
    tdsp_matrix matrix;
    tdsp_matrix_end end;
    assert_int_equal(edge_open(&e, &matrix), TDSP_OK);
    for (size_t i = 0; i < 4; i++) {
        bytes_put_u64(e.bytes + e.name_ends, ends[i]); /* where the second name begins */
        assert_int_equal(tdsp_matrix_source(&matrix, 1, &end), TDSP_OK);
        assert_ptr_equal(end.name, e.bytes + e.names);
        assert_int_equal(end.name_length, name_ends[1]);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_sheet_with_nothing_wrong_opens_and_says_what_is_on_it),
        cmocka_unit_test(bytes_that_end_within_what_is_read_first_are_refused),
        cmocka_unit_test(what_is_right_but_for_its_magic_or_its_length_is_refused),
        cmocka_unit_test(a_header_is_as_long_as_its_version_says),
        cmocka_unit_test(a_header_shorter_than_that_of_the_first_version_is_refused),
        cmocka_unit_test(each_section_begins_where_the_one_before_it_ends),
        cmocka_unit_test(names_that_begin_before_the_names_ends_are_refused_even_if_all_are_empty),
        cmocka_unit_test(the_tables_begin_behind_the_pairs),
        cmocka_unit_test(a_matrix_without_sources_or_destinations_is_refused),
        cmocka_unit_test(numbers_of_ends_whose_sizes_wrap_around_are_refused),
        cmocka_unit_test(pairs_whose_size_wraps_around_are_refused),
        cmocka_unit_test(names_whose_end_wraps_around_are_refused),
        cmocka_unit_test(names_that_end_before_the_section_begins_are_refused),
        cmocka_unit_test(a_last_table_that_is_not_filled_up_is_refused),
        cmocka_unit_test(a_place_that_is_no_number_or_infinite_is_refused_at_every_end),
        cmocka_unit_test(names_that_end_before_they_begin_or_behind_the_last_are_refused),
        cmocka_unit_test(every_name_is_text_by_itself),
        cmocka_unit_test(a_pair_without_a_table_says_nothing_but_why),
        cmocka_unit_test(a_table_that_is_bad_in_itself_is_refused),
        cmocka_unit_test(a_table_leads_from_its_source_to_its_destination),
        cmocka_unit_test(a_pair_that_changes_after_opening_to_wrap_around_is_refused),
        cmocka_unit_test(a_name_that_changes_after_opening_stays_between_the_names_and_the_pairs),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
