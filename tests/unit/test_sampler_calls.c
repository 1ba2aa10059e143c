/* SPDX-License-Identifier: MIT */
/*
 * Building over an oracle that goes wrong at one call, whichever: each in turn of all that a table needs. What it says must be handed on, or
 * found out; where it is only useless, the forward function has the last word.
 */
#include <float.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <string.h>

#include <cmocka.h>

#include "support/assert.h"
#include "support/chance.h"
#include "support/toy_tables.h"

/* How the call goes wrong. Calls of functions that cannot go wrong so are sound. */
typedef enum wrong { FAILS, LATER, ENDLESS, TOO_EARLY } wrong;

typedef struct spoiled {
    tdsp_oracle sound;
    wrong how;
    uint64_t at; /* from 1; 0 for never */
    uint64_t calls;
    tdsp_status reason; /* what last_reason returns */
} spoiled;

static int is_due(spoiled *o)
{
    return ++o->calls == o->at;
}

static tdsp_status spoiled_arrival(void *ctx, double departure, double *arrival)
{
    spoiled *o = ctx;
    if (is_due(o) && o->how == FAILS) return TDSP_FAILED;
    return o->sound.earliest_arrival(o->sound.ctx, departure, arrival);
}

static tdsp_status spoiled_within(void *ctx, double departure, double delta, double *arrival, double *lower)
{
    spoiled *o = ctx;
    if (is_due(o) && o->how == FAILS) return TDSP_FAILED;
    return o->sound.earliest_arrival_within(o->sound.ctx, departure, delta, arrival, lower);
}

static tdsp_status spoiled_departure(void *ctx, double arrival, double *departure)
{
    spoiled *o = ctx;
    int due = is_due(o);
    if (due && o->how == FAILS) return TDSP_FAILED;
    if (due && o->how == TOO_EARLY) return TDSP_ARRIVAL_TOO_EARLY;
    tdsp_status status = o->sound.latest_departure(o->sound.ctx, arrival, departure);
    if (due && o->how == ENDLESS) *departure = INFINITY;
    return status;
}

static tdsp_status spoiled_between(void *ctx, double arrival, double after, double before, double *departure, double *arrives)
{
    spoiled *o = ctx;
    int due = is_due(o);
    if (due && o->how == FAILS) return TDSP_FAILED;
    tdsp_status status = o->sound.latest_departure_between(o->sound.ctx, arrival, after, before, departure, arrives);
    if (due && o->how == LATER && isfinite(before)) *departure = nextafter(before, INFINITY);
    return status;
}

static tdsp_status spoiled_path(void *ctx, tdsp_oracle_path *out)
{
    spoiled *o = ctx;
    if (is_due(o) && o->how == FAILS) return TDSP_FAILED;
    return o->sound.path(o->sound.ctx, out);
}

static tdsp_status spoiled_reason(void *ctx, double departure, tdsp_status *reason)
{
    spoiled *o = ctx;
    (void)departure;
    *reason = TDSP_CUT_OFF;
    return is_due(o) && o->how == FAILS ? TDSP_FAILED : o->reason;
}

static tdsp_status spoiled_gap(void *ctx, double departure, double before, double after, tdsp_gap *out)
{
    spoiled *o = ctx;
    (void)before;
    (void)after;
    *out = (tdsp_gap){1, 2, departure, {0, 0}};
    return is_due(o) && o->how == FAILS ? TDSP_FAILED : TDSP_OK;
}

static tdsp_oracle spoiled_oracle(spoiled *o)
{
    tdsp_oracle out = o->sound;
    out.ctx = o;
    out.earliest_arrival = spoiled_arrival;
    out.path = spoiled_path;
    out.last_reason = spoiled_reason;
    out.jump_gap = spoiled_gap;
    if (out.latest_departure) out.latest_departure = spoiled_departure;
    if (out.earliest_arrival_within) out.earliest_arrival_within = spoiled_within;
    if (out.latest_departure_between) out.latest_departure_between = spoiled_between;
    return out;
}

/* A build; nothing may be handed out unless it is done, and then it is certified. */
static tdsp_status build(const toy *truth, spoiled *o, const tdsp_build_options *options)
{
    const tdsp_oracle oracle = spoiled_oracle(o);
    toy_table t = {.length = 77};
    tdsp_status status = tdsp_build(&oracle, options, NULL, &t.bytes, &t.length, &t.report);
    if (status != TDSP_OK) {
        assert_null(t.bytes);
        assert_int_equal(t.length, 77);
        return status;
    }
    assert_int_equal(tdsp_table_open(&t.table, t.bytes, t.length), TDSP_OK);
    toy_certify(truth, options, &t, 100);
    toy_table_free(&t);
    return TDSP_OK;
}

static spoiled spoil(toy *t, int forward_only, wrong how, uint64_t at)
{
    return (spoiled){.sound = toy_oracle(t, forward_only), .how = how, .at = at, .reason = TDSP_OK};
}

typedef struct world {
    const char *name;
    int forward_only, rough, geometric;
    double epsilon, horizon, error;
} world;

static const world worlds[] = {
    {"bend", 0, 0, 0, 0.01, INFINITY, 0},   {"bend", 1, 0, 0, 0.01, INFINITY, 0},  {"bend", 0, 1, 0, 0.01, INFINITY, 0},
    {"bend", 0, 0, 1, 0.01, INFINITY, 0},   {"bend", 0, 0, 0, 0.01, 7, 0},         {"bend", 0, 0, 0, 0.01, 12, 0},
    {"bend", 0, 1, 1, 0.01, 7, 0},          {"cliff", 0, 0, 0, 0.01, INFINITY, 0}, {"cliff", 1, 1, 0, 0.01, INFINITY, 0},
    {"cliff", 0, 1, 0, 0.01, INFINITY, 0},  {"cliff", 0, 0, 1, 0.01, INFINITY, 0}, {"steep", 0, 0, 0, 0.02, INFINITY, 0},
    {"steep", 0, 1, 0, 0.02, INFINITY, 0},  {"rising", 0, 0, 0, 0.05, INFINITY, 0}, {"rising", 0, 1, 0, 0.05, INFINITY, 0},
    {"rising", 0, 0, 1, 0.05, INFINITY, 0}, {"city", 0, 0, 1, 0.02, INFINITY, 0},  {"shuttle", 0, 0, 1, 0.05, INFINITY, 0},
    {"cliff", 0, 0, 0, 0.05, INFINITY, 1e-5}, {"rising", 0, 0, 0, 0.05, INFINITY, 1e-6}, {"end_jump", 0, 0, 0, 0.05, INFINITY, 0},
};

static tdsp_build_options options_of(const world *w)
{
    tdsp_build_options options;
    tdsp_build_options_init(&options);
    options.epsilon = w->epsilon;
    options.horizon = w->horizon;
    if (w->geometric) options.guarantee = TDSP_GUARANTEE_ARRIVAL, options.sampling = TDSP_SAMPLING_GEOMETRIC;
    return options;
}

static toy toy_of(const world *w)
{
    toy t = toy_named(w->name)->toy;
    t.rough = w->rough;
    t.error = w->error;
    t.time_scale = w->error > 0 ? 1 : 0;
    return t;
}

static void an_error_at_any_call_of_any_function_is_handed_on(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof worlds / sizeof *worlds; i++) {
        const tdsp_build_options options = options_of(&worlds[i]);
        for (uint64_t at = 1;; at += 1 + at / 400) {
            toy t = toy_of(&worlds[i]);
            spoiled o = spoil(&t, worlds[i].forward_only, FAILS, at);
            tdsp_status status = build(&t, &o, &options);
            if (o.calls < at) {
                assert_int_equal(status, TDSP_OK);
                assert_true(at > 5);
                break;
            }
            if (status != TDSP_FAILED) fail_msg("world %zu, call %d: %s", i, (int)at, tdsp_status_name(status));
        }
    }
}

/* Which of the calls are made by the function that goes wrong is not known beforehand: the others are sound. */
static unsigned statuses_when(wrong how, const world *w, tdsp_status allowed)
{
    unsigned met = 0;
    for (uint64_t at = 1; at < 200; at++) {
        toy t = toy_of(w);
        spoiled o = spoil(&t, w->forward_only, how, at);
        const tdsp_build_options options = options_of(w);
        tdsp_status status = build(&t, &o, &options);
        if (status != TDSP_OK && status != allowed) fail_msg("%s, call %d: %s", w->name, (int)at, tdsp_status_name(status));
        met += status != TDSP_OK;
    }
    return met;
}

static void a_latest_departure_that_never_ends_for_an_arrival_that_does_is_found_out(void **state)
{
    (void)state;
    unsigned met = 0;
    for (size_t i = 0; i < sizeof worlds / sizeof *worlds; i++) {
        world finite = worlds[i];
        finite.horizon = fmin(finite.horizon, 3); /* the last departure of all is not asked for */
        if (!finite.forward_only) met += statuses_when(ENDLESS, &finite, TDSP_BAD_ORACLE);
    }
    assert_true(met > 10);
}

static void a_latest_departure_after_the_one_known_to_be_too_late_is_found_out(void **state)
{
    (void)state;
    unsigned met = 0;
    for (size_t i = 0; i < sizeof worlds / sizeof *worlds; i++)
        if (worlds[i].rough && !worlds[i].forward_only) met += statuses_when(LATER, &worlds[i], TDSP_BAD_ORACLE);
    assert_true(met > 5);
}

static void an_arrival_said_to_be_too_early_costs_calls_and_no_correctness(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof worlds / sizeof *worlds; i++)
        if (!worlds[i].forward_only && !worlds[i].rough) assert_int_equal(statuses_when(TOO_EARLY, &worlds[i], TDSP_OK), 0);
}

static void a_reason_that_is_returned_and_not_handed_out_is_found_out(void **state)
{
    (void)state;
    toy t = toy_named("bend")->toy;
    tdsp_build_options options;
    tdsp_build_options_init(&options);
    spoiled o = spoil(&t, 0, FAILS, 0);
    o.reason = TDSP_CUT_OFF;
    assert_int_equal(build(&t, &o, &options), TDSP_BAD_ORACLE);
}

/* ----------------------------------------------------------------------------------------------- what it says of the last departure */

/* The travel time `travel` up to `last`; latest_departure(infinity) is `said`. */
typedef struct lasting {
    double last, said, travel;
} lasting;

static tdsp_status lasting_arrival(void *ctx, double departure, double *arrival)
{
    const lasting *l = ctx;
    *arrival = departure + l->travel;
    return departure <= l->last ? TDSP_OK : TDSP_CUT_OFF;
}

static tdsp_status lasting_departure(void *ctx, double arrival, double *departure)
{
    const lasting *l = ctx;
    *departure = isinf(arrival) ? l->said : fmin(arrival - l->travel, l->last);
    return arrival >= l->travel ? TDSP_OK : TDSP_ARRIVAL_TOO_EARLY;
}

static tdsp_status build_lasting(lasting l, double horizon, tdsp_build_report *report)
{
    tdsp_oracle oracle;
    tdsp_build_options options;
    void *bytes;
    size_t length;
    tdsp_oracle_init(&oracle);
    oracle.ctx = &l;
    oracle.earliest_arrival = lasting_arrival;
    oracle.latest_departure = lasting_departure;
    tdsp_build_options_init(&options);
    options.guarantee = TDSP_GUARANTEE_ABSOLUTE;
    options.delta = 1;
    options.horizon = horizon;
    tdsp_status status = tdsp_build(&oracle, &options, NULL, &bytes, &length, report);
    if (status == TDSP_OK) tdsp_bytes_free(NULL, bytes, length);
    return status;
}

static void the_forward_function_has_the_last_word_on_the_last_departure(void **state)
{
    (void)state;
    tdsp_build_report report;
    assert_int_equal(build_lasting((lasting){10, 15, 3}, 12, &report), TDSP_OK);
    assert_exact(report.last_departure, 10);
    assert_int_equal(report.last_reason, TDSP_CUT_OFF);
    assert_int_equal(build_lasting((lasting){10, 15, 3}, INFINITY, &report), TDSP_OK);
    assert_exact(report.last_departure, 10);
}

static void a_last_departure_right_before_the_horizon_is_the_end(void **state)
{
    (void)state;
    tdsp_build_report report;
    assert_int_equal(build_lasting((lasting){10, 10, 3}, nextafter(10, 11), &report), TDSP_OK);
    assert_exact(report.last_departure, 10);
    assert_int_equal(report.last_reason, TDSP_CUT_OFF);
}

static void departures_that_end_and_are_said_not_to_are_found_out(void **state)
{
    (void)state;
    tdsp_build_report report;
    assert_int_equal(build_lasting((lasting){10, INFINITY, 3}, 12, &report), TDSP_BAD_ORACLE);
    assert_int_equal(build_lasting((lasting){INFINITY, INFINITY, 3}, INFINITY, &report), TDSP_NEEDS_HORIZON);
}

static void departures_that_are_said_to_end_at_2_to_the_501_and_do_not_are_found_out(void **state)
{
    (void)state;
    tdsp_build_report report;
    assert_int_equal(build_lasting((lasting){INFINITY, 0x1p501, 3}, INFINITY, &report), TDSP_BAD_ORACLE); /* where 3 is lost in the rounding */
    assert_int_equal(build_lasting((lasting){INFINITY, 0x1p501, 0}, INFINITY, &report), TDSP_BAD_ORACLE);
}

static void the_largest_double_is_a_horizon(void **state)
{
    (void)state;
    tdsp_build_report report;
    assert_int_equal(build_lasting((lasting){INFINITY, INFINITY, 0}, DBL_MAX, &report), TDSP_OK);
    assert_exact(report.last_departure, DBL_MAX);
    assert_int_equal(report.last_reason, TDSP_HORIZON);
}

/* ------------------------------------------------------------------------------------------------------- travel times that are none */

/* 3 up to 5, 5 up to 5.1, then 9; but `hump` from `from` to `to`. */
typedef struct humped {
    double from, to, hump, error;
} humped;

static tdsp_status humped_arrival(void *ctx, double departure, double *arrival)
{
    const humped *h = ctx;
    double travel = departure <= 5 ? 3 : departure <= 5.1 ? 5 : 9;
    if (departure > h->from && departure <= h->to) travel = h->hump;
    *arrival = departure + travel;
    return departure <= 10 ? TDSP_OK : TDSP_CUT_OFF;
}

static tdsp_status build_humped(humped h, double horizon)
{
    tdsp_oracle oracle;
    tdsp_build_options options;
    toy_table t;
    tdsp_oracle_init(&oracle);
    oracle.ctx = &h;
    oracle.error = h.error;
    oracle.earliest_arrival = humped_arrival;
    tdsp_build_options_init(&options);
    options.horizon = horizon;
    options.epsilon = 0.1;
    tdsp_status status = tdsp_build(&oracle, &options, NULL, &t.bytes, &t.length, &t.report);
    if (status != TDSP_OK) return status;
    double lower, upper;
    assert_int_equal(tdsp_table_open(&t.table, t.bytes, t.length), TDSP_OK);
    assert_int_equal(tdsp_table_arrival(&t.table, 4, &lower, &upper), TDSP_OK);
    assert_true(lower <= 7 && upper >= 7 && upper <= 7.31);
    assert_int_equal(tdsp_table_arrival(&t.table, 6, &lower, &upper), TDSP_OK);
    if (!(lower <= 15 && upper >= 15 && upper <= 15.91)) fail_msg("hump from %g to %g: at 6 [%.17g, %.17g]", h.from, h.to, lower, upper);
    toy_table_free(&t);
    return TDSP_OK;
}

static void travel_times_that_fall_between_departures_far_apart_are_found_out(void **state)
{
    (void)state;
    assert_int_equal(build_humped((humped){2, 3, 20, 0}, 10), TDSP_OK);        /* nobody asks there */
    assert_int_equal(build_humped((humped){4.9, 5.05, 20, 0}, 10), TDSP_BAD_ORACLE); /* the middle is asked first */
    assert_int_equal(build_humped((humped){4, 6, 2, 0}, 5), TDSP_BAD_ORACLE); /* at the horizon, less than at 0 */
}

/* The oracle may mistake the side of a jump that is nearer than ten times its error: 5.1 - 5.02 < 10 * 0.001 * (5.1 + 9). */
static void the_wrong_side_of_a_jump_within_the_stated_error_is_no_fault(void **state)
{
    (void)state;
    for (int i = 0; i < 40; i++)
        for (int k = 1; k < 8; k++) {
            double from = 5.02 + 0.002 * i;
            assert_int_equal(build_humped((humped){from, from + 0.01 * k, 9, 1e-3}, 10), TDSP_OK);
        }
}

/* -------------------------------------------------------------------------------------------------------------------------- many jumps */

enum { STAIRS = 150 };

/* Low and high steps in no order: no stretch of them looks straight. */
static toy stairs_of(toy_piece *pieces, double length)
{
    uint64_t chance = 5;
    double value = 3;
    for (int i = 0; i < STAIRS; i++, value *= chance_below(&chance, 2) ? 1.02 : 1.25) pieces[i] = (toy_piece){length * (i + 1), value, 0, 0};
    return toy_over(pieces, STAIRS, 0);
}

static void more_jumps_than_the_survey_keeps_and_jumps_far_apart_are_sampled_none_the_less(void **state)
{
    (void)state;
    toy_piece pieces[STAIRS];
    for (int far = 0; far < 2; far++) {
        toy truth = stairs_of(pieces, far ? 1e6 : 0.5);
        spoiled o = spoil(&truth, 0, FAILS, 0);
        tdsp_build_options options;
        tdsp_build_options_init(&options);
        assert_int_equal(build(&truth, &o, &options), TDSP_OK);
    }
}

/* Its targets are 20 margins apart at least: at an arrival of 5, (5 + 5) 1e-4 each. */
static void geometric_targets_that_drown_in_the_stated_error_are_not_supported(void **state)
{
    (void)state;
    world coarse = {"linear", 0, 0, 1, 0.0025, INFINITY, 0};
    toy t = toy_named("linear")->toy;
    t.error = 1e-4;
    t.time_scale = 5;
    spoiled o = spoil(&t, 0, FAILS, 0);
    tdsp_build_options options = options_of(&coarse);
    assert_int_equal(build(&t, &o, &options), TDSP_NOT_SUPPORTED);
    options.epsilon = 0.01;
    assert_int_equal(build(&t, &o, &options), TDSP_OK);
}

/* ---------------------------------------------------------------------------------------------------------------------------- workers */

static void run_as_nobody(void *ctx, tdsp_task task, void *task_ctx, size_t count)
{
    (void)ctx;
    for (size_t i = 0; i < count; i++) task(task_ctx, i, 99);
}

static void run_in_order(void *ctx, tdsp_task task, void *task_ctx, size_t count)
{
    ++*(int *)ctx;
    for (size_t i = 0; i < count; i++) task(task_ctx, i, 0);
}

static void a_worker_that_is_none_is_refused_also_where_there_is_one_row(void **state)
{
    (void)state;
    toy t = toy_named("flat")->toy;
    const tdsp_oracle oracle = toy_oracle(&t, 0);
    tdsp_build_options options;
    void *bytes;
    size_t length;
    tdsp_build_options_init(&options);
    options.workers = &oracle;
    options.worker_count = 1;
    options.run_tasks = run_as_nobody;
    assert_int_equal(tdsp_build(&oracle, &options, NULL, &bytes, &length, NULL), TDSP_INVALID_ARGUMENT);
}

static void tasks_without_workers_are_the_oracle_s_own(void **state)
{
    (void)state;
    int runs = 0;
    toy t = toy_named("bend")->toy;
    const tdsp_oracle oracle = toy_oracle(&t, 0);
    tdsp_build_options options;
    tdsp_build_options_init(&options);
    options.run_tasks = run_in_order;
    options.run_tasks_ctx = &runs;
    toy_table table = toy_build(&oracle, &options);
    toy_certify(&t, &options, &table, 100);
    toy_table_free(&table);
    assert_int_equal(runs, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(an_error_at_any_call_of_any_function_is_handed_on),
        cmocka_unit_test(a_latest_departure_that_never_ends_for_an_arrival_that_does_is_found_out),
        cmocka_unit_test(a_latest_departure_after_the_one_known_to_be_too_late_is_found_out),
        cmocka_unit_test(an_arrival_said_to_be_too_early_costs_calls_and_no_correctness),
        cmocka_unit_test(a_reason_that_is_returned_and_not_handed_out_is_found_out),
        cmocka_unit_test(the_forward_function_has_the_last_word_on_the_last_departure),
        cmocka_unit_test(a_last_departure_right_before_the_horizon_is_the_end),
        cmocka_unit_test(departures_that_end_and_are_said_not_to_are_found_out),
        cmocka_unit_test(departures_that_are_said_to_end_at_2_to_the_501_and_do_not_are_found_out),
        cmocka_unit_test(the_largest_double_is_a_horizon),
        cmocka_unit_test(travel_times_that_fall_between_departures_far_apart_are_found_out),
        cmocka_unit_test(the_wrong_side_of_a_jump_within_the_stated_error_is_no_fault),
        cmocka_unit_test(more_jumps_than_the_survey_keeps_and_jumps_far_apart_are_sampled_none_the_less),
        cmocka_unit_test(geometric_targets_that_drown_in_the_stated_error_are_not_supported),
        cmocka_unit_test(a_worker_that_is_none_is_refused_also_where_there_is_one_row),
        cmocka_unit_test(tasks_without_workers_are_the_oracle_s_own),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
