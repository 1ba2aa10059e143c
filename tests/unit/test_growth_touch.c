/* SPDX-License-Identifier: MIT */
/*
 * Where a disc stops growing at the very moment at which its boundary meets a robot: rounding decides which robots get past, and all riders of that moment have to hold to it. The departures
 * are those that the soak found, 1e-12 before a jump.
 */
#include "support/cmocka_all.h"

#include <math.h>

#include "tdsp/growth.h"
#include "tdsp/solver.h"

#define SAME 1e-9

static tdsp_growing_disc stops(double x, double y, double radius, const double *rates, const double *times)
{
    tdsp_growing_disc disc = {{x, y}, radius, {.kind = TDSP_GROWTH_RATES, .count = 2, .values = rates, .times = times}};
    return disc;
}

static double travel_time(const tdsp_journey *journey, const tdsp_growing_disc *discs, size_t count, double departure)
{
    tdsp_scene *scene;
    tdsp_solver *solver;
    double arrival = INFINITY;
    assert_int_equal(tdsp_scene_create_growing(journey, discs, count, NULL, &scene), TDSP_OK);
    assert_int_equal(tdsp_solver_create(scene, &solver), TDSP_OK);
    assert_int_equal(tdsp_earliest_arrival(solver, departure, &arrival), TDSP_OK);
    tdsp_solver_free(solver);
    tdsp_scene_free(scene);
    return arrival - departure;
}

/* A disc faster than the robot stops as it has caught up with it. The second way round was taken for one that had been ridden before: T doubled. */
static void who_is_met_as_the_disc_stops_may_go_either_way_round(void **state)
{
    (void)state;
    static const double rates[] = {1.8752154446655664, 0.0}, times[] = {0.0, 3.2361303691095125};
    const tdsp_journey journey = {1.2800012691157319, 0.0, {0.0, 0.0}, {13.0, 0.66262010400000004}};
    const tdsp_growing_disc disc = stops(0.87764866043783307, -2.1761990252863948, 0.0, rates, times);
    const double before = travel_time(&journey, &disc, 1, 0.3283741826927521);
    assert_near(before, 14.5414838555, SAME);
    assert_near(travel_time(&journey, &disc, 1, 0.32837418269375207), before, 1e-5);
}

/* Between two discs, one of which stops as the gap closes: the rider on the other was let past it, could not change over, and yet kept away those from the other side. */
static void who_is_let_past_a_disc_as_it_stops_may_change_over(void **state)
{
    (void)state;
    static const double first_rates[] = {0.2, 0.0}, first_times[] = {0.0, 3.0}, second_rates[] = {0.9, 0.0}, second_times[] = {0.0, 1.04};
    const tdsp_journey journey = {1.0, 0.0, {0.0, 0.0}, {2.0, 0.0}};
    const tdsp_growing_disc discs[] = {stops(0.4, 0.6, 0.22, first_rates, first_times), stops(1.0, -0.6, 0.0, second_rates, second_times)};
    const double before = travel_time(&journey, discs, 2, 0.29783056549052533), after = travel_time(&journey, discs, 2, 0.29783056550052533);
    const double at = travel_time(&journey, discs, 2, 0.2978305654915253);
    assert_near(before, 2.12387466728, SAME);
    assert_near(after, 3.39039505285, SAME);
    assert_true(fabs(at - before) < SAME || fabs(at - after) < SAME);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(who_is_met_as_the_disc_stops_may_go_either_way_round),
        cmocka_unit_test(who_is_let_past_a_disc_as_it_stops_may_change_over),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
