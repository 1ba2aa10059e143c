/* SPDX-License-Identifier: MIT */
/* The disc engine's loop: labels in, rides and legs out. The method is in engine.h. */
#include "search/engine.h"

#include <string.h>

#include "search/sweep.h"

enum { LABEL_LEG = 0, LABEL_RIDE = 1, LABEL_START = 2 };

/* A disc that holds the goal within this depth at the moment of contact is the one that covers it. */
#define COVERS_GOAL 1e-12

static double label_bound(void *ctx, const tdsp_label *label)
{
    const disc_engine *engine = ctx;
    double bound = label->kind == LABEL_LEG ? engine->legs[label->id].bound : label->kind == LABEL_RIDE ? engine->rides[label->id].bound : 0.0;
    return engine->question.weight * bound;
}

geom_line engine_leg_motion(const disc_engine *engine, const engine_leg *leg)
{
    tdsp_point from = engine->question.start;
    if (leg->ride != ENGINE_NONE) from = disc_boundary(engine_disc(engine, engine->rides[leg->ride].disc), leg->normal, leg->leave);
    geom_line line = {from, point_unit(leg->heading), leg->leave, leg->length};
    return line;
}

uint32_t engine_leg_origin(const disc_engine *engine, const engine_leg *leg)
{
    return leg->ride == ENGINE_NONE ? INDEX_NONE : engine->rides[leg->ride].disc;
}

static int leg_blocked(disc_engine *engine, const engine_leg *leg)
{
    geom_line line = engine_leg_motion(engine, leg);
    ++engine->legs_tested;
    return index_line_blocked(&engine->view, &line, engine_leg_origin(engine, leg), leg->disc);
}

/* Is what stops this leg to the goal a disc that covers the goal by then? The leg is cut there. */
static int leg_stopped_by_cover(disc_engine *engine, engine_leg *leg)
{
    geom_line line = engine_leg_motion(engine, leg);
    double length;
    uint32_t first = index_line_first(&engine->view, &line, engine_leg_origin(engine, leg), &length);
    if (first == INDEX_NONE) return 1;
    leg->length = length;
    const geom_disc *disc = engine_disc(engine, first);
    double radius = disc_radius(disc, leg_arrival(leg));
    return point_distance(disc->center, engine->question.goal) <= radius * (1.0 + COVERS_GOAL) + COVERS_GOAL;
}

static int goal_leg_good(disc_engine *engine, const engine_leg *leg)
{
    double arrival = leg_arrival(leg);
    return arrival >= engine->question.goal_opens && arrival <= engine->question.goal_until && !leg_blocked(engine, leg);
}

static void engine_set_limit(disc_engine *engine, double limit)
{
    engine->limit = limit;
    if (engine->question.weight == 1.0) tdsp_search_limit(engine->open, limit);
}

static tdsp_status engine_add_leg(disc_engine *engine, const engine_leg *leg, uint32_t *added)
{
    if (engine->leg_count >= ENGINE_GOAL) return TDSP_NO_MEMORY;
    tdsp_status status = memory_reserve(&engine->scene->allocator, (void **)&engine->legs, &engine->leg_capacity,
                                        engine->leg_count + 1, sizeof *engine->legs);
    if (status != TDSP_OK) return status;
    *added = (uint32_t)engine->leg_count;
    engine->legs[engine->leg_count++] = *leg;
    return TDSP_OK;
}

tdsp_status engine_arrive(disc_engine *engine, const engine_leg *leg, int *done)
{
    *done = 1;
    return engine_add_leg(engine, leg, &engine->arrived);
}

/* A leg to the goal when the question is why there is no way. */
static tdsp_status engine_explain_leg(disc_engine *engine, engine_leg leg, int *done)
{
    return leg_stopped_by_cover(engine, &leg) ? engine_arrive(engine, &leg, done) : TDSP_OK;
}

static void engine_limit_to_goals(disc_engine *engine)
{
    engine_set_limit(engine, math_min(goals_latest(&engine->several), engine->question.limit));
}

/* A leg to one of several goals that is earlier than what was found so far. */
static tdsp_status engine_push_goal_leg(disc_engine *engine, const engine_leg *leg)
{
    const engine_goal *goal = &engine->several.goals[leg->goal];
    double arrival = leg_arrival(leg);
    uint32_t added;
    if (arrival >= goal->best || arrival < goal->opens || arrival > goal->until || leg_blocked(engine, leg)) return TDSP_OK;
    tdsp_status status = engine_add_leg(engine, leg, &added);
    if (status != TDSP_OK) return status;
    goals_reach(&engine->several, leg->goal, arrival, added);
    engine_limit_to_goals(engine);
    tdsp_label label = {arrival, added, LABEL_LEG};
    return tdsp_search_push(engine->open, &label);
}

/* The first leg to a goal, unless another that was found later arrives earlier. */
static tdsp_status engine_settle(disc_engine *engine, uint32_t id, int *done)
{
    uint32_t goal = engine->legs[id].goal;
    if (engine->several.goals[goal].leg != id) return TDSP_OK;
    goals_settle(&engine->several, goal);
    engine_limit_to_goals(engine);
    *done = engine->several.open == 0;
    return TDSP_OK;
}

tdsp_status engine_push_leg(disc_engine *engine, const engine_leg *leg, int *done)
{
    uint32_t added;
    if (leg_arrival(leg) + leg->bound > engine->limit) return TDSP_OK;
    if (leg->disc == ENGINE_GOAL && engine->several.goals) return engine_push_goal_leg(engine, leg);
    if (leg->disc == ENGINE_GOAL) {
        if (engine->question.explain) return engine_explain_leg(engine, *leg, done);
        if (!goal_leg_good(engine, leg)) return TDSP_OK;
        engine_set_limit(engine, leg_arrival(leg));
    }
    tdsp_status status = engine_add_leg(engine, leg, &added);
    if (status != TDSP_OK) return status;
    tdsp_label label = {leg_arrival(leg), added, LABEL_LEG};
    return tdsp_search_push(engine->open, &label);
}

static tdsp_status engine_add_ride(disc_engine *engine, engine_ride ride, uint32_t *added)
{
    tdsp_status status = memory_reserve(&engine->scene->allocator, (void **)&engine->rides, &engine->ride_capacity,
                                        engine->ride_count + 1, sizeof *engine->rides);
    if (status != TDSP_OK) return status;
    *added = (uint32_t)engine->ride_count;
    engine->rides[engine->ride_count++] = ride;
    sweep_add(engine, *added);
    return TDSP_OK;
}

/* A point that begins to grow has no boundary to ride on yet. */
static int engine_can_ride(const disc_engine *engine, uint32_t disc, double time)
{
    return disc_radius(engine_disc(engine, disc), time) > ENGINE_LEAST_RIDE;
}

static tdsp_status expand_leg(disc_engine *engine, uint32_t id, int *done)
{
    const engine_leg *leg = &engine->legs[id];
    if (leg->disc == ENGINE_GOAL && engine->several.goals) return engine_settle(engine, id, done);
    if (leg->disc == ENGINE_GOAL) {
        engine->arrived = id;
        *done = 1;
        return TDSP_OK;
    }
    double arrival = leg_arrival(leg);
    if (arrival + leg->bound > engine->limit) return TDSP_OK;
    double normal = leg->heading - leg->side * engine_disc(engine, leg->disc)->theta;
    if (!engine_can_ride(engine, leg->disc, arrival)) return TDSP_OK;
    if (sweep_covers(engine, leg->disc, leg->side, normal, arrival) || leg_blocked(engine, leg)) return TDSP_OK;
    engine_ride ride = {leg->disc, leg->side, id, ENGINE_NONE, normal, arrival, arrival, leg->bound};
    uint32_t added;
    tdsp_status status = engine_add_ride(engine, ride, &added);
    return status == TDSP_OK ? ride_follow(engine, added, done) : status;
}

static tdsp_status expand_start(disc_engine *engine, int *done)
{
    const engine_question *question = &engine->question;
    engine_set_limit(engine, question->limit);
    if (question->seed_count == 0) return leaves_push_start(engine, done);
    for (int i = 0; i < question->seed_count && !*done; ++i) {
        const engine_seed *seed = &question->seeds[i];
        if (!engine_can_ride(engine, seed->disc, question->time)) continue;
        tdsp_point place = disc_boundary(engine_disc(engine, seed->disc), seed->normal, question->time);
        engine_ride ride = {seed->disc,    seed->side,     ENGINE_NONE,    ENGINE_NONE,
                            seed->normal, question->time, question->time, engine_bound(engine, place)};
        uint32_t added;
        tdsp_status status = engine_add_ride(engine, ride, &added);
        if (status == TDSP_OK) status = ride_follow(engine, added, done);
        if (status != TDSP_OK) return status;
    }
    return TDSP_OK;
}

static tdsp_status expand(void *ctx, const tdsp_label *label, tdsp_search *open, int *done)
{
    disc_engine *self = ctx;
    (void)open;
    if (self->patience && self->chunks > self->patience) {
        self->gave_up = 1;
        *done = 1;
        return TDSP_OK;
    }
    if (label->kind == LABEL_LEG) return expand_leg(self, label->id, done);
    if (label->kind == LABEL_RIDE) return ride_follow(self, label->id, done);
    return expand_start(self, done);
}

/* Forget the last run. The stamps make that O(1), but for once in 2^32 runs. */
static void engine_forget(disc_engine *engine)
{
    engine->leg_count = engine->ride_count = 0;
    engine->arrived = ENGINE_NONE;
    engine->gave_up = 0;
    engine->chunks = 0;
    if (++engine->stamp == 0 && engine->scene->all.count) {
        memset(engine->stamps, 0, engine->scene->all.count * sizeof *engine->stamps);
        engine->stamp = 1;
    }
}

/* The rings of the whole scene stay, as long as not too many points are among them; those of a part are worth nothing when it has changed. */
static tdsp_status engine_set_around(disc_engine *engine, const disc_set *set)
{
    int is_whole = set == &engine->scene->all;
    engine->around = is_whole ? &engine->around_all : &engine->around_part;
    int is_kept = is_whole && engine->around->set == set && !neighbours_crowded(engine->around);
    return is_kept ? TDSP_OK : neighbours_begin(engine->around, &engine->scene->allocator, set);
}

static tdsp_status engine_search(disc_engine *engine, const disc_set *set, const engine_question *question)
{
    const tdsp_search_problem problem = {sizeof problem, engine, label_bound, expand};
    const tdsp_label start = {question->time, 0, LABEL_START};
    engine_forget(engine);
    engine->question = *question;
    engine->goal = disc_point(question->goal);
    engine->set = set;
    engine->rate_max = set->count ? set->index.nodes[0].rate : 0.0;
    engine->view.index = &set->index;
    engine->view.sign = question->direction;
    engine->view.discs = question->direction == ENGINE_FORWARD ? set->forward : set->reverse;
    int is_part = set != &engine->scene->all;
    engine->patience = is_part && !question->patience ? engine->part_patience : question->patience;
    ++engine->runs;
    tdsp_status status = engine_set_around(engine, set);
    if (status == TDSP_OK) status = tdsp_search_run(engine->open, &problem, &start, 1, NULL);
    return status == TDSP_OK && is_part && !question->patience && engine->gave_up ? TDSP_NO_ANSWER : status;
}

tdsp_status engine_run(disc_engine *engine, const disc_set *set, const engine_question *question)
{
    goals_forget(&engine->several);
    return engine_search(engine, set, question);
}

tdsp_status engine_run_many(disc_engine *engine, const disc_set *set, const engine_question *question, engine_goal *goals, uint32_t count)
{
    engine_question ask = *question;
    tdsp_status status = goals_begin(&engine->several, &engine->scene->allocator, goals, count);
    if (status != TDSP_OK) return status;
    ask.goal = engine->several.middle;
    ask.limit = math_min(ask.limit, goals_latest(&engine->several));
    return engine_search(engine, set, &ask);
}

/* A path across n discs that stand evenly passes about sqrt(n) of them; a scout turns back after passing this many times as many, and a few. */
#define PATIENCE 1.5
#define PATIENCE_LEAST 48

/* What the scouts weigh the bounds with. */
static const double SCOUTS[] = {1.2, 1.03};

/* A path's time is rounded: the best path may seem this share of the times at hand later than one that is no better. */
#define LIMIT_SLACK 1e-12

uint64_t engine_patience(const disc_engine *engine)
{
    return PATIENCE_LEAST + (uint64_t)(PATIENCE * sqrt((double)engine->scene->all.count));
}

tdsp_status engine_scout(disc_engine *engine, engine_question *question, int *lost)
{
    const disc_set *all = &engine->scene->all;
    engine_question ask = *question;
    *lost = 0;
    if (all->count <= ENGINE_SMALL) return TDSP_OK;
    ask.patience = engine_patience(engine);
    for (size_t i = 0; i < sizeof SCOUTS / sizeof *SCOUTS; ++i) {
        ask.weight = SCOUTS[i];
        tdsp_status status = engine_run(engine, all, &ask);
        if (status != TDSP_OK) return status;
        *lost = i == 0 && engine->arrived == ENGINE_NONE;
        if (engine->arrived == ENGINE_NONE) break;
        double arrival = engine_arrival(engine);
        ask.limit = math_min(ask.limit, arrival + LIMIT_SLACK * (1.0 + fabs(arrival)));
    }
    question->limit = ask.limit;
    return TDSP_OK;
}

double engine_lower_bound(const disc_engine *engine)
{
    double lower = engine_arrival(engine);
    for (size_t i = 0; i < engine->open->open.count; ++i) {
        const tdsp_label *label = &engine->open->open.slots[i].label;
        double earliest = label->time + label_bound((void *)engine, label) / engine->question.weight;
        if (earliest < lower) lower = earliest;
    }
    return lower;
}

double engine_arrival(const disc_engine *engine)
{
    return leg_arrival(&engine->legs[engine->arrived]);
}

tdsp_status engine_create(disc_engine *engine, const tdsp_scene *scene)
{
    memset(engine, 0, sizeof *engine);
    engine->scene = scene;
    engine->arrived = ENGINE_NONE;
    tdsp_status status = tdsp_search_create(&scene->allocator, &engine->open);
    if (status != TDSP_OK || scene->all.count == 0) return status;
    size_t lists = scene->all.count;
    engine->heads = memory_array(&scene->allocator, lists, sizeof *engine->heads);
    engine->stamps = memory_array(&scene->allocator, lists, sizeof *engine->stamps);
    if (!engine->heads || !engine->stamps) {
        engine_free(engine);
        return TDSP_NO_MEMORY;
    }
    memset(engine->stamps, 0, lists * sizeof *engine->stamps);
    return TDSP_OK;
}

void engine_free(disc_engine *engine)
{
    if (!engine->scene) return;
    const tdsp_allocator *memory = &engine->scene->allocator;
    size_t lists = engine->scene->all.count;
    tdsp_search_free(engine->open);
    heap_free(&engine->looks, memory);
    goals_free(&engine->several, memory);
    neighbours_free(&engine->around_all, memory);
    neighbours_free(&engine->around_part, memory);
    memory_free(memory, engine->legs, engine->leg_capacity * sizeof *engine->legs);
    memory_free(memory, engine->rides, engine->ride_capacity * sizeof *engine->rides);
    memory_free(memory, engine->heads, lists * sizeof *engine->heads);
    memory_free(memory, engine->stamps, lists * sizeof *engine->stamps);
    memset(engine, 0, sizeof *engine);
}

uint64_t engine_bytes(const disc_engine *engine)
{
    uint64_t lists = (uint64_t)engine->scene->all.count * (sizeof *engine->heads + sizeof *engine->stamps);
    uint64_t around = neighbours_bytes(&engine->around_all) + neighbours_bytes(&engine->around_part);
    uint64_t several = set_bytes(&engine->several.points) + engine->several.latest_capacity * sizeof *engine->several.latest;
    return lists + around + several + engine->leg_capacity * sizeof *engine->legs + engine->ride_capacity * sizeof *engine->rides +
           (engine->open->open.capacity + engine->looks.capacity) * sizeof(heap_slot);
}
