/* SPDX-License-Identifier: MIT */
/*
 * From labels to the legs of a path, in the user's units.
 *
 * On a part of a law where the rate is constant a ride is one logarithmic spiral. Elsewhere it is cut into curves (tdsp/types.h), halved until the polynomials of
 * degree 5 are where the rider is; where the rate comes up to the robot's speed, and the turning has no second derivative, a last stretch
 * too short to matter is a spiral again.
 */
#include <string.h>

#include "geom/angle.h"
#include "growth/growth.h"
#include "growth/rider.h"
#include "tdsp/path.h"

/* A leg shorter than this is left out. */
#define NOTHING 1e-15

/*
 * A curve may be so far from the rider, and, as a robot on it has to keep to its speed, by no more than this share of its own length and rounding: where it is off by e, which is as
 * x^3 (1 - x)^3 along it, it is too fast by up to 3.5 e over its duration.
 */
#define CURVE_ERROR 2e-13
#define CURVE_SHARE 1e-10
#define CURVE_ROUNDING 1e-14

/* A stretch so short that a spiral will do whatever the law. */
#define SHORTEST 1e-8

static tdsp_status path_append(const growth_solver *self, growth_path *out, const tdsp_leg *leg)
{
    tdsp_status status = memory_reserve(&self->scene->allocator, (void **)&out->legs, &out->capacity, out->count + 1, sizeof *leg);
    if (status == TDSP_OK) out->legs[out->count++] = *leg;
    return status;
}

/* The part of a ride from one time to another of one span, in the frame. */
static tdsp_leg ride_leg(const growth_shape *shape, const growth_ride *ride, uint32_t span, double from, double to)
{
    growth_moment begin = {span, 0, from, 0.0}, end = {span, 0, to, 0.0};
    law_jet first = shape_jet(shape, span, from), last = shape_jet(shape, span, to);
    tdsp_leg leg = {.kind = shape_is_linear(shape, span) ? TDSP_LEG_ARC : TDSP_LEG_CURVE, .disc = ride->disc, .turn = ride->side};
    leg.start_time = from;
    leg.end_time = to;
    leg.from = rider_place(shape, 1.0, ride, &begin);
    leg.to = rider_place(shape, 1.0, ride, &end);
    leg.center = shape->center;
    leg.radius_from = first.radius;
    leg.radius_to = last.radius;
    leg.angle_from = rider_normal(shape, 1.0, ride, &begin);
    leg.sweep = shape_turned(shape, span, from, span, to);
    if (leg.kind == TDSP_LEG_ARC) return leg;
    leg.rate_from = first.rate;
    leg.rate_to = last.rate;
    leg.bend_from = first.bend;
    leg.bend_to = last.bend;
    leg.speed = 1.0;
    return leg;
}

static int curve_is_true(const growth_shape *shape, const growth_ride *ride, uint32_t span, const tdsp_leg *leg)
{
    double enough = math_min(CURVE_ERROR, CURVE_SHARE * (leg->end_time - leg->start_time) + CURVE_ROUNDING);
    if (!(leg->rate_from < 1.0 && leg->rate_to < 1.0)) return 0;
    for (int i = 1; i < 8; ++i) {
        growth_moment moment = {span, 0, leg->start_time + (leg->end_time - leg->start_time) * i / 8.0, 0.0};
        if (!(point_distance(tdsp_leg_position(leg, moment.time), rider_place(shape, 1.0, ride, &moment)) <= enough)) return 0;
    }
    return 1;
}

static tdsp_status append_span(const growth_solver *self, const growth_ride *ride, uint32_t span, double from, double end, growth_path *out)
{
    const growth_shape *shape = engine_shape(&self->engine, ride->disc);
    double to = end;
    while (from < end) {
        tdsp_leg leg = ride_leg(shape, ride, span, from, to);
        double width = to - from, middle = from + 0.5 * width;
        if (leg.kind == TDSP_LEG_CURVE && !curve_is_true(shape, ride, span, &leg)) {
            if (width > SHORTEST * (1.0 + from) && middle > from && middle < to) {
                to = middle;
                continue;
            }
            leg.kind = TDSP_LEG_ARC;
            leg.rate_from = leg.rate_to = leg.bend_from = leg.bend_to = leg.speed = 0.0;
        }
        tdsp_status status = width > NOTHING ? path_append(self, out, &leg) : TDSP_OK;
        if (status != TDSP_OK) return status;
        from = to;
        to = math_min(end, from + 2.0 * width);
    }
    return TDSP_OK;
}

static tdsp_status append_ride(const growth_solver *self, const growth_ride *ride, const growth_moment *leave, growth_path *out)
{
    const growth_shape *shape = engine_shape(&self->engine, ride->disc);
    double from = ride->start.time;
    for (uint32_t span = ride->start.span; span <= leave->span; ++span) {
        double to = span == leave->span ? leave->time : shape->spans[span].to;
        tdsp_status status = append_span(self, ride, span, from, to, out);
        if (status != TDSP_OK) return status;
        from = math_max(from, to);
    }
    return TDSP_OK;
}

static tdsp_status append_line(const growth_solver *self, const growth_leg *leg, growth_path *out)
{
    tdsp_leg line = {.kind = TDSP_LEG_LINE, .disc = TDSP_NO_DISC, .start_time = leg->line.start, .end_time = leg->arrive, .from = leg->line.from};
    line.to = sight_place(&leg->line, leg->arrive);
    return leg->arrive - leg->line.start > NOTHING ? path_append(self, out, &line) : TDSP_OK;
}

/* How the path went, from its start on: the legs taken, whose rides lie before them. */
static tdsp_status append_all(const growth_solver *self, growth_path *out)
{
    const growth_engine *engine = &self->engine;
    uint32_t depth = 0, at = engine->arrived;
    for (uint32_t back = at; back != GROWTH_NONE; back = engine->legs[back].ride == GROWTH_NONE ? GROWTH_NONE : engine->rides[engine->legs[back].ride].leg) ++depth;
    tdsp_status status = TDSP_OK;
    for (uint32_t k = depth; k > 0 && status == TDSP_OK; --k) {
        uint32_t index = at;
        for (uint32_t i = 1; i < k; ++i) index = engine->rides[engine->legs[index].ride].leg;
        const growth_leg *leg = &engine->legs[index];
        if (leg->ride != GROWTH_NONE) status = append_ride(self, &engine->rides[leg->ride], &leg->leave, out);
        if (status == TDSP_OK) status = append_line(self, leg, out);
    }
    return status;
}

/* Radii and angle stay the ride's own, not those of the places: on a disc much smaller than the coordinates the places say where to no more than a part of a turn. */
static void leg_to_user(const tdsp_scene *scene, tdsp_leg *leg, tdsp_point center)
{
    double speed = scene->journey.speed, bend = speed / scene->time;
    if (leg->kind == TDSP_LEG_LINE) return;
    leg->center = center;
    leg->radius_from *= scene->length;
    leg->radius_to *= scene->length;
    leg->angle_from = angle_wrap(leg->angle_from);
    leg->rate_from *= speed;
    leg->rate_to *= speed;
    leg->bend_from *= bend;
    leg->bend_to *= bend;
    leg->speed *= speed;
}

/* Units, and the joins. */
static void path_finish(const growth_solver *self, const scene_ends *ends, double departure, double arrival, growth_path *out)
{
    const tdsp_scene *scene = self->scene;
    double start = self->engine.question.time, now = departure;
    tdsp_point at = ends->given.source;
    for (size_t i = 0; i < out->count; ++i) {
        tdsp_leg *leg = &out->legs[i];
        int is_last = i + 1 == out->count;
        leg->from = at;
        leg->start_time = now;
        leg->to = at = is_last ? ends->given.destination : scene_place(scene, leg->to);
        leg->end_time = now = is_last ? arrival : math_min(math_max(now, departure + (leg->end_time - start) * scene->time), arrival);
        leg_to_user(scene, leg, leg->disc == TDSP_NO_DISC ? at : scene->discs[leg->disc].center);
    }
}

tdsp_status growth_route(growth_solver *self, const scene_ends *ends, double departure, double arrival, growth_path *out)
{
    out->count = 0;
    if (self->engine.arrived == GROWTH_NONE) return TDSP_OK;
    tdsp_status status = append_all(self, out);
    if (status == TDSP_OK) path_finish(self, ends, departure, arrival, out);
    return status;
}
