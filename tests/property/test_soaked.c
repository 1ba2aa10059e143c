/* SPDX-License-Identifier: MIT */
/* What the soak (tests/soak) found, each by itself in a scene that its shrinker made. */
#include "support/cmocka_all.h"

#include "tdsp/growth.h"
#include "tdsp/solver.h"
#include "tdsp/verify.h"

static tdsp_solver *solver_for(const tdsp_scene *scene, tdsp_method method)
{
    tdsp_solver *solver;
    assert_int_equal(tdsp_solver_create_for(scene, method, &solver), TDSP_OK);
    return solver;
}

/*
 * The disc comes from so far away that 1e-12 of the time until it covers the destination was 1e-7 of the journey's: robots too late by that much were told to
 * arrive in the moment of the cover, faster than they can be.
 */
static void a_robot_that_just_meets_the_disc_that_covers_its_destination_is_no_faster_than_it_can_be(void **state)
{
    (void)state;
    const tdsp_disc disc = {{151009.61919618174, -7410.9763499999999}, 3034.0637439000002, 0.73926549263600005};
    const tdsp_journey journey = {1.0, 0.0, {0.0, 0.0}, {2.0, 0.0}};
    tdsp_scene *scene;
    assert_int_equal(tdsp_scene_create(&journey, &disc, 1, NULL, &scene), TDSP_OK);
    const double last = tdsp_scene_destination_free_until(scene, NULL) - 2.0;
    for (int general = 0; general < 2; general++) {
        tdsp_solver *solver = solver_for(scene, general ? TDSP_METHOD_GENERAL : TDSP_METHOD_AUTO);
        for (int i = -20; i <= 20; i++) {
            const double departure = last + i * 1e-8, slack = 1e-11 + 0x1p-50 * last;
            double arrival;
            const tdsp_status status = tdsp_earliest_arrival(solver, departure, &arrival);
            assert_int_equal(status, i <= 0 ? TDSP_OK : TDSP_DESTINATION_COVERED);
            assert_true(arrival - departure >= 2.0 - slack);
        }
        tdsp_solver_free(solver);
    }
    tdsp_scene_free(scene);
}

/*
 * The last robot changes over from one disc to another that touches it, to within 6e-12: the first curve on the second disc is so short that this was a share of more than
 * 1e-9 of it, and the verifier called it too fast.
 */
static void a_path_that_changes_over_between_discs_that_touch_is_accepted(void **state)
{
    (void)state;
    static const double slow[] = {0, 1.5, -0.962, 0.297, -0.052, 0.0054, -0.000303, 7e-06};
    static const double late[] = {0, 0, 0, 0.29, -0.178542, 0.04279, -0.004687, 0.0002};
    const tdsp_growing_disc discs[] = {
        {.center = {0.0, -2.0}, .growth = {.kind = TDSP_GROWTH_POLYNOMIAL, .count = 8, .values = slow}},
        {.center = {-0.8, 1.6}, .radius = 0.04, .growth = {.kind = TDSP_GROWTH_POLYNOMIAL, .count = 8, .values = late}}};
    const tdsp_journey journey = {1.0, 0.0, {0.0, 0.0}, {2.0, 0.0}};
    tdsp_leg legs[64];
    size_t count;
    tdsp_verdict verdict;
    double departure, arrives;
    tdsp_scene *scene;
    assert_int_equal(tdsp_scene_create_growing(&journey, discs, 2, NULL, &scene), TDSP_OK);
    tdsp_solver *solver = solver_for(scene, TDSP_METHOD_AUTO);
    assert_int_equal(tdsp_latest_departure(solver, 4.4, &departure, &arrives), TDSP_OK);
    assert_int_equal(tdsp_solver_path(solver, legs, 64, &count), TDSP_OK);
    assert_int_equal(tdsp_verify_path(scene, legs, count, departure, arrives, &verdict), TDSP_OK);
    assert_int_equal(verdict.problems, 0);
    tdsp_solver_free(solver);
    tdsp_scene_free(scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_robot_that_just_meets_the_disc_that_covers_its_destination_is_no_faster_than_it_can_be),
        cmocka_unit_test(a_path_that_changes_over_between_discs_that_touch_is_accepted),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
