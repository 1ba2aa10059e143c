/* SPDX-License-Identifier: MIT */
/*
 * Scenes, solvers and what asks them, without memory: each allocation fails in turn (support/scarce.h).
 *
 * A public function is a row of `calls` here or in the test beside it, or is named by NEEDS_NONE in test_no_memory_needed.c; tests/faults/check_calls.py
 * fails when one is neither.
 */
#include "support/cmocka_all.h"

#include "support/scarce.h"

static tdsp_status told_scene(tdsp_status status, tdsp_scene *scene, scarce_answer *a)
{
    if (LEFT(status, scene) != TDSP_OK) return status;
    scarce_tell_whole(a, tdsp_scene_hash(scene));
    scarce_tell(a, tdsp_scene_source_free_until(scene, NULL));
    tdsp_scene_free(scene);
    return TDSP_OK;
}

static tdsp_status call_scene_create(scarce *f, scarce_answer *a)
{
    size_t count;
    const tdsp_disc *given = scarce_discs(&count, f->kind);
    BLANKED(tdsp_scene *, scene);
    const tdsp_status status = tdsp_scene_create(&scarce_journey, given, count, &f->memory, &scene);
    return told_scene(status, scene, a);
}

static void logistic(void *ctx, double time, double *radius, double *rate)
{
    (void)ctx;
    *radius = 1.0 + 2.0 / (1.0 + exp(5.0 - time));
    *rate = 2.0 * exp(5.0 - time) / ((1.0 + exp(5.0 - time)) * (1.0 + exp(5.0 - time)));
}

static tdsp_status call_scene_create_growing(scarce *f, scarce_answer *a)
{
    const tdsp_growing_disc three[3] = {
        scarce_bent[0], scarce_bent[1], {{3.0, 8.0}, 1.0 + 2.0 / (1.0 + exp(5.0)), {.kind = TDSP_GROWTH_LAW, .law = logistic, .until = 40.0}}};
    BLANKED(tdsp_scene *, scene);
    const tdsp_status status = tdsp_scene_create_growing(&scarce_journey, three, f->kind == SCARCE_GATE ? 2 : 3, &f->memory, &scene);
    return told_scene(status, scene, a);
}

static tdsp_status call_scene_raise(scarce *f, scarce_answer *a)
{
    BLANKED(tdsp_scene *, scene);
    const tdsp_status status = tdsp_scene_raise(f->scene, TDSP_RAISE_FACTOR, 1.25, &scene);
    return told_scene(status, scene, a);
}

static tdsp_status told_solver(tdsp_status status, tdsp_solver *solver, scarce_answer *a)
{
    if (LEFT(status, solver) != TDSP_OK) return status;
    scarce_tell(a, tdsp_solver_method(solver));
    tdsp_solver_free(solver);
    return TDSP_OK;
}

static tdsp_status call_solver_create(scarce *f, scarce_answer *a)
{
    BLANKED(tdsp_solver *, solver);
    const tdsp_status status = tdsp_solver_create(f->scene, &solver);
    return told_solver(status, solver, a);
}

static tdsp_status call_solver_create_for(scarce *f, scarce_answer *a)
{
    BLANKED(tdsp_solver *, solver);
    const tdsp_status status = tdsp_solver_create_for(f->scene, TDSP_METHOD_GENERAL, &solver);
    return told_solver(status, solver, a);
}

typedef struct numbers {
    double first;
    double second;
} numbers;

static tdsp_status told_numbers(tdsp_status status, const numbers *n, const scarce *f, scarce_answer *a)
{
    if (LEFT(status, *n) != TDSP_OK) return status;
    scarce_tell(a, n->first);
    scarce_tell(a, n->second);
    scarce_tell_path(a, f->solver);
    return TDSP_OK;
}

static tdsp_status call_earliest_arrival(scarce *f, scarce_answer *a)
{
    BLANKED(numbers, n);
    return told_numbers(tdsp_earliest_arrival(f->solver, 1.0, &n.first), &n, f, a);
}

static tdsp_status call_earliest_arrival_within(scarce *f, scarce_answer *a)
{
    BLANKED(numbers, n);
    return told_numbers(tdsp_earliest_arrival_within(f->solver, 1.0, 0.05, &n.first, &n.second), &n, f, a);
}

static tdsp_status call_earliest_arrival_for(scarce *f, scarce_answer *a)
{
    BLANKED(numbers, n);
    return told_numbers(tdsp_earliest_arrival_for(f->solver, &scarce_aside, 1.0, &n.first), &n, f, a);
}

static tdsp_status call_latest_departure(scarce *f, scarce_answer *a)
{
    BLANKED(numbers, n);
    return told_numbers(tdsp_latest_departure(f->solver, 33.0, &n.first, &n.second), &n, f, a);
}

static tdsp_status call_latest_departure_for(scarce *f, scarce_answer *a)
{
    BLANKED(numbers, n);
    return told_numbers(tdsp_latest_departure_for(f->solver, &scarce_aside, 33.0, &n.first, &n.second), &n, f, a);
}

static const tdsp_point places[3] = {{-9.0, 1.0}, {9.0, -1.0}, {0.0, 9.5}};

static tdsp_status call_earliest_arrivals(scarce *f, scarce_answer *a)
{
    struct {
        double arrivals[3];
        tdsp_status statuses[3];
    } out;
    memset(&out, SCARCE_BLANK, sizeof out);
    const tdsp_status status = tdsp_earliest_arrivals(f->solver, scarce_journey.source, 1.0, places, 3, out.arrivals, out.statuses);
    if (LEFT(status, out) != TDSP_OK) return status;
    for (int i = 0; i < 3; ++i) {
        scarce_tell(a, out.arrivals[i]);
        scarce_tell(a, out.statuses[i]);
    }
    return TDSP_OK;
}

static tdsp_status call_latest_departures(scarce *f, scarce_answer *a)
{
    struct {
        double departures[3];
        double arrives[3];
        tdsp_status statuses[3];
    } out;
    memset(&out, SCARCE_BLANK, sizeof out);
    const tdsp_status status =
        tdsp_latest_departures(f->solver, places, 3, scarce_journey.destination, 33.0, out.departures, out.arrives, out.statuses);
    if (LEFT(status, out) != TDSP_OK) return status;
    for (int i = 0; i < 3; ++i) {
        scarce_tell(a, out.departures[i]);
        scarce_tell(a, out.arrives[i]);
        scarce_tell(a, out.statuses[i]);
    }
    return TDSP_OK;
}

static tdsp_status call_last_departure(scarce *f, scarce_answer *a)
{
    BLANKED(tdsp_last_departure, last);
    const tdsp_status status = tdsp_solver_last_departure(f->solver, &last);
    if (LEFT(status, last) != TDSP_OK) return status;
    scarce_tell(a, last.departure);
    scarce_tell(a, last.arrival);
    scarce_tell(a, last.reason);
    scarce_tell(a, last.time);
    return TDSP_OK;
}

static tdsp_status call_gap(scarce *f, scarce_answer *a)
{
    BLANKED(tdsp_gap, gap);
    BLANKED(numbers, n);
    tdsp_status status = tdsp_latest_departure(f->solver, 33.0, &n.first, &n.second);
    if (status != TDSP_OK) return status;
    status = tdsp_solver_gap(f->solver, n.first, &gap);
    if (status == TDSP_NO_ANSWER || LEFT(status, gap) != TDSP_OK) return status;
    scarce_tell(a, gap.first);
    scarce_tell(a, gap.time);
    return TDSP_OK;
}

static void tell_witness(scarce_answer *a, const tdsp_witness *witness)
{
    scarce_tell(a, witness->limit);
    scarce_tell(a, witness->disc);
    scarce_tell(a, witness->time);
    scarce_tell(a, witness->place.x);
}

static tdsp_status call_deadline(scarce *f, scarce_answer *a)
{
    BLANKED(tdsp_deadline_answer, out);
    const tdsp_status status = tdsp_solver_deadline(f->solver, 33.0, &out);
    if (LEFT(status, out) != TDSP_OK) return status;
    scarce_tell(a, out.departure);
    tell_witness(a, &out.witness);
    scarce_tell(a, out.after);
    return TDSP_OK;
}

static tdsp_status call_slack(scarce *f, scarce_answer *a)
{
    BLANKED(tdsp_slack, out);
    const tdsp_status status = tdsp_solver_slack(f->solver, 1.0, 33.0, &out);
    if (LEFT(status, out) != TDSP_OK) return status;
    scarce_tell(a, out.early);
    scarce_tell(a, out.later);
    tell_witness(a, &out.latest.witness);
    return TDSP_OK;
}

static tdsp_status told_margin(tdsp_status status, const tdsp_margin *m, scarce_answer *a)
{
    if (LEFT(status, *m) != TDSP_OK) return status;
    scarce_tell(a, m->most);
    scarce_tell(a, m->arrival);
    tell_witness(a, &m->witness);
    return TDSP_OK;
}

static tdsp_status call_departure_margin(scarce *f, scarce_answer *a)
{
    BLANKED(tdsp_margin, m);
    return told_margin(tdsp_departure_margin(f->scene, TDSP_RAISE_FACTOR, 1.0, 33.0, &m), &m, a);
}

static tdsp_status call_path_margin(scarce *f, scarce_answer *a)
{
    const scarce_made *m = scarce_made_of(f->kind);
    BLANKED(tdsp_margin, margin);
    return told_margin(tdsp_path_margin(f->scene, TDSP_RAISE_FACTOR, m->legs, m->leg_count, 1.0, &margin), &margin, a);
}

static tdsp_status call_jumps(scarce *f, scarce_answer *a)
{
    BLANKED(tdsp_jumps *, jumps);
    const tdsp_status status = tdsp_jumps_find(f->solver, NULL, &jumps);
    if (LEFT(status, jumps) != TDSP_OK) return status;
    for (size_t i = 0; i < tdsp_jumps_count(jumps); ++i) {
        tdsp_arrival_jump jump;
        assert_int_equal(tdsp_jumps_get(jumps, i, &jump), TDSP_OK);
        scarce_tell(a, jump.departure);
        scarce_tell(a, jump.size);
    }
    tdsp_jumps_free(jumps);
    return TDSP_OK;
}

static tdsp_status call_envelope(scarce *f, scarce_answer *a)
{
    tdsp_shape_options options;
    tdsp_shape_options_init(&options);
    options.resolution = 5.0;
    options.until = 20.0;
    BLANKED(tdsp_envelope *, envelope);
    const tdsp_status status = tdsp_envelope_find(f->solver, &options, &envelope);
    if (LEFT(status, envelope) != TDSP_OK) return status;
    for (size_t i = 0; i < tdsp_envelope_pieces(envelope); ++i) {
        tdsp_piece piece;
        assert_int_equal(tdsp_envelope_piece(envelope, i, &piece), TDSP_OK);
        scarce_tell(a, piece.until);
        scarce_tell(a, (double)piece.form);
    }
    tdsp_envelope_free(envelope);
    return TDSP_OK;
}

static const scarce_call calls[] = {
    {"tdsp_scene_create", call_scene_create},
    {"tdsp_scene_create_growing", call_scene_create_growing},
    {"tdsp_scene_raise", call_scene_raise},
    {"tdsp_solver_create", call_solver_create},
    {"tdsp_solver_create_for", call_solver_create_for},
    {"tdsp_earliest_arrival", call_earliest_arrival},
    {"tdsp_earliest_arrival_within", call_earliest_arrival_within},
    {"tdsp_earliest_arrival_for", call_earliest_arrival_for},
    {"tdsp_latest_departure", call_latest_departure},
    {"tdsp_latest_departure_for", call_latest_departure_for},
    {"tdsp_earliest_arrivals", call_earliest_arrivals},
    {"tdsp_latest_departures", call_latest_departures},
    {"tdsp_solver_last_departure", call_last_departure},
    {"tdsp_solver_gap", call_gap},
    {"tdsp_solver_deadline", call_deadline},
    {"tdsp_solver_slack", call_slack},
    {"tdsp_departure_margin", call_departure_margin},
    {"tdsp_path_margin", call_path_margin},
    {"tdsp_jumps_find", call_jumps},
    {"tdsp_envelope_find", call_envelope},
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
