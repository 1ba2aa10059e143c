/* The bound is in ride.h. */
#include "growth/ride.h"

#include "geom/tolerance.h"

/* Parts of one chunk against one disc after which a touch is taken to be none: a boundary that is followed for a while. */
#define MOST_LOOKS 3000

#define STACK 64

typedef struct ride_sample {
    double at;
    tdsp_point place; /* from the other's centre */
    double radius;    /* of the other */
    double heading;
} ride_sample;

typedef struct ride_pass {
    const growth_chunk *chunk;
    const growth_shape *other;
    uint32_t span; /* of the other */
} ride_pass;

static ride_sample sample_at(const ride_pass *pass, double at)
{
    const growth_chunk *chunk = pass->chunk;
    growth_moment moment = chunk_moment(chunk, at);
    ride_sample sample = {at, rider_place(chunk->shape, chunk->sign, chunk->ride, &moment), 0.0, 0.0};
    sample.place = point_sub(sample.place, pass->other->center);
    sample.radius = shape_jet(pass->other, pass->span, chunk->sign * at).radius;
    sample.heading = rider_heading(chunk->shape, chunk->sign, chunk->ride, &moment);
    return sample;
}

static double touch_of(const ride_pass *pass, const ride_sample *sample, double distance)
{
    return -tolerance_touch(pass->other->center, sample->radius + distance);
}

static int is_inside(const ride_pass *pass, const ride_sample *sample)
{
    double distance = point_length(sample->place);
    return distance - sample->radius < touch_of(pass, sample, distance);
}

/* The greatest |R''| on a part of the other's span. */
static double bend_bound(const ride_pass *pass, double a, double b)
{
    const law_piece *piece = &pass->other->pieces[pass->other->spans[pass->span].piece];
    double sign = pass->chunk->sign, reach = fmax(fabs(sign * a - piece->start), fabs(sign * b - piece->start)), sum = 0.0, power = 1.0;
    for (uint32_t k = 2; k <= piece->degree; ++k) {
        sum += k * (k - 1) * fabs(piece->c[k]) * power;
        power *= reach;
    }
    return sum;
}

static int part_is_free(const ride_pass *pass, const ride_sample *a, const ride_sample *b)
{
    double width = b->at - a->at, turn = fabs(b->heading - a->heading);
    tdsp_point middle = point_scale(0.5, point_add(a->place, b->place));
    double distance = point_length(middle);
    if (!(distance > 0.0)) return 0;
    double from = point_dot(a->place, middle) / distance - a->radius, to = point_dot(b->place, middle) / distance - b->radius;
    double sag = 0.5 * width * tan(0.5 * turn) + bend_bound(pass, a->at, b->at) * width * width / 8.0;
    return fmin(from, to) - sag >= touch_of(pass, b->radius > a->radius ? b : a, distance);
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

/* The first contact on [from, to], on one span of the other; `to` when there is none, and then *hit stays. */
static double pass_span(const ride_pass *pass, double from, double to, int *hit)
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
        if (part_is_free(pass, &a, &b) || (is_least && !is_inside(pass, &b))) {
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

double ride_touches(const growth_chunk *chunk, const growth_shape *other, int *hit)
{
    growth_moment begin = chunk_moment(chunk, chunk->from);
    *hit = 0;
    if (other == chunk->shape || chunk->base.in_fan) return chunk->to; /* a fan is turned on the spot */
    if (is_far(chunk, other, rider_place(chunk->shape, chunk->sign, chunk->ride, &begin))) return chunk->to;
    ride_pass pass = {chunk, other, sight_span_at(other, chunk->sign, chunk->from)};
    double from = chunk->from;
    for (;;) {
        double end = span_ends(&other->spans[pass.span], chunk->sign), to = fmin(chunk->to, end);
        double free_until = pass_span(&pass, from, to, hit);
        if (*hit || end >= chunk->to) return free_until;
        pass.span = chunk->sign > 0.0 ? pass.span + 1 : pass.span - 1;
        from = to;
    }
}

/* A chunk as far as it is free. */
typedef struct free_part {
    growth_engine *engine;
    growth_chunk chunk;
} free_part;

static int visit_free(void *ctx, uint32_t disc)
{
    free_part *part = ctx;
    int hit;
    part->chunk.to = ride_touches(&part->chunk, engine_shape(part->engine, disc), &hit);
    return part->chunk.to > part->chunk.from;
}

double ride_free_until(growth_engine *engine, const growth_chunk *chunk)
{
    free_part part = {engine, *chunk};
    if (!chunk->base.in_fan) {
        growth_moment begin = chunk_moment(chunk, chunk->from);
        tdsp_point place = rider_place(chunk->shape, chunk->sign, chunk->ride, &begin);
        reach_near(&engine->reach, place, chunk->to - chunk->from, chunk->from, chunk->to, visit_free, &part);
    }
    return part.chunk.to;
}
