/* SPDX-License-Identifier: MIT */
/* Margins in closed form, what limits them, and their ends. */
#include "support/cmocka_all.h"

#include <string.h>

#include "support/tight.h"
#include "support/world.h"
#include "tdsp/growth.h"
#include "tdsp/margin.h"
#include "tdsp/verify.h"

static const tdsp_journey across = {1.0, 0.0, {-10.0, 0.0}, {10.0, 0.0}};
static const tdsp_disc gap[2] = {{{0.0, 3.0}, 1.0, 0.1}, {{0.0, -3.0}, 1.0, 0.1}};

/*
 * The rate at which the gap of two discs like `gap` is passed for the last time by a robot that leaves at t: its corner, as fast as the robot, has the radius
 * R = 3 / sqrt(1 - V^2) and is V R past the middle. From (R - 1) / V = t + 10 + V R follows 3 sqrt(1 - V^2) = 1 + V (t + 10).
 */
static double gap_rate(double t)
{
    const double b = t + 10.0;
    return (sqrt(b * b + 8.0 * (b * b + 9.0)) - b) / (b * b + 9.0);
}

static tdsp_margin departure_margin(world w, tdsp_raise how, double departure, double deadline)
{
    tdsp_margin margin;
    assert_int_equal(tdsp_departure_margin(w.scene, how, departure, deadline, &margin), TDSP_OK);
    return margin;
}

/* Of the fastest path. */
static tdsp_margin path_margin(world w, tdsp_raise how, double departure)
{
    tdsp_leg legs[64];
    size_t count;
    tdsp_margin margin;
    assert_true(world_arrival(w, departure) < INFINITY);
    assert_int_equal(tdsp_solver_path(w.solver, legs, 64, &count), TDSP_OK);
    assert_int_equal(tdsp_path_margin(w.scene, how, legs, count, departure, &margin), TDSP_OK);
    return margin;
}

static void a_closing_gap_limits_by_its_closed_form(void **state)
{
    (void)state;
    world w = world_make(across, gap, 2);
    const double departures[] = {0.0, 1.0, 5.0, 9.0, 9.8};
    for (size_t i = 0; i < 5; i++) {
        const double t = departures[i], rate = gap_rate(t);
        tdsp_margin m = departure_margin(w, TDSP_RAISE_FACTOR, t, t + 20.0);
        assert_near(m.most, rate / 0.1, 1e-10);
        m = departure_margin(w, TDSP_RAISE_ADDED, t, t + 20.0);
        assert_near(m.most, rate - 0.1, 1e-11);
        m = path_margin(w, TDSP_RAISE_FACTOR, t);
        assert_near(m.most, rate / 0.1, 1e-12);
        assert_int_equal(m.witness.limit, TDSP_LIMIT_TOUCH);
        assert_near(m.witness.time, t + 10.0 + m.witness.place.x, 1e-9);
        assert_near(path_margin(w, TDSP_RAISE_ADDED, t).most, rate - 0.1, 1e-13);
    }
    const tdsp_margin m = departure_margin(w, TDSP_RAISE_FACTOR, 9.0, 29.5);
    assert_near(m.most, gap_rate(9.0) / 0.1, 1e-10);
    assert_int_equal(m.witness.limit, TDSP_LIMIT_GAP);
    assert_int_equal(m.witness.disc, 0);
    assert_int_equal(m.witness.other, 1);
    assert_near(m.witness.time, 19.0 + m.witness.place.x, 1e-8);
    assert_near(m.arrival, 29.0, 1e-9);
    world_free(w);
}

static void covers_limit_by_their_closed_forms(void **state)
{
    (void)state;
    const tdsp_disc at_source[2] = {{{-10.0, 4.0}, 1.0, 0.1}, {{-10.0, -5.0}, 1.0, 0.1}};
    const tdsp_disc at_destination[2] = {{{10.0, 9.0}, 1.0, 0.1}, {{10.0, -5.0}, 1.0, 0.1}};
    world w = world_make(across, at_source, 2);
    tdsp_margin m = departure_margin(w, TDSP_RAISE_FACTOR, 10.0, INFINITY);
    assert_near(m.most, 3.0, 1e-11);
    assert_int_equal(m.witness.limit, TDSP_LIMIT_SOURCE_COVERED);
    assert_int_equal(m.witness.disc, 0);
    assert_near(m.witness.time, 10.0, 1e-9);
    assert_near(departure_margin(w, TDSP_RAISE_ADDED, 10.0, INFINITY).most, 0.2, 1e-12);
    assert_near(departure_margin(w, TDSP_RAISE_FACTOR, 60.0, INFINITY).most, 0.5, 1e-11);
    assert_near(departure_margin(w, TDSP_RAISE_ADDED, 60.0, INFINITY).most, -0.05, 1e-12);
    world_free(w);
    w = world_make(across, at_destination, 2);
    m = departure_margin(w, TDSP_RAISE_FACTOR, 5.0, INFINITY);
    assert_near(m.most, 1.6, 1e-11);
    assert_int_equal(m.witness.limit, TDSP_LIMIT_DESTINATION_COVERED);
    assert_int_equal(m.witness.disc, 1);
    assert_near(m.arrival, 25.0, 1e-10);
    assert_near(path_margin(w, TDSP_RAISE_FACTOR, 5.0).most, 1.6, 1e-12);
    world_free(w);
}

static void a_path_that_rides_a_growing_disc_has_nothing_to_spare(void **state)
{
    (void)state;
    world w = world_make(across, gap, 2);
    assert_exact(path_margin(w, TDSP_RAISE_FACTOR, 12.0).most, 1.0);
    const tdsp_margin m = path_margin(w, TDSP_RAISE_ADDED, 12.0);
    assert_exact(m.most, 0.0);
    assert_int_equal(m.witness.limit, TDSP_LIMIT_TOUCH);
    world_free(w);
}

static void a_path_that_rides_a_disc_that_stands_still_has_something_to_spare_for_a_factor_only(void **state)
{
    (void)state;
    const tdsp_disc discs[2] = {{{0.0, 0.0}, 2.0, 0.0}, {{0.0, 9.0}, 1.0, 0.05}};
    world w = world_make(across, discs, 2);
    const tdsp_margin m = path_margin(w, TDSP_RAISE_FACTOR, 0.0);
    assert_true(m.most > 1.0 && m.most < INFINITY);
    assert_int_equal(m.witness.disc, 1);
    assert_exact(path_margin(w, TDSP_RAISE_ADDED, 0.0).most, 0.0);
    world_free(w);
}

static void what_no_rate_below_the_cap_can_reach_is_unlimited(void **state)
{
    (void)state;
    const tdsp_disc discs[2] = {{{0.0, 100.0}, 1.0, 0.1}, {{0.0, -200.0}, 1.0, 3.0}};
    for (size_t count = 0; count <= 2; count++) {
        world w = world_make(across, discs, count);
        for (int how = 0; how < 2; how++) {
            tdsp_margin m = departure_margin(w, (tdsp_raise)how, 1.0, INFINITY);
            assert_near(m.most, INFINITY, 0);
            assert_near(m.arrival, 21.0, 1e-10);
            assert_int_equal(m.witness.limit, TDSP_LIMIT_NONE);
            m = path_margin(w, (tdsp_raise)how, 1.0);
            assert_near(m.most, INFINITY, 0);
            assert_int_equal(m.witness.limit, TDSP_LIMIT_NONE);
        }
        world_free(w);
    }
}

static void what_fails_without_any_growth_has_no_margin_and_says_why(void **state)
{
    (void)state;
    const tdsp_disc on_source = {{-10.0, 0.5}, 1.0, 0.1};
    world w = world_make(across, &on_source, 1);
    tdsp_margin m = departure_margin(w, TDSP_RAISE_FACTOR, 0.0, INFINITY);
    assert_near(m.most, -INFINITY, 0);
    assert_int_equal(m.status, TDSP_SOURCE_COVERED);
    world_free(w);
    w = world_make(across, gap, 2);
    m = departure_margin(w, TDSP_RAISE_ADDED, 5.0, 20.0);
    assert_near(m.most, -INFINITY, 0);
    assert_int_equal(m.status, TDSP_ARRIVAL_TOO_EARLY);
    assert_int_equal(m.witness.limit, TDSP_LIMIT_DEADLINE);
    world_free(w);
}

static void a_departure_that_is_too_late_has_a_factor_below_1(void **state)
{
    (void)state;
    world w = world_make(across, gap, 2);
    const double last = 60.3085080256;
    tdsp_margin m = departure_margin(w, TDSP_RAISE_FACTOR, last + 5.0, INFINITY);
    assert_true(m.most < 1.0 && m.most > 0.8);
    assert_int_equal(m.status, TDSP_OK);
    tdsp_scene *less;
    tdsp_solver *solver;
    double arrival;
    assert_int_equal(tdsp_scene_raise(w.scene, TDSP_RAISE_FACTOR, m.most, &less), TDSP_OK);
    assert_int_equal(tdsp_solver_create(less, &solver), TDSP_OK);
    assert_int_equal(tdsp_earliest_arrival(solver, last + 5.0, &arrival), TDSP_OK);
    assert_exact(arrival, m.arrival);
    tdsp_solver_free(solver);
    tdsp_scene_free(less);
    world_free(w);
}

static void a_deadline_that_is_met_exactly_by_a_ride_leaves_the_factor_1(void **state)
{
    (void)state;
    world w = world_make(across, gap, 2);
    const double departures[] = {10.0, 12.0, 30.0, 60.0};
    for (size_t i = 0; i < 4; i++) {
        const double t = departures[i], a = world_arrival(w, t);
        const tdsp_margin m = departure_margin(w, TDSP_RAISE_FACTOR, t, a);
        assert_true(m.most >= 1.0);
        assert_near(m.most, 1.0, 1e-9);
        assert_int_equal(m.witness.limit, TDSP_LIMIT_DEADLINE);
        assert_near(departure_margin(w, TDSP_RAISE_ADDED, t, a).most, 0.0, 1e-10);
    }
    world_free(w);
}

static void no_deadline_is_an_infinite_one_or_one_after_every_arrival(void **state)
{
    (void)state;
    world w = world_make(across, gap, 2);
    const double never = departure_margin(w, TDSP_RAISE_FACTOR, 11.0, INFINITY).most;
    assert_near(departure_margin(w, TDSP_RAISE_FACTOR, 11.0, 1e6).most, never, 1e-10);
    world_free(w);
}

static void raising_caps_rates_below_the_speed_and_leaves_faster_ones(void **state)
{
    (void)state;
    const tdsp_disc discs[4] = {{{0, 9}, 1, 0.0}, {{0, 19}, 1, 0.25}, {{0, 29}, 1, 1.0}, {{0, 39}, 1, 7.0}};
    const double cap = TDSP_MARGIN_CAP;
    const struct {
        tdsp_raise how;
        double amount, rates[4];
    } cases[] = {
        {TDSP_RAISE_FACTOR, 2.0, {0.0, 0.5, 1.0, 7.0}},      {TDSP_RAISE_FACTOR, 0.0, {0.0, 0.0, 1.0, 7.0}},
        {TDSP_RAISE_FACTOR, INFINITY, {0.0, cap, 1.0, 7.0}}, {TDSP_RAISE_ADDED, 0.125, {0.125, 0.375, 1.0, 7.0}},
        {TDSP_RAISE_ADDED, -0.125, {0.0, 0.125, 1.0, 7.0}},  {TDSP_RAISE_ADDED, INFINITY, {cap, cap, 1.0, 7.0}},
    };
    world w = world_make(across, discs, 4);
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        tdsp_scene *raised;
        assert_int_equal(tdsp_scene_raise(w.scene, cases[i].how, cases[i].amount, &raised), TDSP_OK);
        size_t count;
        const tdsp_disc *found = tdsp_scene_discs(raised, &count);
        assert_int_equal(count, 4);
        for (size_t k = 0; k < 4; k++) assert_exact(found[k].growth, cases[i].rates[k]);
        tdsp_scene_free(raised);
    }
    world_free(w);
}

static void mistakes_are_told_and_touch_nothing(void **state)
{
    (void)state;
    world w = world_make(across, gap, 2);
    tdsp_margin m = {.most = 7.0};
    tdsp_scene *raised = NULL;
    tdsp_leg leg = {.kind = TDSP_LEG_LINE, .start_time = 1.0, .end_time = 0.0};
    assert_int_equal(tdsp_scene_raise(w.scene, TDSP_RAISE_FACTOR, -1.0, &raised), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_scene_raise(w.scene, TDSP_RAISE_ADDED, NAN, &raised), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_scene_raise(w.scene, (tdsp_raise)5, 1.0, &raised), TDSP_INVALID_ARGUMENT);
    assert_null(raised);
    assert_int_equal(tdsp_departure_margin(NULL, TDSP_RAISE_FACTOR, 0.0, 1.0, &m), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_departure_margin(w.scene, (tdsp_raise)5, 0.0, 1.0, &m), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_departure_margin(w.scene, TDSP_RAISE_FACTOR, INFINITY, 1.0, &m), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_departure_margin(w.scene, TDSP_RAISE_FACTOR, 0.0, NAN, &m), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_path_margin(w.scene, TDSP_RAISE_FACTOR, NULL, 1, 0.0, &m), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_path_margin(w.scene, TDSP_RAISE_FACTOR, &leg, 1, 0.0, &m), TDSP_BAD_PATH);
    leg.kind = TDSP_LEG_CURVE;
    assert_int_equal(tdsp_path_margin(w.scene, TDSP_RAISE_FACTOR, &leg, 1, 0.0, &m), TDSP_BAD_PATH);
    assert_exact(m.most, 7.0);
    world_free(w);
}

static void a_path_into_a_disc_has_no_margin(void **state)
{
    (void)state;
    const tdsp_disc disc = {{0.0, 0.0}, 1.0, 0.1};
    const tdsp_leg through = {
        .kind = TDSP_LEG_LINE, .disc = TDSP_NO_DISC, .end_time = 20.0, .from = {-10.0, 0.0}, .to = {10.0, 0.0}};
    world w = world_make(across, &disc, 1);
    tdsp_margin m;
    assert_int_equal(tdsp_path_margin(w.scene, TDSP_RAISE_FACTOR, &through, 1, 0.0, &m), TDSP_OK);
    assert_near(m.most, -INFINITY, 0);
    assert_int_equal(m.status, TDSP_BAD_PATH);
    assert_int_equal(m.witness.disc, 0);
    world_free(w);
}

static void a_robot_that_is_there_already_is_limited_by_the_cover(void **state)
{
    (void)state;
    const tdsp_journey stays = {1.0, 0.5, {0.0, 0.0}, {0.0, 0.0}};
    const tdsp_disc disc = {{5.0, 0.0}, 1.0, 0.1};
    world w = world_make(stays, &disc, 1);
    tdsp_margin m;
    assert_int_equal(tdsp_path_margin(w.scene, TDSP_RAISE_FACTOR, NULL, 0, 7.0, &m), TDSP_OK);
    assert_near(m.most, 5.0, 1e-14);
    assert_near(departure_margin(w, TDSP_RAISE_FACTOR, 7.0, INFINITY).most, 5.0, 1e-11);
    world_free(w);
}

static tdsp_scene *growing_scene(const tdsp_growth *growth)
{
    const tdsp_growing_disc disc = {{-10.0, 4.0}, 1.0, *growth};
    tdsp_scene *scene;
    assert_int_equal(tdsp_scene_create_growing(&across, &disc, 1, NULL, &scene), TDSP_OK);
    return scene;
}

/* A disc has 3 to grow before it covers the source, which the robot leaves at 10. */
static void growth_that_changes_limits_by_its_closed_forms(void **state)
{
    (void)state;
    const double powers[] = {0.1, 0.01}, rates[] = {0.1, 0.2, 0.0}, times[] = {0.0, 5.0, 12.0};
    const struct {
        tdsp_growth growth;
        double factor, added;
    } cases[] = {
        {{.kind = TDSP_GROWTH_POLYNOMIAL, .count = 2, .values = powers}, 1.5, 0.1},            /* 0.1 * 10 + 0.01 * 100 = 2 */
        {{.kind = TDSP_GROWTH_RATES, .count = 2, .values = rates, .times = times}, 2.0, 0.15}, /* 0.1 * 5 + 0.2 * 5 = 1.5 */
        {{.kind = TDSP_GROWTH_RATES, .count = 3, .values = rates, .times = times}, 2.0, 0.15},
    };
    for (size_t i = 0; i < 3; i++) {
        tdsp_margin m;
        tdsp_scene *scene = growing_scene(&cases[i].growth);
        assert_int_equal(tdsp_departure_margin(scene, TDSP_RAISE_FACTOR, 10.0, INFINITY, &m), TDSP_OK);
        assert_near(m.most, cases[i].factor, 1e-11);
        assert_int_equal(m.witness.limit, TDSP_LIMIT_SOURCE_COVERED);
        assert_near(m.witness.time, 10.0, 1e-9);
        assert_int_equal(tdsp_departure_margin(scene, TDSP_RAISE_ADDED, 10.0, INFINITY, &m), TDSP_OK);
        assert_near(m.most, cases[i].added, 1e-11);
        assert_int_equal(tdsp_path_margin(scene, TDSP_RAISE_FACTOR, NULL, 0, 10.0, &m), TDSP_OK);
        assert_near(m.most, cases[i].factor, 1e-7);
        assert_int_equal(m.witness.limit, TDSP_LIMIT_TOUCH);
        assert_int_equal(tdsp_path_margin(scene, TDSP_RAISE_ADDED, NULL, 0, 10.0, &m), TDSP_OK);
        assert_near(m.most, cases[i].added, 1e-7);
        tdsp_scene_free(scene);
    }
}

static void raised_growth_gains_its_radius_in_proportion_or_in_time(void **state)
{
    (void)state;
    const double powers[] = {0.1, 0.0, 0.01}, rates[] = {0.1, 0.4, 0.0}, times[] = {0.0, 5.0, 12.0};
    const tdsp_growth growths[] = {
        {.kind = TDSP_GROWTH_POLYNOMIAL, .count = 3, .values = powers},
        {.kind = TDSP_GROWTH_RATES, .count = 3, .values = rates, .times = times},
    };
    for (size_t i = 0; i < 2; i++) {
        tdsp_scene *scene = growing_scene(&growths[i]), *factor, *added;
        assert_int_equal(tdsp_scene_raise(scene, TDSP_RAISE_FACTOR, 1.75, &factor), TDSP_OK);
        assert_int_equal(tdsp_scene_raise(scene, TDSP_RAISE_ADDED, 0.25, &added), TDSP_OK);
        for (double t = 0.0; t < 20.0; t += 0.7) {
            double radius, more, rate, faster;
            assert_int_equal(tdsp_scene_disc_at(scene, 0, t, &radius, &rate), TDSP_OK);
            assert_int_equal(tdsp_scene_disc_at(factor, 0, t, &more, &faster), TDSP_OK);
            assert_near(more, 1.0 + 1.75 * (radius - 1.0), 1e-12 * more);
            assert_near(faster, 1.75 * rate, 1e-12 * (1.0 + faster));
            assert_int_equal(tdsp_scene_disc_at(added, 0, t, &more, NULL), TDSP_OK);
            assert_near(more, radius + 0.25 * t, 1e-12 * more);
        }
        tdsp_scene_free(factor);
        tdsp_scene_free(added);
        tdsp_scene_free(scene);
    }
}

static void what_growth_that_bends_cannot_be_asked_is_told(void **state)
{
    (void)state;
    const double powers[] = {0.1, 0.01};
    const tdsp_growth growth = {.kind = TDSP_GROWTH_POLYNOMIAL, .count = 2, .values = powers};
    tdsp_scene *scene = growing_scene(&growth), *raised = NULL;
    tdsp_margin m = {.most = 7.0};
    assert_int_equal(tdsp_scene_raise(scene, TDSP_RAISE_ADDED, -0.01, &raised), TDSP_NOT_SUPPORTED);
    assert_int_equal(tdsp_scene_raise(scene, TDSP_RAISE_FACTOR, INFINITY, &raised), TDSP_NOT_SUPPORTED);
    assert_null(raised);
    assert_int_equal(tdsp_departure_margin(scene, TDSP_RAISE_ADDED, 20.0, INFINITY, &m), TDSP_NOT_SUPPORTED);
    assert_exact(m.most, 7.0);
    tdsp_scene_free(scene);
}

/* Every allocation fails in turn: told, nothing leaks, outputs stay. */
static void memory_that_runs_out_is_told_and_leaves_nothing(void **state)
{
    (void)state;
    for (size_t refuse = 1;; refuse += 3) {
        tight_heap heap;
        memset(&heap, 0, sizeof heap);
        const tdsp_allocator memory = tight_allocator(&heap);
        tdsp_scene *scene;
        tdsp_margin m = {.most = 7.0};
        assert_int_equal(tdsp_scene_create(&across, gap, 2, &memory, &scene), TDSP_OK);
        heap.refuse = heap.calls + refuse;
        const tdsp_status status = tdsp_departure_margin(scene, TDSP_RAISE_FACTOR, 9.0, 29.5, &m);
        const int done = heap.calls < heap.refuse;
        tdsp_scene_free(scene);
        assert_int_equal(heap.blocks, 0);
        assert_int_equal(heap.held, 0);
        assert_int_equal(status, done ? TDSP_OK : TDSP_NO_MEMORY);
        if (done) break;
        assert_exact(m.most, 7.0);
    }
}

static void memory_that_runs_out_at_a_deadline_is_told(void **state)
{
    (void)state;
    tight_heap heap;
    memset(&heap, 0, sizeof heap);
    const tdsp_allocator memory = tight_allocator(&heap);
    tdsp_scene *scene;
    tdsp_solver *solver;
    tdsp_status status = TDSP_NO_MEMORY;
    tdsp_deadline_answer answer = {.departure = 7.0};
    assert_int_equal(tdsp_scene_create(&across, gap, 2, &memory, &scene), TDSP_OK);
    assert_int_equal(tdsp_solver_create(scene, &solver), TDSP_OK);
    for (size_t refuse = 1; status == TDSP_NO_MEMORY; refuse++) {
        assert_exact(answer.departure, 7.0);
        heap.refuse = heap.calls + refuse;
        status = tdsp_solver_deadline(solver, 33.0, &answer);
    }
    assert_int_equal(status, TDSP_OK);
    assert_int_equal(answer.witness.limit, TDSP_LIMIT_GAP);
    tdsp_solver_free(solver);
    tdsp_scene_free(scene);
    assert_int_equal(heap.blocks, 0);
    assert_int_equal(heap.held, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_closing_gap_limits_by_its_closed_form),
        cmocka_unit_test(covers_limit_by_their_closed_forms),
        cmocka_unit_test(a_path_that_rides_a_growing_disc_has_nothing_to_spare),
        cmocka_unit_test(a_path_that_rides_a_disc_that_stands_still_has_something_to_spare_for_a_factor_only),
        cmocka_unit_test(what_no_rate_below_the_cap_can_reach_is_unlimited),
        cmocka_unit_test(what_fails_without_any_growth_has_no_margin_and_says_why),
        cmocka_unit_test(a_departure_that_is_too_late_has_a_factor_below_1),
        cmocka_unit_test(a_deadline_that_is_met_exactly_by_a_ride_leaves_the_factor_1),
        cmocka_unit_test(no_deadline_is_an_infinite_one_or_one_after_every_arrival),
        cmocka_unit_test(raising_caps_rates_below_the_speed_and_leaves_faster_ones),
        cmocka_unit_test(mistakes_are_told_and_touch_nothing),
        cmocka_unit_test(a_path_into_a_disc_has_no_margin),
        cmocka_unit_test(a_robot_that_is_there_already_is_limited_by_the_cover),
        cmocka_unit_test(growth_that_changes_limits_by_its_closed_forms),
        cmocka_unit_test(raised_growth_gains_its_radius_in_proportion_or_in_time),
        cmocka_unit_test(what_growth_that_bends_cannot_be_asked_is_told),
        cmocka_unit_test(memory_that_runs_out_is_told_and_leaves_nothing),
        cmocka_unit_test(memory_that_runs_out_at_a_deadline_is_told),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
