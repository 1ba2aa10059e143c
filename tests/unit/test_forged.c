/* SPDX-License-Identifier: MIT */
/*
 * Tables and matrices that somebody forged: numbers at the edge of 64 bits, checksums that fit, bytes that change after opening. Where a table would have to be larger than memory, the check is asked by itself about a view of it.
 */
#include "support/cmocka_all.h"

#include <float.h>
#include <stdlib.h>

#include "base/bytes.h"
#include "support/brink.h"
#include "support/golden.h"
#include "support/matrix_walk.h"
#include "support/walk.h"
#include "support/world.h"
#include "table/check.h"
#include "table/format.h"
#include "table/matrix.h"
#include "tdsp/build.h"
#include "tdsp/table.h"

enum { GAP, ROAD, LOOSE, STILL, CROWD, SWELL, SQUEEZE };

static unsigned char *golden_bytes(size_t which, size_t *length)
{
    unsigned char *bytes = golden_write(&golden_tables[which], length);
    assert_non_null(bytes);
    return bytes;
}

static size_t section_of(const unsigned char *bytes, size_t section)
{
    return (size_t)bytes_get_u64(bytes + format_at_offset(section));
}

static tdsp_status open_sealed(unsigned char *bytes, size_t length)
{
    tdsp_table table;
    golden_seal(bytes, length);
    return tdsp_table_open(&table, bytes, length);
}

/* ---------------------------------------------------------------------------------------------------------- tables */

/* 2^61 - 1 rows take 2^64 - 8 bytes, which fits, and one bound more than there are rows does not. */
static void a_number_of_rows_whose_bounds_overflow_is_refused(void **state)
{
    (void)state;
    size_t length;
    unsigned char *bytes = golden_bytes(ROAD, &length);
    bytes_put_u64(bytes + FORMAT_AT_ROWS, UINT64_MAX / 8);
    assert_int_equal(open_sealed(bytes, length), TDSP_BAD_TABLE);
    free(bytes);
}

/* A later minor version may put something between the sections, so that their offsets are not known beforehand. */
static unsigned char *newer_bytes(size_t which, size_t *length)
{
    unsigned char *bytes = golden_bytes(which, length);
    bytes_put_u16(bytes + FORMAT_AT_MINOR, FORMAT_MINOR + 1);
    return bytes;
}

static void a_later_version_may_not_place_a_section_askew_or_beyond_its_end(void **state)
{
    (void)state;
    const uint64_t places[] = {0, 4, UINT64_MAX - 7};
    for (size_t section = 0; section < FORMAT_SECTIONS_2; section++) {
        for (size_t i = 0; i < sizeof places / sizeof places[0]; i++) {
            size_t length;
            unsigned char *bytes = newer_bytes(SQUEEZE, &length);
            assert_int_equal(open_sealed(bytes, length), TDSP_OK);
            size_t at = section_of(bytes, section);
            bytes_put_u64(bytes + format_at_offset(section), places[i] == 4 ? at + 4 : places[i]);
            assert_int_equal(open_sealed(bytes, length), TDSP_BAD_TABLE);
            free(bytes);
        }
    }
}

/* The opaque bytes would end less than 8 bytes before 2^64, and so be padded past it. */
static void padding_that_overflows_is_refused(void **state)
{
    (void)state;
    size_t length;
    unsigned char *bytes = newer_bytes(SQUEEZE, &length);
    bytes_put_u64(bytes + FORMAT_AT_OPAQUE_LENGTH, 3);
    bytes_put_u64(bytes + format_at_offset(FORMAT_OPAQUE), UINT64_MAX - 7);
    assert_int_equal(open_sealed(bytes, length), TDSP_BAD_TABLE);
    free(bytes);
}

static void a_later_version_with_a_header_of_no_whole_words_or_longer_than_the_file_is_refused(void **state)
{
    (void)state;
    size_t length;
    unsigned char *bytes = newer_bytes(SQUEEZE, &length);
    const uint32_t headers[] = {FORMAT_HEADER_LENGTH_2 + 4, (uint32_t)length + 8 - (uint32_t)length % 8, FORMAT_HEADER_LENGTH_2 - 8};
    for (size_t i = 0; i < 3; i++) {
        bytes_put_u32(bytes + FORMAT_AT_HEADER_LENGTH, headers[i]);
        assert_int_equal(open_sealed(bytes, length), TDSP_BAD_TABLE);
    }
    free(bytes);
}

/* The travel time after the last row says that nothing leaves then by being infinite, not by a sum that overflows. */
static void a_last_row_whose_end_overflows_is_refused_and_one_without_end_is_not(void **state)
{
    (void)state;
    const double after[] = {INFINITY, 1.7e308};
    for (int i = 0; i < 2; i++) {
        size_t length;
        unsigned char *bytes = golden_bytes(SQUEEZE, &length);
        bytes_put_f64(bytes + section_of(bytes, FORMAT_DEPARTURES) + 24, 1.7e308);
        bytes_put_f64(bytes + FORMAT_AT_LAST_DEPARTURE, 1.7e308);
        bytes_put_f64(bytes + section_of(bytes, FORMAT_RIGHT) + 24, after[i]);
        assert_int_equal(open_sealed(bytes, length), i == 0 ? TDSP_OK : TDSP_BAD_TABLE);
        free(bytes);
    }
}

/* 2^31 bytes are too many for a row, however many there are in all. */
static void a_row_with_too_many_opaque_bytes_is_refused(void **state)
{
    (void)state;
    unsigned char bounds[16] = {0};
    for (uint64_t more = 0; more < 2; more++) {
        tdsp_table table = {.bytes = bounds, .rows = 1, .opaque_length = FORMAT_MAX_ROW_BYTES + more};
        bytes_put_u64(bounds + 8, table.opaque_length);
        assert_int_equal(check_opaque(&table), !more);
    }
}

static void a_guide_over_more_rows_than_it_can_number_is_refused(void **state)
{
    (void)state;
    unsigned char zero[8] = {0};
    tdsp_table table = {.bytes = zero, .rows = (uint64_t)FORMAT_GUIDE_MAX + 1};
    table.by_departure.cells = 1;
    assert_int_equal(check_guides(&table), 0);
}

static void a_curve_that_turns_by_less_than_nothing_is_refused(void **state)
{
    (void)state;
    tdsp_leg leg = {.kind = TDSP_LEG_CURVE, .end_time = 1, .radius_from = 1, .radius_to = 1, .speed = 1};
    assert_true(check_curve(&leg));
    leg.sweep = -DBL_MIN;
    assert_false(check_curve(&leg));
}

/* Two arrivals beside 8, the first over it and the second under it by rounding: in order as far as anybody can say, and not in a binary search. */
static void a_guide_to_arrivals_that_fall_by_a_rounding_is_refused(void **state)
{
    (void)state;
    writer_row rows[20];
    writer_header header = golden_tables[ROAD].header;
    memset(rows, 0, sizeof rows);
    for (size_t i = 0; i < 20; i++) {
        rows[i].departure = 0.5 * (double)i;
        rows[i].left = rows[i].right = i < 11 ? 8.0 - rows[i].departure : 3.0;
    }
    header.first_lower = 8.0;
    size_t length;
    unsigned char *bytes = golden_rows(&header, rows, 20, &length);
    assert_non_null(bytes);
    tdsp_table table;
    assert_int_equal(tdsp_table_open(&table, bytes, length), TDSP_OK);
    assert_true(table.by_arrival.cells > 0);
    const double unit = 0x1p-51; /* a quarter of a unit in the last place of 8 */
    bytes_put_f64(bytes + table.left + 8 * 10, 3.0 + 3.0 * unit);
    bytes_put_f64(bytes + table.right + 8 * 10, 3.0 + 3.0 * unit);
    for (size_t i = 11; i < 20; i++) {
        bytes_put_f64(bytes + table.left + 8 * i, i == 11 ? 2.5 + unit : 3.0);
        bytes_put_f64(bytes + table.right + 8 * i, i == 11 ? 2.5 + unit : 3.0);
    }
    golden_seal(bytes, length);
    assert_int_equal(tdsp_table_open(&table, bytes, length), TDSP_BAD_TABLE);
    free(bytes);
}

/* A table right before memory that must not be read. */
static brink brink_table(size_t which, size_t *length)
{
    unsigned char *bytes = golden_bytes(which, length);
    brink b = brink_of(bytes, *length);
    free(bytes);
    return b;
}

/* 2^61 curves of 88 bytes take none, as far as 64 bits go. The table ends where the memory does: a read of the first curve would be noticed. */
static void a_number_of_curves_whose_size_wraps_around_is_refused(void **state)
{
    (void)state;
    size_t length;
    brink b = brink_table(SQUEEZE, &length);
    bytes_put_u64(b.bytes + format_at_offset(FORMAT_CURVES) + FORMAT_FURTHER_AT_COUNT, UINT64_C(1) << 61);
    assert_int_equal(open_sealed(b.bytes, length), TDSP_BAD_TABLE);
    brink_free(b);
}

static void no_question_reads_behind_a_table_that_ends_where_the_memory_does(void **state)
{
    (void)state;
    size_t length;
    tdsp_table table;
    for (size_t which = 0; which < GOLDEN_COUNT; which++) {
        brink b = brink_table(which, &length);
        assert_int_equal(tdsp_table_open(&table, b.bytes, length), TDSP_OK);
        assert_null(walk_table(&table));
        brink_free(b);
    }
}

static void a_guide_of_nothing_has_the_scale_0(void **state)
{
    (void)state;
    const double scales[] = {0.0, 1.0, -1.0, NAN};
    for (size_t i = 0; i < 4; i++) {
        size_t length;
        unsigned char *bytes = golden_bytes(SQUEEZE, &length);
        bytes_put_f64(bytes + format_at_offset(FORMAT_BY_DEPARTURE) + FORMAT_GUIDE_AT_SCALE, scales[i]);
        assert_int_equal(open_sealed(bytes, length), i == 0 ? TDSP_OK : TDSP_BAD_TABLE);
        free(bytes);
    }
}

/* Three and five waypoints instead of four and four; everything else is put right. */
static void an_odd_number_of_waypoints_is_refused_where_legs_have_two_each(void **state)
{
    (void)state;
    size_t length;
    unsigned char *bytes = golden_bytes(LOOSE, &length);
    unsigned char *first = bytes + section_of(bytes, FORMAT_FIRST_WAYPOINT), *waypoint = bytes + section_of(bytes, FORMAT_WAYPOINTS);
    const double times[] = {0, 1, 1, 1, 1, 1, 1, 1};
    for (size_t i = 0; i < 8; i++) {
        bytes_put_f64(waypoint + FORMAT_WAYPOINT_SIZE * i + FORMAT_WAYPOINT_AT_TIME, times[i]);
        bytes_put_u32(waypoint + FORMAT_WAYPOINT_SIZE * i + FORMAT_WAYPOINT_AT_DISC, FORMAT_NONE);
        bytes_put_u32(waypoint + FORMAT_WAYPOINT_SIZE * i + FORMAT_WAYPOINT_AT_ARC, FORMAT_NONE);
    }
    assert_int_equal(open_sealed(bytes, length), TDSP_OK);
    bytes_put_u32(first + 4, 3);
    bytes_put_u32(first + 8, 3);
    bytes_put_u64(bytes + FORMAT_AT_LEGS, 3);
    assert_int_equal(open_sealed(bytes, length), TDSP_BAD_TABLE);
    free(bytes);
}

static void a_table_that_was_never_opened_has_no_rows_to_find(void **state)
{
    (void)state;
    const tdsp_table table = {0};
    const double time = 1.0;
    uint64_t row = 7;
    tdsp_status status = TDSP_OK;
    assert_int_equal(tdsp_table_rows(&table, &time, 1, &row, &status), TDSP_INVALID_ARGUMENT);
    assert_int_equal(row, 7);
}

/* -------------------------------------------------------------------------------------------------------- matrices */

static const tdsp_matrix_end sources[2] = {{{-10.0, 0.0}, "gate", 4}, {{0.0, 3.5}, NULL, 0}};
static const tdsp_matrix_end destinations[1] = {{{10.0, 0.0}, "A", 1}};

static tdsp_status oracle_for(void *ctx, size_t i, size_t j, size_t worker, tdsp_oracle *oracle, uint64_t *hash)
{
    const world *w = ctx;
    const tdsp_ends ends = {sources[i].place, destinations[j].place};
    (void)worker;
    assert_int_equal(tdsp_solver_set_ends(w->solver, &ends), TDSP_OK);
    *hash = tdsp_scene_hash_for(w->scene, &ends);
    return tdsp_solver_oracle(w->solver, oracle);
}

typedef struct forged {
    unsigned char *bytes; /* with room behind them */
    size_t length;
} forged;

/* A matrix with one table, and one pair without because its source is covered. */
static forged forge(void)
{
    static const tdsp_journey across = {1.0, 0.0, {-10.0, 0.0}, {10.0, 0.0}};
    static const tdsp_disc discs[2] = {{{0.0, 3.0}, 1.0, 0.1}, {{0.0, -3.0}, 1.0, 0.1}};
    world w = world_make(across, discs, 2);
    const tdsp_matrix_plan plan = {sources, 2, destinations, 1, oracle_for, &w};
    tdsp_build_options options;
    tdsp_build_options_init(&options);
    options.epsilon = 0.5;
    void *bytes;
    forged out;
    assert_int_equal(tdsp_matrix_build(&plan, &options, NULL, &bytes, &out.length, NULL), TDSP_OK);
    out.bytes = calloc(out.length + 64, 1);
    assert_non_null(out.bytes);
    memcpy(out.bytes, bytes, out.length);
    tdsp_bytes_free(NULL, bytes, out.length);
    world_free(w);
    return out;
}

static tdsp_status open_matrix(forged *f, tdsp_matrix *matrix)
{
    matrix_seal(f->bytes, f->length);
    return tdsp_matrix_open(matrix, f->bytes, f->length);
}

static unsigned char *pair_of(forged *f, size_t i)
{
    return f->bytes + bytes_get_u64(f->bytes + MATRIX_AT_PAIRS) + MATRIX_PAIR_SIZE * i;
}

static void a_later_matrix_with_a_header_of_no_whole_words_or_longer_than_the_file_is_refused(void **state)
{
    (void)state;
    forged f = forge();
    tdsp_matrix matrix;
    bytes_put_u16(f.bytes + MATRIX_AT_MINOR, MATRIX_MINOR + 1);
    const uint32_t headers[] = {MATRIX_HEADER_LENGTH + 4, (uint32_t)f.length + 8 - (uint32_t)f.length % 8, MATRIX_HEADER_LENGTH - 8};
    assert_int_equal(open_matrix(&f, &matrix), TDSP_OK);
    for (size_t i = 0; i < 3; i++) {
        bytes_put_u32(f.bytes + MATRIX_AT_HEADER_LENGTH, headers[i]);
        assert_int_equal(open_matrix(&f, &matrix), TDSP_BAD_TABLE);
    }
    free(f.bytes);
}

/* 2^32 - 1 sources and destinations make a number of pairs that fits, and pairs that do not; names end at the very end of all numbers. */
static void sizes_of_a_matrix_that_overflow_are_refused(void **state)
{
    (void)state;
    tdsp_matrix matrix;
    forged f = forge();
    bytes_put_u64(f.bytes + MATRIX_AT_SOURCES, MATRIX_MOST_ENDS);
    bytes_put_u64(f.bytes + MATRIX_AT_DESTINATIONS, MATRIX_MOST_ENDS);
    assert_int_equal(open_matrix(&f, &matrix), TDSP_BAD_TABLE);
    free(f.bytes);
    f = forge();
    uint64_t names = bytes_get_u64(f.bytes + MATRIX_AT_NAMES), ends = bytes_get_u64(f.bytes + MATRIX_AT_NAME_ENDS);
    for (uint64_t less = 0; less < 9; less++) {
        bytes_put_u64(f.bytes + ends + 16, UINT64_MAX - names - less);
        assert_int_equal(open_matrix(&f, &matrix), TDSP_BAD_TABLE);
    }
    free(f.bytes);
}

static void a_pair_without_a_table_has_one_of_four_reasons(void **state)
{
    (void)state;
    forged f = forge();
    for (uint32_t reason = 1; reason < 40; reason++) {
        tdsp_matrix matrix;
        tdsp_table table;
        int good = reason == TDSP_SOURCE_COVERED || reason == TDSP_DESTINATION_COVERED || reason == TDSP_CUT_OFF || reason == TDSP_UNREACHABLE;
        bytes_put_u32(pair_of(&f, 1) + MATRIX_PAIR_AT_STATUS, reason);
        assert_int_equal(open_matrix(&f, &matrix), good ? TDSP_OK : TDSP_BAD_TABLE);
        if (good) assert_int_equal(tdsp_matrix_table(&matrix, 1, 0, &table), reason);
    }
    free(f.bytes);
}

/* What a later version has behind the tables is none of ours. */
static void bytes_behind_the_last_table_are_for_later_versions_only(void **state)
{
    (void)state;
    forged f = forge();
    tdsp_matrix matrix;
    f.length += 8;
    bytes_put_u64(f.bytes + MATRIX_AT_LENGTH, f.length);
    assert_int_equal(open_matrix(&f, &matrix), TDSP_BAD_TABLE);
    bytes_put_u16(f.bytes + MATRIX_AT_MINOR, MATRIX_MINOR + 1);
    assert_int_equal(open_matrix(&f, &matrix), TDSP_OK);
    free(f.bytes);
}

/* Five bytes of names are padded with three zeros. */
static void padding_in_a_matrix_is_zero(void **state)
{
    (void)state;
    forged f = forge();
    tdsp_matrix matrix;
    for (uint64_t i = 5, names = bytes_get_u64(f.bytes + MATRIX_AT_NAMES); i < 8; i++) {
        f.bytes[names + i] = 1;
        assert_int_equal(open_matrix(&f, &matrix), TDSP_BAD_TABLE);
        f.bytes[names + i] = 0;
    }
    assert_int_equal(open_matrix(&f, &matrix), TDSP_OK);
    free(f.bytes);
}

static void names_that_change_after_opening_become_empty(void **state)
{
    (void)state;
    forged f = forge();
    tdsp_matrix matrix;
    tdsp_matrix_end end;
    assert_int_equal(open_matrix(&f, &matrix), TDSP_OK);
    uint64_t ends = bytes_get_u64(f.bytes + MATRIX_AT_NAME_ENDS);
    bytes_put_u64(f.bytes + ends + 16, 3); /* before the 4 at which it begins */
    assert_int_equal(tdsp_matrix_destination(&matrix, 0, &end), TDSP_OK);
    assert_int_equal(end.name_length, 0);
    bytes_put_u64(f.bytes + ends + 16, 1000000); /* beyond the names */
    assert_int_equal(tdsp_matrix_destination(&matrix, 0, &end), TDSP_OK);
    assert_int_equal(end.name_length, 0);
    free(f.bytes);
}

static void pairs_that_change_after_opening_have_no_table(void **state)
{
    (void)state;
    forged f = forge();
    tdsp_matrix matrix;
    tdsp_table table;
    assert_int_equal(open_matrix(&f, &matrix), TDSP_OK);
    unsigned char *pair = pair_of(&f, 0);
    uint64_t offset = bytes_get_u64(pair + MATRIX_PAIR_AT_OFFSET), length = bytes_get_u64(pair + MATRIX_PAIR_AT_LENGTH);
    bytes_put_u32(pair + MATRIX_PAIR_AT_STATUS, TDSP_BAD_TABLE);
    assert_int_equal(tdsp_matrix_table(&matrix, 0, 0, &table), TDSP_BAD_TABLE);
    bytes_put_u32(pair + MATRIX_PAIR_AT_STATUS, TDSP_HORIZON);
    assert_int_equal(tdsp_matrix_table(&matrix, 0, 0, &table), TDSP_BAD_TABLE);
    bytes_put_u32(pair + MATRIX_PAIR_AT_STATUS, TDSP_OK);
    bytes_put_u64(pair + MATRIX_PAIR_AT_LENGTH, UINT64_MAX);
    assert_int_equal(tdsp_matrix_table(&matrix, 0, 0, &table), TDSP_BAD_TABLE);
    bytes_put_u64(pair + MATRIX_PAIR_AT_LENGTH, f.length - offset + 1);
    assert_int_equal(tdsp_matrix_table(&matrix, 0, 0, &table), TDSP_BAD_TABLE);
    bytes_put_u64(pair + MATRIX_PAIR_AT_LENGTH, length);
    assert_int_equal(tdsp_matrix_table(&matrix, 0, 0, &table), TDSP_OK);
    bytes_put_u64(f.bytes + offset + FORMAT_AT_ROWS, 0);
    assert_int_equal(tdsp_matrix_table(&matrix, 0, 0, &table), TDSP_BAD_TABLE);
    f.bytes[offset] ^= 1;
    assert_int_equal(tdsp_matrix_table(&matrix, 0, 0, &table), TDSP_BAD_MAGIC);
    free(f.bytes);
}

static void what_is_not_wanted_of_a_matrix_may_be_left_out_and_what_is_needed_may_not(void **state)
{
    (void)state;
    forged f = forge();
    tdsp_matrix matrix;
    tdsp_matrix_end end;
    tdsp_table table;
    uint64_t count = 0;
    assert_int_equal(open_matrix(&f, &matrix), TDSP_OK);
    assert_int_equal(tdsp_matrix_size(&matrix, &count, NULL), TDSP_OK);
    assert_int_equal(count, 2);
    assert_int_equal(tdsp_matrix_size(&matrix, NULL, &count), TDSP_OK);
    assert_int_equal(count, 1);
    assert_int_equal(tdsp_matrix_source(NULL, 0, &end), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_matrix_source(&matrix, 0, NULL), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_matrix_destination(NULL, 0, &end), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_matrix_destination(&matrix, 0, NULL), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_matrix_table(NULL, 0, 0, &table), TDSP_INVALID_ARGUMENT);
    free(f.bytes);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_number_of_rows_whose_bounds_overflow_is_refused),
        cmocka_unit_test(a_later_version_may_not_place_a_section_askew_or_beyond_its_end),
        cmocka_unit_test(padding_that_overflows_is_refused),
        cmocka_unit_test(a_later_version_with_a_header_of_no_whole_words_or_longer_than_the_file_is_refused),
        cmocka_unit_test(a_last_row_whose_end_overflows_is_refused_and_one_without_end_is_not),
        cmocka_unit_test(a_row_with_too_many_opaque_bytes_is_refused),
        cmocka_unit_test(a_guide_over_more_rows_than_it_can_number_is_refused),
        cmocka_unit_test(a_curve_that_turns_by_less_than_nothing_is_refused),
        cmocka_unit_test(a_guide_to_arrivals_that_fall_by_a_rounding_is_refused),
        cmocka_unit_test(a_number_of_curves_whose_size_wraps_around_is_refused),
        cmocka_unit_test(no_question_reads_behind_a_table_that_ends_where_the_memory_does),
        cmocka_unit_test(a_guide_of_nothing_has_the_scale_0),
        cmocka_unit_test(an_odd_number_of_waypoints_is_refused_where_legs_have_two_each),
        cmocka_unit_test(padding_in_a_matrix_is_zero),
        cmocka_unit_test(a_table_that_was_never_opened_has_no_rows_to_find),
        cmocka_unit_test(a_later_matrix_with_a_header_of_no_whole_words_or_longer_than_the_file_is_refused),
        cmocka_unit_test(sizes_of_a_matrix_that_overflow_are_refused),
        cmocka_unit_test(a_pair_without_a_table_has_one_of_four_reasons),
        cmocka_unit_test(bytes_behind_the_last_table_are_for_later_versions_only),
        cmocka_unit_test(names_that_change_after_opening_become_empty),
        cmocka_unit_test(pairs_that_change_after_opening_have_no_table),
        cmocka_unit_test(what_is_not_wanted_of_a_matrix_may_be_left_out_and_what_is_needed_may_not),
    };
    return cmocka_run_group_tests_name("forged", tests, NULL, NULL);
}
