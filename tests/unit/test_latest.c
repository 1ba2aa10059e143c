/* SPDX-License-Identifier: MIT */
/* Latest departures against bisection on A, and their statuses. */
#include "support/cmocka_all.h"

#include "support/chance.h"
#include "support/random_scene.h"
#include "support/world.h"
#include "tdsp/solver.h"
#include "tdsp/verify.h"

enum { LEGS = 256, DISCS = 12 };

/* sup { t : A(t) <= a } by halving; negative when there is none. */
static double bisected(world w, double a)
{
    double lo = 0.0, hi = a;
    if (!(world_arrival(w, 0.0) <= a)) return -1.0;
    for (int step = 0; step < 50; ++step) {
        double middle = 0.5 * (lo + hi);
        *(world_arrival(w, middle) <= a ? &lo : &hi) = middle;
    }
    return lo;
}

static void check_inverse(world w, double a)
{
    double departure = -1.0, arrives = -1.0, slack = 1e-8 * (w.unit + a);
    tdsp_status status = tdsp_latest_departure(w.solver, a, &departure, &arrives);
    if (status == TDSP_ARRIVAL_TOO_EARLY) {
        assert_true(world_arrival(w, 0.0) > a - slack);
        return;
    }
    if (status != TDSP_OK) {
        assert_true(isinf(world_arrival(w, 0.0)));
        return;
    }
    tdsp_leg legs[LEGS];
    size_t count;
    tdsp_verdict verdict;
    assert_int_equal(tdsp_solver_path(w.solver, legs, LEGS, &count), TDSP_OK);
    assert_int_equal(tdsp_verify_path(w.scene, legs, count, departure, arrives, &verdict), TDSP_OK);
    assert_int_equal(verdict.problems, 0);
    assert_true(arrives >= departure && arrives <= a);
    assert_near(world_arrival(w, departure), arrives, slack);
    assert_near(departure, fmax(bisected(w, a), 0.0), slack);
}

static void random_scenes_agree_with_bisection(void **state)
{
    (void)state;
    uint64_t chance = 1;
    for (int mix = 0; mix < RANDOM_MIX_COUNT; ++mix)
        for (uint64_t seed = 0; seed < 8; ++seed) {
            tdsp_disc discs[DISCS];
            tdsp_journey journey;
            random_scene(seed, (random_mix)mix, DISCS, &journey, discs);
            world w = world_make(journey, discs, DISCS);
            for (int k = 0; k < 4; ++k) check_inverse(w, w.unit * chance_between(&chance, 0.9, 5.0));
            world_free(w);
        }
}

static void the_inverse_undoes_the_arrival(void **state)
{
    (void)state;
    for (int mix = 0; mix < RANDOM_MIX_COUNT; ++mix)
        for (uint64_t seed = 20; seed < 26; ++seed) {
            tdsp_disc discs[DISCS];
            tdsp_journey journey;
            random_scene(seed, (random_mix)mix, DISCS, &journey, discs);
            world w = world_make(journey, discs, DISCS);
            for (int k = 0; k < 4; ++k) {
                double t = 0.3 * k * w.unit, a = world_arrival(w, t), departure = -1.0;
                if (isinf(a)) break;
                tdsp_status status = tdsp_latest_departure(w.solver, a, &departure, NULL);
                if (status == TDSP_ARRIVAL_TOO_EARLY) assert_int_equal(k, 0);
                if (status == TDSP_OK) assert_true(departure >= t - 1e-9 * (w.unit + a));
            }
            world_free(w);
        }
}

static const tdsp_journey across = {1.0, 0.0, {-10.0, 0.0}, {10.0, 0.0}};
static const tdsp_disc gap[2] = {{{0.0, 3.0}, 1.0, 0.1}, {{0.0, -3.0}, 1.0, 0.1}};

static void too_early_an_arrival_is_told_and_touches_nothing(void **state)
{
    (void)state;
    double departure = 77.0, arrives = 77.0;
    world w = world_make(across, gap, 2);
    assert_int_equal(tdsp_latest_departure(w.solver, 0.0, &departure, &arrives), TDSP_ARRIVAL_TOO_EARLY);
    assert_int_equal(tdsp_latest_departure(w.solver, 19.99, &departure, &arrives), TDSP_ARRIVAL_TOO_EARLY);
    assert_true(departure == 77.0 && arrives == 77.0);
    size_t count;
    assert_int_equal(tdsp_solver_path(w.solver, NULL, 0, &count), TDSP_NO_ANSWER);
    assert_int_equal(tdsp_latest_departure(w.solver, 20.0, &departure, NULL), TDSP_OK);
    assert_near(departure, 0.0, 1e-12);
    world_free(w);
}

static void without_a_way_the_reason_is_told(void **state)
{
    (void)state;
    const tdsp_disc on_source = {{-10.0, 0.5}, 1.0, 0.0}, on_destination = {{10.0, 5.0}, 1.0, 0.25};
    double departure = 77.0;
    world w = world_make(across, &on_source, 1);
    assert_int_equal(tdsp_latest_departure(w.solver, 50.0, &departure, NULL), TDSP_SOURCE_COVERED);
    world_free(w);
    w = world_make(across, &on_destination, 1);
    assert_int_equal(tdsp_latest_departure(w.solver, 50.0, &departure, NULL), TDSP_DESTINATION_COVERED);
    assert_int_equal(tdsp_latest_departure(w.solver, INFINITY, &departure, NULL), TDSP_DESTINATION_COVERED);
    assert_true(departure == 77.0);
    world_free(w);
}

static void an_arrival_past_the_last_answers_the_last_departure(void **state)
{
    (void)state;
    double departure = -1.0, arrives = -1.0, again = -1.0;
    tdsp_last_departure last;
    world w = world_make(across, gap, 2);
    assert_int_equal(tdsp_solver_last_departure(w.solver, &last), TDSP_OK);
    assert_int_equal(tdsp_latest_departure(w.solver, 1e6, &departure, &arrives), TDSP_OK);
    assert_near(departure, last.departure, 1e-8 * last.departure);
    assert_near(arrives, last.arrival, 1e-8 * last.arrival);
    assert_int_equal(tdsp_latest_departure(w.solver, INFINITY, &again, NULL), TDSP_OK);
    assert_exact(again, departure);
    assert_true(isfinite(world_arrival(w, last.departure)));
    assert_true(isinf(world_arrival(w, last.departure + 1e-6)));
    world_free(w);
}

static void where_nothing_ends_departures_the_last_is_infinite(void **state)
{
    (void)state;
    const tdsp_disc standing = {{0.0, 0.0}, 3.0, 0.0};
    double departure = -1.0, arrives = -1.0;
    tdsp_last_departure last;
    for (size_t count = 0; count < 2; ++count) {
        world w = world_make(across, &standing, count);
        assert_int_equal(tdsp_latest_departure(w.solver, INFINITY, &departure, &arrives), TDSP_OK);
        assert_true(isinf(departure) && isinf(arrives));
        assert_int_equal(tdsp_solver_last_departure(w.solver, &last), TDSP_OK);
        assert_true(isinf(last.departure));
        assert_int_equal(last.reason, TDSP_OK);
        assert_int_equal(last.disc, TDSP_NO_DISC);
        double travel = world_arrival(w, 0.0);
        assert_int_equal(tdsp_latest_departure(w.solver, 1000.0, &departure, &arrives), TDSP_OK);
        assert_near(departure, 1000.0 - travel, 1e-9);
        world_free(w);
    }
}

static void each_end_of_departures_is_named_with_its_disc_and_moment(void **state)
{
    (void)state;
    const tdsp_disc at_source[2] = {{{-10.0, 4.0}, 1.0, 0.1}, {{-10.0, -5.0}, 1.0, 0.1}};
    const tdsp_disc at_destination[2] = {{{10.0, 9.0}, 1.0, 0.1}, {{10.0, -5.0}, 1.0, 0.1}};
    tdsp_last_departure last;
    world w = world_make(across, at_source, 2);
    assert_int_equal(tdsp_solver_last_departure(w.solver, &last), TDSP_OK);
    assert_int_equal(last.reason, TDSP_SOURCE_COVERED);
    assert_int_equal(last.disc, 0);
    assert_near(last.time, 30.0, 1e-12);
    assert_near(last.departure, 30.0, 1e-9);
    assert_near(last.place.x, -10.0, 0.0);
    world_free(w);
    w = world_make(across, at_destination, 2);
    assert_int_equal(tdsp_solver_last_departure(w.solver, &last), TDSP_OK);
    assert_int_equal(last.reason, TDSP_DESTINATION_COVERED);
    assert_int_equal(last.disc, 1);
    assert_near(last.time, 40.0, 1e-12);
    assert_near(last.arrival, 40.0, 1e-9);
    world_free(w);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(random_scenes_agree_with_bisection),
        cmocka_unit_test(the_inverse_undoes_the_arrival),
        cmocka_unit_test(too_early_an_arrival_is_told_and_touches_nothing),
        cmocka_unit_test(without_a_way_the_reason_is_told),
        cmocka_unit_test(an_arrival_past_the_last_answers_the_last_departure),
        cmocka_unit_test(where_nothing_ends_departures_the_last_is_infinite),
        cmocka_unit_test(each_end_of_departures_is_named_with_its_disc_and_moment),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
