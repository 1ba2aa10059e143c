/* SPDX-License-Identifier: MIT */
/* Everything with a progress callback is cancelled at each of its calls: it says so at once, hands out nothing, keeps nothing, and answers in full afterwards. */
#include "support/cmocka_all.h"

#include "base/hash.h"
#include "support/scarce.h"

/* Cancels at call number `at`; 0 never. */
typedef struct watch {
    uint64_t calls;
    uint64_t at;
} watch;

static int watch_progress(void *ctx, double settled, double all)
{
    watch *w = ctx;
    assert_true(settled <= all);
    return ++w->calls == w->at;
}

typedef tdsp_status (*work)(scarce *f, watch *w, scarce_answer *a);

static void tell_bytes(scarce *f, void *bytes, size_t length, scarce_answer *a)
{
    scarce_tell(a, (double)length);
    scarce_tell_whole(a, hash_fnv1a(HASH_FNV1A_SEED, bytes, length));
    tdsp_bytes_free(&f->memory, bytes, length);
}

static tdsp_build_options finer(const tdsp_scene *scene)
{
    tdsp_build_options options = scarce_options(scene);
    options.epsilon = 0.1;
    return options;
}

typedef struct built {
    void *bytes;
    size_t length;
} built;

static tdsp_status build_with(scarce *f, tdsp_build_options options, watch *w, scarce_answer *a)
{
    tdsp_oracle oracle;
    BLANKED(built, out);
    BLANKED(tdsp_build_report, report);
    options.progress = watch_progress;
    options.progress_ctx = w;
    assert_int_equal(tdsp_solver_oracle(f->solver, &oracle), TDSP_OK);
    const tdsp_status status = tdsp_build(&oracle, &options, &f->memory, &out.bytes, &out.length, &report);
    if (status != TDSP_OK) {
        LEFT(status, report);
        return LEFT(status, out);
    }
    tell_bytes(f, out.bytes, out.length, a);
    return TDSP_OK;
}

static tdsp_status build_travel(scarce *f, watch *w, scarce_answer *a)
{
    return build_with(f, finer(f->scene), w, a);
}

static tdsp_status build_exact(scarce *f, watch *w, scarce_answer *a)
{
    tdsp_build_options options = finer(f->scene);
    options.oracle_share = 0.0;
    return build_with(f, options, w, a);
}

static tdsp_status build_absolute(scarce *f, watch *w, scarce_answer *a)
{
    tdsp_build_options options = finer(f->scene);
    options.guarantee = TDSP_GUARANTEE_ABSOLUTE;
    options.delta = 2.0;
    return build_with(f, options, w, a);
}

static tdsp_status build_geometric(scarce *f, watch *w, scarce_answer *a)
{
    tdsp_build_options options = finer(f->scene);
    options.guarantee = TDSP_GUARANTEE_ARRIVAL;
    options.sampling = TDSP_SAMPLING_GEOMETRIC;
    return build_with(f, options, w, a);
}

static tdsp_status build_to_horizon(scarce *f, watch *w, scarce_answer *a)
{
    tdsp_build_options options = finer(f->scene);
    options.horizon = 12.0;
    return build_with(f, options, w, a);
}

static const tdsp_matrix_end ends[3] = {{{-9.0, 1.0}, "west", 4}, {{9.0, -1.0}, NULL, 0}, {{0.0, 9.5}, "north", 5}};

static tdsp_status pair_oracle(void *ctx, size_t i, size_t j, size_t worker, tdsp_oracle *oracle, uint64_t *scene_hash)
{
    const scarce *f = ctx;
    const tdsp_ends pair = {ends[i].place, ends[j].place};
    (void)worker;
    const tdsp_status status = tdsp_solver_set_ends(f->solver, &pair);
    *scene_hash = tdsp_scene_hash_for(f->scene, &pair);
    return status == TDSP_OK ? tdsp_solver_oracle(f->solver, oracle) : status;
}

static tdsp_status build_matrix(scarce *f, watch *w, scarce_answer *a)
{
    tdsp_build_options options = finer(f->scene);
    const tdsp_matrix_plan plan = {ends, 2, ends, 3, pair_oracle, f};
    BLANKED(built, out);
    options.horizon = 15.0;
    options.progress = watch_progress;
    options.progress_ctx = w;
    const tdsp_status status = tdsp_matrix_build(&plan, &options, &f->memory, &out.bytes, &out.length, NULL);
    if (LEFT(status, out) != TDSP_OK) return status;
    tell_bytes(f, out.bytes, out.length, a);
    return TDSP_OK;
}

static tdsp_shape_options shape_options(watch *w)
{
    tdsp_shape_options options;
    tdsp_shape_options_init(&options);
    options.until = 20.0;
    options.resolution = 4.0;
    options.least = 0.5;
    options.progress = watch_progress;
    options.progress_ctx = w;
    return options;
}

static tdsp_status find_jumps(scarce *f, watch *w, scarce_answer *a)
{
    const tdsp_shape_options options = shape_options(w);
    BLANKED(tdsp_jumps *, jumps);
    const tdsp_status status = tdsp_jumps_find(f->solver, &options, &jumps);
    if (LEFT(status, jumps) != TDSP_OK) return status;
    scarce_tell(a, (double)tdsp_jumps_count(jumps));
    for (size_t i = 0; i < tdsp_jumps_count(jumps); ++i) {
        tdsp_arrival_jump jump;
        assert_int_equal(tdsp_jumps_get(jumps, i, &jump), TDSP_OK);
        scarce_tell(a, jump.departure);
    }
    tdsp_jumps_free(jumps);
    return TDSP_OK;
}

static tdsp_status find_envelope(scarce *f, watch *w, scarce_answer *a)
{
    const tdsp_shape_options options = shape_options(w);
    BLANKED(tdsp_envelope *, envelope);
    const tdsp_status status = tdsp_envelope_find(f->solver, &options, &envelope);
    if (LEFT(status, envelope) != TDSP_OK) return status;
    for (size_t i = 0; i < tdsp_envelope_pieces(envelope); ++i) {
        tdsp_piece piece;
        assert_int_equal(tdsp_envelope_piece(envelope, i, &piece), TDSP_OK);
        scarce_tell(a, piece.until);
    }
    tdsp_envelope_free(envelope);
    return TDSP_OK;
}

/* At call `at`, and then the same solver again without. */
static void cancel_at(work what, scarce_world kind, uint64_t at, const scarce_answer *expected)
{
    static scarce_answer got;
    scarce f;
    watch w = {.at = at}, never = {.at = 0};
    scarce_open(&f, kind);
    got.count = 0;
    assert_int_equal(what(&f, &w, &got), TDSP_CANCELLED);
    assert_int_equal(w.calls, at);
    assert_int_equal(got.count, 0);
    assert_int_equal(what(&f, &never, &got), TDSP_OK);
    assert_int_equal(got.count, expected->count);
    assert_memory_equal(got.told, expected->told, expected->count * sizeof *expected->told);
    scarce_close(&f);
}

static uint64_t cancel_each(work what, scarce_world kind)
{
    static scarce_answer expected;
    scarce f;
    watch whole = {.at = 0};
    scarce_open(&f, kind);
    expected.count = 0;
    assert_int_equal(what(&f, &whole, &expected), TDSP_OK);
    scarce_close(&f);
    for (uint64_t at = 1; at <= whole.calls; ++at) cancel_at(what, kind, at, &expected);
    return whole.calls;
}

static void cancel_everywhere(const char *name, work what)
{
    uint64_t calls = 0;
    for (int kind = 0; kind < SCARCE_WORLDS; ++kind) calls += cancel_each(what, (scarce_world)kind);
    print_message("%s: cancelled at each of %u calls of progress\n", name, (unsigned)calls);
    assert_true(calls > 0);
}

static void a_table_is_cancelled_at_every_call_of_progress(void **state)
{
    (void)state;
    cancel_everywhere("tdsp_build, travel", build_travel);
    cancel_everywhere("tdsp_build, exact answers only", build_exact);
    cancel_everywhere("tdsp_build, absolute", build_absolute);
    cancel_everywhere("tdsp_build, geometric", build_geometric);
    cancel_everywhere("tdsp_build, up to a horizon", build_to_horizon);
}

static void a_matrix_is_cancelled_at_every_call_of_progress(void **state)
{
    (void)state;
    cancel_everywhere("tdsp_matrix_build", build_matrix);
}

static void a_shape_is_cancelled_at_every_call_of_progress(void **state)
{
    (void)state;
    cancel_everywhere("tdsp_jumps_find", find_jumps);
    cancel_everywhere("tdsp_envelope_find", find_envelope);
}

/* One oracle for two workers, in turns. */
static void in_turns(void *ctx, tdsp_task task, void *task_ctx, size_t count)
{
    (void)ctx;
    for (size_t i = 0; i < count; ++i) task(task_ctx, i, i % 2);
}

static tdsp_status build_by_two(scarce *f, watch *w, scarce_answer *a)
{
    tdsp_build_options options = finer(f->scene);
    tdsp_oracle workers[2];
    for (int i = 0; i < 2; ++i) assert_int_equal(tdsp_solver_oracle(f->solver, &workers[i]), TDSP_OK);
    options.run_tasks = in_turns;
    options.workers = workers;
    options.worker_count = 2;
    return build_with(f, options, w, a);
}

/* The tasks of a batch that were still to run went on asking the oracle, and progress. */
static void nothing_is_asked_any_more_once_a_batch_was_cancelled(void **state)
{
    (void)state;
    cancel_everywhere("tdsp_build, by two workers", build_by_two);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_table_is_cancelled_at_every_call_of_progress),
        cmocka_unit_test(nothing_is_asked_any_more_once_a_batch_was_cancelled),
        cmocka_unit_test(a_matrix_is_cancelled_at_every_call_of_progress),
        cmocka_unit_test(a_shape_is_cancelled_at_every_call_of_progress),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
