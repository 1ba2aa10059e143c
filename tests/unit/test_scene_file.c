/* SPDX-License-Identifier: MIT */
/* Scene files whose discs grow in any way: what the scene then holds, and what is said of a radius that shrinks. */
#include "support/cmocka_all.h"

#include <string.h>

#include "tdsp/cli.h"
#include "tdsp/growth.h"
#include "tdsp/scene_file.h"

#define WORLD "{\"robot\": {\"speed\": 1}, \"source\": [0, 0], \"destination\": [20, 0], \"discs\": [" DISC("0.1") ", "
#define DISC(growth) "{\"center\": [10, 3], \"radius\": 1, \"growth\": " growth "}"

static SceneFile scene_of(const char *text)
{
    SceneFile scene;
    g_autoptr(GError) error = NULL;
    if (!scene_file_parse("scene.json", text, strlen(text), &scene, &error)) fail_msg("%s", error->message);
    return scene;
}

static void assert_disc_at(const SceneFile *scene, double time, double radius, double rate)
{
    double found_radius, found_rate;
    assert_int_equal(tdsp_scene_disc_at(scene->scene, 1, time, &found_radius, &found_rate), TDSP_OK);
    assert_near(found_radius, radius, 1e-14 * radius);
    assert_near(found_rate, rate, 1e-14);
}

static void coefficients_are_those_of_a_polynomial(void **state)
{
    (void)state;
    g_auto(SceneFile) scene = scene_of(WORLD DISC("[0.5, 0, 0.25]") "]}");
    assert_false(tdsp_scene_has_rates_only(scene.scene));
    assert_disc_at(&scene, 2.0, 1.0 + 1.0 + 2.0, 0.5 + 3.0);
    assert_true(isinf(tdsp_scene_valid_until(scene.scene, NULL)));
}

static void rates_begin_at_their_times(void **state)
{
    (void)state;
    g_auto(SceneFile) scene = scene_of(WORLD DISC("{\"rates\": [0.5, 0, 2], \"times\": [0, 3, 4]}") "]}");
    assert_disc_at(&scene, 1.0, 1.5, 0.5);
    assert_disc_at(&scene, 3.5, 2.5, 0.0);
    assert_disc_at(&scene, 5.0, 4.5, 2.0);
}

static void discs_at_one_rate_make_a_scene_of_rates(void **state)
{
    (void)state;
    g_auto(SceneFile) plain = scene_of(WORLD DISC("0.2") "]}");
    g_auto(SceneFile) scene = scene_of(WORLD DISC("{\"times\": [0, 3], \"rates\": [0.2, 0.2]}") "]}");
    assert_true(tdsp_scene_has_rates_only(scene.scene));
    assert_true(tdsp_scene_hash(scene.scene) == tdsp_scene_hash(plain.scene));
}

static void a_question_beyond_the_time_at_which_a_radius_shrinks_names_file_disc_and_time(void **state)
{
    (void)state;
    g_auto(SceneFile) scene = scene_of(WORLD DISC("[1, -0.002]") "]}");
    g_autoptr(GError) error = NULL;
    assert_near(tdsp_scene_valid_until(scene.scene, NULL), 250.0, 1e-12);
    assert_false(scene_file_fail(&scene, "solver", TDSP_SHRINKS, &error));
    assert_int_equal(error->code, CLI_INPUT);
    assert_string_equal(error->message, "scene.json: discs[1].growth: the radius shrinks after t = 250, and this question reaches beyond");
    g_clear_error(&error);
    assert_false(scene_file_fail(&scene, "solver", TDSP_NO_MEMORY, &error));
    assert_int_equal(error->code, CLI_SYSTEM);
    assert_non_null(strstr(error->message, "solver: "));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(coefficients_are_those_of_a_polynomial),
        cmocka_unit_test(rates_begin_at_their_times),
        cmocka_unit_test(discs_at_one_rate_make_a_scene_of_rates),
        cmocka_unit_test(a_question_beyond_the_time_at_which_a_radius_shrinks_names_file_disc_and_time),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
