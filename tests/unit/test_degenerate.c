/* SPDX-License-Identifier: MIT */
/* Scenes that went wrong once, as they were found: both engines must give the same answer, with a path that the verifier takes. */
#include "support/cmocka_all.h"

#include "support/chance.h"
#include "tdsp/growth.h"
#include "tdsp/solver.h"
#include "tdsp/verify.h"

#define SEED 7301

#define MOST_LEGS 64

typedef struct degenerate {
    tdsp_journey journey;
    size_t count;
    tdsp_disc discs[4];
} degenerate;

/* A(departure) by a method, its path checked; infinite without a way. */
static double arrival_by(const tdsp_scene *scene, tdsp_method method, double departure)
{
    tdsp_solver *solver;
    tdsp_leg legs[MOST_LEGS];
    tdsp_verdict verdict;
    size_t count;
    double arrival = -1.0;
    assert_int_equal(tdsp_solver_create_for(scene, method, &solver), TDSP_OK);
    assert_true(tdsp_status_is_answer(tdsp_earliest_arrival(solver, departure, &arrival)));
    if (arrival < INFINITY) {
        assert_int_equal(tdsp_solver_path(solver, legs, MOST_LEGS, &count), TDSP_OK);
        assert_int_equal(tdsp_verify_path(scene, legs, count, departure, arrival, &verdict), TDSP_OK);
        assert_int_equal(verdict.problems, 0);
    }
    tdsp_solver_free(solver);
    return arrival;
}

static tdsp_scene *scene_of(const degenerate *d)
{
    tdsp_scene *scene;
    assert_int_equal(tdsp_scene_create(&d->journey, d->discs, d->count, NULL, &scene), TDSP_OK);
    return scene;
}

/* What both engines say of a departure. */
static double agreed_arrival(const degenerate *d, double departure)
{
    tdsp_scene *scene = scene_of(d);
    const double one = arrival_by(scene, TDSP_METHOD_AUTO, departure), other = arrival_by(scene, TDSP_METHOD_GENERAL, departure);
    tdsp_scene_free(scene);
    assert_near(other, one, 1e-10 * one);
    return one;
}

static double last_departure(const degenerate *d)
{
    tdsp_scene *scene = scene_of(d);
    tdsp_solver *solver;
    tdsp_last_departure last;
    assert_int_equal(tdsp_solver_create(scene, &solver), TDSP_OK);
    assert_int_equal(tdsp_solver_last_departure(solver, &last), TDSP_OK);
    tdsp_solver_free(solver);
    tdsp_scene_free(scene);
    return last.departure;
}

/* A place so far from a centre, in one of some directions. */
static tdsp_point place_around(tdsp_point center, double away, int direction)
{
    return (tdsp_point){center.x + away * cos(0.37 * direction), center.y + away * sin(0.37 * direction)};
}

static void a_destination_a_hair_beyond_a_boundary_is_not_ridden_past(void **state)
{
    (void)state;
    for (int direction = -7; direction <= 7; direction++) {
        for (double hair = 1e-3; hair > 1e-11; hair *= 0.1) {
            degenerate d = {{1.0, 0.0, {-1.0, 0.0}, {0.0, 0.0}}, 1, {{{0.0, 0.0}, 0.25, 0.0}}};
            d.journey.destination = place_around(d.discs[0].center, 0.25 + hair, direction);
            assert_true(agreed_arrival(&d, 0.0) < INFINITY);
        }
    }
}

/* The disc is 5e-7 of the journey: the coordinates of its boundary are known to less than the depth that was forgiven. */
static void a_destination_on_the_boundary_of_a_pebble_is_reached(void **state)
{
    (void)state;
    const degenerate d = {{0x1p-20, 0.0, {-1048576.0, 0.0}, {-802816.0, 2080768.0}}, 1, {{{-802816.83487477119, 2080768.634425523}, 1.048576, 0.0}}};
    assert_true(agreed_arrival(&d, 0.0) < INFINITY);
}

static void a_destination_behind_a_pebble_that_it_touches_is_ridden_to(void **state)
{
    (void)state;
    const degenerate d = {
        {0x1p-20, 0.0, {-1048576.0, 0.0}, {1556480.0, -1998848.0}}, 1, {{{1556479.0766198053, -1998847.5031291477}, 1.048576, 0.0}}};
    assert_true(agreed_arrival(&d, 0.0) < INFINITY);
}

/* The ride begins on a radius of 2e-8, where places say the angle to 5e-9, and ends on one of 1.3. */
static void a_spiral_out_of_almost_nothing_ends_where_its_angle_says(void **state)
{
    (void)state;
    const degenerate d = {{1.0, 1e-12, {-1.0, 0.0}, {-0.75, -2.0}}, 1, {{{-1.0000000008585634, -5.1270718232044204e-10}, 0.0, 0.999}}};
    tdsp_scene *scene = scene_of(&d);
    assert_near(arrival_by(scene, TDSP_METHOD_AUTO, 3.9288208455629492e-10), 2.017294844, 1e-8);
    assert_near(arrival_by(scene, TDSP_METHOD_GENERAL, 3.9288208455629492e-10), 2.017294844, 1e-8);
    tdsp_scene_free(scene);
}

static void a_point_that_grows_a_hair_from_the_source_covers_it_last(void **state)
{
    (void)state;
    const degenerate d = {{0.3, 0.0, {-1.0, 0.0}, {1.296875, -2.0}}, 1, {{{-1.000000000880604, 4.7385297032589052e-10}, 0.0, 0.15}}};
    tdsp_scene *scene = scene_of(&d);
    const double covered = tdsp_scene_source_free_until(scene, NULL);
    tdsp_scene_free(scene);
    assert_near(last_departure(&d), covered, 1e-12);
}

/* So late that the arrival and the end of the ride before it are rounded apart: the last leg ran backwards in time. */
static void a_path_at_the_end_of_a_long_wait_does_not_run_backwards(void **state)
{
    (void)state;
    const degenerate d = {{1e-6, 0.0, {-1048576001048576.0, 524288000000000.0}, {-1048575997919232.0, 524288002080768.0}},
                          1,
                          {{{-1048575998771200.0, 524288001228800.0}, 1e-6, 1e-15}}};
    tdsp_scene *scene = scene_of(&d);
    assert_true(arrival_by(scene, TDSP_METHOD_AUTO, last_departure(&d)) < INFINITY);
    tdsp_scene_free(scene);
}

/* Legs of the other root, which from a point have a length below 0, were taken for legs of length 0 to the wrong side. */
static void a_source_a_hair_off_a_boundary_is_left_both_ways_round(void **state)
{
    (void)state;
    const degenerate exact = {{0.3, 0.0, {0.0, -0.5}, {-0.921875, -1.609375}}, 1, {{{-0.59509565564332778, -0.17977904739695677}, 0.67578125, 0.0375}}};
    const degenerate nearly = {{0.3, 1e-300, {999.0, -500.0}, {998.5, -500.015625}}, 1, {{{998.98486238532109, -499.75045871559621}, 0.25, 0.036}}};
    assert_near(agreed_arrival(&exact, 0.0), 4.8229085031310035, 1e-10);
    assert_near(agreed_arrival(&nearly, 0.0), 1.66797954347241, 1e-10);
}

/* A place of departure was met by who is 3e-12 of a turn past it, on this disc a thousandth of the journey: the leg from there was shorter than straight. */
static void nobody_leaves_a_vast_disc_from_behind(void **state)
{
    (void)state;
    const degenerate d = {{1.0, 0.0, {-37000.0, 0.0}, {37000.0, 0.0}}, 2, {{{-41046.875, 41046.875}, 23125.0, 0.125}, {{37000.0, 3.7e13}, 3.7e13, 0.0}}};
    const degenerate without = {d.journey, 1, {d.discs[0]}};
    assert_near(agreed_arrival(&d, 144964.88), agreed_arrival(&without, 144964.88), 3.7e13 * 0x1p-50);
}

/* In the general method the ride on the faster of two discs that touch from inside, at the source, was over before the place where it leaves for the other. */
static void a_source_where_two_discs_touch_from_inside_is_left_by_both(void **state)
{
    (void)state;
    const degenerate d = {{1.0, 0.0, {-1.0, 0.0}, {0.671875, -2.0}},
                          2,
                          {{{-0.57421875, 0.0}, 0.42578125, 0.032499999999967499}, {{-0.48828125, 0.0}, 0.51171875, 0.024999999975000003}}};
    assert_near(agreed_arrival(&d, 0.0), 2.641733936823384, 1e-10);
}

/* ... and where the source's distance is rounded to a hair inside one of them that ride seemed to begin inside of it, and not to leave for it later. */
static void a_source_where_two_discs_touch_from_inside_is_left_by_both_after_rounding(void **state)
{
    (void)state;
    const degenerate d = {{1.0, 0.0, {-1.0, 0.0}, {1.890625, -2.0}}, 2,
                          {{{-0.57421875, 0.0}, 0.42578125, 0.032499999999967499}, {{-0.48828125, 0.0}, 0.51171875, 0.024999999975000003}}};
    assert_near(agreed_arrival(&d, 0.0), 3.603365540027, 1e-11);
}

/* From a pebble on a boundary the rider left for a place a quarter round the disc, by a leg of no length. */
static void a_pebble_on_a_boundary_is_no_short_cut_round_the_disc(void **state)
{
    (void)state;
    const degenerate d = {{1.0, 0.0, {-37000.0, 0.0}, {-73421.875, -64171.875}},
                          3,
                          {{{-41678.630941883144, 3143.725620383434}, 5636.71875, 0.925},
                           {{-74000.0, -74000.0}, 0.0, 0.02125},
                           {{-36999.999999996297, 0.0}, 0.0, 0.0675}}};
    tdsp_scene *scene = scene_of(&d);
    assert_true(arrival_by(scene, TDSP_METHOD_AUTO, 0.0) == INFINITY);
    tdsp_scene_free(scene);
}

/* Late in time a rounding of the clock puts the end of a ride behind the destination by more than a touch. */
static void a_destination_on_a_boundary_is_reached_late_in_time(void **state)
{
    (void)state;
    const degenerate d = {{1.0, 0.0, {1.0, 0.0}, {-1.0, 0.0}},
                          2,
                          {{{-1.2187499999999998, -2.0}, 0.0625, 0.00125}, {{-0.9863061797752809, 0.028089887640449437}, 0.03125, 0.0}}};
    assert_near(agreed_arrival(&d, 1168.1030009581443), 1170.1034845797317, 1e-10);
}

/* So late that the clock rounds by more than a touch: every other departure was told that the destination on the boundary is covered. */
static void a_destination_on_a_boundary_is_ridden_onto_tens_of_thousands_of_journeys_late(void **state)
{
    (void)state;
    const degenerate d = {{1e-6, 0.0, {-1e9, 0.0}, {1671875000.0, 1593750000.0}},
                          2,
                          {{{-1093749999.9998906, -1093750000.0}, 3e8, 1e-18}, {{1510156250.0, 1378125000.0}, 269531250.0, 0.0}}};
    for (int k = -10; k <= 10; k++) {
        const double departure = 1.0194441707981426e20 + k * 1e15;
        assert_near(agreed_arrival(&d, departure) - departure, 3185050620952576.0, 65536.0);
    }
}

/* The moment in which the destination is covered was infinite, and a search back from it not a number. */
static void a_destination_covered_later_than_doubles_say_is_too_far(void **state)
{
    (void)state;
    const degenerate d = {{1e6, 0.0, {0.0, 0.0}, {1.953125, -1.953125}}, 2, {{{0.0, 0.0}, 0.0, 1e-303}, {{-0.109486, -1.953125}, 0.0, 1e-303}}};
    tdsp_scene *scene = scene_of(&d);
    tdsp_solver *solver;
    double departure;
    assert_int_equal(tdsp_solver_create(scene, &solver), TDSP_OK);
    assert_int_equal(tdsp_latest_departure(solver, INFINITY, &departure, NULL), TDSP_NOT_SUPPORTED);
    tdsp_solver_free(solver);
    tdsp_scene_free(scene);
}

/* R(t) = radius + rate t / (1 + t / span) */
typedef struct slowing {
    double radius, rate, span;
} slowing;

static void slowing_at(void *ctx, double time, double *radius, double *rate)
{
    const slowing *law = ctx;
    const double slowed = 1.0 + time / law->span;
    *radius = law->radius + law->rate * time / slowed;
    *rate = law->rate / (slowed * slowed);
}

/* Curves of 1e-7 of the journey were near enough to the ride for their place, and not for their speed. */
static void a_ride_on_a_rate_that_falls_within_a_moment_keeps_to_the_speed(void **state)
{
    (void)state;
    slowing law = {0.734375, 0.94, 1e-6};
    const tdsp_journey journey = {1.0, 0.0, {-1.0, 0.0}, {1.0, 0.0}};
    const tdsp_growing_disc disc = {
        {-1.4091154849861591, 0.60986159252595151}, 0.734375, {.kind = TDSP_GROWTH_LAW, .law = slowing_at, .ctx = &law, .until = 16.0}};
    tdsp_scene *scene;
    assert_int_equal(tdsp_scene_create_growing(&journey, &disc, 1, NULL, &scene), TDSP_OK);
    assert_near(arrival_by(scene, TDSP_METHOD_AUTO, 0.0), 2.0, 1e-6);
    tdsp_scene_free(scene);
}

/* The destination is covered 3e13 time units on, and steps of the search for the last departure were a share of that. */
static void a_disc_that_has_all_but_stopped_does_not_blur_the_last_departure(void **state)
{
    (void)state;
    slowing law = {27750.0, 960000.00000096008, 3.6999999999999994e-08};
    static const double times[] = {0.0, 0.037}, rates[] = {960000.0, 0.0};
    const tdsp_journey journey = {1e6, 0.0, {-37000.0, 0.0}, {73421.875, -41046.875}};
    const tdsp_growth until = {.kind = TDSP_GROWTH_RATES, .count = 2, .times = times, .values = rates};
    const tdsp_growing_disc discs[] = {{{-74000.0, 37000.0}, 27750.0, until},
                                       {{-2890.625, -2890.625}, 27750.0, until},
                                       {{-74000.0, -68218.75}, 27750.0, {.kind = TDSP_GROWTH_LAW, .law = slowing_at, .ctx = &law, .until = 0.592}}};
    tdsp_scene *scene;
    tdsp_solver *solver;
    tdsp_last_departure last;
    assert_int_equal(tdsp_scene_create_growing(&journey, discs, 3, NULL, &scene), TDSP_OK);
    assert_int_equal(tdsp_solver_create(scene, &solver), TDSP_OK);
    assert_int_equal(tdsp_solver_last_departure(solver, &last), TDSP_OK);
    assert_near(last.departure, 0.00145929221595, 1e-11);
    tdsp_solver_free(solver);
    tdsp_scene_free(scene);
}

/* The destination is covered later than doubles say, the source not; or neither is. That nothing grew any more was concluded, and the last departure was 0, or there was none. */
static void a_disc_that_grows_on_beyond_doubles_ends_the_departures_where_it_covers_the_source(void **state)
{
    (void)state;
    static const double times[] = {0.0, 1.0}, rates[] = {2e-306, 1e-306};
    const tdsp_journey journey = {1.0, 0.0, {0.0, 0.0}, {1000.0, 0.0}};
    for (int far = 0; far < 2; far++) {
        const tdsp_growing_disc disc = {{0.0, far ? -1e5 : -1.0}, 1.0 - 0x1p-52, {.kind = TDSP_GROWTH_RATES, .count = 2, .times = times, .values = rates}};
        tdsp_scene *scene;
        tdsp_solver *solver;
        tdsp_last_departure last = {.departure = -1.0};
        assert_int_equal(tdsp_scene_create_growing(&journey, &disc, 1, NULL, &scene), TDSP_OK);
        assert_int_equal(tdsp_solver_create(scene, &solver), TDSP_OK);
        assert_int_equal(tdsp_solver_last_departure(solver, &last), far ? TDSP_NOT_SUPPORTED : TDSP_OK);
        if (!far) assert_int_equal(last.reason, TDSP_SOURCE_COVERED);
        if (!far) assert_near(last.departure / (0x1p-52 / 1e-306), 1.0, 1e-9);
        tdsp_solver_free(solver);
        tdsp_scene_free(scene);
    }
}

/* The source lies where two discs meet, and a third one closes the pocket within a billionth of the journey: the last departure was 0, for want of a gap that explained it. */
static void a_pocket_that_closes_at_once_is_left_until_then(void **state)
{
    (void)state;
    const tdsp_journey journey = {1.0, 0.0, {-1048576.0, 0.0}, {1048576.0, 0.0}};
    const tdsp_disc discs[] = {{{-2097152.0000002095, -2097152.0}, 0.0, 0.125},
                               {{-989753.29963898915, 107885.97833935017}, 122880.0, 0.0},
                               {{-989753.29963898915, -107885.97833935019}, 122880.0, 0.0},
                               {{-1048576.000846517, -0.00061880585923974408}, 0.0, 0.2225}};
    tdsp_scene *scene;
    tdsp_solver *solver;
    tdsp_last_departure last;
    double arrival;
    assert_int_equal(tdsp_scene_create(&journey, discs, 4, NULL, &scene), TDSP_OK);
    assert_int_equal(tdsp_solver_create(scene, &solver), TDSP_OK);
    assert_int_equal(tdsp_solver_last_departure(solver, &last), TDSP_OK);
    assert_int_equal(tdsp_earliest_arrival(solver, last.departure, &arrival), TDSP_OK);
    assert_int_equal(tdsp_earliest_arrival(solver, last.departure + 1e-4, &arrival), TDSP_CUT_OFF);
    tdsp_solver_free(solver);
    tdsp_scene_free(scene);
}

/* What a term does that shows after 1e97 journeys only: nothing. The moment of a cover was halved too few times, and cuts of the law were looked for beside 1e97. */
static void a_law_that_turns_beyond_all_times_is_as_without_that(void **state)
{
    (void)state;
    uint64_t chance = SEED;
    print_message("seed %d\n", SEED);
    const tdsp_journey journey = {1.0, 0.0, {-10.0, 0.0}, {10.0, 0.0}};
    for (int round = 0; round < 100; round++) {
        const double values[4] = {chance_between(&chance, 0.05, 0.3), chance_between(&chance, -0.02, 0.05), chance_between(&chance, 0.004, 0.01), -1e-97};
        const tdsp_point center = {chance_between(&chance, -5.0, 5.0), chance_between(&chance, -4.0, 4.0)};
        double arrivals[2], lasts[2];
        for (int turns = 0; turns < 2; turns++) {
            const tdsp_growing_disc disc = {center, 0.5, {.kind = TDSP_GROWTH_POLYNOMIAL, .count = turns ? 4 : 3, .values = values}};
            tdsp_scene *scene;
            tdsp_solver *solver;
            tdsp_last_departure last = {.departure = -1.0};
            assert_int_equal(tdsp_scene_create_growing(&journey, &disc, 1, NULL, &scene), TDSP_OK);
            assert_int_equal(tdsp_solver_create(scene, &solver), TDSP_OK);
            arrivals[turns] = -1.0;
            assert_true(tdsp_status_is_answer(tdsp_earliest_arrival(solver, 0.0, &arrivals[turns])));
            assert_true(tdsp_status_is_answer(tdsp_solver_last_departure(solver, &last)));
            lasts[turns] = last.departure;
            tdsp_solver_free(solver);
            tdsp_scene_free(scene);
        }
        assert_true(arrivals[0] == arrivals[1] || fabs(arrivals[0] - arrivals[1]) < 1e-9);
        assert_near(lasts[1], lasts[0], 1e-8);
    }
}

/* Around a disc of half a milliard journeys a ride is as long, and a disc on its way is smaller than the least part that was looked at: the path led through it. */
static void a_ride_around_a_vast_disc_does_not_lead_through_a_small_one(void **state)
{
    (void)state;
    const tdsp_journey journey = {1.0, 0.0, {-37000.0, 0.0}, {37000.0, 0.0}};
    for (double vast = 3.7e7; vast < 1e16; vast *= 10.0) {
        const tdsp_growing_disc discs[] = {{{32566.148939832517, 3241.1554602995857}, 5492.1875, {.kind = TDSP_GROWTH_RATE}},
                                           {{37000.0, vast}, vast, {.kind = TDSP_GROWTH_RATE}}};
        tdsp_scene *scene;
        assert_int_equal(tdsp_scene_create_growing(&journey, discs, 2, NULL, &scene), TDSP_OK);
        assert_near(arrival_by(scene, TDSP_METHOD_AUTO, 0.0), 74762.85723213, 1e-6);
        assert_near(arrival_by(scene, TDSP_METHOD_GENERAL, 0.0), 74762.85723213, 1e-6);
        tdsp_scene_free(scene);
    }
}

/* Where rates change, a boundary too small to be ridden stopped straight legs all the same: whoever met it head on had no way, or was early by aiming past it. */
static void a_pebble_too_small_to_go_round_stops_nobody(void **state)
{
    (void)state;
    const tdsp_journey journey = {1.0, 0.0, {-10.0, 3.0}, {10.0, 1.37}};
    static const double values[] = {0.0, 1e-40};
    for (double radius = 1e-13; radius < 1e-9; radius *= 3.0) {
        const tdsp_growing_disc disc = {{0.0, 2.185}, radius, {.kind = TDSP_GROWTH_POLYNOMIAL, .count = 2, .values = values}};
        tdsp_scene *scene;
        assert_int_equal(tdsp_scene_create_growing(&journey, &disc, 1, NULL, &scene), TDSP_OK);
        assert_near(arrival_by(scene, TDSP_METHOD_GENERAL, 1.0), 1.0 + hypot(20.0, 1.63), 1e-9);
        tdsp_scene_free(scene);
    }
}

/* The moment from which on the source would have been covered lay before the least double, and counted as never. */
static void a_source_inside_a_disc_that_hardly_grows_is_covered(void **state)
{
    (void)state;
    const tdsp_journey journey = {9.5367431640625e-07, 0.0, {0.0, 0.0}, {3129344.0, 2080768.0}};
    const tdsp_disc disc = {{0.0, 0.0}, 520192.0, 9.536743165016175e-307};
    double arrival = 0.0;
    tdsp_scene *scene;
    tdsp_solver *solver;
    assert_int_equal(tdsp_scene_create(&journey, &disc, 1, NULL, &scene), TDSP_OK);
    assert_int_equal(tdsp_solver_create(scene, &solver), TDSP_OK);
    assert_int_equal(tdsp_earliest_arrival(solver, 0.0, &arrival), TDSP_SOURCE_COVERED);
    tdsp_solver_free(solver);
    tdsp_scene_free(scene);
}

/* The frame's unit is no less than 1e-12 of the scene: a journey among discs that are farther off than that had no length, and its destination was reached at once. */
static void a_disc_at_the_end_of_the_world_is_refused(void **state)
{
    (void)state;
    const tdsp_journey journey = {1.0, 0.0, {-10.0, 0.0}, {10.0, 0.0}};
    const double away[] = {1.9e13, 2.1e13, 3e58};
    for (int i = 0; i < 3; ++i) {
        const tdsp_disc disc = {{0.0, away[i]}, 1.0, 0.5};
        double arrival = -1.0, latest;
        tdsp_scene *scene;
        tdsp_solver *solver;
        assert_int_equal(tdsp_scene_create(&journey, &disc, 1, NULL, &scene), TDSP_OK);
        for (int method = TDSP_METHOD_SAME_SPEED; method <= TDSP_METHOD_GENERAL; ++method) {
            assert_int_equal(tdsp_solver_create_for(scene, (tdsp_method)method, &solver), TDSP_OK);
            assert_int_equal(tdsp_earliest_arrival(solver, 1.0, &arrival), i > 0 ? TDSP_NOT_SUPPORTED : TDSP_OK);
            assert_near(arrival, i > 0 ? -1.0 : 21.0, 1e-9);
            assert_int_equal(tdsp_latest_departure(solver, 21.0, &latest, NULL), i > 0 ? TDSP_NOT_SUPPORTED : TDSP_OK);
            arrival = -1.0;
            tdsp_solver_free(solver);
        }
        tdsp_scene_free(scene);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_destination_a_hair_beyond_a_boundary_is_not_ridden_past),
        cmocka_unit_test(a_destination_on_the_boundary_of_a_pebble_is_reached),
        cmocka_unit_test(a_source_a_hair_off_a_boundary_is_left_both_ways_round),
        cmocka_unit_test(nobody_leaves_a_vast_disc_from_behind),
        cmocka_unit_test(a_source_where_two_discs_touch_from_inside_is_left_by_both),
        cmocka_unit_test(a_source_where_two_discs_touch_from_inside_is_left_by_both_after_rounding),
        cmocka_unit_test(a_pebble_on_a_boundary_is_no_short_cut_round_the_disc),
        cmocka_unit_test(a_destination_on_a_boundary_is_reached_late_in_time),
        cmocka_unit_test(a_destination_on_a_boundary_is_ridden_onto_tens_of_thousands_of_journeys_late),
        cmocka_unit_test(a_destination_covered_later_than_doubles_say_is_too_far),
        cmocka_unit_test(a_path_at_the_end_of_a_long_wait_does_not_run_backwards),
        cmocka_unit_test(a_destination_behind_a_pebble_that_it_touches_is_ridden_to),
        cmocka_unit_test(a_spiral_out_of_almost_nothing_ends_where_its_angle_says),
        cmocka_unit_test(a_ride_on_a_rate_that_falls_within_a_moment_keeps_to_the_speed),
        cmocka_unit_test(a_point_that_grows_a_hair_from_the_source_covers_it_last),
        cmocka_unit_test(a_ride_around_a_vast_disc_does_not_lead_through_a_small_one),
        cmocka_unit_test(a_pocket_that_closes_at_once_is_left_until_then),
        cmocka_unit_test(a_law_that_turns_beyond_all_times_is_as_without_that),
        cmocka_unit_test(a_disc_that_has_all_but_stopped_does_not_blur_the_last_departure),
        cmocka_unit_test(a_disc_that_grows_on_beyond_doubles_ends_the_departures_where_it_covers_the_source),
        cmocka_unit_test(a_pebble_too_small_to_go_round_stops_nobody),
        cmocka_unit_test(a_source_inside_a_disc_that_hardly_grows_is_covered),
        cmocka_unit_test(a_disc_at_the_end_of_the_world_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
