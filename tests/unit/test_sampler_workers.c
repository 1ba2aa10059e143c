/* SPDX-License-Identifier: MIT */
/* Rows by several workers: the same bytes whoever does what, in whatever order. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <string.h>

#include <cmocka.h>
#include <glib.h>

#include "support/assert.h"
#include "support/tight.h"
#include "support/toy_tables.h"

#define MOST 5

typedef struct crew {
    toy toys[MOST];
    tdsp_oracle oracles[MOST];
    size_t count;
    size_t tasks;
} crew;

static void hire(crew *c, const toy *world, size_t count, int forward_only)
{
    c->count = count;
    c->tasks = 0;
    for (size_t i = 0; i < count; i++) {
        c->toys[i] = *world;
        c->oracles[i] = toy_oracle(&c->toys[i], forward_only);
    }
}

/* From the last task to the first, dealt to the workers in turn. */
static void run_backwards(void *ctx, tdsp_task task, void *task_ctx, size_t count)
{
    crew *c = ctx;
    for (size_t i = count; i-- > 0;)
        task(task_ctx, i, c->tasks++ % c->count);
}

typedef struct share {
    tdsp_task task;
    void *task_ctx;
    size_t worker;
    size_t workers;
    size_t count;
} share;

static gpointer work(gpointer data)
{
    const share *s = data;
    for (size_t i = s->worker; i < s->count; i += s->workers)
        s->task(s->task_ctx, i, s->worker);
    return NULL;
}

static void run_in_threads(void *ctx, tdsp_task task, void *task_ctx, size_t count)
{
    const crew *c = ctx;
    share shares[MOST];
    GThread *threads[MOST];
    for (size_t w = 0; w < c->count; w++) {
        shares[w] = (share){task, task_ctx, w, c->count, count};
        threads[w] = g_thread_new("worker", work, &shares[w]);
    }
    for (size_t w = 0; w < c->count; w++)
        g_thread_join(threads[w]);
}

static void run_all_but_one(void *ctx, tdsp_task task, void *task_ctx, size_t count)
{
    (void)ctx;
    for (size_t i = 1; i < count; i++)
        task(task_ctx, i, 0);
}

static void run_too_many(void *ctx, tdsp_task task, void *task_ctx, size_t count)
{
    (void)ctx;
    for (size_t i = 0; i < count + 3; i++)
        task(task_ctx, i, 0);
}

static void run_by_a_stranger(void *ctx, tdsp_task task, void *task_ctx, size_t count)
{
    const crew *c = ctx;
    for (size_t i = 0; i < count; i++)
        task(task_ctx, i, c->count);
}

static tdsp_build_options geometric(void)
{
    tdsp_build_options options;
    tdsp_build_options_init(&options);
    options.guarantee = TDSP_GUARANTEE_ARRIVAL;
    options.sampling = TDSP_SAMPLING_GEOMETRIC;
    return options;
}

static tdsp_build_options adaptive(tdsp_guarantee guarantee)
{
    tdsp_build_options options;
    tdsp_build_options_init(&options);
    options.guarantee = guarantee;
    options.delta = 0.03;
    return options;
}

static toy_table build_by(crew *c, const toy *world, size_t count, int forward_only, tdsp_run_tasks run, tdsp_build_options options)
{
    hire(c, world, count, forward_only);
    options.workers = c->oracles;
    options.worker_count = c->count;
    options.run_tasks = run;
    options.run_tasks_ctx = c;
    toy t = *world;
    tdsp_oracle oracle = toy_oracle(&t, forward_only);
    toy_table table = toy_build(&oracle, &options);
    uint64_t forward = t.forward_calls;
    uint64_t reverse = t.reverse_calls;
    for (size_t i = 0; i < count; i++)
        forward += c->toys[i].forward_calls, reverse += c->toys[i].reverse_calls;
    assert_int_equal(table.report.forward_calls, forward);
    assert_int_equal(table.report.reverse_calls, reverse);
    return table;
}

static void assert_same_bytes(const toy_table *a, const toy_table *b)
{
    assert_int_equal(a->length, b->length);
    assert_memory_equal(a->bytes, b->bytes, a->length);
}

static void check_world(const toy_world *world, int forward_only, double error, tdsp_build_options options)
{
    toy t = world->toy;
    t.error = error;
    t.time_scale = (double)toy_value(&t, 0);
    t.blur = error * t.time_scale;
    t.rough = error > 0;
    options.delta *= t.time_scale;
    toy used = t;
    tdsp_oracle oracle = toy_oracle(&used, forward_only);
    toy_table alone = toy_build(&oracle, &options);
    static const size_t counts[] = {1, 2, MOST};
    for (size_t i = 0; i < 3; i++) {
        crew c;
        toy_table backwards = build_by(&c, &t, counts[i], forward_only, run_backwards, options);
        assert_same_bytes(&alone, &backwards);
        toy_table_free(&backwards);
        toy_table threads = build_by(&c, &t, counts[i], forward_only, run_in_threads, options);
        assert_same_bytes(&alone, &threads);
        toy_table_free(&threads);
    }
    toy_table_free(&alone);
}

static void check_worlds(const toy_world *(*some)(size_t *count), tdsp_build_options options)
{
    size_t count;
    const toy_world *worlds = some(&count);
    for (int mode = 0; mode < 4; mode++)
        for (size_t i = 0; i < count; i++)
            if (toy_value(&worlds[i].toy, 0) != 0) check_world(&worlds[i], mode & 1, mode & 2 ? 1e-11 : 0, options);
}

static void bytes_do_not_depend_on_the_workers(void **state)
{
    (void)state;
    check_worlds(toy_worlds, geometric());
    check_worlds(toy_networks, geometric());
}

static void bytes_of_adaptive_tables_do_not_depend_on_the_workers_either(void **state)
{
    (void)state;
    check_worlds(toy_worlds, adaptive(TDSP_GUARANTEE_TRAVEL));
    check_worlds(toy_worlds, adaptive(TDSP_GUARANTEE_ARRIVAL));
    check_worlds(toy_worlds, adaptive(TDSP_GUARANTEE_ABSOLUTE));
    check_worlds(toy_networks, adaptive(TDSP_GUARANTEE_ARRIVAL));
}

static tdsp_status outcome(crew *c, tdsp_run_tasks run, tight_heap *heap, tdsp_build_options options)
{
    options.workers = c->oracles;
    options.worker_count = c->count;
    options.run_tasks = run;
    options.run_tasks_ctx = c;
    toy t = toy_named("bend")->toy;
    tdsp_oracle oracle = toy_oracle(&t, 0);
    tdsp_allocator allocator = tight_allocator(heap);
    void *bytes = NULL;
    size_t length = 0;
    tdsp_status status = tdsp_build(&oracle, &options, &allocator, &bytes, &length, NULL);
    if (status == TDSP_OK)
        tdsp_bytes_free(&allocator, bytes, length);
    else
        assert_null(bytes);
    assert_int_equal(heap->blocks, 0);
    return status;
}

static tdsp_status outcome_of(tdsp_run_tasks run, tdsp_build_options options)
{
    crew c;
    hire(&c, &toy_named("bend")->toy, 2, 0);
    tight_heap heap = {0};
    return outcome(&c, run, &heap, options);
}

static void runners_that_do_not_keep_to_the_rules_are_found_out(void **state)
{
    (void)state;
    const tdsp_build_options both[] = {geometric(), adaptive(TDSP_GUARANTEE_TRAVEL)};
    for (size_t i = 0; i < 2; i++) {
        assert_int_equal(outcome_of(run_all_but_one, both[i]), TDSP_FAILED);
        assert_int_equal(outcome_of(run_by_a_stranger, both[i]), TDSP_INVALID_ARGUMENT);
        assert_int_equal(outcome_of(run_too_many, both[i]), TDSP_OK);
    }
}

static void errors_of_a_worker_are_handed_on(void **state)
{
    (void)state;
    for (uint64_t at = 1; at < 30; at++) {
        crew c;
        hire(&c, &toy_named("bend")->toy, 2, 0);
        c.toys[1].fault = TOY_ERROR;
        c.toys[1].fault_at = at;
        tight_heap heap = {0};
        assert_int_equal(outcome(&c, run_backwards, &heap, geometric()), TDSP_FAILED);
    }
}

static void every_allocation_may_fail(tdsp_build_options options)
{
    tdsp_status status = TDSP_NO_MEMORY;
    for (size_t refuse = 1; status == TDSP_NO_MEMORY; refuse++) {
        crew c;
        hire(&c, &toy_named("bend")->toy, 3, 0);
        tight_heap heap = {.refuse = refuse};
        status = outcome(&c, run_backwards, &heap, options);
        assert_true(status == TDSP_OK || heap.calls >= refuse);
    }
    assert_int_equal(status, TDSP_OK);
}

static void every_allocation_of_a_worker_may_fail(void **state)
{
    (void)state;
    every_allocation_may_fail(geometric());
    every_allocation_may_fail(adaptive(TDSP_GUARANTEE_TRAVEL));
}

static int cancel(void *ctx, double settled, double all)
{
    (void)settled;
    (void)all;
    size_t *left = ctx;
    return *left == 0 ? 1 : ((*left)--, 0);
}

static void a_parallel_build_can_be_cancelled_between_batches(void **state)
{
    (void)state;
    for (size_t allowed = 0; allowed < 10; allowed++) {
        crew c;
        hire(&c, &toy_named("bend")->toy, 2, 0);
        tdsp_build_options options = geometric();
        size_t left = allowed;
        options.workers = c.oracles;
        options.worker_count = c.count;
        options.run_tasks = run_backwards;
        options.run_tasks_ctx = &c;
        options.progress = cancel;
        options.progress_ctx = &left;
        tdsp_oracle oracle = c.oracles[0];
        void *bytes = NULL;
        size_t length = 0;
        assert_int_equal(tdsp_build(&oracle, &options, NULL, &bytes, &length, NULL), TDSP_CANCELLED);
        assert_null(bytes);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(bytes_do_not_depend_on_the_workers),
        cmocka_unit_test(bytes_of_adaptive_tables_do_not_depend_on_the_workers_either),
        cmocka_unit_test(runners_that_do_not_keep_to_the_rules_are_found_out),
        cmocka_unit_test(errors_of_a_worker_are_handed_on),
        cmocka_unit_test(every_allocation_of_a_worker_may_fail),
        cmocka_unit_test(a_parallel_build_can_be_cancelled_between_batches),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
