/* SPDX-License-Identifier: MIT */
/*
 * The legs that leave a chunk of a ride, or the start.
 *
 * Discs are looked at ring by ring (neighbours.h), nearest first, as far as they stand in the wedge and are not hidden (wedge.h). Where the rings end the
 * index is asked for the rest, nearest first as well.
 */
#include "geom/angle.h"
#include "geom/tangent.h"
#include "geom/tolerance.h"
#include "search/engine.h"
#include "search/wedge.h"

enum { LOOK_NODE = 0, LOOK_DISC = 1 };

/* The start looks around in so many sectors. */
#define SECTORS 6

/* Centres closer than this share of the radii count as one: bearings mean nothing then. */
#define SAME_CENTER 1e-9

/* The legs of one wedge. */
typedef struct leave_task {
    disc_engine *engine;
    uint32_t ride;  /* ENGINE_NONE: the start */
    uint32_t self;  /* the disc ridden, or INDEX_NONE */
    uint32_t place;  /* of its rings */
    uint32_t others; /* so many discs are not it */
    uint32_t goal;   /* which of several is looked at */
    look_wedge wedge;
    int *done;
} leave_task;

static void task_init(leave_task *task, disc_engine *engine, uint32_t ride, uint32_t self, int *done)
{
    task->engine = engine;
    task->ride = ride;
    task->self = self;
    task->place = task->goal = 0;
    task->others = engine->set->count - (self != INDEX_NONE);
    task->done = done;
}

static int task_is_start(const leave_task *task)
{
    return task->ride == ENGINE_NONE;
}

static tdsp_status task_push(leave_task *task, const geom_tangent *tangent, uint32_t target, double leave)
{
    disc_engine *engine = task->engine;
    const geom_ride *motion = &task->wedge.motion;
    geom_leg taken = task_is_start(task) ? (geom_leg){0.0, tangent_heading(tangent, leave), tangent_length(tangent, leave)}
                                         : tangent_leg(tangent, ride_angle(motion, leave), leave);
    engine_leg leg = {task->ride, target, tangent->to_side, task->goal, leave, taken.normal, taken.heading, taken.length, 0.0};
    if (taken.length == TANGENT_NONE) return TDSP_OK;
    double direction = wedge_direction(&task->wedge, angle_positive(leg.heading));
    if (sky_hides(&task->wedge.sky, direction, direction, leg.length)) return TDSP_OK;
    if (target != ENGINE_GOAL) {
        double reached = leg.heading - leg.side * tangent->to->theta;
        tdsp_point place = disc_boundary(tangent->to, reached, leg_arrival(&leg));
        leg.bound = engine_bound(engine, place);
    }
    return engine_push_leg(engine, &leg, task->done);
}

/*
 * Discs that just close the gap that the rider passes: whoever is let past may also change over, or rounding would leave a way that neither world has, the one with the
 * gap and the one without.
 */
static tdsp_status task_try_touch(leave_task *task, const geom_disc *disc, uint32_t target)
{
    const geom_ride *motion = &task->wedge.motion;
    double leave;
    if (!ride_touch(motion, disc, &leave)) return TDSP_OK;
    double normal = ride_angle(motion, leave), heading = disc_heading(motion->disc, motion->side, normal);
    engine_leg leg = {task->ride, target, -motion->side, task->goal, leave, normal, heading, 0.0, 0.0};
    leg.bound = engine_bound(task->engine, disc_boundary(motion->disc, normal, leave));
    return engine_push_leg(task->engine, &leg, task->done);
}

/* Does the leg of this branch shrink to nothing as the gap between the discs closes? */
static int task_may_touch(const geom_tangent *tangent, uint32_t target)
{
    int shrinks = (tangent->from->rate + tangent->to->rate < 0.0) == (tangent->root < 0);
    return target != ENGINE_GOAL && tangent->to_side != tangent->side && shrinks;
}

/* Push the leg of one branch, if it leaves this chunk. From a start, whose radius is 0, the second root has none: w = 0, and L would be below 0. */
static tdsp_status task_try(leave_task *task, const geom_pair *pair, uint32_t target, int to_side, int root, int is_apart)
{
    const geom_ride *motion = &task->wedge.motion;
    double leave = motion->start;
    geom_tangent tangent = tangent_make(pair, motion->side, to_side, root);
    if (*task->done || !tangent_possible(&tangent) || (task_is_start(task) && root < 0)) return TDSP_OK;
    int leaves = task_is_start(task) ? 1
                 : is_apart          ? tangent_leave_apart(&tangent, motion->angle, motion->start, motion->end, &leave)
                                     : tangent_leave(&tangent, motion->angle, motion->start, motion->end, &leave);
    if (leaves) return task_push(task, &tangent, target, leave);
    return !is_apart && task_may_touch(&tangent, target) ? task_try_touch(task, tangent.to, target) : TDSP_OK;
}

/*
 * The second root has legs only where q sin(alpha) > 0: to the own side of a disc of a larger rate, or, when time runs backwards, to the other side. And
 * discs that are apart have K^2 + w^2 <= (R_i + R_j)^2 < |D|^2: the second root has none at all, and every leg of the first has a length.
 */
static tdsp_status task_try_roots(leave_task *task, const geom_pair *pair, uint32_t target, int to_side)
{
    tdsp_status status = task_try(task, pair, target, to_side, 1, 0);
    return status == TDSP_OK ? task_try(task, pair, target, to_side, -1, 0) : status;
}

/* Push the leg to a goal: to a point it does not matter on which side it is passed. */
static tdsp_status task_try_goal(leave_task *task, const geom_disc *goal)
{
    const geom_disc *own = task->wedge.motion.disc;
    tdsp_point offset = point_sub(goal->center, own->center);
    wedge_sight sight;
    wedge_look_at_disc(&task->wedge, goal, point_length(offset), angle_near(offset.y, offset.x), &sight);
    if (sight.is_apart && !wedge_shows(&task->wedge, &sight.same, sight.shortest)) return TDSP_OK;
    geom_pair pair = pair_make(own, goal);
    if (!sight.is_apart) return task_try_roots(task, &pair, ENGINE_GOAL, task->wedge.motion.side);
    return task_try(task, &pair, ENGINE_GOAL, task->wedge.motion.side, 1, 1);
}

/* Is every path by way of the disc too late? */
static int task_too_late(const leave_task *task, const geom_disc *disc)
{
    const disc_engine *engine = task->engine;
    const look_wedge *wedge = &task->wedge;
    if (isinf(engine->limit)) return 0;
    double first = disc_radius(disc, wedge->motion.start), last = disc_radius(disc, engine->limit);
    double detour = point_distance(disc->center, wedge->middle) + point_distance(disc->center, engine->question.goal) - engine->several.spread;
    return wedge->motion.start + detour - wedge->half_length - 2.0 * (first > last ? first : last) > engine->limit;
}

static tdsp_status task_visit(leave_task *task, uint32_t k, double bearing)
{
    const geom_disc *disc = engine_disc(task->engine, k), *own = task->wedge.motion.disc;
    int side = task->wedge.motion.side;
    wedge_sight sight;
    if (!disc_ridable(disc) || task_too_late(task, disc)) return TDSP_OK;
    double distance = point_distance(disc->center, own->center);
    if (distance <= SAME_CENTER * (task->wedge.widest + disc_radius(disc, task->wedge.motion.start))) {
        geom_pair pair = pair_make(own, disc);
        tdsp_status status = task_try_roots(task, &pair, k, side);
        return status == TDSP_OK ? task_try_roots(task, &pair, k, -side) : status;
    }
    if (!wedge_look_at_disc(&task->wedge, disc, distance, bearing, &sight)) return TDSP_OK;
    int shows_same = wedge_shows(&task->wedge, &sight.same, sight.shortest);
    int shows_other = wedge_shows(&task->wedge, &sight.other, sight.shortest);
    int second_roots = !sight.is_apart && (own->rate < disc->rate || own->rate + disc->rate < 0.0);
    tdsp_status status = TDSP_OK;
    if (shows_same || shows_other || second_roots) {
        geom_pair pair = pair_make(own, disc);
        if (shows_same) status = task_try(task, &pair, k, side, 1, sight.is_apart);
        if (shows_other && status == TDSP_OK) status = task_try(task, &pair, k, -side, 1, sight.is_apart);
        if (second_roots && status == TDSP_OK) status = task_try(task, &pair, k, side, -1, 0);
        if (second_roots && status == TDSP_OK) status = task_try(task, &pair, k, -side, -1, 0);
    }
    if (status == TDSP_OK && !*task->done) wedge_cover(&task->wedge, disc, &sight);
    return status;
}

static tdsp_status look_later(leave_task *task, uint32_t id, uint32_t kind, double shortest)
{
    disc_engine *engine = task->engine;
    tdsp_label label = {shortest, id, kind};
    return heap_push(&engine->looks, &engine->scene->allocator, shortest, label);
}

/* Put what a node holds, as far as it may be seen, among the things to look at; discs within the rings have been. */
static tdsp_status look_into(leave_task *task, uint32_t self, double shortest, double rings)
{
    const disc_engine *engine = task->engine;
    const look_wedge *wedge = &task->wedge;
    const index_node *nodes = engine->view.index->nodes, *node = &nodes[self];
    double there;
    tdsp_status status = TDSP_OK;
    for (uint32_t k = node->first; k < node->first + node->count && status == TDSP_OK; ++k) {
        const geom_disc *disc = engine_disc(engine, k), *forward = &engine->set->forward[k];
        double first = disc_radius(disc, wedge->motion.start), last = disc_radius(disc, wedge->motion.end);
        if (k == task->self || point_distance(forward->center, wedge->motion.disc->center) - forward->radius <= rings) continue;
        if (!wedge_look_at_place(wedge, disc->center, first > last ? first : last, disc->rate, &there)) continue;
        status = look_later(task, k, LOOK_DISC, there > shortest ? there : shortest);
    }
    if (node->count) return status;
    const uint32_t children[2] = {self + 1, node->right};
    for (int i = 0; i < 2 && status == TDSP_OK; ++i) {
        const index_node *child = &nodes[children[i]];
        double reach = index_node_reach(child, wedge->late > 0.0 ? wedge->late : 0.0) + child->half;
        if (wedge_look_at_place(wedge, child->middle, reach, child->rate, &there))
            status = look_later(task, children[i], LOOK_NODE, there > shortest ? there : shortest);
    }
    return status;
}

/* What is farther away than the rings reach. */
static tdsp_status task_look_far(leave_task *task, double rings)
{
    disc_engine *engine = task->engine;
    const geom_disc *own = task->wedge.motion.disc;
    heap_clear(&engine->looks);
    tdsp_status status = look_later(task, 0, LOOK_NODE, 0.0);
    while (status == TDSP_OK && !*task->done && engine->looks.count > 0) {
        tdsp_label look = heap_pop(&engine->looks);
        if (!sky_advance(&task->wedge.sky, look.time)) break;
        if (look.kind == LOOK_NODE) {
            status = look_into(task, look.id, look.time, rings);
        } else {
            tdsp_point offset = point_sub(engine_disc(engine, look.id)->center, own->center);
            status = task_visit(task, look.id, angle_near(offset.y, offset.x));
        }
    }
    return status;
}

static tdsp_status task_look_at_ring(leave_task *task, uint32_t ring)
{
    const neighbourhood *around = task->engine->around;
    const neighbour_ring *self = &around->rings[task->place].rings[ring];
    int seen[NEIGHBOUR_BLOCK];
    tdsp_status status = TDSP_OK;
    for (uint32_t first = 0; first < self->count && status == TDSP_OK; first += NEIGHBOUR_BLOCK) {
        const neighbour_block *block = &around->blocks[self->first + first / NEIGHBOUR_BLOCK];
        int count = wedge_look_at_block(&task->wedge, block, seen);
        for (int i = 0; i < count && status == TDSP_OK && !*task->done; ++i) status = task_visit(task, block->disc[seen[i]], block->bearing[seen[i]]);
    }
    return status;
}

/* See to it that there is a ring after those that hold `seen` discs; *far is 1 when a rider looks at no more rings. */
static tdsp_status task_next_ring(leave_task *task, uint32_t ring, uint32_t seen, int *far)
{
    neighbourhood *around = task->engine->around;
    int added = ring < around->rings[task->place].ring_count;
    tdsp_status status = TDSP_OK;
    if (!added) status = neighbours_widen(around, &task->engine->scene->allocator, task->place, NEIGHBOURS_MOST, &added);
    *far = !added || seen >= NEIGHBOURS_MOST;
    return status;
}

/* Push the legs to all discs. */
static tdsp_status task_look_around(leave_task *task)
{
    neighbourhood *around = task->engine->around;
    double radius = -INFINITY; /* of the rings looked at */
    uint32_t seen = 0;         /* discs in them */
    tdsp_status status = TDSP_OK;
    for (uint32_t ring = 0; status == TDSP_OK && !*task->done; ++ring) {
        int far;
        double shortest = wedge_shortest(&task->wedge, radius);
        if (shortest > task->wedge.longest || !sky_advance(&task->wedge.sky, shortest)) return TDSP_OK;
        status = task_next_ring(task, ring, seen, &far);
        if (status != TDSP_OK) return status;
        if (far) return seen == task->others ? TDSP_OK : task_look_far(task, radius);
        status = task_look_at_ring(task, ring);
        radius = around->rings[task->place].rings[ring].radius;
        seen += around->rings[task->place].rings[ring].count;
    }
    return status;
}

/* Is a place so near that it can be reached from here by then? */
static int task_reaches(const leave_task *task, double distance, double latest)
{
    return task->wedge.motion.start - task->wedge.half_length + distance < math_min(latest, task->engine->limit);
}

/* Push the legs to the goals of a leaf. */
static tdsp_status task_try_leaf(leave_task *task, const index_node *leaf)
{
    const goal_set *several = &task->engine->several;
    tdsp_status status = TDSP_OK;
    for (uint32_t i = leaf->first; i < leaf->first + leaf->count && status == TDSP_OK; ++i) {
        const geom_disc *point = &several->points.forward[i];
        const engine_goal *goal = &several->goals[several->points.origin[i]];
        double shortest;
        if (goal->is_settled || !task_reaches(task, point_distance(point->center, task->wedge.middle), goal->best)) continue;
        if (!wedge_look_at_place(&task->wedge, point->center, 0.0, 0.0, &shortest)) continue;
        task->goal = several->points.origin[i];
        geom_pair pair = pair_make(task->wedge.motion.disc, point);
        status = task_is_start(task) ? task_try(task, &pair, ENGINE_GOAL, 1, 1, 1) : task_try_goal(task, point);
    }
    return status;
}

/* Push the legs to several goals, once it is known what the discs around hide. */
static tdsp_status task_try_goals(leave_task *task)
{
    const goal_set *several = &task->engine->several;
    uint32_t later[INDEX_DEPTH], at = 0;
    tdsp_status status = TDSP_OK;
    for (int top = 0; status == TDSP_OK;) {
        const index_node *node = &several->points.index.nodes[at];
        double shortest;
        int matters = task_reaches(task, index_node_distance(node, task->wedge.middle), several->latest[at]) &&
                      wedge_look_at_place(&task->wedge, node->middle, node->half, 0.0, &shortest);
        if (matters && !node->count) {
            later[top++] = node->right;
            ++at;
            continue;
        }
        if (matters) status = task_try_leaf(task, node);
        if (top == 0) break;
        at = later[--top];
    }
    return status;
}

tdsp_status leaves_push(disc_engine *engine, uint32_t ride, double from, double to, int *done)
{
    leave_task task;
    geom_ride motion = engine_ride_motion(engine, &engine->rides[ride], from, to);
    task_init(&task, engine, ride, engine->rides[ride].disc, done);
    wedge_of_chunk(&task.wedge, &motion, math_max(engine_true_time(engine, from), engine_true_time(engine, to)), engine->rate_max);
    tdsp_status status = engine->several.goals ? TDSP_OK : task_try_goal(&task, &engine->goal);
    if (status == TDSP_OK) status = neighbours_of_disc(engine->around, &engine->scene->allocator, task.self, &task.place);
    if (status != TDSP_OK || *done) return status;
    wedge_set_limit(&task.wedge, engine->question.goal, engine->limit + engine->several.spread);
    status = task_look_around(&task);
    return status == TDSP_OK && engine->several.goals ? task_try_goals(&task) : status;
}

tdsp_status leaves_push_start(disc_engine *engine, int *done)
{
    const geom_disc start = disc_point(engine->question.start);
    double time = engine->question.time, half_angle = GEOM_PI / SECTORS;
    const geom_ride motion = {&start, 1, 0.0, time, time};
    leave_task task;
    task_init(&task, engine, ENGINE_NONE, INDEX_NONE, done);
    wedge_of_sector(&task.wedge, &motion, 0.0, half_angle, engine_true_time(engine, time), engine->rate_max);
    geom_pair to_goal = pair_make(&start, &engine->goal);
    tdsp_status status = engine->several.goals ? TDSP_OK : task_try(&task, &to_goal, ENGINE_GOAL, 1, 1, 1);
    if (status == TDSP_OK) status = neighbours_of_point(engine->around, &engine->scene->allocator, start.center, &task.place);
    for (int i = 0; i < SECTORS && status == TDSP_OK && !*done; ++i) {
        wedge_of_sector(&task.wedge, &motion, angle_wrap((2 * i + 1) * half_angle), half_angle, engine_true_time(engine, time), engine->rate_max);
        wedge_set_limit(&task.wedge, engine->question.goal, engine->limit + engine->several.spread);
        status = task_look_around(&task);
        if (status == TDSP_OK && engine->several.goals) status = task_try_goals(&task);
    }
    return status;
}
