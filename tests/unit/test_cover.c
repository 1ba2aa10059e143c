/* SPDX-License-Identifier: MIT */
/* Discs that can never matter: what is dropped is enclosed by what is kept, for good; and dropping changes no answer. */
#include "support/cmocka_all.h"

#include <stdlib.h>
#include <string.h>

#include "scene/cover.h"
#include "scene/scene.h"
#include "support/chance.h"
#include "support/tight.h"
#include "tdsp/solver.h"

enum { MOST = 120 };

typedef struct heap_of_discs {
    geom_disc discs[MOST];
    geom_disc given_discs[MOST];
    geom_disc spare[MOST];
    uint32_t given[MOST];
    uint32_t count;
    uint32_t kept;
} heap_of_discs;

static tdsp_status drop(heap_of_discs *h, const tdsp_allocator *memory)
{
    index_items items = {h->discs, h->given, h->spare, h->count};
    scene_index index = {0};
    for (uint32_t i = 0; i < h->count; ++i) {
        h->discs[i] = h->given_discs[i];
        h->given[i] = i;
    }
    tdsp_status status = index_build(&index, memory, items);
    if (status == TDSP_OK) status = cover_drop(&index, memory, items, &h->kept);
    index_free(&index, memory);
    return status;
}

static void drop_well(heap_of_discs *h)
{
    tdsp_allocator memory = memory_allocator(NULL);
    assert_int_equal(drop(h, &memory), TDSP_OK);
}

static void add(heap_of_discs *h, double x, double y, double radius, double rate)
{
    h->given_discs[h->count++] = disc_make(point_make(x, y), radius, rate);
}

static int is_kept(const heap_of_discs *h, uint32_t given)
{
    for (uint32_t i = 0; i < h->kept; ++i)
        if (h->given[i] == given) return 1;
    return 0;
}

/* A map of the plane at one moment: what a robot from outside can reach past the discs kept. */
enum { CELLS = 160 };

typedef struct map {
    const heap_of_discs *h;
    double time;
    double half; /* of the map's width */
    double step;
    unsigned char reached[CELLS][CELLS];
    uint32_t todo[CELLS * CELLS];
    uint32_t count;
} map;

static tdsp_point map_place(const map *m, uint32_t cell)
{
    return point_make(m->step * (cell % CELLS + 0.5) - m->half, m->step * (cell / CELLS + 0.5) - m->half);
}

/* With a step's distance from all that is kept: a step to a neighbour then runs into nothing. */
static int map_free(const map *m, uint32_t cell)
{
    for (uint32_t i = 0; i < m->h->kept; ++i)
        if (point_distance(map_place(m, cell), m->h->discs[i].center) <= disc_radius(&m->h->discs[i], m->time) + m->step)
            return 0;
    return 1;
}

static void map_reach(map *m, uint32_t cell)
{
    if (m->reached[cell / CELLS][cell % CELLS] || !map_free(m, cell)) return;
    m->reached[cell / CELLS][cell % CELLS] = 1;
    m->todo[m->count++] = cell;
}

static void map_flood(map *m)
{
    for (uint32_t i = 0; i < CELLS; ++i) map_reach(m, i); /* the lowest row lies outside all discs */
    while (m->count > 0) {
        uint32_t cell = m->todo[--m->count];
        if (cell % CELLS > 0) map_reach(m, cell - 1);
        if (cell % CELLS < CELLS - 1) map_reach(m, cell + 1);
        if (cell >= CELLS) map_reach(m, cell - CELLS);
        if (cell < CELLS * (CELLS - 1)) map_reach(m, cell + CELLS);
    }
}

/* No place that a robot from outside reaches lies in a disc that was dropped. */
static uint32_t assert_enclosed(const heap_of_discs *h, double time)
{
    static map m;
    uint32_t reached = 0;
    memset(&m, 0, sizeof m);
    m.h = h;
    m.time = time;
    m.half = 8.0 + 1.5 + 1.4 * time + 1.0;
    m.step = 2.0 * m.half / (double)CELLS;
    map_flood(&m);
    for (uint32_t cell = 0; cell < CELLS * CELLS; ++cell) {
        if (!m.reached[cell / CELLS][cell % CELLS]) continue;
        ++reached;
        for (uint32_t i = 0; i < h->count; ++i)
            assert_true(point_distance(map_place(&m, cell), h->given_discs[i].center) > disc_radius(&h->given_discs[i], time));
    }
    return reached;
}

static void random_heap(heap_of_discs *h, uint64_t *chance)
{
    memset(h, 0, sizeof *h);
    uint32_t count = 1 + (uint32_t)chance_below(chance, MOST);
    double spread = chance_between(chance, 1.0, 8.0);
    while (h->count < count) {
        double rate = chance_below(chance, 2) ? 0.2 : chance_between(chance, 0.0, 1.4);
        add(h, chance_between(chance, -spread, spread), chance_between(chance, -spread, spread), chance_between(chance, 0.0, 1.5),
            rate);
    }
}

static void nobody_from_outside_ever_gets_into_a_dropped_disc(void **state)
{
    (void)state;
    static const double times[] = {0.0, 0.1, 0.5, 3.0};
    static heap_of_discs h;
    uint64_t chance = 1;
    uint32_t dropped = 0, kept = 0;
    for (int k = 0; k < 40; ++k) {
        random_heap(&h, &chance);
        drop_well(&h);
        for (size_t i = 0; i < 4; ++i) assert_true(assert_enclosed(&h, times[i]) > CELLS);
        kept += h.kept;
        dropped += h.count - h.kept;
    }
    assert_true(kept > 500 && dropped > 300);
}

/* A point of a disc's boundary at time 0 that no other disc holds proves that the disc matters. */
static void a_disc_with_a_bare_place_is_kept(void **state)
{
    (void)state;
    static heap_of_discs h;
    uint64_t chance = 2;
    for (int k = 0; k < 60; ++k) {
        random_heap(&h, &chance);
        drop_well(&h);
        for (uint32_t i = 0; i < h.count; ++i) {
            int bare = 0;
            for (int a = 0; a < 360 && !bare; ++a) {
                tdsp_point place = disc_boundary(&h.given_discs[i], GEOM_TURN * a / 360.0, 0.0);
                bare = 1;
                for (uint32_t j = 0; j < h.count; ++j)
                    if (j != i && point_distance(place, h.given_discs[j].center) <= h.given_discs[j].radius + 1e-9) bare = 0;
            }
            if (bare) assert_true(is_kept(&h, i));
        }
    }
}

static void what_is_kept_stays_whole_and_in_order(void **state)
{
    (void)state;
    static heap_of_discs h;
    uint64_t chance = 3;
    for (int k = 0; k < 30; ++k) {
        unsigned char seen[MOST] = {0};
        random_heap(&h, &chance);
        drop_well(&h);
        for (uint32_t i = 0; i < h.kept; ++i) {
            assert_int_equal(seen[h.given[i]], 0);
            seen[h.given[i]] = 1;
            assert_memory_equal(&h.discs[i], &h.given_discs[h.given[i]], sizeof h.discs[i]);
        }
    }
}

static void of_equal_discs_one_is_kept(void **state)
{
    (void)state;
    static heap_of_discs h;
    memset(&h, 0, sizeof h);
    for (int i = 0; i < 50; ++i) add(&h, 1.0, 2.0, 0.5, 0.3);
    drop_well(&h);
    assert_int_equal(h.kept, 1);
}

static void a_disc_inside_a_faster_one_is_dropped_and_inside_a_slower_one_kept(void **state)
{
    (void)state;
    static heap_of_discs h;
    memset(&h, 0, sizeof h);
    add(&h, 0.0, 0.0, 2.0, 0.3);
    add(&h, 0.5, 0.0, 1.0, 0.3);
    add(&h, 0.5, 0.5, 1.0, 0.31);
    drop_well(&h);
    assert_int_equal(h.kept, 2);
    assert_true(is_kept(&h, 0) && is_kept(&h, 2));
}

static void a_disc_ringed_by_others_is_dropped_only_when_the_ring_is_whole(void **state)
{
    (void)state;
    static heap_of_discs h;
    for (int gap = 0; gap < 2; ++gap) {
        memset(&h, 0, sizeof h);
        add(&h, 0.0, 0.0, 1.0, 0.1);
        for (int i = gap; i < 6; ++i) add(&h, cos(i * GEOM_TURN / 6.0), sin(i * GEOM_TURN / 6.0), 0.7, 0.1);
        drop_well(&h);
        assert_int_equal(h.kept, 6);
        assert_int_equal(is_kept(&h, 0), gap);
    }
}

/* The places that are looked at first: they alone prove nothing. */
static void a_disc_covered_at_eight_places_only_is_kept(void **state)
{
    (void)state;
    static heap_of_discs h;
    memset(&h, 0, sizeof h);
    add(&h, 0.0, 0.0, 1.0, 0.1);
    for (int i = 0; i < 8; ++i) add(&h, cos(i * GEOM_TURN / 8.0), sin(i * GEOM_TURN / 8.0), 0.1, 0.1);
    drop_well(&h);
    assert_int_equal(h.kept, 9);
}

static void points_that_never_grow_are_dropped(void **state)
{
    (void)state;
    static heap_of_discs h;
    memset(&h, 0, sizeof h);
    add(&h, 0.0, 0.0, 0.0, 0.0);
    add(&h, 1.0, 0.0, 0.0, 0.1);
    add(&h, 2.0, 0.0, 0.1, 0.0);
    drop_well(&h);
    assert_int_equal(h.kept, 2);
    assert_false(is_kept(&h, 0));
}

static void nothing_is_kept_of_nothing(void **state)
{
    (void)state;
    static heap_of_discs h;
    memset(&h, 0, sizeof h);
    h.kept = 7;
    drop_well(&h);
    assert_int_equal(h.kept, 0);
}

/* A(t) with each disc a very little faster the smaller it is: then no disc inside another is as slow, and none is dropped for that. */
static double arrival(const tdsp_disc *discs, size_t count, double departure, uint32_t *kept)
{
    const tdsp_journey journey = {1.0, 0.0, {-10.0, 0.0}, {10.0, 0.5}};
    tdsp_scene *scene;
    tdsp_solver *solver;
    double found = -1.0;
    assert_int_equal(tdsp_scene_create(&journey, discs, count, NULL, &scene), TDSP_OK);
    assert_int_equal(tdsp_solver_create(scene, &solver), TDSP_OK);
    assert_true(tdsp_status_is_answer(tdsp_earliest_arrival(solver, departure, &found)));
    *kept = scene->all.count;
    tdsp_solver_free(solver);
    tdsp_scene_free(scene);
    return found;
}

static void dropping_changes_no_arrival(void **state)
{
    (void)state;
    uint64_t chance = 4;
    uint32_t saved = 0;
    for (int k = 0; k < 150; ++k) {
        tdsp_disc discs[24], unequal[24];
        uint32_t few, many;
        double rate = chance_between(&chance, 0.0, 0.2);
        for (int i = 0; i < 24; ++i) {
            tdsp_disc disc = {{chance_between(&chance, -6.0, 6.0), chance_between(&chance, -4.0, 4.0)},
                              chance_between(&chance, 0.1, 2.0),
                              rate};
            discs[i] = unequal[i] = disc;
            unequal[i].growth *= 1.0 + 1e-9 * (2.0 - disc.radius);
        }
        double expected = arrival(unequal, 24, 0.5, &many), found = arrival(discs, 24, 0.5, &few);
        saved += many - few;
        if (isinf(found) != isinf(expected)) continue; /* a jump in between */
        if (fabs(found - expected) < 1e-2 || isinf(found)) assert_near(found, expected, 1e-6);
        assert_true(isinf(found) || found <= expected + 1e-6);
    }
    assert_true(saved > 100);
}

static void a_failed_allocation_is_told(void **state)
{
    (void)state;
    static heap_of_discs h;
    uint64_t chance = 5;
    random_heap(&h, &chance);
    for (size_t refuse = 1;; ++refuse) {
        tight_heap heap = {.refuse = refuse};
        tdsp_allocator memory = tight_allocator(&heap);
        tdsp_status status = drop(&h, &memory);
        assert_int_equal(heap.blocks, 0);
        assert_int_equal(heap.held, 0);
        if (status == TDSP_OK && refuse > heap.calls) break;
        assert_int_equal(status, TDSP_NO_MEMORY);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(nobody_from_outside_ever_gets_into_a_dropped_disc),
        cmocka_unit_test(a_disc_with_a_bare_place_is_kept),
        cmocka_unit_test(what_is_kept_stays_whole_and_in_order),
        cmocka_unit_test(of_equal_discs_one_is_kept),
        cmocka_unit_test(a_disc_inside_a_faster_one_is_dropped_and_inside_a_slower_one_kept),
        cmocka_unit_test(a_disc_ringed_by_others_is_dropped_only_when_the_ring_is_whole),
        cmocka_unit_test(a_disc_covered_at_eight_places_only_is_kept),
        cmocka_unit_test(points_that_never_grow_are_dropped),
        cmocka_unit_test(nothing_is_kept_of_nothing),
        cmocka_unit_test(dropping_changes_no_arrival),
        cmocka_unit_test(a_failed_allocation_is_told),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
