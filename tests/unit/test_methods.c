/* SPDX-License-Identifier: MIT */
/* The methods of a solver: their names, and the scenes to which each applies. */
#include "support/cmocka_all.h"

#include "tdsp/growth.h"
#include "tdsp/solver.h"

static const tdsp_journey across = {1.0, 0.0, {-3.0, 0.0}, {3.0, 0.0}};

static tdsp_growing_disc of_rate(double x, double y, double radius, double rate)
{
    tdsp_growing_disc disc = {{x, y}, radius, {.kind = TDSP_GROWTH_RATE, .rate = rate}};
    return disc;
}

static tdsp_growing_disc of_powers(double x, double y, double radius, const double *values, size_t count)
{
    tdsp_growing_disc disc = {{x, y}, radius, {.kind = TDSP_GROWTH_POLYNOMIAL, .count = count, .values = values}};
    return disc;
}

static void a_method_has_a_name(void **state)
{
    (void)state;
    assert_string_equal(tdsp_method_name(TDSP_METHOD_AUTO), "auto");
    assert_string_equal(tdsp_method_name(TDSP_METHOD_SAME_SPEED), "same_speed");
    assert_string_equal(tdsp_method_name(TDSP_METHOD_DIFFERENT_SPEEDS), "different_speeds");
    assert_string_equal(tdsp_method_name(TDSP_METHOD_GENERAL), "general");
    assert_string_equal(tdsp_method_name((tdsp_method)9), "unknown");
    assert_int_equal(tdsp_solver_method(NULL), TDSP_METHOD_AUTO);
}

/* Every method from the narrowest that applies on makes a solver, and no other. */
static void methods_from(const tdsp_scene *scene, tdsp_method narrowest)
{
    for (int k = TDSP_METHOD_AUTO; k <= TDSP_METHOD_GENERAL; ++k) {
        tdsp_method method = (tdsp_method)k;
        tdsp_solver *solver = (tdsp_solver *)&method, *untouched = solver;
        tdsp_status status = tdsp_solver_create_for(scene, method, &solver);
        if (method != TDSP_METHOD_AUTO && method < narrowest) {
            assert_int_equal(status, TDSP_NOT_SUPPORTED);
            assert_ptr_equal(solver, untouched);
            continue;
        }
        assert_int_equal(status, TDSP_OK);
        assert_int_equal(tdsp_solver_method(solver), method == TDSP_METHOD_AUTO ? narrowest : method);
        tdsp_solver_free(solver);
    }
}

static void a_method_makes_a_solver_where_it_applies(void **state)
{
    (void)state;
    const double values[2] = {0.1, 0.02}, line[2] = {0.1, 0.0};
    const tdsp_growing_disc one[2] = {of_rate(0.0, 2.0, 1.0, 0.1), of_powers(0.0, -2.0, 1.0, line, 2)};
    const tdsp_growing_disc mixed[2] = {one[0], of_rate(0.0, -2.0, 1.0, 0.2)}, laws[2] = {one[0], of_powers(0.0, -2.0, 1.0, values, 2)};
    const struct {
        const tdsp_growing_disc *discs;
        size_t count;
        tdsp_method narrowest;
    } cases[] = {{one, 2, TDSP_METHOD_SAME_SPEED}, {one, 0, TDSP_METHOD_SAME_SPEED}, {mixed, 2, TDSP_METHOD_DIFFERENT_SPEEDS}, {laws, 2, TDSP_METHOD_GENERAL}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i) {
        tdsp_scene *scene;
        assert_int_equal(tdsp_scene_create_growing(&across, cases[i].discs, cases[i].count, NULL, &scene), TDSP_OK);
        methods_from(scene, cases[i].narrowest);
        tdsp_scene_free(scene);
    }
}

static void a_method_that_is_none_is_refused(void **state)
{
    (void)state;
    tdsp_scene *scene;
    tdsp_solver *solver;
    assert_int_equal(tdsp_scene_create(&across, NULL, 0, NULL, &scene), TDSP_OK);
    assert_int_equal(tdsp_solver_create_for(scene, (tdsp_method)4, &solver), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_solver_create_for(scene, (tdsp_method)-1, &solver), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_solver_create_for(NULL, TDSP_METHOD_AUTO, &solver), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_solver_create_for(scene, TDSP_METHOD_AUTO, NULL), TDSP_INVALID_ARGUMENT);
    tdsp_scene_free(scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_method_has_a_name),
        cmocka_unit_test(a_method_makes_a_solver_where_it_applies),
        cmocka_unit_test(a_method_that_is_none_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
