/* SPDX-License-Identifier: MIT */
/* A destination walled in: found out where it is so, and never where there is a way. */
#include "support/cmocka_all.h"

#include <string.h>

#include "search/solver.h"
#include "support/chance.h"
#include "support/random_scene.h"
#include "support/tight.h"
#include "support/world.h"

#define RING 24

enum { MOST = RING + 200 };

static const tdsp_journey across = {1.0, 0.0, {-10.0, 0.0}, {10.0, 0.0}};

static int is_enclosed(world w, double departure)
{
    int enclosed = 7;
    assert_int_equal(enclosure_test(&w.solver->enclosure, &w.solver->engine, &w.solver->ends, departure / w.scene->time, &enclosed), TDSP_OK);
    assert_true(enclosed == 0 || enclosed == 1);
    return enclosed;
}

/* A ring of radius 3 about the destination; discs touch where theirs is 3 sin(pi / RING). */
static void ring(tdsp_disc *discs, double radius, double growth)
{
    for (int i = 0; i < RING; ++i) {
        double angle = 2.0 * GEOM_PI * i / RING;
        tdsp_disc disc = {{10.0 + 3.0 * cos(angle), 3.0 * sin(angle)}, radius, growth};
        discs[i] = disc;
    }
}

static double touch(void)
{
    return 3.0 * sin(GEOM_PI / RING);
}

static void a_closed_ring_encloses_and_one_with_a_gap_does_not(void **state)
{
    (void)state;
    tdsp_disc discs[RING];
    for (int open = 0; open < RING; ++open) {
        ring(discs, 1.01 * touch(), 0.0);
        world w = world_make(across, discs, RING);
        assert_int_equal(is_enclosed(w, 5.0), 1);
        world_free(w);
        for (int i = open; i + 1 < RING; ++i) discs[i] = discs[i + 1];
        w = world_make(across, discs, RING - 1);
        assert_int_equal(is_enclosed(w, 5.0), 0);
        world_free(w);
    }
}

static void a_ring_that_only_touches_lets_through(void **state)
{
    (void)state;
    tdsp_disc discs[RING];
    ring(discs, touch() * (1.0 - 1e-12), 0.0);
    world w = world_make(across, discs, RING);
    assert_int_equal(is_enclosed(w, 0.0), 0);
    assert_true(isfinite(world_arrival(w, 0.0)));
    world_free(w);
}

/*
 * The ring's nearest discs close at the moment when the robot is there, the others later, for the robot is there later. A disc at the distance a from the
 * source counts with the radius (R + c (t + a)) / (1 + c).
 */
static void a_growing_ring_encloses_as_soon_as_it_closes_before_the_robot_is_there(void **state)
{
    (void)state;
    tdsp_disc discs[RING];
    const double growth = 0.005;
    ring(discs, 0.5 * touch(), growth);
    world w = world_make(across, discs, RING);
    double nearest = 20.0 - 3.0, closes = (touch() * (1.0 + growth) - 0.5 * touch()) / growth - nearest;
    assert_int_equal(is_enclosed(w, closes + 0.2), 1);
    assert_int_equal(is_enclosed(w, closes - 0.2), 0);
    assert_true(isinf(world_arrival(w, closes + 0.2)));
    assert_true(isfinite(world_arrival(w, closes - 5.0)));
    world_free(w);
}

static void a_wall_that_closes_only_after_the_robot_has_passed_does_not_count(void **state)
{
    (void)state;
    tdsp_disc discs[RING];
    ring(discs, 0.9 * touch(), 0.0004);
    world w = world_make(across, discs, RING);
    assert_int_equal(is_enclosed(w, 0.0), 0);
    assert_near(world_arrival(w, 0.0), 20.0, 1.0);
    assert_int_equal(is_enclosed(w, 200.0), 1);
    world_free(w);
}

/* The upper half of the ring is missing; a disc comes down there, which covers the destination at 25. */
static void a_disc_that_covers_the_destination_later_is_no_wall(void **state)
{
    (void)state;
    tdsp_disc discs[RING + 1];
    ring(discs, 1.01 * touch(), 0.0);
    for (int i = 0; i < RING; ++i)
        if (discs[i].center.y > 0.5) discs[i].center.y -= 50.0;
    tdsp_disc lid = {{10.0, 30.0}, 5.0, 1.0};
    discs[RING] = lid;
    world w = world_make(across, discs, RING + 1);
    for (double departure = 0.0; departure < 4.5; departure += 0.5) {
        assert_int_equal(is_enclosed(w, departure), 0);
        assert_true(isfinite(world_arrival(w, departure)));
    }
    assert_true(isinf(world_arrival(w, 5.0)));
    world_free(w);
}

static void a_source_inside_the_ring_is_not_walled_off(void **state)
{
    (void)state;
    tdsp_disc discs[RING];
    const tdsp_journey inside = {1.0, 0.0, {8.5, 0.5}, {10.0, 0.0}};
    ring(discs, 1.01 * touch(), 0.001);
    world w = world_make(inside, discs, RING);
    for (double departure = 0.0; departure < 100.0; departure += 9.0) assert_int_equal(is_enclosed(w, departure), 0);
    world_free(w);
}

static void among_no_discs_nobody_is_enclosed(void **state)
{
    (void)state;
    world w = world_make(across, NULL, 0);
    assert_int_equal(is_enclosed(w, 0.0), 0);
    world_free(w);
}

/* Discs all about, and a ring that may have holes and gaps that close. */
static size_t random_ring(tdsp_disc *discs, uint64_t *chance)
{
    size_t count = 0;
    double growth = chance_below(chance, 2) ? 0.0 : chance_between(chance, 0.0, 0.02), radius = touch() * chance_between(chance, 0.7, 1.2);
    int hole = (int)chance_below(chance, 3 * RING);
    ring(discs, radius, growth);
    for (int i = 0; i < RING; ++i) {
        discs[i].center.x += chance_between(chance, -0.1, 0.1);
        if (i != hole) discs[count++] = discs[i];
    }
    size_t more = chance_below(chance, 30);
    for (size_t i = 0; i < more; ++i) {
        tdsp_disc disc = {{chance_between(chance, -9.0, 14.0), chance_between(chance, -6.0, 6.0)}, chance_between(chance, 0.05, 0.8), chance_between(chance, 0.0, 0.02)};
        discs[count++] = disc;
    }
    return count;
}

/* The exact search among so few discs sends no scouts and asks about no enclosure. */
static void enclosed_means_no_way(world w, double departure, int counts[2])
{
    double found = -1.0;
    tdsp_status status = solver_forward(w.solver, &w.scene->all, departure, INFINITY, &found);
    assert_true(tdsp_status_is_answer(status));
    int enclosed = status != TDSP_SOURCE_COVERED && is_enclosed(w, departure);
    if (enclosed) assert_int_equal(status, TDSP_CUT_OFF);
    counts[0] += enclosed;
    counts[1] += status == TDSP_CUT_OFF;
}

static void where_there_is_a_way_nobody_is_enclosed(void **state)
{
    (void)state;
    tdsp_disc discs[MOST];
    uint64_t chance = 1;
    int counts[2] = {0, 0};
    for (int k = 0; k < 400; ++k) {
        world w = world_make(across, discs, random_ring(discs, &chance));
        for (int i = 0; i < 5; ++i) enclosed_means_no_way(w, i ? chance_between(&chance, 0.0, 40.0) : 0.0, counts);
        world_free(w);
    }
    assert_true(counts[0] > 400 && counts[1] > counts[0]);
}

static void where_there_is_a_way_in_a_scene_of_any_kind_nobody_is_enclosed(void **state)
{
    (void)state;
    tdsp_disc discs[RANDOM_MOST_DISCS];
    uint64_t chance = 2;
    int counts[2] = {0, 0};
    for (int mix = 0; mix < RANDOM_MIX_COUNT; ++mix)
        for (uint64_t seed = 0; seed < 25; ++seed) {
            tdsp_journey journey;
            size_t count = 3 + (size_t)chance_below(&chance, RANDOM_MOST_DISCS - 2);
            random_scene(seed, (random_mix)mix, count, &journey, discs);
            world w = world_make(journey, discs, count);
            double last = fmin(tdsp_scene_source_free_until(w.scene, NULL), 3.0 * w.unit);
            for (int i = 0; i < 4; ++i) enclosed_means_no_way(w, last * chance_between(&chance, 0.0, 1.0), counts);
            world_free(w);
        }
    assert_true(counts[0] > 50);
}

static void a_test_without_memory_is_told_and_can_be_made_again(void **state)
{
    (void)state;
    static tdsp_disc discs[MOST];
    tight_heap heap = {0};
    tdsp_allocator memory = tight_allocator(&heap);
    tdsp_scene *scene;
    tdsp_solver *solver;
    ring(discs, 1.01 * touch(), 0.0);
    assert_int_equal(tdsp_scene_create(&across, discs, RING, &memory, &scene), TDSP_OK);
    tdsp_status status = TDSP_NO_MEMORY;
    for (size_t refuse = 1; status == TDSP_NO_MEMORY; ++refuse) {
        int enclosed = 0;
        assert_int_equal(tdsp_solver_create(scene, &solver), TDSP_OK);
        heap.refuse = heap.calls + refuse;
        status = enclosure_test(&solver->enclosure, &solver->engine, &solver->ends, 0.0, &enclosed);
        heap.refuse = 0;
        assert_int_equal(enclosed, status == TDSP_OK);
        if (status != TDSP_OK) assert_int_equal(enclosure_test(&solver->enclosure, &solver->engine, &solver->ends, 0.0, &enclosed), TDSP_OK);
        assert_int_equal(enclosed, 1);
        tdsp_solver_free(solver);
    }
    assert_int_equal(status, TDSP_OK);
    tdsp_scene_free(scene);
    assert_int_equal(heap.blocks, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_closed_ring_encloses_and_one_with_a_gap_does_not),
        cmocka_unit_test(a_ring_that_only_touches_lets_through),
        cmocka_unit_test(a_growing_ring_encloses_as_soon_as_it_closes_before_the_robot_is_there),
        cmocka_unit_test(a_wall_that_closes_only_after_the_robot_has_passed_does_not_count),
        cmocka_unit_test(a_disc_that_covers_the_destination_later_is_no_wall),
        cmocka_unit_test(a_source_inside_the_ring_is_not_walled_off),
        cmocka_unit_test(among_no_discs_nobody_is_enclosed),
        cmocka_unit_test(where_there_is_a_way_nobody_is_enclosed),
        cmocka_unit_test(where_there_is_a_way_in_a_scene_of_any_kind_nobody_is_enclosed),
        cmocka_unit_test(a_test_without_memory_is_told_and_can_be_made_again),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
