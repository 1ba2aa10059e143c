/*
 * Where a path only just passes: the moment at which it touches one disc and is nearest to another.
 *
 * A path touches a disc all along a ride, and where a leg lands. The last path to pass a closing gap does so with the other disc at its side: among all moments on
 * the path at which it touches a disc, looked at chunk by chunk, the one with the least clearance to any other is taken, and then made precise by halving.
 */
#include "growth/growth.h"
#include "growth/rider.h"

/* A chunk is looked at in so many places, and the best of them with so many steps to either side. */
#define LOOKS 8
#define STEPS 60

typedef struct squeeze {
    const growth_engine *engine;
    uint32_t first, second;
    double clearance, time;
    tdsp_point place;
} squeeze;

/* The nearest other disc at a moment of a ride. */
static double squeeze_look(squeeze *self, const growth_chunk *chunk, double at)
{
    growth_moment moment = chunk_moment(chunk, at);
    tdsp_point place = rider_place(chunk->shape, chunk->sign, chunk->ride, &moment);
    double least = INFINITY;
    for (uint32_t i = 0; i < self->engine->shape_count; ++i) {
        const growth_shape *other = engine_shape(self->engine, i);
        if (other == chunk->shape) continue;
        double clearance = point_distance(place, other->center) - shape_radius(other, chunk->sign * moment.time);
        least = fmin(least, clearance);
        if (clearance >= self->clearance) continue;
        self->clearance = clearance;
        self->first = chunk->ride->disc;
        self->second = i;
        self->time = moment.time;
        self->place = place;
    }
    return least;
}

/* Around a place looked at, by thirds: the clearance falls towards its least value from either side. */
static void squeeze_refine(squeeze *self, const growth_chunk *chunk, double low, double high)
{
    for (int step = 0; step < STEPS; ++step) {
        double third = (high - low) / 3.0;
        if (squeeze_look(self, chunk, low + third) < squeeze_look(self, chunk, high - third))
            high -= third;
        else
            low += third;
    }
}

static void squeeze_chunk(squeeze *self, const growth_chunk *chunk)
{
    double least = INFINITY, step = (chunk->to - chunk->from) / LOOKS;
    int best = 0;
    for (int i = 0; i <= LOOKS; ++i) {
        double clearance = squeeze_look(self, chunk, chunk->from + step * i);
        if (clearance >= least) continue;
        least = clearance;
        best = i;
    }
    double middle = chunk->from + step * best;
    if (least <= self->clearance) squeeze_refine(self, chunk, fmax(chunk->from, middle - step), fmin(chunk->to, middle + step));
}

static void squeeze_ride(squeeze *self, const growth_ride *ride, const growth_moment *leave)
{
    const growth_shape *shape = engine_shape(self->engine, ride->disc);
    growth_ride again = *ride;
    growth_chunk chunk;
    again.now = ride->start;
    again.is_over = 0;
    while (!again.is_over && rider_next_chunk(shape, self->engine->question.sign, &again, &chunk)) {
        int is_last = !chunk.base.in_fan && chunk.base.span == leave->span && chunk.to >= leave->time;
        if (is_last) chunk.to = leave->time;
        squeeze_chunk(self, &chunk);
        if (is_last) return;
        again.now = rider_after(&chunk, &again.is_over);
    }
}

growth_squeeze growth_narrowest(const growth_solver *self)
{
    const growth_engine *engine = &self->engine;
    const tdsp_scene *scene = self->scene;
    squeeze found = {engine, TDSP_NO_DISC, TDSP_NO_DISC, INFINITY, 0.0, {0.0, 0.0}};
    for (uint32_t at = engine->arrived; at != GROWTH_NONE && engine->legs[at].ride != GROWTH_NONE;) {
        const growth_leg *leg = &engine->legs[at];
        squeeze_ride(&found, &engine->rides[leg->ride], &leg->leave);
        at = engine->rides[leg->ride].leg;
    }
    growth_squeeze narrowest = {found.first, found.second, engine->question.sign * found.time * scene->time, scene_place(scene, found.place)};
    if (found.first < found.second) return narrowest;
    narrowest.first = found.second;
    narrowest.second = found.first;
    return narrowest;
}
