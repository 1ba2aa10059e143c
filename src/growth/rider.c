/* SPDX-License-Identifier: MIT */
/* The description is in rider.h. */
#include "growth/rider.h"

/* The most that a heading turns in a chunk. */
#define CHUNK_TURN 0.4

/* A corner at which the heading turns by less is none. */
#define LEAST_FAN 1e-12

/* Halving leaves nothing of a chunk after this. */
#define MOST_HALVINGS 100

static double theta_of(double rate)
{
    double squared = (1.0 - rate) * (1.0 + rate);
    return math_atan2(squared > 0.0 ? sqrt(squared) : 0.0, rate);
}

double rider_theta(const growth_shape *shape, double sign, uint32_t span, double time)
{
    return theta_of(sight_rate(shape, sign, span, time));
}

static double moment_theta(const growth_shape *shape, double sign, const growth_moment *moment)
{
    return moment->in_fan ? moment->theta : rider_theta(shape, sign, moment->span, moment->time);
}

growth_moment chunk_moment(const growth_chunk *chunk, double at)
{
    growth_moment moment = chunk->base;
    if (moment.in_fan)
        moment.theta = at;
    else
        moment.time = at;
    return moment;
}

double rider_turned(const growth_shape *shape, double sign, const growth_ride *ride, const growth_moment *moment)
{
    const growth_moment *start = &ride->start;
    return sign > 0.0 ? shape_turned(shape, start->span, start->time, moment->span, moment->time)
                      : shape_turned(shape, moment->span, -moment->time, start->span, -start->time);
}

double rider_normal(const growth_shape *shape, double sign, const growth_ride *ride, const growth_moment *moment)
{
    return ride->normal + ride->side * rider_turned(shape, sign, ride, moment);
}

double rider_heading(const growth_shape *shape, double sign, const growth_ride *ride, const growth_moment *moment)
{
    return rider_normal(shape, sign, ride, moment) + ride->side * moment_theta(shape, sign, moment);
}

tdsp_point rider_place(const growth_shape *shape, double sign, const growth_ride *ride, const growth_moment *moment)
{
    double radius = shape_jet(shape, moment->span, sign * moment->time).radius;
    return point_along(shape->center, radius, point_unit(rider_normal(shape, sign, ride, moment)));
}

sight_line rider_leaves(const growth_shape *shape, double sign, const growth_ride *ride, const growth_moment *moment)
{
    law_jet jet = shape_jet(shape, moment->span, sign * moment->time);
    tdsp_point out = point_unit(rider_normal(shape, sign, ride, moment));
    double rate = moment->in_fan ? math_cos(moment->theta) : math_min(sign * jet.rate, 1.0);
    double across = ride->side * (moment->in_fan ? math_sin(moment->theta) : sqrt(math_max((1.0 - rate) * (1.0 + rate), 0.0)));
    sight_line line = {point_along(shape->center, jet.radius, out), {rate * out.x - across * out.y, rate * out.y + across * out.x}, moment->time};
    return line;
}

/* When the heading has turned by so much on this span, or the span's end before. */
static double chunk_end(const growth_shape *shape, double sign, const growth_ride *ride, const growth_moment *from)
{
    double end = span_ends(&shape->spans[from->span], sign), heading = rider_heading(shape, sign, ride, from);
    law_jet jet = shape_jet(shape, from->span, sign * from->time);
    growth_moment to = *from;
    double step = jet.radius > 0.0 ? jet.radius : 1.0;
    to.time = math_min(end, from->time + step);
    while (to.time < end && fabs(rider_heading(shape, sign, ride, &to) - heading) < 0.5 * CHUNK_TURN) {
        step *= 2.0;
        to.time = math_min(end, from->time + step);
    }
    while (fabs(rider_heading(shape, sign, ride, &to) - heading) > CHUNK_TURN) {
        double middle = 0.5 * (from->time + to.time);
        if (!(middle > from->time && middle < to.time)) break;
        to.time = middle;
    }
    return to.time;
}

static uint32_t span_after(const growth_shape *shape, double sign, uint32_t span)
{
    const shape_run *run = &shape->runs[shape->spans[span].run];
    if (span == (sign > 0.0 ? run->last : run->first)) return SHAPE_NONE;
    return sign > 0.0 ? span + 1 : span - 1;
}

int rider_next_chunk(const growth_shape *shape, double sign, const growth_ride *ride, growth_chunk *chunk)
{
    growth_chunk made = {shape, ride, sign, ride->now, 0.0, 0.0};
    if (ride->is_over) return 0;
    if (ride->now.in_fan) {
        uint32_t next = span_after(shape, sign, ride->now.span);
        made.from = ride->now.theta;
        made.to = math_min(made.from + CHUNK_TURN, rider_theta(shape, sign, next, ride->now.time));
    } else {
        made.from = ride->now.time;
        made.to = chunk_end(shape, sign, ride, &ride->now);
    }
    *chunk = made;
    return 1;
}

growth_moment rider_after(const growth_chunk *chunk, int *is_over)
{
    growth_moment moment = chunk_moment(chunk, chunk->to);
    const growth_shape *shape = chunk->shape;
    double end = span_ends(&shape->spans[moment.span], chunk->sign);
    *is_over = 0;
    if (!moment.in_fan && moment.time < end) return moment;
    uint32_t next = span_after(shape, chunk->sign, moment.span);
    if (next == SHAPE_NONE) {
        *is_over = 1;
        return moment;
    }
    double theta = moment_theta(shape, chunk->sign, &moment), after = rider_theta(shape, chunk->sign, next, moment.time);
    moment.in_fan = after > theta + LEAST_FAN;
    moment.theta = theta;
    if (!moment.in_fan) moment.span = next;
    return moment;
}

static double turned_at(const growth_chunk *chunk, double at)
{
    growth_moment moment = chunk_moment(chunk, at);
    return rider_turned(chunk->shape, chunk->sign, chunk->ride, &moment);
}

int rider_passes(const growth_chunk *chunk, tdsp_point place, double *at)
{
    tdsp_point out = point_sub(place, chunk->shape->center);
    double angle = angle_positive(chunk->ride->side * (math_atan2(out.y, out.x) - chunk->ride->normal));
    double low = chunk->from, high = chunk->to;
    if (chunk->base.in_fan || angle < turned_at(chunk, low) || angle > turned_at(chunk, high)) return 0;
    for (int step = 0; step < MOST_HALVINGS; ++step) {
        double middle = 0.5 * (low + high);
        if (!(middle > low && middle < high)) break;
        *(turned_at(chunk, middle) < angle ? &low : &high) = middle;
    }
    *at = high;
    return 1;
}
