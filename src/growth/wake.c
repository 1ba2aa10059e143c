/* SPDX-License-Identifier: MIT */
/* The argument is in wake.h. */
#include "growth/wake.h"

/* Rides of one place and time, to rounding, are told apart by who came first. */
#define SAME_PLACE 1e-13

/* Is a moment of a run before another, in the direction of travel? */
static int moment_precedes(const growth_moment *a, const growth_moment *b)
{
    return a->time < b->time;
}

/* When the ride had turned by an angle, which it did between its start and `last`. */
static double when_turned(const growth_shape *shape, double sign, const growth_ride *ride, double angle, const growth_moment *last)
{
    double low = ride->start.time, high = last->time;
    for (int step = 0; step < 100; ++step) {
        growth_moment middle = {0, 0, 0.5 * (low + high), 0.0};
        if (!(middle.time > low && middle.time < high)) break;
        middle.span = sight_span_at(shape, sign, middle.time);
        if (rider_turned(shape, sign, ride, &middle) < angle)
            low = middle.time;
        else
            high = middle.time;
    }
    return high;
}

/* Is the way outwards (backwards in time: inwards) at an angle free, for whoever was there at `passed` and has to be there again by `time`? */
static int radius_is_free(growth_engine *engine, uint32_t disc, double normal, double passed, double time)
{
    const growth_shape *shape = engine_shape(engine, disc);
    double sign = engine->question.sign, before = shape_radius(shape, sign * passed), after = shape_radius(shape, sign * time);
    double way = fabs(after - before);
    tdsp_point out = point_unit(normal);
    sight_line line = {point_along(shape->center, before, out), after < before ? point_scale(-1.0, out) : out, sign > 0.0 ? passed : time - way};
    return !growth_line_is_blocked(engine, &line, line.start + way, disc);
}

/* Did the ride pass the angle before the moment? *when: the time. */
static int ride_passed(const growth_shape *shape, double sign, const growth_ride *ride, double normal, const growth_moment *moment, int is_older, double *when)
{
    const growth_moment *last = moment_precedes(&ride->now, moment) ? &ride->now : moment;
    double angle = angle_positive(ride->side * (normal - ride->normal));
    if (moment_precedes(last, &ride->start)) return 0;
    if (angle > GEOM_TURN - SAME_PLACE) angle = 0.0;
    double turned = rider_turned(shape, sign, ride, last);
    if (angle > turned) return 0;
    *when = angle == 0.0 ? ride->start.time : when_turned(shape, sign, ride, angle, last);
    return *when < moment->time - SAME_PLACE * (1.0 + fabs(moment->time)) || is_older;
}

int wake_covers(growth_engine *engine, const growth_ride *rider, double normal, const growth_moment *moment, uint32_t self)
{
    const growth_shape *shape = engine_shape(engine, rider->disc);
    double when;
    for (uint32_t r = engine->heads[rider->disc]; r != GROWTH_NONE; r = engine->rides[r].next) {
        const growth_ride *ride = &engine->rides[r];
        if (r == self || ride->run != rider->run) continue;
        if (engine->question.explain && ride->side != rider->side) continue;
        int is_older = (self == GROWTH_NONE || r < self) && ride->side == rider->side;
        if (ride_passed(shape, engine->question.sign, ride, normal, moment, is_older, &when) &&
            radius_is_free(engine, rider->disc, normal, when, moment->time))
            return 1;
    }
    return 0;
}

static int chunk_is_passed(growth_engine *engine, const growth_chunk *chunk, uint32_t self, double at)
{
    growth_moment moment = chunk_moment(chunk, at);
    double normal = rider_normal(chunk->shape, chunk->sign, chunk->ride, &moment);
    return wake_covers(engine, chunk->ride, normal, &moment, self);
}

double wake_cut(growth_engine *engine, const growth_chunk *chunk, uint32_t self)
{
    double low = chunk->from, high = chunk->to;
    if (chunk->base.in_fan || !chunk_is_passed(engine, chunk, self, high)) return high;
    if (chunk_is_passed(engine, chunk, self, low)) return low;
    for (int step = 0; step < 60; ++step) {
        double middle = 0.5 * (low + high);
        if (!(middle > low && middle < high)) break;
        if (chunk_is_passed(engine, chunk, self, middle))
            high = middle;
        else
            low = middle;
    }
    return high;
}
