/* SPDX-License-Identifier: MIT */
/* Legs that leave a ride: where a sign is neither above nor below zero. */
#include "support/cmocka_all.h"

#include "tdsp/solver.h"

/* A rider who lands on the second of three discs in a row stands on its tangent to the third to the bit: the leg is left there and then. */
static void a_common_tangent_of_a_row_of_discs_is_left_where_it_lands(void **state)
{
    (void)state;
    const tdsp_journey journey = {1.0, 0.0, {-1.0, 0.0}, {1.0, 0.0}};
    const double rate = 0.21354412825114386;
    const tdsp_disc discs[3] = {{{-0.5, 0.0}, 0.25, rate}, {{-0.25, 0.0}, 0.25, rate}, {{0.0, 0.0}, 0.25, rate}};
    tdsp_scene *scene;
    tdsp_solver *general, *other;
    assert_int_equal(tdsp_scene_create(&journey, discs, 3, NULL, &scene), TDSP_OK);
    assert_int_equal(tdsp_solver_create_for(scene, TDSP_METHOD_GENERAL, &general), TDSP_OK);
    assert_int_equal(tdsp_solver_create(scene, &other), TDSP_OK);
    for (int i = 0; i < 600; i++) {
        double found, expected;
        assert_int_equal(tdsp_earliest_arrival(general, 0.001 * i, &found), TDSP_OK);
        assert_int_equal(tdsp_earliest_arrival(other, 0.001 * i, &expected), TDSP_OK);
        assert_near(found, expected, 1e-12);
    }
    tdsp_solver_free(general);
    tdsp_solver_free(other);
    tdsp_scene_free(scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_common_tangent_of_a_row_of_discs_is_left_where_it_lands),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
