/* SPDX-License-Identifier: MIT */
/* Margins at the edges of what can be asked: times too far away, growth that shrinks later or bends, discs as fast as the robot. */
#include "support/cmocka_all.h"

#include "support/world.h"
#include "tdsp/growth.h"
#include "tdsp/margin.h"

static const tdsp_journey across = {1.0, 0.0, {-10.0, 0.0}, {10.0, 0.0}};
static const tdsp_journey stays = {1.0, 0.0, {0.0, 0.0}, {0.0, 0.0}};

static tdsp_leg straight(double start, double end, tdsp_point from, tdsp_point to)
{
    return (tdsp_leg){.kind = TDSP_LEG_LINE, .disc = TDSP_NO_DISC, .start_time = start, .end_time = end, .from = from, .to = to};
}

/* From the source to the destination without a stop. */
static tdsp_leg through(void)
{
    return straight(0.0, 20.0, across.source, across.destination);
}

static tdsp_scene *growing(tdsp_journey journey, tdsp_point center, tdsp_growth growth)
{
    const tdsp_growing_disc disc = {center, 1.0, growth};
    tdsp_scene *scene;
    assert_int_equal(tdsp_scene_create_growing(&journey, &disc, 1, NULL, &scene), TDSP_OK);
    return scene;
}

static tdsp_margin departure_margin(const tdsp_scene *scene, tdsp_raise how, double departure)
{
    tdsp_margin margin;
    assert_int_equal(tdsp_departure_margin(scene, how, departure, INFINITY, &margin), TDSP_OK);
    return margin;
}

static tdsp_margin leg_margin(const tdsp_scene *scene, tdsp_raise how, tdsp_leg leg)
{
    tdsp_margin margin;
    assert_int_equal(tdsp_path_margin(scene, how, &leg, 1, leg.start_time, &margin), TDSP_OK);
    return margin;
}

/* The disc has 3 to grow until it covers the source, and would take 3e18 of time. */
static void a_latest_departure_too_far_away_leaves_the_decision_to_the_arrival(void **state)
{
    (void)state;
    const tdsp_disc slow = {{-10.0, 4.0}, 1.0, 1e-18};
    world w = world_make(across, &slow, 1);
    double latest;
    assert_int_equal(tdsp_latest_departure(w.solver, INFINITY, &latest, NULL), TDSP_NOT_SUPPORTED);
    assert_near(departure_margin(w.scene, TDSP_RAISE_FACTOR, 10.0).most, 3e17, 1e7);
    assert_near(departure_margin(w.scene, TDSP_RAISE_ADDED, 10.0).most, 0.3, 1e-12);
    world_free(w);
}

/* At 10 the disc has grown by 1, and hardly grows from then on: raised so that it just does not cover the source, it never will. */
static void a_witness_too_far_away_is_left_out(void **state)
{
    (void)state;
    const double rates[] = {0.1, 1e-30}, times[] = {0.0, 10.0};
    tdsp_scene *scene = growing(across, (tdsp_point){-10.0, 4.0},
                                (tdsp_growth){.kind = TDSP_GROWTH_RATES, .count = 2, .values = rates, .times = times});
    const tdsp_margin margin = departure_margin(scene, TDSP_RAISE_FACTOR, 15.0);
    assert_near(margin.most, 3.0, 1e-11);
    assert_near(margin.arrival, 35.0, 1e-9);
    tdsp_scene_free(scene);
}

/* The disc gains t / 100 - t^2 / 10000, at most a quarter, at 50: raised by less than 12 it shrinks before it covers the source, and no latest departure is known. */
static void growth_that_shrinks_later_has_the_margin_of_the_arrival(void **state)
{
    (void)state;
    const double powers[] = {0.01, -0.0001};
    const tdsp_growth growth = {.kind = TDSP_GROWTH_POLYNOMIAL, .count = 2, .values = powers};
    tdsp_scene *scene = growing(across, (tdsp_point){-10.0, 4.0}, growth);
    tdsp_margin margin = departure_margin(scene, TDSP_RAISE_FACTOR, 10.0);
    const tdsp_leg late = straight(40.0, 60.0, across.source, across.destination);
    assert_near(margin.most, 3.0 / 0.09, 1e-9);
    assert_int_equal(tdsp_path_margin(scene, TDSP_RAISE_FACTOR, &late, 1, 40.0, &margin), TDSP_SHRINKS);
    tdsp_scene_free(scene);
}

static void nothing_covers_a_robot_that_is_there_before_anything_has_grown(void **state)
{
    (void)state;
    const tdsp_disc disc = {{5.0, 0.0}, 1.0, 0.1};
    world w = world_make(stays, &disc, 1);
    assert_near(departure_margin(w.scene, TDSP_RAISE_FACTOR, 0.0).most, INFINITY, 0);
    world_free(w);
}

/* A disc of radius 1 + x (t / 10 + t^2 / 100) beside the way, which is nearest to it at t = 10: gains 2 x there. */
static void a_path_into_growth_that_bends_fails_below_1(void **state)
{
    (void)state;
    const double powers[] = {0.1, 0.01};
    const tdsp_growth growth = {.kind = TDSP_GROWTH_POLYNOMIAL, .count = 2, .values = powers};
    tdsp_margin margin;
    tdsp_leg leg = straight(10.0, 10.0, across.source, across.source);
    tdsp_scene *scene = growing(across, (tdsp_point){-10.0, 2.0}, growth);
    margin = leg_margin(scene, TDSP_RAISE_FACTOR, leg);
    assert_near(margin.most, 0.5, 1e-7);
    assert_int_equal(margin.status, TDSP_OK);
    assert_int_equal(margin.witness.limit, TDSP_LIMIT_TOUCH);
    assert_int_equal(tdsp_path_margin(scene, TDSP_RAISE_ADDED, &leg, 1, 10.0, &margin), TDSP_NOT_SUPPORTED);
    tdsp_scene_free(scene);
    scene = growing(across, (tdsp_point){0.0, 0.5}, growth);
    leg = through();
    margin = leg_margin(scene, TDSP_RAISE_FACTOR, leg);
    assert_near(margin.most, -INFINITY, 0);
    assert_int_equal(margin.status, TDSP_BAD_PATH);
    tdsp_scene_free(scene);
}

static void growth_that_bends_too_little_for_any_factor_is_unlimited(void **state)
{
    (void)state;
    const double powers[] = {0.0, 1e-9}; /* 4e-7 at 20, 0.42 with the largest factor */
    tdsp_scene *scene =
        growing(across, (tdsp_point){0.0, 4.0}, (tdsp_growth){.kind = TDSP_GROWTH_POLYNOMIAL, .count = 2, .values = powers});
    const tdsp_margin margin = leg_margin(scene, TDSP_RAISE_FACTOR, through());
    assert_near(margin.most, INFINITY, 0);
    assert_int_equal(margin.witness.limit, TDSP_LIMIT_NONE);
    assert_near(margin.witness.place.x, 10.0, 0);
    tdsp_scene_free(scene);
}

/* Rates as fast as the robot are not raised: what they allow is anything or nothing. */
static void a_disc_that_outruns_the_robot_forbids_its_path_or_does_not_matter(void **state)
{
    (void)state;
    const tdsp_disc fast = {{0.0, 25.0}, 1.0, 2.0};
    const tdsp_leg legs[2] = {straight(0.0, 5.0, across.source, (tdsp_point){-5.0, 0.0}), through()};
    world w = world_make(across, &fast, 1);
    for (int how = 0; how < 2; how++) {
        assert_near(leg_margin(w.scene, (tdsp_raise)how, legs[0]).most, INFINITY, 0); /* 24.5 away, 11 large */
        assert_near(leg_margin(w.scene, (tdsp_raise)how, legs[1]).most, -INFINITY, 0);
    }
    world_free(w);
}

static void a_path_may_name_a_disc_that_is_not_there(void **state)
{
    (void)state;
    const tdsp_disc disc = {{3.0, 0.0}, 1.0, 0.1};
    tdsp_leg leg = {.kind = TDSP_LEG_ARC,
                    .disc = 0,
                    .start_time = 1.0,
                    .end_time = 2.0,
                    .turn = 1,
                    .center = {5.0, 0.0},
                    .radius_from = 1.0,
                    .radius_to = 1.0,
                    .sweep = 1.0};
    leg.from = (tdsp_point){6.0, 0.0};
    leg.to = (tdsp_point){5.0 + cos(1.0), sin(1.0)};
    world w = world_make(across, &disc, 1);
    const double most = leg_margin(w.scene, TDSP_RAISE_FACTOR, leg).most;
    leg.disc = 7;
    assert_exact(leg_margin(w.scene, TDSP_RAISE_FACTOR, leg).most, most);
    assert_near(most, (hypot(leg.to.x - 3.0, leg.to.y) - 1.0) / 2.0 / 0.1, 1e-9); /* the end is nearest, and latest */
    world_free(w);
}

static void mistakes_in_questions_are_told(void **state)
{
    (void)state;
    const tdsp_disc disc = {{0.0, 5.0}, 1.0, 0.1};
    const tdsp_leg backwards[2] = {straight(5.0, 6.0, across.source, across.source),
                                   straight(4.0, 6.0, across.source, across.source)};
    const tdsp_leg leg = through();
    world w = world_make(across, &disc, 1);
    tdsp_margin m;
    tdsp_slack slack;
    tdsp_scene *raised;
    assert_int_equal(tdsp_path_margin(w.scene, TDSP_RAISE_FACTOR, backwards, 2, 5.0, &m), TDSP_BAD_PATH);
    assert_int_equal(tdsp_path_margin(NULL, TDSP_RAISE_FACTOR, &leg, 1, 0.0, &m), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_path_margin(w.scene, TDSP_RAISE_FACTOR, &leg, 1, 0.0, NULL), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_path_margin(w.scene, (tdsp_raise)2, &leg, 1, 0.0, &m), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_path_margin(w.scene, TDSP_RAISE_FACTOR, &leg, 1, -1.0, &m), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_path_margin(w.scene, TDSP_RAISE_FACTOR, &leg, 1, INFINITY, &m), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_departure_margin(w.scene, TDSP_RAISE_FACTOR, 0.0, 1.0, NULL), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_departure_margin(w.scene, TDSP_RAISE_FACTOR, -1.0, 1.0, &m), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_scene_raise(NULL, TDSP_RAISE_FACTOR, 1.0, &raised), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_scene_raise(w.scene, TDSP_RAISE_FACTOR, 1.0, NULL), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_solver_slack(NULL, 1.0, 2.0, &slack), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_solver_slack(w.solver, 1.0, 2.0, NULL), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_solver_slack(w.solver, 1.0, -1.0, &slack), TDSP_INVALID_ARGUMENT);
    world_free(w);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_latest_departure_too_far_away_leaves_the_decision_to_the_arrival),
        cmocka_unit_test(a_witness_too_far_away_is_left_out),
        cmocka_unit_test(growth_that_shrinks_later_has_the_margin_of_the_arrival),
        cmocka_unit_test(nothing_covers_a_robot_that_is_there_before_anything_has_grown),
        cmocka_unit_test(a_path_into_growth_that_bends_fails_below_1),
        cmocka_unit_test(growth_that_bends_too_little_for_any_factor_is_unlimited),
        cmocka_unit_test(a_disc_that_outruns_the_robot_forbids_its_path_or_does_not_matter),
        cmocka_unit_test(a_path_may_name_a_disc_that_is_not_there),
        cmocka_unit_test(mistakes_in_questions_are_told),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
