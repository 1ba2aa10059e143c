/* SPDX-License-Identifier: MIT */
/* The general method: it agrees with the others where they apply, and beyond them with closed forms, halving and scenes said in another way. */
#include "support/cmocka_all.h"

#include "geom/point.h"
#include "support/chance.h"
#include "support/random_scene.h"
#include "tdsp/build.h"
#include "tdsp/growth.h"
#include "tdsp/solver.h"

#define SEED 4203

static const tdsp_journey across = {1.0, 0.0, {-3.0, 0.0}, {3.0, 0.0}};

/* A scene with one solver for a method. */
typedef struct world {
    tdsp_scene *scene;
    tdsp_solver *solver;
} world;

static world open_growing(const tdsp_journey *journey, const tdsp_growing_disc *discs, size_t count)
{
    world w;
    assert_int_equal(tdsp_scene_create_growing(journey, discs, count, NULL, &w.scene), TDSP_OK);
    assert_int_equal(tdsp_solver_create_for(w.scene, TDSP_METHOD_GENERAL, &w.solver), TDSP_OK);
    return w;
}

static void drop(world *w)
{
    tdsp_solver_free(w->solver);
    tdsp_scene_free(w->scene);
}

static tdsp_growing_disc of_rate(double x, double y, double radius, double rate)
{
    tdsp_growing_disc disc = {{x, y}, radius, {.kind = TDSP_GROWTH_RATE, .rate = rate}};
    return disc;
}

static tdsp_growing_disc of_powers(double x, double y, double radius, const double *values, size_t count)
{
    tdsp_growing_disc disc = {{x, y}, radius, {.kind = TDSP_GROWTH_POLYNOMIAL, .count = count, .values = values}};
    return disc;
}

static tdsp_growing_disc of_rates(double x, double y, double radius, const double *times, const double *rates, size_t count)
{
    tdsp_growing_disc disc = {{x, y}, radius, {.kind = TDSP_GROWTH_RATES, .count = count, .values = rates, .times = times}};
    return disc;
}

/* What a method answers to one departure. */
typedef struct answer {
    tdsp_status status;
    double number;
} answer;

static answer arrival_of(tdsp_solver *solver, double departure)
{
    answer a = {TDSP_OK, INFINITY};
    a.status = tdsp_earliest_arrival(solver, departure, &a.number);
    return a;
}

static answer latest_of(tdsp_solver *solver, double arrival)
{
    answer a = {TDSP_OK, -1.0};
    a.status = tdsp_latest_departure(solver, arrival, &a.number, NULL);
    return a;
}

static void assert_same(answer general, answer other, double tolerance)
{
    assert_int_equal(general.status, other.status);
    if (other.status == TDSP_OK) assert_near(general.number, other.number, tolerance);
}

/* So many journeys on, the general method's times are rounded by more than its contacts may be deep, and its last departure may be off by a journey. */
#define FAR 1e4

/* The general method refuses times past this. */
#define REFUSED 0x1p20

static void last_departures_agree(tdsp_solver *general, tdsp_solver *other, double unit)
{
    const tdsp_scene *scene = tdsp_solver_scene(other);
    tdsp_last_departure last, also;
    tdsp_status status = tdsp_solver_last_departure(other, &also), told = tdsp_solver_last_departure(general, &last);
    if (told == TDSP_NOT_SUPPORTED) {
        assert_true(tdsp_scene_source_free_until(scene, NULL) > REFUSED * unit && tdsp_scene_destination_free_until(scene, NULL) > REFUSED * unit);
        return;
    }
    assert_int_equal(told, status);
    if (status != TDSP_OK) return;
    assert_int_equal(last.reason, also.reason);
    assert_int_equal(isinf(last.departure), isinf(also.departure));
    if (also.departure < FAR * unit) assert_near(last.departure, also.departure, 1e-11 * (unit + also.arrival));
}

/* Departures that are not just where the answers jump. */
static void methods_agree(const tdsp_scene *scene, uint64_t *chance, double unit)
{
    tdsp_solver *general, *other;
    assert_int_equal(tdsp_solver_create_for(scene, TDSP_METHOD_GENERAL, &general), TDSP_OK);
    assert_int_equal(tdsp_solver_create(scene, &other), TDSP_OK);
    for (int k = 0; k < 4; ++k) {
        double departure = k == 0 ? 0.0 : chance_between(chance, 0.0, 3.0 * unit);
        answer a = arrival_of(general, departure), b = arrival_of(other, departure);
        assert_same(a, b, 1e-12 * (unit + (b.status == TDSP_OK ? b.number : 0.0)));
    }
    double until = chance_between(chance, 0.0, 5.0 * unit);
    assert_same(latest_of(general, until), latest_of(other, until), 1e-11 * (unit + until));
    last_departures_agree(general, other, unit);
    tdsp_solver_free(other);
    tdsp_solver_free(general);
}

static void the_general_method_agrees_with_the_others(void **state)
{
    (void)state;
    print_message("seed %d\n", SEED);
    for (uint64_t i = 0; i < 300; ++i) {
        tdsp_journey journey;
        tdsp_disc discs[10];
        tdsp_scene *scene;
        uint64_t chance = SEED + i;
        size_t count = 1 + chance_below(&chance, 10);
        random_scene(SEED + i, (random_mix)(i % RANDOM_MIX_COUNT), count, &journey, discs);
        assert_int_equal(tdsp_scene_create(&journey, discs, count, NULL, &scene), TDSP_OK);
        double x = journey.destination.x - journey.source.x, y = journey.destination.y - journey.source.y;
        methods_agree(scene, &chance, sqrt(x * x + y * y) / journey.speed);
        tdsp_scene_free(scene);
    }
}

/* ----------------------------------------------------------------------------------------------------- laws that shrink */

/* 1 + 0.4 t - 0.05 t^2, which grows until 4; as it is, and as a law by callback that stays from then on. */
static const double sinking[2] = {0.4, -0.05};

static void staying(void *ctx, double time, double *radius, double *rate)
{
    (void)ctx;
    double t = fmin(time, 4.0);
    *radius = 1.0 + 0.4 * t - 0.05 * t * t;
    *rate = time < 4.0 ? 0.4 - 0.1 * t : 0.0;
}

static tdsp_growing_disc sinking_disc(double x, double y)
{
    return of_powers(x, y, 1.0, sinking, 2);
}

static tdsp_growing_disc staying_disc(double x, double y)
{
    static const double kinks[1] = {4.0};
    tdsp_growing_disc disc = {{x, y}, 1.0, {.kind = TDSP_GROWTH_LAW, .count = 1, .times = kinks, .law = staying, .until = 5.0}};
    return disc;
}

static const tdsp_journey brisk = {2.0, 0.0, {-2.5, 0.1}, {2.5, 0.0}};

static void answers_up_to_the_moment_a_disc_shrinks_are_those_of_a_disc_that_stays(void **state)
{
    (void)state;
    const tdsp_growing_disc sinks = sinking_disc(0.0, 0.0), stays = staying_disc(0.0, 0.0);
    world w = open_growing(&brisk, &sinks, 1), v = open_growing(&brisk, &stays, 1);
    double border = latest_of(v.solver, 4.0).number;
    assert_true(border > 0.5 && border < 2.0);
    assert_near(tdsp_scene_valid_until(w.scene, NULL), 4.0, 1e-12);
    for (int k = 0; k < 400; ++k) {
        double departure = 2.0 * border * k / 400.0, untouched = 77.0;
        if (fabs(departure - border) < 1e-9) continue;
        answer a = arrival_of(w.solver, departure), b = arrival_of(v.solver, departure);
        assert_int_equal(b.status, TDSP_OK);
        assert_int_equal(a.status, departure < border ? TDSP_OK : TDSP_SHRINKS);
        if (a.status == TDSP_OK) assert_near(a.number, b.number, 1e-11);
        if (a.status == TDSP_OK) continue;
        size_t count;
        assert_int_equal(tdsp_earliest_arrival(w.solver, departure, &untouched), TDSP_SHRINKS);
        assert_exact(untouched, 77.0);
        assert_int_equal(tdsp_solver_path(w.solver, NULL, 0, &count), TDSP_NO_ANSWER);
    }
    drop(&v);
    drop(&w);
}

static void the_latest_departure_is_told_up_to_the_moment_a_disc_shrinks(void **state)
{
    (void)state;
    const tdsp_growing_disc sinks = sinking_disc(0.0, 0.0), stays = staying_disc(0.0, 0.0);
    world w = open_growing(&brisk, &sinks, 1), v = open_growing(&brisk, &stays, 1);
    tdsp_last_departure last;
    for (int k = 0; k <= 200; ++k) {
        double arrival = 8.0 * k / 200.0;
        answer a = latest_of(w.solver, arrival), b = latest_of(v.solver, arrival);
        if (arrival > 4.0) assert_int_equal(a.status, TDSP_SHRINKS);
        if (arrival <= 4.0) assert_same(a, b, 1e-10);
    }
    assert_int_equal(latest_of(w.solver, INFINITY).status, TDSP_SHRINKS);
    assert_int_equal(tdsp_solver_last_departure(w.solver, &last), TDSP_SHRINKS);
    drop(&v);
    drop(&w);
}

/* Whoever leaves for good leaves when the second has stopped, and nobody knows what the first is by then. */
static void no_latest_departure_is_told_where_a_disc_grows_on_after_another_shrinks(void **state)
{
    (void)state;
    static const double times[2] = {0.0, 10.0}, rates[2] = {0.1, 0.0};
    const tdsp_growing_disc discs[2] = {sinking_disc(0.0, 0.0), of_rates(0.0, 50.0, 1.0, times, rates, 2)};
    world w = open_growing(&brisk, discs, 2);
    tdsp_last_departure last;
    assert_int_equal(latest_of(w.solver, INFINITY).status, TDSP_SHRINKS);
    assert_int_equal(tdsp_solver_last_departure(w.solver, &last), TDSP_SHRINKS);
    drop(&w);
}

/* The cover of an end ends the departures before anything shrinks: no departure before that asks more of the disc. */
static void what_ends_the_departures_before_a_disc_shrinks_is_told(void **state)
{
    (void)state;
    const double cover = 4.0 - sqrt(16.0 - 0.3 / 0.05); /* 1 + 0.4 t - 0.05 t^2 = 1.3 */
    for (int is_source = 0; is_source < 2; ++is_source) {
        const tdsp_growing_disc sinks = sinking_disc(is_source ? -3.8 : 3.8, 0.1 * is_source);
        const tdsp_journey fast = {10.0, 0.0, {-2.5, 0.1}, {2.5, 0.0}};
        world w = open_growing(&fast, &sinks, 1);
        tdsp_last_departure last;
        assert_int_equal(tdsp_solver_last_departure(w.solver, &last), TDSP_OK);
        assert_int_equal(last.reason, is_source ? TDSP_SOURCE_COVERED : TDSP_DESTINATION_COVERED);
        assert_near(is_source ? last.departure : last.arrival, cover, 1e-11);
        assert_near(last.arrival - last.departure, sqrt(25.01) / 10.0, 1e-11);
        assert_near(last.time, cover, 1e-11);
        assert_int_equal(last.disc, 0);
        assert_int_equal(arrival_of(w.solver, 3.0).status, last.reason);
        assert_int_equal(arrival_of(w.solver, 30.0).status, TDSP_SHRINKS);
        drop(&w);
    }
}

/* ---------------------------------------------------------------------------------------------------- a gap that closes */

static const tdsp_journey inwards = {1.0, 0.0, {-2.0, 0.0}, {3.0, 0.0}};

/* A ring around the destination, whose only way in lies between the first two discs, at (0, 1) and (0, -1). */
static world open_ring(tdsp_journey journey, tdsp_growing_disc gate)
{
    tdsp_growing_disc discs[5] = {gate, gate, of_rate(3.0, 6.0, 5.5, 0.0), of_rate(3.0, -6.0, 5.5, 0.0), of_rate(9.0, 0.0, 5.0, 0.0)};
    discs[0].center = (tdsp_point){0.0, 1.0};
    discs[1].center = (tdsp_point){0.0, -1.0};
    return open_growing(&journey, discs, 5);
}

/* The gate's law: 0.5 + 0.05 t + 0.02 t^2 in three ways, the last with the rate of that at 2 and at 5. */
static const double powers[2] = {0.05, 0.02}, gate_times[2] = {0.0, 2.0}, gate_rates[2] = {0.09, 0.25};

static void gate_law(void *ctx, double time, double *radius, double *rate)
{
    (void)ctx;
    *radius = 0.5 + 0.05 * time + 0.02 * time * time;
    *rate = 0.05 + 0.04 * time;
}

static tdsp_growing_disc gate_of(int kind)
{
    tdsp_growing_disc called = {{0.0, 0.0}, 0.5, {.kind = TDSP_GROWTH_LAW, .law = gate_law, .until = 20.0}};
    if (kind == 0) return of_powers(0.0, 0.0, 0.5, powers, 2);
    return kind == 1 ? called : of_rates(0.0, 0.0, 0.5, gate_times, gate_rates, 2);
}

static void gate_at(int kind, double time, double *radius, double *rate)
{
    if (kind < 2) gate_law(NULL, time, radius, rate);
    if (kind < 2) return;
    *rate = gate_rates[time >= 2.0];
    *radius = 0.5 + (time < 2.0 ? 0.09 * time : 0.18 + 0.25 * (time - 2.0));
}

/* When the corner at sqrt(R^2 - 1) on the axis, which starts infinitely fast, has slowed down to the robot: R R' = v sqrt(R^2 - 1). */
static double corner_time(int kind, double robot, double speed)
{
    double low = 0.0, high = 20.0;
    for (int i = 0; i < 200; ++i) {
        double middle = 0.5 * (low + high), radius, rate;
        gate_at(kind, middle, &radius, &rate);
        radius += robot;
        *(radius <= 1.0 || radius * rate > speed * sqrt(radius * radius - 1.0) ? &low : &high) = middle;
    }
    return low;
}

static void the_last_robot_through_a_gap_meets_its_corner_where_that_has_slowed_down(void **state)
{
    (void)state;
    static const double robots[2] = {0.0, 0.05}, speeds[2] = {1.0, 1.5};
    for (int kind = 0; kind < 3; ++kind)
        for (int k = 0; k < 4; ++k) {
            tdsp_journey journey = inwards;
            double robot = journey.radius = robots[k / 2], speed = journey.speed = speeds[k % 2], time = corner_time(kind, robot, speed), radius, rate;
            gate_at(kind, time, &radius, &rate);
            double x = sqrt((radius + robot) * (radius + robot) - 1.0), departure = time - (x + 2.0) / speed;
            world w = open_ring(journey, gate_of(kind));
            tdsp_last_departure last;
            assert_int_equal(tdsp_solver_last_departure(w.solver, &last), TDSP_OK);
            assert_near(last.departure, departure, 1e-9);
            assert_near(last.arrival, departure + 5.0 / speed, 1e-9);
            assert_int_equal(last.reason, TDSP_CUT_OFF);
            assert_int_equal(last.disc, 0);
            assert_int_equal(last.other, 1);
            assert_near(last.time, time, 1e-6);
            assert_near(last.place.x, x, 1e-6);
            assert_near(last.place.y, 0.0, 1e-6);
            assert_int_equal(arrival_of(w.solver, departure + 1e-6).status, TDSP_CUT_OFF);
            assert_near(arrival_of(w.solver, departure - 1e-6).number, departure - 1e-6 + 5.0 / speed, 1e-9);
            drop(&w);
        }
}

/* ------------------------------------------------------------------------------------------- departures without an end */

static const double cap_times[2] = {0.0, 2.0}, cap_rates[2] = {0.3, 0.0};

static void discs_that_stop_growing_never_end_the_departures(void **state)
{
    (void)state;
    const tdsp_growing_disc capped = of_rates(0.0, 0.0, 1.0, cap_times, cap_rates, 2);
    world w = open_growing(&across, &capped, 1);
    tdsp_last_departure last;
    double still = arrival_of(w.solver, 100.0).number - 100.0, tangent = sqrt(9.0 - 1.6 * 1.6);
    assert_near(still, 2.0 * tangent + 1.6 * (GEOM_TURN / 2.0 - 2.0 * acos(1.6 / 3.0)), 1e-11);
    assert_int_equal(tdsp_solver_last_departure(w.solver, &last), TDSP_OK);
    assert_exact(last.departure, INFINITY);
    assert_int_equal(last.reason, TDSP_OK);
    assert_int_equal(last.disc, TDSP_NO_DISC);
    answer a = latest_of(w.solver, INFINITY);
    assert_int_equal(a.status, TDSP_OK);
    assert_exact(a.number, INFINITY);
    assert_near(latest_of(w.solver, 1000.0).number, 1000.0 - still, 1e-9);
    drop(&w);
}

static void a_table_without_an_end_needs_a_horizon(void **state)
{
    (void)state;
    const tdsp_growing_disc capped = of_rates(0.0, 0.0, 1.0, cap_times, cap_rates, 2);
    world w = open_growing(&across, &capped, 1);
    tdsp_oracle oracle;
    tdsp_build_options options;
    tdsp_build_report report;
    void *bytes;
    size_t length;
    assert_int_equal(tdsp_solver_oracle(w.solver, &oracle), TDSP_OK);
    tdsp_build_options_init(&options);
    assert_int_equal(tdsp_build(&oracle, &options, NULL, &bytes, &length, &report), TDSP_NEEDS_HORIZON);
    options.horizon = 10.0;
    assert_int_equal(tdsp_build(&oracle, &options, NULL, &bytes, &length, &report), TDSP_OK);
    assert_int_equal(report.last_reason, TDSP_HORIZON);
    assert_exact(report.last_departure, 10.0);
    tdsp_bytes_free(NULL, bytes, length);
    drop(&w);
}

/* The ring's gate closes before it stops: the departures end all the same. */
static void a_gap_that_closes_before_the_discs_stop_ends_the_departures(void **state)
{
    (void)state;
    static const double times[3] = {0.0, 2.0, 6.0}, rates[3] = {0.09, 0.25, 0.0};
    world w = open_ring(inwards, of_rates(0.0, 0.0, 0.5, times, rates, 3)), v = open_ring(inwards, gate_of(2));
    tdsp_last_departure last, also;
    assert_int_equal(tdsp_solver_last_departure(w.solver, &last), TDSP_OK);
    assert_int_equal(tdsp_solver_last_departure(v.solver, &also), TDSP_OK);
    assert_near(last.departure, also.departure, 1e-11);
    assert_int_equal(last.reason, TDSP_CUT_OFF);
    assert_int_equal(last.disc, also.disc);
    assert_near(last.time, also.time, 1e-6);
    drop(&v);
    drop(&w);
}

/* ------------------------------------------------------------------------------------------------------ ends covered, equal */

static void a_source_inside_a_disc_is_covered(void **state)
{
    (void)state;
    const tdsp_growing_disc early = of_powers(-3.5, 0.0, 0.6, powers, 2), late = of_powers(-4.0, 0.0, 0.5, powers, 2);
    const double cover = (-0.05 + sqrt(0.05 * 0.05 + 0.04)) / 0.04; /* 0.05 t + 0.02 t^2 = 0.5 */
    tdsp_last_departure last;
    world w = open_growing(&across, &early, 1);
    assert_int_equal(arrival_of(w.solver, 0.0).status, TDSP_SOURCE_COVERED);
    assert_int_equal(latest_of(w.solver, 50.0).status, TDSP_SOURCE_COVERED);
    assert_int_equal(tdsp_solver_last_departure(w.solver, &last), TDSP_SOURCE_COVERED);
    drop(&w);
    w = open_growing(&across, &late, 1);
    assert_int_equal(arrival_of(w.solver, cover - 1e-9).status, TDSP_OK);
    assert_int_equal(arrival_of(w.solver, cover + 1e-9).status, TDSP_SOURCE_COVERED);
    assert_int_equal(tdsp_solver_last_departure(w.solver, &last), TDSP_OK);
    assert_near(last.departure, cover, 1e-12);
    assert_near(last.arrival, cover + 6.0, 1e-12);
    assert_int_equal(last.reason, TDSP_SOURCE_COVERED);
    drop(&w);
}

static void work_is_counted(void **state)
{
    (void)state;
    const tdsp_growing_disc disc = of_powers(0.0, 0.0, 0.5, powers, 2);
    world w = open_growing(&across, &disc, 1);
    tdsp_solver_work work;
    assert_true(arrival_of(w.solver, 0.0).status == TDSP_OK && tdsp_solver_work_done(w.solver, &work) == TDSP_OK);
    assert_true(work.forward_searches == 1 && work.labels > 2 && work.legs_tested > 2 && work.bytes > 1000);
    drop(&w);
}

static void who_is_there_already_arrives_at_once(void **state)
{
    (void)state;
    const tdsp_journey nowhere = {1.0, 0.0, {1.0, 1.0}, {1.0, 1.0}};
    const tdsp_growing_disc law = of_powers(1.0, 2.0, 0.5, powers, 2);
    const double cover = (-0.05 + sqrt(0.05 * 0.05 + 0.04)) / 0.04;
    world w = open_growing(&nowhere, &law, 1);
    size_t count = 9;
    assert_exact(arrival_of(w.solver, 1.25).number, 1.25);
    assert_int_equal(tdsp_solver_path(w.solver, NULL, 0, &count), TDSP_OK);
    assert_int_equal(count, 0);
    assert_near(latest_of(w.solver, 2.0).number, 2.0, 1e-12);
    assert_near(latest_of(w.solver, INFINITY).number, cover, 1e-11);
    assert_int_equal(arrival_of(w.solver, cover + 1e-9).status, TDSP_SOURCE_COVERED);
    drop(&w);
}

static void a_departure_too_far_away_is_refused(void **state)
{
    (void)state;
    const tdsp_growing_disc capped = of_rates(0.0, 0.0, 1.0, cap_times, cap_rates, 2);
    world w = open_growing(&across, &capped, 1);
    assert_int_equal(arrival_of(w.solver, 6.0 * 1048576.0 * 1.01).status, TDSP_NOT_SUPPORTED);
    assert_int_equal(arrival_of(w.solver, 6.0 * 1048576.0 * 0.99).status, TDSP_OK);
    assert_int_equal(arrival_of(w.solver, INFINITY).status, TDSP_INVALID_ARGUMENT);
    assert_int_equal(arrival_of(w.solver, -1.0).status, TDSP_INVALID_ARGUMENT);
    drop(&w);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_general_method_agrees_with_the_others),
        cmocka_unit_test(answers_up_to_the_moment_a_disc_shrinks_are_those_of_a_disc_that_stays),
        cmocka_unit_test(the_latest_departure_is_told_up_to_the_moment_a_disc_shrinks),
        cmocka_unit_test(no_latest_departure_is_told_where_a_disc_grows_on_after_another_shrinks),
        cmocka_unit_test(what_ends_the_departures_before_a_disc_shrinks_is_told),
        cmocka_unit_test(the_last_robot_through_a_gap_meets_its_corner_where_that_has_slowed_down),
        cmocka_unit_test(discs_that_stop_growing_never_end_the_departures),
        cmocka_unit_test(a_table_without_an_end_needs_a_horizon),
        cmocka_unit_test(a_gap_that_closes_before_the_discs_stop_ends_the_departures),
        cmocka_unit_test(a_source_inside_a_disc_is_covered),
        cmocka_unit_test(work_is_counted),
        cmocka_unit_test(who_is_there_already_arrives_at_once),
        cmocka_unit_test(a_departure_too_far_away_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
