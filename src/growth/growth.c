/* SPDX-License-Identifier: MIT */
/* Questions, by relaxation. */
#include "growth/growth.h"

#include <string.h>

#include "geom/tolerance.h"
#include "growth/ride.h"
#include "tdsp/growth.h"

/* Scenes of so few discs are searched whole. */
#define SMALL 6u

/* When a path has met more than this share of the discs, or has been mended so often, the whole is searched. */
#define LARGE_SHARE 3u
#define ROUNDS 64

/* More members than this are worth a scout, with bounds so heavy. */
#define SCOUTED 24u
#define SCOUT_WEIGHT 1.1

/* A scout looks for an arrival so much later than the last one known, or the straight way; then twice as late, and so on up to this many times, then as late as may be. */
#define LATER 1.25
#define LATEST 8.0

static geom_law plain_law(const tdsp_disc *disc, law_piece *piece)
{
    law_piece plain = {0.0, {disc->radius, disc->growth}, 1};
    geom_law law = {piece, 1};
    *piece = plain;
    return law;
}

static tdsp_status make_shapes(growth_solver *self)
{
    const tdsp_scene *scene = self->scene;
    growth_engine *engine = &self->engine;
    shape_units units = {scene->origin, scene->length, scene->time, scene->journey.radius};
    tdsp_status status = TDSP_OK;
    for (uint32_t i = 0; i < scene->count && status == TDSP_OK; ++i) {
        law_piece piece;
        geom_law law = tdsp_scene_has_rates_only(scene) ? plain_law(&scene->discs[i], &piece) : scene_law(scene, i);
        ++engine->shape_count;
        status = shape_make(&engine->shapes[i], &engine->allocator, scene->discs[i].center, law, units);
    }
    return status;
}

static tdsp_status growth_prepare(growth_solver *self)
{
    growth_engine *engine = &self->engine;
    size_t count = self->scene->count;
    tdsp_status status = tdsp_search_create(&engine->allocator, &engine->open);
    if (status != TDSP_OK || count == 0) return status;
    engine->shapes = memory_array(&engine->allocator, count, sizeof *engine->shapes);
    engine->members = memory_array(&engine->allocator, count, sizeof *engine->members);
    engine->heads = memory_array(&engine->allocator, count, sizeof *engine->heads);
    self->is_member = memory_array(&engine->allocator, count, 1);
    if (!engine->shapes || !engine->members || !engine->heads || !self->is_member) return TDSP_NO_MEMORY;
    memset(self->is_member, 0, count);
    return make_shapes(self);
}

tdsp_status growth_create(const tdsp_scene *scene, growth_solver **out)
{
    growth_solver *self = memory_array(&scene->allocator, 1, sizeof *self);
    if (!self) return TDSP_NO_MEMORY;
    memset(self, 0, sizeof *self);
    self->scene = scene;
    self->engine.allocator = scene->allocator;
    tdsp_status status = growth_prepare(self);
    if (status != TDSP_OK) {
        growth_free(self);
        return status;
    }
    *out = self;
    return TDSP_OK;
}

void growth_free(growth_solver *self)
{
    if (!self) return;
    growth_engine *engine = &self->engine;
    tdsp_allocator memory = engine->allocator;
    size_t count = self->scene->count;
    for (uint32_t i = 0; i < engine->shape_count; ++i) shape_free(&engine->shapes[i], &memory);
    memory_free(&memory, engine->shapes, count * sizeof *engine->shapes);
    memory_free(&memory, engine->members, count * sizeof *engine->members);
    memory_free(&memory, engine->heads, count * sizeof *engine->heads);
    memory_free(&memory, self->is_member, count);
    memory_free(&memory, engine->legs, engine->leg_capacity * sizeof *engine->legs);
    memory_free(&memory, engine->rides, engine->ride_capacity * sizeof *engine->rides);
    memory_free(&memory, engine->ahead, engine->ahead_capacity * sizeof *engine->ahead);
    reach_free(&engine->reach, &memory);
    tdsp_search_free(engine->open);
    memory_free(&memory, self, sizeof *self);
}

uint64_t growth_bytes(const growth_solver *self)
{
    const growth_engine *engine = &self->engine;
    uint64_t bytes = sizeof *self + engine->leg_capacity * sizeof *engine->legs + engine->ride_capacity * sizeof *engine->rides + engine->ahead_capacity * sizeof *engine->ahead;
    bytes += self->scene->count * (1 + sizeof *engine->shapes + sizeof *engine->members + sizeof *engine->heads);
    bytes += reach_bytes(&engine->reach);
    for (uint32_t i = 0; i < engine->shape_count; ++i) bytes += shape_bytes(&engine->shapes[i]);
    return bytes;
}

void growth_add_work(const growth_solver *self, tdsp_solver_work *work)
{
    work->labels += self->engine.labels;
    work->legs_tested += self->engine.legs_tested;
    work->rounds += self->rounds;
}

static void member_add(growth_solver *self, uint32_t disc)
{
    if (self->is_member[disc]) return;
    self->is_member[disc] = 1;
    self->engine.members[self->engine.member_count++] = disc;
}

static void members_clear(growth_solver *self)
{
    while (self->engine.member_count > 0) self->is_member[self->engine.members[--self->engine.member_count]] = 0;
}

static void members_all(growth_solver *self)
{
    for (uint32_t i = 0; i < self->engine.shape_count; ++i) member_add(self, i);
}

static void mend_leg(growth_solver *self, const growth_leg *leg)
{
    const growth_engine *engine = &self->engine;
    double hit;
    for (uint32_t i = 0; i < engine->shape_count; ++i)
        if (!self->is_member[i] && sight_is_blocked(&engine->shapes[i], engine->question.sign, &leg->line, leg->arrive, SHAPE_NONE, SHAPE_NONE, &hit))
            member_add(self, i);
}

/* Is this moment of a ride past another? */
static int is_past(double sign, const growth_moment *moment, const growth_moment *end)
{
    if (moment->span != end->span) return sign > 0.0 ? moment->span > end->span : moment->span < end->span;
    if (moment->in_fan != end->in_fan) return moment->in_fan;
    return moment->in_fan ? moment->theta >= end->theta : moment->time >= end->time;
}

static void mend_chunk(growth_solver *self, const growth_chunk *chunk)
{
    const growth_engine *engine = &self->engine;
    for (uint32_t i = 0; i < engine->shape_count; ++i) {
        if (!self->is_member[i] && ride_meets(chunk, &engine->shapes[i]).is_stopped) member_add(self, i);
    }
}

/* Along the ride, chunk by chunk, up to where the path leaves it. */
static void mend_ride(growth_solver *self, const growth_ride *ride, const growth_moment *leave)
{
    const growth_engine *engine = &self->engine;
    const growth_shape *shape = engine_shape(engine, ride->disc);
    growth_ride again = *ride;
    growth_chunk chunk;
    again.now = ride->start;
    again.is_over = 0;
    while (!again.is_over && !is_past(engine->question.sign, &again.now, leave) && rider_next_chunk(shape, engine->question.sign, &again, &chunk)) {
        if (!chunk.base.in_fan && chunk.base.span == leave->span) chunk.to = math_min(chunk.to, leave->time);
        mend_chunk(self, &chunk);
        again.now = rider_after(&chunk, &again.is_over);
    }
}

/* Add all discs that the path found runs into; returns how many were new. */
static uint32_t path_mend(growth_solver *self)
{
    const growth_engine *engine = &self->engine;
    uint32_t before = engine->member_count, at = engine->arrived;
    while (at != GROWTH_NONE) {
        const growth_leg *leg = &engine->legs[at];
        mend_leg(self, leg);
        if (leg->ride == GROWTH_NONE) break;
        mend_ride(self, &engine->rides[leg->ride], &leg->leave);
        at = engine->rides[leg->ride].leg;
    }
    return engine->member_count - before;
}

/*
 * A search with heavier bounds. The sooner it may stop looking the less it meets, so it looks for soon arrivals first.
 */
static tdsp_status scout(growth_solver *self, const growth_question *question, double known)
{
    growth_question ask = *question;
    double straight = point_distance(question->start, question->goal), later = LATER * math_max(straight, known - question->time);
    ask.weight = SCOUT_WEIGHT;
    for (;; later *= 2.0) {
        ask.limit = later > LATEST * straight ? question->limit : math_min(question->time + later, question->limit);
        tdsp_status status = growth_run(&self->engine, &ask);
        if (status != TDSP_OK || self->engine.arrived != GROWTH_NONE || ask.limit == question->limit) return status;
    }
}

/* Among the members: where they are many, a scout goes ahead, whose path keeps the search for the best from looking where it cannot be. An arrival is known among fewer. */
static tdsp_status run(growth_solver *self, const growth_question *question, double known)
{
    growth_question ask = *question;
    if (self->engine.member_count > SCOUTED) {
        tdsp_status status = scout(self, question, known);
        if (status != TDSP_OK || self->engine.arrived == GROWTH_NONE) return status;
        double arrives = self->engine.legs[self->engine.arrived].arrive;
        ask.limit = math_min(ask.limit, arrives + GEOM_CONTACT * (1.0 + fabs(arrives)));
    }
    return growth_run(&self->engine, &ask);
}

/* Where there is no way among fewer discs there is none among all; but backwards in time nobody waits until the source is free, and among fewer a way may be too short for that. */
static tdsp_status ask(growth_solver *self, const growth_question *question)
{
    growth_engine *engine = &self->engine;
    double known = question->time;
    members_clear(self);
    for (int round = 0; engine->shape_count > SMALL && round < ROUNDS && engine->member_count * LARGE_SHARE < engine->shape_count; ++round) {
        ++self->rounds;
        tdsp_status status = run(self, question, known);
        if (status == TDSP_OK && engine->arrived == GROWTH_NONE && question->sign < 0.0) break;
        if (status != TDSP_OK || engine->arrived == GROWTH_NONE || path_mend(self) == 0) return status;
        known = engine->legs[engine->arrived].arrive;
    }
    members_all(self);
    return run(self, question, known);
}

/*
 * A moment in the user's time, for a robot that leaves at `began` in the frame's; the last robot may meet the disc that covers its goal. What is forgiven is told as the
 * moment of the cover, so it is no more than arrivals are wrong by.
 */
static double frame_until(const tdsp_scene *scene, double time, double began)
{
    double until = time / scene->time;
    return until + GEOM_CONTACT * (1.0 + fabs(until - began)) + GEOM_TIME * fabs(until);
}

tdsp_status growth_arrival(growth_solver *self, const scene_ends *ends, double departure, double *arrival, double *looked_until)
{
    const tdsp_scene *scene = self->scene;
    growth_question question = {1.0, ends->source, ends->destination, departure / scene->time, 0.0, 0.0, 1.0, 0};
    question.limit = question.goal_until = frame_until(scene, ends->destination_cover.time, question.time);
    tdsp_status status = ask(self, &question);
    if (status != TDSP_OK) return status;
    *looked_until = departure + (self->engine.latest - question.time) * scene->time;
    if (self->engine.arrived == GROWTH_NONE) return TDSP_CUT_OFF;
    double found = departure + (self->engine.legs[self->engine.arrived].arrive - question.time) * scene->time;
    *arrival = math_min(found, math_max(departure, ends->destination_cover.time));
    return TDSP_OK;
}

tdsp_status growth_departure(growth_solver *self, const scene_ends *ends, double arrival, double *departure)
{
    const tdsp_scene *scene = self->scene;
    growth_question question = {-1.0, ends->destination, ends->source, -arrival / scene->time, 0.0, 0.0, 1.0, 0};
    tdsp_status status = ask(self, &question);
    *departure = -1.0;
    if (status != TDSP_OK || self->engine.arrived == GROWTH_NONE) return status;
    double found = arrival - (self->engine.legs[self->engine.arrived].arrive - question.time) * scene->time;
    *departure = math_max(found, 0.0);
    return TDSP_OK;
}

tdsp_status growth_explain(growth_solver *self, const scene_ends *ends, double departure, int *is_open)
{
    const tdsp_scene *scene = self->scene;
    double cover = ends->destination_cover.time / scene->time;
    growth_question question = {1.0, ends->source, ends->destination, departure / scene->time, INFINITY, 0.0, 1.0, 1};
    question.limit = 64.0 * (1.0 + question.time + (isinf(cover) ? 0.0 : fabs(cover)));
    members_clear(self);
    members_all(self);
    tdsp_status status = growth_run(&self->engine, &question);
    *is_open = status == TDSP_OK && (self->engine.is_explained || self->engine.arrived != GROWTH_NONE);
    return status;
}

void growth_forget(growth_solver *self)
{
    self->engine.arrived = GROWTH_NONE;
}

double growth_still_from(const growth_solver *self)
{
    double still = 0.0;
    for (uint32_t i = 0; i < self->engine.shape_count; ++i) {
        const growth_shape *shape = &self->engine.shapes[i];
        const law_piece *last = &shape->pieces[shape->piece_count - 1];
        still = math_max(still, last->degree == 0 ? last->start : INFINITY);
    }
    return still * self->scene->time;
}
