/* SPDX-License-Identifier: MIT */
/* Other ends among the discs of a prepared scene. */
#include "support/cmocka_all.h"

#include "scene/scene.h"
#include "support/chance.h"
#include "support/world.h"

static const tdsp_journey across = {1.0, 0.0, {-10.0, 0.0}, {10.0, 0.0}};

static tdsp_disc any_disc(uint64_t *chance)
{
    const double radius = chance_between(chance, 0.0, 2.0), growth = chance_below(chance, 4) ? chance_between(chance, 0.0, 1.5) : 0.0;
    return (tdsp_disc){{chance_between(chance, -20.0, 20.0), chance_between(chance, -20.0, 20.0)}, radius, growth};
}

/* When a place is covered first, by looking at every disc. */
static double cover_by_all(const tdsp_disc *discs, size_t count, double robot, tdsp_point place)
{
    double first = INFINITY;
    for (size_t i = 0; i < count; ++i) {
        const double gap = hypot(place.x - discs[i].center.x, place.y - discs[i].center.y) - (discs[i].radius + robot);
        if (discs[i].growth > 0.0) first = fmin(first, gap / discs[i].growth);
        if (discs[i].growth == 0.0 && gap < 0.0) first = fmin(first, -1.0);
    }
    return first;
}

static void a_place_is_covered_when_looking_at_every_disc_says_so(void **state)
{
    (void)state;
    static tdsp_disc discs[400];
    uint64_t chance = 3;
    for (size_t count = 0; count <= 400; count += 1 + count / 4) {
        tdsp_scene *scene;
        const tdsp_journey journey = {1.0, count % 2 ? 0.25 : 0.0, {-3.0, 1.0}, {5.0, -2.0}};
        for (size_t i = 0; i < count; ++i) discs[i] = any_disc(&chance);
        assert_int_equal(tdsp_scene_create(&journey, discs, count, NULL, &scene), TDSP_OK);
        for (int k = 0; k < 100; ++k) {
            const double wide = k % 10 == 0 ? 1e5 : 25.0;
            const tdsp_point place = {chance_between(&chance, -wide, wide), chance_between(&chance, -wide, wide)};
            uint32_t disc;
            const double expected = cover_by_all(discs, count, journey.radius, place), found = tdsp_scene_free_until(scene, place, &disc);
            assert_int_equal(found < 0.0, expected < 0.0);
            if (expected >= 0.0) assert_near(found, expected, 1e-12 * (1.0 + expected));
            assert_int_equal(disc == TDSP_NO_DISC, isinf(expected));
            if (disc != TDSP_NO_DISC) assert_near(cover_by_all(&discs[disc], 1, journey.radius, place), found, 1e-12 * (1.0 + fabs(found)));
        }
        assert_exact(tdsp_scene_free_until(scene, journey.source, NULL), tdsp_scene_source_free_until(scene, NULL));
        assert_exact(tdsp_scene_free_until(scene, journey.destination, NULL), tdsp_scene_destination_free_until(scene, NULL));
        tdsp_scene_free(scene);
    }
}

static void the_hash_for_other_ends_is_that_of_a_scene_with_them(void **state)
{
    (void)state;
    uint64_t chance = 4;
    tdsp_disc discs[20];
    tdsp_scene *scene, *other;
    const tdsp_ends ends = {{1.0, -0.0}, {3.0, 4.0}};
    const tdsp_journey journey = {across.speed, across.radius, ends.source, ends.destination};
    for (size_t i = 0; i < 20; ++i) discs[i] = any_disc(&chance);
    assert_int_equal(tdsp_scene_create(&across, discs, 20, NULL, &scene), TDSP_OK);
    assert_int_equal(tdsp_scene_create(&journey, discs, 20, NULL, &other), TDSP_OK);
    assert_true(tdsp_scene_hash_for(scene, &ends) == tdsp_scene_hash(other));
    assert_true(tdsp_scene_hash_for(scene, NULL) == tdsp_scene_hash(scene));
    assert_true(tdsp_scene_hash(scene) != tdsp_scene_hash(other));
    tdsp_scene_free(other);
    tdsp_scene_free(scene);
}

static const tdsp_disc two_discs[2] = {{{0.0, 3.0}, 1.0, 0.1}, {{0.0, -3.0}, 1.0, 0.1}};

static void asking_about_its_own_ends_changes_no_bit(void **state)
{
    (void)state;
    world w = world_make(across, two_discs, 2);
    const tdsp_ends own = {across.source, across.destination};
    for (double t = 0.0; t < 12.0; t += 1.7) {
        double as_it_is = world_arrival(w, t), found = -1.0;
        assert_true(tdsp_status_is_answer(tdsp_earliest_arrival_for(w.solver, &own, t, &found)));
        assert_exact(found, as_it_is);
        assert_int_equal(tdsp_solver_set_ends(w.solver, &own), TDSP_OK);
        assert_exact(world_arrival(w, t), as_it_is);
        assert_int_equal(tdsp_solver_set_ends(w.solver, NULL), TDSP_OK);
    }
    world_free(w);
}

static void one_question_about_other_ends_leaves_the_solver_with_its_own(void **state)
{
    (void)state;
    world w = world_make(across, two_discs, 2);
    const tdsp_ends up = {{-4.0, 0.0}, {-4.0, 8.0}}, held = {{5.0, 5.0}, {5.0, -5.0}};
    tdsp_ends ends;
    tdsp_leg leg;
    size_t count;
    double arrival, departure, arrives;
    assert_int_equal(tdsp_solver_set_ends(w.solver, &held), TDSP_OK);
    assert_int_equal(tdsp_earliest_arrival_for(w.solver, &up, 2.0, &arrival), TDSP_OK);
    assert_near(arrival, 10.0, 1e-12);
    assert_int_equal(tdsp_solver_path(w.solver, &leg, 1, &count), TDSP_OK);
    assert_memory_equal(&leg.from, &up.source, sizeof leg.from);
    assert_memory_equal(&leg.to, &up.destination, sizeof leg.to);
    assert_int_equal(tdsp_latest_departure_for(w.solver, &up, 9.5, &departure, &arrives), TDSP_OK);
    assert_near(departure, 1.5, 1e-10);
    assert_near(arrives, 9.5, 1e-10);
    assert_int_equal(tdsp_solver_ends(w.solver, &ends), TDSP_OK);
    assert_memory_equal(&ends, &held, sizeof ends);
    assert_near(world_arrival(w, 1.0), 11.0, 1e-12);
    assert_int_equal(tdsp_earliest_arrival_for(w.solver, NULL, 1.0, &arrival), TDSP_OK);
    assert_near(arrival, 21.0, 1e-12);
    world_free(w);
}

static void a_journey_without_length_takes_no_time_wherever_it_is(void **state)
{
    (void)state;
    world w = world_make(across, two_discs, 2);
    const tdsp_ends free = {{3.0, -7.0}, {3.0, -7.0}}, covered = {{0.0, 3.5}, {0.0, 3.5}}, far = {{1e6, 0.0}, {1e6, 0.0}};
    double arrival;
    assert_int_equal(tdsp_earliest_arrival_for(w.solver, &free, 4.0, &arrival), TDSP_OK);
    assert_exact(arrival, 4.0);
    assert_int_equal(tdsp_earliest_arrival_for(w.solver, &far, 4.0, &arrival), TDSP_OK);
    assert_exact(arrival, 4.0);
    assert_int_equal(tdsp_earliest_arrival_for(w.solver, &covered, 0.0, &arrival), TDSP_SOURCE_COVERED);
    assert_true(isinf(arrival));
    world_free(w);
}

/* Once an endless loop: the departure was rounded towards -1 from the wrong side. */
static void an_arrival_long_before_the_first_possible_one_is_too_early_where_nothing_grows(void **state)
{
    (void)state;
    const tdsp_disc wide = {{0.0, 0.0}, 3.0, 0.0};
    world w = world_make(across, &wide, 1);
    uint64_t chance = 6;
    double departure;
    for (int k = 0; k < 100; ++k)
        assert_int_equal(tdsp_latest_departure(w.solver, chance_between(&chance, 0.0, 20.0), &departure, NULL), TDSP_ARRIVAL_TOO_EARLY);
    world_free(w);
}

static void ends_that_cannot_be_asked_about_are_refused_and_change_nothing(void **state)
{
    (void)state;
    world w = world_make(across, two_discs, 2);
    const double bad[] = {NAN, INFINITY, -INFINITY, 2e100};
    tdsp_ends ends = {{0.0, 9.0}, {1.0, 9.0}}, found;
    double time = -7.0;
    assert_int_equal(tdsp_solver_set_ends(NULL, NULL), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_solver_ends(NULL, &found), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_solver_ends(w.solver, NULL), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_earliest_arrival_for(NULL, &ends, 0.0, &time), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_latest_departure_for(NULL, &ends, 0.0, &time, NULL), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_solver_set_ends(w.solver, &ends), TDSP_OK);
    for (int k = 0; k < 16; ++k) {
        double numbers[4] = {0.0, 9.0, 1.0, 9.0};
        numbers[k / 4] = bad[k % 4];
        const tdsp_ends wrong = {{numbers[0], numbers[1]}, {numbers[2], numbers[3]}};
        assert_int_equal(tdsp_solver_set_ends(w.solver, &wrong), TDSP_INVALID_ARGUMENT);
        assert_int_equal(tdsp_earliest_arrival_for(w.solver, &wrong, 0.0, &time), TDSP_INVALID_ARGUMENT);
        assert_int_equal(tdsp_latest_departure_for(w.solver, &wrong, 9.0, &time, NULL), TDSP_INVALID_ARGUMENT);
    }
    const tdsp_ends far = {{0.0, 0.0}, {1048577.0 * 20.0, 0.0}}, near = {{0.0, 0.0}, {1048575.0 * 20.0, 0.0}};
    assert_int_equal(tdsp_solver_set_ends(w.solver, &far), TDSP_NOT_SUPPORTED);
    assert_exact(time, -7.0);
    assert_int_equal(tdsp_solver_ends(w.solver, &found), TDSP_OK);
    assert_memory_equal(&found, &ends, sizeof ends);
    assert_int_equal(tdsp_earliest_arrival_for(w.solver, &near, 0.0, &time), TDSP_OK);
    assert_near(time, 1048575.0 * 20.0, 1e-3);
    world_free(w);
}

static void an_oracle_is_about_the_ends_that_the_solver_holds(void **state)
{
    (void)state;
    world w = world_make(across, two_discs, 2);
    tdsp_oracle oracle;
    double arrival;
    const tdsp_ends up = {{-4.0, 0.0}, {-4.0, 8.0}}, far = {{-400.0, 0.0}, {-400.0, 8.0}};
    assert_int_equal(tdsp_solver_set_ends(w.solver, &up), TDSP_OK);
    assert_int_equal(tdsp_solver_oracle(w.solver, &oracle), TDSP_OK);
    assert_near(oracle.time_scale, 20.0, 1e-12);
    assert_int_equal(oracle.earliest_arrival(oracle.ctx, 1.0, &arrival), TDSP_OK);
    assert_near(arrival, 9.0, 1e-12);
    assert_int_equal(tdsp_solver_set_ends(w.solver, &far), TDSP_OK);
    assert_int_equal(tdsp_solver_oracle(w.solver, &oracle), TDSP_OK);
    assert_near(oracle.time_scale, 400.0, 1e-12);
    world_free(w);
}

static void questions_about_many_ends_need_no_more_and_more_memory(void **state)
{
    (void)state;
    static tdsp_disc discs[300];
    uint64_t chance = 5, early = 0;
    for (size_t i = 0; i < 300; ++i)
        discs[i] = (tdsp_disc){{chance_between(&chance, -10.0, 10.0), chance_between(&chance, -10.0, 10.0)}, 0.15, 0.003};
    world w = world_make(across, discs, 300);
    tdsp_solver_work work;
    for (int k = 0; k < 6000; ++k) {
        const tdsp_ends ends = {{chance_between(&chance, -10.0, 10.0), chance_between(&chance, -10.0, 10.0)},
                                {chance_between(&chance, -10.0, 10.0), chance_between(&chance, -10.0, 10.0)}};
        double arrival;
        assert_true(tdsp_status_is_answer(tdsp_earliest_arrival_for(w.solver, &ends, 0.0, &arrival)));
        assert_int_equal(tdsp_solver_work_done(w.solver, &work), TDSP_OK);
        if (k == 1000) early = work.bytes;
    }
    assert_true(work.bytes <= 2 * early);
    world_free(w);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_place_is_covered_when_looking_at_every_disc_says_so),
        cmocka_unit_test(the_hash_for_other_ends_is_that_of_a_scene_with_them),
        cmocka_unit_test(asking_about_its_own_ends_changes_no_bit),
        cmocka_unit_test(one_question_about_other_ends_leaves_the_solver_with_its_own),
        cmocka_unit_test(a_journey_without_length_takes_no_time_wherever_it_is),
        cmocka_unit_test(an_arrival_long_before_the_first_possible_one_is_too_early_where_nothing_grows),
        cmocka_unit_test(ends_that_cannot_be_asked_about_are_refused_and_change_nothing),
        cmocka_unit_test(an_oracle_is_about_the_ends_that_the_solver_holds),
        cmocka_unit_test(questions_about_many_ends_need_no_more_and_more_memory),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
