/* SPDX-License-Identifier: MIT */
/* The verifier of tables: accepts what was built, and finds a number changed under right checksums. */
#include "support/cmocka_all.h"

#include <stdlib.h>
#include <string.h>

#include "base/bytes.h"
#include "support/golden.h"
#include "support/toy_tables.h"
#include "tdsp/build.h"
#include "tdsp/scene.h"
#include "tdsp/solver.h"
#include "tdsp/verify.h"

static const tdsp_journey journey = {1.0, 0.0, {-10.0, 0.0}, {10.0, 0.0}};
static const tdsp_disc discs[2] = {{{0.0, 3.0}, 1.0, 0.1}, {{0.0, -3.0}, 1.0, 0.1}};

typedef struct fixture {
    tdsp_scene *scene;
    unsigned char *bytes;
    size_t length;
    tdsp_table table;
} fixture;

static void build(fixture *f, tdsp_guarantee guarantee, tdsp_sampling sampling)
{
    tdsp_solver *solver;
    tdsp_oracle oracle;
    tdsp_build_options options;
    void *bytes;
    assert_int_equal(tdsp_scene_create(&journey, discs, 2, NULL, &f->scene), TDSP_OK);
    assert_int_equal(tdsp_solver_create(f->scene, &solver), TDSP_OK);
    assert_int_equal(tdsp_solver_oracle(solver, &oracle), TDSP_OK);
    tdsp_build_options_init(&options);
    options.guarantee = guarantee;
    options.sampling = sampling;
    options.epsilon = 0.01;
    options.delta = 0.3;
    options.world.scene_hash = tdsp_scene_hash(f->scene);
    options.world.speed = journey.speed;
    options.world.source = journey.source;
    options.world.destination = journey.destination;
    assert_int_equal(tdsp_build(&oracle, &options, NULL, &bytes, &f->length, NULL), TDSP_OK);
    f->bytes = bytes;
    assert_int_equal(tdsp_table_open(&f->table, f->bytes, f->length), TDSP_OK);
    tdsp_solver_free(solver);
}

static void discard(fixture *f)
{
    tdsp_bytes_free(NULL, f->bytes, f->length);
    tdsp_scene_free(f->scene);
}

static tdsp_table_verdict verdict_of(const fixture *f)
{
    tdsp_table_verdict verdict;
    assert_int_equal(tdsp_verify_table(f->scene, &f->table, &verdict), TDSP_OK);
    return verdict;
}

/* Change a double of a section, put the checksums right, and open again. */
static void spoil(fixture *f, uint64_t section, uint64_t item, double factor)
{
    unsigned char *at = f->bytes + section + 8 * item;
    bytes_put_f64(at, factor * bytes_get_f64(at));
    golden_seal(f->bytes, f->length);
    assert_int_equal(tdsp_table_open(&f->table, f->bytes, f->length), TDSP_OK);
}

static void a_built_table_is_accepted_under_every_guarantee(void **state)
{
    (void)state;
    for (int guarantee = 0; guarantee < 4; guarantee++) {
        fixture f;
        if (guarantee == 3)
            build(&f, TDSP_GUARANTEE_ARRIVAL, TDSP_SAMPLING_GEOMETRIC);
        else
            build(&f, (tdsp_guarantee)guarantee, TDSP_SAMPLING_ADAPTIVE);
        const tdsp_table_verdict verdict = verdict_of(&f);
        assert_true(verdict.ok);
        assert_false(verdict.stale);
        assert_true(verdict.first_bad_row == UINT64_MAX);
        assert_int_equal(verdict.worst.problems, 0);
        assert_true(verdict.worst.min_clearance >= -verdict.worst.tolerance);
        discard(&f);
    }
}

static void a_table_of_another_scene_is_stale(void **state)
{
    (void)state;
    fixture f;
    build(&f, TDSP_GUARANTEE_TRAVEL, TDSP_SAMPLING_ADAPTIVE);
    tdsp_scene_free(f.scene);
    tdsp_disc smaller[2] = {discs[0], discs[1]};
    smaller[1].radius *= 0.5;
    assert_int_equal(tdsp_scene_create(&journey, smaller, 2, NULL, &f.scene), TDSP_OK);
    const tdsp_table_verdict verdict = verdict_of(&f);
    assert_false(verdict.ok);
    assert_true(verdict.stale);
    assert_int_equal(verdict.bad_order + verdict.bad_ratio, 0);
    discard(&f);
}

static void larger_discs_make_rows_fail_by_their_paths(void **state)
{
    (void)state;
    fixture f;
    build(&f, TDSP_GUARANTEE_TRAVEL, TDSP_SAMPLING_ADAPTIVE);
    tdsp_scene_free(f.scene);
    tdsp_disc larger[2] = {discs[0], discs[1]};
    larger[0].radius += 1e-3;
    assert_int_equal(tdsp_scene_create(&journey, larger, 2, NULL, &f.scene), TDSP_OK);
    const tdsp_table_verdict verdict = verdict_of(&f);
    assert_true(verdict.bad_paths > 0);
    assert_int_equal(verdict.worst.problems & TDSP_PROBLEM_CLEARANCE, TDSP_PROBLEM_CLEARANCE);
    assert_true(verdict.worst.min_clearance < -1e-4);
    discard(&f);
}

static void an_upper_end_that_is_too_high_breaks_the_guarantee(void **state)
{
    (void)state;
    fixture f;
    build(&f, TDSP_GUARANTEE_TRAVEL, TDSP_SAMPLING_ADAPTIVE);
    const uint64_t last = f.table.rows - 1;
    spoil(&f, f.table.left, last, 1.02);
    const tdsp_table_verdict verdict = verdict_of(&f);
    assert_false(verdict.ok);
    assert_int_equal(verdict.bad_ratio, 1);
    assert_int_equal(verdict.bad_paths, 0);
    assert_true(verdict.first_bad_row == last);
    discard(&f);
}

static void a_path_that_ends_beside_the_destination_is_a_bad_path(void **state)
{
    (void)state;
    fixture f;
    build(&f, TDSP_GUARANTEE_TRAVEL, TDSP_SAMPLING_ADAPTIVE);
    tdsp_scene_free(f.scene);
    tdsp_journey farther = journey;
    farther.destination.x += 1e-6;
    assert_int_equal(tdsp_scene_create(&farther, discs, 2, NULL, &f.scene), TDSP_OK);
    const tdsp_table_verdict verdict = verdict_of(&f);
    assert_int_equal(verdict.bad_paths, f.table.rows);
    assert_true(verdict.first_bad_row == 0);
    assert_int_equal(verdict.worst.problems, TDSP_PROBLEM_END);
    discard(&f);
}

/* A road network's rows bring a path of their own kind: nothing that the verifier could hold against discs. */
static void a_table_that_is_monotone_in_arrival_is_held_in_order_by_its_arrivals(void **state)
{
    (void)state;
    toy t = toy_named("city")->toy;
    const tdsp_oracle oracle = toy_oracle(&t, 0);
    tdsp_build_options options;
    fixture f;
    tdsp_build_options_init(&options);
    options.guarantee = TDSP_GUARANTEE_ARRIVAL;
    toy_table table = toy_build(&oracle, &options);
    assert_int_equal(tdsp_scene_create(&journey, discs, 2, NULL, &f.scene), TDSP_OK);
    f.table = table.table;
    const tdsp_table_verdict verdict = verdict_of(&f);
    assert_int_equal(verdict.bad_order + verdict.bad_ratio, 0);
    assert_int_equal(verdict.bad_paths, table.report.rows);
    tdsp_scene_free(f.scene);
    toy_table_free(&table);
}

static void a_table_that_was_never_opened_and_ends_that_are_no_places_are_refused(void **state)
{
    (void)state;
    fixture f;
    tdsp_table never;
    tdsp_table_verdict verdict;
    const tdsp_ends nowhere = {{0.0, 0.0}, {0.0, INFINITY}};
    memset(&never, 0, sizeof never);
    build(&f, TDSP_GUARANTEE_TRAVEL, TDSP_SAMPLING_ADAPTIVE);
    assert_int_equal(tdsp_verify_table(f.scene, &never, &verdict), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_verify_table_for(f.scene, &nowhere, &f.table, &verdict), TDSP_INVALID_ARGUMENT);
    discard(&f);
}

static void null_arguments_are_refused(void **state)
{
    (void)state;
    fixture f;
    tdsp_table_verdict verdict;
    build(&f, TDSP_GUARANTEE_TRAVEL, TDSP_SAMPLING_ADAPTIVE);
    assert_int_equal(tdsp_verify_table(NULL, &f.table, &verdict), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_verify_table(f.scene, NULL, &verdict), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_verify_table(f.scene, &f.table, NULL), TDSP_INVALID_ARGUMENT);
    discard(&f);
}

/* Put a number into a section of a table that stays open: opening has held rows to their order, and the verifier does not rely on it. */
static tdsp_table_verdict verdict_with(const tdsp_scene *scene, const tdsp_table *table, unsigned char *bytes, uint64_t section, uint64_t row, double number)
{
    tdsp_table_verdict verdict;
    unsigned char *at = bytes + section + 8 * row;
    const double before = bytes_get_f64(at);
    bytes_put_f64(at, number);
    assert_int_equal(tdsp_verify_table(scene, table, &verdict), TDSP_OK);
    bytes_put_f64(at, before);
    return verdict;
}

static void assert_unordered(const tdsp_scene *scene, const tdsp_table *table, unsigned char *bytes, uint64_t section, uint64_t row, double number)
{
    const tdsp_table_verdict verdict = verdict_with(scene, table, bytes, section, row, number);
    if (verdict.ok || verdict.bad_order == 0) fail_msg("row %d of the section at %d: %g was let pass", (int)row, (int)section, number);
}

static void rows_that_are_changed_after_the_table_was_opened_are_found(void **state)
{
    (void)state;
    fixture f;
    build(&f, TDSP_GUARANTEE_TRAVEL, TDSP_SAMPLING_ADAPTIVE);
    const tdsp_table *t = &f.table;
    tdsp_row before, row;
    assert_int_equal(tdsp_table_row(t, 2, &before), TDSP_OK);
    assert_int_equal(tdsp_table_row(t, 3, &row), TDSP_OK);
    assert_unordered(f.scene, t, f.bytes, t->departures, 0, 0.5);
    assert_unordered(f.scene, t, f.bytes, t->left, 0, 1.0);
    assert_unordered(f.scene, t, f.bytes, t->departures, 3, before.departure);
    assert_unordered(f.scene, t, f.bytes, t->departures, 3, NAN);
    assert_unordered(f.scene, t, f.bytes, t->left, 3, 0.5 * before.left);
    assert_unordered(f.scene, t, f.bytes, t->right, 3, 0.5 * before.right);
    assert_unordered(f.scene, t, f.bytes, t->right, 2, 1.5 * row.left);
    assert_true(verdict_of(&f).ok);
    discard(&f);
}

/* The same where arrivals do not decrease, and travel times may. */
static void arrivals_that_are_changed_after_the_table_was_opened_are_found(void **state)
{
    (void)state;
    toy city = toy_named("city")->toy;
    const tdsp_oracle oracle = toy_oracle(&city, 0);
    tdsp_build_options options;
    tdsp_build_options_init(&options);
    options.guarantee = TDSP_GUARANTEE_ARRIVAL;
    toy_table t = toy_build(&oracle, &options);
    tdsp_table_verdict verdict;
    tdsp_scene *scene;
    tdsp_row before;
    assert_int_equal(tdsp_scene_create(&journey, NULL, 0, NULL, &scene), TDSP_OK);
    assert_int_equal(tdsp_verify_table(scene, &t.table, &verdict), TDSP_OK);
    assert_int_equal(verdict.bad_order, 0);
    assert_int_equal(tdsp_table_row(&t.table, 2, &before), TDSP_OK);
    assert_unordered(scene, &t.table, t.bytes, t.table.left, 3, 0.0);
    assert_unordered(scene, &t.table, t.bytes, t.table.right, 3, 0.0);
    assert_unordered(scene, &t.table, t.bytes, t.table.departures, 3, before.departure);
    tdsp_scene_free(scene);
    toy_table_free(&t);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rows_that_are_changed_after_the_table_was_opened_are_found),
        cmocka_unit_test(arrivals_that_are_changed_after_the_table_was_opened_are_found),
        cmocka_unit_test(a_built_table_is_accepted_under_every_guarantee),
        cmocka_unit_test(a_table_of_another_scene_is_stale),
        cmocka_unit_test(larger_discs_make_rows_fail_by_their_paths),
        cmocka_unit_test(an_upper_end_that_is_too_high_breaks_the_guarantee),
        cmocka_unit_test(a_path_that_ends_beside_the_destination_is_a_bad_path),
        cmocka_unit_test(a_table_that_is_monotone_in_arrival_is_held_in_order_by_its_arrivals),
        cmocka_unit_test(a_table_that_was_never_opened_and_ends_that_are_no_places_are_refused),
        cmocka_unit_test(null_arguments_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
