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

/* Three gentle steps of growth, each a begin, a span and a share of the radius. */
typedef struct steps {
    double begins[3], spans[3], shares[3];
} steps;

static void steps_law(void *ctx, double time, double *radius, double *rate)
{
    const steps *s = ctx;
    *radius = 0.07357401460879455;
    *rate = 0.0;
    for (size_t k = 0; k < 3 && time >= s->begins[k]; k++) {
        const double x = (time - s->begins[k]) / s->spans[k], below = 1.0 + x * x;
        *radius += s->shares[k] * (x * x) / below;
        *rate += s->shares[k] * (2.0 * x) / (below * below * s->spans[k]);
    }
}

/*
 * The disc catches the last robot in the moment in which its rate has fallen to the robot's speed: there its boundary begins to be ridden. The tangent of one side met it a bit after that
 * moment, that of the other, which is faster, in that very moment, and was lost.
 */
static void who_is_caught_as_the_rate_falls_to_the_speed_may_go_either_way_round(void **state)
{
    (void)state;
    static steps s = {{0.86655451332846023, 1.0055530943196314, 1.13300750776959},
                      {0.30503192081023245, 0.31053634642194489, 0.39973435749464686},
                      {0.35364793777855669, 0.082852495766617379, 0.49696933200890497}};
    const tdsp_journey journey = {1.0, 0.0, {0.0, 0.0}, {2.0, 0.0}};
    const tdsp_growing_disc disc = {.center = {0.42904496446947282, 0.04462658804022468},
                                    .radius = 0.07357401460879455,
                                    .growth = {.kind = TDSP_GROWTH_LAW, .law = steps_law, .ctx = &s, .times = s.begins, .count = 3, .until = 32.0}};
    const double before = travel_time(&journey, &disc, 1, 1.2823226713783);
    assert_near(before, 3.45707405, 1e-7);
    assert_near(travel_time(&journey, &disc, 1, 1.2823226713783784), before, 1e-6);
    assert_near(travel_time(&journey, &disc, 1, 1.2823226713783786), before, 1e-6);
}

/* Straight away from the centre is one line, whichever way round the robot goes then: rounding let those past who go one way only. */
static void who_flees_straight_from_a_disc_until_it_stops_may_go_either_way_round(void **state)
{
    (void)state;
    static const double rates[] = {0.0, 1.5785797316726358, 2.1168494839197245, 0.0}, times[] = {0.0, 0.15864136554124392, 0.41284401307123531, 0.52875361120674536};
    const tdsp_journey journey = {1.0, 0.0, {0.0, 0.0}, {-0.60236363286982075, 1.9071334651239991}};
    tdsp_growing_disc disc = stops(-0.52527070773343876, 0.7009603215707132, 0.29427809207597005, rates, times);
    disc.growth.count = 4;
    tdsp_scene *scene;
    tdsp_solver *solver;
    assert_int_equal(tdsp_scene_create_growing(&journey, &disc, 1, NULL, &scene), TDSP_OK);
    assert_int_equal(tdsp_solver_create(scene, &solver), TDSP_OK);
    int past = 0, caught = 0;
    double departure = 0.463763954729675;
    for (int k = 0; k < 200; k++, departure = nextafter(departure, 1.0)) {
        double arrival;
        const tdsp_status status = tdsp_earliest_arrival(solver, departure, &arrival);
        status == TDSP_OK ? ++past : ++caught;
        if (status == TDSP_OK) assert_near(arrival - departure, 2.5960946, 1e-6);
    }
    assert_true(past > 20 && caught > 20);
    tdsp_solver_free(solver);
    tdsp_scene_free(scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(who_is_met_as_the_disc_stops_may_go_either_way_round),
        cmocka_unit_test(who_is_caught_as_the_rate_falls_to_the_speed_may_go_either_way_round),
        cmocka_unit_test(who_is_let_past_a_disc_as_it_stops_may_change_over),
        cmocka_unit_test(who_flees_straight_from_a_disc_until_it_stops_may_go_either_way_round),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
