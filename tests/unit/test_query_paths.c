/* SPDX-License-Identifier: MIT */
/* Paths, positions and jumps of a table, and what is refused. */
#include "support/cmocka_all.h"

#include <stdlib.h>

#include "support/chance.h"
#include "support/sample.h"
#include "tdsp/path.h"
#include "tdsp/table.h"

/* ----------------------------------------------------------------------------------------------------------- paths */

static void assert_same_leg(const tdsp_leg *a, const tdsp_leg *b)
{
    assert_int_equal(a->kind, b->kind);
    assert_int_equal(a->disc, b->disc);
    assert_int_equal(a->turn, b->turn);
    assert_int_equal(a->reserved, b->reserved);
    assert_memory_equal(&a->start_time, &b->start_time, sizeof *a - offsetof(tdsp_leg, start_time));
}

static void legs_come_out_as_they_went_in(void **state)
{
    (void)state;
    for (size_t which = 0; which < GOLDEN_COUNT; which++) {
        sample s = sample_golden(which);
        for (size_t row = 0; row < s.count; row++) {
            tdsp_leg legs[8];
            size_t count;
            tdsp_row stored;
            assert_int_equal(tdsp_table_row(&s.table, row, &stored), TDSP_OK);
            assert_int_equal(stored.legs, s.rows[row].leg_count);
            assert_int_equal(tdsp_table_path(&s.table, s.rows[row].departure, legs, 8, &count), TDSP_OK);
            assert_int_equal(count, s.rows[row].leg_count);
            for (size_t i = 0; i < count; i++) {
                tdsp_leg leg;
                assert_int_equal(tdsp_table_row_leg(&s.table, row, i, &leg), TDSP_OK);
                assert_same_leg(&leg, &s.rows[row].legs[i]);
                assert_same_leg(&legs[i], &leg);
                assert_int_equal(tdsp_table_leg(&s.table, s.rows[row].departure, i, &leg), TDSP_OK);
                assert_same_leg(&leg, &legs[i]);
            }
            assert_int_equal(tdsp_table_row_leg(&s.table, row, count, legs), TDSP_NO_ANSWER);
            assert_int_equal(tdsp_table_leg(&s.table, s.rows[row].departure, count, legs), TDSP_NO_ANSWER);
        }
        sample_free(&s);
    }
}

static void opaque_bytes_come_out_as_they_went_in(void **state)
{
    (void)state;
    for (size_t which = 0; which < GOLDEN_COUNT; which++) {
        sample s = sample_golden(which);
        for (size_t row = 0; row < s.count; row++) {
            const void *bytes;
            size_t length;
            assert_int_equal(tdsp_table_row_bytes(&s.table, row, &bytes, &length), TDSP_OK);
            assert_int_equal(length, s.rows[row].byte_count);
            if (length == 0)
                assert_null(bytes);
            else
                assert_memory_equal(bytes, s.rows[row].bytes, length);
        }
        sample_free(&s);
    }
}

static void between_rows_the_path_starts_at_the_departure_and_arrives_in_time(void **state)
{
    (void)state;
    uint64_t chance = 18;
    sample s = sample_golden(0);
    for (int i = 0; i < 20000; i++) {
        double t = chance_between(&chance, 0, 12.5), upper;
        tdsp_leg legs[8];
        size_t count;
        size_t row = sample_scan_row(&s, t);
        assert_int_equal(tdsp_table_arrival(&s.table, t, NULL, &upper), TDSP_OK);
        assert_int_equal(tdsp_table_path(&s.table, t, legs, 8, &count), TDSP_OK);
        assert_int_equal(count, s.rows[row].leg_count);
        assert_exact(legs[0].start_time, t);
        assert_true(legs[count - 1].end_time <= upper);
        for (size_t k = 0; k < count; k++) {
            double delay = t - s.rows[row].departure;
            assert_near(legs[k].start_time, s.rows[row].legs[k].start_time + delay, 1e-14);
            assert_near(legs[k].end_time, s.rows[row].legs[k].end_time + delay, 1e-14);
            if (k > 0) assert_exact(legs[k].start_time, legs[k - 1].end_time);
            assert_memory_equal(&legs[k].from, &s.rows[row].legs[k].from, sizeof legs[k] - offsetof(tdsp_leg, from));
        }
    }
    sample_free(&s);
}

static void positions_are_those_of_the_shifted_path(void **state)
{
    (void)state;
    uint64_t chance = 19;
    const size_t with_paths[] = {0, 2};
    for (int i = 0; i < 20000; i++) {
        sample s = sample_golden(with_paths[i / 10000]);
        for (int k = 0; k < 4; k++, i++) {
            double t = sample_departure(&chance, &s), time = chance_between(&chance, -1, 40);
            tdsp_leg legs[8];
            tdsp_point at, expected;
            size_t count;
            if (tdsp_table_path(&s.table, t, legs, 8, &count) != TDSP_OK) continue;
            if (count == 0) {
                assert_int_equal(tdsp_table_position(&s.table, t, time, &at), TDSP_NO_ANSWER);
                continue;
            }
            assert_int_equal(tdsp_path_position(legs, count, time, &expected), TDSP_OK);
            assert_int_equal(tdsp_table_position(&s.table, t, time, &at), TDSP_OK);
            assert_exact(at.x, expected.x);
            assert_exact(at.y, expected.y);
        }
        sample_free(&s);
    }
}

static void at_a_joint_the_robot_is_where_the_second_leg_starts(void **state)
{
    (void)state;
    sample s = sample_golden(2);
    tdsp_point at;
    assert_int_equal(tdsp_table_position(&s.table, 0, 1, &at), TDSP_OK);
    assert_exact(at.x, 1.0000000000000002);
    assert_int_equal(tdsp_table_position(&s.table, 0, nextafter(1, 0), &at), TDSP_OK);
    assert_near(at.x, 1, 3e-16);
    assert_int_equal(tdsp_table_position(&s.table, 0, 2, &at), TDSP_OK);
    assert_exact(at.x, 2.0);
    sample_free(&s);
}

static void in_a_table_monotone_in_arrival_the_robot_waits_at_the_source(void **state)
{
    (void)state;
    const tdsp_leg walk = {.kind = TDSP_LEG_LINE, .disc = TDSP_NO_DISC, .start_time = 2, .end_time = 4, .from = {1, 1}, .to = {3, 1}};
    const writer_row rows[] = {{0, 3, 3, NULL, 0, NULL, 0}, {2, 2, 2, &walk, 1, NULL, 0}};
    writer_header header = golden_tables[1].header;
    tdsp_table table;
    tdsp_leg leg;
    tdsp_point at;
    size_t length;
    header.first_lower = 3;
    unsigned char *bytes = golden_rows(&header, rows, 2, &length);
    assert_int_equal(tdsp_table_open(&table, bytes, length), TDSP_OK);
    assert_int_equal(tdsp_table_leg(&table, 0.5, 0, &leg), TDSP_OK);
    assert_same_leg(&leg, &walk);
    assert_int_equal(tdsp_table_position(&table, 0.5, 1.5, &at), TDSP_OK);
    assert_exact(at.x, 1.0);
    assert_int_equal(tdsp_table_position(&table, 0.5, 3, &at), TDSP_OK);
    assert_exact(at.x, 2.0);
    assert_int_equal(tdsp_table_position(&table, 0, 3, &at), TDSP_NO_ANSWER);
    free(bytes);
}

static void a_buffer_too_small_for_a_path_is_told_the_count_and_left_alone(void **state)
{
    (void)state;
    sample s = sample_golden(0);
    tdsp_leg legs[3];
    size_t count = 0;
    memset(legs, 0x5a, sizeof legs);
    assert_int_equal(tdsp_table_path(&s.table, 5, legs, 3, &count), TDSP_BUFFER_TOO_SMALL);
    assert_int_equal(count, 4);
    assert_int_equal(((unsigned char *)legs)[0], 0x5a);
    assert_int_equal(tdsp_table_path(&s.table, 5, NULL, 0, &count), TDSP_BUFFER_TOO_SMALL);
    assert_int_equal(tdsp_table_path(&s.table, 5, NULL, 4, &count), TDSP_INVALID_ARGUMENT);
    sample_free(&s);
}

/* ----------------------------------------------------------------------------------------------------------- jumps */

static void jumps_are_found_in_both_directions(void **state)
{
    (void)state;
    sample s = sample_golden(1);
    tdsp_jump jump;
    assert_int_equal(tdsp_table_next_jump(&s.table, -INFINITY, &jump), TDSP_OK);
    assert_int_equal(jump.row, 1);
    assert_exact(jump.departure, 2.0);
    assert_exact(jump.before, 4.0);
    assert_exact(jump.after, 7.0);
    assert_int_equal(tdsp_table_next_jump(&s.table, 2, &jump), TDSP_OK);
    assert_int_equal(jump.row, 1);
    assert_int_equal(tdsp_table_next_jump(&s.table, nextafter(2, 3), &jump), TDSP_OK);
    assert_int_equal(jump.row, 3);
    assert_int_equal(tdsp_table_next_jump(&s.table, 6.5, &jump), TDSP_NO_ANSWER);
    assert_int_equal(tdsp_table_previous_jump(&s.table, INFINITY, &jump), TDSP_OK);
    assert_int_equal(jump.row, 3);
    assert_int_equal(tdsp_table_previous_jump(&s.table, 6, &jump), TDSP_OK);
    assert_int_equal(jump.row, 1);
    jump.row = 7;
    assert_int_equal(tdsp_table_previous_jump(&s.table, 2, &jump), TDSP_NO_ANSWER);
    assert_int_equal(jump.row, 7);
    sample_free(&s);
}

static void neither_the_end_nor_what_the_stated_error_explains_is_a_jump(void **state)
{
    (void)state;
    writer_header header = golden_tables[0].header;
    writer_row rows[] = {{0, 20, 20, NULL, 0, NULL, 0}, {1, 20, 20, NULL, 0, NULL, 0}, {2, 21, INFINITY, NULL, 0, NULL, 0}};
    const struct {
        double error;
        double rise;
        tdsp_status expected;
    } cases[] = {{0, 0, TDSP_NO_ANSWER},         {0, 1e-11, TDSP_NO_ANSWER}, {0, 3e-11, TDSP_OK},
                 {1e-3, 0.0799, TDSP_NO_ANSWER}, {1e-3, 0.0801, TDSP_OK},    {1e-3, 0.5, TDSP_OK}};
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        size_t length;
        tdsp_table table;
        tdsp_jump jump;
        rows[1].right = 20 + cases[i].rise;
        header.error = cases[i].error;
        unsigned char *bytes = golden_rows(&header, rows, 3, &length);
        assert_int_equal(tdsp_table_open(&table, bytes, length), TDSP_OK);
        assert_int_equal(tdsp_table_next_jump(&table, 0, &jump), cases[i].expected);
        assert_int_equal(tdsp_table_next_jump(&table, 2, &jump), TDSP_NO_ANSWER);
        assert_int_equal(tdsp_table_next_jump(&table, nextafter(2, 3), &jump), TDSP_NO_ANSWER);
        free(bytes);
    }
}

/* ---------------------------------------------------------------------------------------------------------- misuse */

static void arguments_that_are_missing_or_out_of_range_are_refused_and_nothing_is_written(void **state)
{
    (void)state;
    sample s = sample_golden(0);
    const tdsp_table *table = &s.table;
    double x = 7, bad[] = {NAN, -1, -INFINITY};
    tdsp_row row = {7, 7, 7, 7};
    tdsp_leg leg;
    tdsp_point at;
    tdsp_jump jump;
    const void *bytes;
    size_t size;
    uint64_t found;
    for (size_t i = 0; i < 3; i++) {
        assert_int_equal(tdsp_table_find(table, bad[i], &found), TDSP_INVALID_ARGUMENT);
        assert_int_equal(tdsp_table_arrival(table, bad[i], &x, &x), TDSP_INVALID_ARGUMENT);
        assert_int_equal(tdsp_table_leg(table, bad[i], 0, &leg), TDSP_INVALID_ARGUMENT);
        assert_int_equal(tdsp_table_path(table, bad[i], &leg, 1, &size), TDSP_INVALID_ARGUMENT);
        assert_int_equal(tdsp_table_position(table, bad[i], 0, &at), TDSP_INVALID_ARGUMENT);
    }
    assert_int_equal(tdsp_table_departure(table, NAN, &x, &x), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_table_position(table, 0, NAN, &at), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_table_position(table, 0, INFINITY, &at), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_table_next_jump(table, NAN, &jump), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_table_previous_jump(table, NAN, &jump), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_table_row(table, 4, &row), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_table_row(table, UINT64_MAX, &row), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_table_row_leg(table, 4, 0, &leg), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_table_row_bytes(table, 4, &bytes, &size), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_table_find(table, 0, NULL), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_table_row(table, 0, NULL), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_table_get_info(table, NULL), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_table_leg(table, 0, 0, NULL), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_table_row_leg(table, 0, 0, NULL), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_table_row_bytes(table, 0, NULL, &size), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_table_row_bytes(table, 0, &bytes, NULL), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_table_path(table, 0, &leg, 1, NULL), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_table_position(table, 0, 0, NULL), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_table_next_jump(table, 0, NULL), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_table_arrivals(table, NULL, 1, &x, &x, NULL), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_table_departures(table, NULL, 1, &x, &x, NULL), TDSP_INVALID_ARGUMENT);
    assert_exact(x, 7.0);
    assert_exact(row.departure, 7.0);
    sample_free(&s);
}

static void assert_refused_without_a_table(const tdsp_table *table)
{
    double x = 0;
    tdsp_row row;
    tdsp_table_info info;
    tdsp_leg leg;
    tdsp_point at;
    tdsp_jump jump;
    const void *bytes;
    size_t size;
    uint64_t found;
    assert_int_equal(tdsp_table_get_info(table, &info), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_table_row(table, 0, &row), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_table_find(table, 0, &found), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_table_arrival(table, 0, &x, &x), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_table_departure(table, 0, &x, &x), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_table_arrivals(table, &x, 1, &x, &x, NULL), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_table_departures(table, &x, 1, &x, &x, NULL), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_table_leg(table, 0, 0, &leg), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_table_row_leg(table, 0, 0, &leg), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_table_row_bytes(table, 0, &bytes, &size), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_table_path(table, 0, &leg, 1, &size), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_table_position(table, 0, 0, &at), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_table_next_jump(table, 0, &jump), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_table_previous_jump(table, 0, &jump), TDSP_INVALID_ARGUMENT);
}

static void no_question_is_answered_without_an_opened_table(void **state)
{
    (void)state;
    const tdsp_table never_opened = {0};
    assert_refused_without_a_table(NULL);
    assert_refused_without_a_table(&never_opened);
}

static void either_result_may_be_left_out(void **state)
{
    (void)state;
    sample s = sample_golden(0);
    double x = 7;
    assert_int_equal(tdsp_table_arrival(&s.table, 2, &x, NULL), TDSP_OK);
    assert_exact(x, 22.0);
    assert_int_equal(tdsp_table_arrival(&s.table, 2, NULL, &x), TDSP_OK);
    assert_exact(x, 22.5);
    assert_int_equal(tdsp_table_departure(&s.table, 22, &x, NULL), TDSP_OK);
    assert_exact(x, 1.5);
    assert_int_equal(tdsp_table_departure(&s.table, 22, NULL, &x), TDSP_OK);
    assert_exact(x, 2.0);
    sample_free(&s);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(legs_come_out_as_they_went_in),
        cmocka_unit_test(opaque_bytes_come_out_as_they_went_in),
        cmocka_unit_test(between_rows_the_path_starts_at_the_departure_and_arrives_in_time),
        cmocka_unit_test(positions_are_those_of_the_shifted_path),
        cmocka_unit_test(at_a_joint_the_robot_is_where_the_second_leg_starts),
        cmocka_unit_test(in_a_table_monotone_in_arrival_the_robot_waits_at_the_source),
        cmocka_unit_test(a_buffer_too_small_for_a_path_is_told_the_count_and_left_alone),
        cmocka_unit_test(jumps_are_found_in_both_directions),
        cmocka_unit_test(neither_the_end_nor_what_the_stated_error_explains_is_a_jump),
        cmocka_unit_test(no_question_is_answered_without_an_opened_table),
        cmocka_unit_test(either_result_may_be_left_out),
        cmocka_unit_test(arguments_that_are_missing_or_out_of_range_are_refused_and_nothing_is_written),
    };
    return cmocka_run_group_tests_name("query paths", tests, NULL, NULL);
}
