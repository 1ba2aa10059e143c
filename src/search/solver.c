/* SPDX-License-Identifier: MIT */
/* The public face of the engine: earliest arrivals, paths, counters, and the oracle. */
#include "search/solver.h"

#include <string.h>

#include "geom/tolerance.h"
#include "search/gap.h"
#include "search/general.h"
#include "search/reason.h"
#include "tdsp/growth.h"

/* Chunks of rides after which the oracle does without an exact answer, where it may. */
#define ORACLE_PATIENCE 20000u

/* The first method that applies. */
static tdsp_method method_for(const tdsp_scene *scene)
{
    if (!tdsp_scene_has_rates_only(scene)) return TDSP_METHOD_GENERAL;
    for (size_t i = 1; i < scene->count; ++i)
        if (scene->discs[i].growth != scene->discs[0].growth) return TDSP_METHOD_DIFFERENT_SPEEDS;
    return TDSP_METHOD_SAME_SPEED;
}

const char *tdsp_method_name(tdsp_method method)
{
    switch (method) {
    case TDSP_METHOD_AUTO: return "auto";
    case TDSP_METHOD_SAME_SPEED: return "same_speed";
    case TDSP_METHOD_DIFFERENT_SPEEDS: return "different_speeds";
    case TDSP_METHOD_GENERAL: return "general";
    }
    return "unknown";
}

tdsp_method tdsp_solver_method(const tdsp_solver *solver)
{
    return solver ? solver->method : TDSP_METHOD_AUTO;
}

tdsp_status tdsp_solver_create(const tdsp_scene *scene, tdsp_solver **out)
{
    return tdsp_solver_create_for(scene, TDSP_METHOD_AUTO, out);
}

static tdsp_status solver_prepare(tdsp_solver *solver)
{
    const tdsp_scene *scene = solver->scene;
    tdsp_status status = engine_create(&solver->engine, scene);
    if (status == TDSP_OK) status = relax_create(&solver->relaxation, scene);
    if (status == TDSP_OK && solver->method == TDSP_METHOD_GENERAL) status = growth_create(scene, &solver->growth);
    return status;
}

tdsp_status tdsp_solver_create_for(const tdsp_scene *scene, tdsp_method method, tdsp_solver **out)
{
    if (!scene || !out || (unsigned)method > TDSP_METHOD_GENERAL) return TDSP_INVALID_ARGUMENT;
    tdsp_method narrowest = method_for(scene);
    if (method == TDSP_METHOD_AUTO) method = narrowest;
    if (method < narrowest) return TDSP_NOT_SUPPORTED;
    tdsp_solver *solver = memory_array(&scene->allocator, 1, sizeof *solver);
    if (!solver) return TDSP_NO_MEMORY;
    memset(solver, 0, sizeof *solver);
    solver->scene = scene;
    solver->ends = scene->ends;
    solver->method = method;
    tdsp_status status = solver_prepare(solver);
    if (status != TDSP_OK) {
        tdsp_solver_free(solver);
        return status;
    }
    *out = solver;
    return TDSP_OK;
}

void tdsp_solver_free(tdsp_solver *solver)
{
    if (!solver) return;
    const tdsp_allocator *memory = &solver->scene->allocator;
    growth_free(solver->growth);
    engine_free(&solver->engine);
    relax_free(&solver->relaxation);
    enclosure_free(&solver->enclosure, memory);
    memory_free(memory, solver->path, solver->path_capacity * sizeof *solver->path);
    memory_free(memory, solver->gaps, solver->gap_capacity * sizeof *solver->gaps);
    memory_free(memory, solver, sizeof *solver);
}

const tdsp_scene *tdsp_solver_scene(const tdsp_solver *solver)
{
    return solver->scene;
}

/* From here on a double no longer tells the moments of one journey apart. */
#define FAR_AWAY 1099511627776.0 /* 2^40 */

/* ... and from here on the engine for changing rates, which counts time from 0 and not from the departure, no longer aims legs between small discs. */
#define FAR_AWAY_CHANGING 1048576.0 /* 2^20 */

int solver_is_far(const tdsp_solver *solver, double time)
{
    const tdsp_scene *scene = solver->scene;
    if (scene_is_too_wide(scene)) return 1;
    return !scene_is_still(scene) && time > (solver->growth ? FAR_AWAY_CHANGING : FAR_AWAY) * scene->time && !scene_covered(solver->ends.source_cover, time);
}

engine_question solver_forward_question(const tdsp_solver *solver, double departure)
{
    const tdsp_scene *scene = solver->scene;
    const scene_ends *ends = &solver->ends;
    double time = scene_is_still(scene) ? 0.0 : departure / scene->time; /* where nothing grows one time is as good as another */
    /* The last robot meets the disc that covers the destination: a touch. What is forgiven is told as the moment of the cover, so it is no more than arrivals are wrong by. */
    double until = ends->destination_cover.time / scene->time;
    until += GEOM_CONTACT * (1.0 + fabs(until - time)) + GEOM_TIME * fabs(until);
    engine_question question = {ENGINE_FORWARD, ends->source, ends->destination, time, -INFINITY, until,
                                until, 1.0, 0, 0, NULL, 0};
    return question;
}

double solver_time_of(const tdsp_solver *solver, double departure, double began, double time)
{
    double found = departure + (time - began) * solver->scene->time;
    return math_min(found, math_max(departure, solver->ends.destination_cover.time));
}

/* Where the scouts are lost the destination may be walled in; if it is not, relaxation has another try. */
static tdsp_status solver_scout(tdsp_solver *solver, engine_question *question)
{
    int lost;
    tdsp_status status = engine_scout(&solver->engine, question, &lost);
    if (status != TDSP_OK || !lost) return status;
    status = enclosure_test(&solver->enclosure, &solver->engine, &solver->ends, question->time, &solver->is_enclosed);
    return status == TDSP_OK && !solver->is_enclosed ? TDSP_NO_ANSWER : status;
}

static tdsp_status solver_run(tdsp_solver *solver, const disc_set *set, engine_question *question)
{
    int is_scouted = set == &solver->scene->all && solver->relaxation.stage == RELAX_SCOUTED;
    tdsp_status status = is_scouted ? solver_scout(solver, question) : TDSP_OK;
    if (set == &solver->scene->all) question->patience = solver->patience;
    return status == TDSP_OK && !solver->is_enclosed ? engine_run(&solver->engine, set, question) : status;
}

tdsp_status solver_forward(tdsp_solver *solver, const disc_set *set, double departure, double until, double *arrival)
{
    solver->engine.arrived = ENGINE_NONE;
    solver->is_enclosed = 0;
    if (scene_covered(solver->ends.source_cover, departure)) return TDSP_SOURCE_COVERED;
    if (ends_meet(&solver->ends)) {
        *arrival = departure;
        return TDSP_OK;
    }
    engine_question question = solver_forward_question(solver, departure);
    double latest = question.time + (until - departure) / solver->scene->time;
    question.limit = math_min(question.limit, latest + GEOM_CONTACT * fabs(latest));
    ++solver->work.forward_searches;
    tdsp_status status = solver_run(solver, set, &question);
    if (status != TDSP_OK) return status;
    if (solver->engine.arrived == ENGINE_NONE) return TDSP_CUT_OFF;
    *arrival = solver_time_of(solver, departure, question.time, engine_arrival(&solver->engine));
    return TDSP_OK;
}

/* A question for A(t). */
typedef struct arrival_question {
    tdsp_solver *solver;
    tdsp_solver_work before; /* the counters when it came in */
    double departure;
    double arrival;
    tdsp_status answer;
} arrival_question;

static tdsp_status ask_arrival(void *ctx, const disc_set *set)
{
    arrival_question *question = ctx;
    question->solver->work = question->before;
    question->answer = solver_forward(question->solver, set, question->departure, INFINITY, &question->arrival);
    return tdsp_status_is_answer(question->answer) ? TDSP_OK : question->answer;
}

tdsp_status solver_arrival(tdsp_solver *solver, double departure, double *arrival)
{
    arrival_question question = {solver, solver->work, departure, INFINITY, TDSP_OK};
    if (solver->growth) return general_arrival(solver, departure, arrival);
    solver->has_path = 0;
    tdsp_status status = relax_run(&solver->relaxation, &solver->engine, ask_arrival, &question);
    if (status != TDSP_OK) return status;
    if (question.answer == TDSP_OK) *arrival = question.arrival;
    return question.answer;
}

tdsp_status solver_conclude(tdsp_solver *solver, double departure, double arrival, tdsp_status answer)
{
    if (answer == TDSP_OK) return route_keep(solver, departure, arrival);
    if (answer != TDSP_CUT_OFF) return answer;
    tdsp_status reason, failure = reason_find(solver, departure, &reason);
    return failure == TDSP_OK ? reason : failure;
}

tdsp_status tdsp_earliest_arrival(tdsp_solver *solver, double departure, double *arrival)
{
    if (!solver || !arrival || !(departure >= 0.0) || isinf(departure)) return TDSP_INVALID_ARGUMENT;
    double found = INFINITY;
    if (solver_is_far(solver, departure)) return TDSP_NOT_SUPPORTED;
    tdsp_status status = solver_arrival(solver, departure, &found);
    status = solver_conclude(solver, departure, found, status);
    if (tdsp_status_is_answer(status)) *arrival = found;
    return status;
}

tdsp_status tdsp_solver_path(const tdsp_solver *solver, tdsp_leg *legs, size_t capacity, size_t *count)
{
    if (!solver || !count || (capacity && !legs)) return TDSP_INVALID_ARGUMENT;
    if (!solver->has_path) return TDSP_NO_ANSWER;
    *count = solver->path_count;
    if (capacity < solver->path_count) return TDSP_BUFFER_TOO_SMALL;
    if (solver->path_count) memcpy(legs, solver->path, solver->path_count * sizeof *legs);
    return TDSP_OK;
}

tdsp_status tdsp_solver_work_done(const tdsp_solver *solver, tdsp_solver_work *out)
{
    if (!solver || !out) return TDSP_INVALID_ARGUMENT;
    *out = solver->work;
    out->labels = solver->engine.open->taken;
    out->legs_tested = solver->engine.legs_tested;
    out->rounds = solver->relaxation.rounds;
    if (solver->growth) growth_add_work(solver->growth, out);
    out->bytes = sizeof *solver + engine_bytes(&solver->engine) + relax_bytes(&solver->relaxation) + set_bytes(&solver->enclosure.wall) + solver->path_capacity * sizeof *solver->path +
                 solver->gap_capacity * sizeof *solver->gaps;
    if (solver->growth) out->bytes += growth_bytes(solver->growth);
    return TDSP_OK;
}

static tdsp_status oracle_arrival(void *ctx, double departure, double *arrival)
{
    return tdsp_earliest_arrival(ctx, departure, arrival);
}

/*
 * An exact answer as long as that is cheap. How far the share asked for helps depends on the scene: across some hundred thousand discs the proof
 * costs a hundred times what finding costs, among crowds and fires nothing. An exact answer leaves a table fewer rows.
 */
static tdsp_status oracle_within(void *ctx, double departure, double delta, double *arrival, double *lower)
{
    tdsp_solver *solver = ctx;
    double found = INFINITY;
    if (solver_is_far(solver, departure)) return TDSP_NOT_SUPPORTED;
    solver->patience = ORACLE_PATIENCE;
    solver->engine.gave_up = 0;
    tdsp_status status = solver_arrival(solver, departure, &found);
    solver->patience = 0;
    int unknown = status == TDSP_CUT_OFF || (tdsp_status_is_answer(status) && solver->engine.gave_up);
    if (unknown) return tdsp_earliest_arrival_within(solver, departure, delta, arrival, lower);
    if (status == TDSP_OK) status = route_keep(solver, departure, found);
    if (tdsp_status_is_answer(status)) *arrival = *lower = found;
    return status;
}

static tdsp_status oracle_departure_between(void *ctx, double arrival, double after, double before, double *departure, double *arrives)
{
    return solver_departure_between(ctx, arrival, after, before, departure, arrives);
}

static tdsp_status oracle_departure(void *ctx, double arrival, double *departure)
{
    return tdsp_latest_departure(ctx, arrival, departure, NULL);
}

static tdsp_status oracle_path(void *ctx, tdsp_oracle_path *out)
{
    const tdsp_solver *solver = ctx;
    if (!solver->has_path) return TDSP_NO_ANSWER;
    memset(out, 0, sizeof *out);
    out->legs = solver->path;
    out->leg_count = solver->path_count;
    return TDSP_OK;
}

static tdsp_status oracle_last_reason(void *ctx, double departure, tdsp_status *reason)
{
    return solver_last_reason(ctx, departure, reason);
}

static tdsp_status oracle_jump_gap(void *ctx, double departure, double before, double after, tdsp_gap *out)
{
    (void)before;
    (void)after;
    return tdsp_solver_gap(ctx, departure, out);
}

tdsp_status tdsp_solver_oracle(tdsp_solver *solver, tdsp_oracle *out)
{
    if (!solver || !out) return TDSP_INVALID_ARGUMENT;
    tdsp_oracle_init(out);
    out->ctx = solver;
    out->monotone = TDSP_MONOTONE_TRAVEL;
    out->error = TDSP_SOLVER_ERROR;
    out->time_scale = solver->ends.time;
    out->earliest_arrival = oracle_arrival;
    out->latest_departure = oracle_departure;
    out->path = oracle_path;
    out->last_reason = oracle_last_reason;
    if (!solver->growth) out->earliest_arrival_within = oracle_within;
    out->latest_departure_between = oracle_departure_between;
    out->jump_gap = oracle_jump_gap;
    return TDSP_OK;
}
