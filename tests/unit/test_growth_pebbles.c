/* SPDX-License-Identifier: MIT */
/*
 * Discs so small that, late in time, the rounding of a moment turns a rider by more than the angle between two ways on. Nothing grows here, so that the travel time is the same at
 * all departures, and at 0 a moment is exact.
 */
#include "support/cmocka_all.h"

#include <math.h>

#include "support/chance.h"
#include "tdsp/growth.h"
#include "tdsp/solver.h"

enum { SCENES = 400, MOST_DISCS = 6 };

static const tdsp_journey journey = {1.0, 0.0, {-1.0, 0.0}, {1.0, 0.0}};

static tdsp_solver *solver_among(const tdsp_growing_disc *discs, size_t count, tdsp_scene **scene)
{
    tdsp_solver *solver;
    assert_int_equal(tdsp_scene_create_growing(&journey, discs, count, NULL, scene), TDSP_OK);
    assert_int_equal(tdsp_solver_create_for(*scene, TDSP_METHOD_GENERAL, &solver), TDSP_OK);
    return solver;
}

static double travel_time(tdsp_solver *solver, double departure)
{
    double arrival = INFINITY;
    assert_int_equal(tdsp_earliest_arrival(solver, departure, &arrival), TDSP_OK);
    return arrival - departure;
}

/* Found by fuzzing: the rider was beyond the tangent to its goal as it began to ride, and there was no way. */
static void one_pebble_on_the_way_is_passed_at_every_time(void **state)
{
    (void)state;
    for (double radius = 1e-12; radius < 1e-3; radius *= 10.0) {
        const tdsp_growing_disc pebble = {.center = {-0.75007500000000005, 0.0}, .radius = radius};
        tdsp_scene *scene;
        tdsp_solver *solver = solver_among(&pebble, 1, &scene);
        const double first = travel_time(solver, 0.0);
        for (double departure = 1.1; departure < 1e6; departure *= 4.0) assert_near(travel_time(solver, departure), first, 1e-12 + 0x1p-50 * departure);
        tdsp_solver_free(solver);
        tdsp_scene_free(scene);
    }
}

/* From pebble to pebble one heading misses the next on one side, and the next representable one on the other. */
static void pebbles_in_a_row_are_passed_at_every_time(void **state)
{
    (void)state;
    uint64_t r = 7; /* the seed */
    for (int i = 0; i < SCENES; i++) {
        tdsp_growing_disc discs[MOST_DISCS];
        const size_t count = 1 + (size_t)chance_below(&r, MOST_DISCS);
        for (size_t k = 0; k < count; k++) {
            const double radius = pow(10.0, chance_between(&r, -10.0, -1.0)), x = chance_between(&r, -0.85, 0.85);
            discs[k] = (tdsp_growing_disc){.center = {x, radius * chance_between(&r, -0.9, 0.9)}, .radius = radius};
        }
        tdsp_scene *scene;
        tdsp_solver *solver = solver_among(discs, count, &scene);
        const double first = travel_time(solver, 0.0);
        for (double departure = 1.1; departure < 5e5; departure *= 4.0) assert_near(travel_time(solver, departure), first, 1e-11 + 0x1p-48 * departure);
        tdsp_solver_free(solver);
        tdsp_scene_free(scene);
    }
}

/* Found by fuzzing: a rider of the pebble, 70,000 journeys late, left for the other disc where its rounded time had turned it, and went on from inside of that disc. */
static void a_pebble_aside_changes_nothing_late_in_time(void **state)
{
    (void)state;
    static const double slowing[] = {0.1, 0.001, -1e-5}, starting[] = {0.0, 1e-9};
    const tdsp_journey fast = {2595488.0, 0.0, {-18.0, 0.0}, {20.0, 0.0}};
    const tdsp_growing_disc discs[] = {
        {{7.0, 3.0}, 6.0, {.kind = TDSP_GROWTH_POLYNOMIAL, .count = 3, .values = slowing}},
        {{0.0, -1.0}, 0.0, {.kind = TDSP_GROWTH_POLYNOMIAL, .count = 2, .values = starting}},
    };
    double travel[2];
    for (size_t count = 1; count <= 2; count++) {
        tdsp_scene *scene;
        tdsp_solver *solver;
        assert_int_equal(tdsp_scene_create_growing(&fast, discs, count, NULL, &scene), TDSP_OK);
        assert_int_equal(tdsp_solver_create(scene, &solver), TDSP_OK);
        travel[count - 1] = travel_time(solver, 1.0);
        tdsp_solver_free(solver);
        tdsp_scene_free(scene);
    }
    assert_near(travel[1], travel[0], 0x1p-50);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(one_pebble_on_the_way_is_passed_at_every_time),
        cmocka_unit_test(pebbles_in_a_row_are_passed_at_every_time),
        cmocka_unit_test(a_pebble_aside_changes_nothing_late_in_time),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
