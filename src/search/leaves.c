/*
 * The legs that leave a chunk of a ride.
 *
 * While the rider turns by the angle of a chunk, its tangent ray sweeps a narrow wedge. Only discs that reach into the wedge can be
 * touched: seen from a place at distance D, the tangents to a disc stand asin(R / D) + asin(c) to either side of its centre, the second
 * term for its growth on the way (negative for a disc that shrinks). Nodes of the index are tested alike. Discs are visited nearest first, and what nearer ones hide is
 * left out (skyline.h).
 */
#include "geom/tangent.h"
#include "geom/tolerance.h"
#include "search/engine.h"
#include "search/skyline.h"

enum { LOOK_NODE = 0, LOOK_DISC = 1 };

/* What the chunk can see. */
typedef struct leave_wedge {
    disc_engine *engine;
    uint32_t ride;
    geom_ride motion; /* over the chunk */
    tdsp_point middle;
    tdsp_point heading;  /* in the middle */
    double middle_angle; /* the same, as an angle */
    double half_length;  /* of the chunk */
    double late;         /* the true time at which radii are largest */
    skyline sky;
    int *done;
} leave_wedge;

/* Where something stands in the wedge. */
typedef struct wedge_window {
    double from; /* directions, as angles from the middle heading */
    double to;
    double bound; /* no leg to it is shorter */
} wedge_window;

static void wedge_init(leave_wedge *wedge, disc_engine *engine, uint32_t ride, double from, double to, int *done)
{
    double half = 0.5 * (to - from);
    wedge->engine = engine;
    wedge->ride = ride;
    wedge->motion = engine_ride_motion(engine, &engine->rides[ride], from, to);
    double angle = ride_angle(&wedge->motion, from + half);
    const geom_disc *disc = wedge->motion.disc;
    wedge->middle = disc_boundary(disc, angle, from + half);
    wedge->middle_angle = disc_heading(disc, wedge->motion.side, angle);
    wedge->heading = point_unit(wedge->middle_angle);
    wedge->half_length = half;
    wedge->late = fmax(engine_true_time(engine, from), engine_true_time(engine, to));
    wedge->done = done;
    double first = wedge->motion.angle - angle, last = ride_angle(&wedge->motion, to) - angle;
    sky_init(&wedge->sky, fmin(first, last) - GEOM_ANGLE_START, fmax(first, last) + GEOM_ANGLE_START);
}

/* Is every path by way of something this far from the middle of the chunk and from the goal, of this radius at last, too late? */
static int wedge_too_late(const leave_wedge *wedge, double from_middle, double to_goal, double radius)
{
    return wedge->motion.start + from_middle + to_goal - wedge->half_length - 2.0 * radius > wedge->engine->limit;
}

/* An upper bound on asin(x) for 0 <= x <= 1, at most 0.2 above it: the difference vanishes at 0 and 1 only. */
static double asin_above(double x)
{
    return x + (0.5 * GEOM_PI - 1.0) * x * x * x;
}

/* The direction of (x, y) within DIRECTION_ERROR: a polynomial for the arc tangent. */
#define DIRECTION_ERROR 2e-4

static double direction_near(double y, double x)
{
    double ax = fabs(x), ay = fabs(y), low = ax < ay ? ax : ay, high = ax < ay ? ay : ax;
    double a = high > 0.0 ? low / high : 0.0, b = a * a;
    double angle = a * (0.99997726 + b * (-0.33262347 + b * (0.19354346 + b * (-0.11643287 + b * (0.05265332 - b * 0.01172120)))));
    if (ay > ax) angle = 0.5 * GEOM_PI - angle;
    if (x < 0.0) angle = GEOM_PI - angle;
    return y < 0.0 ? -angle : angle;
}

/*
 * The window of something within `reach` of a place, whose rate is at most `rate` either way, or a little more than it. Returns 0 when it is
 * not in the wedge, or hidden.
 */
static int wedge_sees(const leave_wedge *wedge, tdsp_point place, double reach, double rate, wedge_window *window)
{
    tdsp_point offset = point_sub(place, wedge->middle);
    double squared = point_dot(offset, offset), near = reach + wedge->half_length;
    window->from = -GEOM_TURN;
    window->to = GEOM_TURN;
    window->bound = 0.0;
    if (squared <= near * near || rate >= 1.0) return 1;
    double distance = sqrt(squared);
    double off = direction_near(point_cross(wedge->heading, offset), point_dot(wedge->heading, offset));
    double half = asin_above(near / distance) + asin_above(rate) + DIRECTION_ERROR;
    window->from = off - half;
    window->to = off + half;
    window->bound = (distance - near) / (1.0 + rate); /* a disc that shrinks only makes the leg longer */
    if (window->from < -GEOM_PI || window->to > GEOM_PI) return 1; /* it may reach round from behind */
    return window->to >= wedge->sky.from && window->from <= wedge->sky.to && !sky_hides_window(&wedge->sky, window->from, window->to);
}

static int wedge_sees_node(const leave_wedge *wedge, const index_node *node, wedge_window *window)
{
    const disc_engine *engine = wedge->engine;
    if (!wedge_sees(wedge, node->middle, index_node_reach(node, wedge->late) + node->half, node->rate, window)) return 0;
    if (isinf(engine->limit)) return 1;
    double last = index_node_reach(node, fmax(wedge->late, engine_true_time(engine, engine->limit)));
    double from_middle = index_node_distance(node, wedge->middle);
    return !wedge_too_late(wedge, from_middle, index_node_distance(node, engine->question.goal), last);
}

static int wedge_sees_disc(const leave_wedge *wedge, uint32_t k, wedge_window *window)
{
    const disc_engine *engine = wedge->engine;
    const geom_disc *disc = engine_disc(engine, k);
    if (!disc_ridable(disc) || k == engine->rides[wedge->ride].disc) return 0;
    double reach = fmax(disc_radius(disc, wedge->motion.start), disc_radius(disc, wedge->motion.end));
    if (!wedge_sees(wedge, disc->center, reach, fabs(disc->rate), window)) return 0;
    double last = fmax(reach, disc_radius(disc, engine->limit));
    double from_middle = point_distance(disc->center, wedge->middle);
    return !wedge_too_late(wedge, from_middle, point_distance(disc->center, engine->question.goal), last);
}

static double wedge_offset(const leave_wedge *wedge, double leave)
{
    double angle = ride_angle(&wedge->motion, leave);
    return disc_heading(wedge->motion.disc, wedge->motion.side, angle) - wedge->middle_angle;
}

static tdsp_status wedge_push(leave_wedge *wedge, const geom_tangent *tangent, uint32_t target, double leave)
{
    disc_engine *engine = wedge->engine;
    const geom_ride *motion = &wedge->motion;
    double normal = tangent_normal(tangent, ride_angle(motion, leave), leave);
    double heading = disc_heading(motion->disc, motion->side, normal);
    engine_leg leg = {wedge->ride, target, tangent->to_side, leave, normal, heading, tangent_length(tangent, leave), 0.0};
    if (sky_hides_leg(&wedge->sky, wedge_offset(wedge, leave), leg.length)) return TDSP_OK;
    if (target != ENGINE_GOAL) {
        double reached = heading - leg.side * tangent->to->theta;
        tdsp_point place = disc_boundary(tangent->to, reached, leg_arrival(&leg));
        leg.bound = point_distance(place, engine->question.goal);
    }
    return engine_push_leg(engine, &leg, wedge->done);
}

/*
 * Are the ride's disc and the other apart all the time? Then K^2 + w^2 <= (R_i + R_j)^2 < |D|^2: the second root has no legs, and every
 * leg of the first has a length.
 */
static int wedge_apart(const leave_wedge *wedge, const geom_pair *pair)
{
    const geom_ride *motion = &wedge->motion;
    double at_start = disc_radius(pair->from, motion->start) + disc_radius(pair->to, motion->start);
    double at_end = disc_radius(pair->from, motion->end) + disc_radius(pair->to, motion->end);
    return pair->distance > fmax(at_start, at_end) * (1.0 + GEOM_CONTACT);
}

/* Push the legs to one side of a target. *leave becomes the time of the first root's, or NaN. */
static tdsp_status wedge_try(leave_wedge *wedge, const geom_pair *pair, uint32_t target, int to_side, double *leave)
{
    const geom_ride *motion = &wedge->motion;
    int last = wedge_apart(wedge, pair) ? 1 : -1;
    tdsp_status status = TDSP_OK;
    *leave = NAN;
    for (int root = 1; root >= last && status == TDSP_OK && !*wedge->done; root -= 2) {
        double at;
        geom_tangent tangent = tangent_make(pair, motion->side, to_side, root);
        if (!tangent_possible(&tangent) || !tangent_leave(&tangent, motion->angle, motion->start, motion->end, &at)) continue;
        if (root > 0) *leave = at;
        status = wedge_push(wedge, &tangent, target, at);
    }
    return status;
}

/* Does the ray that leaves at this time run into the disc within the length? */
static int wedge_ray_hits(const leave_wedge *wedge, double leave, double length, const geom_disc *disc)
{
    const geom_ride *motion = &wedge->motion;
    double normal = ride_angle(motion, leave);
    geom_line ray = {disc_boundary(motion->disc, normal, leave), point_unit(disc_heading(motion->disc, motion->side, normal)), leave, length};
    return line_blocked(&ray, disc);
}

/*
 * The headings from which a disc stops the ray: from the time the rider's ray first touches it (the disc on the rider's own side) to the time it
 * leaves it (the other side). No ray reaches a disc later than a tangent does: the smaller root of the contact equation is at most the
 * geometric mean of both, which is the tangent's length sqrt(D^2 - R^2) / sin(theta).
 */
static void wedge_cover(leave_wedge *wedge, const geom_disc *disc, double enter, double leave)
{
    const geom_ride *motion = &wedge->motion;
    double from = isnan(enter) ? motion->start : enter, to = isnan(leave) ? motion->end : leave;
    double far = point_distance(disc->center, wedge->middle) + wedge->half_length;
    double radius = fmin(disc_radius(disc, motion->start), disc_radius(disc, motion->end));
    if (from >= to || far <= radius) return;
    double reach = sqrt((far - radius) * (far + radius)) / disc->sine;
    if (!wedge_ray_hits(wedge, 0.5 * (from + to), reach, disc)) return;
    double a = wedge_offset(wedge, from), b = wedge_offset(wedge, to);
    double first = isnan(enter) ? (a < b ? wedge->sky.from : wedge->sky.to) : a;
    double last = isnan(leave) ? (a < b ? wedge->sky.to : wedge->sky.from) : b;
    sky_add(&wedge->sky, fmin(first, last), fmax(first, last), reach);
}

static tdsp_status wedge_visit(leave_wedge *wedge, uint32_t k)
{
    const geom_disc *disc = engine_disc(wedge->engine, k);
    int side = wedge->motion.side;
    double enter, leave;
    geom_pair pair = pair_make(wedge->motion.disc, disc);
    tdsp_status status = wedge_try(wedge, &pair, k, side, &enter);
    if (status != TDSP_OK || *wedge->done) return status;
    status = wedge_try(wedge, &pair, k, -side, &leave);
    if (status == TDSP_OK && !*wedge->done && wedge_apart(wedge, &pair)) wedge_cover(wedge, disc, enter, leave);
    return status;
}

static tdsp_status wedge_look(leave_wedge *wedge, uint32_t id, uint32_t kind, double bound)
{
    disc_engine *engine = wedge->engine;
    tdsp_label label = {bound, id, kind};
    return heap_push(&engine->looks, &engine->scene->allocator, bound, label);
}

/* Put what a node holds, as far as it can be seen, among the things to look at. */
static tdsp_status wedge_open(leave_wedge *wedge, uint32_t self, double bound)
{
    const index_node *nodes = wedge->engine->view.index->nodes, *node = &nodes[self];
    wedge_window window;
    tdsp_status status = TDSP_OK;
    for (uint32_t k = node->first; k < node->first + node->count && status == TDSP_OK; ++k)
        if (wedge_sees_disc(wedge, k, &window)) status = wedge_look(wedge, k, LOOK_DISC, fmax(bound, window.bound));
    if (node->count) return status;
    const uint32_t children[2] = {self + 1, node->right};
    for (int i = 0; i < 2 && status == TDSP_OK; ++i)
        if (wedge_sees_node(wedge, &nodes[children[i]], &window))
            status = wedge_look(wedge, children[i], LOOK_NODE, fmax(bound, window.bound));
    return status;
}

tdsp_status leaves_push(disc_engine *engine, uint32_t ride, double from, double to, int *done)
{
    leave_wedge wedge;
    double ignored;
    wedge_init(&wedge, engine, ride, from, to, done);
    geom_pair to_goal = pair_make(wedge.motion.disc, &engine->goal);
    tdsp_status status = wedge_try(&wedge, &to_goal, ENGINE_GOAL, wedge.motion.side, &ignored);
    heap_clear(&engine->looks);
    if (status == TDSP_OK && engine->view.index->node_count) status = wedge_look(&wedge, 0, LOOK_NODE, 0.0);
    while (status == TDSP_OK && !*done && engine->looks.count > 0) {
        tdsp_label look = heap_pop(&engine->looks);
        if (!sky_advance(&wedge.sky, look.time)) break;
        status = look.kind == LOOK_NODE ? wedge_open(&wedge, look.id, look.time) : wedge_visit(&wedge, look.id);
    }
    return status;
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
    for (uint32_t k = 0; k < engine->set->count && status == TDSP_OK && !*done; ++k) {
        if (!disc_ridable(engine_disc(engine, k))) continue;
        status = start_push(engine, &start, k, 1, done);
        if (status == TDSP_OK && !*done) status = start_push(engine, &start, k, -1, done);
    }
    return status;
}
