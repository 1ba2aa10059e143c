/* SPDX-License-Identifier: MIT */
/* Gap events: the last moment at which a closing gap lets a robot out, against geometry and against bisection on A. */
#include "support/cmocka_all.h"

#include "search/gap.h"
#include "support/chance.h"
#include "support/world.h"

static double latest(world w, double a)
{
    double departure = -1.0, arrives = -1.0;
    assert_int_equal(tdsp_latest_departure(w.solver, a, &departure, &arrives), TDSP_OK);
    assert_true(arrives <= a);
    return departure;
}

/* Where two circles meet, on the side of `side`; 0 when they do not. */
static int circles_meet(const geom_disc *i, const geom_disc *j, double time, int side, tdsp_point *corner)
{
    double ri = disc_radius(i, time), rj = disc_radius(j, time), d = point_distance(i->center, j->center);
    double along = (d * d + ri * ri - rj * rj) / (2.0 * d), squared = ri * ri - along * along;
    if (squared < 0.0) return 0;
    tdsp_point u = point_scale(1.0 / d, point_sub(j->center, i->center));
    *corner = point_along(point_along(i->center, along, u), side * sqrt(squared), point_make(-u.y, u.x));
    return 1;
}

/* The corner's velocity, by differences. */
static tdsp_point corner_velocity(const geom_disc *i, const geom_disc *j, double time, int side)
{
    double h = 1e-5;
    tdsp_point before = {0.0, 0.0}, after = {0.0, 0.0};
    assert_true(circles_meet(i, j, time - h, side, &before));
    assert_true(circles_meet(i, j, time + h, side, &after));
    return point_scale(0.5 / h, point_sub(after, before));
}

static void check_event(const gap_event *event, const disc_set *set)
{
    const geom_disc *i = &set->forward[event->first], *j = &set->forward[event->second];
    tdsp_point corner = {0.0, 0.0};
    int side = 1;
    assert_true(circles_meet(i, j, event->time, side, &corner));
    if (point_distance(corner, event->place) > 1e-6 && circles_meet(i, j, event->time, -1, &corner)) side = -1;
    assert_near(point_distance(corner, event->place), 0.0, 1e-7);
    assert_near(point_distance(disc_boundary(i, event->normal[0], event->time), event->place), 0.0, 1e-9);
    assert_near(point_distance(disc_boundary(j, event->normal[1], event->time), event->place), 0.0, 1e-9);
    tdsp_point velocity = corner_velocity(i, j, event->time, side);
    assert_near(point_length(velocity), 1.0, 1e-5);
    tdsp_point heading = point_unit(disc_heading(i, event->side, event->normal[0]));
    assert_near(point_distance(heading, velocity), 0.0, 1e-4);
    heading = point_unit(disc_heading(j, -event->side, event->normal[1]));
    assert_near(point_distance(heading, velocity), 0.0, 1e-4);
}

static void at_an_event_the_corner_moves_as_fast_as_the_robot_and_with_it(void **state)
{
    (void)state;
    const tdsp_journey journey = {1.0, 0.0, {-10.0, 0.0}, {10.0, 0.0}};
    uint64_t chance = 1;
    size_t events = 0;
    for (int k = 0; k < 500; ++k) {
        tdsp_disc discs[2];
        for (int i = 0; i < 2; ++i) {
            tdsp_disc disc = {{chance_between(&chance, -2.0, 2.0), (i ? -1.0 : 1.0) * chance_between(&chance, 2.0, 4.0)},
                              chance_between(&chance, 0.3, 1.2), chance_between(&chance, 0.02, 0.6)};
            discs[i] = disc;
        }
        world w = world_make(journey, discs, 2);
        assert_int_equal(gap_collect(w.solver, &w.scene->all, 0.0, 5.0), TDSP_OK);
        for (size_t i = 0; i < w.solver->gap_count; ++i) check_event(&w.solver->gaps[i], &w.scene->all);
        events += w.solver->gap_count;
        world_free(w);
    }
    assert_true(events > 200);
}

static const tdsp_journey gap_journey = {1.0, 0.0, {-10.0, 0.0}, {10.0, 0.0}};
static const tdsp_disc gap_discs[2] = {{{0.0, 3.0}, 1.0, 0.1}, {{0.0, -3.0}, 1.0, 0.1}};

/* R = 3 sin(theta) at the event, and sqrt(100 - 0.01 * ...) aside: 30 sqrt(0.99) - 20 by symmetry. */
static void the_symmetric_gap_is_lost_at_its_closed_form(void **state)
{
    (void)state;
    world w = world_make(gap_journey, gap_discs, 2);
    double lost = 30.0 * sqrt(0.99) - 20.0;
    assert_near(lost, 9.8496231132, 1e-10);
    assert_near(latest(w, 30.35), lost, 1e-9);
    assert_near(latest(w, 33.0), lost, 1e-9);
    assert_near(world_arrival(w, lost - 1e-9), lost + 20.0, 1e-7);
    assert_near(world_arrival(w, lost - 1e-6), 29.8496, 1e-4);
    assert_near(world_arrival(w, lost + 1e-6), 33.5675, 1e-4);
    world_free(w);
}

static void an_arrival_in_the_middle_of_a_jump_takes_the_path_through_the_gap(void **state)
{
    (void)state;
    world w = world_make(gap_journey, gap_discs, 2);
    double before = 30.0 * sqrt(0.99), first = latest(w, before + 0.01);
    for (double a = before + 0.02; a < 33.56; a += 0.1) assert_near(latest(w, a), first, 1e-9);
    assert_true(latest(w, before - 0.01) < first - 1e-3);
    assert_true(latest(w, 33.6) > first + 1e-3);
    world_free(w);
}

/* Where A passes `a`, by halving between a departure that is in time and one that is not. */
static double bisected(world w, double a, double lo, double hi)
{
    for (int step = 0; step < 45; ++step) {
        double middle = 0.5 * (lo + hi);
        *(world_arrival(w, middle) <= a ? &lo : &hi) = middle;
    }
    return lo;
}

static tdsp_disc random_wall(uint64_t *chance, int upper)
{
    tdsp_disc disc = {{chance_between(chance, -3.0, 3.0), (upper ? 1.0 : -1.0) * chance_between(chance, 2.0, 4.0)},
                      chance_between(chance, 0.5, 1.5), chance_between(chance, 0.0, 0.5)};
    return disc;
}

static void random_gaps_are_lost_where_bisection_says(void **state)
{
    (void)state;
    uint64_t chance = 2;
    int jumps = 0;
    for (int k = 0; k < 150; ++k) {
        const tdsp_disc discs[2] = {random_wall(&chance, 1), random_wall(&chance, 0)};
        world w = world_make(gap_journey, discs, 2);
        double lo = 0.0, hi = fmin(tdsp_scene_source_free_until(w.scene, NULL), 30.0), first = world_arrival(w, lo);
        for (int i = 1; i < 6 && isfinite(first); ++i) {
            double a = first + i * 4.0, expected = bisected(w, a, lo, hi), found = latest(w, a);
            assert_near(found, expected, 1e-8);
            jumps += world_arrival(w, found + 1e-6) > a + 1e-3;
        }
        world_free(w);
    }
    assert_true(jumps > 20);
}

static void a_corner_that_a_third_disc_covers_is_no_event(void **state)
{
    (void)state;
    const tdsp_disc discs[3] = {gap_discs[0], gap_discs[1], {{0.0, 0.0}, 0.2, 0.11}};
    world open = world_make(gap_journey, gap_discs, 2), shut = world_make(gap_journey, discs, 3);
    double until = 40.0 / open.scene->time;
    assert_int_equal(gap_collect(open.solver, &open.scene->all, 0.0, until), TDSP_OK);
    assert_true(open.solver->gap_count > 0);
    assert_int_equal(gap_collect(shut.solver, &shut.scene->all, 0.0, until), TDSP_OK);
    for (size_t i = 0; i < shut.solver->gap_count; ++i) {
        uint32_t a = shut.scene->all.origin[shut.solver->gaps[i].first], b = shut.scene->all.origin[shut.solver->gaps[i].second];
        assert_true(a == 2 || b == 2);
    }
    world_free(open);
    world_free(shut);
}

static void static_discs_have_no_events(void **state)
{
    (void)state;
    const tdsp_disc discs[2] = {{{0.0, 1.0}, 1.5, 0.0}, {{0.0, -1.0}, 1.5, 0.0}};
    world w = world_make(gap_journey, discs, 2);
    assert_int_equal(gap_collect(w.solver, &w.scene->all, 0.0, 10.0), TDSP_OK);
    assert_int_equal(w.solver->gap_count, 0);
    world_free(w);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(at_an_event_the_corner_moves_as_fast_as_the_robot_and_with_it),
        cmocka_unit_test(the_symmetric_gap_is_lost_at_its_closed_form),
        cmocka_unit_test(an_arrival_in_the_middle_of_a_jump_takes_the_path_through_the_gap),
        cmocka_unit_test(random_gaps_are_lost_where_bisection_says),
        cmocka_unit_test(a_corner_that_a_third_disc_covers_is_no_event),
        cmocka_unit_test(static_discs_have_no_events),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
