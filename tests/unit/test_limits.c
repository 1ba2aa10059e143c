/* SPDX-License-Identifier: MIT */
/* Numbers at the ends of what a scene may hold: each ends in an answer or a status, and answers are right. */
#include "support/cmocka_all.h"

#include <float.h>

#include "support/world.h"
#include "tdsp/build.h"
#include "tdsp/growth.h"
#include "tdsp/solver.h"
#include "tdsp/table.h"
#include "tdsp/verify.h"

static const tdsp_journey plain = {1.0, 0.0, {-10.0, 0.0}, {10.0, 0.0}};

static void assert_path_is_good(world w, double departure, double arrival)
{
    tdsp_leg legs[64];
    size_t count = 0;
    tdsp_verdict verdict;
    assert_int_equal(tdsp_solver_path(w.solver, legs, 64, &count), TDSP_OK);
    assert_int_equal(tdsp_verify_path(w.scene, legs, count, departure, arrival, &verdict), TDSP_OK);
    assert_int_equal(verdict.problems, 0);
}

static void assert_table_is_good(world w, tdsp_status wanted)
{
    tdsp_oracle oracle;
    tdsp_build_options options;
    tdsp_build_report report;
    tdsp_table table;
    tdsp_table_verdict verdict;
    void *bytes = NULL;
    size_t length = 0;
    const tdsp_journey *journey = tdsp_scene_journey(w.scene);
    assert_int_equal(tdsp_solver_oracle(w.solver, &oracle), TDSP_OK);
    tdsp_build_options_init(&options);
    options.epsilon = 0.1;
    options.world = (tdsp_build_world){tdsp_scene_hash(w.scene), journey->speed, journey->source, journey->destination, NULL, NULL};
    assert_int_equal(tdsp_build(&oracle, &options, NULL, &bytes, &length, &report), wanted);
    if (wanted != TDSP_OK) return;
    assert_int_equal(tdsp_table_open(&table, bytes, length), TDSP_OK);
    assert_int_equal(tdsp_verify_table(w.scene, &table, &verdict), TDSP_OK);
    assert_true(verdict.ok);
    tdsp_bytes_free(NULL, bytes, length);
}

/* A disc smaller than the rounding of places stood in the way like a wall: it stopped the straight leg and could not be ridden. */
static void a_disc_smaller_than_rounding_is_no_wall(void **state)
{
    (void)state;
    static const double radii[] = {1e-8, 1e-12, 1e-13, 8e-14, 1e-14, 1e-15, 1e-16, 1e-20, 1e-100, 1e-200, 1e-310, 0.0};
    static const double rates[] = {0.0, 1e-310, 1e-30, 1e-15};
    for (size_t i = 0; i < sizeof radii / sizeof *radii; i++)
        for (size_t k = 0; k < sizeof rates / sizeof *rates; k++)
            for (int place = 0; place < 3; place++) {
                const tdsp_disc disc = {{4.0 * place, 0.0}, radii[i], rates[k]};
                world w = world_make(plain, &disc, 1);
                const double arrival = world_arrival(w, 0.0);
                assert_near(arrival, 20.0, 1e-9);
                assert_path_is_good(w, 0.0, arrival);
                world_free(w);
            }
}

/* In scenes of lengths around 1e-300 squares of lengths are 0: rides had radius 0, and no table could be built. */
static void the_smallest_scenes_have_tables_too(void **state)
{
    (void)state;
    static const double sizes[] = {1e-100, 1e-140, 1e-153, 1e-155, 1e-200, 1e-300};
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        const double a = sizes[i];
        const tdsp_journey journey = {1.0, 0.0, {-a, 0.0}, {a, 0.0}};
        const tdsp_disc disc = {{0.0, 0.0}, 0.5 * a, 0.1};
        world w = world_make(journey, &disc, 1);
        const double arrival = world_arrival(w, 0.0);
        assert_true(arrival > 2.0 * a && arrival < 3.0 * a);
        assert_path_is_good(w, 0.0, arrival);
        assert_table_is_good(w, TDSP_OK);
        world_free(w);
    }
}

/* The same where rates change: such a source counted as covered. */
static void the_source_of_the_smallest_scene_is_free(void **state)
{
    (void)state;
    static const double sizes[] = {1e-100, 1e-200, 1e-300};
    static const double coefficients[] = {0.1, 0.01};
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        const double a = sizes[i];
        const tdsp_journey journey = {1.0, 0.0, {-a, 0.0}, {a, 0.0}};
        const tdsp_growing_disc disc = {{0.0, 0.0}, 0.5 * a, {.kind = TDSP_GROWTH_POLYNOMIAL, .count = 2, .values = coefficients}};
        tdsp_scene *scene = NULL;
        assert_int_equal(tdsp_scene_create_growing(&journey, &disc, 1, NULL, &scene), TDSP_OK);
        assert_near(tdsp_scene_source_free_until(scene, NULL) / (5.0 * a), 1.0, 1e-9);
        tdsp_scene_free(scene);
    }
}

/* A scene at the largest lengths was answered "bad scene" while it looked for a reason, among discs grown past the largest radius. */
static void the_largest_scene_has_a_reason_for_its_end(void **state)
{
    (void)state;
    const tdsp_journey journey = {1.0, 0.0, {-1e100, 0.0}, {1e100, 0.0}};
    const tdsp_disc gate[] = {{{0.0, 3e99}, 1e99, 0.1}, {{0.0, -3e99}, 1e99, 0.1}};
    const tdsp_disc corner[] = {{{-1e100, -1e100}, 1e99, 0.5}, {{0.0, 0.0}, 0.0, 0.1}, {{-1e100, 1e100}, 1e100, 0.0}};
    tdsp_last_departure last;
    world w = world_make(journey, gate, 2);
    assert_int_equal(tdsp_solver_last_departure(w.solver, &last), TDSP_OK);
    assert_true(tdsp_status_is_answer(last.reason) && last.reason != TDSP_OK);
    assert_table_is_good(w, TDSP_OK);
    world_free(w);
    w = world_make(journey, corner, 3);
    assert_int_equal(tdsp_solver_last_departure(w.solver, &last), TDSP_OK);
    assert_true(last.reason == TDSP_SOURCE_COVERED || last.reason == TDSP_DESTINATION_COVERED || last.reason == TDSP_CUT_OFF);
    world_free(w);
}

static void times_too_far_away_are_refused_at_once(void **state)
{
    (void)state;
    static const double far[] = {1e30, 1e100, 1e300};
    const tdsp_disc disc = {{0.0, 5.0}, 1.0, 1e-300};
    world w = world_make(plain, &disc, 1);
    double arrival = -1.0;
    for (size_t i = 0; i < sizeof far / sizeof *far; i++) {
        assert_int_equal(tdsp_earliest_arrival(w.solver, far[i], &arrival), TDSP_NOT_SUPPORTED);
        assert_int_equal(tdsp_latest_departure(w.solver, far[i], &arrival, NULL), TDSP_NOT_SUPPORTED);
    }
    assert_int_equal(tdsp_earliest_arrival(w.solver, INFINITY, &arrival), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_earliest_arrival(w.solver, NAN, &arrival), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_earliest_arrival(w.solver, -5e-324, &arrival), TDSP_INVALID_ARGUMENT);
    assert_true(arrival == -1.0);
    world_free(w);
}

static void counts_beyond_memory_are_refused_before_anything_is_read(void **state)
{
    (void)state;
    const tdsp_disc disc = {{0.0, 5.0}, 1.0, 0.1};
    const tdsp_growing_disc growing = {{0.0, 5.0}, 1.0, {.kind = TDSP_GROWTH_RATE, .rate = 0.1}};
    static const size_t counts[] = {SIZE_MAX, SIZE_MAX / sizeof(tdsp_disc), SIZE_MAX / 2 + 1, (size_t)1 << 31};
    tdsp_scene *scene = NULL;
    for (size_t i = 0; i < sizeof counts / sizeof *counts; i++) {
        const tdsp_status wanted = counts[i] > 0x7fffffff ? TDSP_INVALID_ARGUMENT : TDSP_NO_MEMORY; /* the latter on 32 bits */
        assert_int_equal(tdsp_scene_create(&plain, &disc, counts[i], NULL, &scene), wanted);
        assert_int_equal(tdsp_scene_create_growing(&plain, &growing, counts[i], NULL, &scene), wanted);
    }
    assert_null(scene);
}

static void numbers_out_of_range_are_refused(void **state)
{
    (void)state;
    static const double wrong[] = {NAN, INFINITY, -INFINITY, 1.0000000000000002e100, -1.0000000000000002e100, DBL_MAX};
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        tdsp_disc discs[] = {{{wrong[i], 0.0}, 1.0, 0.1}, {{0.0, wrong[i]}, 1.0, 0.1}, {{0.0, 5.0}, wrong[i], 0.1}, {{0.0, 5.0}, 1.0, wrong[i]}};
        tdsp_journey journeys[] = {plain, plain, plain, plain};
        journeys[0].speed = wrong[i];
        journeys[1].radius = wrong[i];
        journeys[2].source.x = wrong[i];
        journeys[3].destination.y = wrong[i];
        for (int k = 0; k < 4; k++) {
            tdsp_scene *scene = NULL;
            assert_non_null(tdsp_disc_check(&discs[k]));
            assert_non_null(tdsp_journey_check(&journeys[k]));
            assert_int_equal(tdsp_scene_create(&plain, &discs[k], 1, NULL, &scene), TDSP_BAD_SCENE);
            assert_int_equal(tdsp_scene_create(&journeys[k], NULL, 0, NULL, &scene), TDSP_BAD_SCENE);
            assert_null(scene);
        }
    }
}

/* Which of two moments that are as close was left to the order in which the compiler evaluates arguments. */
static void of_equal_clearances_the_first_is_told_whatever_the_compiler(void **state)
{
    (void)state;
    const tdsp_disc disc = {{0.0, 0.0}, 1.0, 0.0};
    const double quarter = asin(1.0);
    const tdsp_leg ride = {.kind = TDSP_LEG_ARC, .turn = 1, .start_time = 1.0, .end_time = 1.0 + quarter, .from = {1.0, 0.0}, .to = {0.0, 1.0},
                           .radius_from = 1.0, .radius_to = 1.0, .sweep = quarter};
    world w = world_make(plain, &disc, 1);
    tdsp_verdict verdict;
    assert_int_equal(tdsp_verify_path(w.scene, &ride, 1, 1.0, ride.end_time, &verdict), TDSP_OK);
    assert_true(verdict.min_clearance == 0.0 && verdict.time == 1.0);
    world_free(w);
}

/* What bounds the rows of a table is asked for, and ends the building when it is passed. */
static void the_rows_asked_for_at_most_end_the_building(void **state)
{
    (void)state;
    const tdsp_disc disc = {{0.0, 0.0}, 1.0, 0.1};
    world w = world_make(plain, &disc, 1);
    tdsp_oracle oracle;
    tdsp_build_options options;
    tdsp_build_report report;
    void *bytes = NULL;
    size_t length = 0;
    assert_int_equal(tdsp_solver_oracle(w.solver, &oracle), TDSP_OK);
    tdsp_build_options_init(&options);
    options.epsilon = 1e-9;
    options.max_rows = 100;
    assert_int_equal(tdsp_build(&oracle, &options, NULL, &bytes, &length, &report), TDSP_TOO_MANY_ROWS);
    options.epsilon = 1e-300;
    assert_int_equal(tdsp_build(&oracle, &options, NULL, &bytes, &length, &report), TDSP_INVALID_ARGUMENT);
    assert_null(bytes);
    world_free(w);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_disc_smaller_than_rounding_is_no_wall),
        cmocka_unit_test(the_smallest_scenes_have_tables_too),
        cmocka_unit_test(the_source_of_the_smallest_scene_is_free),
        cmocka_unit_test(the_largest_scene_has_a_reason_for_its_end),
        cmocka_unit_test(times_too_far_away_are_refused_at_once),
        cmocka_unit_test(counts_beyond_memory_are_refused_before_anything_is_read),
        cmocka_unit_test(numbers_out_of_range_are_refused),
        cmocka_unit_test(of_equal_clearances_the_first_is_told_whatever_the_compiler),
        cmocka_unit_test(the_rows_asked_for_at_most_end_the_building),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
