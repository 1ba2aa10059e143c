/* SPDX-License-Identifier: MIT */
/* The writer: what went in comes out, what contradicts the format does not get out, and memory may fail anywhere. */
#include "support/cmocka_all.h"
#include "support/tight.h"

#include <stdio.h>
#include <stdlib.h>

#include "support/chance.h"
#include "support/golden.h"
#include "support/walk.h"
#include "tdsp/table.h"

static unsigned char *read_golden(const char *name, size_t *length)
{
    char path[128];
    unsigned char *bytes = malloc(4096);
    assert_non_null(bytes);
    snprintf(path, sizeof path, "tests/independent/golden/%s.tdsp", name);
    FILE *file = fopen(path, "rb");
    if (!file) fail_msg("%s: not there; run the tests from the top of the checkout", path);
    *length = fread(bytes, 1, 4096, file);
    fclose(file);
    return bytes;
}

static void golden_tables_are_written_to_the_bit(void **state)
{
    (void)state;
    for (size_t which = 0; which < GOLDEN_COUNT; which++) {
        size_t length, expected_length;
        unsigned char *bytes = golden_write(&golden_tables[which], &length);
        unsigned char *expected = read_golden(golden_tables[which].name, &expected_length);
        assert_non_null(bytes);
        assert_int_equal(length, expected_length);
        assert_memory_equal(bytes, expected, length);
        free(bytes);
        free(expected);
    }
}

static void finishing_twice_gives_the_same_bytes_and_rows_may_follow(void **state)
{
    (void)state;
    const writer_row more = {5, 0, 0, NULL, 0, NULL, 0};
    writer *w = golden_fill(&golden_tables[3], NULL);
    void *first, *second, *third;
    size_t first_length, second_length, third_length;
    assert_non_null(w);
    assert_int_equal(writer_finish(w, &golden_tables[3].header, &first, &first_length), TDSP_OK);
    assert_int_equal(writer_finish(w, &golden_tables[3].header, &second, &second_length), TDSP_OK);
    assert_int_equal(first_length, second_length);
    assert_memory_equal(first, second, first_length);
    assert_int_equal(writer_add(w, &more), TDSP_OK);
    assert_int_equal(writer_finish(w, &golden_tables[3].header, &third, &third_length), TDSP_OK);
    assert_int_equal(third_length, first_length + 24);
    tdsp_bytes_free(NULL, first, first_length);
    tdsp_bytes_free(NULL, second, second_length);
    tdsp_bytes_free(NULL, third, third_length);
    writer_free(w);
}

/* A random path over [departure, departure + left]; `loose` leaves a gap of rounding at some joints. */
static size_t random_path(uint64_t *chance, tdsp_leg *legs, double departure, double left, int loose, int curves)
{
    size_t count = (size_t)chance_below(chance, 9);
    double time = departure, end = departure + left;
    tdsp_point at = {chance_between(chance, -1, 1), chance_between(chance, -1, 1)};
    for (size_t i = 0; i < count; i++) {
        tdsp_leg leg = {.kind = TDSP_LEG_LINE, .disc = TDSP_NO_DISC, .start_time = time, .end_time = time, .from = at};
        leg.end_time = i + 1 == count ? end : chance_between(chance, time, end);
        leg.to.x = chance_between(chance, -1, 1);
        leg.to.y = chance_between(chance, -1, 1);
        if (chance_below(chance, 2)) {
            leg.kind = curves && chance_below(chance, 2) ? TDSP_LEG_CURVE : TDSP_LEG_ARC;
            leg.disc = (uint32_t)chance_u64(chance);
            leg.turn = chance_below(chance, 2) ? 1 : -1;
            leg.center.x = chance_between(chance, -1, 1);
            leg.center.y = chance_between(chance, -1, 1);
            leg.radius_from = chance_between(chance, 0.1, 1);
            leg.radius_to = chance_between(chance, 0.1, 1);
            leg.angle_from = chance_between(chance, -7, 7);
            leg.sweep = chance_below(chance, 4) ? chance_between(chance, 0, 7) : 0;
        }
        if (leg.kind == TDSP_LEG_CURVE) {
            leg.speed = chance_between(chance, 1, 2);
            leg.rate_from = chance_between(chance, -1, 1);
            leg.rate_to = chance_between(chance, -1, 1);
            leg.bend_from = chance_between(chance, -9, 9);
            leg.bend_to = chance_between(chance, -9, 9);
        }
        legs[i] = leg;
        time = leg.end_time;
        at = leg.to;
        if (loose && chance_below(chance, 3) == 0) at.x = nextafter(at.x, 2);
    }
    return count;
}

static void assert_paths_come_out(const tdsp_table *table, const writer_row *rows, size_t count)
{
    for (size_t row = 0; row < count; row++) {
        tdsp_row stored;
        assert_int_equal(tdsp_table_row(table, row, &stored), TDSP_OK);
        assert_int_equal(stored.legs, rows[row].leg_count);
        for (size_t i = 0; i < rows[row].leg_count; i++) {
            tdsp_leg leg;
            assert_int_equal(tdsp_table_row_leg(table, row, i, &leg), TDSP_OK);
            assert_memory_equal(&leg, &rows[row].legs[i], sizeof leg);
        }
    }
}

static void any_well_formed_path_comes_out_to_the_bit(void **state)
{
    (void)state;
    uint64_t chance = 21;
    for (int round = 0; round < 300; round++) {
        static tdsp_leg legs[20][9];
        writer_row rows[20];
        size_t count = 1 + (size_t)chance_below(&chance, 20), length;
        for (size_t i = 0; i < count; i++) {
            writer_row row = {(double)i * 0.7, 2 + (double)i, 2 + (double)i, legs[i], 0, NULL, 0};
            row.leg_count = random_path(&chance, legs[i], row.departure, row.left, round % 2, round % 3);
            rows[i] = row;
        }
        rows[count - 1].right = INFINITY;
        unsigned char *bytes = golden_rows(&golden_tables[2].header, rows, count, &length);
        tdsp_table table;
        assert_non_null(bytes);
        assert_int_equal(tdsp_table_open(&table, bytes, length), TDSP_OK);
        assert_paths_come_out(&table, rows, count);
        assert_null(walk_table(&table));
        free(bytes);
    }
}

static void a_leg_that_is_not_well_formed_or_does_not_join_is_refused_and_nothing_added(void **state)
{
    (void)state;
    const tdsp_leg line = {.kind = TDSP_LEG_LINE, .disc = TDSP_NO_DISC, .end_time = 1, .to = {1, 0}};
    const tdsp_leg arc = {.kind = TDSP_LEG_ARC, .disc = 5, .turn = 1, .start_time = 1, .end_time = 2, .from = {1, 0},
                          .to = {2, 0}, .center = {1, 1}, .radius_from = 1, .radius_to = 1.5, .sweep = 1};
    writer *w;
    assert_int_equal(writer_create(NULL, &w), TDSP_OK);
    for (int fault = 0; fault < 25; fault++) {
        tdsp_leg legs[2] = {line, arc};
        switch (fault) {
        case 0: legs[0].kind = 2; break;
        case 1: legs[0].disc = 0; break;
        case 2: legs[0].turn = 1; break;
        case 3: legs[0].reserved = 1; break;
        case 4: legs[0].radius_from = 1; break;
        case 5: legs[0].sweep = 1; break;
        case 6: legs[0].start_time = 0.5; break;
        case 7: legs[0].end_time = -1; break;
        case 8: legs[0].from.x = NAN; break;
        case 9: legs[0].to.y = INFINITY; break;
        case 10: legs[1].start_time = 1.5; break;
        case 11: legs[1].end_time = 0.5; break;
        case 12: legs[1].end_time = 2.5; break;
        case 13: legs[1].turn = 0; break;
        case 14: legs[1].turn = 2; break;
        case 15: legs[1].radius_from = 0; break;
        case 16: legs[1].radius_to = -1; break;
        case 17: legs[1].sweep = -1; break;
        case 18: legs[1].sweep = NAN; break;
        case 19: legs[1].center.x = INFINITY; break;
        case 20: legs[1].angle_from = NAN; break;
        case 21: legs[0].kind = 3; break;
        case 22: legs[0].speed = 1; break;
        case 23: legs[1].bend_to = 1; break;
        default: legs[1].end_time = NAN; break;
        }
        writer_row row = {0, 2, 2, legs, 2, NULL, 0};
        if (writer_add(w, &row) != TDSP_BAD_PATH) fail_msg("fault %d was not refused", fault);
    }
    const tdsp_leg good[2] = {line, arc};
    const writer_row row = {0, 2, INFINITY, good, 2, NULL, 0};
    void *bytes;
    size_t length;
    tdsp_table table;
    assert_int_equal(writer_add(w, &row), TDSP_OK);
    assert_int_equal(writer_finish(w, &golden_tables[2].header, &bytes, &length), TDSP_OK);
    assert_int_equal(tdsp_table_open(&table, bytes, length), TDSP_OK);
    assert_paths_come_out(&table, &row, 1);
    tdsp_bytes_free(NULL, bytes, length);
    writer_free(w);
}

static void rows_out_of_order_are_refused_at_the_end_and_nothing_is_handed_out(void **state)
{
    (void)state;
    const struct {
        size_t row;
        double departure, left, right;
    } faults[] = {{0, 1, 20, 20},       {1, 0, 20.5, 20.25}, {1, -1, 20.5, 20.25}, {1, 10, 20.5, 20.25},       {1, NAN, 20.5, 20.25},
                  {1, 4, 19, 19},       {1, 4, 30, 20.25},   {1, 4, 20.5, 19},     {1, 4, 20.5, 21},           {1, 4, NAN, 20.25},
                  {2, 9.75, 20.75, 26}, {2, 9.75, -1, 24.5}, {3, 12.5, 24.75, 30}, {2, 9.75, 20.75, INFINITY}, {3, 12.5, INFINITY, INFINITY}};
    for (size_t i = 0; i < sizeof faults / sizeof faults[0]; i++) {
        writer *w;
        void *bytes = &w;
        size_t length = 7;
        assert_int_equal(writer_create(NULL, &w), TDSP_OK);
        for (size_t row = 0; row < 4; row++) {
            writer_row at = golden_tables[0].rows[row];
            at.leg_count = 0;
            if (row == faults[i].row) {
                at.departure = faults[i].departure;
                at.left = faults[i].left;
                at.right = faults[i].right;
            }
            assert_int_equal(writer_add(w, &at), TDSP_OK);
        }
        if (writer_finish(w, &golden_tables[0].header, &bytes, &length) != TDSP_BAD_TABLE) fail_msg("fault %zu was not refused", i);
        assert_ptr_equal(bytes, &w);
        assert_int_equal(length, 7);
        writer_free(w);
    }
}

static void equal_arrivals_may_be_stored_as_travel_times_that_round(void **state)
{
    (void)state;
    writer_row rows[200];
    writer_header header = golden_tables[1].header;
    size_t length;
    memset(rows, 0, sizeof rows);
    for (size_t i = 0; i < 200; i++) {
        rows[i].departure = (double)i * 0.1;
        rows[i].left = nextafter(33.3 - rows[i].departure, 100);
        rows[i].right = nextafter(33.3 - rows[i].departure, 0);
    }
    header.first_lower = 33;
    unsigned char *bytes = golden_rows(&header, rows, 200, &length);
    assert_non_null(bytes);
    free(bytes);
}

static void what_the_caller_forgot_is_refused(void **state)
{
    (void)state;
    writer *w = golden_fill(&golden_tables[3], NULL), *empty;
    writer_row row = {5, 0, 0, NULL, 1, NULL, 0};
    writer_header header = golden_tables[3].header;
    void *bytes;
    size_t length;
    assert_non_null(w);
    assert_int_equal(writer_create(NULL, &empty), TDSP_OK);
    assert_int_equal(writer_add(w, NULL), TDSP_INVALID_ARGUMENT);
    assert_int_equal(writer_add(NULL, &row), TDSP_INVALID_ARGUMENT);
    assert_int_equal(writer_add(w, &row), TDSP_INVALID_ARGUMENT);
    row.leg_count = 0, row.byte_count = 1;
    assert_int_equal(writer_add(w, &row), TDSP_INVALID_ARGUMENT);
    row.bytes = &row, row.byte_count = (size_t)1 << 31;
    assert_int_equal(writer_add(w, &row), TDSP_INVALID_ARGUMENT);
    assert_int_equal(writer_finish(empty, &header, &bytes, &length), TDSP_INVALID_ARGUMENT);
    assert_int_equal(writer_finish(w, NULL, &bytes, &length), TDSP_INVALID_ARGUMENT);
    assert_int_equal(writer_finish(w, &header, NULL, &length), TDSP_INVALID_ARGUMENT);
    header.world.length_unit = "sixteen bytes!!!";
    assert_int_equal(writer_finish(w, &header, &bytes, &length), TDSP_INVALID_ARGUMENT);
    header.world.length_unit = "\xff";
    assert_int_equal(writer_finish(w, &header, &bytes, &length), TDSP_BAD_TABLE);
    writer_free(empty);
    writer_free(w);
    writer_free(NULL);
    tdsp_bytes_free(NULL, NULL, 0);
}

static tdsp_status write_within(tight_heap *heap, const golden_table *golden)
{
    const tdsp_allocator allocator = tight_allocator(heap);
    void *bytes;
    size_t length;
    writer *w = golden_fill(golden, &allocator);
    if (!w) return TDSP_NO_MEMORY;
    tdsp_status status = writer_finish(w, &golden->header, &bytes, &length);
    writer_free(w);
    if (status != TDSP_OK) return status;
    assert_int_equal(heap->held, length);
    tdsp_bytes_free(&allocator, bytes, length);
    return TDSP_OK;
}

static void memory_may_fail_anywhere_and_nothing_leaks(void **state)
{
    (void)state;
    for (size_t which = 0; which < GOLDEN_COUNT; which++) {
        tdsp_status status = TDSP_NO_MEMORY;
        size_t refuse = 1;
        for (; status != TDSP_OK && refuse < 100; refuse++) {
            tight_heap heap = {.refuse = refuse, .and_after = 1};
            status = write_within(&heap, &golden_tables[which]);
            assert_true(status == TDSP_OK || status == TDSP_NO_MEMORY);
            assert_int_equal(heap.held, 0);
        }
        assert_int_equal(status, TDSP_OK);
        assert_true(refuse > 4);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(golden_tables_are_written_to_the_bit),
        cmocka_unit_test(finishing_twice_gives_the_same_bytes_and_rows_may_follow),
        cmocka_unit_test(any_well_formed_path_comes_out_to_the_bit),
        cmocka_unit_test(a_leg_that_is_not_well_formed_or_does_not_join_is_refused_and_nothing_added),
        cmocka_unit_test(rows_out_of_order_are_refused_at_the_end_and_nothing_is_handed_out),
        cmocka_unit_test(equal_arrivals_may_be_stored_as_travel_times_that_round),
        cmocka_unit_test(what_the_caller_forgot_is_refused),
        cmocka_unit_test(memory_may_fail_anywhere_and_nothing_leaks),
    };
    return cmocka_run_group_tests_name("writer", tests, NULL, NULL);
}
