/* SPDX-License-Identifier: MIT */
/*
 * One source and many destinations, or many sources and one destination, in one search.
 *
 * A search in the order of time settles every place on its way, whatever it looks for. So one search forwards from the source answers all
 * destinations, and one search backwards from the destination at `a` tells for each source the last departure from which a path arrives exactly at a.
 * Where A is continuous that is the answer, and A at it is a; otherwise the source is asked about alone.
 *
 * Such a search floods the discs as far as the farthest place, while a question alone looks only at what its path meets (relax.h). So places are asked about
 * alone as long as what that cost so far does not show that sharing pays for the others.
 */
#include "search/reason.h"

/* So many are asked about alone at least. */
#define SAMPLES 4u

/* A flood costs as much as following so many chunks of rides alone, for each disc that it reaches. Measured: docs/math/search.md, 7.10. */
#define FLOOD 14.0

/* ... and for backward questions, which share about half of their work, so many times as much. */
#define FLOOD_BACK 2.0

#define NO_GOAL 0xffffffffu

typedef struct many_place {
    scene_ends ends;
    int is_known;
    uint32_t goal;  /* of the flood, or NO_GOAL */
    tdsp_status status;
    double time;    /* the answer ... */
    double arrives; /* ... and A there, backwards */
} many_place;

typedef struct many_question {
    tdsp_solver *solver;
    engine_direction direction;
    double time; /* departure or arrival */
    int explain; /* say why there is no way */
    many_place *places;
    engine_goal *goals;
    size_t count;
    uint32_t goal_count;
    double discs_met; /* by a flood */
} many_question;

/* The places, where the other end is one and the same. */
static tdsp_status many_begin(many_question *self, const tdsp_point *places, size_t count, tdsp_point other)
{
    const tdsp_scene *scene = self->solver->scene;
    self->count = count;
    self->places = memory_array(&scene->allocator, count, sizeof *self->places);
    self->goals = memory_array(&scene->allocator, count, sizeof *self->goals);
    tdsp_status status = self->places && self->goals ? TDSP_OK : TDSP_NO_MEMORY;
    for (size_t k = 0; k < count && status == TDSP_OK; ++k) {
        const tdsp_ends forwards = {other, places[k]}, backwards = {places[k], other};
        self->places[k].is_known = 0;
        self->places[k].goal = NO_GOAL;
        status = scene_ends_make(scene, self->direction == ENGINE_FORWARD ? &forwards : &backwards, &self->places[k].ends);
    }
    return status;
}

static void many_free(many_question *self)
{
    const tdsp_allocator *memory = &self->solver->scene->allocator;
    memory_free(memory, self->places, self->count * sizeof *self->places);
    memory_free(memory, self->goals, self->count * sizeof *self->goals);
}

static tdsp_status many_learn(many_place *place, tdsp_status status)
{
    place->status = status;
    place->is_known = 1;
    return tdsp_status_is_answer(status) ? TDSP_OK : status;
}

static tdsp_status many_ask_alone(many_question *self, many_place *place)
{
    tdsp_solver *solver = self->solver;
    solver->ends = place->ends;
    if (self->direction == ENGINE_FORWARD) return many_learn(place, tdsp_earliest_arrival(solver, self->time, &place->time));
    return many_learn(place, tdsp_latest_departure(solver, self->time, &place->time, &place->arrives));
}

static int count_disc(void *ctx, uint32_t disc)
{
    (void)disc;
    ++*(double *)ctx;
    return 1;
}

/* How many discs a flood as far as the farthest unknown place meets. */
static double many_discs_met(const many_question *self)
{
    const disc_set *all = &self->solver->scene->all;
    const scene_ends *any = &self->places[0].ends;
    const index_view view = {&all->index, all->forward, 1.0};
    double farthest = 0.0, met = 0.0;
    for (size_t k = 0; k < self->count; ++k) {
        const scene_ends *ends = &self->places[k].ends;
        farthest = math_max(farthest, point_distance(ends->source, ends->destination));
    }
    index_near(&view, self->direction == ENGINE_FORWARD ? any->source : any->destination, farthest, 0.0, count_disc, &met);
    return met;
}

/* Does sharing pay for the others, when `known` places cost so many chunks? */
static int many_pays(const many_question *self, size_t known, uint64_t chunks)
{
    if (known < SAMPLES || known >= self->count || self->count >= ENGINE_GOAL || self->solver->growth) return 0;
    double alone = (double)chunks / (double)known * (double)(self->count - known);
    return alone > FLOOD * (self->direction == ENGINE_FORWARD ? 1.0 : FLOOD_BACK) * self->discs_met;
}

/* Places at the other end itself, covered ones and those too far away are no goals: they are asked about alone, which is quick. */
static void many_add_goal(many_question *self, many_place *place)
{
    tdsp_solver *solver = self->solver;
    const scene_ends *ends = &place->ends;
    solver->ends = *ends;
    if (place->is_known || ends_meet(ends) || scene_covered(ends->source_cover, 0.0) || scene_covered(ends->destination_cover, 0.0)) return;
    if (solver_is_far(solver, self->time)) return;
    engine_goal goal = {ends->destination, -INFINITY, 0.0, INFINITY, GOALS_NONE, 0};
    if (self->direction == ENGINE_FORWARD) {
        goal.until = solver_forward_question(solver, self->time).goal_until;
    } else {
        goal.place = ends->source;
        goal.opens = -ends->source_cover.time / solver->scene->time;
    }
    place->goal = self->goal_count;
    self->goals[self->goal_count++] = goal;
}

static tdsp_status many_flood(many_question *self, const engine_question *question)
{
    tdsp_solver *solver = self->solver;
    if (self->direction == ENGINE_FORWARD) ++solver->work.forward_searches;
    if (self->direction == ENGINE_REVERSE) ++solver->work.reverse_searches;
    return engine_run_many(&solver->engine, &solver->scene->all, question, self->goals, self->goal_count);
}

static tdsp_status arrivals_share(many_question *self)
{
    tdsp_solver *solver = self->solver;
    engine_question question = solver_forward_question(solver, self->time);
    question.limit = INFINITY;
    tdsp_status status = scene_covered(solver->ends.source_cover, self->time) ? TDSP_OK : many_flood(self, &question);
    if (scene_covered(solver->ends.source_cover, self->time)) return status;
    for (size_t k = 0; k < self->count && status == TDSP_OK; ++k) {
        many_place *place = &self->places[k];
        if (place->goal == NO_GOAL) continue;
        const engine_goal *goal = &self->goals[place->goal];
        solver->ends = place->ends;
        if (goal->leg != GOALS_NONE) place->time = solver_time_of(solver, self->time, question.time, goal->best);
        if (goal->leg != GOALS_NONE || !self->explain) many_learn(place, goal->leg == GOALS_NONE ? TDSP_CUT_OFF : TDSP_OK);
    }
    return status;
}

/* As far as the destination is free. */
static tdsp_status departures_share(many_question *self)
{
    tdsp_solver *solver = self->solver;
    double unit = solver->scene->time, last = math_min(self->time, solver->ends.destination_cover.time);
    if (scene_is_still(solver->scene) || isinf(last)) return TDSP_OK;
    engine_question question = solver_reverse_question(solver, last / unit, 0.0);
    tdsp_status status = many_flood(self, &question);
    for (size_t k = 0; k < self->count && status == TDSP_OK; ++k) {
        many_place *place = &self->places[k];
        if (place->goal == NO_GOAL) continue;
        solver->ends = place->ends;
        double candidate = -self->goals[place->goal].best * unit;
        status = many_learn(place, solver_departure_at(solver, self->time, candidate, &place->time, &place->arrives));
    }
    return status;
}

static tdsp_status many_share(many_question *self)
{
    for (size_t k = 0; k < self->count; ++k) many_add_goal(self, &self->places[k]);
    if (self->goal_count == 0) return TDSP_OK;
    return self->direction == ENGINE_FORWARD ? arrivals_share(self) : departures_share(self);
}

/* One after the other, in steps that spread the first ones over the list, until sharing pays. */
static tdsp_status many_answer(many_question *self)
{
    const disc_engine *engine = &self->solver->engine;
    const uint64_t before = engine->chunks_followed;
    size_t known = 0, step = self->count / SAMPLES + 1;
    int is_shared = 0;
    tdsp_status status = TDSP_OK;
    self->discs_met = many_discs_met(self);
    for (size_t first = 0; first < step; ++first) {
        for (size_t k = first; k < self->count && status == TDSP_OK; k += step) {
            if (!is_shared && many_pays(self, known, engine->chunks_followed - before)) {
                is_shared = 1;
                status = many_share(self);
            }
            if (status == TDSP_OK && !self->places[k].is_known) status = many_ask_alone(self, &self->places[k]);
            ++known;
        }
    }
    return status;
}

static void many_hand_out(const many_question *self, double *times, double *arrives, tdsp_status *statuses)
{
    for (size_t k = 0; k < self->count; ++k) {
        const many_place *place = &self->places[k];
        int found = place->status == TDSP_OK;
        times[k] = found ? place->time : INFINITY;
        if (arrives) arrives[k] = found ? place->arrives : INFINITY;
        if (statuses) statuses[k] = place->status;
    }
}

/* The whole of it; the solver keeps its own ends. */
static tdsp_status many_run(many_question *self, const tdsp_point *places, size_t count, tdsp_point other, double *times, double *arrives,
                            tdsp_status *statuses)
{
    if (count == 0) return TDSP_OK;
    const scene_ends before = self->solver->ends;
    tdsp_status status = many_begin(self, places, count, other);
    if (status == TDSP_OK) status = many_answer(self);
    if (status == TDSP_OK) many_hand_out(self, times, arrives, statuses);
    many_free(self);
    self->solver->ends = before;
    self->solver->has_path = 0;
    return status;
}

tdsp_status tdsp_earliest_arrivals(tdsp_solver *solver, tdsp_point source, double departure, const tdsp_point *destinations, size_t count,
                                   double *arrivals, tdsp_status *statuses)
{
    if (!solver || (count && (!destinations || !arrivals)) || !(departure >= 0.0) || isinf(departure)) return TDSP_INVALID_ARGUMENT;
    many_question question = {solver, ENGINE_FORWARD, departure, statuses != NULL, NULL, NULL, 0, 0, 0.0};
    return many_run(&question, destinations, count, source, arrivals, NULL, statuses);
}

tdsp_status tdsp_latest_departures(tdsp_solver *solver, const tdsp_point *sources, size_t count, tdsp_point destination, double arrival,
                                   double *departures, double *arrives, tdsp_status *statuses)
{
    if (!solver || (count && (!sources || !departures)) || !(arrival >= 0.0)) return TDSP_INVALID_ARGUMENT;
    many_question question = {solver, ENGINE_REVERSE, arrival, 1, NULL, NULL, 0, 0, 0.0};
    return many_run(&question, sources, count, destination, departures, arrives, statuses);
}
