/* SPDX-License-Identifier: MIT */
/* Look-up in both directions: against answers by hand, and against a scan of all rows on random tables. */
#include "support/cmocka_all.h"

#include <float.h>
#include <stdlib.h>

#include "base/round.h"
#include "support/chance.h"
#include "support/sample.h"
#include "support/walk.h"
#include "tdsp/table.h"

/* ------------------------------------------------------------------------------------------------- answers by hand */

static void assert_interval(const sample *s, double departure, double lower, double upper)
{
    double l, u;
    assert_int_equal(tdsp_table_arrival(&s->table, departure, &l, &u), TDSP_OK);
    assert_exact(l, lower);
    assert_exact(u, upper);
}

static void assert_departure(const sample *s, double arrival, double departure, double last)
{
    double d, u;
    assert_int_equal(tdsp_table_departure(&s->table, arrival, &d, &u), TDSP_OK);
    assert_exact(d, departure);
    assert_exact(u, last);
}

static void a_table_monotone_in_travel_time_answers_as_worked_out_by_hand(void **state)
{
    (void)state;
    sample s = sample_golden(0);
    double unused = 7;
    assert_interval(&s, 0, 19.75, 20);
    assert_interval(&s, -0.0, 19.75, 20);
    assert_interval(&s, 2, 22, 22.5);
    assert_interval(&s, 4, 24, 24.5);
    assert_interval(&s, 9, 29.25, 29.75);
    assert_interval(&s, 10, 34.5, 34.75);
    assert_interval(&s, 12.5, 37, 37.25);
    assert_departure(&s, 20, 0, 0);
    assert_departure(&s, 22, 1.5, 2);
    assert_departure(&s, 24.5, 4, 4.25);
    assert_departure(&s, 32, 9.75, 9.75);
    assert_departure(&s, 36, 11.25, 11.5);
    assert_departure(&s, 100, 12.5, 12.5);
    assert_departure(&s, INFINITY, 12.5, 12.5);
    assert_int_equal(tdsp_table_departure(&s.table, 19.999, &unused, &unused), TDSP_ARRIVAL_TOO_EARLY);
    assert_int_equal(tdsp_table_departure(&s.table, -INFINITY, &unused, &unused), TDSP_ARRIVAL_TOO_EARLY);
    assert_exact(unused, 7.0);
    sample_free(&s);
}

static void a_table_monotone_in_arrival_answers_as_worked_out_by_hand(void **state)
{
    (void)state;
    sample s = sample_golden(1);
    assert_interval(&s, 0, 4.9, 5);
    assert_interval(&s, 1, 5, 6);
    assert_interval(&s, 2, 5, 6);
    assert_interval(&s, 3, 9, 9);
    assert_interval(&s, 5.5, 9, 9);
    assert_departure(&s, 5, 0, 2);
    assert_departure(&s, 8, 2, 2);
    assert_departure(&s, 9, 6, 6);
    assert_departure(&s, 9.25, 6, 6);
    assert_departure(&s, 10, 6, 10);
    assert_departure(&s, INFINITY, 6, INFINITY);
    sample_free(&s);
}

static void sums_that_are_not_exact_are_rounded_outward(void **state)
{
    (void)state;
    sample s = sample_golden(2);
    assert_interval(&s, 0.1, nextafter(2.1, 0), 2.1);
    assert_departure(&s, 2.1, 0.1, 0.10000000000000009);
    sample_free(&s);
}

static void the_lower_end_is_never_before_the_departure(void **state)
{
    (void)state;
    const writer_row rows[] = {{0, 1, 1, NULL, 0, NULL, 0}, {5, 1, 1, NULL, 0, NULL, 0}};
    size_t length;
    sample s = {0};
    s.bytes = golden_rows(&golden_tables[1].header, rows, 2, &length);
    assert_null(s.bytes);
    writer_header header = golden_tables[1].header;
    header.first_lower = 1;
    s.bytes = golden_rows(&header, rows, 2, &length);
    assert_int_equal(tdsp_table_open(&s.table, s.bytes, length), TDSP_OK);
    assert_interval(&s, 0.5, 1, 6);
    assert_interval(&s, 3, 3, 6);
    sample_free(&s);
}

static void one_row_answers_departure_0_and_nothing_else(void **state)
{
    (void)state;
    uint64_t row = 9;
    sample s = sample_golden(3);
    assert_interval(&s, 0, 0, 0);
    assert_departure(&s, 0, 0, 0);
    assert_departure(&s, 5, 0, 5);
    assert_int_equal(tdsp_table_find(&s.table, nextafter(0, 1), &row), TDSP_OUTSIDE_TABLE);
    assert_int_equal(row, 9);
    sample_free(&s);
}

static void after_the_last_departure_the_table_says_why(void **state)
{
    (void)state;
    const tdsp_status reasons[] = {TDSP_CUT_OFF, TDSP_HORIZON, TDSP_SOURCE_COVERED, TDSP_OUTSIDE_TABLE,
                                   TDSP_DESTINATION_COVERED, TDSP_SOURCE_COVERED, TDSP_CUT_OFF};
    for (size_t which = 0; which < GOLDEN_COUNT; which++) {
        double lower = 7, upper = 7;
        size_t count = 7;
        tdsp_leg leg;
        tdsp_point at;
        sample s = sample_golden(which);
        double after = nextafter(s.rows[s.count - 1].departure, INFINITY);
        assert_int_equal(tdsp_table_arrival(&s.table, after, &lower, &upper), reasons[which]);
        assert_int_equal(tdsp_table_arrival(&s.table, INFINITY, &lower, &upper), reasons[which]);
        assert_int_equal(tdsp_table_path(&s.table, after, NULL, 0, &count), reasons[which]);
        assert_int_equal(tdsp_table_leg(&s.table, after, 0, &leg), reasons[which]);
        assert_int_equal(tdsp_table_position(&s.table, after, 0, &at), reasons[which]);
        assert_exact(lower, 7.0);
        assert_exact(upper, 7.0);
        assert_int_equal(count, 7);
        sample_free(&s);
    }
}

/* ------------------------------------------------------------------------------------------------ against all rows */

/* -1, 0 or 1 as the real number a + b is below, at or over c; sums as pairs of TwoSum compare in order. */
static int compare_sum(double a, double b, double c)
{
    double s = a + b;
    double e = round_sum_error(a, b, s);
    if (!(s < INFINITY)) return s > c ? 1 : 0;
    return s < c ? -1 : s > c ? 1 : e < 0 ? -1 : e > 0 ? 1 : 0;
}

static void the_row_found_is_that_of_a_scan(void **state)
{
    (void)state;
    uint64_t chance = 11;
    for (int round = 0; round < 600; round++) {
        sample s = sample_random(&chance, 1 + (size_t)chance_below(&chance, 70), round % 2, round % 3);
        for (int i = 0; i < 100; i++) {
            double t = sample_departure(&chance, &s);
            size_t expected = sample_scan_row(&s, t);
            uint64_t row;
            tdsp_status status = tdsp_table_find(&s.table, t, &row);
            if (expected == s.count)
                assert_int_equal(status, round % 3 ? TDSP_HORIZON : TDSP_CUT_OFF);
            else
                assert_true(status == TDSP_OK && row == expected);
        }
        sample_free(&s);
    }
}

/* The interval by the definition, with the sums compared exactly: the tightest doubles around them. */
static void check_interval_against_scan(const sample *s, double t)
{
    double lower, upper;
    size_t row = sample_scan_row(s, t);
    if (row == s->count) return;
    assert_int_equal(tdsp_table_arrival(&s->table, t, &lower, &upper), TDSP_OK);
    double from = s->travel ? t : s->rows[row].departure;
    assert_true(compare_sum(from, s->rows[row].left, upper) <= 0);
    assert_true(compare_sum(from, s->rows[row].left, nextafter(upper, -INFINITY)) > 0);
    assert_true(lower <= upper && lower >= t);
    if (row == 0) assert_exact(lower, s->first_lower);
    if (row == 0) return;
    from = s->travel ? t : s->rows[row - 1].departure;
    assert_true(compare_sum(from, s->rows[row - 1].right, lower) >= 0 || lower == t);
    assert_true(compare_sum(from, s->rows[row - 1].right, nextafter(lower, INFINITY)) < 0);
}

static void intervals_are_the_tightest_doubles_around_the_definition(void **state)
{
    (void)state;
    uint64_t chance = 12;
    for (int round = 0; round < 600; round++) {
        sample s = sample_random(&chance, 1 + (size_t)chance_below(&chance, 70), round % 2, round % 3);
        for (int i = 0; i < 100; i++)
            check_interval_against_scan(&s, sample_departure(&chance, &s));
        sample_free(&s);
    }
}

/* sup { t : the upper end at t <= a } over each row by itself, as a double rounded down; -1 when there is none. */
static double scan_safe(const sample *s, double a)
{
    double best = -1;
    for (size_t i = 0; i < s->count; i++) {
        const writer_row *row = &s->rows[i];
        double t = s->travel                                        ? round_subtract_down(a, row->left)
                   : compare_sum(row->departure, row->left, a) <= 0 ? row->departure
                                                                    : -1;
        if (t > row->departure) t = row->departure;
        if (i > 0 ? t <= s->rows[i - 1].departure : t < 0) continue;
        if (t > best) best = t;
    }
    return best;
}

/* sup { t : the lower end at t <= a } over each row by itself, rounded up. */
static double scan_last(const sample *s, double a)
{
    double best = 0;
    for (size_t i = 0; i < s->count; i++) {
        const writer_row *row = &s->rows[i];
        if (!(row->right < INFINITY) || compare_sum(row->departure, row->right, a) > 0) continue;
        double t = s->travel ? round_subtract_up(a, row->right) : a;
        if (i + 1 < s->count && t > s->rows[i + 1].departure) t = s->rows[i + 1].departure;
        if (t > best) best = t;
    }
    return best;
}

static void departures_are_the_best_that_a_scan_of_all_rows_finds(void **state)
{
    (void)state;
    uint64_t chance = 13;
    for (int round = 0; round < 600; round++) {
        sample s = sample_random(&chance, 1 + (size_t)chance_below(&chance, 70), 1, round % 3);
        for (int i = 0; i < 100; i++) {
            double a = sample_arrival(&chance, &s), departure, last;
            double safe = scan_safe(&s, a);
            tdsp_status status = tdsp_table_departure(&s.table, a, &departure, &last);
            assert_int_equal(status, safe < 0 ? TDSP_ARRIVAL_TOO_EARLY : TDSP_OK);
            if (status != TDSP_OK) continue;
            assert_exact(departure, safe);
            assert_exact(last, scan_last(&s, a));
        }
        sample_free(&s);
    }
}

/* Where arrivals are flat the stored sums wobble by their rounding: the best to within it. */
static void departures_of_a_table_monotone_in_arrival_are_the_best_up_to_rounding(void **state)
{
    (void)state;
    uint64_t chance = 14;
    for (int round = 0; round < 600; round++) {
        sample s = sample_random(&chance, 1 + (size_t)chance_below(&chance, 70), 0, round % 3);
        for (int i = 0; i < 100; i++) {
            double a = sample_arrival(&chance, &s), departure, last;
            if (tdsp_table_departure(&s.table, a, &departure, &last) != TDSP_OK) {
                assert_true(scan_safe(&s, a * (1 - 1e-15)) < 0);
                continue;
            }
            assert_true(departure >= scan_safe(&s, a * (1 - 1e-15)) && departure <= scan_safe(&s, a));
            assert_true(last >= departure);
            assert_true(last >= scan_last(&s, a * (1 - 1e-15)) && last <= scan_last(&s, a * (1 + 1e-15)));
        }
        sample_free(&s);
    }
}

/* What leaves at `departure` arrives in time; what leaves after `last` does not. */
static void check_duality(uint64_t *chance, const sample *s, double a)
{
    double departure, last, lower, upper;
    if (tdsp_table_departure(&s->table, a, &departure, &last) != TDSP_OK) return;
    assert_true(departure <= last);
    assert_int_equal(tdsp_table_arrival(&s->table, departure, NULL, &upper), TDSP_OK);
    assert_true(upper <= a);
    double t = chance_below(chance, 2) ? nextafter(last, INFINITY) : last + chance_between(chance, 0, 3) * 1e-3 + 1e-9;
    if (tdsp_table_arrival(&s->table, t, &lower, &upper) != TDSP_OK) return;
    size_t row = sample_scan_row(s, t);
    double from = s->travel ? t : s->rows[row - 1].departure;
    assert_true(compare_sum(from, s->rows[row - 1].right, a) > 0 || (!s->travel && t > a));
    assert_true(lower >= a && upper > a);
    if (t > last + 1e-10 && s->travel) assert_true(lower > a);
}

static void both_directions_agree(void **state)
{
    (void)state;
    uint64_t chance = 15;
    for (int round = 0; round < 600; round++) {
        sample s = sample_random(&chance, 1 + (size_t)chance_below(&chance, 70), round % 2, round % 3);
        for (int i = 0; i < 100; i++)
            check_duality(&chance, &s, sample_arrival(&chance, &s));
        sample_free(&s);
    }
}

static void a_table_of_100000_rows_answers_as_a_scan_does(void **state)
{
    (void)state;
    uint64_t chance = 16;
    for (int travel = 0; travel < 2; travel++) {
        sample s = sample_random(&chance, 100000, travel, 0);
        assert_null(walk_table(&s.table));
        for (int i = 0; i < 300; i++) {
            check_interval_against_scan(&s, sample_departure(&chance, &s));
            check_duality(&chance, &s, sample_arrival(&chance, &s));
        }
        for (int i = 0; i < 100 && travel; i++) {
            double a = sample_arrival(&chance, &s), departure, last;
            if (tdsp_table_departure(&s.table, a, &departure, &last) != TDSP_OK) continue;
            assert_exact(departure, scan_safe(&s, a));
            assert_exact(last, scan_last(&s, a));
        }
        sample_free(&s);
    }
}

static void looking_up_many_at_once_is_looking_up_each(void **state)
{
    (void)state;
    uint64_t chance = 17;
    double t[64], low[64], high[64], l, u;
    tdsp_status statuses[64];
    sample s = sample_random(&chance, 50, 1, 0);
    for (int i = 0; i < 64; i++)
        t[i] = sample_departure(&chance, &s);
    t[3] = NAN, t[4] = -1, t[5] = INFINITY;
    assert_int_equal(tdsp_table_arrivals(&s.table, t, 64, low, high, statuses), TDSP_OK);
    for (int i = 0; i < 64; i++) {
        l = u = INFINITY;
        assert_int_equal(statuses[i], tdsp_table_arrival(&s.table, t[i], &l, &u));
        assert_exact(low[i], l);
        assert_exact(high[i], u);
    }
    for (int i = 6; i < 64; i++)
        t[i] = sample_arrival(&chance, &s);
    assert_int_equal(tdsp_table_departures(&s.table, t, 64, low, high, statuses), TDSP_OK);
    for (int i = 0; i < 64; i++) {
        l = u = -INFINITY;
        assert_int_equal(statuses[i], tdsp_table_departure(&s.table, t[i], &l, &u));
        assert_exact(low[i], l);
        assert_exact(high[i], u);
    }
    assert_int_equal(tdsp_table_arrivals(&s.table, t, 64, NULL, NULL, NULL), TDSP_OK);
    assert_int_equal(tdsp_table_departures(&s.table, t, 64, NULL, NULL, NULL), TDSP_OK);
    sample_free(&s);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_table_monotone_in_travel_time_answers_as_worked_out_by_hand),
        cmocka_unit_test(a_table_monotone_in_arrival_answers_as_worked_out_by_hand),
        cmocka_unit_test(sums_that_are_not_exact_are_rounded_outward),
        cmocka_unit_test(the_lower_end_is_never_before_the_departure),
        cmocka_unit_test(one_row_answers_departure_0_and_nothing_else),
        cmocka_unit_test(after_the_last_departure_the_table_says_why),
        cmocka_unit_test(the_row_found_is_that_of_a_scan),
        cmocka_unit_test(intervals_are_the_tightest_doubles_around_the_definition),
        cmocka_unit_test(departures_are_the_best_that_a_scan_of_all_rows_finds),
        cmocka_unit_test(departures_of_a_table_monotone_in_arrival_are_the_best_up_to_rounding),
        cmocka_unit_test(both_directions_agree),
        cmocka_unit_test(a_table_of_100000_rows_answers_as_a_scan_does),
        cmocka_unit_test(looking_up_many_at_once_is_looking_up_each),
    };
    return cmocka_run_group_tests_name("query", tests, NULL, NULL);
}
