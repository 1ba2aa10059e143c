/* SPDX-License-Identifier: MIT */
/* Where rows are placed: the guarantee, the number of rows, both sides of jumps, the calls that it takes. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <string.h>

#include <cmocka.h>

#include "support/assert.h"
#include "support/toy_tables.h"

#define SAMPLES 1000

static const double bounds[] = {1, 0.1, 0.01, 0.001};
#define BOUNDS (sizeof bounds / sizeof *bounds)

static tdsp_build_options with(tdsp_guarantee guarantee, tdsp_sampling sampling, double bound)
{
    tdsp_build_options options;
    tdsp_build_options_init(&options);
    options.guarantee = guarantee;
    options.sampling = sampling;
    options.epsilon = bound;
    options.delta = bound;
    return options;
}

/* The least number of rows that any table has, where jumps that are nearer to each other than the stated error count as one. */
static size_t least_rows(const toy *t, const tdsp_build_options *options)
{
    toy_piece pieces[128];
    toy resolved = *t;
    assert_true(t->count <= sizeof pieces / sizeof *pieces);
    resolved.pieces = pieces;
    resolved.count = 0;
    double from = 0;
    for (size_t i = 0; i < t->count; from = t->pieces[i++].until) {
        double travel = (double)(toy_arrival(t, t->pieces[i].until) - t->pieces[i].until);
        int seen = i == 0 || i + 1 == t->count || t->pieces[i].until - from > t->error * (travel + t->time_scale);
        if (seen) pieces[resolved.count++] = t->pieces[i];
    }
    return toy_least_rows(&resolved, options) - (t->error > 0 ? 1 : 0);
}

/*
 * Not fewer rows than greedy needs in closed form, and not more than greedy with a little less room: a thousandth of the increase is given
 * away on slopes, and what the noise takes.
 */
static void assert_few_rows(const toy_world *world, const toy *t, const tdsp_build_options *options, const toy_table *table)
{
    tdsp_build_options tighter = *options;
    double share = 1 - 0.002 - 100 * t->error / options->epsilon;
    tighter.epsilon *= share;
    tighter.delta *= share;
    size_t least = least_rows(t, options);
    size_t most = toy_least_rows(t, &tighter) + 1;
    if (table->report.rows >= least && table->report.rows <= most) return;
    print_error("%s: %zu rows, not %zu to %zu\n", world->name, (size_t)table->report.rows, least, most);
    fail();
}

static void check_adaptive(const toy_world *world, tdsp_guarantee guarantee, int forward_only, double error)
{
    for (size_t i = 0; i < BOUNDS; i++) {
        toy t = world->toy;
        double scale = (double)toy_value(&t, 0);
        t.error = error;
        t.time_scale = scale;
        t.blur = error * scale;
        /* An exact 0 is the one travel time that a relative error cannot be told from. */
        if (scale == 0 && error > 0) continue;
        tdsp_build_options options = with(guarantee, TDSP_SAMPLING_ADAPTIVE, bounds[i]);
        options.delta = bounds[i] * (scale > 0 ? scale : 1);
        tdsp_oracle oracle = toy_oracle(&t, forward_only);
        toy_table table = toy_build(&oracle, &options);
        toy_certify(&t, &options, &table, SAMPLES);
        assert_few_rows(world, &t, &options, &table);
        assert_int_equal(table.report.forward_calls, t.forward_calls);
        assert_int_equal(table.report.reverse_calls, t.reverse_calls);
        toy_table_free(&table);
    }
}

/* The guarantee holds although each answer is as far from the best as the oracle's share allows; rows are as few as for what is left of it. */
static void check_rough(const toy_world *world, tdsp_guarantee guarantee, double share)
{
    toy t = world->toy;
    double scale = (double)toy_value(&t, 0);
    if (scale == 0) return;
    t.error = 1e-11;
    t.time_scale = scale;
    t.blur = t.error * scale;
    t.rough = 1;
    tdsp_build_options options = with(guarantee, TDSP_SAMPLING_ADAPTIVE, 0.05);
    options.delta = 0.05 * scale;
    options.oracle_share = share;
    tdsp_oracle oracle = toy_oracle(&t, 0);
    toy_table table = toy_build(&oracle, &options);
    toy_certify(&t, &options, &table, SAMPLES);
    tdsp_build_options tighter = options;
    tighter.epsilon *= 0.98 * (share > 0 ? (1 - share) / 2 : 1); /* a row that ends in doubt uses half of its room */
    tighter.delta *= 0.98 * (share > 0 ? (1 - share) / 2 : 1);
    assert_in_range(table.report.rows, 0, toy_least_rows(&t, &tighter) + 1);
    assert_int_equal(table.report.rough_calls, t.rough_calls);
    assert_int_equal(table.report.oracle_delta > 0, share > 0);
    if (share == 0) assert_int_equal(t.rough_calls, 0);
    toy_table_free(&table);
}

static void answers_within_a_share_of_the_best_stay_inside_the_guarantee(void **state)
{
    (void)state;
    size_t count;
    const toy_world *worlds = toy_worlds(&count);
    for (size_t i = 0; i < count; i++)
        for (int share = 0; share <= 8; share += 4) {
            check_rough(&worlds[i], TDSP_GUARANTEE_TRAVEL, share / 10.0);
            check_rough(&worlds[i], TDSP_GUARANTEE_ABSOLUTE, share / 10.0);
        }
}

static void check_worlds(tdsp_guarantee guarantee, int forward_only, double error)
{
    size_t count;
    const toy_world *worlds = toy_worlds(&count);
    for (size_t i = 0; i < count; i++) check_adaptive(&worlds[i], guarantee, forward_only, error);
}

static void travel_rows_are_certified_and_few(void **state)
{
    (void)state;
    check_worlds(TDSP_GUARANTEE_TRAVEL, 0, 0);
    check_worlds(TDSP_GUARANTEE_TRAVEL, 1, 0);
}

static void arrival_rows_are_certified_and_few(void **state)
{
    (void)state;
    check_worlds(TDSP_GUARANTEE_ARRIVAL, 0, 0);
    check_worlds(TDSP_GUARANTEE_ARRIVAL, 1, 0);
}

static void absolute_rows_are_certified_and_few(void **state)
{
    (void)state;
    check_worlds(TDSP_GUARANTEE_ABSOLUTE, 0, 0);
    check_worlds(TDSP_GUARANTEE_ABSOLUTE, 1, 0);
}

static void noise_and_displaced_jumps_stay_inside_the_guarantee(void **state)
{
    (void)state;
    for (int forward_only = 0; forward_only < 2; forward_only++) {
        check_worlds(TDSP_GUARANTEE_TRAVEL, forward_only, 1e-11);
        check_worlds(TDSP_GUARANTEE_ARRIVAL, forward_only, 1e-9);
        check_worlds(TDSP_GUARANTEE_ABSOLUTE, forward_only, 1e-7);
    }
}

static void networks_that_are_monotone_in_arrival_are_certified_and_few(void **state)
{
    (void)state;
    size_t count;
    const toy_world *networks = toy_networks(&count);
    for (size_t i = 0; i < count; i++)
        for (int forward_only = 0; forward_only < 2; forward_only++) {
            check_adaptive(&networks[i], TDSP_GUARANTEE_ARRIVAL, forward_only, 0);
            check_adaptive(&networks[i], TDSP_GUARANTEE_ABSOLUTE, forward_only, 0);
            check_adaptive(&networks[i], TDSP_GUARANTEE_ARRIVAL, forward_only, 1e-11);
            check_adaptive(&networks[i], TDSP_GUARANTEE_ABSOLUTE, forward_only, 1e-11);
        }
}

static void check_geometric(const toy_world *world, int forward_only, double error)
{
    for (size_t i = 0; i < BOUNDS; i++) {
        toy t = world->toy;
        t.error = error;
        t.time_scale = (double)toy_value(&t, 0);
        t.blur = error * t.time_scale;
        tdsp_oracle oracle = toy_oracle(&t, forward_only);
        tdsp_build_options options = with(TDSP_GUARANTEE_ARRIVAL, TDSP_SAMPLING_GEOMETRIC, bounds[i]);
        if (toy_value(&t, 0) == 0) {
            void *bytes = NULL;
            size_t length = 0;
            assert_int_equal(tdsp_build(&oracle, &options, NULL, &bytes, &length, NULL), TDSP_NOT_SUPPORTED);
            continue;
        }
        toy_table geometric = toy_build(&oracle, &options);
        toy_certify(&t, &options, &geometric, SAMPLES);
        double steps = log((double)toy_arrival(&t, toy_last(&t)) / t.time_scale) / log1p(bounds[i]);
        assert_true((double)geometric.report.rows <= ceil(steps) + 2);
        options.sampling = TDSP_SAMPLING_ADAPTIVE;
        toy_table adaptive = toy_build(&oracle, &options);
        assert_true(adaptive.report.rows <= geometric.report.rows);
        toy_table_free(&adaptive);
        toy_table_free(&geometric);
    }
}

static void geometric_rows_are_certified_and_adaptive_never_needs_more(void **state)
{
    (void)state;
    size_t count;
    const toy_world *worlds = toy_worlds(&count);
    for (size_t i = 0; i < count; i++)
        for (int mode = 0; mode < 4; mode++) check_geometric(&worlds[i], mode & 1, mode & 2 ? 1e-11 : 0);
    worlds = toy_networks(&count);
    for (size_t i = 0; i < count; i++)
        for (int mode = 0; mode < 4; mode++) check_geometric(&worlds[i], mode & 1, mode & 2 ? 1e-11 : 0);
}

/* Every jump larger than the bound is in the table, in order, with both of its sides. */
static void check_jumps(const char *name, int forward_only, double error)
{
    toy t = toy_named(name)->toy;
    t.error = error;
    t.time_scale = error > 0 ? 1 : 0;
    t.blur = 3 * error;
    tdsp_oracle oracle = toy_oracle(&t, forward_only);
    tdsp_build_options options = with(TDSP_GUARANTEE_TRAVEL, TDSP_SAMPLING_ADAPTIVE, 0.001);
    toy_table table = toy_build(&oracle, &options);
    double from = 0;
    for (size_t i = 0; i + 1 < t.count; i++) {
        double place = t.pieces[i].until;
        tdsp_jump jump;
        tdsp_status status = tdsp_table_next_jump(&table.table, from, &jump);
        if (status != TDSP_OK) fail_msg("%s: no jump after %.17g, though there is one at %.17g", name, from, place);
        assert_near(jump.departure, place, 2 * t.blur + 1e-15 * place);
        assert_near(jump.before, (double)toy_value(&t, place), 1e-13 + 100 * error);
        from = nextafter(jump.departure, INFINITY);
        assert_near(jump.after, (double)toy_value(&t, fmax(from, nextafter(place, INFINITY))), 1e-13 + 100 * error);
    }
    tdsp_jump none;
    assert_int_equal(tdsp_table_next_jump(&table.table, from, &none), TDSP_NO_ANSWER);
    toy_table_free(&table);
}

static void both_sides_of_every_jump_are_kept(void **state)
{
    (void)state;
    static const char *const names[] = {"cliff", "steep", "staircase", "rising", "zero_jump", "start_jump"};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        for (int mode = 0; mode < 4; mode++) {
            if (mode & 2 && strcmp(names[i], "zero_jump") == 0) continue; /* an exact 0 has no noise */
            check_jumps(names[i], mode & 1, mode & 2 ? 1e-11 : 0);
        }
}

static void jumps_at_neighbouring_doubles_are_told_apart(void **state)
{
    (void)state;
    check_jumps("neighbours", 0, 0);
    check_jumps("neighbours", 1, 0);
    check_jumps("end_jump", 0, 0);
    check_jumps("end_jump", 1, 0);
}

static void a_flat_travel_time_needs_one_row_to_the_end(void **state)
{
    (void)state;
    static const char *const names[] = {"flat", "zero"};
    for (size_t i = 0; i < 2; i++) {
        toy t = toy_named(names[i])->toy;
        tdsp_oracle oracle = toy_oracle(&t, 0);
        tdsp_build_options options = with(TDSP_GUARANTEE_TRAVEL, TDSP_SAMPLING_ADAPTIVE, 1e-9);
        toy_table table = toy_build(&oracle, &options);
        assert_int_equal(table.report.rows, 2);
        assert_true(table.report.forward_calls <= 3);
        toy_table_free(&table);
    }
}

static void smooth_curves_take_less_than_two_calls_a_row(void **state)
{
    (void)state;
    static const char *const names[] = {"linear", "quadratic"};
    for (size_t i = 0; i < 2; i++) {
        toy t = toy_named(names[i])->toy;
        t.error = 1e-11;
        t.time_scale = 1;
        tdsp_oracle oracle = toy_oracle(&t, 0);
        tdsp_build_options options = with(TDSP_GUARANTEE_TRAVEL, TDSP_SAMPLING_ADAPTIVE, 0.01);
        toy_table table = toy_build(&oracle, &options);
        assert_true(table.report.forward_calls < 2 * table.report.rows);
        toy_table_free(&table);
    }
}

static void a_jump_takes_few_calls_where_the_oracle_can_be_asked_backwards(void **state)
{
    (void)state;
    toy t = toy_named("staircase")->toy;
    tdsp_oracle oracle = toy_oracle(&t, 0);
    tdsp_build_options options = with(TDSP_GUARANTEE_TRAVEL, TDSP_SAMPLING_ADAPTIVE, 0.01);
    toy_table table = toy_build(&oracle, &options);
    assert_true(table.report.forward_calls < 6 * table.report.rows);
    assert_true(table.report.forward_calls + table.report.reverse_calls < 7 * table.report.rows);
    toy_table_free(&table);
}

static void every_row_carries_the_path_of_its_departure(void **state)
{
    (void)state;
    static const char *const names[] = {"bend", "staircase", "neighbours", "start_jump", "instant"};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        for (int mode = 0; mode < 4; mode++) {
            toy t = toy_named(names[i])->toy;
            tdsp_oracle oracle = toy_oracle(&t, mode & 1);
            tdsp_sampling sampling = mode & 2 ? TDSP_SAMPLING_GEOMETRIC : TDSP_SAMPLING_ADAPTIVE;
            tdsp_build_options options = with(TDSP_GUARANTEE_ARRIVAL, sampling, 0.01);
            toy_table table = toy_build(&oracle, &options);
            for (uint64_t r = 0; r < table.table.rows; r++) {
                const void *bytes;
                size_t length;
                tdsp_row row;
                assert_int_equal(tdsp_table_row(&table.table, r, &row), TDSP_OK);
                assert_int_equal(tdsp_table_row_bytes(&table.table, r, &bytes, &length), TDSP_OK);
                assert_int_equal(length, sizeof row.departure);
                assert_memory_equal(bytes, &row.departure, length);
            }
            toy_table_free(&table);
        }
}

static void legs_are_stored_where_the_oracle_has_legs(void **state)
{
    (void)state;
    toy t = toy_named("bend")->toy;
    t.legs = 1;
    tdsp_oracle oracle = toy_oracle(&t, 0);
    tdsp_build_options options = with(TDSP_GUARANTEE_TRAVEL, TDSP_SAMPLING_ADAPTIVE, 0.01);
    toy_table table = toy_build(&oracle, &options);
    for (uint64_t r = 0; r < table.table.rows; r++) {
        tdsp_row row;
        tdsp_leg leg;
        assert_int_equal(tdsp_table_row(&table.table, r, &row), TDSP_OK);
        assert_int_equal(row.legs, 1);
        assert_int_equal(tdsp_table_row_leg(&table.table, r, 0, &leg), TDSP_OK);
        assert_exact(leg.start_time, row.departure);
        assert_true(leg.end_time <= row.departure + row.left);
    }
    toy_table_free(&table);
}

static void an_oracle_without_paths_makes_rows_without_paths(void **state)
{
    (void)state;
    toy t = toy_named("bend")->toy;
    tdsp_oracle oracle = toy_oracle(&t, 0);
    oracle.path = NULL;
    tdsp_build_options options = with(TDSP_GUARANTEE_TRAVEL, TDSP_SAMPLING_ADAPTIVE, 0.01);
    toy_table table = toy_build(&oracle, &options);
    toy_certify(&t, &options, &table, SAMPLES);
    tdsp_row row;
    assert_int_equal(tdsp_table_row(&table.table, 1, &row), TDSP_OK);
    assert_int_equal(row.legs, 0);
    toy_table_free(&table);
}

static void the_finest_bound_holds_above_the_noise(void **state)
{
    (void)state;
    static toy_piece short_bend[] = {{1e-7, 5, 0.5, 0}, {2e-7, 7, 2, 0}};
    toy t = toy_over(short_bend, 2, 0);
    t.error = 1e-11;
    t.time_scale = 1;
    for (int forward_only = 0; forward_only < 2; forward_only++) {
        tdsp_oracle oracle = toy_oracle(&t, forward_only);
        tdsp_build_options options = with(TDSP_GUARANTEE_TRAVEL, TDSP_SAMPLING_ADAPTIVE, 1e-9);
        toy_table table = toy_build(&oracle, &options);
        toy_certify(&t, &options, &table, SAMPLES);
        toy_table_free(&table);
    }
}

/* Where the oracle could be rough, too. */
static void arrival_rows_are_exact_and_never_more_than_geometric_ones(void **state)
{
    (void)state;
    size_t count;
    const toy_world *worlds = toy_worlds(&count);
    for (size_t i = 0; i < count; i++)
        for (size_t k = 1; k < BOUNDS; k++) {
            toy t = worlds[i].toy;
            if (toy_value(&t, 0) == 0) continue;
            t.error = 1e-11;
            t.time_scale = (double)toy_value(&t, 0);
            t.rough = 1;
            tdsp_oracle oracle = toy_oracle(&t, 0);
            tdsp_build_options adaptive = with(TDSP_GUARANTEE_ARRIVAL, TDSP_SAMPLING_ADAPTIVE, bounds[k]);
            tdsp_build_options geometric = with(TDSP_GUARANTEE_ARRIVAL, TDSP_SAMPLING_GEOMETRIC, bounds[k]);
            toy_table one = toy_build(&oracle, &adaptive), other = toy_build(&oracle, &geometric);
            if (one.report.rows > other.report.rows) print_error("%s at %g\n", worlds[i].name, bounds[k]);
            assert_in_range(one.report.rows, 0, other.report.rows);
            assert_int_equal(one.report.rough_calls + other.report.rough_calls, 0);
            toy_table_free(&one);
            toy_table_free(&other);
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(answers_within_a_share_of_the_best_stay_inside_the_guarantee),
        cmocka_unit_test(arrival_rows_are_exact_and_never_more_than_geometric_ones),
        cmocka_unit_test(travel_rows_are_certified_and_few),
        cmocka_unit_test(arrival_rows_are_certified_and_few),
        cmocka_unit_test(absolute_rows_are_certified_and_few),
        cmocka_unit_test(noise_and_displaced_jumps_stay_inside_the_guarantee),
        cmocka_unit_test(networks_that_are_monotone_in_arrival_are_certified_and_few),
        cmocka_unit_test(geometric_rows_are_certified_and_adaptive_never_needs_more),
        cmocka_unit_test(both_sides_of_every_jump_are_kept),
        cmocka_unit_test(jumps_at_neighbouring_doubles_are_told_apart),
        cmocka_unit_test(a_flat_travel_time_needs_one_row_to_the_end),
        cmocka_unit_test(smooth_curves_take_less_than_two_calls_a_row),
        cmocka_unit_test(a_jump_takes_few_calls_where_the_oracle_can_be_asked_backwards),
        cmocka_unit_test(every_row_carries_the_path_of_its_departure),
        cmocka_unit_test(legs_are_stored_where_the_oracle_has_legs),
        cmocka_unit_test(an_oracle_without_paths_makes_rows_without_paths),
        cmocka_unit_test(the_finest_bound_holds_above_the_noise),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
