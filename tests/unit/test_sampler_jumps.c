/* SPDX-License-Identifier: MIT */
/*
 * Jumps that are certified by reverse calls: exact places, few calls, and what happens near other jumps, steep pieces, the end, and with
 * a reverse oracle that does not tell the truth.
 */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

#include "support/assert.h"
#include "support/toy_tables.h"

#define ERROR 1e-11

static tdsp_build_options with(tdsp_sampling sampling, double bound)
{
    tdsp_build_options options;
    tdsp_build_options_init(&options);
    options.sampling = sampling;
    options.guarantee = sampling == TDSP_SAMPLING_GEOMETRIC ? TDSP_GUARANTEE_ARRIVAL : TDSP_GUARANTEE_TRAVEL;
    options.epsilon = bound;
    return options;
}

static toy noisy(const toy *sound, double blur)
{
    toy t = *sound;
    t.error = ERROR;
    t.time_scale = 1;
    t.blur = blur;
    return t;
}

/* Every jump of the toy is in the table at its double, and its right side is under the truth by a few errors at most. */
static void assert_exact_jumps(const toy *t, const toy_table *table)
{
    double from = 0;
    for (size_t i = 0; i + 1 < t->count; i++) {
        double place = t->pieces[i].until;
        long double after = toy_value_after(t, place);
        tdsp_jump jump;
        assert_int_equal(tdsp_table_next_jump(&table->table, from, &jump), TDSP_OK);
        assert_exact(jump.departure, place);
        assert_true(jump.before >= (double)toy_value(t, place));
        assert_true(jump.after <= after);
        assert_near(jump.after, (double)after, 16 * ERROR * ((double)after + 1));
        from = nextafter(place, INFINITY);
    }
    tdsp_jump none;
    assert_int_equal(tdsp_table_next_jump(&table->table, from, &none), TDSP_NO_ANSWER);
}

static void check_exact(const toy *t, double bound)
{
    toy sound = *t;
    tdsp_oracle oracle = toy_oracle(&sound, 0);
    tdsp_build_options options = with(TDSP_SAMPLING_ADAPTIVE, bound);
    toy_table table = toy_build(&oracle, &options);
    assert_exact_jumps(t, &table);
    toy_certify(t, &options, &table, 1000);
    toy_table_free(&table);
}

static void jumps_are_where_latest_departure_says_to_the_double(void **state)
{
    (void)state;
    static const char *const names[] = {"cliff", "staircase", "rising", "start_jump"};
    static const double blurs[] = {0, ERROR, 3 * ERROR};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        for (size_t j = 0; j < sizeof blurs / sizeof *blurs; j++) {
            toy t = noisy(&toy_named(names[i])->toy, blurs[j]);
            check_exact(&t, 0.001);
        }
}

static void a_jump_takes_three_forward_and_two_reverse_calls(void **state)
{
    (void)state;
    /* One jump in a flat function: beside it there are departure 0, the end, and the calls that narrow the bracket to the jump's size. */
    static const toy_piece pieces[] = {{1, 3, 0, 0}, {2, 9, 0, 0}};
    toy flat = toy_over(pieces, 2, 0);
    toy t = noisy(&flat, ERROR);
    tdsp_oracle oracle = toy_oracle(&t, 0);
    tdsp_build_options options = with(TDSP_SAMPLING_ADAPTIVE, 0.01);
    toy_table table = toy_build(&oracle, &options);
    assert_int_equal(table.report.rows, 3);
    assert_int_equal(table.report.reverse_calls, 1 + 2);
    assert_true(table.report.forward_calls <= 3 + 2 + 3);
    toy_table_free(&table);
}

static void stairs_take_eight_calls_a_step(void **state)
{
    (void)state;
    static const char *const names[] = {"staircase", "rising"};
    for (size_t i = 0; i < 2; i++) {
        toy t = noisy(&toy_named(names[i])->toy, ERROR);
        tdsp_oracle oracle = toy_oracle(&t, 0);
        tdsp_build_options options = with(TDSP_SAMPLING_ADAPTIVE, 0.01);
        toy_table table = toy_build(&oracle, &options);
        assert_true(table.report.forward_calls < 8 * table.report.rows);
        assert_true(table.report.reverse_calls < 11 * table.report.rows / 5);
        toy_table_free(&table);
    }
}

static void check_certified(const toy *t)
{
    static const double bounds[] = {1, 0.1, 0.01, 0.001};
    for (size_t i = 0; i < sizeof bounds / sizeof *bounds; i++)
        for (int mode = 0; mode < 4; mode++) {
            toy copy = *t;
            tdsp_oracle oracle = toy_oracle(&copy, mode & 1);
            tdsp_build_options options = with(mode & 2 ? TDSP_SAMPLING_GEOMETRIC : TDSP_SAMPLING_ADAPTIVE, bounds[i]);
            toy_table table = toy_build(&oracle, &options);
            toy_certify(t, &options, &table, 1000);
            toy_table_free(&table);
        }
}

static void two_jumps_nearer_than_the_first_step_after_them_are_told_apart(void **state)
{
    (void)state;
    static const double gaps[] = {6e-11, 1e-10, 3e-10, 1e-9, 1e-8};
    for (size_t i = 0; i < sizeof gaps / sizeof *gaps; i++) {
        const toy_piece pieces[] = {{2, 3, 0, 0}, {2 + gaps[i], 4, 0, 0}, {6, 5, 0.1, 0}};
        toy sound = toy_over(pieces, 3, 0);
        toy t = noisy(&sound, 0);
        check_exact(&t, 0.001);
        check_certified(&t);
    }
}

static void steep_growth_right_after_a_jump_is_certified(void **state)
{
    (void)state;
    static const double slopes[] = {1, 10, 1e3, 1e6, 1e9};
    for (size_t i = 0; i < sizeof slopes / sizeof *slopes; i++) {
        double run = fmin(1, 0.5 / slopes[i]);
        const toy_piece pieces[] = {{2, 3, 0.1, 0}, {2 + run, 4, slopes[i], 0}, {6, 6, 0.1, 0}};
        toy sound = toy_over(pieces, 3, 0);
        toy t = noisy(&sound, 0);
        check_certified(&t);
    }
}

static void a_jump_at_the_very_end_is_certified(void **state)
{
    (void)state;
    static const double rests[] = {0x1p-50, 1e-14, 1e-11, 1e-10, 1e-9, 1e-6};
    for (size_t i = 0; i < sizeof rests / sizeof *rests; i++) {
        const toy_piece pieces[] = {{2, 3, 0.1, 0}, {2 + rests[i], 5, 0, 0}};
        toy sound = toy_over(pieces, 2, 0);
        toy t = noisy(&sound, 0);
        check_certified(&t);
    }
}

/* Certified by the forward function, or found out. What rises right after a jump is not to be judged: only the truth tells it from a jump. */
static void check_lie(const toy *t, int sampling)
{
    toy liar = *t;
    tdsp_oracle oracle = toy_oracle(&liar, 0);
    tdsp_build_options options = with(sampling ? TDSP_SAMPLING_GEOMETRIC : TDSP_SAMPLING_ADAPTIVE, 0.01);
    toy_table table = {.bytes = NULL};
    tdsp_status status = tdsp_build(&oracle, &options, NULL, &table.bytes, &table.length, &table.report);
    if (status == TDSP_BAD_ORACLE) return;
    assert_int_equal(status, TDSP_OK);
    assert_int_equal(tdsp_table_open(&table.table, table.bytes, table.length), TDSP_OK);
    toy judge = *t;
    judge.blur = 2.5e-9;
    toy_certify(&judge, &options, &table, 1000);
    assert_true(liar.forward_calls < 200 * table.report.rows);
    toy_table_free(&table);
}

static void a_latest_departure_that_lies_does_no_harm(void **state)
{
    (void)state;
    static const char *const names[] = {"cliff", "rising", "bend", "steep"};
    static const double lies[] = {1e-7, 1e-6, 1e-3, 0.1, 5, -1e-7, -1e-6, -1e-3, -0.1, -5};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        for (size_t j = 0; j < sizeof lies / sizeof *lies; j++)
            for (uint64_t from = 2; from < 6; from++)
                for (int mode = 0; mode < 4; mode++) {
                    toy t = noisy(&toy_named(names[i])->toy, 0);
                    t.lie = lies[j];
                    t.lie_from = from;
                    t.lie_to = mode & 2 ? from + 1 : 0;
                    check_lie(&t, mode & 1);
                }
}

/* A toy that, in the noise behind its jump, takes a way longer than that of any later departure. */
typedef struct detour {
    toy sound; /* the first, for callbacks that know only it */
    double jump, noise, longer;
} detour;

static tdsp_status detour_arrival(void *ctx, double departure, double *arrival)
{
    detour *d = ctx;
    tdsp_status status = toy_oracle(&d->sound, 0).earliest_arrival(&d->sound, departure, arrival);
    if (status == TDSP_OK && departure > d->jump && departure <= d->jump + d->noise) *arrival += d->longer;
    return status;
}

static tdsp_status detour_build(toy_table *table)
{
    static const toy_piece pieces[] = {{1, 3, 0, 0}, {2, 9, 0, 0}};
    toy flat = toy_over(pieces, 2, 0);
    detour d = {noisy(&flat, 0), 1, 100 * ERROR, 5};
    tdsp_oracle oracle = toy_oracle(&d.sound, 0);
    oracle.earliest_arrival = detour_arrival;
    tdsp_build_options options = with(TDSP_SAMPLING_ADAPTIVE, 0.01);
    return tdsp_build(&oracle, &options, NULL, &table->bytes, &table->length, &table->report);
}

static void a_longer_way_right_behind_a_jump_costs_nothing(void **state)
{
    (void)state;
    toy_table table = {.bytes = NULL};
    assert_int_equal(detour_build(&table), TDSP_OK);
    assert_int_equal(tdsp_table_open(&table.table, table.bytes, table.length), TDSP_OK);
    tdsp_jump jump;
    assert_int_equal(tdsp_table_next_jump(&table.table, 0, &jump), TDSP_OK);
    assert_near(jump.departure, 1, 200 * ERROR);
    assert_near(jump.after, 9, 200 * ERROR);
    toy_table_free(&table);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(jumps_are_where_latest_departure_says_to_the_double),
        cmocka_unit_test(a_jump_takes_three_forward_and_two_reverse_calls),
        cmocka_unit_test(stairs_take_eight_calls_a_step),
        cmocka_unit_test(two_jumps_nearer_than_the_first_step_after_them_are_told_apart),
        cmocka_unit_test(steep_growth_right_after_a_jump_is_certified),
        cmocka_unit_test(a_jump_at_the_very_end_is_certified),
        cmocka_unit_test(a_latest_departure_that_lies_does_no_harm),
        cmocka_unit_test(a_longer_way_right_behind_a_jump_costs_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
