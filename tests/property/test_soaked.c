/* What the soak (tests/soak) found, each by itself in a scene that its shrinker made. */
#include "support/cmocka_all.h"

#include "tdsp/solver.h"

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

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_robot_that_just_meets_the_disc_that_covers_its_destination_is_no_faster_than_it_can_be),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
