/* SPDX-License-Identifier: MIT */
/* The engine for changing rates in crowds, where a scout goes ahead: held against the engine for rates, and against moving the clock. */
#include "support/cmocka_all.h"

#include <string.h>

#include "support/chance.h"
#include "tdsp/growth.h"
#include "tdsp/solver.h"
#include "tdsp/verify.h"

enum { MANY = 120, LEGS = 256 };

static const tdsp_journey across = {1.0, 0.0, {-10.0, 0.0}, {10.0, 0.0}};

static void crowd(uint64_t seed, tdsp_disc *discs)
{
    uint64_t chance = seed;
    for (int i = 0; i < MANY; i++) {
        const tdsp_point center = {chance_between(&chance, -8.0, 8.0), chance_between(&chance, -3.0, 3.0)};
        discs[i] = (tdsp_disc){center, chance_between(&chance, 0.05, 0.25), chance_between(&chance, 0.0, 0.05)};
    }
}

static tdsp_solver *solver_of(const tdsp_scene *scene, tdsp_method method)
{
    tdsp_solver *solver;
    assert_int_equal(tdsp_solver_create_for(scene, method, &solver), TDSP_OK);
    return solver;
}

/* Discs of one rate each have an engine of their own: both find the same arrivals, latest departures, and that there is no way. */
static void both_engines_agree_in_crowds_of_constant_rates(void **state)
{
    (void)state;
    int found = 0, without = 0;
    for (uint64_t seed = 1; seed <= 5; seed++) {
        tdsp_disc discs[MANY];
        tdsp_scene *scene;
        crowd(seed, discs);
        assert_int_equal(tdsp_scene_create(&across, discs, MANY, NULL, &scene), TDSP_OK);
        tdsp_solver *rates = solver_of(scene, TDSP_METHOD_AUTO), *general = solver_of(scene, TDSP_METHOD_GENERAL);
        for (double departure = 0.0; departure < 60.0; departure += 6.0) {
            double one = -1.0, other = -1.0;
            const tdsp_status status = tdsp_earliest_arrival(rates, departure, &one);
            assert_int_equal(tdsp_earliest_arrival(general, departure, &other), status);
            assert_near(other, one, 1e-9 * (1.0 + one));
            found += status == TDSP_OK;
            without += status != TDSP_OK;
        }
        double one = -1.0, other = -1.0;
        assert_int_equal(tdsp_latest_departure(rates, 35.0, &one, NULL), TDSP_OK);
        assert_int_equal(tdsp_latest_departure(general, 35.0, &other, NULL), TDSP_OK);
        assert_near(other, one, 1e-8);
        tdsp_solver_free(rates);
        tdsp_solver_free(general);
        tdsp_scene_free(scene);
    }
    assert_true(found > 5 && without > 5);
}

/* The same crowd with growth that bends: each path is clear, and leaving a little later arrives no earlier. */
static void paths_in_crowds_that_bend_are_clear_and_travel_times_do_not_fall(void **state)
{
    (void)state;
    for (uint64_t seed = 1; seed <= 4; seed++) {
        tdsp_disc discs[MANY];
        tdsp_growing_disc growing[MANY];
        double powers[MANY][2], before = 0.0;
        tdsp_scene *scene;
        memset(growing, 0, sizeof growing);
        crowd(seed, discs);
        for (int i = 0; i < MANY; i++) {
            powers[i][0] = discs[i].growth;
            powers[i][1] = 1e-5;
            growing[i] = (tdsp_growing_disc){
                discs[i].center, discs[i].radius, {.kind = TDSP_GROWTH_POLYNOMIAL, .count = 2, .values = powers[i]}};
        }
        assert_int_equal(tdsp_scene_create_growing(&across, growing, MANY, NULL, &scene), TDSP_OK);
        tdsp_solver *solver = solver_of(scene, TDSP_METHOD_AUTO);
        for (double departure = 0.0; departure < 20.0; departure += 4.0) {
            tdsp_leg legs[LEGS];
            tdsp_verdict verdict;
            double arrival;
            size_t count;
            if (tdsp_earliest_arrival(solver, departure, &arrival) != TDSP_OK) break;
            assert_int_equal(tdsp_solver_path(solver, legs, LEGS, &count), TDSP_OK);
            assert_int_equal(tdsp_verify_path(scene, legs, count, departure, arrival, &verdict), TDSP_OK);
            assert_int_equal(verdict.problems, 0);
            assert_true(arrival - departure >= before - 1e-9);
            before = arrival - departure;
        }
        tdsp_solver_free(solver);
        tdsp_scene_free(scene);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(both_engines_agree_in_crowds_of_constant_rates),
        cmocka_unit_test(paths_in_crowds_that_bend_are_clear_and_travel_times_do_not_fall),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
