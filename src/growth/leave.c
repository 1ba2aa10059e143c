/* SPDX-License-Identifier: MIT */
/* The argument is in leave.h. */
#include "growth/leave.h"

#include "geom/tolerance.h"
#include "growth/ahead.h"

/* Parts of a chunk that are looked at one by one, at most. */
#define MOST_PARTS 64

/* F of a line that touches, relative to the distance of the centre; and of one that misses by so much that no tangent is near, relative to its square. */
#define GRAZE_VALUE 1e-15
#define GRAZE_FAR 0.25
#define GRAZE_STEPS 8

/* So near to a place where F is 0 another one is no other. */
#define MOST_HALVINGS 40

/* F that rounding may make of 0. */
#define TOUCH_VALUE 1e-15

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
    double reach; /* the largest radius that can be met; no goal is as far off as 0 */
    const sight_line *ends; /* the lines at both ends of the chunk */
} leave_target;

static sight_line target_line(const leave_target *target, double at)
{
    const growth_chunk *chunk = target->chunk;
    if (chunk) {
        if (at == chunk->from) return target->ends[0];
        if (at == chunk->to) return target->ends[1];
        growth_moment moment = chunk_moment(chunk, at);
        return rider_leaves(chunk->shape, chunk->sign, chunk->ride, &moment);
    }
    const growth_question *question = &target->engine->question;
    const double turn = at < GEOM_PI ? target->side * at : GEOM_PI; /* straight away both sides are one line, to the bit */
    sight_line line = {question->start, point_unit(target->ahead - turn), question->time};
    return line;
}

/* e: positive where the place is to the left of the line. */
static double target_offset(const leave_target *target, const sight_line *line)
{
    return point_cross(line->unit, point_sub(target->place, line->from));
}

static sight_nearest target_nearest(const leave_target *target, const sight_line *line, int is_precise)
{
    return sight_pass(target->shape, target->engine->question.sign, line, target->run, line->start, is_precise);
}

/* e, or m once a run is chosen. */
static double target_value(const leave_target *target, double at)
{
    sight_line line = target_line(target, at);
    return target->run == SHAPE_NONE ? target_offset(target, &line) : target_nearest(target, &line, 0).value;
}

/*
 * Whoever starts on both boundaries has a value of 0 there, and may have another root behind it: the first place on the way back to `a`, halving, whose value has the other sign than
 * that at *b, which becomes the place before. `a` where there is none.
 */
static double root_behind_zero(const leave_target *target, double a, double *b, double *fb, double *value)
{
    for (int step = 0; step < MOST_HALVINGS; ++step) {
        double at = 0.5 * (a + *b);
        if (!(at > a && at < *b)) break;
        *value = target_value(target, at);
        if (*value != 0.0 && (*value > 0.0) != (*fb > 0.0)) return at;
        *b = at;
        *fb = *value;
        if (*value == 0.0) break;
    }
    return a;
}

/* A root between two places with values of different sign, or where the value is small enough: regula falsi with the Illinois weights, halving when that is slow. */
static double target_root(const leave_target *target, double a, double fa, double b, double fb, double enough)
{
    int last = 0;
    if (fb == 0.0) return b;
    if (fa == 0.0) {
        double zero = a;
        a = root_behind_zero(target, zero, &b, &fb, &fa);
        if (a == zero) return zero;
    }
    for (int step = 0; step < 200; ++step) {
        double width = b - a, at = step % 4 == 3 ? 0.5 * (a + b) : (a * fb - b * fa) / (fb - fa);
        if (!(at > a && at < b)) at = 0.5 * (a + b);
        if (!(at > a && at < b) || width <= 1e-16 * (fabs(a) + fabs(b))) break;
        double f = target_value(target, at);
        if (fabs(f) <= enough) return at;
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
static double landing_theta(tdsp_point center, int side, const sight_line *line, double time)
{
    tdsp_point outwards = point_sub(sight_place(line, time), center);
    return math_atan2(side * point_cross(outwards, line->unit), point_dot(outwards, line->unit));
}

/* The disc's radius as the line comes as far as its centre, or as the run ends. */
static double radius_ahead(const leave_target *target, const sight_line *line, double distance)
{
    const double sign = target->engine->question.sign;
    return shape_radius(target->shape, sign * math_min(line->start + distance, run_ends(target->shape, sign, target->run)));
}

/* A line from there that touches the disc as it will be, if the disc does not reach as far; 0 where it does. */
static int line_aim(const leave_target *target, sight_line *line)
{
    tdsp_point to = point_sub(target->place, line->from);
    double distance = point_length(to), radius = radius_ahead(target, line, distance);
    if (radius >= distance) return 0;
    line->unit = point_unit(math_atan2(to.y, to.x) - target->side * math_asin(radius / distance));
    return 1;
}

/*
 * Where an ulp of time turns the ride by much, as on a pebble late in time, the heading of a root is not that of the tangent: it is turned about the place of leaving until the line touches
 * the disc. F changes with that turn as the distance travelled does across the line. A line that misses the disc by far is aimed at it first.
 */
static void line_graze(const leave_target *target, sight_line *line, sight_nearest *nearest)
{
    int is_aimed = 0;
    for (int step = 0; step < GRAZE_STEPS; ++step) {
        tdsp_point out = point_sub(sight_place(line, nearest->time), target->place);
        double distance = point_length(out), miss = fabs(nearest->value);
        if (miss <= GRAZE_VALUE * distance) return;
        sight_line better = *line;
        int is_far = !(miss <= GRAZE_FAR * distance * distance);
        if (is_far && (is_aimed || !line_aim(target, &better))) return;
        if (!is_far) {
            double turn = -nearest->value / (2.0 * (nearest->time - line->start) * point_cross(line->unit, out));
            better.unit = point_unit(math_atan2(line->unit.y, line->unit.x) + turn);
        }
        sight_nearest touch = target_nearest(target, &better, 1);
        if (!is_far && !(fabs(touch.value) < miss)) return;
        *line = better;
        *nearest = touch;
        is_aimed |= is_far;
    }
}

/* Does it touch, as far as places are known? A run that begins may find the line already past the disc. */
static int line_touches(const leave_target *target, const sight_line *line, const sight_nearest *nearest)
{
    double distance = point_distance(sight_place(line, nearest->time), target->place), radius = shape_radius(target->shape, target->engine->question.sign * nearest->time);
    return fabs(nearest->value) <= tolerance_touch(target->place, distance + radius) * (distance + radius);
}

static tdsp_status target_push(const leave_target *target, double at, const sight_line *line, double arrive, const sight_nearest *nearest)
{
    growth_engine *engine = target->engine;
    growth_leg leg = {.ride = target->ride, .line = *line, .arrive = arrive, .disc = target->disc, .run = target->run};
    leg.side = target->side;
    if (target->chunk) leg.leave = chunk_moment(target->chunk, at);
    if (!target->chunk) leg.leave.time = engine->question.time;
    leg.land.time = arrive;
    if (nearest) {
        leg.land.span = nearest->span;
        leg.land.in_fan = nearest->is_at_corner;
        leg.land.theta = landing_theta(target->place, target->side, &leg.line, arrive);
    }
    leg.bound = nearest ? point_distance(sight_place(&leg.line, arrive), engine->question.goal) : 0.0;
    return growth_push_leg(engine, &leg);
}

/* A tangent on a line that leaves there, if it lies on the run and after the place of leaving. */
static tdsp_status push_line(const leave_target *target, double at, sight_line *line)
{
    double sign = target->engine->question.sign;
    sight_nearest nearest = target_nearest(target, line, 1);
    if (target->chunk) line_graze(target, line, &nearest);
    if (target->chunk && !line_touches(target, line, &nearest)) return TDSP_OK;
    /* A run may begin where its rate falls to the robot's speed: whoever is caught there, from right behind, rides on. */
    int is_within = nearest.time >= run_begins(target->shape, sign, target->run) && nearest.time < run_ends(target->shape, sign, target->run);
    return nearest.time > line->start && (is_within || nearest.is_at_corner) ? target_push(target, at, line, nearest.time, &nearest) : TDSP_OK;
}

/* At a root of m. */
static tdsp_status push_tangent(const leave_target *target, double at)
{
    sight_line line = target_line(target, at);
    return push_line(target, at, &line);
}

/*
 * Both tangents where the rider's heading passes the whole disc within the rounding of a time, from one pebble to another: they are aimed from there, each to its side.
 */
static tdsp_status push_narrow(leave_target *target, double at)
{
    sight_line line = target_line(target, at);
    tdsp_status status = TDSP_OK;
    if (fabs(target_offset(target, &line)) < 0.5 * radius_ahead(target, &line, point_distance(line.from, target->place))) return TDSP_OK;
    for (int side = -1; side <= 1 && status == TDSP_OK; side += 2) {
        target->side = side;
        if (line_aim(target, &line)) status = push_line(target, at, &line);
    }
    return status;
}

/* Can a run of the disc be met by whoever leaves from here on? Not the one that is ridden. */
static int run_matters(const leave_target *target, uint32_t run, double start)
{
    const growth_engine *engine = target->engine;
    double sign = engine->question.sign;
    if (target->chunk && target->shape == target->chunk->shape && run == target->chunk->ride->run) return 0;
    return run_ends(target->shape, sign, run) > start && run_begins(target->shape, sign, run) <= engine->limit;
}

/* The tangent between two places whose m have different signs. */
static tdsp_status push_between(leave_target *target, double from, double a, double to, double b, int side)
{
    target->side = side;
    return push_tangent(target, target_root(target, from, a, to, b, 0.0));
}

/* The tangents to all runs of a disc on a part of the chunk on which e has one sign. */
static tdsp_status push_part(leave_target *target, double from, double to, int side)
{
    double start = target->chunk ? chunk_moment(target->chunk, from).time : target->engine->question.time;
    tdsp_status status = TDSP_OK;
    target->side = side;
    for (uint32_t run = 0; run < target->shape->run_count && status == TDSP_OK; ++run) {
        if (!run_matters(target, run, start)) continue;
        target->run = run;
        double a = target_value(target, from), b = target_value(target, to);
        /* Straight away from the centre both sides are one line, and rounding must not tell them apart: whom a disc just catches from behind it catches for both. */
        if (!target->chunk && b < 0.0 && b > -TOUCH_VALUE) b = 0.0;
        /* Who starts to ride on both boundaries, as where discs touch from inside at the source, may be between them for a while first: see root_behind_zero(). */
        if (target->chunk && b < 0.0 && a < 0.0 && a > -TOUCH_VALUE) a = 0.0;
        if ((a < 0.0) != (b < 0.0)) status = push_between(target, from, a, to, b, side);
    }
    target->run = SHAPE_NONE;
    return status;
}

/* Which side a rider who meets the disc on this line takes: the centre on the left is counter-clockwise. */
static int side_of(double offset)
{
    return offset > 0.0 ? 1 : -1;
}

/* To the goal itself, by the line from there: the heading of a root is not exact, as in line_graze(). */
static tdsp_status push_aimed(const leave_target *target, double at, sight_line line)
{
    tdsp_point way = point_sub(target->place, line.from);
    double length = point_length(way);
    if (length > 0.0) line.unit = point_scale(1.0 / length, way);
    return target_push(target, at, &line, line.start + length, NULL);
}

static tdsp_status push_goal(const leave_target *target, double at)
{
    sight_line line = target_line(target, at);
    return point_dot(point_sub(target->place, line.from), line.unit) >= 0.0 ? push_aimed(target, at, line) : TDSP_OK;
}

/* Where e is 0, or near enough to run into the disc. */
static double centre_of(leave_target *target, double from, double a, double to, double b, double enough)
{
    uint32_t run = target->run;
    target->run = SHAPE_NONE;
    double middle = target_root(target, from, a, to, b, enough);
    target->run = run;
    return middle;
}

/*
 * The tangents on a part on which e changes its sign, from a to b: m falls towards that place and rises after it, so that one end below 0 leaves one root at most. With both
 * above there are two if m is below 0 in between.
 */
static tdsp_status push_across(leave_target *target, double from, double a, double to, double b)
{
    double start = chunk_moment(target->chunk, from).time, near = 0.25 * shape_radius(target->shape, target->engine->question.sign * start);
    tdsp_status status = TDSP_OK;
    for (uint32_t run = 0; run < target->shape->run_count && status == TDSP_OK; ++run) {
        if (!run_matters(target, run, start)) continue;
        target->run = run;
        double first = target_value(target, from), last = target_value(target, to);
        if (first < 0.0 && last < 0.0) continue;
        if (first < 0.0 || last < 0.0) {
            status = push_between(target, from, first, to, last, side_of(first < 0.0 ? b : a));
            continue;
        }
        double middle = centre_of(target, from, a, to, b, near), least = target_value(target, middle);
        if (!(least < 0.0)) {
            middle = centre_of(target, from, a, to, b, 0.0);
            least = target_value(target, middle);
        }
        if (!(least < 0.0)) {
            status = push_narrow(target, middle);
            continue;
        }
        status = push_between(target, from, first, middle, least, side_of(a));
        if (status == TDSP_OK) status = push_between(target, middle, least, to, last, side_of(b));
    }
    target->run = SHAPE_NONE;
    return status;
}

/* On a part too short to walk round the place. */
static tdsp_status leave_part(leave_target *target, double from, double to)
{
    double a = target_value(target, from), b = target_value(target, to);
    int crosses = (a > 0.0) != (b > 0.0);
    if (!target->shape) return crosses ? push_goal(target, target_root(target, from, a, to, b, 0.0)) : TDSP_OK;
    if (crosses) return push_across(target, from, a, to, b);
    return math_min(fabs(a), fabs(b)) > target->reach ? TDSP_OK : push_part(target, from, to, side_of(a)); /* in between it is farther off still */
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

/*
 * A place closer to the boundary than parts are short has both its tangents in one of them: one before the rider passes in front of it, one after. There e is of the
 * other sign, so that is where the part is cut.
 */
static tdsp_status leave_part_cut(leave_target *target, double from, double to, double cut)
{
    if (!(cut > from && cut < to)) return leave_part(target, from, to);
    tdsp_status status = leave_part(target, from, cut);
    return status == TDSP_OK ? leave_part(target, cut, to) : status;
}

static tdsp_status leave_for(leave_target *target)
{
    const growth_chunk *chunk = target->chunk;
    int parts = parts_of(target);
    tdsp_status status = TDSP_OK;
    double from = chunk->from, step = (chunk->to - chunk->from) / parts, cut = from;
    if (parts == MOST_PARTS && !rider_passes(chunk, target->place, &cut)) cut = from;
    for (int i = 1; i <= parts && status == TDSP_OK; ++i) {
        double to = i == parts ? chunk->to : chunk->from + step * i;
        status = leave_part_cut(target, from, to, cut);
        from = to;
    }
    return status;
}

/* A goal on the boundary itself is ridden onto: there e touches 0 and keeps its sign. */
static tdsp_status leave_onto_goal(const leave_target *goal)
{
    const growth_chunk *chunk = goal->chunk;
    double at;
    if (!rider_passes(chunk, goal->place, &at)) return TDSP_OK;
    growth_moment moment = chunk_moment(chunk, at);
    double length = point_distance(rider_place(chunk->shape, chunk->sign, chunk->ride, &moment), goal->place);
    double distance = point_distance(goal->place, chunk->shape->center);
    double touch = GEOM_CONTACT * (1.0 + distance) + GEOM_TIME * fabs(moment.time);
    return length <= touch ? push_aimed(goal, at, target_line(goal, at)) : TDSP_OK;
}

/* To what is ahead, nearest first, as far as it is not hidden. Who asks why there is no path wants to see all that stops a robot. */
static tdsp_status leave_ahead(growth_engine *engine, ahead_view *view, uint32_t ride)
{
    const growth_chunk *chunk = view->chunk;
    tdsp_status status = ahead_list(engine, view);
    for (size_t i = 0; i < engine->ahead_count && status == TDSP_OK; ++i) {
        const growth_ahead *ahead = &engine->ahead[i];
        uint32_t disc = engine->reach.given[ahead->place];
        const growth_shape *shape = engine_shape(engine, disc);
        int ends = ahead_ends(view, ahead);
        if (!engine->question.explain && (ends || ahead_hides(view, ahead))) {
            engine->latest = math_max(engine->latest, view->last + ahead->nearest);
            if (ends) break;
            continue;
        }
        leave_target target = {engine, chunk, ride, disc, shape, shape->center, SHAPE_NONE, 0, 0.0, engine->reach.largest[ahead->place], view->ends};
        if (shape != chunk->shape || shape->run_count > 1) status = leave_for(&target);
        if (shape != chunk->shape) ahead_cover(view, ahead, shape);
    }
    return status;
}

tdsp_status leave_chunk(growth_engine *engine, const growth_chunk *chunk, uint32_t ride)
{
    growth_moment first = chunk_moment(chunk, chunk->from), last = chunk_moment(chunk, chunk->to);
    const sight_line ends[2] = {rider_leaves(chunk->shape, chunk->sign, chunk->ride, &first), rider_leaves(chunk->shape, chunk->sign, chunk->ride, &last)};
    ahead_view view = ahead_look(chunk, ends);
    leave_target goal = {engine, chunk, ride, GROWTH_GOAL, NULL, engine->question.goal, SHAPE_NONE, 0, 0.0, 0.0, ends};
    tdsp_status status = leave_for(&goal);
    if (status == TDSP_OK) status = leave_onto_goal(&goal);
    return status == TDSP_OK ? leave_ahead(engine, &view, ride) : status;
}

tdsp_status leave_touch(growth_engine *engine, const growth_chunk *chunk, uint32_t ride, const ride_change *change)
{
    const growth_shape *shape = engine_shape(engine, change->disc);
    growth_moment moment = chunk_moment(chunk, change->at);
    sight_line line = rider_leaves(chunk->shape, chunk->sign, chunk->ride, &moment);
    growth_leg leg = {.ride = ride, .leave = moment, .line = line, .arrive = moment.time, .disc = change->disc, .run = shape->spans[change->span].run};
    leg.side = side_of(point_cross(line.unit, point_sub(shape->center, line.from)));
    leg.land.span = change->span;
    leg.land.in_fan = change->is_at_corner;
    leg.land.time = moment.time;
    leg.land.theta = landing_theta(shape->center, leg.side, &line, moment.time);
    leg.bound = point_distance(line.from, engine->question.goal);
    return leg.run == SHAPE_NONE || leg.side == chunk->ride->side ? TDSP_OK : growth_push_leg(engine, &leg);
}

/* From the start: straight at the centre a line runs into the disc, straight away from it misses it. */
static tdsp_status start_for(leave_target *target)
{
    tdsp_point to = point_sub(target->place, target->engine->question.start);
    target->ahead = math_atan2(to.y, to.x);
    tdsp_status status = push_part(target, 0.0, GEOM_PI, 1);
    return status == TDSP_OK ? push_part(target, 0.0, GEOM_PI, -1) : status;
}

tdsp_status leave_start(growth_engine *engine)
{
    const growth_question *question = &engine->question;
    tdsp_point way = point_sub(question->goal, question->start);
    leave_target goal = {engine, NULL, GROWTH_NONE, GROWTH_GOAL, NULL, question->goal, SHAPE_NONE, 0, math_atan2(way.y, way.x), 0.0, NULL};
    tdsp_status status = push_aimed(&goal, 0.0, target_line(&goal, 0.0));
    for (uint32_t i = 0; i < engine->reach.count && status == TDSP_OK; ++i) {
        uint32_t disc = engine->reach.given[i];
        const growth_shape *shape = engine_shape(engine, disc);
        if (ahead_is_too_late(engine, question->start, question->time, shape->center, engine->reach.largest[i])) continue;
        leave_target target = {engine, NULL, GROWTH_NONE, disc, shape, shape->center, SHAPE_NONE, 0, 0.0, INFINITY, NULL};
        status = start_for(&target);
    }
    return status;
}
