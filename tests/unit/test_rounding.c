/* SPDX-License-Identifier: MIT */
/* Answers in scenes in which rounding used to show, beside what tests/slow/precise.h says of them. */
#include "support/cmocka_all.h"

#include "support/assert.h"
#include "support/world.h"
#include "tdsp/path.h"

/*
 * Between a ride on disc 8 and one on disc 5 a ride on disc 1 shrinks to nothing, as disc 5 swallows disc 1. T seemed 1.1e-8 longer than it is there, and fell
 * by as much where that ride ended.
 */
static void a_ride_that_vanishes_as_its_disc_is_swallowed_costs_nothing(void **state)
{
    (void)state;
    static const tdsp_disc discs[] = {
        {{0.75, 0}, 0.125, 0.0056967725160056715}, {{0, -0.5}, 0.125, 0.0056967725160056715}, {{0.25, -0.25}, 0.125, 0.0056967725160056715},
        {{0, 0}, 0.125, 0.0056967725160056715},    {{0.25, 0.5}, 0.125, 0.125},               {{-0.25, 0.5}, 0.125, 0.125},
        {{-0.25, 0}, 0.125, 0.125},                {{-0.5, -0.25}, 0.125, 0.125},
    };
    static const double expected[][2] = {{3.1064164353669197, 3.0077156201374677185}, {3.1064174343669197, 3.0077159806751517014},
                                         {3.1064174353669198, 3.0077159810360511723}, {3.1064174354669198, 3.0077159810721411197},
                                         {3.1064174356669199, 3.0077159811443210146}, {3.1064174453669198, 3.0077159846450455928}};
    world w = world_make((tdsp_journey){1.0, 0.0, {-1.0, 0.0}, {1.0, 0.0}}, discs, sizeof discs / sizeof *discs);
    for (size_t i = 0; i < sizeof expected / sizeof *expected; i++) {
        double arrival;
        assert_int_equal(tdsp_earliest_arrival(w.solver, expected[i][0], &arrival), TDSP_OK);
        assert_near(arrival - expected[i][0], expected[i][1], 1e-13);
    }
    world_free(w);
}

/*
 * An arrival that is late by no more than a touch or the rounding of time counts as the moment in which the destination is covered. After 4e8 journeys that
 * is a good part of one, and the last leg began after its end.
 */
static void no_leg_ends_before_it_begins_where_the_arrival_is_a_touch_late(void **state)
{
    (void)state;
    static const tdsp_disc disc = {{0.58263844054014291, -0.36885568616643244}, 0.12524994908990919, 1e-9};
    world w = world_make((tdsp_journey){1.0, 0.0, {-1.0, 0.0}, {1.0, 0.0}}, &disc, 1);
    const double covered = tdsp_scene_destination_free_until(w.scene, NULL);
    tdsp_leg legs[8];
    size_t count;
    double arrival;
    int late = 0;
    for (int i = 0; i < 400; i++) {
        const double departure = covered - 2.06570 - 1e-7 * i;
        if (tdsp_earliest_arrival(w.solver, departure, &arrival) != TDSP_OK) continue;
        assert_int_equal(tdsp_solver_path(w.solver, legs, 8, &count), TDSP_OK);
        for (size_t k = 0; k < count; k++) assert_true(legs[k].start_time <= legs[k].end_time);
        assert_exact(legs[count - 1].end_time, arrival);
        assert_true(arrival <= covered);
        late += arrival == covered;
    }
    assert_true(late > 0);
    world_free(w);
}

/*
 * So near to a disc that it counts as touched, the second root of the tangents to it was taken for a leg of no length. Its ride began where the one to the other side
 * does, a moment too early, and drove that one out: the robot went the long way round, T = 11.67.
 */
static void a_source_just_before_it_is_covered_is_left_on_the_shorter_side(void **state)
{
    (void)state;
    static const tdsp_disc disc = {{4.118967169731425, 1.6081529091159112}, 0.35839264562669249, 0.082125410843469554};
    const tdsp_point source = {4.4076124114462845, -0.57906964610513401}, destination = {-source.x, -source.y};
    world w = world_make((tdsp_journey){1.4220572780052794, 0.0, source, destination}, &disc, 1);
    const double covered = tdsp_scene_source_free_until(w.scene, NULL);
    for (double before = 1e-9; before > 1e-14; before *= 0.3) assert_near(world_arrival(w, covered - before) - (covered - before), 6.26119170908977, 2.0 * before + 1e-13);
    world_free(w);
}

/* The same backwards: the latest departures that reach a destination just before it is covered. */
static void a_destination_just_before_it_is_covered_is_reached_on_the_shorter_side(void **state)
{
    (void)state;
    static const tdsp_disc disc = {{0.98, -0.3}, 0.1, 0.05};
    world w = world_make((tdsp_journey){1.0, 0.0, {-1.0, 0.0}, {1.0, 0.0}}, &disc, 1);
    const double covered = tdsp_scene_destination_free_until(w.scene, NULL);
    double at_last, departure, arrives;
    assert_int_equal(tdsp_latest_departure(w.solver, covered, &at_last, NULL), TDSP_OK);
    for (double before = 1e-9; before > 1e-14; before *= 0.3) {
        assert_int_equal(tdsp_latest_departure(w.solver, covered - before, &departure, &arrives), TDSP_OK);
        assert_near(arrives, covered - before, 1e-13);
        assert_near(departure, at_last, 2.0 * before + 1e-13);
    }
    world_free(w);
}

/*
 * Disc 0 touches disc 1 from inside, and both grow at one rate, so it does for ever. The leg from one to the other has a length and a direction that are rounding alone; from moment
 * to moment they were other ones, by 1e-8, and a robot that changed over and back again gained as much.
 */
static void nothing_is_gained_by_changing_over_between_discs_that_touch_from_inside(void **state)
{
    (void)state;
    static const tdsp_disc discs[] = {{{0.30551307397315114, -0.631482715100382}, 0.1124989051065784, 0.1759234298949048},
                                      {{0.3449378765985501, -0.5488319159842825}, 0.20407111517372425, 0.1759234298949048},
                                      {{0.15575136544195028, 0.12546518307071514}, 0.1, 0.2}};
    const tdsp_point source = {0.6273259153535756, -0.7787568272097514}, destination = {-source.x, -source.y};
    world w = world_make((tdsp_journey){1.0, 0.0, source, destination}, discs, 3);
    assert_near(world_arrival(w, 0.525) - 0.525, 2.374952872546834256, 1e-13);
    world_free(w);
}

/* A touch of 1e-12 of a disc of 57186 is 5.7e-8, which is more than any path may be wrong by. Precisely, there is no way. */
static void a_touch_of_a_huge_disc_is_no_deeper_than_a_path_may_be(void **state)
{
    (void)state;
    static const tdsp_disc discs[] = {{{0.923901, 0.139414211}, 4.7e-05, 0.213395139},
                                      {{6292120, -118090352}, 118257862, 0},
                                      {{-17388.9670697, 54479.1618222}, 57186.507495937491, 0}};
    double arrival;
    world w = world_make((tdsp_journey){1.0, 0.0, {0.0, 0.0}, {2.0, 0.0}}, discs, 3);
    assert_int_equal(tdsp_earliest_arrival(w.solver, 1.9722645, &arrival), TDSP_CUT_OFF);
    assert_near(world_arrival(w, 1.9) - 1.9, 2.716692032496362695, 1e-13);
    world_free(w);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_ride_that_vanishes_as_its_disc_is_swallowed_costs_nothing),
        cmocka_unit_test(a_source_just_before_it_is_covered_is_left_on_the_shorter_side),
        cmocka_unit_test(a_destination_just_before_it_is_covered_is_reached_on_the_shorter_side),
        cmocka_unit_test(nothing_is_gained_by_changing_over_between_discs_that_touch_from_inside),
        cmocka_unit_test(a_touch_of_a_huge_disc_is_no_deeper_than_a_path_may_be),
        cmocka_unit_test(no_leg_ends_before_it_begins_where_the_arrival_is_a_touch_late),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
