/* SPDX-License-Identifier: MIT */
/* One source and many destinations, many sources and one destination: that they share searches, and what happens when something fails. */
#include "support/cmocka_all.h"

#include "support/chance.h"
#include "support/tight.h"
#include "support/world.h"

static const tdsp_journey across = {1.0, 0.0, {-1.0, 0.0}, {21.0, 20.0}};

enum { DISCS = 120, PLACES = 600 };

static void crowd(tdsp_disc discs[DISCS], tdsp_point places[PLACES])
{
    uint64_t chance = 11;
    for (int i = 0; i < DISCS; ++i)
        discs[i] = (tdsp_disc){{chance_between(&chance, 0.0, 20.0), chance_between(&chance, 0.0, 20.0)}, chance_between(&chance, 0.3, 1.4), 0.01};
    for (int k = 0; k < PLACES; ++k) places[k] = (tdsp_point){chance_between(&chance, -1.0, 21.0), chance_between(&chance, -1.0, 21.0)};
}

static uint64_t searches(const tdsp_solver *solver)
{
    tdsp_solver_work work;
    assert_int_equal(tdsp_solver_work_done(solver, &work), TDSP_OK);
    return work.forward_searches + work.reverse_searches;
}

static void many_destinations_in_a_crowd_share_a_search_and_have_their_own_answers(void **state)
{
    (void)state;
    tdsp_disc discs[DISCS];
    static tdsp_point places[PLACES];
    static double arrivals[PLACES];
    crowd(discs, places);
    world w = world_make(across, discs, DISCS);
    assert_int_equal(tdsp_earliest_arrivals(w.solver, across.source, 0.5, places, PLACES, arrivals, NULL), TDSP_OK);
    assert_true(searches(w.solver) < PLACES / 2);
    for (int k = 0; k < PLACES; k += 7) {
        const tdsp_ends ends = {across.source, places[k]};
        double alone;
        assert_true(tdsp_status_is_answer(tdsp_earliest_arrival_for(w.solver, &ends, 0.5, &alone)));
        assert_near(arrivals[k], alone, 1e-9);
    }
    tdsp_leg leg;
    size_t count;
    assert_int_equal(tdsp_earliest_arrivals(w.solver, across.source, 0.5, places, PLACES, arrivals, NULL), TDSP_OK);
    assert_int_equal(tdsp_solver_path(w.solver, &leg, 1, &count), TDSP_NO_ANSWER);
    world_free(w);
}

static void many_sources_in_a_crowd_share_the_search_backwards(void **state)
{
    (void)state;
    tdsp_disc discs[DISCS];
    static tdsp_point places[PLACES];
    static double departures[PLACES], arrives[PLACES];
    static tdsp_status statuses[PLACES];
    crowd(discs, places);
    world shared = world_make(across, discs, DISCS), alone = world_make(across, discs, DISCS);
    assert_int_equal(tdsp_latest_departures(shared.solver, places, PLACES, across.destination, 24.0, departures, arrives, statuses), TDSP_OK);
    for (int k = 0; k < PLACES; ++k) {
        const tdsp_ends ends = {places[k], across.destination};
        double departure, there;
        assert_int_equal(tdsp_latest_departure_for(alone.solver, &ends, 24.0, &departure, &there), statuses[k]);
        assert_int_equal(isinf(departures[k]), statuses[k] != TDSP_OK);
        if (statuses[k] != TDSP_OK) continue;
        assert_near(departures[k], departure, 1e-8);
        assert_near(arrives[k], there, 1e-8);
    }
    assert_true(searches(shared.solver) < searches(alone.solver) * 3 / 4);
    world_free(shared);
    world_free(alone);
}

static void a_source_without_a_way_out_has_an_answer_for_each(void **state)
{
    (void)state;
    tdsp_disc discs[DISCS];
    static tdsp_point places[PLACES];
    static double arrivals[PLACES];
    static tdsp_status statuses[PLACES];
    crowd(discs, places);
    world w = world_make(across, discs, DISCS);
    assert_int_equal(tdsp_earliest_arrivals(w.solver, discs[0].center, 0.0, places, PLACES, arrivals, statuses), TDSP_OK);
    for (int k = 0; k < PLACES; ++k) {
        assert_int_equal(statuses[k], TDSP_SOURCE_COVERED);
        assert_true(isinf(arrivals[k]));
    }
    world_free(w);
}

/* Sharing pays by what the first ones took, and then there is nothing to share. */
static void a_crowd_of_places_of_which_only_the_first_are_apart_is_answered(void **state)
{
    (void)state;
    tdsp_disc discs[DISCS];
    static tdsp_point places[PLACES];
    static double times[PLACES];
    static tdsp_status statuses[PLACES];
    const int spacings[] = {5, 40, PLACES / 4 + 1}; /* with the last, those asked first */
    for (size_t i = 0; i < sizeof spacings / sizeof *spacings; ++i) {
        const int apart = spacings[i];
        crowd(discs, places);
        for (int k = 0; k < PLACES; ++k)
            if (k % apart) places[k] = across.source;
        world w = world_make(across, discs, DISCS);
        assert_int_equal(tdsp_earliest_arrivals(w.solver, across.source, 0.5, places, PLACES, times, statuses), TDSP_OK);
        for (int k = 0; k < PLACES; ++k)
            if (k % apart) assert_exact(times[k], 0.5);
        world_free(w);
    }
}

static void what_cannot_be_asked_is_refused_and_the_arrays_are_untouched(void **state)
{
    (void)state;
    const tdsp_disc disc = {{5.0, 5.0}, 1.0, 1e-14};
    world w = world_make(across, &disc, 1);
    tdsp_point places[6] = {{1, 1}, {2, 2}, {3, 0}, {4, 4}, {5, 0}, {NAN, 0}};
    double times[6] = {-7, -7, -7, -7, -7, -7};
    assert_int_equal(tdsp_earliest_arrivals(NULL, places[0], 0.0, places, 5, times, NULL), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_earliest_arrivals(w.solver, places[0], -1.0, places, 5, times, NULL), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_earliest_arrivals(w.solver, places[0], INFINITY, places, 5, times, NULL), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_earliest_arrivals(w.solver, places[0], 0.0, NULL, 5, times, NULL), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_earliest_arrivals(w.solver, places[0], 0.0, places, 5, NULL, NULL), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_earliest_arrivals(w.solver, places[0], 0.0, places, 6, times, NULL), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_earliest_arrivals(w.solver, places[5], 0.0, places, 5, times, NULL), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_earliest_arrivals(w.solver, places[0], 1e14, places, 5, times, NULL), TDSP_NOT_SUPPORTED);
    assert_int_equal(tdsp_latest_departures(NULL, places, 5, places[0], 9.0, times, NULL, NULL), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_latest_departures(w.solver, places, 5, places[0], -1.0, times, NULL, NULL), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_latest_departures(w.solver, places, 6, places[0], 9.0, times, NULL, NULL), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_latest_departures(w.solver, NULL, 5, places[0], 9.0, times, NULL, NULL), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_latest_departures(w.solver, places, 5, places[0], 9.0, NULL, NULL, NULL), TDSP_INVALID_ARGUMENT);
    for (int k = 0; k < 6; ++k) assert_exact(times[k], -7.0);
    assert_int_equal(tdsp_earliest_arrivals(w.solver, places[0], 0.0, NULL, 0, NULL, NULL), TDSP_OK);
    assert_int_equal(tdsp_latest_departures(w.solver, NULL, 0, places[0], INFINITY, NULL, NULL, NULL), TDSP_OK);
    tdsp_ends ends;
    assert_int_equal(tdsp_solver_ends(w.solver, &ends), TDSP_OK);
    assert_memory_equal(&ends.source, &across.source, sizeof ends.source);
    world_free(w);
}

static void a_failing_allocation_is_reported_and_leaves_no_block(void **state)
{
    (void)state;
    tdsp_disc discs[DISCS];
    static tdsp_point places[PLACES];
    static double arrivals[PLACES];
    tight_heap heap = {0};
    tdsp_allocator memory = tight_allocator(&heap);
    tdsp_scene *scene;
    tdsp_solver *solver;
    crowd(discs, places);
    assert_int_equal(tdsp_scene_create(&across, discs, DISCS, &memory, &scene), TDSP_OK);
    tdsp_status status = TDSP_NO_MEMORY;
    for (size_t refuse = 1; status == TDSP_NO_MEMORY; ++refuse) {
        assert_int_equal(tdsp_solver_create(scene, &solver), TDSP_OK);
        heap.refuse = heap.calls + refuse;
        status = tdsp_earliest_arrivals(solver, across.source, 0.0, places, PLACES, arrivals, NULL);
        heap.refuse = 0;
        tdsp_solver_free(solver);
    }
    assert_int_equal(status, TDSP_OK);
    tdsp_scene_free(scene);
    assert_int_equal(heap.blocks, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(many_destinations_in_a_crowd_share_a_search_and_have_their_own_answers),
        cmocka_unit_test(many_sources_in_a_crowd_share_the_search_backwards),
        cmocka_unit_test(a_source_without_a_way_out_has_an_answer_for_each),
        cmocka_unit_test(a_crowd_of_places_of_which_only_the_first_are_apart_is_answered),
        cmocka_unit_test(what_cannot_be_asked_is_refused_and_the_arrays_are_untouched),
        cmocka_unit_test(a_failing_allocation_is_reported_and_leaves_no_block),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
