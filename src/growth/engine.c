/* SPDX-License-Identifier: MIT */
/* Labels: the description is in engine.h. */
#include "growth/engine.h"

#include "growth/leave.h"
#include "growth/ride.h"
#include "growth/wake.h"

/* A disc that holds the goal within this depth at the moment of contact is the one that covers it. */
#define COVERS_GOAL 1e-12

typedef enum label_kind { LABEL_LEG, LABEL_RIDE } label_kind;

/* A label's bound was worked out when it was made. */
static double label_bound(void *ctx, const tdsp_label *label)
{
    const growth_engine *engine = ctx;
    return engine->question.weight * (label->kind == LABEL_LEG ? engine->legs[label->id].bound : engine->rides[label->id].bound);
}

static tdsp_status push_label(growth_engine *engine, label_kind kind, uint32_t id, double time)
{
    tdsp_label label = {time, id, kind};
    return tdsp_search_push(engine->open, &label);
}

/* A motion, and who stops it. */
typedef struct blocked_query {
    growth_engine *engine;
    const sight_line *line;
    const growth_ride *ride; /* that it leaves; NULL for none */
    uint32_t to, met;        /* the disc that it meets, on this run; */
    uint32_t except;         /* this one does not count */
    growth_hit first;
} blocked_query;

static int visit_blocked(void *ctx, uint32_t disc)
{
    blocked_query *query = ctx;
    const growth_question *question = &query->engine->question;
    uint32_t left = SHAPE_NONE, met = disc == query->to ? query->met : SHAPE_NONE;
    double time;
    if (disc == query->except) return 1;
    if (query->ride) left = disc == query->ride->disc ? query->ride->run : ride_left(query->engine, query->ride, query->line, disc);
    if (!sight_is_blocked(engine_shape(query->engine, disc), question->sign, query->line, query->first.time, left, met, &time)) return 1;
    query->first.disc = disc;
    query->first.time = time;
    return question->explain && query->to == GROWTH_GOAL; /* who stops it first; else any will do */
}

int growth_leg_is_blocked(growth_engine *engine, const growth_leg *leg, growth_hit *hit)
{
    const growth_ride *ride = leg->ride == GROWTH_NONE ? NULL : &engine->rides[leg->ride];
    blocked_query query = {engine, &leg->line, ride, leg->disc, leg->run, GROWTH_NONE, {GROWTH_NONE, leg->arrive}};
    ++engine->legs_tested;
    reach_line(&engine->reach, &leg->line, leg->arrive, visit_blocked, &query);
    *hit = query.first;
    return hit->disc != GROWTH_NONE;
}

int growth_line_is_blocked(growth_engine *engine, const sight_line *line, double end, uint32_t except)
{
    blocked_query query = {engine, line, NULL, GROWTH_NONE, SHAPE_NONE, except, {GROWTH_NONE, end}};
    reach_line(&engine->reach, line, end, visit_blocked, &query);
    return query.first.disc != GROWTH_NONE;
}

/* Does a disc cover the goal by then? */
static int covers_goal(const growth_engine *engine, uint32_t disc, double time)
{
    const growth_shape *shape = engine_shape(engine, disc);
    double radius = shape_radius(shape, engine->question.sign * time);
    return point_distance(shape->center, engine->question.goal) <= radius * (1.0 + COVERS_GOAL) + COVERS_GOAL;
}

/*
 * When the question is why there is no way: the disc ridden may be the one that covers the goal, and then no leg to the goal is left. The rider
 * has come as near as it can when it passes in front of it.
 */
static int ride_explains(const growth_engine *engine, const growth_chunk *chunk)
{
    double at;
    return engine->question.explain && rider_passes(chunk, engine->question.goal, &at) && covers_goal(engine, chunk->ride->disc, at);
}

static tdsp_status leg_add(growth_engine *engine, const growth_leg *leg)
{
    tdsp_status status = memory_reserve(&engine->allocator, (void **)&engine->legs, &engine->leg_capacity, engine->leg_count + 1, sizeof *leg);
    if (status == TDSP_OK) engine->legs[engine->leg_count++] = *leg;
    return status;
}

tdsp_status growth_push_leg(growth_engine *engine, const growth_leg *leg)
{
    growth_hit hit;
    if (!(leg->arrive + leg->bound <= engine->limit)) return TDSP_OK;
    if (leg->disc == GROWTH_GOAL) {
        if (leg->arrive > engine->question.goal_until) return TDSP_OK;
        if (!engine->question.explain && growth_leg_is_blocked(engine, leg, &hit)) return TDSP_OK;
        if (!engine->question.explain) engine->limit = leg->arrive;
    }
    tdsp_status status = leg_add(engine, leg);
    return status == TDSP_OK ? push_label(engine, LABEL_LEG, (uint32_t)(engine->leg_count - 1), leg->arrive) : status;
}

static tdsp_status ride_begin(growth_engine *engine, growth_ride *ride)
{
    growth_shape *shape = &engine->shapes[ride->disc];
    tdsp_status status = shape_measure(shape, &engine->allocator, ride->run);
    if (status != TDSP_OK) return status;
    if (wake_covers(engine, ride, ride->normal, &ride->start, GROWTH_NONE)) return TDSP_OK;
    status = memory_reserve(&engine->allocator, (void **)&engine->rides, &engine->ride_capacity, engine->ride_count + 1, sizeof *ride);
    if (status != TDSP_OK) return status;
    ride->now = ride->start;
    ride->next = engine->heads[ride->disc];
    ride->is_over = 0;
    engine->rides[engine->ride_count] = *ride;
    engine->heads[ride->disc] = (uint32_t)engine->ride_count;
    return push_label(engine, LABEL_RIDE, (uint32_t)engine->ride_count++, ride->start.time);
}

/* Discs smaller than this are pebbles: the rounding of a place turns their normal more than that of an angle. */
#define PEBBLE 1e-3

/*
 * By the place, or on a pebble by the heading, which its rider goes on with: there a rounding of the time would turn it past what it was to leave for. Not where the
 * rate is so near to the robot's speed that the angle between heading and normal is known no better.
 */
static double landing_normal(const growth_shape *shape, double sign, const growth_leg *leg)
{
    tdsp_point out = point_sub(sight_place(&leg->line, leg->arrive), shape->center);
    double theta = leg->land.in_fan ? 0.0 : rider_theta(shape, sign, leg->land.span, leg->land.time);
    if (point_length(out) >= PEBBLE * math_sin(theta)) return math_atan2(out.y, out.x);
    return math_atan2(leg->line.unit.y, leg->line.unit.x) - leg->side * theta;
}

static tdsp_status leg_taken(growth_engine *engine, uint32_t index, int *done)
{
    const growth_leg leg = engine->legs[index];
    growth_hit hit;
    engine->latest = math_max(engine->latest, leg.arrive);
    if ((leg.disc != GROWTH_GOAL || engine->question.explain) && growth_leg_is_blocked(engine, &leg, &hit)) {
        engine->is_explained = *done = leg.disc == GROWTH_GOAL && covers_goal(engine, hit.disc, hit.time);
        return TDSP_OK;
    }
    if (leg.disc == GROWTH_GOAL) {
        engine->arrived = index;
        *done = 1;
        return TDSP_OK;
    }
    const growth_shape *shape = engine_shape(engine, leg.disc);
    growth_ride ride = {.disc = leg.disc, .run = leg.run, .side = leg.side, .leg = index, .start = leg.land, .bound = leg.bound};
    ride.normal = landing_normal(shape, engine->question.sign, &leg);
    return ride_begin(engine, &ride);
}

/* Follow a ride by one chunk. */
static tdsp_status ride_taken(growth_engine *engine, uint32_t index, int *done)
{
    growth_ride ride = engine->rides[index]; /* the array may move */
    const growth_shape *shape = engine_shape(engine, ride.disc);
    growth_chunk chunk;
    if (!rider_next_chunk(shape, engine->question.sign, &ride, &chunk)) return TDSP_OK;
    double whole = chunk.to, limit = engine->limit;
    if (!chunk.base.in_fan) chunk.to = math_min(chunk.to, math_max(chunk.from, limit));
    ride_changes changes;
    chunk.to = ride_free_until(engine, &chunk, &changes);
    double free_until = chunk.to;
    engine->latest = math_max(engine->latest, chunk_moment(&chunk, chunk.to).time);
    chunk.to = wake_cut(engine, &chunk, index);
    int is_cut = chunk.to < whole || free_until < whole;
    if (ride_explains(engine, &chunk)) {
        engine->is_explained = *done = 1;
        return TDSP_OK;
    }
    tdsp_status status = chunk.to > chunk.from ? leave_chunk(engine, &chunk, index) : TDSP_OK;
    for (uint32_t i = 0; i < changes.count && status == TDSP_OK; ++i)
        if (changes.at[i].at <= chunk.to) status = leave_touch(engine, &chunk, index, &changes.at[i]);
    if (status != TDSP_OK) return status;
    int is_over = is_cut;
    growth_moment now = is_cut ? chunk_moment(&chunk, chunk.to) : rider_after(&chunk, &is_over);
    growth_ride *kept = &engine->rides[index];
    kept->now = now;
    kept->is_over = is_over || rider_turned(shape, engine->question.sign, kept, &now) > GEOM_TURN;
    if (kept->is_over) return TDSP_OK;
    kept->bound = point_distance(rider_place(shape, engine->question.sign, kept, &now), engine->question.goal);
    return push_label(engine, LABEL_RIDE, index, now.time);
}

static tdsp_status label_taken(void *ctx, const tdsp_label *label, tdsp_search *open, int *done)
{
    growth_engine *engine = ctx;
    (void)open;
    ++engine->labels;
    return label->kind == LABEL_LEG ? leg_taken(engine, label->id, done) : ride_taken(engine, label->id, done);
}

/* A start on a boundary may ride at once, either way round. */
static tdsp_status start_rides(growth_engine *engine, uint32_t disc)
{
    const growth_question *question = &engine->question;
    const growth_shape *shape = engine_shape(engine, disc);
    uint32_t span = sight_span_at(shape, question->sign, question->time), run = shape->spans[span].run;
    tdsp_point out = point_sub(question->start, shape->center);
    double radius = shape_radius(shape, question->sign * question->time), gap = point_length(out) - radius;
    if (run == SHAPE_NONE || gap > 1e-12 * (1.0 + radius)) return TDSP_OK;
    tdsp_status status = TDSP_OK;
    for (int side = -1; side <= 1 && status == TDSP_OK; side += 2) {
        growth_ride ride = {.disc = disc, .run = run, .side = side, .leg = GROWTH_NONE, .normal = math_atan2(out.y, out.x)};
        ride.start.span = span;
        ride.start.time = question->time;
        ride.bound = point_distance(question->start, question->goal);
        status = ride_begin(engine, &ride);
    }
    return status;
}

typedef struct start_label {
    growth_engine *engine;
    int is_begun;
} start_label;

/* The first label only begins: pushing is allowed from inside a search. */
static tdsp_status search_step(void *ctx, const tdsp_label *label, tdsp_search *open, int *done)
{
    start_label *self = ctx;
    growth_engine *engine = self->engine;
    if (self->is_begun) return label_taken(engine, label, open, done);
    self->is_begun = 1;
    tdsp_status status = leave_start(engine);
    for (uint32_t i = 0; i < engine->member_count && status == TDSP_OK; ++i) status = start_rides(engine, engine->members[i]);
    return status;
}

static double search_bound(void *ctx, const tdsp_label *label)
{
    const start_label *self = ctx;
    return self->is_begun ? label_bound(self->engine, label) : 0.0;
}

/* Where nothing limits a search, the index knows about journeys that take this many times as long as the straight way. */
#define WINDOW 16.0

static tdsp_status members_reach(growth_engine *engine)
{
    const growth_question *question = &engine->question;
    double last = isinf(question->limit) ? question->time + WINDOW * point_distance(question->start, question->goal) : question->limit;
    reach_question ask = {engine->shapes, engine->members, engine->member_count, question->sign, question->time, math_max(last, question->time)};
    if (question->sign < 0.0) {
        ask.from = math_max(-question->limit, 0.0);
        ask.until = -question->time;
    }
    tdsp_status status = reach_build(&engine->reach, &engine->allocator, &ask);
    if (status == TDSP_OK) reach_limit(&engine->reach, question->goal, question->limit);
    return status;
}

tdsp_status growth_run(growth_engine *engine, const growth_question *question)
{
    start_label begin = {engine, 0};
    tdsp_search_problem problem = {sizeof problem, &begin, search_bound, search_step};
    tdsp_label first = {question->time, 0, LABEL_LEG};
    engine->question = *question;
    engine->limit = question->limit;
    engine->leg_count = engine->ride_count = 0;
    engine->arrived = GROWTH_NONE;
    engine->is_explained = 0;
    engine->latest = question->time;
    for (uint32_t i = 0; i < engine->shape_count; ++i) engine->heads[i] = GROWTH_NONE;
    for (uint32_t i = 0; i < engine->member_count; ++i)
        if (sight_is_inside(engine_shape(engine, engine->members[i]), question->sign, question->start, question->time)) return TDSP_OK;
    tdsp_status status = members_reach(engine);
    return status == TDSP_OK ? tdsp_search_run(engine->open, &problem, &first, 1, NULL) : status;
}
