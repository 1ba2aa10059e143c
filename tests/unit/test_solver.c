/* SPDX-License-Identifier: MIT */
/* The solver's public face: closed forms, statuses, paths, arguments, counters, threads. */
#include "support/cmocka_all.h"

#include <pthread.h>
#include <string.h>

#include "support/chance.h"
#include "support/random_scene.h"
#include "support/world.h"
#include "tdsp/solver.h"
#include "tdsp/verify.h"

enum { LEGS = 256 };

/* The path of the last answer is good, starts and ends as told, and its legs join to the bit. */
static size_t check_path(world w, double departure, double arrival)
{
    tdsp_leg legs[LEGS];
    size_t count;
    tdsp_verdict verdict;
    assert_int_equal(tdsp_solver_path(w.solver, legs, LEGS, &count), TDSP_OK);
    assert_int_equal(tdsp_verify_path(w.scene, legs, count, departure, arrival, &verdict), TDSP_OK);
    assert_int_equal(verdict.problems, 0);
    if (count == 0) return 0;
    assert_exact(legs[0].start_time, departure);
    assert_exact(legs[count - 1].end_time, arrival);
    assert_memory_equal(&legs[0].from, &tdsp_scene_journey(w.scene)->source, sizeof legs[0].from);
    assert_memory_equal(&legs[count - 1].to, &tdsp_scene_journey(w.scene)->destination, sizeof legs[0].to);
    for (size_t i = 1; i < count; ++i) {
        assert_exact(legs[i].start_time, legs[i - 1].end_time);
        assert_memory_equal(&legs[i].from, &legs[i - 1].to, sizeof legs[i].from);
    }
    return count;
}

static double arrival_of(tdsp_journey journey, const tdsp_disc *discs, size_t count, double departure)
{
    double arrival = -1.0;
    world w = world_make(journey, discs, count);
    assert_int_equal(tdsp_earliest_arrival(w.solver, departure, &arrival), TDSP_OK);
    check_path(w, departure, arrival);
    world_free(w);
    return arrival;
}

static tdsp_status status_of(tdsp_journey journey, const tdsp_disc *discs, size_t count, double departure)
{
    double arrival = -1.0;
    size_t legs = 77;
    world w = world_make(journey, discs, count);
    tdsp_status status = tdsp_earliest_arrival(w.solver, departure, &arrival);
    assert_exact(arrival, INFINITY);
    assert_int_equal(tdsp_solver_path(w.solver, NULL, 0, &legs), TDSP_NO_ANSWER);
    assert_int_equal(legs, 77);
    world_free(w);
    return status;
}

static const tdsp_journey across = {1.0, 0.0, {-10.0, 0.0}, {10.0, 0.0}};

static void without_discs_the_way_is_straight(void **state)
{
    (void)state;
    const tdsp_journey journey = {2.5, 3.0, {1.0, 2.0}, {4.0, 6.0}};
    assert_near(arrival_of(journey, NULL, 0, 0.0), 2.0, 1e-15);
    assert_near(arrival_of(journey, NULL, 0, 7.0), 9.0, 1e-15);
}

static void a_standing_disc_is_passed_by_tangents_and_an_arc(void **state)
{
    (void)state;
    const tdsp_disc disc = {{0.0, 0.0}, 3.0, 0.0};
    double tangent = sqrt(91.0), arc = 3.0 * (acos(-1.0) - 2.0 * acos(0.3));
    for (double t = 0.0; t < 10.0; t += 2.5) assert_near(arrival_of(across, &disc, 1, t), t + 2.0 * tangent + arc, 1e-13);
    const tdsp_disc slim = {{0.0, 0.0}, 2.5, 0.0};
    tdsp_journey wide = across;
    wide.radius = 0.5;
    assert_near(arrival_of(wide, &slim, 1, 0.0), 2.0 * tangent + arc, 1e-13);
}

/* One growing disc on the line: tangent, logarithmic spiral, tangent, each from its own equation; the last meets d at the same heading. */
static double growing_arrival(double radius, double rate, double departure)
{
    double c = rate, s = sqrt(1.0 - c * c), r0 = radius + rate * departure;
    /* Back from the touch by L, at theta to the normal, the source is r0 ahead of the centre along the normal and s L beside it. */
    double first = sqrt(100.0 - r0 * r0) / s, touch = departure + first, r = r0 + c * first;
    double seen = atan2(s * first, r0), lo = touch, hi = touch + 100.0;
    for (int k = 0; k < 200; ++k) {
        double leave = 0.5 * (lo + hi), at = radius + rate * leave, turned = s / c * log(at / r);
        double length = -c * at + sqrt(100.0 - s * at * s * at), ahead = atan2(s * length, at + c * length);
        *(seen + turned + ahead < acos(-1.0) ? &lo : &hi) = leave;
    }
    double at = radius + rate * lo;
    return lo - c * at + sqrt(100.0 - s * at * s * at);
}

static void a_growing_disc_is_passed_by_tangents_and_a_spiral(void **state)
{
    (void)state;
    for (double rate = 0.05; rate < 0.25; rate += 0.05)
        for (double t = 0.0; t < 3.0; t += 1.0) {
            const tdsp_disc disc = {{0.0, 0.0}, 2.0, rate};
            assert_near(arrival_of(across, &disc, 1, t), growing_arrival(2.0, rate, t), 1e-11);
        }
}

static void source_and_destination_the_same_take_no_time_and_no_legs(void **state)
{
    (void)state;
    const tdsp_journey stay = {1.0, 0.0, {3.0, 4.0}, {3.0, 4.0}};
    const tdsp_disc disc = {{10.0, 4.0}, 1.0, 0.5};
    double departure = -1.0, arrives = -1.0, arrival = -1.0;
    world w = world_make(stay, &disc, 1);
    assert_int_equal(tdsp_earliest_arrival(w.solver, 5.0, &arrival), TDSP_OK);
    assert_exact(arrival, 5.0);
    assert_int_equal(check_path(w, 5.0, 5.0), 0);
    assert_int_equal(tdsp_latest_departure(w.solver, 7.5, &departure, &arrives), TDSP_OK);
    assert_exact(departure, 7.5);
    assert_exact(arrives, 7.5);
    assert_int_equal(tdsp_latest_departure(w.solver, 1e9, &departure, &arrives), TDSP_OK);
    assert_near(departure, 12.0, 1e-12);
    assert_int_equal(tdsp_earliest_arrival(w.solver, 12.5, &arrival), TDSP_SOURCE_COVERED);
    world_free(w);
}

static void a_covered_source_is_told(void **state)
{
    (void)state;
    const tdsp_disc at_once = {{-10.0, 1.0}, 2.0, 0.0}, later = {{-10.0, 3.0}, 1.0, 0.5};
    assert_int_equal(status_of(across, &at_once, 1, 0.0), TDSP_SOURCE_COVERED);
    assert_int_equal(status_of(across, &later, 1, 4.5), TDSP_SOURCE_COVERED);
    assert_true(arrival_of(across, &later, 1, 3.9) < INFINITY);
}

static void a_destination_that_is_covered_too_soon_is_told(void **state)
{
    (void)state;
    const tdsp_disc disc = {{10.0, 5.0}, 1.0, 0.25}; /* covers the destination at 16, and the way there takes 20 */
    assert_int_equal(status_of(across, &disc, 1, 0.0), TDSP_DESTINATION_COVERED);
    const tdsp_disc slower = {{10.0, 5.0}, 1.0, 0.19}; /* at 21.05 */
    assert_near(arrival_of(across, &slower, 1, 1.0), 21.0, 1e-12);
    assert_int_equal(status_of(across, &slower, 1, 1.1), TDSP_DESTINATION_COVERED);
}

static void being_cut_off_is_told(void **state)
{
    (void)state;
    tdsp_disc ring[24];
    for (int i = 0; i < 24; ++i) {
        tdsp_disc disc = {{10.0 + 4.0 * cos(i * 0.2618), 4.0 * sin(i * 0.2618)}, 0.7, 0.0};
        ring[i] = disc;
    }
    assert_int_equal(status_of(across, ring, 24, 0.0), TDSP_CUT_OFF);
}

static void a_source_on_a_boundary_may_ride_away_or_leave(void **state)
{
    (void)state;
    const tdsp_disc behind = {{-11.0, 0.0}, 1.0, 0.0}, before = {{-9.0, 0.0}, 1.0, 0.0};
    assert_near(arrival_of(across, &behind, 1, 0.0), 20.0, 1e-13);
    double arc = acos(-1.0) - acos(1.0 / 19.0);
    assert_near(arrival_of(across, &before, 1, 0.0), arc + sqrt(360.0), 1e-7);
}

static void a_destination_on_a_standing_boundary_is_reached_by_riding(void **state)
{
    (void)state;
    const tdsp_disc disc = {{9.0, 0.0}, 1.0, 0.0};
    double reach = sqrt(19.0 * 19.0 - 1.0), arc = acos(-1.0) - acos(1.0 / 19.0);
    for (double t = 0.0; t < 5.0; t += 0.7) assert_near(arrival_of(across, &disc, 1, t), t + reach + arc, 1e-7);
}

static tdsp_point rotated(double x, double y, double angle)
{
    tdsp_point p = {x * cos(angle) - y * sin(angle), x * sin(angle) + y * cos(angle)};
    return p;
}

/* Two rides began at one place and moment on one disc, and each gave way to the other: T was 2.856 for 1,686 of 162,500 departures. */
static void riders_who_come_together_do_not_both_give_way(void **state)
{
    (void)state;
    for (int k = 0; k < 200; ++k) {
        double angle = 0.03 * k;
        const tdsp_disc discs[2] = {{rotated(0.0, 0.5, angle), 0.5, 0.0}, {rotated(0.0, 0.0, angle), 0.5, 0.0}};
        const tdsp_journey journey = {1.0, 0.0, rotated(0.5, 0.5, angle), rotated(0.0, -0.5, angle)};
        world w = world_make(journey, discs, 2);
        for (int i = 0; i < 100; ++i) {
            double arrival = -1.0, t = 0.0137 * i;
            tdsp_status status = tdsp_earliest_arrival(w.solver, t, &arrival);
            if (status == TDSP_SOURCE_COVERED || tdsp_scene_destination_free_until(w.scene, NULL) < 0.0) break; /* rounding put it inside */
            assert_int_equal(status, TDSP_OK);
            assert_near(arrival - t, 0.5 + 0.25 * acos(-1.0), 1e-7);
        }
        world_free(w);
    }
}

/* A chunk of a ride took less time than separates two doubles, and the ride went on for ever. */
static void a_pebble_late_in_time_does_not_hold_the_robot_for_ever(void **state)
{
    (void)state;
    const tdsp_disc disc = {{0.0, 0.0}, 1e-6, 0.0};
    for (double t = 1e9; t < 1e13; t *= 10.0) {
        double arrival = -1.0;
        world w = world_make(across, &disc, 1);
        assert_true(tdsp_status_is_answer(tdsp_earliest_arrival(w.solver, t, &arrival)));
        world_free(w);
    }
}

/* A ride on a disc of no radius has no angle: the search refused its own label. */
static void a_point_that_begins_to_grow_at_the_source_is_left_behind(void **state)
{
    (void)state;
    const tdsp_journey journey = {1.0, 0.0, {-8.0, -8.0}, {-7.5, -6.5}};
    const tdsp_disc discs[2] = {{{-8.0, -8.0}, 0.0, 0.1}, {{-8.0, -7.5}, 0.5, 0.0}};
    double departure = -1.0, arrival = arrival_of(journey, discs, 2, 0.0);
    assert_near(arrival, 1.0 + 0.25 * acos(-1.0), 1e-7);
    world w = world_make(journey, discs, 2);
    assert_int_equal(tdsp_latest_departure(w.solver, arrival, &departure, NULL), TDSP_OK);
    assert_near(departure, 0.0, 1e-10);
    world_free(w);
}

static void a_pebble_beside_the_source_makes_nothing_faster(void **state)
{
    (void)state;
    const tdsp_journey journey = {1.0, 0.0, {-8.0, 7.6428571428571432}, {-7.5, -8.0}};
    const tdsp_disc discs[2] = {{{0.0, -3.0}, 2.5, 0.25}, {{-8.0, 0.0}, 1e-9, 0.0}};
    const double departures[4] = {0.0, 10.0, 10.3, 10.3557};
    for (int i = 0; i < 4; ++i)
        assert_near(arrival_of(journey, discs, 2, departures[i]), arrival_of(journey, discs, 1, departures[i]), 1e-11);
}

static void a_disc_that_shrinks_to_a_point_backwards_is_left_in_time(void **state)
{
    (void)state;
    const tdsp_journey journey = {1.0, 0.0, {-5.5, -8.0}, {2.0, -8.0}};
    const tdsp_disc discs[2] = {{{-8.0, -8.0}, 0.5, 0.0}, {{-5.5, -8.0}, 0.0, 0.999}};
    world w = world_make(journey, discs, 2);
    double departure = -1.0, arrives = -1.0;
    assert_int_equal(tdsp_latest_departure(w.solver, 9.0, &departure, &arrives), TDSP_OK);
    assert_exact(departure, 0.0);
    assert_near(arrives, 7.5, 1e-11);
    world_free(w);
}

static void times_too_many_journeys_away_are_refused(void **state)
{
    (void)state;
    const tdsp_journey journey = {1.0, 0.0, {0.0, 0.0}, {1.0, 0.0}};
    const tdsp_disc growing = {{0.0, 9.0}, 1.0, 1e-14}, still = {{0.0, 9.0}, 1.0, 0.0};
    double arrival = 77.0;
    world w = world_make(journey, &growing, 1);
    assert_int_equal(tdsp_earliest_arrival(w.solver, 1e13, &arrival), TDSP_NOT_SUPPORTED);
    assert_exact(arrival, 77.0);
    assert_int_equal(tdsp_earliest_arrival(w.solver, 1e6, &arrival), TDSP_OK);
    assert_near(arrival, 1e6 + 1.0, 1e-9);
    world_free(w);
    assert_near(arrival_of(journey, &still, 1, 1e13), 1e13 + 1.0, 1e-2);
}

static void a_latest_departure_arrives_by_the_arrival_to_the_last_bit(void **state)
{
    (void)state;
    const tdsp_journey journey = {1.0, 0.0, {-10.0, 0.0}, {10.0, 0.0}};
    const tdsp_disc disc = {{0.0, 0.0}, 2.0, 0.1};
    world w = world_make(journey, &disc, 1);
    for (int i = 0; i < 2000; ++i) {
        double a = 30.0 + 0.0137394 * i, departure = -1.0, arrives = INFINITY;
        assert_int_equal(tdsp_latest_departure(w.solver, a, &departure, &arrives), TDSP_OK);
        assert_true(arrives <= a);
    }
    world_free(w);
}

static void halving_ends_where_a_pebble_hides_the_way_back(void **state)
{
    (void)state;
    const tdsp_journey journey = {1.0, 0.0, {-2.0000000010000001, -7.0000000010000001}, {4.1428571428571432, -3.0}};
    const tdsp_disc discs[2] = {{{7.6428571428571432, 7.6428571428571432}, 5.0, 0.3}, {{-2.0, -7.0000000010000001}, 1.0000000000000001e-09, 0.0}};
    world w = world_make(journey, discs, 2);
    double departure = -1.0;
    assert_int_equal(tdsp_latest_departure(w.solver, 7.4228952076349897, &departure, NULL), TDSP_OK);
    assert_near(departure, 0.0925, 1e-10);
    world_free(w);
}

static void bad_arguments_are_refused_and_touch_nothing(void **state)
{
    (void)state;
    static const double bad[] = {-1.0, -1e-300, NAN, INFINITY, -INFINITY};
    double arrival = 77.0, departure = 77.0, arrives = 77.0;
    size_t count;
    tdsp_leg leg;
    tdsp_oracle oracle;
    tdsp_solver *solver;
    tdsp_solver_work work;
    tdsp_last_departure last;
    world w = world_make(across, NULL, 0);
    for (int i = 0; i < 5; ++i) assert_int_equal(tdsp_earliest_arrival(w.solver, bad[i], &arrival), TDSP_INVALID_ARGUMENT);
    for (int i = 0; i < 5; ++i)
        if (i != 3) assert_int_equal(tdsp_latest_departure(w.solver, bad[i], &departure, &arrives), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_earliest_arrival(NULL, 0.0, &arrival), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_earliest_arrival(w.solver, 0.0, NULL), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_latest_departure(NULL, 1.0, &departure, &arrives), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_latest_departure(w.solver, 1.0, NULL, &arrives), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_solver_last_departure(NULL, &last), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_solver_last_departure(w.solver, NULL), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_solver_path(NULL, &leg, 1, &count), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_solver_path(w.solver, NULL, 1, &count), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_solver_path(w.solver, &leg, 1, NULL), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_solver_path(w.solver, &leg, 1, &count), TDSP_NO_ANSWER);
    assert_int_equal(tdsp_solver_create(NULL, &solver), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_solver_create(w.scene, NULL), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_solver_work_done(NULL, &work), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_solver_work_done(w.solver, NULL), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_solver_oracle(NULL, &oracle), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_solver_oracle(w.solver, NULL), TDSP_INVALID_ARGUMENT);
    assert_true(arrival == 77.0 && departure == 77.0 && arrives == 77.0);
    tdsp_solver_free(NULL);
    world_free(w);
}

static void a_path_says_how_much_room_it_needs(void **state)
{
    (void)state;
    const tdsp_disc disc = {{0.0, 0.0}, 3.0, 0.1};
    tdsp_leg legs[3];
    double arrival;
    size_t count = 0;
    world w = world_make(across, &disc, 1);
    assert_int_equal(tdsp_earliest_arrival(w.solver, 0.0, &arrival), TDSP_OK);
    memset(legs, 7, sizeof legs);
    const tdsp_leg untouched = legs[0];
    assert_int_equal(tdsp_solver_path(w.solver, legs, 2, &count), TDSP_BUFFER_TOO_SMALL);
    assert_int_equal(count, 3);
    assert_memory_equal(&legs[0], &untouched, sizeof untouched);
    assert_int_equal(tdsp_solver_path(w.solver, NULL, 0, &count), TDSP_BUFFER_TOO_SMALL);
    assert_int_equal(tdsp_solver_path(w.solver, legs, 3, &count), TDSP_OK);
    assert_int_equal(legs[1].kind, TDSP_LEG_ARC);
    assert_int_equal(legs[1].disc, 0);
    world_free(w);
}

static void counters_count(void **state)
{
    (void)state;
    const tdsp_disc disc = {{0.0, 0.0}, 3.0, 0.1};
    double value;
    tdsp_solver_work before, after;
    world w = world_make(across, &disc, 1);
    assert_int_equal(tdsp_solver_work_done(w.solver, &before), TDSP_OK);
    assert_int_equal(before.forward_searches + before.reverse_searches + before.labels + before.legs_tested, 0);
    assert_int_equal(tdsp_earliest_arrival(w.solver, 0.0, &value), TDSP_OK);
    assert_int_equal(tdsp_solver_work_done(w.solver, &after), TDSP_OK);
    assert_int_equal(after.forward_searches, 1);
    assert_true(after.labels > 0 && after.legs_tested > 0 && after.bytes >= before.bytes);
    assert_int_equal(tdsp_latest_departure(w.solver, 40.0, &value, NULL), TDSP_OK);
    assert_int_equal(tdsp_solver_work_done(w.solver, &before), TDSP_OK);
    assert_true(before.reverse_searches >= 1);
    world_free(w);
}

static void the_oracle_answers_as_the_solver(void **state)
{
    (void)state;
    const tdsp_disc disc = {{0.0, 0.0}, 3.0, 0.1};
    double a = -1.0, b = -2.0;
    tdsp_oracle oracle;
    tdsp_oracle_path path;
    tdsp_status reason = TDSP_OK;
    world w = world_make(across, &disc, 1), other = world_make(across, &disc, 1);
    assert_int_equal(tdsp_solver_oracle(w.solver, &oracle), TDSP_OK);
    assert_int_equal(oracle.monotone, TDSP_MONOTONE_TRAVEL);
    assert_int_equal(oracle.path(oracle.ctx, &path), TDSP_NO_ANSWER);
    assert_int_equal(oracle.earliest_arrival(oracle.ctx, 1.5, &a), tdsp_earliest_arrival(other.solver, 1.5, &b));
    assert_exact(a, b);
    assert_int_equal(oracle.path(oracle.ctx, &path), TDSP_OK);
    assert_int_equal(path.leg_count, 3);
    assert_int_equal(path.byte_count, 0);
    assert_int_equal(oracle.latest_departure(oracle.ctx, 40.0, &a), tdsp_latest_departure(other.solver, 40.0, &b, NULL));
    assert_exact(a, b);
    assert_int_equal(oracle.latest_departure(oracle.ctx, INFINITY, &a), TDSP_OK);
    assert_int_equal(oracle.last_reason(oracle.ctx, a, &reason), TDSP_OK);
    tdsp_last_departure last;
    assert_int_equal(tdsp_solver_last_departure(other.solver, &last), TDSP_OK);
    assert_int_equal(reason, last.reason);
    world_free(w);
    world_free(other);
}

typedef struct job {
    const tdsp_scene *scene;
    double arrivals[60];
    double departures[60];
    int failed;
} job;

static void *job_run(void *ctx)
{
    job *j = ctx;
    tdsp_solver *solver;
    j->failed = tdsp_solver_create(j->scene, &solver) != TDSP_OK;
    for (int i = 0; i < 60 && !j->failed; ++i) {
        j->failed |= !tdsp_status_is_answer(tdsp_earliest_arrival(solver, 0.02 * i, &j->arrivals[i]));
        j->departures[i] = -1.0;
        j->failed |= !tdsp_status_is_answer(tdsp_latest_departure(solver, 1.0 + 0.05 * i, &j->departures[i], NULL));
    }
    if (!j->failed) tdsp_solver_free(solver);
    return NULL;
}

static void two_threads_with_one_scene_get_the_same_bits(void **state)
{
    (void)state;
    tdsp_disc discs[64];
    tdsp_journey journey;
    random_scene(3, RANDOM_MIXED_RATES, 64, &journey, discs);
    world w = world_make(journey, discs, 64);
    static job jobs[2];
    pthread_t threads[2];
    for (int i = 0; i < 2; ++i) {
        jobs[i].scene = w.scene;
        assert_int_equal(pthread_create(&threads[i], NULL, job_run, &jobs[i]), 0);
    }
    for (int i = 0; i < 2; ++i) assert_int_equal(pthread_join(threads[i], NULL), 0);
    assert_int_equal(jobs[0].failed + jobs[1].failed, 0);
    assert_memory_equal(jobs[0].arrivals, jobs[1].arrivals, sizeof jobs[0].arrivals);
    assert_memory_equal(jobs[0].departures, jobs[1].departures, sizeof jobs[0].departures);
    world_free(w);
}

static void every_path_of_random_scenes_is_good_and_joins_to_the_bit(void **state)
{
    (void)state;
    size_t legs = 0;
    for (int mix = 0; mix < RANDOM_MIX_COUNT; ++mix)
        for (uint64_t seed = 100; seed < 110; ++seed) {
            tdsp_disc discs[16];
            tdsp_journey journey;
            random_scene(seed, (random_mix)mix, 16, &journey, discs);
            world w = world_make(journey, discs, 16);
            double arrival = -1.0;
            for (int i = 0; i < 3; ++i)
                if (tdsp_earliest_arrival(w.solver, 0.1 * i, &arrival) == TDSP_OK) legs += check_path(w, 0.1 * i, arrival);
            world_free(w);
        }
    assert_true(legs > 500);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(without_discs_the_way_is_straight),
        cmocka_unit_test(a_standing_disc_is_passed_by_tangents_and_an_arc),
        cmocka_unit_test(a_growing_disc_is_passed_by_tangents_and_a_spiral),
        cmocka_unit_test(source_and_destination_the_same_take_no_time_and_no_legs),
        cmocka_unit_test(a_covered_source_is_told),
        cmocka_unit_test(a_destination_that_is_covered_too_soon_is_told),
        cmocka_unit_test(being_cut_off_is_told),
        cmocka_unit_test(a_source_on_a_boundary_may_ride_away_or_leave),
        cmocka_unit_test(a_destination_on_a_standing_boundary_is_reached_by_riding),
        cmocka_unit_test(riders_who_come_together_do_not_both_give_way),
        cmocka_unit_test(a_pebble_late_in_time_does_not_hold_the_robot_for_ever),
        cmocka_unit_test(a_point_that_begins_to_grow_at_the_source_is_left_behind),
        cmocka_unit_test(a_pebble_beside_the_source_makes_nothing_faster),
        cmocka_unit_test(a_disc_that_shrinks_to_a_point_backwards_is_left_in_time),
        cmocka_unit_test(times_too_many_journeys_away_are_refused),
        cmocka_unit_test(a_latest_departure_arrives_by_the_arrival_to_the_last_bit),
        cmocka_unit_test(halving_ends_where_a_pebble_hides_the_way_back),
        cmocka_unit_test(bad_arguments_are_refused_and_touch_nothing),
        cmocka_unit_test(a_path_says_how_much_room_it_needs),
        cmocka_unit_test(counters_count),
        cmocka_unit_test(the_oracle_answers_as_the_solver),
        cmocka_unit_test(two_threads_with_one_scene_get_the_same_bits),
        cmocka_unit_test(every_path_of_random_scenes_is_good_and_joins_to_the_bit),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
