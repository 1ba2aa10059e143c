/* SPDX-License-Identifier: MIT */
/*
 * Arrivals within a share of the best.
 *
 * A search whose bounds weigh w = 1 + delta takes labels in the order of time + w * bound. When it takes a leg to the goal that arrives at U, every
 * label still open has time + w * bound >= U, and whatever is yet to be found comes from one of them, no earlier than its time + bound. So
 * the least of these is a lower bound on A(t), and U - t <= w * (A(t) - t). Few discs alone, searched exactly, bound A(t) as well.
 */
#include "search/solver.h"

/* A search that weighs little looks at more than one path across: it has so many times a scout's patience. */
#define PATIENCE 8u

typedef struct within_question {
    tdsp_solver *solver;
    tdsp_solver_work before; /* the counters when it came in */
    double departure;
    double delta;
    double arrival;
    double lower;
    tdsp_status answer;
} within_question;

/* Among all discs: with some patience first. */
static tdsp_status run_weighted(tdsp_solver *solver, engine_question *question)
{
    disc_engine *engine = &solver->engine;
    int is_brief = solver->relaxation.stage == RELAX_SCOUTED;
    question->patience = is_brief ? PATIENCE * engine_patience(engine) : 0;
    tdsp_status status = engine_run(engine, &solver->scene->all, question);
    if (status != TDSP_OK || !engine->gave_up) return status;
    status = enclosure_test(&solver->enclosure, engine, &solver->ends, question->time, &solver->is_enclosed);
    return status == TDSP_OK && !solver->is_enclosed ? TDSP_NO_ANSWER : status;
}

static tdsp_status ask_within(void *ctx, const disc_set *set)
{
    within_question *self = ctx;
    tdsp_solver *solver = self->solver;
    solver->work = self->before;
    if (set != &solver->scene->all || scene_covered(solver->ends.source_cover, self->departure) || ends_meet(&solver->ends)) {
        self->answer = solver_forward(solver, set, self->departure, INFINITY, &self->arrival);
        if (self->answer == TDSP_OK) self->lower = math_max(self->lower, self->arrival);
        return tdsp_status_is_answer(self->answer) ? TDSP_OK : self->answer;
    }
    engine_question question = solver_forward_question(solver, self->departure);
    question.weight = 1.0 + self->delta;
    solver->is_enclosed = 0;
    ++solver->work.forward_searches;
    tdsp_status status = run_weighted(solver, &question);
    if (status != TDSP_OK) return status;
    self->answer = solver->engine.arrived == ENGINE_NONE ? TDSP_CUT_OFF : TDSP_OK;
    if (self->answer != TDSP_OK) return TDSP_OK;
    self->arrival = solver_time_of(solver, self->departure, question.time, engine_arrival(&solver->engine));
    self->lower = math_max(self->lower, solver_time_of(solver, self->departure, question.time, engine_lower_bound(&solver->engine)));
    return TDSP_OK;
}

tdsp_status tdsp_earliest_arrival_within(tdsp_solver *solver, double departure, double delta, double *arrival, double *lower)
{
    if (!solver || !arrival || !lower || !(departure >= 0.0) || isinf(departure) || !(delta >= 0.0 && delta <= 1.0))
        return TDSP_INVALID_ARGUMENT;
    if (solver->growth) { /* whose answers are all exact */
        tdsp_status exact = tdsp_earliest_arrival(solver, departure, arrival);
        if (tdsp_status_is_answer(exact)) *lower = *arrival;
        return exact;
    }
    if (solver_is_far(solver, departure)) return TDSP_NOT_SUPPORTED;
    within_question question = {solver, solver->work, departure, delta, INFINITY, departure, TDSP_OK};
    solver->has_path = 0;
    tdsp_status status = relax_run(&solver->relaxation, &solver->engine, ask_within, &question);
    if (status != TDSP_OK) return status;
    status = solver_conclude(solver, departure, question.arrival, question.answer);
    if (!tdsp_status_is_answer(status)) return status;
    *arrival = status == TDSP_OK ? question.arrival : INFINITY;
    *lower = status == TDSP_OK ? math_min(question.lower, question.arrival) : INFINITY;
    return status;
}
