/* SPDX-License-Identifier: MIT */
/* Arrivals within a share of the best: what is promised of them, where few discs are searched and where many are. */
#include "support/cmocka_all.h"

#include <stdlib.h>
#include <string.h>

#include "search/solver.h"
#include "support/chance.h"
#include "support/random_scene.h"
#include "support/tight.h"
#include "support/world.h"
#include "tdsp/verify.h"

enum { LEGS = 4096, MOST = 3000, SMALL = 20 };

static const double deltas[] = {0.0, 1e-6, 0.01, 0.1, 1.0};
enum { DELTAS = sizeof deltas / sizeof *deltas };

static const tdsp_journey across = {1.0, 0.0, {-12.0, 0.0}, {12.0, 0.0}};

/* What the solver states, and the rounding of the times. */
static double error_of(world w, double departure, double arrival)
{
    return TDSP_SOLVER_ERROR * (arrival - departure + w.unit) + 4.5e-16 * (departure + arrival);
}

static void assert_path_is_good(world w, double departure, double arrival)
{
    static tdsp_leg legs[LEGS];
    size_t count;
    tdsp_verdict verdict;
    assert_int_equal(tdsp_solver_path(w.solver, legs, LEGS, &count), TDSP_OK);
    assert_int_equal(tdsp_verify_path(w.scene, legs, count, departure, arrival, &verdict), TDSP_OK);
    assert_int_equal(verdict.problems, 0);
    if (count) assert_exact(legs[count - 1].end_time, arrival);
}

/* Ask, and hold the answer to all that is promised. Returns the arrival. */
static double assert_within(world w, double departure, double delta)
{
    double exact = -1.0, arrival = -1.0, lower = -1.0;
    tdsp_status wanted = tdsp_earliest_arrival(w.solver, departure, &exact);
    tdsp_status status = tdsp_earliest_arrival_within(w.solver, departure, delta, &arrival, &lower);
    assert_int_equal(status, wanted);
    if (status != TDSP_OK) {
        assert_exact(arrival, INFINITY);
        assert_exact(lower, INFINITY);
        return arrival;
    }
    double error = error_of(w, departure, arrival);
    assert_true(lower <= arrival);
    assert_true(lower <= exact + error);
    assert_true(exact <= arrival + error);
    assert_true(arrival - departure <= (1.0 + delta) * (lower - departure) + error);
    if (delta == 0.0) assert_near(arrival, exact, error);
    assert_path_is_good(w, departure, arrival);
    return arrival;
}

static uint64_t labels(world w)
{
    tdsp_solver_work work;
    assert_int_equal(tdsp_solver_work_done(w.solver, &work), TDSP_OK);
    return work.labels;
}

/* Was the last question answered by a weighted search among all discs? */
static int was_weighted(world w)
{
    return w.solver->engine.set == &w.scene->all && w.solver->engine.question.weight > 1.0;
}

static void a_small_scene_of_any_kind_is_answered_as_promised(void **state)
{
    (void)state;
    uint64_t chance = 1;
    for (int mix = 0; mix < RANDOM_MIX_COUNT; ++mix)
        for (uint64_t seed = 0; seed < 12; ++seed) {
            tdsp_disc discs[SMALL];
            tdsp_journey journey;
            random_scene(seed, (random_mix)mix, SMALL, &journey, discs);
            world w = world_make(journey, discs, SMALL);
            double last = fmin(tdsp_scene_source_free_until(w.scene, NULL), 2.0 * w.unit);
            for (size_t i = 0; i < DELTAS; ++i) assert_within(w, last * chance_between(&chance, 0.0, 1.1), deltas[i]);
            world_free(w);
        }
}

/* Discs all over the way, alike or of many rates. */
static size_t crowd(tdsp_disc *discs, size_t count, double rate, int alike, uint64_t *chance)
{
    double size = 6.0 / sqrt((double)count);
    for (size_t i = 0; i < count; ++i) {
        tdsp_point place = {chance_between(chance, -11.0, 11.0), chance_between(chance, -11.0, 11.0)};
        tdsp_disc disc = {place, size * chance_between(chance, 0.1, 1.0), alike ? rate : chance_between(chance, 0.0, rate)};
        discs[i] = disc;
    }
    return count;
}

static void a_crowd_is_crossed_as_promised(void **state)
{
    (void)state;
    static tdsp_disc discs[MOST];
    static const size_t counts[] = {65, 300, 1000, MOST};
    uint64_t chance = 2;
    int weighted = 0, open = 0;
    for (int k = 0; k < 16; ++k) {
        size_t count = counts[k % 4];
        world w = world_make(across, discs, crowd(discs, count, 0.1 / sqrt((double)count), k < 8, &chance));
        for (size_t i = 0; i < DELTAS; ++i) {
            open += isfinite(assert_within(w, 2.0 * (double)i, deltas[i]));
            weighted += was_weighted(w);
        }
        world_free(w);
    }
    assert_true(weighted > 20 && open > 40);
}

static void an_answer_within_a_hundredth_takes_less_than_half_the_work(void **state)
{
    (void)state;
    static tdsp_disc discs[MOST];
    uint64_t chance = 3;
    world w = world_make(across, discs, crowd(discs, MOST, 0.001, 1, &chance));
    double arrival = -1.0, lower = -1.0;
    uint64_t before = labels(w);
    assert_int_equal(tdsp_earliest_arrival(w.solver, 0.0, &arrival), TDSP_OK);
    uint64_t exact = labels(w) - before;
    before = labels(w);
    assert_int_equal(tdsp_earliest_arrival_within(w.solver, 0.0, 0.01, &arrival, &lower), TDSP_OK);
    assert_true(was_weighted(w));
    assert_true(2 * (labels(w) - before) < exact);
    world_free(w);
}

/* Columns of discs that nearly touch, each with one gap. */
static size_t walls(tdsp_disc *discs, int columns, double rate, uint64_t *chance)
{
    size_t count = 0;
    for (int column = 0; column < columns; ++column) {
        double x = -10.0 + 20.0 * (column + 0.5) / columns;
        int gap = (int)chance_below(chance, 61);
        for (int i = 0; i < 61; ++i) {
            tdsp_disc disc = {{x, 0.3 * (i - 30)}, 0.16, rate};
            if (i != gap) discs[count++] = disc;
        }
    }
    return count;
}

static void walls_with_gaps_are_passed_as_promised(void **state)
{
    (void)state;
    static tdsp_disc discs[MOST];
    uint64_t chance = 4;
    int weighted = 0;
    for (int k = 0; k < 12; ++k) {
        world w = world_make(across, discs, walls(discs, 2 + k, k % 2 ? 0.0005 : 0.0, &chance));
        for (size_t i = 0; i < DELTAS; ++i) {
            assert_within(w, 3.0 * (double)i, deltas[i]);
            weighted += was_weighted(w);
        }
        world_free(w);
    }
    assert_true(weighted > 10);
}

/* A crowd, and a closed ring about one end. */
static size_t sealed(tdsp_disc *discs, size_t count, double at, double rate, uint64_t *chance)
{
    crowd(discs, count, 0.001, 1, chance);
    for (int i = 0; i < 40; ++i) {
        tdsp_disc ring = {{at + 2.0 * cos(GEOM_PI * i / 20), 2.0 * sin(GEOM_PI * i / 20)}, 0.17, rate};
        discs[i] = ring;
    }
    return count;
}

static void where_either_end_is_sealed_there_is_no_way(void **state)
{
    (void)state;
    static tdsp_disc discs[MOST];
    uint64_t chance = 5;
    for (int k = 0; k < 8; ++k) {
        world w = world_make(across, discs, sealed(discs, 1000, k % 2 ? 12.0 : -12.0, k < 4 ? 0.0 : 0.01, &chance));
        for (size_t i = 0; i < DELTAS; ++i) assert_exact(assert_within(w, 0.0, deltas[i]), INFINITY);
        world_free(w);
    }
}

/* The ring is closed too late for whoever leaves early. */
static void a_ring_that_closes_in_time_cuts_off_and_one_that_does_not_is_passed(void **state)
{
    (void)state;
    static tdsp_disc discs[MOST];
    uint64_t chance = 6;
    size_t count = sealed(discs, 1000, 12.0, 0.0, &chance);
    for (int i = 0; i < 40; ++i) {
        discs[i].radius = 0.1;
        discs[i].growth = 0.001;
    }
    world w = world_make(across, discs, count);
    int open = 0, closed = 0;
    for (double departure = 0.0; departure < 90.0; departure += 5.0)
        *(isfinite(assert_within(w, departure, 0.05)) ? &open : &closed) += 1;
    assert_true(open > 4 && closed > 4);
    world_free(w);
}

static tdsp_status ask(world w, double departure, double delta, double *arrival, double *lower)
{
    *arrival = *lower = -1.0;
    return tdsp_earliest_arrival_within(w.solver, departure, delta, arrival, lower);
}

static void among_no_discs_the_answer_is_the_straight_line(void **state)
{
    (void)state;
    world w = world_make(across, NULL, 0);
    double arrival, lower;
    assert_int_equal(ask(w, 5.0, 0.01, &arrival, &lower), TDSP_OK);
    assert_near(arrival, 29.0, 1e-13);
    assert_exact(lower, arrival);
    world_free(w);
}

static void who_is_there_already_arrives_when_leaving(void **state)
{
    (void)state;
    static tdsp_disc discs[MOST];
    uint64_t chance = 7;
    tdsp_journey stay = across;
    stay.destination = stay.source;
    for (size_t count = 10; count < 200; count += 90) {
        world w = world_make(stay, discs, crowd(discs, count, 0.001, 0, &chance));
        double arrival, lower;
        size_t legs = 7;
        assert_int_equal(ask(w, 5.0, 0.01, &arrival, &lower), TDSP_OK);
        assert_exact(arrival, 5.0);
        assert_exact(lower, 5.0);
        assert_int_equal(tdsp_solver_path(w.solver, NULL, 0, &legs), TDSP_OK);
        assert_int_equal(legs, 0);
        world_free(w);
    }
}

static void a_covered_end_is_told_as_by_the_exact_search(void **state)
{
    (void)state;
    static tdsp_disc discs[MOST];
    uint64_t chance = 8;
    for (size_t count = 10; count < 200; count += 90)
        for (int end = 0; end < 2; ++end) {
            crowd(discs, count, 0.0, 1, &chance);
            tdsp_disc cover = {{end ? 12.0 : -12.0, 3.0}, 1.0, 0.05};
            discs[0] = cover;
            world w = world_make(across, discs, count);
            double arrival, lower;
            assert_within(w, 1.0, 0.01);
            assert_int_equal(ask(w, 60.0, 0.01, &arrival, &lower), end ? TDSP_DESTINATION_COVERED : TDSP_SOURCE_COVERED);
            assert_within(w, 60.0, 0.01);
            world_free(w);
        }
}

static void a_wrong_argument_is_refused_and_touches_nothing(void **state)
{
    (void)state;
    static tdsp_disc discs[MOST];
    uint64_t chance = 9;
    world w = world_make(across, discs, crowd(discs, 100, 0.001, 1, &chance));
    const double bad_delta[] = {-1e-300, -1.0, 1.0 + 1e-15, INFINITY, -INFINITY, NAN}, bad_time[] = {-1e-300, INFINITY, NAN};
    double arrival, lower;
    for (size_t i = 0; i < 6; ++i) assert_int_equal(ask(w, 0.0, bad_delta[i], &arrival, &lower), TDSP_INVALID_ARGUMENT);
    for (size_t i = 0; i < 3; ++i) assert_int_equal(ask(w, bad_time[i], 0.1, &arrival, &lower), TDSP_INVALID_ARGUMENT);
    assert_int_equal(ask(w, 1e300, 0.1, &arrival, &lower), tdsp_earliest_arrival(w.solver, 1e300, &arrival));
    assert_int_equal(tdsp_earliest_arrival_within(NULL, 0.0, 0.1, &arrival, &lower), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_earliest_arrival_within(w.solver, 0.0, 0.1, NULL, &lower), TDSP_INVALID_ARGUMENT);
    lower = -1.0;
    assert_int_equal(tdsp_earliest_arrival_within(w.solver, 0.0, -0.1, &arrival, &lower), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_earliest_arrival_within(w.solver, 0.0, 0.1, &arrival, NULL), TDSP_INVALID_ARGUMENT);
    assert_exact(lower, -1.0);
    world_free(w);
}

static void a_time_too_many_journeys_away_is_refused_where_something_grows(void **state)
{
    (void)state;
    const tdsp_disc grows = {{0.0, 5.0}, 0.0, 1e-20}, stands = {{0.0, 5.0}, 1.0, 0.0};
    double arrival, lower;
    world w = world_make(across, &grows, 1);
    assert_int_equal(ask(w, 1e15, 0.1, &arrival, &lower), TDSP_NOT_SUPPORTED);
    assert_exact(arrival, -1.0);
    assert_exact(lower, -1.0);
    tdsp_oracle oracle;
    assert_int_equal(tdsp_solver_oracle(w.solver, &oracle), TDSP_OK);
    assert_int_equal(oracle.earliest_arrival_within(oracle.ctx, 1e15, 0.1, &arrival, &lower), TDSP_NOT_SUPPORTED);
    assert_exact(arrival, -1.0);
    world_free(w);
    w = world_make(across, &stands, 1);
    assert_int_equal(ask(w, 1e15, 0.1, &arrival, &lower), TDSP_OK);
    assert_near(arrival, 1e15 + 24.0, 0.2);
    world_free(w);
}

static void an_answer_does_not_depend_on_the_questions_before(void **state)
{
    (void)state;
    static tdsp_disc discs[MOST];
    uint64_t chance = 10;
    size_t count = crowd(discs, 600, 0.004, 0, &chance);
    world busy = world_make(across, discs, count);
    for (int k = 0; k < 12; ++k) {
        world fresh = world_make(across, discs, count);
        double departure = chance_between(&chance, 0.0, 6.0), delta = deltas[k % DELTAS], a, b, c, d;
        if (k % 3 == 0) world_arrival(busy, departure);
        assert_int_equal(ask(busy, departure, delta, &a, &b), ask(fresh, departure, delta, &c, &d));
        assert_exact(a, c);
        assert_exact(b, d);
        world_free(fresh);
    }
    world_free(busy);
}

/* A question whose every allocation is to fail in turn. */
typedef struct fault_case {
    tight_heap heap;
    tdsp_allocator memory;
    tdsp_scene *scene;
    tdsp_solver *solver;
    double delta;
} fault_case;

typedef struct answer {
    double arrival, lower;
    tdsp_leg path[LEGS];
} answer;

static tdsp_status answer_of(fault_case *self, answer *out)
{
    size_t legs;
    tdsp_status status = tdsp_earliest_arrival_within(self->solver, 1.0, self->delta, &out->arrival, &out->lower);
    return status == TDSP_OK ? tdsp_solver_path(self->solver, out->path, LEGS, &legs) : status;
}

static void fail_each(fault_case *self)
{
    static answer expected, untouched, got;
    memset(&expected, 0, sizeof expected);
    memset(&untouched, 0, sizeof untouched);
    tdsp_status wanted = answer_of(self, &expected), status = TDSP_NO_MEMORY;
    assert_true(tdsp_status_is_answer(wanted));
    for (size_t refuse = 1; status == TDSP_NO_MEMORY; ++refuse) {
        size_t legs = 77;
        tdsp_solver_free(self->solver);
        assert_int_equal(tdsp_solver_create(self->scene, &self->solver), TDSP_OK);
        got = untouched;
        self->heap.refuse = self->heap.calls + refuse;
        status = answer_of(self, &got);
        self->heap.refuse = 0;
        if (status == TDSP_NO_MEMORY) {
            assert_memory_equal(&got, &untouched, sizeof got);
            assert_int_equal(tdsp_solver_path(self->solver, NULL, 0, &legs), TDSP_NO_ANSWER);
            assert_int_equal(answer_of(self, &got), wanted);
        }
        assert_memory_equal(&got, &expected, sizeof got);
    }
    assert_int_equal(status, wanted);
}

static void an_answer_without_memory_is_told_and_can_be_asked_again(void **state)
{
    (void)state;
    static tdsp_disc discs[MOST];
    static fault_case f;
    uint64_t chance = 11;
    for (int k = 0; k < 8; ++k) {
        size_t count = k < 2 ? crowd(discs, 40, 0.01, 1, &chance) : k < 6 ? crowd(discs, 400, 0.001, 0, &chance) : sealed(discs, 400, 12.0, 0.001, &chance);
        memset(&f, 0, sizeof f);
        f.memory = tight_allocator(&f.heap);
        f.delta = deltas[2 + k % 3];
        assert_int_equal(tdsp_scene_create(&across, discs, count, &f.memory, &f.scene), TDSP_OK);
        assert_int_equal(tdsp_solver_create(f.scene, &f.solver), TDSP_OK);
        fail_each(&f);
        tdsp_solver_free(f.solver);
        tdsp_scene_free(f.scene);
        assert_int_equal(f.heap.blocks, 0);
        assert_int_equal(f.heap.held, 0);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_small_scene_of_any_kind_is_answered_as_promised),
        cmocka_unit_test(a_crowd_is_crossed_as_promised),
        cmocka_unit_test(an_answer_within_a_hundredth_takes_less_than_half_the_work),
        cmocka_unit_test(walls_with_gaps_are_passed_as_promised),
        cmocka_unit_test(where_either_end_is_sealed_there_is_no_way),
        cmocka_unit_test(a_ring_that_closes_in_time_cuts_off_and_one_that_does_not_is_passed),
        cmocka_unit_test(among_no_discs_the_answer_is_the_straight_line),
        cmocka_unit_test(who_is_there_already_arrives_when_leaving),
        cmocka_unit_test(a_covered_end_is_told_as_by_the_exact_search),
        cmocka_unit_test(a_wrong_argument_is_refused_and_touches_nothing),
        cmocka_unit_test(a_time_too_many_journeys_away_is_refused_where_something_grows),
        cmocka_unit_test(an_answer_does_not_depend_on_the_questions_before),
        cmocka_unit_test(an_answer_without_memory_is_told_and_can_be_asked_again),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
