/* SPDX-License-Identifier: MIT */
/* Weighted searches: scouts that find a limit for the exact search, patience, and the lower bound that a weighted search leaves behind. */
#include "support/cmocka_all.h"

#include "search/solver.h"
#include "support/chance.h"
#include "support/world.h"

enum { MOST = 2000 };

static const tdsp_journey across = {1.0, 0.0, {-12.0, 0.0}, {12.0, 0.0}};

static void crowd(tdsp_disc *discs, size_t count, double rate, uint64_t *chance)
{
    double size = 6.5 / sqrt((double)count);
    for (size_t i = 0; i < count; ++i) {
        tdsp_point place = {chance_between(chance, -11.0, 11.0), chance_between(chance, -11.0, 11.0)};
        tdsp_disc disc = {place, size * chance_between(chance, 0.2, 1.0), chance_between(chance, 0.0, rate)};
        discs[i] = disc;
    }
}

static void run(world w, const engine_question *question)
{
    assert_int_equal(engine_run(&w.solver->engine, &w.scene->all, question), TDSP_OK);
}

/* The arrival of the run, infinite without one. */
static double arrived(world w)
{
    return w.solver->engine.arrived == ENGINE_NONE ? INFINITY : engine_arrival(&w.solver->engine);
}

typedef void (*check_world)(world w, double departure);

static void each_crowd(uint64_t seed, check_world check)
{
    static tdsp_disc discs[MOST];
    static const size_t counts[] = {65, 200, 800, MOST};
    uint64_t chance = seed;
    for (int k = 0; k < 12; ++k) {
        size_t count = counts[k % 4];
        crowd(discs, count, 0.05 / sqrt((double)count), &chance);
        world w = world_make(across, discs, count);
        for (int i = 0; i < 3; ++i) check(w, 3.0 * i);
        world_free(w);
    }
}

static int scouts_back;

static void check_scouts(world w, double departure)
{
    disc_engine *engine = &w.solver->engine;
    engine_question alone = solver_forward_question(w.solver, departure), scouted = alone;
    int lost = 7;
    run(w, &alone);
    double exact = arrived(w);
    assert_int_equal(engine_scout(engine, &scouted, &lost), TDSP_OK);
    assert_true(lost == 0 || lost == 1);
    assert_exact(scouted.weight, 1.0);
    assert_int_equal(scouted.patience, 0);
    if (lost) assert_exact(scouted.limit, alone.limit);
    /* The limit is the arrival of some path, and not of a much longer one. */
    if (!lost) assert_true(exact <= scouted.limit && scouted.limit - alone.time <= 1.21 * (exact - alone.time));
    scouts_back += !lost;
    run(w, &scouted);
    assert_near(arrived(w), exact, 1e-12 * (1.0 + fabs(exact)));
}

static void scouts_find_a_limit_that_changes_no_answer(void **state)
{
    (void)state;
    scouts_back = 0;
    each_crowd(1, check_scouts);
    assert_true(scouts_back > 24);
}

static void check_weights(world w, double departure)
{
    static const double weights[] = {1.0, 1.001, 1.05, 1.5, 2.0, 5.0};
    engine_question question = solver_forward_question(w.solver, departure);
    run(w, &question);
    double exact = arrived(w), slack = 1e-11 * (1.0 + fabs(exact));
    for (size_t i = 0; i < sizeof weights / sizeof *weights; ++i) {
        question.weight = weights[i];
        run(w, &question);
        assert_int_equal(isinf(arrived(w)), isinf(exact));
        if (isinf(exact)) continue;
        double lower = engine_lower_bound(&w.solver->engine);
        assert_true(lower <= exact + slack && exact <= arrived(w) + slack);
        assert_true(arrived(w) - question.time <= weights[i] * (lower - question.time) + slack);
    }
}

static void a_weighted_path_is_at_most_so_much_longer_than_its_lower_bound(void **state)
{
    (void)state;
    each_crowd(3, check_weights);
}

static void a_search_without_patience_gives_up_and_finds_nothing(void **state)
{
    (void)state;
    static tdsp_disc discs[MOST];
    uint64_t chance = 4;
    crowd(discs, MOST, 0.001, &chance);
    world w = world_make(across, discs, MOST);
    disc_engine *engine = &w.solver->engine;
    engine_question question = solver_forward_question(w.solver, 0.0);
    run(w, &question);
    uint64_t needed = engine->chunks;
    assert_int_equal(engine->gave_up, 0);
    assert_true(needed > 20);
    question.patience = needed / 2;
    run(w, &question);
    assert_int_equal(engine->gave_up, 1);
    assert_int_equal(engine->arrived, ENGINE_NONE);
    assert_true(engine->chunks <= question.patience + 1);
    question.patience = needed;
    run(w, &question);
    assert_int_equal(engine->gave_up, 0);
    assert_true(engine->arrived != ENGINE_NONE);
    world_free(w);
}

static void a_small_scene_sends_no_scouts(void **state)
{
    (void)state;
    static tdsp_disc discs[MOST];
    uint64_t chance = 5;
    crowd(discs, 64, 0.001, &chance);
    world w = world_make(across, discs, 64);
    engine_question question = solver_forward_question(w.solver, 0.0);
    double limit = question.limit;
    int lost = 7;
    uint64_t runs = w.solver->engine.chunks_followed;
    assert_int_equal(engine_scout(&w.solver->engine, &question, &lost), TDSP_OK);
    assert_int_equal(lost, 0);
    assert_exact(question.limit, limit);
    assert_int_equal(w.solver->engine.chunks_followed, runs);
    world_free(w);
}

static void scouts_are_lost_where_there_is_no_way(void **state)
{
    (void)state;
    static tdsp_disc discs[MOST];
    uint64_t chance = 6;
    crowd(discs, 400, 0.0, &chance);
    for (int i = 0; i < 40; ++i) {
        tdsp_disc ring = {{12.0 + 2.0 * cos(GEOM_PI * i / 20), 2.0 * sin(GEOM_PI * i / 20)}, 0.17, 0.0};
        discs[i] = ring;
    }
    world w = world_make(across, discs, 400);
    engine_question question = solver_forward_question(w.solver, 0.0);
    int lost = 7;
    assert_int_equal(engine_scout(&w.solver->engine, &question, &lost), TDSP_OK);
    assert_int_equal(lost, 1);
    assert_exact(question.limit, INFINITY);
    world_free(w);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(scouts_find_a_limit_that_changes_no_answer),
        cmocka_unit_test(a_weighted_path_is_at_most_so_much_longer_than_its_lower_bound),
        cmocka_unit_test(a_search_without_patience_gives_up_and_finds_nothing),
        cmocka_unit_test(a_small_scene_sends_no_scouts),
        cmocka_unit_test(scouts_are_lost_where_there_is_no_way),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
