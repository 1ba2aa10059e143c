/* SPDX-License-Identifier: MIT */
/* Worlds without memory. */
#include "support/scarce.h"

#include "support/cmocka_all.h"

#include <stdlib.h>

#include "support/chance.h"

const tdsp_journey scarce_journey = {1.0, 0.0, {-10.0, 0.0}, {10.0, 0.0}};
const tdsp_ends scarce_aside = {{-9.0, 1.0}, {9.0, -1.0}};
static const double bend[2] = {0.1, 0.0005}, rates[2] = {0.05, 0.1}, times[2] = {0.0, 15.0};

static tdsp_disc discs[SCARCE_DISCS];
const tdsp_growing_disc scarce_bent[2] = {
    {{0.0, 3.0}, 1.0, {.kind = TDSP_GROWTH_POLYNOMIAL, .count = 2, .values = bend}},
    {{0.0, -3.0}, 1.0, {.kind = TDSP_GROWTH_RATES, .count = 2, .values = rates, .times = times}},
};

const tdsp_disc *scarce_discs(size_t *count, scarce_world kind)
{
    uint64_t chance = 1;
    const tdsp_disc gate[2] = {{{0.0, 3.0}, 1.0, 0.1}, {{0.0, -3.0}, 1.0, 0.1}};
    for (int i = 0; i < SCARCE_DISCS; ++i) {
        const tdsp_point center = {chance_between(&chance, -7.0, 7.0), chance_between(&chance, -7.0, 7.0)};
        discs[i] = (tdsp_disc){center, chance_between(&chance, 0.1, 0.5), 0.01 + 0.001 * i};
    }
    memcpy(discs, gate, sizeof gate);
    *count = kind == SCARCE_GATE ? 2 : SCARCE_DISCS;
    return discs;
}

static tdsp_status make_scene(scarce_world kind, const tdsp_allocator *memory, tdsp_scene **scene)
{
    if (kind == SCARCE_BENT) return tdsp_scene_create_growing(&scarce_journey, scarce_bent, 2, memory, scene);
    size_t count;
    const tdsp_disc *given = scarce_discs(&count, kind);
    return tdsp_scene_create(&scarce_journey, given, count, memory, scene);
}

void scarce_open(scarce *f, scarce_world kind)
{
    memset(f, 0, sizeof *f);
    f->kind = kind;
    f->memory = tight_allocator(&f->heap);
    assert_int_equal(make_scene(kind, &f->memory, &f->scene), TDSP_OK);
    assert_int_equal(tdsp_solver_create(f->scene, &f->solver), TDSP_OK);
}

void scarce_close(scarce *f)
{
    tdsp_solver_free(f->solver);
    tdsp_scene_free(f->scene);
    assert_int_equal(f->heap.blocks, 0);
    assert_int_equal(f->heap.held, 0);
}

tdsp_build_options scarce_options(const tdsp_scene *scene)
{
    tdsp_build_options options;
    tdsp_build_options_init(&options);
    options.epsilon = 0.5;
    options.world.scene_hash = tdsp_scene_hash(scene);
    options.world.speed = scarce_journey.speed;
    options.world.source = scarce_journey.source;
    options.world.destination = scarce_journey.destination;
    return options;
}

static scarce_made of_world[SCARCE_WORLDS]; /* each made when first asked for */

static void make(scarce_made *m, scarce_world kind)
{
    scarce f;
    tdsp_oracle oracle;
    scarce_open(&f, kind);
    const tdsp_build_options options = scarce_options(f.scene);
    assert_int_equal(tdsp_earliest_arrival(f.solver, 1.0, &m->arrival), TDSP_OK);
    assert_int_equal(tdsp_solver_path(f.solver, m->legs, SCARCE_LEGS, &m->leg_count), TDSP_OK);
    assert_int_equal(tdsp_solver_oracle(f.solver, &oracle), TDSP_OK);
    assert_int_equal(tdsp_build(&oracle, &options, NULL, &m->bytes, &m->length, NULL), TDSP_OK);
    assert_int_equal(tdsp_table_open(&m->table, m->bytes, m->length), TDSP_OK);
    scarce_close(&f);
}

const scarce_made *scarce_made_of(scarce_world kind)
{
    if (!of_world[kind].bytes) make(&of_world[kind], kind);
    return &of_world[kind];
}

static void free_worlds(void)
{
    for (int kind = 0; kind < SCARCE_WORLDS; ++kind) {
        tdsp_bytes_free(NULL, of_world[kind].bytes, of_world[kind].length);
        of_world[kind].bytes = NULL;
    }
}

void scarce_tell(scarce_answer *a, double number)
{
    assert_true(a->count < SCARCE_TOLD);
    a->told[a->count++] = number;
}

void scarce_tell_whole(scarce_answer *a, uint64_t number)
{
    scarce_tell(a, (double)(number >> 32));
    scarce_tell(a, (double)(number & 0xffffffffu));
}

void scarce_tell_path(scarce_answer *a, const tdsp_solver *solver)
{
    tdsp_leg legs[SCARCE_LEGS];
    size_t count;
    assert_int_equal(tdsp_solver_path(solver, legs, SCARCE_LEGS, &count), TDSP_OK);
    for (size_t i = 0; i < count; ++i) {
        scarce_tell(a, legs[i].end_time);
        scarce_tell(a, legs[i].to.x);
        scarce_tell(a, legs[i].to.y);
    }
}

/* An error leaves its output as it was; an answer may write to it. */
tdsp_status scarce_left(tdsp_status status, const void *output, size_t size)
{
    const unsigned char *bytes = output;
    if (!tdsp_status_is_answer(status))
        for (size_t i = 0; i < size; ++i) assert_int_equal(bytes[i], SCARCE_BLANK);
    return status;
}

static void same_answer(const scarce_answer *got, const scarce_answer *expected)
{
    assert_int_equal(got->count, expected->count);
    assert_memory_equal(got->told, expected->told, expected->count * sizeof *expected->told);
}

/* Without allocation `refuse`, and then again with memory. */
static void refuse_one(const scarce_call *s, scarce_world kind, size_t refuse, int and_after, tdsp_status status, const scarce_answer *expected)
{
    static scarce_answer got;
    scarce f;
    scarce_open(&f, kind);
    got.count = 0;
    f.heap.refuse = f.heap.calls + refuse;
    f.heap.and_after = and_after;
    const tdsp_status without = s->call(&f, &got);
    f.heap.refuse = 0;
    if (without != status) assert_int_equal(without, TDSP_NO_MEMORY);
    if (without == status) same_answer(&got, expected);
    got.count = 0;
    assert_int_equal(s->call(&f, &got), status);
    same_answer(&got, expected);
    scarce_close(&f);
}

/* How many allocations failed; `all` grows by how many there are. */
static size_t refuse_each(const scarce_call *s, scarce_world kind, size_t *all)
{
    static scarce_answer expected;
    scarce f;
    scarce_open(&f, kind);
    expected.count = 0;
    scarce_made_of(kind);
    const size_t before = f.heap.calls;
    const tdsp_status status = s->call(&f, &expected);
    const size_t calls = f.heap.calls - before;
    scarce_close(&f);
    size_t failed = 0;
    const char *asked = getenv("SCARCE_ALL");
    const size_t whole = asked ? (size_t)strtoull(asked, NULL, 10) : 64;
    for (size_t refuse = 1; refuse <= calls; refuse += refuse < whole ? 1 : refuse / 8, ++failed)
        for (int and_after = 0; and_after < 2; ++and_after) refuse_one(s, kind, refuse, and_after, status, &expected);
    *all += calls;
    return failed;
}

void scarce_try(const scarce_call *calls, size_t count)
{
    for (size_t i = 0; i < count; ++i) {
        size_t failed = 0, all = 0;
        for (int kind = 0; kind < SCARCE_WORLDS; ++kind) failed += refuse_each(&calls[i], (scarce_world)kind, &all);
        print_message("%s: %zu of %zu allocations failed, alone and with all after them\n", calls[i].function, failed, all);
        assert_true(failed > 0);
    }
    free_worlds();
}
