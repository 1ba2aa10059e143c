/* SPDX-License-Identifier: MIT */
/* The derivation is in sight.h and shape.h. */
#include "growth/sight.h"

#include "geom/tolerance.h"

/* Newton's last step, of a time that is wanted itself, and of one at which only F is: its error is squared there. */
#define PRECISE 4e-16
#define ROUGH 1e-9

/* Halving alone needs no more. */
#define MOST_STEPS 200

double run_begins(const growth_shape *shape, double sign, uint32_t run)
{
    const shape_run *self = &shape->runs[run];
    return sign > 0.0 ? shape->spans[self->first].from : -shape->spans[self->last].to;
}

double run_ends(const growth_shape *shape, double sign, uint32_t run)
{
    const shape_run *self = &shape->runs[run];
    return sign > 0.0 ? shape->spans[self->last].to : -shape->spans[self->first].from;
}

uint32_t sight_span_at(const growth_shape *shape, double sign, double time)
{
    uint32_t span = shape_span_at(shape, sign * time);
    return sign < 0.0 && span > 0 && shape->spans[span].from == -time ? span - 1 : span;
}

double sight_value(const growth_shape *shape, double sign, uint32_t span, tdsp_point place, double time)
{
    double distance = point_distance(place, shape->center), radius = shape_jet(shape, span, sign * time).radius;
    return (distance - radius) * (distance + radius);
}

/* Half the slope of F along the motion. */
static double slope(const growth_shape *shape, double sign, const sight_line *line, uint32_t span, double time)
{
    law_jet jet = shape_jet(shape, span, sign * time);
    return point_dot(point_sub(line->from, shape->center), line->unit) + (time - line->start) - sign * jet.radius * jet.rate;
}

/*
 * Where the slope, which rises, is 0 between two moments of one span; it is below 0 at `low` and not at `high`, which may be infinite. Newton from the moment nearest to
 * the centre, kept between the two.
 */
static double slope_root(const growth_shape *shape, double sign, const sight_line *line, uint32_t span, double low, double high, double error)
{
    double along = point_dot(point_sub(line->from, shape->center), line->unit), time = line->start - along;
    if (shape_is_linear(shape, span)) {
        const law_piece *piece = &shape->pieces[shape->spans[span].piece];
        double rate = sign * piece->c[1], radius = piece->c[0] - piece->c[1] * piece->start;
        time = (rate * radius + line->start - along) / ((1.0 - rate) * (1.0 + rate));
        return math_max(low, math_min(time, high));
    }
    if (!(time > low && time < high)) time = isinf(high) ? low + 1.0 : 0.5 * (low + high);
    for (int step = 0; step < MOST_STEPS && low < high; ++step) {
        law_jet jet = shape_jet(shape, span, sign * time);
        double value = along + (time - line->start) - sign * jet.radius * jet.rate;
        double rise = 1.0 - (jet.rate * jet.rate + jet.radius * jet.bend);
        if (value < 0.0)
            low = time;
        else
            high = time;
        double next = time - value / rise;
        if (fabs(next - time) <= error * (1.0 + fabs(time))) return math_max(low, math_min(next, high));
        if (!(next > low && next < high)) next = isinf(high) ? low + 2.0 * (low - line->start + 1.0) : 0.5 * (low + high);
        if (next <= low || next >= high) return next;
        time = next;
    }
    return time;
}

static sight_nearest nearest_at(const growth_shape *shape, double sign, const sight_line *line, uint32_t span, double time)
{
    sight_nearest nearest = {sight_value(shape, sign, span, sight_place(line, time), time), time, span, 0};
    return nearest;
}

sight_nearest sight_pass(const growth_shape *shape, double sign, const sight_line *line, uint32_t run, double from, int is_precise)
{
    const shape_run *self = &shape->runs[run];
    uint32_t first = sign > 0.0 ? self->first : self->last, last = sign > 0.0 ? self->last : self->first;
    double begin = run_begins(shape, sign, run), low = math_max(begin, from);
    uint32_t span = low > begin ? sight_span_at(shape, sign, low) : first;
    if (shape->spans[span].run != run) span = last;
    if (slope(shape, sign, line, span, low) >= 0.0) return nearest_at(shape, sign, line, span, low);
    for (;;) {
        double high = span_ends(&shape->spans[span], sign);
        if (isinf(high) || slope(shape, sign, line, span, high) >= 0.0)
            return nearest_at(shape, sign, line, span, slope_root(shape, sign, line, span, low, high, is_precise ? PRECISE : ROUGH));
        uint32_t next = sign > 0.0 ? span + 1 : span - 1;
        int is_last = span == last;
        if (is_last || slope(shape, sign, line, next, high) >= 0.0) {
            sight_nearest nearest = nearest_at(shape, sign, line, span, high);
            nearest.is_at_corner = !is_last;
            return nearest;
        }
        span = next;
        low = high;
    }
}

/* How far below 0 F may be for a touch. */
static double touch(const growth_shape *shape, double distance, double radius)
{
    double sizes = distance + radius;
    if (radius <= SHAPE_LEAST_RIDE) return -sizes * sizes; /* nobody has to go round it */
    return -tolerance_touch(shape->center, sizes) * sizes;
}

static int is_below(const growth_shape *shape, double sign, uint32_t span, const sight_line *line, double time)
{
    double distance = point_distance(sight_place(line, time), shape->center), radius = shape_jet(shape, span, sign * time).radius;
    return (distance - radius) * (distance + radius) < touch(shape, distance, radius);
}

/* When F goes below 0 on a part of a span at whose end it is. */
static double entering(const growth_shape *shape, double sign, uint32_t span, const sight_line *line, double low, double high)
{
    if (is_below(shape, sign, span, line, low)) return low;
    for (int step = 0; step < 60; ++step) {
        double middle = 0.5 * (low + high);
        if (is_below(shape, sign, span, line, middle))
            high = middle;
        else
            low = middle;
    }
    return high;
}

static int span_blocks(const growth_shape *shape, double sign, uint32_t span, const sight_line *line, double low, double high, double *hit)
{
    double lowest = high;
    if (shape->spans[span].is_concave && slope(shape, sign, line, span, high) > 0.0) {
        lowest = slope(shape, sign, line, span, low) >= 0.0 ? low : slope_root(shape, sign, line, span, low, high, ROUGH);
    } else if (!shape->spans[span].is_concave && is_below(shape, sign, span, line, low)) {
        lowest = low;
    }
    if (!is_below(shape, sign, span, line, lowest)) return 0;
    *hit = entering(shape, sign, span, line, low, lowest);
    return 1;
}

/* The square of the least distance of a segment from a place. */
static double segment_distance_squared(const sight_line *line, double end, tdsp_point place)
{
    double along = point_dot(point_sub(place, line->from), line->unit);
    double time = math_min(math_max(line->start + along, line->start), end);
    tdsp_point offset = point_sub(sight_place(line, time), place);
    return point_dot(offset, offset);
}

int sight_is_blocked(const growth_shape *shape, double sign, const sight_line *line, double end, uint32_t left, uint32_t met, double *hit)
{
    double radius = shape_radius(shape, sign > 0.0 ? end : -line->start); /* the largest */
    if (segment_distance_squared(line, end, shape->center) > radius * radius) return 0;
    uint32_t span = sight_span_at(shape, sign, line->start);
    for (;;) {
        const shape_span *self = &shape->spans[span];
        double low = math_max(line->start, span_begins(self, sign)), high = math_min(end, span_ends(self, sign));
        int is_touched = self->run != SHAPE_NONE && (self->run == left || self->run == met);
        if (high >= low && !is_touched && span_blocks(shape, sign, span, line, low, high, hit)) return 1;
        if (span_ends(self, sign) >= end || (sign < 0.0 && span == 0) || (sign > 0.0 && span + 1 == shape->span_count)) return 0;
        span = sign > 0.0 ? span + 1 : span - 1;
    }
}

int sight_is_inside(const growth_shape *shape, double sign, tdsp_point place, double time)
{
    double distance = point_distance(place, shape->center), radius = shape_radius(shape, sign * time);
    return (distance - radius) * (distance + radius) < touch(shape, distance, radius);
}
