/* SPDX-License-Identifier: MIT */
/* Why there is no way: where the destination's cover ends the departures, nothing else is told for who leaves later. */
#include "support/cmocka_all.h"

#include "search/solver.h"
#include "support/random_scene.h"
#include "support/world.h"
#include "tdsp/growth.h"

static const tdsp_method methods[] = {TDSP_METHOD_AUTO, TDSP_METHOD_GENERAL};

enum { METHODS = sizeof methods / sizeof *methods };

static const double later[] = {1e-10, 1e-9, 3e-9, 1e-8, 1e-6, 1e-4, 1e-3, 1e-2, 0.1, 0.5};

enum { LATER = sizeof later / sizeof *later };

/* From `shortest` on after the last departure, where a touch is no excuse, and as long as the source is free. */
static void reason_stays(tdsp_solver *solver, tdsp_status reason, double last, double shortest, double free_until)
{
    double arrival = 0.0;
    for (int k = 0; k < LATER; ++k)
        if (later[k] >= shortest && last + later[k] < free_until) assert_int_equal(tdsp_earliest_arrival(solver, last + later[k], &arrival), reason);
    assert_int_equal(tdsp_earliest_arrival(solver, last, &arrival), TDSP_OK);
}

/* The last robot arrives as a disc covers the destination: that disc is told, and nothing else for who leaves later. */
static void cover_ends(const tdsp_scene *scene, tdsp_method method, uint32_t disc, double departure)
{
    tdsp_solver *solver;
    tdsp_last_departure last;
    const double covered = tdsp_scene_destination_free_until(scene, NULL);
    assert_int_equal(tdsp_solver_create_for(scene, method, &solver), TDSP_OK);
    assert_int_equal(tdsp_solver_last_departure(solver, &last), TDSP_OK);
    assert_int_equal(last.reason, TDSP_DESTINATION_COVERED);
    assert_int_equal(last.disc, disc);
    assert_near(last.arrival, covered, 1e-10);
    assert_near(last.time, covered, 1e-12);
    if (departure >= 0.0) assert_near(last.departure, departure, 1e-10);
    reason_stays(solver, TDSP_DESTINATION_COVERED, last.departure, 1e-10, tdsp_scene_source_free_until(scene, NULL));
    tdsp_solver_free(solver);
}

static void cover_ends_among_rates(const tdsp_journey *journey, const tdsp_disc *discs, size_t count, uint32_t disc, double departure)
{
    tdsp_scene *scene;
    assert_int_equal(tdsp_scene_create(journey, discs, count, NULL, &scene), TDSP_OK);
    for (int k = 0; k < METHODS; ++k) cover_ends(scene, methods[k], disc, departure);
    tdsp_scene_free(scene);
}

/*
 * The disc below as fast as the robot reaches the axis a little before the destination a little sooner: who is late by 1e-8 meets it 1e-8 before the destination, 3e-11 before
 * that is covered. It was told that discs cut the ends off from each other, and of the last departure too.
 */
static void the_cover_ends_the_departures_also_where_its_disc_meets_who_is_late_before_the_destination(void **state)
{
    (void)state;
    const tdsp_journey journey = {1.0, 0.0, {0.0, 0.0}, {2.0, 0.0}};
    const tdsp_disc discs[] = {{{1.99, -3.0}, 0.0, 1.0}, {{-2.0, 0.0}, 0.0, 1.0}};
    cover_ends_among_rates(&journey, discs, 2, 0, sqrt(9.0001) - 2.0);
}

/* The disc comes from behind, over the source at 10 and over the destination at 15. */
static void the_cover_ends_the_departures_also_where_its_disc_overtakes_who_is_late(void **state)
{
    (void)state;
    const tdsp_journey journey = {1.0, 0.0, {0.0, 0.0}, {10.0, 0.0}};
    const tdsp_disc disc = {{-20.0, 0.0}, 0.0, 2.0};
    cover_ends_among_rates(&journey, &disc, 1, 0, 5.0);
}

/* The same with a disc that can be ridden: who is late flies past in front of the destination, and no ride on that disc comes back to it. */
static void the_cover_ends_the_departures_also_where_who_is_late_flies_past(void **state)
{
    (void)state;
    const tdsp_journey journey = {1.0, 0.0, {0.0, 0.0}, {2.0, 0.0}};
    const tdsp_disc discs[] = {{{1.99, -3.0}, 0.0, 0.9}, {{-1.4, 0.0}, 0.0, 1.0}};
    cover_ends_among_rates(&journey, discs, 2, 0, sqrt(9.0001) / 0.9 - 2.0);
}

/*
 * A ring about the destination closes on its far side, and 1 later a disc in it covers the destination. From the source, for which the way to the gap might be straight, no wall
 * shows; but no robot arrives in the moment of the cover.
 */
static void a_gap_that_closes_cuts_off_also_where_the_destination_is_covered_soon_after(void **state)
{
    (void)state;
    enum { RING = 24 };
    const tdsp_journey journey = {1.0, 0.0, {-10.0, 0.0}, {10.0, 0.0}};
    tdsp_disc discs[RING];
    for (int i = 1; i < RING; ++i) {
        const double angle = i * GEOM_TURN / (double)RING;
        discs[i] = (tdsp_disc){{10.0 + 4.0 * cos(angle), 4.0 * sin(angle)}, 0.7, i == 1 || i == RING - 1 ? 0.005 : 0.0};
    }
    discs[0] = (tdsp_disc){{10.0, 1.5}, 0.5, 1.0 / 72.0};
    world w = world_make(journey, discs, RING);
    tdsp_last_departure last;
    assert_int_equal(tdsp_solver_last_departure(w.solver, &last), TDSP_OK);
    assert_int_equal(last.reason, TDSP_CUT_OFF);
    assert_true(last.arrival < tdsp_scene_destination_free_until(w.scene, NULL) - 1.0);
    reason_stays(w.solver, TDSP_CUT_OFF, last.departure, 3e-9, INFINITY);
    world_free(w);
}

enum { NEAR = 20, FAR = 80, SEEDS = 8, ASKED = 12 };

static tdsp_status status_at(tdsp_solver *solver, double departure)
{
    double arrival;
    return tdsp_earliest_arrival(solver, departure, &arrival);
}

/* The same scene with discs far away that matter to nobody, so many that few are asked first. */
static void add_far_discs(tdsp_disc *discs, const tdsp_journey *journey)
{
    const double unit = point_distance(journey->source, journey->destination);
    for (int i = 0; i < FAR; ++i)
        discs[NEAR + i] = (tdsp_disc){{journey->source.x + unit * (1000.0 + i), journey->source.y + unit * (500.0 - 7.0 * i)}, 0.1 * unit, 0.0};
}

/*
 * The latest departure that arrives as the destination is covered was asked for among a part of the discs first. Backwards in time nobody waits until the source is free: among fewer
 * discs there may be no such departure although there is one among all.
 */
static void discs_far_away_change_no_reason_by_the_general_method(void **state)
{
    (void)state;
    for (int mix = 0; mix < RANDOM_MIX_COUNT; ++mix) {
        if (mix == RANDOM_FAR_ORIGIN || mix == RANDOM_ON_SOURCE || mix == RANDOM_ON_DESTINATION || mix == RANDOM_TOUCHING) continue; /* a larger extent rounds them otherwise */
        for (uint64_t seed = 0; seed < SEEDS; ++seed) {
            tdsp_disc discs[NEAR + FAR];
            tdsp_journey journey;
            random_scene(seed, (random_mix)mix, NEAR, &journey, discs);
            add_far_discs(discs, &journey);
            world few = world_make(journey, discs, NEAR), many = world_make(journey, discs, NEAR + FAR);
            tdsp_solver *solver;
            const double end = math_min(tdsp_scene_source_free_until(few.scene, NULL), 2.0 * few.unit);
            assert_int_equal(tdsp_solver_create_for(many.scene, TDSP_METHOD_GENERAL, &solver), TDSP_OK);
            for (int k = 1; k < ASKED; ++k) assert_int_equal(status_at(solver, end * k / (double)ASKED), status_at(few.solver, end * k / (double)ASKED));
            tdsp_solver_free(solver);
            world_free(few);
            world_free(many);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_cover_ends_the_departures_also_where_its_disc_meets_who_is_late_before_the_destination),
        cmocka_unit_test(the_cover_ends_the_departures_also_where_its_disc_overtakes_who_is_late),
        cmocka_unit_test(the_cover_ends_the_departures_also_where_who_is_late_flies_past),
        cmocka_unit_test(discs_far_away_change_no_reason_by_the_general_method),
        cmocka_unit_test(a_gap_that_closes_cuts_off_also_where_the_destination_is_covered_soon_after),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
