/* The argument is in leave.h. */
#include "growth/leave.h"

/* Parts of a chunk that are looked at one by one, at most. */
#define MOST_PARTS 64

/* A function of a leg's parameter whose sign changes once. */
typedef struct leave_target {
    growth_engine *engine;
    const growth_chunk *chunk; /* NULL: from the start, the parameter is the angle from the centre's direction */
    uint32_t ride;
    uint32_t disc;
    const growth_shape *shape; /* NULL: the goal */
    tdsp_point place;          /* the centre, or the goal */
    uint32_t run;
    int side;
    double ahead; /* from the start: the centre's direction */
} leave_target;

static sight_line target_line(const leave_target *target, double at)
{
    const growth_chunk *chunk = target->chunk;
    if (chunk) {
        growth_moment moment = chunk_moment(chunk, at);
        return rider_leaves(chunk->shape, chunk->sign, chunk->ride, &moment);
    }
    const growth_question *question = &target->engine->question;
    sight_line line = {question->start, point_unit(target->ahead - target->side * at), question->time};
    return line;
}

/* e: positive where the place is to the left of the line. */
static double target_offset(const leave_target *target, const sight_line *line)
{
    return point_cross(line->unit, point_sub(target->place, line->from));
}

static sight_nearest target_nearest(const leave_target *target, const sight_line *line)
{
    return sight_pass(target->shape, target->engine->question.sign, line, target->run, line->start);
}

/* e, or m once a run is chosen. */
static double target_value(const leave_target *target, double at)
{
    sight_line line = target_line(target, at);
    return target->run == SHAPE_NONE ? target_offset(target, &line) : target_nearest(target, &line).value;
}

/* A root between two places with values of different sign: regula falsi with the Illinois weights, halving when that is slow. */
static double target_root(const leave_target *target, double a, double fa, double b, double fb)
{
    int last = 0;
    for (int step = 0; step < 200; ++step) {
        double width = b - a, at = step % 4 == 3 ? 0.5 * (a + b) : (a * fb - b * fa) / (fb - fa);
        if (!(at > a && at < b)) at = 0.5 * (a + b);
        if (!(at > a && at < b) || width <= 1e-16 * (fabs(a) + fabs(b))) break;
        double f = target_value(target, at);
        if (f == 0.0) return at;
        if ((f > 0.0) == (fa > 0.0)) {
            a = at;
            fa = f;
            if (last == 1) fb *= 0.5;
            last = 1;
        } else {
            b = at;
            fb = f;
            if (last == -1) fa *= 0.5;
            last = -1;
        }
    }
    return 0.5 * (a + b);
}

/* The angle between heading and normal with which the line meets the disc. */
static double landing_theta(const leave_target *target, const sight_line *line, double time)
{
    tdsp_point outwards = point_sub(sight_place(line, time), target->place);
    return atan2(target->side * point_cross(outwards, line->unit), point_dot(outwards, line->unit));
}

static tdsp_status target_push(const leave_target *target, double at, double arrive, const sight_nearest *nearest)
{
    growth_engine *engine = target->engine;
    growth_leg leg = {.ride = target->ride, .line = target_line(target, at), .arrive = arrive, .disc = target->disc, .run = target->run};
    leg.side = target->side;
    if (target->chunk) leg.leave = chunk_moment(target->chunk, at);
    if (!target->chunk) leg.leave.time = engine->question.time;
    leg.land.time = arrive;
    if (nearest) {
        leg.land.span = nearest->span;
        leg.land.in_fan = nearest->is_at_corner;
        leg.land.theta = landing_theta(target, &leg.line, arrive);
    }
    leg.bound = nearest ? point_distance(sight_place(&leg.line, arrive), engine->question.goal) : 0.0;
    return growth_push_leg(engine, &leg);
}

/* A tangent at a root of m, if it lies on the run and after the place of leaving. */
static tdsp_status push_tangent(const leave_target *target, double at)
{
    double sign = target->engine->question.sign;
    sight_line line = target_line(target, at);
    sight_nearest nearest = target_nearest(target, &line);
    int is_within = nearest.time > run_begins(target->shape, sign, target->run) && nearest.time < run_ends(target->shape, sign, target->run);
    return nearest.time > line.start && (is_within || nearest.is_at_corner) ? target_push(target, at, nearest.time, &nearest) : TDSP_OK;
}

/* The tangents to all runs of a disc on a part of the chunk on which e has one sign. */
static tdsp_status push_part(leave_target *target, double from, double to, int side)
{
    const growth_shape *shape = target->shape;
    const growth_engine *engine = target->engine;
    double sign = engine->question.sign, start = target->chunk ? chunk_moment(target->chunk, from).time : engine->question.time;
    tdsp_status status = TDSP_OK;
    target->side = side;
    for (uint32_t run = 0; run < shape->run_count && status == TDSP_OK; ++run) {
        int is_own = target->chunk && shape == target->chunk->shape && run == target->chunk->ride->run;
        if (is_own || run_ends(shape, sign, run) <= start || run_begins(shape, sign, run) > engine->limit) continue;
        target->run = run;
        double a = target_value(target, from), b = target_value(target, to);
        if ((a < 0.0) != (b < 0.0)) status = push_tangent(target, target_root(target, from, a, to, b));
    }
    target->run = SHAPE_NONE;
    return status;
}

/* Which side a rider who meets the disc on this line takes: the centre on the left is counter-clockwise. */
static int side_of(double offset)
{
    return offset > 0.0 ? 1 : -1;
}

static tdsp_status push_goal(leave_target *target, double at)
{
    sight_line line = target_line(target, at);
    double length = point_dot(point_sub(target->place, line.from), line.unit);
    return length >= 0.0 ? target_push(target, at, line.start + length, NULL) : TDSP_OK;
}

/* On a part too short to walk round the place. */
static tdsp_status leave_part(leave_target *target, double from, double to)
{
    double a = target_value(target, from), b = target_value(target, to), middle = to;
    int crosses = (a > 0.0) != (b > 0.0);
    if (crosses) middle = target_root(target, from, a, to, b);
    if (!target->shape) return crosses ? push_goal(target, middle) : TDSP_OK;
    tdsp_status status = push_part(target, from, middle, side_of(a));
    if (status == TDSP_OK && crosses) status = push_part(target, middle, to, side_of(b));
    return status;
}

/* How many parts of a chunk are each a third of the way to the place or less. */
static int parts_of(const leave_target *target)
{
    const growth_chunk *chunk = target->chunk;
    if (chunk->base.in_fan) return 1;
    double length = chunk->to - chunk->from, distance = point_distance(target_line(target, chunk->from).from, target->place) - length;
    if (distance * MOST_PARTS < 3.0 * length) return MOST_PARTS;
    return 1 + (int)(3.0 * length / distance);
}

static tdsp_status leave_for(leave_target *target)
{
    const growth_chunk *chunk = target->chunk;
    int parts = parts_of(target);
    tdsp_status status = TDSP_OK;
    double from = chunk->from, step = (chunk->to - chunk->from) / parts;
    for (int i = 1; i <= parts && status == TDSP_OK; ++i) {
        double to = i == parts ? chunk->to : chunk->from + step * i;
        status = leave_part(target, from, to);
        from = to;
    }
    return status;
}

tdsp_status leave_chunk(growth_engine *engine, const growth_chunk *chunk, uint32_t ride)
{
    leave_target goal = {engine, chunk, ride, GROWTH_GOAL, NULL, engine->question.goal, SHAPE_NONE, 0, 0.0};
    tdsp_status status = leave_for(&goal);
    for (uint32_t i = 0; i < engine->member_count && status == TDSP_OK; ++i) {
        uint32_t disc = engine->members[i];
        const growth_shape *shape = engine_shape(engine, disc);
        if (shape == chunk->shape && shape->run_count == 1) continue;
        leave_target target = {engine, chunk, ride, disc, shape, shape->center, SHAPE_NONE, 0, 0.0};
        status = leave_for(&target);
    }
    return status;
}

/* From the start: straight at the centre a line runs into the disc, straight away from it misses it. */
static tdsp_status start_for(leave_target *target)
{
    tdsp_point to = point_sub(target->place, target->engine->question.start);
    target->ahead = atan2(to.y, to.x);
    tdsp_status status = push_part(target, 0.0, GEOM_PI, 1);
    return status == TDSP_OK ? push_part(target, 0.0, GEOM_PI, -1) : status;
}

tdsp_status leave_start(growth_engine *engine)
{
    const growth_question *question = &engine->question;
    tdsp_point way = point_sub(question->goal, question->start);
    leave_target goal = {engine, NULL, GROWTH_NONE, GROWTH_GOAL, NULL, question->goal, SHAPE_NONE, 0, atan2(way.y, way.x)};
    tdsp_status status = target_push(&goal, 0.0, question->time + point_length(way), NULL);
    for (uint32_t i = 0; i < engine->member_count && status == TDSP_OK; ++i) {
        uint32_t disc = engine->members[i];
        const growth_shape *shape = engine_shape(engine, disc);
        leave_target target = {engine, NULL, GROWTH_NONE, disc, shape, shape->center, SHAPE_NONE, 0, 0.0};
        status = start_for(&target);
    }
    return status;
}
