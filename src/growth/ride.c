/* SPDX-License-Identifier: MIT */
/* The bound is in ride.h. */
#include "growth/ride.h"

#include "geom/tolerance.h"

/* How much of a touch may be rounding. */
#define TOUCH_SAME 1e-3

/* A touch of the disc ridden, and a little more: no deeper in another begins who came over from there. */
#define GRACE 1.25

/* Parts of one chunk against one disc after which a touch is taken to be none: a boundary that is followed for a while. */
#define MOST_LOOKS 3000

#define STACK 64

typedef struct ride_sample {
    double at;        /* the time */
    tdsp_point place; /* from the other's centre */
    double radius;    /* of the other */
    double heading;
} ride_sample;

typedef struct ride_pass {
    const growth_chunk *chunk;
    const growth_shape *other;
    uint32_t span; /* of the other */
    double grace;  /* touches that are forgiven besides one */
    double least;  /* the least clearance seen, in touches, */
    double before, after; /* ... between these */
    double floor;         /* none is less, seen or not */
} ride_pass;

static ride_sample sample_at(const ride_pass *pass, double at)
{
    const growth_chunk *chunk = pass->chunk;
    growth_moment moment = chunk_moment(chunk, at);
    ride_sample sample = {moment.time, rider_place(chunk->shape, chunk->sign, chunk->ride, &moment), 0.0, 0.0};
    sample.place = point_sub(sample.place, pass->other->center);
    sample.radius = shape_jet(pass->other, pass->span, chunk->sign * moment.time).radius;
    sample.heading = rider_heading(chunk->shape, chunk->sign, chunk->ride, &moment);
    return sample;
}

static double touch_of(const ride_pass *pass, const ride_sample *sample, double distance)
{
    double sizes = sample->radius + distance;
    return sample->radius <= SHAPE_LEAST_RIDE ? -sizes : -tolerance_touch(pass->other->center, sizes);
}

/* How far outside, in touches: below -1 it is no touch any more. */
static double sample_clearance(const ride_pass *pass, const ride_sample *sample)
{
    double distance = point_length(sample->place);
    return (sample->radius - distance) / touch_of(pass, sample, distance);
}

static int is_inside(const ride_pass *pass, const ride_sample *sample)
{
    return sample_clearance(pass, sample) < -1.0 - pass->grace;
}

/* How fast it comes out of the other. */
static double sample_slope(const ride_pass *pass, const ride_sample *sample)
{
    double outwards = point_dot(point_unit(sample->heading), sample->place) / point_length(sample->place);
    return outwards - sight_rate(pass->other, pass->chunk->sign, pass->span, sample->at);
}

static void pass_notes(ride_pass *pass, const ride_sample *sample, double before, double after)
{
    double clearance = sample_clearance(pass, sample);
    if (!(clearance < pass->least)) return;
    pass->least = clearance;
    pass->before = before;
    pass->after = after;
}

/* The greatest |R''| on a part of the other's span. */
static double bend_bound(const ride_pass *pass, double a, double b)
{
    const law_piece *piece = &pass->other->pieces[pass->other->spans[pass->span].piece];
    double sign = pass->chunk->sign, reach = math_max(fabs(sign * a - piece->start), fabs(sign * b - piece->start)), sum = 0.0, power = 1.0;
    for (uint32_t k = 2; k <= piece->degree; ++k) {
        sum += k * (k - 1) * fabs(piece->c[k]) * power;
        power *= reach;
    }
    return sum;
}

/* No clearance on the part is less, in touches. */
static double part_least(const ride_pass *pass, const ride_sample *a, const ride_sample *b)
{
    double width = b->at - a->at, turn = fabs(b->heading - a->heading);
    tdsp_point middle = point_scale(0.5, point_add(a->place, b->place));
    double distance = point_length(middle);
    if (!(distance > 0.0)) return -INFINITY;
    double from = point_dot(a->place, middle) / distance - a->radius, to = point_dot(b->place, middle) / distance - b->radius;
    tdsp_point half = point_unit(0.5 * turn);
    double sag = 0.5 * width * (half.y / half.x) + bend_bound(pass, a->at, b->at) * width * width / 8.0;
    return (sag - math_min(from, to)) / touch_of(pass, b->radius > a->radius ? b : a, distance);
}

/* Around one centre only the radii count; they cross where their difference does. */
static int is_concentric(const ride_pass *pass)
{
    return point_distance(pass->chunk->shape->center, pass->other->center) < 1e-14;
}

static double first_inside(const ride_pass *pass, double low, double high)
{
    for (int step = 0; step < 60; ++step) {
        double middle = 0.5 * (low + high);
        ride_sample sample = sample_at(pass, middle);
        if (is_inside(pass, &sample))
            high = middle;
        else
            low = middle;
    }
    return low;
}

static double forgiven_to(const growth_shape *shape, double sign, double time)
{
    return GRACE * tolerance_touch(shape->center, 2.0 * shape_radius(shape, sign * time));
}

/*
 * The touches forgiven to a ride that begins inside the other and is about to come out. One that came over from there was let past in proportion to the disc that it rides
 * now, which may be many touches of the other's where that is the smaller.
 */
static double begin_grace(const ride_pass *pass)
{
    const growth_chunk *chunk = pass->chunk;
    ride_sample start = sample_at(pass, chunk->from);
    double clearance = sample_clearance(pass, &start), slope = sample_slope(pass, &start), distance = point_length(start.place);
    double forgiven = forgiven_to(chunk->shape, chunk->sign, start.at), touch = -touch_of(pass, &start, distance);
    double rate = sight_rate(pass->other, chunk->sign, pass->span, start.at);
    if (start.at > chunk->ride->start.time || clearance >= -1.0 || clearance * touch < -forgiven) return 0.0;
    int is_turning = slope * slope * distance <= (1.0 - rate * rate) * forgiven;
    return slope >= 0.0 || is_turning ? 2.0 * forgiven / touch : 0.0;
}

uint32_t ride_left(const growth_engine *engine, const growth_ride *ride, const sight_line *line, uint32_t disc)
{
    const growth_leg *leg = ride->leg == GROWTH_NONE ? NULL : &engine->legs[ride->leg];
    if (!leg || leg->ride == GROWTH_NONE || leg->arrive > leg->line.start || engine->rides[leg->ride].disc != disc) return SHAPE_NONE;
    const growth_shape *own = engine_shape(engine, ride->disc), *other = engine_shape(engine, disc);
    double sign = engine->question.sign;
    uint32_t span = sight_span_at(other, sign, line->start);
    tdsp_point out = point_sub(line->from, other->center);
    double distance = point_length(out), clearance = distance - shape_radius(other, sign * line->start);
    int comes_out = point_dot(line->unit, out) >= sight_rate(other, sign, span, line->start) * distance;
    return comes_out && clearance >= -forgiven_to(own, sign, line->start) ? other->spans[span].run : SHAPE_NONE;
}

/* The first contact on [from, to], on one span of the other; `to` when there is none, and then *hit stays. */
static double pass_span(ride_pass *pass, double from, double to, int *hit)
{
    ride_sample stack[STACK], a = sample_at(pass, from);
    int top = 0, looks = 0;
    stack[top++] = sample_at(pass, to);
    *hit = 1;
    if (is_inside(pass, &a)) return from;
    while (top > 0) {
        ride_sample b = stack[top - 1];
        double middle = 0.5 * (a.at + b.at);
        int is_least = !(middle > a.at && middle < b.at) || top == STACK || ++looks > MOST_LOOKS || is_concentric(pass);
        double least = part_least(pass, &a, &b);
        if (least >= -1.0 - pass->grace || (is_least && !is_inside(pass, &b))) {
            double next = top > 1 ? stack[top - 2].at : to;
            pass_notes(pass, &b, a.at, next);
            pass->floor = math_min(pass->floor, least);
            a = b;
            --top;
            continue;
        }
        if (is_least || (is_inside(pass, &b) && b.at - a.at < 1e-9 * (1.0 + fabs(a.at)))) return first_inside(pass, a.at, b.at);
        stack[top++] = sample_at(pass, middle);
    }
    *hit = 0;
    return to;
}

/* Too far away for the whole chunk? */
static int is_far(const growth_chunk *chunk, const growth_shape *other, tdsp_point from)
{
    double largest = shape_radius(other, chunk->sign > 0.0 ? chunk->to : -chunk->from);
    double reach = chunk->to - chunk->from + largest;
    tdsp_point offset = point_sub(from, other->center);
    return point_dot(offset, offset) > reach * reach;
}

/* Where both moments are one, there is still something to double. */
#define LEAST_WIDTH 0x1p-52

/* The moment of the least clearance around that noted, which rounding may have put a little off; 0 where it falls or rises all the way. */
static int least_moment(const ride_pass *pass, double from, double to, double *at)
{
    double before = pass->before, after = pass->after, width = math_max(after - before, LEAST_WIDTH * (to - from));
    ride_sample first = sample_at(pass, before), last = sample_at(pass, after);
    for (; before > from && sample_slope(pass, &first) >= 0.0; width *= 2.0) {
        before = math_max(before - width, from);
        first = sample_at(pass, before);
    }
    for (; after < to && sample_slope(pass, &last) < 0.0; width *= 2.0) {
        after = math_min(after + width, to);
        last = sample_at(pass, after);
    }
    if (!(sample_slope(pass, &first) < 0.0 && sample_slope(pass, &last) >= 0.0)) return 0;
    for (int step = 0; step < 60; ++step) {
        double middle = 0.5 * (before + after);
        ride_sample sample = sample_at(pass, middle);
        *(sample_slope(pass, &sample) < 0.0 ? &before : &after) = middle;
    }
    *at = after;
    return 1;
}

/*
 * Discs that just close the gap that the rider passes are passed at a touch: the clearance is least there, so the heading is that of a rider on the other disc. It is none
 * where the part ends with no more left than a touch has. INFINITY: nowhere on this part.
 */
static double pass_touch(const ride_pass *pass, double from, double to)
{
    double at;
    if (!(pass->floor <= 1.0) || !least_moment(pass, from, to, &at)) return INFINITY;
    ride_sample least = sample_at(pass, at), end = sample_at(pass, to);
    double clearance = sample_clearance(pass, &least);
    return clearance >= -1.0 - TOUCH_SAME && clearance <= 1.0 && sample_clearance(pass, &end) > TOUCH_SAME - 1.0 ? at : INFINITY;
}

static uint32_t span_next(const ride_pass *pass)
{
    return pass->chunk->sign > 0.0 ? pass->span + 1 : pass->span - 1;
}

/* Is the clearance least, and a touch, at the end of the span, where the rate falls? */
static int touches_corner(const ride_pass *pass, double at)
{
    const growth_shape *other = pass->other;
    ride_pass after = *pass;
    after.span = span_next(pass);
    if (other->spans[pass->span].run == SHAPE_NONE || other->spans[after.span].run != other->spans[pass->span].run) return 0;
    ride_sample corner = sample_at(pass, at);
    double clearance = sample_clearance(pass, &corner);
    return fabs(clearance) <= 1.0 + TOUCH_SAME && sample_slope(pass, &corner) < 0.0 && sample_slope(&after, &corner) >= 0.0;
}

static void meeting_notes(ride_meeting *meeting, const ride_pass *pass, int is_at_corner, double at)
{
    if (!(at < meeting->change.at)) return;
    meeting->change.span = pass->span;
    meeting->change.is_at_corner = is_at_corner;
    meeting->change.at = at;
}

/* The span that held right before one begins, if it can be ridden; one of no duration did not. */
static uint32_t span_before(const growth_shape *shape, double sign, uint32_t span, double time)
{
    for (;;) {
        uint32_t before = sign > 0.0 ? span - 1 : span + 1;
        if (span_begins(&shape->spans[span], sign) < time || before >= shape->span_count || shape->spans[before].run == SHAPE_NONE) return span;
        span = before;
    }
}

/* Where the heading, which turns on the spot, comes out of the other: it does not at `from`. */
static double fan_turns_out(const ride_pass *pass, double from, double to)
{
    for (int step = 0; step < 60; ++step) {
        double middle = 0.5 * (from + to);
        ride_sample sample = sample_at(pass, middle);
        *(sample_slope(pass, &sample) < 0.0 ? &from : &to) = middle;
    }
    return to;
}

/*
 * A fan is turned on the spot and meets nothing. But the other may be touched there, and the heading become that of a rider on it. For one who begins in the fan it may be
 * within a fan of the other's at once, whose rate falls in the same moment; and who came over from there is as deep in it as is forgiven.
 */
static void fan_meets(ride_meeting *meeting, const growth_chunk *chunk, const growth_shape *other)
{
    const growth_moment *start = &chunk->ride->start;
    int begins = start->in_fan && start->span == chunk->base.span && start->theta == chunk->from;
    double time = chunk->base.time;
    ride_pass after = {chunk, other, sight_span_at(other, chunk->sign, time), 0.0, INFINITY, 0.0, 0.0, INFINITY}, before = after;
    before.span = span_before(other, chunk->sign, after.span, time);
    ride_sample from = sample_at(&after, chunk->from), to = sample_at(&after, chunk->to);
    double touch = -touch_of(&after, &from, point_length(from.place)), clearance = sample_clearance(&after, &from), deepest = 1.0 + TOUCH_SAME;
    if (begins) deepest = math_max(deepest, forgiven_to(chunk->shape, chunk->sign, time) / touch);
    if (clearance > 1.0 + TOUCH_SAME || clearance < -deepest) return;
    if (sample_slope(&after, &from) >= 0.0) {
        if (begins && sample_slope(&before, &from) < 0.0) meeting_notes(meeting, &before, 1, chunk->from);
    } else if (sample_slope(&after, &to) >= 0.0) {
        meeting_notes(meeting, &after, 0, fan_turns_out(&after, chunk->from, chunk->to));
    }
}

ride_meeting ride_meets(const growth_chunk *chunk, const growth_shape *other)
{
    ride_meeting meeting = {chunk->to, 0, {0, SHAPE_NONE, 0, INFINITY}};
    growth_moment begin = chunk_moment(chunk, chunk->from);
    if (other == chunk->shape) return meeting;
    if (chunk->base.in_fan) {
        fan_meets(&meeting, chunk, other);
        return meeting;
    }
    if (is_far(chunk, other, rider_place(chunk->shape, chunk->sign, chunk->ride, &begin))) return meeting;
    ride_pass pass = {chunk, other, sight_span_at(other, chunk->sign, chunk->from), 0.0, INFINITY, 0.0, 0.0, INFINITY};
    double from = chunk->from;
    pass.grace = begin_grace(&pass);
    for (;;) {
        double end = span_ends(&other->spans[pass.span], chunk->sign), to = math_min(chunk->to, end);
        pass.least = pass.floor = INFINITY;
        meeting.free_until = pass_span(&pass, from, to, &meeting.is_stopped);
        if (meeting.is_stopped) return meeting;
        meeting_notes(&meeting, &pass, 0, pass_touch(&pass, from, to));
        if (end > chunk->to || span_next(&pass) >= other->span_count) return meeting;
        if (touches_corner(&pass, to)) meeting_notes(&meeting, &pass, 1, to);
        pass.span = span_next(&pass);
        from = to;
    }
}

/* A chunk as far as it is free. */
typedef struct free_part {
    growth_engine *engine;
    growth_chunk chunk;
    ride_changes *changes;
} free_part;

static int visit_free(void *ctx, uint32_t disc)
{
    free_part *part = ctx;
    ride_changes *changes = part->changes;
    ride_meeting meeting = ride_meets(&part->chunk, engine_shape(part->engine, disc));
    part->chunk.to = meeting.free_until;
    meeting.change.disc = disc;
    if (meeting.change.at < INFINITY && changes->count < RIDE_CHANGES) changes->at[changes->count++] = meeting.change;
    return part->chunk.to > part->chunk.from;
}

double ride_free_until(growth_engine *engine, const growth_chunk *chunk, ride_changes *changes)
{
    free_part part = {engine, *chunk, changes};
    changes->count = 0;
    growth_moment begin = chunk_moment(chunk, chunk->from), end = chunk_moment(chunk, chunk->to);
    tdsp_point place = rider_place(chunk->shape, chunk->sign, chunk->ride, &begin);
    reach_near(&engine->reach, place, end.time - begin.time, begin.time, end.time, visit_free, &part);
    return part.chunk.to;
}
