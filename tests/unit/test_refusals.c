/* SPDX-License-Identifier: MIT */
/* Every allocation of everything that is asked of a scene fails in turn: told, nothing leaks, outputs stay. */
#include "support/cmocka_all.h"

#include <string.h>

#include "support/chance.h"
#include "support/refusals.h"
#include "tdsp/growth.h"
#include "tdsp/margin.h"
#include "tdsp/oracle_check.h"
#include "tdsp/shape.h"
#include "tdsp/solver.h"
#include "tdsp/verify.h"

enum { MANY = 9, LEGS = 64 };

static const tdsp_journey across = {1.0, 0.1, {-10.0, 0.0}, {10.0, 0.0}};
static const double bending[3] = {0.02, 0.001, 1e-5}, rates[3] = {0.02, 0.05, 0.01}, times[3] = {0.0, 5.0, 20.0};

/* Which discs, and how they grow: each kind is solved, raised and verified by code of its own. */
typedef enum discs_kind { KIND_RATES, KIND_PIECES, KIND_BENDING, KINDS } discs_kind;

static tdsp_growing_disc disc_of(discs_kind kind, tdsp_point center, double radius)
{
    tdsp_growing_disc disc;
    memset(&disc, 0, sizeof disc);
    disc.center = center;
    disc.radius = radius;
    disc.growth.kind = kind == KIND_RATES ? TDSP_GROWTH_RATE : kind == KIND_PIECES ? TDSP_GROWTH_RATES : TDSP_GROWTH_POLYNOMIAL;
    disc.growth.rate = 0.03;
    disc.growth.count = 3;
    disc.growth.values = kind == KIND_PIECES ? rates : bending;
    disc.growth.times = times;
    return disc;
}

/* A gap that closes, and a crowd beside it. */
static tdsp_status scene_make(discs_kind kind, const tdsp_allocator *memory, tdsp_scene **out)
{
    tdsp_growing_disc discs[MANY] = {disc_of(kind, (tdsp_point){0.0, 3.0}, 2.5), disc_of(kind, (tdsp_point){0.0, -3.0}, 2.5)};
    uint64_t chance = 1;
    for (int i = 2; i < MANY; ++i) {
        const tdsp_point center = {chance_between(&chance, -8.0, 8.0), chance_between(&chance, 4.0, 9.0)};
        discs[i] = disc_of(kind, center, chance_between(&chance, 0.1, 0.4));
    }
    return tdsp_scene_create_growing(&across, discs, MANY, memory, out);
}

typedef struct question {
    discs_kind kind;
    tdsp_method method;
    tdsp_raise how;
    tdsp_status (*ask)(tdsp_solver *solver, const struct question *self);
    const tdsp_leg *legs; /* a path of the scene */
    size_t leg_count;
} question;

/* What `refuse_each` asks: scene, solver, question. */
static tdsp_status ask_all(const tdsp_allocator *memory, void *ctx)
{
    const question *self = ctx;
    tdsp_scene *scene;
    tdsp_solver *solver;
    tdsp_status status = scene_make(self->kind, memory, &scene);
    if (status != TDSP_OK) return status;
    status = tdsp_solver_create_for(scene, self->method, &solver);
    if (status == TDSP_OK) {
        status = self->ask(solver, self);
        tdsp_solver_free(solver);
    }
    tdsp_scene_free(scene);
    return status;
}

/* Ask of each kind of growth, by the quick method and by the general one. */
static void refuse_raised(tdsp_status (*ask)(tdsp_solver *solver, const question *self), tdsp_raise how, tdsp_status expected)
{
    for (discs_kind kind = 0; kind < KINDS; kind++)
        for (int general = 0; general < 2; general++) {
            question asked = {kind, general ? TDSP_METHOD_GENERAL : TDSP_METHOD_AUTO, how, ask, NULL, 0};
            assert_true(refuse_each(ask_all, &asked, expected) > 10);
        }
}

static void refuse(tdsp_status (*ask)(tdsp_solver *solver, const question *self), tdsp_status expected)
{
    refuse_raised(ask, TDSP_RAISE_FACTOR, expected);
}

/* The outputs hold bytes of 0x55 before, and still do unless the status is TDSP_OK. */
static void poison(void *out, size_t size)
{
    memset(out, 0x55, size);
}

static tdsp_status answered(tdsp_status status, const void *out, size_t size)
{
    const unsigned char *bytes = out;
    for (size_t i = 0; status != TDSP_OK && i < size; i++) assert_int_equal(bytes[i], 0x55);
    return status;
}

static tdsp_status ask_arrival(tdsp_solver *solver, const question *self)
{
    double arrival;
    (void)self;
    poison(&arrival, sizeof arrival);
    return answered(tdsp_earliest_arrival(solver, 1.0, &arrival), &arrival, sizeof arrival);
}

static tdsp_status ask_latest(tdsp_solver *solver, const question *self)
{
    double found[2];
    (void)self;
    poison(found, sizeof found);
    return answered(tdsp_latest_departure(solver, 25.0, &found[0], &found[1]), found, sizeof found);
}

static tdsp_status ask_last(tdsp_solver *solver, const question *self)
{
    tdsp_last_departure last;
    (void)self;
    poison(&last, sizeof last);
    return answered(tdsp_solver_last_departure(solver, &last), &last, sizeof last);
}

static tdsp_status ask_within(tdsp_solver *solver, const question *self)
{
    double found[2];
    (void)self;
    poison(found, sizeof found);
    return answered(tdsp_earliest_arrival_within(solver, 1.0, 0.01, &found[0], &found[1]), found, sizeof found);
}

static tdsp_status ask_gap(tdsp_solver *solver, const question *self)
{
    tdsp_gap gap;
    (void)self;
    poison(&gap, sizeof gap);
    return answered(tdsp_solver_gap(solver, 1.0, &gap), &gap, sizeof gap);
}

static void answers_without_memory_are_told(void **state)
{
    (void)state;
    refuse(ask_arrival, TDSP_OK);
    refuse(ask_latest, TDSP_OK);
    refuse(ask_last, TDSP_OK);
    refuse(ask_within, TDSP_OK);
    refuse(ask_gap, TDSP_NO_ANSWER);
}

enum { PLACES = 9 };
static const tdsp_point places[PLACES] = {{10.0, 0.0}, {10.0, 1.0}, {9.0, -2.0}, {5.0, -7.0}, {0.0, 3.0},
                                          {8.0, 3.0},  {7.0, -1.0}, {3.0, 0.0},  {9.5, 2.0}};

static tdsp_status ask_arrivals(tdsp_solver *solver, const question *self)
{
    double found[PLACES];
    tdsp_status statuses[PLACES];
    (void)self;
    poison(found, sizeof found);
    const tdsp_status status = tdsp_earliest_arrivals(solver, across.source, 1.0, places, PLACES, found, statuses);
    return answered(status, found, sizeof found);
}

static tdsp_status ask_departures(tdsp_solver *solver, const question *self)
{
    double found[PLACES];
    tdsp_status statuses[PLACES];
    (void)self;
    poison(found, sizeof found);
    const tdsp_status status = tdsp_latest_departures(solver, places, PLACES, across.source, 30.0, found, NULL, statuses);
    return answered(status, found, sizeof found);
}

static void many_answers_without_memory_are_told(void **state)
{
    (void)state;
    refuse(ask_arrivals, TDSP_OK);
    refuse(ask_departures, TDSP_OK);
}

static tdsp_status ask_deadline(tdsp_solver *solver, const question *self)
{
    tdsp_deadline_answer answer;
    (void)self;
    poison(&answer, sizeof answer);
    return answered(tdsp_solver_deadline(solver, 25.0, &answer), &answer, sizeof answer);
}

static tdsp_status ask_end(tdsp_solver *solver, const question *self)
{
    tdsp_deadline_answer answer;
    (void)self;
    poison(&answer, sizeof answer);
    return answered(tdsp_solver_deadline(solver, INFINITY, &answer), &answer, sizeof answer);
}

static tdsp_status ask_slack(tdsp_solver *solver, const question *self)
{
    tdsp_slack slack;
    (void)self;
    poison(&slack, sizeof slack);
    return answered(tdsp_solver_slack(solver, 1.0, 25.0, &slack), &slack, sizeof slack);
}

static tdsp_status ask_margin(tdsp_solver *solver, const question *self)
{
    tdsp_margin margin;
    poison(&margin, sizeof margin);
    return answered(tdsp_departure_margin(tdsp_solver_scene(solver), self->how, 1.0, 25.0, &margin), &margin, sizeof margin);
}

static tdsp_status ask_raised(tdsp_solver *solver, const question *self)
{
    tdsp_scene *raised = (tdsp_scene *)&raised;
    const tdsp_status status = tdsp_scene_raise(tdsp_solver_scene(solver), self->how, 1.5, &raised);
    if (status == TDSP_OK)
        tdsp_scene_free(raised);
    else
        assert_ptr_equal(raised, &raised);
    return status;
}

static void deadlines_and_margins_without_memory_are_told(void **state)
{
    (void)state;
    refuse(ask_deadline, TDSP_OK);
    refuse(ask_end, TDSP_OK);
    refuse(ask_slack, TDSP_OK);
    refuse_raised(ask_margin, TDSP_RAISE_FACTOR, TDSP_OK);
    refuse_raised(ask_margin, TDSP_RAISE_ADDED, TDSP_OK);
    refuse_raised(ask_raised, TDSP_RAISE_FACTOR, TDSP_OK);
    refuse_raised(ask_raised, TDSP_RAISE_ADDED, TDSP_OK);
}

static tdsp_status ask_path_margin(tdsp_solver *solver, const question *self)
{
    tdsp_margin margin;
    poison(&margin, sizeof margin);
    const tdsp_status status = tdsp_path_margin(tdsp_solver_scene(solver), self->how, self->legs, self->leg_count, 1.0, &margin);
    return answered(status, &margin, sizeof margin);
}

static tdsp_status ask_verdict(tdsp_solver *solver, const question *self)
{
    tdsp_verdict verdict;
    poison(&verdict, sizeof verdict);
    const double arrival = self->legs[self->leg_count - 1].end_time;
    const tdsp_status status = tdsp_verify_path(tdsp_solver_scene(solver), self->legs, self->leg_count, 1.0, arrival, &verdict);
    if (status == TDSP_OK) assert_int_equal(verdict.problems, 0);
    return answered(status, &verdict, sizeof verdict);
}

static void paths_without_memory_are_neither_cleared_nor_condemned(void **state)
{
    (void)state;
    tdsp_leg legs[LEGS];
    for (discs_kind kind = 0; kind < KINDS; kind++)
        for (int how = 0; how < 2; how++) {
            question margin = {kind, TDSP_METHOD_AUTO, (tdsp_raise)how, ask_path_margin, legs, 0}, verdict;
            tdsp_scene *scene;
            tdsp_solver *solver;
            double arrival;
            assert_int_equal(scene_make(kind, NULL, &scene), TDSP_OK);
            assert_int_equal(tdsp_solver_create(scene, &solver), TDSP_OK);
            assert_int_equal(tdsp_earliest_arrival(solver, 1.0, &arrival), TDSP_OK);
            assert_int_equal(tdsp_solver_path(solver, legs, LEGS, &margin.leg_count), TDSP_OK);
            verdict = margin;
            verdict.ask = ask_verdict;
            assert_true(refuse_each(ask_all, &margin, TDSP_OK) > 10);
            assert_true(refuse_each(ask_all, &verdict, TDSP_OK) > 10);
            tdsp_solver_free(solver);
            tdsp_scene_free(scene);
        }
}

static tdsp_status ask_jumps(tdsp_solver *solver, const question *self)
{
    tdsp_jumps *jumps = (tdsp_jumps *)&jumps;
    tdsp_shape_options options;
    (void)self;
    tdsp_shape_options_init(&options);
    options.until = 6.0;
    const tdsp_status status = tdsp_jumps_find(solver, &options, &jumps);
    if (status == TDSP_OK) {
        assert_true(tdsp_jumps_count(jumps) > 0);
        tdsp_jumps_free(jumps);
    } else
        assert_ptr_equal(jumps, &jumps);
    return status;
}

static tdsp_status ask_envelope(tdsp_solver *solver, const question *self)
{
    tdsp_envelope *envelope = (tdsp_envelope *)&envelope;
    tdsp_shape_options options;
    (void)self;
    tdsp_shape_options_init(&options);
    options.until = 6.0;
    const tdsp_status status = tdsp_envelope_find(solver, &options, &envelope);
    if (status == TDSP_OK) {
        assert_true(tdsp_envelope_pieces(envelope) > 1);
        tdsp_envelope_free(envelope);
    } else
        assert_ptr_equal(envelope, &envelope);
    return status;
}

static void jumps_and_pieces_without_memory_are_told(void **state)
{
    (void)state;
    refuse(ask_jumps, TDSP_OK);
    refuse(ask_envelope, TDSP_OK);
}

static tdsp_status ask_table(tdsp_solver *solver, const question *self)
{
    tdsp_oracle oracle;
    tdsp_build_options options;
    tdsp_table_verdict verdict;
    void *bytes;
    size_t length;
    (void)self;
    tdsp_build_options_init(&options);
    options.horizon = 8.0;
    options.epsilon = 0.05;
    assert_int_equal(tdsp_solver_oracle(solver, &oracle), TDSP_OK);
    tdsp_status status = tdsp_build(&oracle, &options, NULL, &bytes, &length, NULL);
    if (status != TDSP_OK) return status;
    tdsp_table table;
    poison(&verdict, sizeof verdict);
    assert_int_equal(tdsp_table_open(&table, bytes, length), TDSP_OK);
    status = answered(tdsp_verify_table(tdsp_solver_scene(solver), &table, &verdict), &verdict, sizeof verdict);
    tdsp_bytes_free(NULL, bytes, length);
    if (status == TDSP_OK) assert_int_equal(verdict.bad_paths + verdict.bad_order + verdict.bad_ratio, 0);
    return status;
}

static void a_table_is_built_and_verified_or_memory_is_told(void **state)
{
    (void)state;
    refuse(ask_table, TDSP_OK);
}

static tdsp_status ask_conformance(const tdsp_allocator *memory, void *ctx)
{
    tdsp_oracle_findings findings;
    tdsp_oracle_check_options options;
    tdsp_oracle_check_options_init(&options);
    options.departures = 10;
    poison(&findings, sizeof findings);
    return answered(tdsp_oracle_check(ctx, &options, memory, &findings), &findings, sizeof findings);
}

static void an_oracle_is_checked_or_memory_is_told(void **state)
{
    (void)state;
    toy t = toy_named("bend")->toy;
    t.legs = 1;
    tdsp_oracle oracle = toy_oracle(&t, 0);
    assert_true(refuse_each(ask_conformance, &oracle, TDSP_OK) > 2);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(answers_without_memory_are_told),
        cmocka_unit_test(many_answers_without_memory_are_told),
        cmocka_unit_test(deadlines_and_margins_without_memory_are_told),
        cmocka_unit_test(paths_without_memory_are_neither_cleared_nor_condemned),
        cmocka_unit_test(jumps_and_pieces_without_memory_are_told),
        cmocka_unit_test(a_table_is_built_and_verified_or_memory_is_told),
        cmocka_unit_test(an_oracle_is_checked_or_memory_is_told),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
