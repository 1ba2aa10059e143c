/* SPDX-License-Identifier: MIT */
/* Every allocation of a scene, a solver and its answers fails in turn: told, nothing leaks, outputs stay, and everything goes on working. */
#include "support/cmocka_all.h"

#include <string.h>

#include "support/chance.h"
#include "support/tight.h"
#include "tdsp/solver.h"

enum { MANY = 100, LEGS = 256 };

static const tdsp_journey across = {1.0, 0.0, {-10.0, 0.0}, {10.0, 0.0}};

/* More discs than are searched whole, some of them enclosed by others. */
static void crowd(tdsp_disc *discs)
{
    uint64_t chance = 1;
    for (int i = 0; i < MANY; ++i) {
        tdsp_disc disc = {{chance_between(&chance, -7.0, 7.0), chance_between(&chance, -5.0, 5.0)}, chance_between(&chance, 0.1, 0.5), 0.01};
        discs[i] = disc;
    }
}

typedef struct world {
    tight_heap heap;
    tdsp_allocator memory;
    tdsp_disc discs[MANY];
    size_t count;
    tdsp_scene *scene;
    tdsp_solver *solver;
} world;

static void world_init(world *w, size_t count)
{
    memset(w, 0, sizeof *w);
    w->memory = tight_allocator(&w->heap);
    w->count = count;
    crowd(w->discs);
}

static void world_open(world *w)
{
    assert_int_equal(tdsp_scene_create(&across, w->discs, w->count, &w->memory, &w->scene), TDSP_OK);
    assert_int_equal(tdsp_solver_create(w->scene, &w->solver), TDSP_OK);
}

static void world_close(world *w)
{
    tdsp_solver_free(w->solver);
    tdsp_scene_free(w->scene);
    assert_int_equal(w->heap.blocks, 0);
    assert_int_equal(w->heap.held, 0);
}

static const size_t counts[] = {0, 1, 40, MANY};

static void a_scene_that_cannot_be_made_leaves_nothing(void **state)
{
    (void)state;
    static world w;
    for (size_t k = 0; k < 4; ++k)
        for (size_t refuse = 1;; ++refuse) {
            world_init(&w, counts[k]);
            w.heap.refuse = refuse;
            w.scene = (tdsp_scene *)&w;
            tdsp_status status = tdsp_scene_create(&across, w.discs, w.count, &w.memory, &w.scene);
            if (status == TDSP_OK) {
                assert_true(refuse > w.heap.calls);
                world_close(&w);
                break;
            }
            assert_int_equal(status, TDSP_NO_MEMORY);
            assert_ptr_equal(w.scene, &w);
            assert_int_equal(w.heap.blocks, 0);
            assert_int_equal(w.heap.held, 0);
        }
}

static void a_solver_that_cannot_be_made_leaves_the_scene_usable(void **state)
{
    (void)state;
    static world w;
    for (size_t k = 0; k < 4; ++k) {
        world_init(&w, counts[k]);
        assert_int_equal(tdsp_scene_create(&across, w.discs, w.count, &w.memory, &w.scene), TDSP_OK);
        size_t blocks = w.heap.blocks, held = w.heap.held;
        for (size_t refuse = 1;; ++refuse) {
            tdsp_solver *solver = (tdsp_solver *)&w;
            w.heap.refuse = w.heap.calls + refuse;
            tdsp_status status = tdsp_solver_create(w.scene, &solver);
            if (status == TDSP_OK) {
                tdsp_solver_free(solver);
                break;
            }
            assert_int_equal(status, TDSP_NO_MEMORY);
            assert_ptr_equal(solver, &w);
            assert_int_equal(w.heap.blocks, blocks);
            assert_int_equal(w.heap.held, held);
        }
        w.heap.refuse = 0;
        assert_int_equal(tdsp_solver_create(w.scene, &w.solver), TDSP_OK);
        world_close(&w);
    }
}

typedef struct answer {
    double number;
    double other;
    size_t legs;
    tdsp_leg path[LEGS];
} answer;

typedef tdsp_status (*question)(world *w, answer *out);

static tdsp_status keep_path(world *w, answer *out)
{
    return tdsp_solver_path(w->solver, out->path, LEGS, &out->legs);
}

static tdsp_status ask_arrival(world *w, answer *out)
{
    tdsp_status status = tdsp_earliest_arrival(w->solver, 1.0, &out->number);
    return status == TDSP_OK ? keep_path(w, out) : status;
}

static tdsp_status ask_departure(world *w, answer *out)
{
    tdsp_status status = tdsp_latest_departure(w->solver, 26.0, &out->number, &out->other);
    return status == TDSP_OK ? keep_path(w, out) : status;
}

static tdsp_status ask_last(world *w, answer *out)
{
    tdsp_last_departure last;
    tdsp_status status = tdsp_solver_last_departure(w->solver, &last);
    if (status != TDSP_OK) return status;
    out->number = last.departure;
    out->other = last.arrival;
    return TDSP_OK;
}

/* Fail each allocation of the question in turn, each time with a solver that has not reserved anything; then ask the same solver again. */
static void fail_each(size_t count, question ask)
{
    static world w;
    static answer expected, untouched, got;
    memset(&expected, 0, sizeof expected);
    memset(&untouched, 0, sizeof untouched);
    world_init(&w, count);
    world_open(&w);
    assert_int_equal(ask(&w, &expected), TDSP_OK);
    for (size_t refuse = 1;; ++refuse) {
        tdsp_solver_free(w.solver);
        assert_int_equal(tdsp_solver_create(w.scene, &w.solver), TDSP_OK);
        got = untouched;
        w.heap.refuse = w.heap.calls + refuse;
        tdsp_status status = ask(&w, &got);
        if (status == TDSP_OK) {
            assert_memory_equal(&got, &expected, sizeof got);
            break;
        }
        assert_int_equal(status, TDSP_NO_MEMORY);
        assert_memory_equal(&got, &untouched, sizeof got);
        w.heap.refuse = 0;
        assert_int_equal(ask(&w, &got), TDSP_OK);
        assert_memory_equal(&got, &expected, sizeof got);
    }
    world_close(&w);
}

static void an_arrival_without_memory_is_told_and_can_be_asked_again(void **state)
{
    (void)state;
    for (size_t k = 0; k < 4; ++k) fail_each(counts[k], ask_arrival);
}

static void a_latest_departure_without_memory_is_told_and_can_be_asked_again(void **state)
{
    (void)state;
    for (size_t k = 0; k < 4; ++k) fail_each(counts[k], ask_departure);
}

static void the_last_departure_without_memory_is_told_and_can_be_asked_again(void **state)
{
    (void)state;
    for (size_t k = 0; k < 4; ++k) fail_each(counts[k], ask_last);
}

static void after_a_failure_there_is_no_path(void **state)
{
    (void)state;
    static world w;
    double arrival = -1.0;
    size_t count = 77;
    world_init(&w, 40);
    world_open(&w);
    w.heap.refuse = w.heap.calls + 1;
    assert_int_equal(tdsp_earliest_arrival(w.solver, 1.0, &arrival), TDSP_NO_MEMORY);
    assert_exact(arrival, -1.0);
    assert_int_equal(tdsp_solver_path(w.solver, NULL, 0, &count), TDSP_NO_ANSWER);
    assert_int_equal(count, 77);
    world_close(&w);
}

static void the_memory_told_is_the_memory_held(void **state)
{
    (void)state;
    static world w;
    for (size_t k = 0; k < 4; ++k) {
        double number;
        tdsp_solver_work work;
        world_init(&w, counts[k]);
        assert_int_equal(tdsp_scene_create(&across, w.discs, w.count, &w.memory, &w.scene), TDSP_OK);
        size_t of_scene = w.heap.held;
        assert_int_equal(tdsp_solver_create(w.scene, &w.solver), TDSP_OK);
        assert_int_equal(tdsp_earliest_arrival(w.solver, 1.0, &number), TDSP_OK);
        assert_int_equal(tdsp_latest_departure(w.solver, 26.0, &number, NULL), TDSP_OK);
        assert_int_equal(tdsp_solver_work_done(w.solver, &work), TDSP_OK);
        assert_near((double)work.bytes, (double)(w.heap.held - of_scene), 512.0);
        world_close(&w);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_scene_that_cannot_be_made_leaves_nothing),
        cmocka_unit_test(a_solver_that_cannot_be_made_leaves_the_scene_usable),
        cmocka_unit_test(an_arrival_without_memory_is_told_and_can_be_asked_again),
        cmocka_unit_test(a_latest_departure_without_memory_is_told_and_can_be_asked_again),
        cmocka_unit_test(the_last_departure_without_memory_is_told_and_can_be_asked_again),
        cmocka_unit_test(after_a_failure_there_is_no_path),
        cmocka_unit_test(the_memory_told_is_the_memory_held),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
