/* SPDX-License-Identifier: MIT */
/*
 * Searches, tables, matrices and their checks, without memory: each allocation fails in turn (support/scarce.h).
 *
 * A public function is a row of `calls` here or in the test beside it, or is named by NEEDS_NONE in test_no_memory_needed.c; tests/faults/check_calls.py
 * fails when one is neither.
 */
#include "support/cmocka_all.h"

#include "base/hash.h"
#include "support/scarce.h"
#include "support/toy_oracles.h"

static tdsp_status call_search_create(scarce *f, scarce_answer *a)
{
    BLANKED(tdsp_search *, search);
    const tdsp_status status = tdsp_search_create(&f->memory, &search);
    if (LEFT(status, search) != TDSP_OK) return status;
    scarce_tell(a, 1.0);
    tdsp_search_free(search);
    return TDSP_OK;
}

/* A tree with two children each, whose labels are counted. */
static tdsp_status expand(void *ctx, const tdsp_label *label, tdsp_search *open, int *done)
{
    scarce_answer *a = ctx;
    scarce_tell(a, label->time);
    *done = a->count == 300;
    for (uint32_t i = 0; i < 2; ++i) {
        const tdsp_label child = {label->time + 1.0 + i, label->id + i, label->kind};
        const tdsp_status status = tdsp_search_push(open, &child);
        if (status != TDSP_OK) return status;
    }
    return TDSP_OK;
}

static tdsp_status call_search_run(scarce *f, scarce_answer *a)
{
    const tdsp_label starts[3] = {{0.0, 1, 0}, {0.5, 2, 0}, {0.25, 3, 0}};
    const tdsp_search_problem problem = {.size = sizeof problem, .ctx = a, .expand = expand};
    tdsp_search *search;
    BLANKED(int, done);
    tdsp_status status = tdsp_search_create(&f->memory, &search);
    if (status != TDSP_OK) return status;
    status = LEFT(tdsp_search_run(search, &problem, starts, 3, &done), done);
    if (status == TDSP_OK) scarce_tell(a, done);
    tdsp_search_free(search);
    if (status != TDSP_OK) a->count = 0;
    return status;
}

static void tell_bytes(scarce *f, void *bytes, size_t length, scarce_answer *a)
{
    scarce_tell(a, (double)length);
    scarce_tell_whole(a, hash_fnv1a(HASH_FNV1A_SEED, bytes, length));
    tdsp_bytes_free(&f->memory, bytes, length);
}

typedef struct built {
    void *bytes;
    size_t length;
} built;

static tdsp_status call_build(scarce *f, scarce_answer *a)
{
    const tdsp_build_options options = scarce_options(f->scene);
    tdsp_oracle oracle;
    BLANKED(built, out);
    BLANKED(tdsp_build_report, report);
    assert_int_equal(tdsp_solver_oracle(f->solver, &oracle), TDSP_OK);
    const tdsp_status status = tdsp_build(&oracle, &options, &f->memory, &out.bytes, &out.length, &report);
    if (LEFT(status, report) != TDSP_OK || LEFT(status, out) != TDSP_OK) return LEFT(status, out);
    scarce_tell(a, (double)report.rows);
    tell_bytes(f, out.bytes, out.length, a);
    return TDSP_OK;
}

static const tdsp_matrix_end matrix_ends[2] = {{{-9.0, 1.0}, "west", 4}, {{9.0, -1.0}, NULL, 0}};

static tdsp_status pair_oracle(void *ctx, size_t i, size_t j, size_t worker, tdsp_oracle *oracle, uint64_t *scene_hash)
{
    const scarce *f = ctx;
    const tdsp_ends ends = {matrix_ends[i].place, matrix_ends[j].place};
    (void)worker;
    const tdsp_status status = tdsp_solver_set_ends(f->solver, &ends);
    *scene_hash = tdsp_scene_hash_for(f->scene, &ends);
    return status == TDSP_OK ? tdsp_solver_oracle(f->solver, oracle) : status;
}

static tdsp_status call_matrix_build(scarce *f, scarce_answer *a)
{
    const tdsp_build_options options = scarce_options(f->scene);
    const tdsp_matrix_plan plan = {matrix_ends, 1, matrix_ends, 2, pair_oracle, f};
    BLANKED(built, out);
    const tdsp_status status = tdsp_matrix_build(&plan, &options, &f->memory, &out.bytes, &out.length, NULL);
    if (LEFT(status, out) != TDSP_OK) return status;
    tell_bytes(f, out.bytes, out.length, a);
    return TDSP_OK;
}

static tdsp_status call_oracle_check(scarce *f, scarce_answer *a)
{
    static const toy_piece rising[] = {{10.0, 5.0, 0.5, 0.0}};
    toy t = toy_over(rising, 1, 0);
    const tdsp_oracle oracle = toy_oracle(&t, 0);
    tdsp_oracle_check_options options;
    tdsp_oracle_check_options_init(&options);
    options.departures = 20;
    BLANKED(tdsp_oracle_findings, found);
    const tdsp_status status = tdsp_oracle_check(&oracle, &options, &f->memory, &found);
    if (LEFT(status, found) != TDSP_OK) return status;
    scarce_tell_whole(a, found.looked_at);
    scarce_tell(a, (double)found.calls);
    return TDSP_OK;
}

static tdsp_status told_verdict(tdsp_status status, const tdsp_verdict *v, scarce_answer *a)
{
    if (LEFT(status, *v) != TDSP_OK) return status;
    scarce_tell(a, v->problems);
    scarce_tell(a, v->min_clearance);
    scarce_tell(a, v->disc);
    return TDSP_OK;
}

static tdsp_status call_verify_path(scarce *f, scarce_answer *a)
{
    const scarce_made *m = scarce_made_of(f->kind);
    BLANKED(tdsp_verdict, v);
    return told_verdict(tdsp_verify_path(f->scene, m->legs, m->leg_count, 1.0, m->arrival, &v), &v, a);
}

static tdsp_status call_verify_path_for(scarce *f, scarce_answer *a)
{
    const scarce_made *m = scarce_made_of(f->kind);
    BLANKED(tdsp_verdict, v);
    return told_verdict(tdsp_verify_path_for(f->scene, &scarce_aside, m->legs, m->leg_count, 1.0, m->arrival, &v), &v, a);
}

static tdsp_status told_table_verdict(tdsp_status status, const tdsp_table_verdict *v, scarce_answer *a)
{
    if (LEFT(status, *v) != TDSP_OK) return status;
    scarce_tell(a, v->ok);
    scarce_tell(a, (double)v->bad_paths);
    return told_verdict(TDSP_OK, &v->worst, a);
}

static tdsp_status call_verify_table(scarce *f, scarce_answer *a)
{
    BLANKED(tdsp_table_verdict, v);
    return told_table_verdict(tdsp_verify_table(f->scene, &scarce_made_of(f->kind)->table, &v), &v, a);
}

static tdsp_status call_verify_table_for(scarce *f, scarce_answer *a)
{
    BLANKED(tdsp_table_verdict, v);
    return told_table_verdict(tdsp_verify_table_for(f->scene, &scarce_aside, &scarce_made_of(f->kind)->table, &v), &v, a);
}

static const scarce_call calls[] = {
    {"tdsp_search_create", call_search_create},
    {"tdsp_search_run", call_search_run},
    {"tdsp_search_push", call_search_run},
    {"tdsp_build", call_build},
    {"tdsp_matrix_build", call_matrix_build},
    {"tdsp_oracle_check", call_oracle_check},
    {"tdsp_verify_path", call_verify_path},
    {"tdsp_verify_path_for", call_verify_path_for},
    {"tdsp_verify_table", call_verify_table},
    {"tdsp_verify_table_for", call_verify_table_for},
};

static void every_function_says_that_there_is_no_memory_and_answers_in_full_afterwards(void **state)
{
    (void)state;
    scarce_try(calls, sizeof calls / sizeof *calls);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_function_says_that_there_is_no_memory_and_answers_in_full_afterwards),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
