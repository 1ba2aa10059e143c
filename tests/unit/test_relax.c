/* SPDX-License-Identifier: MIT */
/* Asking few discs first gives the answers of asking all. */
#include "support/cmocka_all.h"

#include "search/solver.h"
#include "support/chance.h"
#include "support/random_scene.h"
#include "support/world.h"

enum { FAR = 80, NEAR = 20, CROWD = 300 };

static uint64_t rounds(world w)
{
    tdsp_solver_work work;
    assert_int_equal(tdsp_solver_work_done(w.solver, &work), TDSP_OK);
    return work.rounds;
}

static double arrival(world w, double departure, tdsp_status *status)
{
    double found = -1.0;
    *status = tdsp_earliest_arrival(w.solver, departure, &found);
    assert_true(tdsp_status_is_answer(*status));
    return found;
}

static void assert_same_arrival(world a, world b, double departure)
{
    tdsp_status first, second;
    double x = arrival(a, departure, &first), y = arrival(b, departure, &second);
    assert_int_equal(first, second);
    assert_near(x, y, 1e-10 * (a.scene->time + fabs(x)));
}

static void assert_same_departure(world a, world b, double time)
{
    double x = -1.0, y = -1.0;
    assert_int_equal(tdsp_latest_departure(a.solver, time, &x, NULL), tdsp_latest_departure(b.solver, time, &y, NULL));
    assert_near(x, y, 1e-8 * (a.scene->time + fabs(x)));
}

/* The same scene with discs far away that matter to nobody, so many that few are asked first. */
static size_t with_far_discs(const tdsp_disc *discs, size_t count, const tdsp_journey *journey, tdsp_disc *out)
{
    double unit = hypot(journey->destination.x - journey->source.x, journey->destination.y - journey->source.y);
    for (size_t i = 0; i < count; ++i) out[i] = discs[i];
    for (int i = 0; i < FAR; ++i) {
        tdsp_disc disc = {{journey->source.x + unit * (1000.0 + i), journey->source.y + unit * (500.0 - 7.0 * i)}, 0.1 * unit, 0.0};
        out[count++] = disc;
    }
    return count;
}

static void discs_far_away_change_no_answer(void **state)
{
    (void)state;
    uint64_t chance = 1;
    for (int mix = 0; mix < RANDOM_MIX_COUNT; ++mix) {
        if (mix == RANDOM_FAR_ORIGIN || mix == RANDOM_ON_SOURCE || mix == RANDOM_ON_DESTINATION || mix == RANDOM_TOUCHING) continue; /* a larger extent rounds them otherwise */
        for (uint64_t seed = 0; seed < 12; ++seed) {
            tdsp_disc discs[NEAR], more[NEAR + FAR];
            tdsp_journey journey;
            random_scene(seed, (random_mix)mix, NEAR, &journey, discs);
            world few = world_make(journey, discs, NEAR);
            world many = world_make(journey, more, with_far_discs(discs, NEAR, &journey, more));
            double unit = few.scene->time, free = fmin(tdsp_scene_source_free_until(few.scene, NULL), 2.0 * unit);
            assert_same_arrival(few, many, 0.0);
            assert_same_arrival(few, many, free * chance_between(&chance, 0.0, 0.9));
            assert_same_departure(few, many, unit * chance_between(&chance, 1.0, 4.0));
            assert_int_equal(rounds(few), 0);
            assert_true(rounds(many) > 0);
            world_free(few);
            world_free(many);
        }
    }
}

static double direct(world w, double departure)
{
    double found = INFINITY;
    tdsp_status status = solver_forward(w.solver, &w.scene->all, departure, INFINITY, &found);
    assert_true(tdsp_status_is_answer(status));
    return status == TDSP_OK ? found : INFINITY;
}

static void a_crowd_is_crossed_as_when_all_are_asked_at_once(void **state)
{
    (void)state;
    const tdsp_journey journey = {1.0, 0.0, {-12.0, 0.0}, {12.0, 0.0}};
    uint64_t chance = 2;
    for (int k = 0; k < 25; ++k) {
        static tdsp_disc discs[CROWD];
        double rate = chance_between(&chance, 0.0, 0.1);
        for (int i = 0; i < CROWD; ++i) {
            tdsp_disc disc = {{chance_between(&chance, -10.0, 10.0), chance_between(&chance, -10.0, 10.0)}, chance_between(&chance, 0.05, 0.3),
                              k % 2 ? rate : chance_between(&chance, 0.0, 0.1)};
            discs[i] = disc;
        }
        world w = world_make(journey, discs, CROWD);
        for (double departure = 0.0; departure < 5.0; departure += 1.7) {
            tdsp_status status;
            assert_near(arrival(w, departure, &status), direct(w, departure), 1e-10 * (24.0 + departure));
        }
        assert_true(rounds(w) > 0);
        world_free(w);
    }
}

static void an_answer_does_not_depend_on_the_questions_before(void **state)
{
    (void)state;
    const tdsp_journey journey = {1.0, 0.0, {-12.0, 0.0}, {12.0, 0.0}};
    static tdsp_disc discs[CROWD];
    uint64_t chance = 3;
    for (int i = 0; i < CROWD; ++i) {
        tdsp_disc disc = {{chance_between(&chance, -10.0, 10.0), chance_between(&chance, -10.0, 10.0)}, 0.2, chance_between(&chance, 0.0, 0.05)};
        discs[i] = disc;
    }
    world busy = world_make(journey, discs, CROWD);
    for (int k = 0; k < 10; ++k) {
        tdsp_status a, b;
        world fresh = world_make(journey, discs, CROWD);
        double departure = chance_between(&chance, 0.0, 3.0);
        assert_exact(arrival(busy, departure, &a), arrival(fresh, departure, &b));
        assert_int_equal(a, b);
        world_free(fresh);
    }
    world_free(busy);
}

static void a_sealed_source_is_found_out_among_the_discs_that_seal_it(void **state)
{
    (void)state;
    const tdsp_journey journey = {1.0, 0.0, {0.0, 0.0}, {50.0, 0.0}};
    static tdsp_disc discs[CROWD];
    uint64_t chance = 4;
    for (int i = 0; i < CROWD; ++i) {
        tdsp_disc ring = {{4.0 * cos(i * 0.3), 4.0 * sin(i * 0.3)}, 0.7, 0.0};
        tdsp_disc away = {{chance_between(&chance, 10.0, 45.0), chance_between(&chance, -20.0, 20.0)}, 0.3, 0.01};
        discs[i] = i < 21 ? ring : away;
    }
    tdsp_status status;
    world w = world_make(journey, discs, CROWD);
    assert_true(isinf(arrival(w, 0.0, &status)));
    assert_int_equal(status, TDSP_CUT_OFF);
    tdsp_solver_work work;
    assert_int_equal(tdsp_solver_work_done(w.solver, &work), TDSP_OK);
    assert_true(work.rounds > 0);
    world_free(w);
}

static void the_last_departure_names_the_users_discs(void **state)
{
    (void)state;
    /* Two walls far up and down leave one gap, between the discs 70 and 71. */
    const tdsp_journey journey = {1.0, 0.0, {-10.0, 0.0}, {10.0, 0.0}};
    static tdsp_disc discs[102];
    for (int i = 0; i < 102; ++i) {
        tdsp_disc away = {{500.0 + 3.0 * i, 0.0}, 1.0, 0.0};
        discs[i] = away;
    }
    tdsp_disc up = {{0.0, 3.0}, 1.0, 0.1}, down = {{0.0, -3.0}, 1.0, 0.1};
    discs[70] = up;
    discs[71] = down;
    for (int i = 0; i < 15; ++i) {
        tdsp_disc wall = {{0.0, 5.0 + 2.5 * i}, 1.8, 0.1}, other = {{0.0, -5.0 - 2.5 * i}, 1.8, 0.1};
        discs[i] = wall;
        discs[72 + i] = other;
    }
    world w = world_make(journey, discs, 102);
    tdsp_last_departure last;
    assert_int_equal(tdsp_solver_last_departure(w.solver, &last), TDSP_OK);
    assert_true(isfinite(last.departure) && last.departure > 9.0);
    if (last.reason == TDSP_CUT_OFF) assert_true(last.disc < 102 && last.other < 102 && last.disc != last.other);
    tdsp_status status;
    assert_true(isfinite(arrival(w, last.departure * (1.0 - 1e-9), &status)));
    assert_true(isinf(arrival(w, last.departure + 1e-6, &status)));
    assert_int_equal(status, last.reason);
    world_free(w);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(discs_far_away_change_no_answer),
        cmocka_unit_test(a_crowd_is_crossed_as_when_all_are_asked_at_once),
        cmocka_unit_test(an_answer_does_not_depend_on_the_questions_before),
        cmocka_unit_test(a_sealed_source_is_found_out_among_the_discs_that_seal_it),
        cmocka_unit_test(the_last_departure_names_the_users_discs),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
