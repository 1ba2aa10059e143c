/* SPDX-License-Identifier: MIT */
/* Where departures end: by the oracle, by the horizon, or never; with latest_departure and without. */
#include <float.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

#include "support/assert.h"
#include "support/toy_tables.h"

static tdsp_build_options until(double horizon)
{
    tdsp_build_options options;
    tdsp_build_options_init(&options);
    options.horizon = horizon;
    return options;
}

static tdsp_status status_of(const tdsp_oracle *oracle, const tdsp_build_options *options)
{
    void *bytes = NULL;
    size_t length = 0;
    tdsp_status status = tdsp_build(oracle, options, NULL, &bytes, &length, NULL);
    if (status == TDSP_OK)
        tdsp_bytes_free(NULL, bytes, length);
    else
        assert_null(bytes);
    return status;
}

static tdsp_row last_row(const toy_table *table)
{
    tdsp_row row;
    assert_int_equal(tdsp_table_row(&table->table, table->table.rows - 1, &row), TDSP_OK);
    return row;
}

static void departures_end_at_the_last_double_with_an_answer(void **state)
{
    (void)state;
    size_t count;
    const toy_world *worlds = toy_worlds(&count);
    for (size_t i = 0; i < count; i++)
        for (int forward_only = 0; forward_only < 2; forward_only++) {
            toy t = worlds[i].toy;
            t.reason = TDSP_DESTINATION_COVERED;
            tdsp_oracle oracle = toy_oracle(&t, forward_only);
            tdsp_build_options options = until(INFINITY);
            toy_table table = toy_build(&oracle, &options);
            assert_exact(table.report.last_departure, toy_last(&t));
            assert_int_equal(table.report.last_reason, TDSP_DESTINATION_COVERED);
            assert_exact(last_row(&table).departure, toy_last(&t));
            assert_exact(last_row(&table).right, INFINITY);
            toy_table_free(&table);
        }
}

static void the_end_is_found_within_the_stated_error(void **state)
{
    (void)state;
    for (int forward_only = 0; forward_only < 2; forward_only++) {
        toy t = toy_named("linear")->toy;
        t.error = 1e-9;
        t.time_scale = 5;
        t.blur = 3e-9;
        tdsp_oracle oracle = toy_oracle(&t, forward_only);
        tdsp_build_options options = until(INFINITY);
        toy_table table = toy_build(&oracle, &options);
        assert_near(table.report.last_departure, toy_last(&t), t.blur + 20 * t.error);
        assert_true(table.report.forward_calls < table.report.rows + (forward_only ? 60 : 8));
        toy_table_free(&table);
    }
}

static tdsp_status last_reason(void *ctx, double departure, tdsp_status *reason)
{
    const toy *t = ctx;
    assert_exact(departure, toy_last(t));
    *reason = TDSP_SOURCE_COVERED;
    return TDSP_OK;
}

static tdsp_status odd_reason(void *ctx, double departure, tdsp_status *reason)
{
    (void)ctx;
    (void)departure;
    *reason = TDSP_HORIZON;
    return TDSP_OK;
}

static tdsp_status failing_reason(void *ctx, double departure, tdsp_status *reason)
{
    (void)ctx;
    (void)departure;
    (void)reason;
    return TDSP_FAILED;
}

static void the_reason_is_the_oracles_own_where_it_has_one(void **state)
{
    (void)state;
    toy t = toy_named("linear")->toy;
    tdsp_oracle oracle = toy_oracle(&t, 0);
    tdsp_build_options options = until(INFINITY);
    oracle.last_reason = last_reason;
    toy_table table = toy_build(&oracle, &options);
    assert_int_equal(table.report.last_reason, TDSP_SOURCE_COVERED);
    toy_table_free(&table);
    oracle.last_reason = odd_reason;
    assert_int_equal(status_of(&oracle, &options), TDSP_BAD_ORACLE);
    oracle.last_reason = failing_reason;
    assert_int_equal(status_of(&oracle, &options), TDSP_FAILED);
}

static void a_horizon_before_the_end_ends_the_table(void **state)
{
    (void)state;
    for (int forward_only = 0; forward_only < 2; forward_only++) {
        toy t = toy_named("bend")->toy;
        tdsp_oracle oracle = toy_oracle(&t, forward_only);
        tdsp_build_options options = until(4.5);
        toy_table table = toy_build(&oracle, &options);
        assert_exact(table.report.last_departure, 4.5);
        assert_int_equal(table.report.last_reason, TDSP_HORIZON);
        assert_near(last_row(&table).right, (double)toy_value(&t, 4.5), 1e-13);
        assert_int_equal(table.report.reverse_calls, 0);
        toy_certify(&t, &options, &table, 1000);
        toy_table_free(&table);
    }
}

static void a_jump_right_at_the_horizon_is_kept(void **state)
{
    (void)state;
    toy t = toy_named("cliff")->toy;
    tdsp_oracle oracle = toy_oracle(&t, 0);
    tdsp_build_options options = until(7);
    toy_table table = toy_build(&oracle, &options);
    assert_near(last_row(&table).left, 3, 1e-13);
    assert_near(last_row(&table).right, 9, 1e-13);
    toy_table_free(&table);
}

static void a_horizon_at_or_after_the_end_changes_nothing(void **state)
{
    (void)state;
    static const double horizons[] = {10, 10.0000001, 1000, 1e300, DBL_MAX};
    for (size_t i = 0; i < sizeof horizons / sizeof *horizons; i++)
        for (int forward_only = 0; forward_only < 2; forward_only++) {
            toy t = toy_named("linear")->toy;
            tdsp_oracle oracle = toy_oracle(&t, forward_only);
            tdsp_build_options options = until(horizons[i]);
            toy_table table = toy_build(&oracle, &options);
            assert_exact(table.report.last_departure, 10);
            assert_int_equal(table.report.last_reason, TDSP_CUT_OFF);
            assert_exact(last_row(&table).right, INFINITY);
            toy_table_free(&table);
        }
}

static void a_horizon_of_zero_makes_one_row(void **state)
{
    (void)state;
    toy t = toy_named("linear")->toy;
    tdsp_oracle oracle = toy_oracle(&t, 0);
    tdsp_build_options options = until(0);
    toy_table table = toy_build(&oracle, &options);
    assert_int_equal(table.report.rows, 1);
    assert_int_equal(table.report.last_reason, TDSP_HORIZON);
    toy_table_free(&table);
    t = toy_named("instant")->toy;
    oracle = toy_oracle(&t, 0);
    table = toy_build(&oracle, &options);
    assert_int_equal(table.report.rows, 1);
    assert_int_equal(table.report.last_reason, TDSP_CUT_OFF);
    toy_table_free(&table);
}

static void departures_that_never_end_need_a_horizon(void **state)
{
    (void)state;
    static const toy_piece level[] = {{INFINITY, 5, 0, 0}};
    static const toy_piece growing[] = {{INFINITY, 5, 0.25, 0}};
    static const toy_piece nothing[] = {{INFINITY, 0, 0, 0}};
    const toy_piece *const all[] = {level, growing, nothing};
    for (size_t i = 0; i < 3; i++)
        for (int forward_only = 0; forward_only < 2; forward_only++) {
            toy t = toy_over(all[i], 1, 0);
            tdsp_oracle oracle = toy_oracle(&t, forward_only);
            tdsp_build_options options = until(INFINITY);
            assert_int_equal(status_of(&oracle, &options), TDSP_NEEDS_HORIZON);
            assert_true(t.forward_calls < 20);
            options.horizon = 100;
            toy_table table = toy_build(&oracle, &options);
            assert_int_equal(table.report.last_reason, TDSP_HORIZON);
            toy_certify(&t, &options, &table, 1000);
            toy_table_free(&table);
        }
}

static void no_way_at_departure_zero_is_an_answer(void **state)
{
    (void)state;
    static const toy_piece never[] = {{-1, 5, 0, 0}};
    static const tdsp_status reasons[] = {TDSP_SOURCE_COVERED, TDSP_DESTINATION_COVERED, TDSP_CUT_OFF, TDSP_UNREACHABLE};
    for (size_t i = 0; i < 4; i++) {
        toy t = toy_over(never, 1, 0);
        t.reason = reasons[i];
        tdsp_oracle oracle = toy_oracle(&t, 0);
        tdsp_build_options options = until(INFINITY);
        assert_int_equal(status_of(&oracle, &options), reasons[i]);
        assert_int_equal(t.forward_calls, 1);
    }
}

static void the_end_is_found_at_any_scale_by_forward_calls_alone(void **state)
{
    (void)state;
    for (int exponent = -300; exponent <= 150; exponent += 25) {
        toy_piece piece = {.until = 3 * pow(10, exponent), .c0 = 5};
        toy t = toy_over(&piece, 1, 0);
        tdsp_oracle oracle = toy_oracle(&t, 1);
        tdsp_build_options options = until(INFINITY);
        int resolved = piece.until * 0x1p-52 < piece.c0;
        if (!resolved) {
            assert_int_equal(status_of(&oracle, &options), TDSP_NEEDS_HORIZON);
            continue;
        }
        toy_table table = toy_build(&oracle, &options);
        assert_exact(table.report.last_departure, piece.until);
        assert_true(table.report.forward_calls < 140);
        toy_table_free(&table);
    }
}

static void a_seed_that_is_wrong_is_corrected_by_forward_calls(void **state)
{
    (void)state;
    /* latest_departure says 10, the forward function goes on to 10 + blur, far over the stated error. */
    toy t = toy_named("linear")->toy;
    t.blur = 0.5;
    tdsp_oracle oracle = toy_oracle(&t, 0);
    tdsp_build_options options = until(INFINITY);
    void *bytes = NULL;
    size_t length = 0;
    tdsp_build_report report;
    tdsp_status status = tdsp_build(&oracle, &options, NULL, &bytes, &length, &report);
    assert_int_equal(status, TDSP_OK);
    assert_near(report.last_departure, 10.5, 1e-9);
    tdsp_bytes_free(NULL, bytes, length);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(departures_end_at_the_last_double_with_an_answer),
        cmocka_unit_test(the_end_is_found_within_the_stated_error),
        cmocka_unit_test(the_reason_is_the_oracles_own_where_it_has_one),
        cmocka_unit_test(a_horizon_before_the_end_ends_the_table),
        cmocka_unit_test(a_jump_right_at_the_horizon_is_kept),
        cmocka_unit_test(a_horizon_at_or_after_the_end_changes_nothing),
        cmocka_unit_test(a_horizon_of_zero_makes_one_row),
        cmocka_unit_test(departures_that_never_end_need_a_horizon),
        cmocka_unit_test(no_way_at_departure_zero_is_an_answer),
        cmocka_unit_test(the_end_is_found_at_any_scale_by_forward_calls_alone),
        cmocka_unit_test(a_seed_that_is_wrong_is_corrected_by_forward_calls),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
