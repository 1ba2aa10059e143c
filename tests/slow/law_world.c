/* SPDX-License-Identifier: MIT */
/*
 * Discs, and lines among them.
 *
 * With the robot's speed 1, g(T) = R^2 - T^2 has g'' = 2 (R'^2 + R R'' - 1): the sign of `curve`. A line from the point P at the time t
 * in the direction u has in that plane the slope 2 ((P - O) . u - t), and g' = 2 (R R' - T).
 */
#include "slow/law_world.h"

#include <math.h>
#include <stdlib.h>

#include "slow/law_ride.h"

#define SAMPLES_A_PIECE 600
#define TOUCH 1e-12    /* a contact less deep than this share of the sizes that meet is no collision */
#define ROUNDING 1e-14 /* nor is one less deep than this share of the journey */
#define SAME_RATE 1e-13

static const double pi = 3.14159265358979323846;

double law_wrap(double angle)
{
    const double wrapped = remainder(angle, 2.0 * pi);
    return wrapped <= -pi ? wrapped + 2.0 * pi : wrapped;
}

double law_wrap_positive(double angle)
{
    const double wrapped = fmod(angle, 2.0 * pi);
    return wrapped < 0.0 ? wrapped + 2.0 * pi : wrapped;
}

slow_jet law_world_jet(const law_world *world, size_t disc, size_t piece, double time)
{
    const slow_law_disc *law = world->discs[disc].law;
    const slow_jet jet = law->jet(law->ctx, piece, time * world->time);
    const double speed = world->time / world->length;
    return (slow_jet){(jet.radius + world->radius) / world->length, jet.rate * speed, jet.bend * speed * world->time};
}

/* Half of g''. */
static double curve(slow_jet j)
{
    return j.rate * j.rate + j.radius * j.bend - 1.0;
}

/* ------------------------------------------------------------------------------------------------------------ stretches */

static int kind_of(slow_jet j)
{
    return (curve(j) < 0.0) + 2 * (j.rate < 1.0);
}

static int add_stretch(law_world *world, size_t disc, size_t piece, double from, double to)
{
    law_disc *d = &world->discs[disc];
    if (d->stretch_count == LAW_STRETCHES) return 0;
    const slow_jet middle = law_world_jet(world, disc, piece, 0.5 * (from + to));
    d->stretches[d->stretch_count++] =
        (law_stretch){from, to, piece, !(middle.radius > 0.0), curve(middle) < 0.0, middle.rate < 1.0};
    return 1;
}

static int kind_at(const law_world *world, size_t disc, size_t piece, double time)
{
    return kind_of(law_world_jet(world, disc, piece, time));
}

/* The moment up to which the kind of a moment a lasts, when it is another at b. */
static double change_between(const law_world *world, size_t disc, size_t piece, int kind, double a, double b)
{
    for (int i = 0; i < 60; i++) {
        const double middle = 0.5 * (a + b);
        if (kind_at(world, disc, piece, middle) == kind)
            a = middle;
        else
            b = middle;
    }
    return b;
}

/* Samples lie closer to the piece's begin, where a disc may begin as a point. Between two samples the kind changes twice at most. */
static int divide_piece(law_world *world, size_t disc, size_t piece, double from, double to)
{
    const double first = from + 1e-12 * (to - from), last = to - 1e-12 * (to - from);
    double begin = from, before = first;
    int kind = kind_at(world, disc, piece, first);
    for (int i = 1; i <= SAMPLES_A_PIECE; i++) {
        const double share = (double)i / SAMPLES_A_PIECE, now = fmin(from + (to - from) * share * share, last);
        for (int change = 0; change < 2 && kind_at(world, disc, piece, now) != kind; change++) {
            before = change_between(world, disc, piece, kind, before, now);
            kind = kind_at(world, disc, piece, before);
            if (!add_stretch(world, disc, piece, begin, before)) return 0;
            begin = before;
        }
        before = now;
    }
    return add_stretch(world, disc, piece, begin, to);
}

static int divide(law_world *world, size_t disc)
{
    const slow_law_disc *law = world->discs[disc].law;
    double from = 0.0;
    for (size_t k = 0; k <= law->break_count && from < world->until; k++) {
        double to = k < law->break_count ? law->breaks[k] / world->time : world->until;
        if (to > world->until) to = world->until;
        if (!divide_piece(world, disc, k, from, to)) return 0;
        from = to;
    }
    return 1;
}

/* ---------------------------------------------------------------------------------------------------------------- spots */

static void add_kink(law_world *world, size_t disc, const law_stretch *before, const law_stretch *after)
{
    law_disc *d = &world->discs[disc];
    const slow_jet left = law_world_jet(world, disc, before->piece, after->from),
                   right = law_world_jet(world, disc, after->piece, after->from);
    if (!(right.radius > 0.0) || right.rate >= 1.0 || left.rate <= right.rate + SAME_RATE) return;
    d->spots[d->spot_count++] = (law_spot){after->from, after->from, after->piece, 1, right.rate, fmin(left.rate, 1.0)};
}

static void find_spots(law_world *world, size_t disc)
{
    law_disc *d = &world->discs[disc];
    for (size_t i = 0; i < d->stretch_count; i++) {
        const law_stretch *s = &d->stretches[i];
        if (i > 0 && s->piece != s[-1].piece) add_kink(world, disc, s - 1, s);
        if (s->concave && s->ridable && !s->empty) d->spots[d->spot_count++] = (law_spot){s->from, s->to, s->piece, 0, 0.0, 0.0};
    }
}

/* ----------------------------------------------------------------------------------------------------------------- world */

int law_world_make(law_world *world, const tdsp_journey *journey, const slow_law_disc *discs, size_t count, double until)
{
    const tdsp_point from = journey->source, to = journey->destination;
    double length = hypot(to.x - from.x, to.y - from.y);
    if (length == 0.0) length = 1.0;
    *world = (law_world){.count = count, .radius = journey->radius, .length = length, .time = length / journey->speed};
    world->to_x = (to.x - from.x) / length;
    world->to_y = (to.y - from.y) / length;
    world->until = until / world->time;
    if (count > SLOW_LAW_DISCS) return 0;
    for (size_t i = 0; i < count; i++) {
        world->discs[i].law = &discs[i];
        world->discs[i].x = (discs[i].center.x - from.x) / length;
        world->discs[i].y = (discs[i].center.y - from.y) / length;
        if (!divide(world, i)) return 0;
        find_spots(world, i);
        if (!law_ride_prepare(world, i)) return 0;
    }
    return 1;
}

void law_world_drop(law_world *world)
{
    for (size_t i = 0; i < world->count; i++) free(world->discs[i].panels);
}

static double clearance_at(const law_disc *disc, double radius, double x, double y)
{
    return hypot(x - disc->x, y - disc->y) - radius;
}

double law_world_clearance(const law_world *world, size_t disc, size_t piece, double x, double y, double time)
{
    return clearance_at(&world->discs[disc], law_world_jet(world, disc, piece, time).radius, x, y);
}

int law_world_clear(const law_world *world, size_t disc, size_t piece, double x, double y, double time)
{
    const law_disc *d = &world->discs[disc];
    const double radius = law_world_jet(world, disc, piece, time).radius;
    if (!(radius > 0.0)) return 1;
    const double sizes = fabs(x) + fabs(y) + fabs(d->x) + fabs(d->y) + radius;
    return clearance_at(d, radius, x, y) >= -ROUNDING - TOUCH * sizes;
}

int law_world_point_free(const law_world *world, double x, double y, double time)
{
    for (size_t i = 0; i < world->count; i++)
        for (size_t k = 0; k < world->discs[i].stretch_count; k++) {
            const law_stretch *s = &world->discs[i].stretches[k];
            if (time >= s->from && time <= s->to && !law_world_clear(world, i, s->piece, x, y, time)) return 0;
        }
    return 1;
}

/* ----------------------------------------------------------------------------------------------------------------- lines */

/* In a concave stretch R R' - T falls: when it is `level`, or the end that is nearest to that. */
static double level_time(const law_world *world, size_t disc, size_t piece, double level, double low, double high)
{
    for (int i = 0; i < 80 && high - low > 1e-16 * (1.0 + high); i++) {
        const double middle = 0.5 * (low + high);
        const slow_jet j = law_world_jet(world, disc, piece, middle);
        if (j.radius * j.rate - middle > level)
            low = middle;
        else
            high = middle;
    }
    return 0.5 * (low + high);
}

/* A line is no lower under g than at the ends of each stretch, and where the line has g's slope in a concave one. */
static int stretch_off_line(const law_world *world, size_t disc, const law_stretch *s, const double line[5])
{
    const double x = line[0], y = line[1], ux = line[2], uy = line[3], time = line[4];
    const law_disc *d = &world->discs[disc];
    const double level = (x - d->x) * ux + (y - d->y) * uy - time;
    double at[3] = {s->from, s->to, 0.0};
    if (s->concave) at[2] = level_time(world, disc, s->piece, level, s->from, s->to);
    for (int i = 0; i < 2 + s->concave; i++)
        if (!law_world_clear(world, disc, s->piece, x + (at[i] - time) * ux, y + (at[i] - time) * uy, at[i])) return 0;
    return 1;
}

int law_world_line_free(const law_world *world, double x, double y, double heading, double time, double length)
{
    const double line[5] = {x, y, cos(heading), sin(heading), time};
    const double end = time + length;
    if (end > world->until) return 0;
    for (size_t i = 0; i < world->count; i++)
        for (size_t k = 0; k < world->discs[i].stretch_count; k++) {
            law_stretch part = world->discs[i].stretches[k];
            if (part.to < time || part.from > end || part.empty) continue;
            part.from = fmax(part.from, time);
            part.to = fmin(part.to, end);
            if (!stretch_off_line(world, i, &part, line)) return 0;
        }
    return 1;
}

/* --------------------------------------------------------------------------------------------------------------- landing */

/* R^2 - 2 l R R' + l^2 - D^2, which grows with the contact's time in a concave stretch, and half its derivative. */
static double miss_of(slow_jet j, double length, double distance, double *slope)
{
    *slope = -length * curve(j);
    return j.radius * j.radius - 2.0 * length * j.radius * j.rate + length * length - distance * distance;
}

static double contact_time(const law_world *world, size_t disc, const law_spot *spot, double distance, double time, double hint)
{
    double low = fmax(spot->from, time), high = spot->to, slope;
    if (!(miss_of(law_world_jet(world, disc, spot->piece, low), low - time, distance, &slope) < 0.0)) return low;
    if (!(miss_of(law_world_jet(world, disc, spot->piece, high), high - time, distance, &slope) > 0.0)) return high;
    double at = hint > low && hint < high ? hint : 0.5 * (low + high), step = high - low;
    for (int i = 0; i < 100; i++) {
        const double miss = miss_of(law_world_jet(world, disc, spot->piece, at), at - time, distance, &slope), last = step;
        if (miss < 0.0)
            low = at;
        else
            high = at;
        step = -0.5 * miss / slope;
        if (!(at + step > low && at + step < high) || fabs(step) > 0.5 * fabs(last)) step = 0.5 * (low + high) - at;
        if (fabs(step) <= 2e-16 * (1.0 + at)) break;
        at += step;
    }
    return at;
}

/* The triangle of the sides distance, length and radius: the angle at the point. */
static double angle_aside(double distance, double length, double radius)
{
    const double opposite = (radius - length + distance) * (radius + length - distance);
    const double beside = (length + distance - radius) * (length + distance + radius);
    return 2.0 * atan2(sqrt(fmax(0.0, opposite)), sqrt(fmax(0.0, beside)));
}

int law_world_land(const law_world *world, size_t disc, const law_spot *spot, double x, double y, double time, double hint,
                   law_landing *out)
{
    const law_disc *d = &world->discs[disc];
    const double distance = hypot(d->x - x, d->y - y);
    if (time > spot->to || (spot->kink && time >= spot->to)) return 0;
    out->time = spot->kink ? spot->from : contact_time(world, disc, spot, distance, time, hint);
    const double length = out->time - time;
    const slow_jet j = law_world_jet(world, disc, spot->piece, out->time);
    out->aside = angle_aside(distance, length, j.radius);
    if (length <= 0.0 && distance - j.radius > TOUCH) {
        out->excess = INFINITY;
        return 1;
    }
    if (length <= 0.0) {
        out->excess = 0.0;
        out->aside = atan2(sqrt(fmax(0.0, (1.0 - j.rate) * (1.0 + j.rate))), -j.rate);
        return 1;
    }
    const double outward = (length * length + j.radius * j.radius - distance * distance) / (2.0 * length * j.radius);
    const double least = spot->kink ? spot->slow : j.rate, most = spot->kink ? spot->fast : j.rate;
    out->excess = outward < least ? outward - least : outward > most ? outward - most : 0.0;
    return 1;
}
