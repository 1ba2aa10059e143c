/*
 * The legs that leave a chunk of a ride.
 *
 * While the rider turns by the angle of a chunk, its tangent ray sweeps a narrow wedge. Only discs that reach into the wedge can be
 * touched: seen from a place at distance D, a disc fills the half angle asin(R / D) + asin(c) around its centre, the second
 * term for its growth on the way. Nodes of the index are tested alike.
 */
#include "geom/tangent.h"
#include "search/engine.h"

/* What the chunk can see. */
typedef struct leave_wedge {
    disc_engine *engine;
    uint32_t ride;
    geom_ride motion; /* over the chunk */
    tdsp_point middle;
    tdsp_point heading; /* in the middle */
    double half_angle;  /* by which the heading swings to either side */
    double half_length; /* of the chunk */
    double late;        /* the true time at which radii are largest */
    tdsp_status status;
    int *done;
} leave_wedge;

static leave_wedge wedge_make(disc_engine *engine, uint32_t ride, double from, double to, int *done)
{
    leave_wedge wedge = {engine, ride, engine_ride_motion(engine, &engine->rides[ride], from, to), {0, 0}, {0, 0}, 0, 0, 0, TDSP_OK, done};
    double half = 0.5 * (to - from), angle = ride_angle(&wedge.motion, from + half);
    const geom_disc *disc = wedge.motion.disc;
    wedge.middle = disc_boundary(disc, angle, from + half);
    wedge.heading = point_unit(disc_heading(disc, wedge.motion.side, angle));
    wedge.half_angle = fabs(ride_angle(&wedge.motion, to) - wedge.motion.angle) + 1e-6;
    wedge.half_length = half;
    wedge.late = fmax(engine_true_time(engine, from), engine_true_time(engine, to));
    return wedge;
}

/* Can something within `reach` of a place, growing at `rate`, touch the wedge? */
static int wedge_sees(const leave_wedge *wedge, tdsp_point place, double reach, double rate)
{
    tdsp_point offset = point_sub(place, wedge->middle);
    double distance = point_length(offset), near = reach + wedge->half_length;
    if (distance <= near || rate >= 1.0) return 1;
    double off = atan2(fabs(point_cross(wedge->heading, offset)), point_dot(wedge->heading, offset));
    return off <= wedge->half_angle + asin(near / distance) + asin(rate);
}

static int wedge_sees_node(const leave_wedge *wedge, const index_node *node)
{
    const disc_engine *engine = wedge->engine;
    double half_x = 0.5 * (node->max_x - node->min_x), half_y = 0.5 * (node->max_y - node->min_y);
    tdsp_point middle = point_make(node->min_x + half_x, node->min_y + half_y);
    double reach = index_node_reach(node, wedge->late);
    if (isfinite(engine->limit)) {
        double last = index_node_reach(node, fmax(wedge->late, engine_true_time(engine, engine->limit)));
        double way = index_node_distance(node, wedge->middle) + index_node_distance(node, engine->question.goal);
        if (wedge->motion.start + way - wedge->half_length - 2.0 * last > engine->limit) return 0;
    }
    double rate = engine->question.direction == ENGINE_FORWARD ? node->rate : -node->rate_min;
    return wedge_sees(wedge, middle, reach + sqrt(half_x * half_x + half_y * half_y), rate);
}

static void wedge_push(leave_wedge *wedge, const geom_tangent *tangent, uint32_t target, double leave)
{
    disc_engine *engine = wedge->engine;
    const geom_ride *motion = &wedge->motion;
    double normal = ride_angle(motion, leave), heading = disc_heading(motion->disc, motion->side, normal);
    engine_leg leg = {wedge->ride, target, tangent->to_side, leave, normal, heading, tangent_length(tangent, leave), 0.0};
    if (target != ENGINE_GOAL) {
        double reached = heading - leg.side * tangent->to->theta;
        tdsp_point place = disc_boundary(tangent->to, reached, leg_arrival(&leg));
        leg.bound = point_distance(place, engine->question.goal);
    }
    wedge->status = engine_push_leg(engine, &leg, wedge->done);
}

static void wedge_try(leave_wedge *wedge, const geom_pair *pair, uint32_t target, int to_side)
{
    const geom_ride *motion = &wedge->motion;
    for (int root = 1; root >= -1 && wedge->status == TDSP_OK && !*wedge->done; root -= 2) {
        double leave;
        geom_tangent tangent = tangent_make(pair, motion->side, to_side, root);
        if (tangent_possible(&tangent) && tangent_leave(&tangent, motion->angle, motion->start, motion->end, &leave))
            wedge_push(wedge, &tangent, target, leave);
    }
}

static void wedge_visit(leave_wedge *wedge, uint32_t k)
{
    const geom_disc *disc = engine_disc(wedge->engine, k);
    if (!disc_ridable(disc) || k == wedge->engine->rides[wedge->ride].disc) return;
    double reach = fmax(disc_radius(disc, wedge->motion.start), disc_radius(disc, wedge->motion.end));
    if (!wedge_sees(wedge, disc->center, reach, disc->rate)) return;
    geom_pair pair = pair_make(wedge->motion.disc, disc);
    wedge_try(wedge, &pair, k, 1);
    wedge_try(wedge, &pair, k, -1);
}

tdsp_status leaves_push(disc_engine *engine, uint32_t ride, double from, double to, int *done)
{
    leave_wedge wedge = wedge_make(engine, ride, from, to, done);
    geom_pair to_goal = pair_make(wedge.motion.disc, &engine->goal);
    wedge_try(&wedge, &to_goal, ENGINE_GOAL, wedge.motion.side);
    const scene_index *index = engine->view.index;
    uint32_t later[INDEX_DEPTH], next = index->node_count ? 0 : INDEX_NONE;
    int top = 0;
    while (next != INDEX_NONE && wedge.status == TDSP_OK && !*done) {
        const index_node *node = &index->nodes[next];
        if (wedge_sees_node(&wedge, node)) {
            for (uint32_t k = node->first; k < node->first + node->count; ++k) wedge_visit(&wedge, k);
            if (!node->count) {
                later[top++] = node->right;
                ++next;
                continue;
            }
        }
        next = top ? later[--top] : INDEX_NONE;
    }
    return wedge.status;
}

/* A leg from the start: the start is a disc of radius 0, on which any angle will do. */
static tdsp_status start_push(disc_engine *engine, const geom_disc *start, uint32_t target, int side, int *done)
{
    const geom_disc *disc = target == ENGINE_GOAL ? &engine->goal : engine_disc(engine, target);
    double time = engine->question.time;
    geom_pair pair = pair_make(start, disc);
    geom_tangent tangent = tangent_make(&pair, side, side, 1);
    engine_leg leg = {ENGINE_NONE, target, side, time, 0.0, tangent_heading(&tangent, time), tangent_length(&tangent, time), 0.0};
    if (pair.distance == 0.0 && target != ENGINE_GOAL) return TDSP_OK;
    if (target != ENGINE_GOAL) {
        tdsp_point place = disc_boundary(disc, leg.heading - side * disc->theta, leg_arrival(&leg));
        leg.bound = point_distance(place, engine->question.goal);
    }
    return engine_push_leg(engine, &leg, done);
}

tdsp_status leaves_push_start(disc_engine *engine, int *done)
{
    geom_disc start = disc_point(engine->question.start);
    tdsp_status status = start_push(engine, &start, ENGINE_GOAL, 1, done);
    for (uint32_t k = 0; k < engine->scene->active && status == TDSP_OK && !*done; ++k) {
        if (!disc_ridable(engine_disc(engine, k))) continue;
        status = start_push(engine, &start, k, 1, done);
        if (status == TDSP_OK && !*done) status = start_push(engine, &start, k, -1, done);
    }
    return status;
}
