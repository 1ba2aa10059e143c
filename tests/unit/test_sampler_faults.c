/* SPDX-License-Identifier: MIT */
/* What goes wrong: arguments, oracles that break their word, cancelling, memory, the limit of rows. Nothing leaks, outputs stay. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <string.h>

#include <cmocka.h>

#include "support/assert.h"
#include "support/tight.h"
#include "support/toy_tables.h"

/* Build with a counting allocator. Unless TDSP_OK nothing is handed out; nothing is held in the end in any case. */
static tdsp_status outcome(const tdsp_oracle *oracle, const tdsp_build_options *options, tight_heap *heap)
{
    tight_heap own;
    memset(&own, 0, sizeof own);
    if (!heap) heap = &own;
    tdsp_allocator allocator = tight_allocator(heap);
    char untouched;
    void *bytes = &untouched;
    size_t length = 77;
    tdsp_build_report report = {.rows = 78};
    tdsp_status status = tdsp_build(oracle, options, &allocator, &bytes, &length, &report);
    if (status == TDSP_OK) {
        assert_int_equal(report.rows == 78, 0);
        assert_int_equal(heap->blocks, 1);
        assert_int_equal(heap->held, length);
        tdsp_bytes_free(&allocator, bytes, length);
    } else {
        assert_ptr_equal(bytes, &untouched);
        assert_int_equal(length, 77);
        assert_int_equal(report.rows, 78);
    }
    assert_int_equal(heap->blocks, 0);
    assert_int_equal(heap->held, 0);
    return status;
}

static tdsp_build_options defaults(void)
{
    tdsp_build_options options;
    tdsp_build_options_init(&options);
    return options;
}

static tdsp_build_options geometric(void)
{
    tdsp_build_options options = defaults();
    options.guarantee = TDSP_GUARANTEE_ARRIVAL;
    options.sampling = TDSP_SAMPLING_GEOMETRIC;
    return options;
}

static void defaults_are_those_documented(void **state)
{
    (void)state;
    tdsp_build_options options = defaults();
    assert_int_equal(options.size, sizeof options);
    assert_int_equal(options.guarantee, TDSP_GUARANTEE_TRAVEL);
    assert_int_equal(options.sampling, TDSP_SAMPLING_ADAPTIVE);
    assert_exact(options.epsilon, 0.01);
    assert_exact(options.horizon, INFINITY);
    assert_int_equal(options.max_rows, TDSP_MAX_ROWS);
    tdsp_oracle oracle;
    tdsp_oracle_init(&oracle);
    assert_int_equal(oracle.size, sizeof oracle);
    assert_int_equal(oracle.monotone, TDSP_MONOTONE_TRAVEL);
    assert_true(oracle.error == 0 && oracle.time_scale == 0);
    tdsp_build_options_init(NULL);
    tdsp_oracle_init(NULL);
}

static void bad_outputs_and_allocators_are_refused(void **state)
{
    (void)state;
    toy t = toy_named("linear")->toy;
    tdsp_oracle oracle = toy_oracle(&t, 0);
    tdsp_build_options options = defaults();
    void *bytes;
    size_t length;
    tdsp_allocator empty = {NULL, NULL};
    assert_int_equal(tdsp_build(NULL, &options, NULL, &bytes, &length, NULL), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_build(&oracle, NULL, NULL, &bytes, &length, NULL), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_build(&oracle, &options, NULL, NULL, &length, NULL), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_build(&oracle, &options, NULL, &bytes, NULL, NULL), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_build(&oracle, &options, &empty, &bytes, &length, NULL), TDSP_INVALID_ARGUMENT);
    assert_int_equal(t.forward_calls, 0);
}

#define REFUSED_ORACLE(change)                                                                                                   \
    do {                                                                                                                         \
        tdsp_oracle o = toy_oracle(&t, 0);                                                                                       \
        o.change;                                                                                                                \
        assert_int_equal(outcome(&o, &options, NULL), TDSP_INVALID_ARGUMENT);                                                    \
    } while (0)

static void bad_oracles_are_refused_before_they_are_asked(void **state)
{
    (void)state;
    toy t = toy_named("linear")->toy;
    tdsp_build_options options = defaults();
    REFUSED_ORACLE(size = 3);
    REFUSED_ORACLE(earliest_arrival = NULL);
    REFUSED_ORACLE(monotone = (tdsp_monotone)2);
    REFUSED_ORACLE(error = -1e-9);
    REFUSED_ORACLE(error = NAN);
    REFUSED_ORACLE(error = 0.2);
    REFUSED_ORACLE(time_scale = -1);
    REFUSED_ORACLE(time_scale = NAN);
    REFUSED_ORACLE(time_scale = INFINITY);
    assert_int_equal(t.forward_calls, 0);
}

#define REFUSED(change)                                                                                                          \
    do {                                                                                                                         \
        tdsp_build_options options = defaults();                                                                                 \
        options.change;                                                                                                          \
        assert_int_equal(outcome(&oracle, &options, NULL), TDSP_INVALID_ARGUMENT);                                               \
    } while (0)

static void bad_options_are_refused(void **state)
{
    (void)state;
    toy t = toy_named("linear")->toy;
    tdsp_oracle oracle = toy_oracle(&t, 0);
    REFUSED(size = 0);
    REFUSED(guarantee = (tdsp_guarantee)3);
    REFUSED(sampling = (tdsp_sampling)2);
    REFUSED(epsilon = 0.9e-9);
    REFUSED(epsilon = 1.0001);
    REFUSED(epsilon = NAN);
    REFUSED(oracle_share = -0.01);
    REFUSED(oracle_share = 0.91);
    REFUSED(oracle_share = NAN);
    REFUSED(guarantee = TDSP_GUARANTEE_ABSOLUTE); /* delta is 0 */
    REFUSED(horizon = -1);
    REFUSED(horizon = NAN);
    REFUSED(max_rows = 0);
    REFUSED(max_rows = TDSP_MAX_ROWS + 1);
    REFUSED(world.speed = -1);
    REFUSED(world.speed = NAN);
    REFUSED(world.speed = INFINITY);
    REFUSED(world.source.y = INFINITY);
    REFUSED(world.destination.x = NAN);
    REFUSED(world.source.x = INFINITY);
    REFUSED(world.destination.y = NAN);
    REFUSED(world.length_unit = "sixteen bytes ..");
    REFUSED(world.time_unit = "sixteen bytes ..");
    REFUSED(worker_count = 1);  /* and no workers */
    REFUSED(workers = &oracle); /* and no count */
    assert_int_equal(t.forward_calls, 0);
}

static void bad_deltas_are_refused(void **state)
{
    (void)state;
    toy t = toy_named("linear")->toy;
    tdsp_oracle oracle = toy_oracle(&t, 0);
    tdsp_build_options options = defaults();
    const double bad[] = {-1, 0, NAN, INFINITY};
    options.guarantee = TDSP_GUARANTEE_ABSOLUTE;
    for (size_t i = 0; i < 4; i++) {
        options.delta = bad[i];
        assert_int_equal(outcome(&oracle, &options, NULL), TDSP_INVALID_ARGUMENT);
    }
}

#define DIFFERS(change)                                                                                                          \
    do {                                                                                                                         \
        workers[1] = oracle;                                                                                                     \
        workers[1].change;                                                                                                       \
        assert_int_equal(outcome(&oracle, &options, NULL), TDSP_INVALID_ARGUMENT);                                               \
    } while (0)

static void workers_must_declare_what_the_oracle_declares(void **state)
{
    (void)state;
    toy t = toy_named("linear")->toy;
    t.rough = 1;
    tdsp_oracle oracle = toy_oracle(&t, 0);
    tdsp_oracle workers[2] = {oracle, oracle};
    tdsp_build_options options = geometric();
    options.workers = workers;
    options.worker_count = 2;
    assert_int_equal(outcome(&oracle, &options, NULL), TDSP_OK);
    DIFFERS(size = 3);
    DIFFERS(monotone = TDSP_MONOTONE_ARRIVAL);
    DIFFERS(error = 1e-9);
    DIFFERS(time_scale = 7);
    DIFFERS(latest_departure = NULL);
    DIFFERS(path = NULL);
    DIFFERS(earliest_arrival_within = NULL);
    DIFFERS(latest_departure_between = NULL);
}

static void what_an_oracle_cannot_promise_is_not_supported(void **state)
{
    (void)state;
    toy t = toy_named("city")->toy;
    tdsp_oracle oracle = toy_oracle(&t, 0);
    tdsp_build_options options = defaults();
    assert_int_equal(outcome(&oracle, &options, NULL), TDSP_NOT_SUPPORTED); /* travel, monotone in arrival */
    options = geometric();
    options.guarantee = TDSP_GUARANTEE_TRAVEL;
    toy line = toy_named("linear")->toy;
    tdsp_oracle sound = toy_oracle(&line, 0);
    assert_int_equal(outcome(&sound, &options, NULL), TDSP_NOT_SUPPORTED);
    options.guarantee = TDSP_GUARANTEE_ABSOLUTE;
    options.delta = 1;
    assert_int_equal(outcome(&sound, &options, NULL), TDSP_NOT_SUPPORTED);
    assert_int_equal(line.forward_calls + t.forward_calls, 0);
}

static void a_guarantee_finer_than_the_error_is_not_supported(void **state)
{
    (void)state;
    for (int sampling = 0; sampling < 2; sampling++)
        for (int forward_only = 0; forward_only < 2; forward_only++) {
            toy t = toy_named("linear")->toy;
            t.error = 1e-3;
            t.time_scale = 5;
            tdsp_oracle oracle = toy_oracle(&t, forward_only);
            tdsp_build_options options = sampling ? geometric() : defaults();
            options.epsilon = 1e-3;
            assert_int_equal(outcome(&oracle, &options, NULL), TDSP_NOT_SUPPORTED);
        }
}

/* A travel time that grows from an exact 0 has no finite table with a relative guarantee, and has one with an absolute one. */
static void a_travel_time_that_grows_from_zero_needs_the_absolute_guarantee(void **state)
{
    (void)state;
    static const toy_piece growing[] = {{5, 0, 0, 0}, {9, 0, 1, 0}};
    toy t = toy_over(growing, 2, 0);
    tdsp_oracle oracle = toy_oracle(&t, 0);
    tdsp_build_options options = defaults();
    assert_int_equal(outcome(&oracle, &options, NULL), TDSP_NOT_SUPPORTED);
    options.guarantee = TDSP_GUARANTEE_ABSOLUTE;
    options.delta = 0.1;
    assert_int_equal(outcome(&oracle, &options, NULL), TDSP_OK);
}

static void check_fault(toy_fault fault, uint64_t at, int sampling, int forward_only, tdsp_status expected)
{
    toy t = toy_named("bend")->toy;
    t.fault = fault;
    t.fault_at = at;
    tdsp_oracle oracle = toy_oracle(&t, forward_only);
    tdsp_build_options options = sampling ? geometric() : defaults();
    tdsp_status status = outcome(&oracle, &options, NULL);
    if (status != expected) fail_msg("fault %d at call %d: %s", (int)fault, (int)at, tdsp_status_name(status));
}

static void an_oracle_that_breaks_its_word_at_any_call_is_found_out(void **state)
{
    (void)state;
    static const toy_fault faults[] = {TOY_NAN, TOY_INFINITE, TOY_EARLY, TOY_NEGATIVE, TOY_ODD_ANSWER};
    for (size_t i = 0; i < sizeof faults / sizeof *faults; i++)
        for (uint64_t at = 1; at < 100; at += at < 12 ? 1 : 11)
            for (int mode = 0; mode < 4; mode++) check_fault(faults[i], at, mode & 1, mode >> 1, TDSP_BAD_ORACLE);
}

static void errors_of_the_oracle_are_handed_on(void **state)
{
    (void)state;
    for (uint64_t at = 1; at < 100; at += at < 12 ? 1 : 11)
        for (int mode = 0; mode < 4; mode++) check_fault(TOY_ERROR, at, mode & 1, mode >> 1, TDSP_FAILED);
    check_fault(TOY_REVERSE_ERROR, 1, 0, 0, TDSP_FAILED);
    for (uint64_t at = 1; at < 40; at++) {
        check_fault(TOY_REVERSE_ERROR, at, 1, 0, TDSP_FAILED);
        check_fault(TOY_REVERSE_NAN, at, 1, 0, TDSP_BAD_ORACLE);
        check_fault(TOY_REVERSE_ODD, at, 1, 0, TDSP_BAD_ORACLE);
        check_fault(TOY_PATH_ERROR, at, (int)(at & 1), (int)(at >> 1 & 1), TDSP_NO_ANSWER);
        check_fault(TOY_PATH_NULL, at, (int)(at & 1), (int)(at >> 1 & 1), TDSP_BAD_ORACLE);
    }
}

static tdsp_status outcome_of_rough_fault(toy_fault fault, uint64_t at)
{
    toy t = toy_named("staircase")->toy;
    t.rough = 1;
    t.fault = fault;
    t.fault_at = at;
    tdsp_oracle oracle = toy_oracle(&t, 0);
    tdsp_build_options options = defaults();
    return outcome(&oracle, &options, NULL);
}

static void bounds_that_cannot_be_are_found_out(void **state)
{
    (void)state;
    assert_int_equal(outcome_of_rough_fault(TOY_SOUND, 0), TDSP_OK);
    assert_int_equal(outcome_of_rough_fault(TOY_CROSSED, 1), TDSP_BAD_ORACLE);
    assert_int_equal(outcome_of_rough_fault(TOY_BEFORE_LOWER, 1), TDSP_BAD_ORACLE);
    int found = 0;
    for (uint64_t at = 1; at < 20; at++) found += outcome_of_rough_fault(TOY_NOT_BETWEEN, at) == TDSP_BAD_ORACLE;
    assert_true(found > 0);
}

static void travel_times_that_fall_are_found_out(void **state)
{
    (void)state;
    for (uint64_t at = 3; at < 40; at++)
        for (int forward_only = 0; forward_only < 2; forward_only++) check_fault(TOY_FALLS, at, 0, forward_only, TDSP_BAD_ORACLE);
}

static void the_limit_of_rows_is_kept_to_the_row(void **state)
{
    (void)state;
    for (int sampling = 0; sampling < 2; sampling++) {
        toy t = toy_named("bend")->toy;
        tdsp_oracle oracle = toy_oracle(&t, 0);
        tdsp_build_options options = sampling ? geometric() : defaults();
        toy_table table = toy_build(&oracle, &options);
        uint32_t rows = (uint32_t)table.report.rows;
        toy_table_free(&table);
        options.max_rows = rows;
        assert_int_equal(outcome(&oracle, &options, NULL), TDSP_OK);
        options.max_rows = rows - 1;
        assert_int_equal(outcome(&oracle, &options, NULL), TDSP_TOO_MANY_ROWS);
        options.max_rows = 1;
        assert_int_equal(outcome(&oracle, &options, NULL), TDSP_TOO_MANY_ROWS);
    }
}

typedef struct watch {
    uint64_t calls;
    uint64_t cancel_at;
    double settled;
    double all;
} watch;

static int progress(void *ctx, double settled, double all)
{
    watch *w = ctx;
    assert_true(settled >= w->settled && settled <= all);
    assert_true(isinf(w->all) || all == w->all);
    w->settled = settled;
    w->all = all;
    return ++w->calls == w->cancel_at;
}

static void building_can_be_cancelled_at_every_call_of_progress(void **state)
{
    (void)state;
    for (int mode = 0; mode < 4; mode++) {
        toy t = toy_named("bend")->toy;
        tdsp_oracle oracle = toy_oracle(&t, mode >> 1);
        tdsp_build_options options = mode & 1 ? geometric() : defaults();
        watch whole = {.all = INFINITY};
        options.progress = progress;
        options.progress_ctx = &whole;
        assert_int_equal(outcome(&oracle, &options, NULL), TDSP_OK);
        assert_true(whole.calls >= t.forward_calls + t.reverse_calls);
        assert_exact(whole.all, 10);
        for (uint64_t at = 1; at <= whole.calls; at++) {
            watch w = {.cancel_at = at, .all = INFINITY};
            options.progress_ctx = &w;
            assert_int_equal(outcome(&oracle, &options, NULL), TDSP_CANCELLED);
            assert_int_equal(w.calls, at);
        }
    }
}

static void every_allocation_may_fail(void **state)
{
    (void)state;
    for (int mode = 0; mode < 8; mode++) {
        toy t = toy_named("bend")->toy;
        t.legs = mode >> 2;
        tdsp_oracle oracle = toy_oracle(&t, mode >> 1 & 1);
        tdsp_build_options options = mode & 1 ? geometric() : defaults();
        tdsp_status status = TDSP_NO_MEMORY;
        size_t refuse = 0;
        while (status == TDSP_NO_MEMORY) {
            tight_heap heap = {.refuse = ++refuse};
            status = outcome(&oracle, &options, &heap);
            assert_true(status == TDSP_OK || heap.calls >= refuse);
        }
        assert_int_equal(status, TDSP_OK);
        assert_true(refuse > 5);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(defaults_are_those_documented),
        cmocka_unit_test(bad_outputs_and_allocators_are_refused),
        cmocka_unit_test(bad_oracles_are_refused_before_they_are_asked),
        cmocka_unit_test(bad_options_are_refused),
        cmocka_unit_test(bad_deltas_are_refused),
        cmocka_unit_test(workers_must_declare_what_the_oracle_declares),
        cmocka_unit_test(what_an_oracle_cannot_promise_is_not_supported),
        cmocka_unit_test(a_guarantee_finer_than_the_error_is_not_supported),
        cmocka_unit_test(a_travel_time_that_grows_from_zero_needs_the_absolute_guarantee),
        cmocka_unit_test(an_oracle_that_breaks_its_word_at_any_call_is_found_out),
        cmocka_unit_test(errors_of_the_oracle_are_handed_on),
        cmocka_unit_test(bounds_that_cannot_be_are_found_out),
        cmocka_unit_test(travel_times_that_fall_are_found_out),
        cmocka_unit_test(the_limit_of_rows_is_kept_to_the_row),
        cmocka_unit_test(building_can_be_cancelled_at_every_call_of_progress),
        cmocka_unit_test(every_allocation_may_fail),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
