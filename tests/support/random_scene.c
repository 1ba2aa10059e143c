/* SPDX-License-Identifier: MIT */
/*
 * Every mix is a way to place discs around the journey from (-1, 0) to (1, 0) of a robot with speed 1; afterwards the scene
 * is turned, scaled and moved, because axis-parallel scenes hide mistakes of angle, and in part of the scenes it is left as
 * it is, because they also make them.
 */
#include "support/random_scene.h"

#include <math.h>

#include "support/chance.h"

#define NEAR_SPEED 0.9999

static int chance(uint64_t *r, double share)
{
    return chance_unit(r) < share;
}

static int chance_index(uint64_t *r, int limit)
{
    return (int)chance_below(r, (size_t)limit);
}

static tdsp_disc disc_at(double x, double y, double radius, double growth)
{
    return (tdsp_disc){{x, y}, radius, growth};
}

/* A unit vector, uniform, from sums and square roots alone. */
static tdsp_point random_direction(uint64_t *r)
{
    for (;;) {
        const double x = chance_between(r, -1.0, 1.0), y = chance_between(r, -1.0, 1.0), n = x * x + y * y;
        if (n > 0.01 && n <= 1.0) return (tdsp_point){x / sqrt(n), y / sqrt(n)};
    }
}

/* Somewhere around the journey, smaller when there are more. */
static tdsp_disc disc_around(uint64_t *r, size_t count, double rate)
{
    const double x = chance_between(r, -0.9, 0.9), y = chance_between(r, -0.6, 0.6);
    return disc_at(x, y, chance_between(r, 0.03, 0.5) / sqrt((double)count), rate);
}

typedef struct maker {
    uint64_t *r;
    size_t i, count;
    double rate;      /* one that scenes of equal rates share */
    tdsp_disc *discs; /* those made so far, and this one */
    tdsp_journey *journey;
    double source_open; /* no disc covers the source, or the destination, before these times, where that can be had */
    double destination_open;
} maker;

static double any_rate(uint64_t *r)
{
    const double share = chance_between(r, 0.0, 1.0);
    if (share < 0.5) return chance_between(r, 0.0, 0.15);
    return share < 0.85 ? chance_between(r, 0.0, 0.4) : chance_between(r, 0.0, 0.95);
}

static tdsp_disc make_equal_rates(maker *m)
{
    return disc_around(m->r, m->count, m->rate);
}

static tdsp_disc make_mixed_rates(maker *m)
{
    return disc_around(m->r, m->count, any_rate(m->r));
}

static tdsp_disc make_static(maker *m)
{
    return disc_around(m->r, m->count, 0.0);
}

static tdsp_disc make_some_static(maker *m)
{
    return disc_around(m->r, m->count, chance(m->r, 0.5) ? 0.0 : m->rate);
}

static tdsp_disc make_too_fast(maker *m)
{
    static const double fast[] = {1.0, 1.0, 1.5, 4.0};
    if (chance(m->r, 0.7)) return disc_around(m->r, m->count, any_rate(m->r));
    m->source_open = 0.0;
    const double rate = fast[chance_index(m->r, 4)], far = 2.5 * rate;
    const tdsp_point to = random_direction(m->r);
    return disc_at(far * to.x, far * to.y, chance_between(m->r, 0.0, 0.3), rate);
}

/* A disc that is fast must begin far from the destination, so beside the source or behind it. */
static tdsp_disc fast_disc(maker *m, double rate)
{
    const tdsp_point to = random_direction(m->r);
    const double radius = chance_between(m->r, 0.005, 0.1), away = radius + chance_between(m->r, 0.01, 0.4);
    return disc_at(m->journey->source.x + away * to.x, m->journey->source.y + away * to.y, radius, rate);
}

static tdsp_disc make_nearly_as_fast(maker *m)
{
    m->source_open = 0.01 * m->source_open;
    if (chance(m->r, 0.5)) return disc_around(m->r, m->count, any_rate(m->r));
    return fast_disc(m, chance_between(m->r, 0.5, chance(m->r, 0.5) ? 0.95 : NEAR_SPEED));
}

static tdsp_disc make_nearly_static(maker *m)
{
    static const double rates[] = {0.0, 1e-14, 1e-9, 1e-6, 1e-3};
    return disc_around(m->r, m->count, rates[chance_index(m->r, 5)]);
}

static tdsp_disc make_points(maker *m)
{
    tdsp_disc disc = disc_around(m->r, m->count, chance(m->r, 0.5) ? m->rate : any_rate(m->r));
    if (chance(m->r, 0.8)) disc.radius = 0.0;
    return disc;
}

static tdsp_disc make_cluster(maker *m)
{
    const tdsp_point to = random_direction(m->r);
    const double away = chance_between(m->r, 0.0, 0.35);
    const double rate = chance(m->r, 0.5) ? m->rate : any_rate(m->r);
    return disc_at(away * to.x, away * to.y, chance_between(m->r, 0.08, 0.3), rate);
}

static tdsp_disc make_nested(maker *m)
{
    if (m->i % 2 == 0) return disc_around(m->r, m->count, any_rate(m->r));
    const tdsp_disc outer = m->discs[m->i - 1];
    const tdsp_point to = random_direction(m->r);
    const double away = outer.radius * chance_between(m->r, 0.0, 0.6);
    const double rate = any_rate(m->r), radius = (outer.radius - away) * chance_between(m->r, 0.1, 1.0);
    return disc_at(outer.center.x + away * to.x, outer.center.y + away * to.y, radius, rate);
}

static tdsp_disc make_concentric(maker *m)
{
    if (m->i % 3 == 0) return disc_around(m->r, m->count, any_rate(m->r));
    tdsp_disc disc = m->discs[m->i - 1];
    disc.radius *= chance(m->r, 0.2) ? 1.0 : chance_between(m->r, 0.2, 1.2);
    disc.growth = chance(m->r, 0.2) ? disc.growth : any_rate(m->r);
    return disc;
}

static tdsp_disc make_touching(maker *m)
{
    tdsp_disc disc = disc_around(m->r, m->count, chance(m->r, 0.5) ? m->rate : any_rate(m->r));
    if (m->i == 0) return disc;
    const tdsp_disc other = m->discs[chance_index(m->r, (int)m->i)];
    const tdsp_point to = random_direction(m->r);
    const double away = other.radius + disc.radius;
    disc.center = (tdsp_point){other.center.x + away * to.x, other.center.y + away * to.y};
    return disc;
}

static tdsp_disc wall_disc(maker *m, double x, size_t place, size_t places)
{
    const double step = 1.6 / (double)places, y = -0.8 + step * ((double)place + chance_between(m->r, 0.3, 0.7));
    const double rate = chance(m->r, 0.5) ? m->rate * 0.3 : chance_between(m->r, 0.0, 0.2);
    return disc_at(x, y, step * chance_between(m->r, 0.15, 0.45), rate);
}

static tdsp_disc make_wall(maker *m)
{
    return wall_disc(m, chance_between(m->r, -0.05, 0.05), m->i, m->count);
}

static tdsp_disc make_two_walls(maker *m)
{
    return wall_disc(m, m->i % 2 == 0 ? -0.4 : 0.4, m->i / 2, (m->count + 1) / 2);
}

static tdsp_disc make_emerging(maker *m)
{
    if (m->i % 2 == 0) {
        const double rate = chance_between(m->r, 0.0, 0.2), radius = chance_between(m->r, 0.1, 0.4), y = chance_between(m->r, -0.3, 0.3);
        return disc_at(chance_between(m->r, -0.4, 0.4), y, radius, rate);
    }
    const tdsp_disc slow = m->discs[m->i - 1];
    const tdsp_point to = random_direction(m->r);
    const double away = slow.radius * chance_between(m->r, 0.0, 0.9), room = slow.radius - away;
    const double rate = slow.growth + chance_between(m->r, 0.02, 0.4);
    return disc_at(slow.center.x + away * to.x, slow.center.y + away * to.y, room * chance_between(m->r, 0.0, 1.0), rate);
}

static tdsp_disc make_swallowed(maker *m)
{
    if (m->i == 0) {
        const double rate = chance_between(m->r, 0.1, 0.6), radius = chance_between(m->r, 0.05, 0.3), y = chance_between(m->r, -0.1, 0.1);
        return disc_at(chance_between(m->r, -0.2, 0.2), y, radius, rate);
    }
    const tdsp_disc fast = m->discs[0];
    const tdsp_point to = random_direction(m->r);
    const double radius = fast.radius * chance_between(m->r, 0.005, 0.3),
                 away = fast.radius + radius * chance_between(m->r, -0.8, 6.0);
    return disc_at(fast.center.x + away * to.x, fast.center.y + away * to.y, radius,
                   chance(m->r, 0.5) ? 0.0 : chance_between(m->r, 0.0, 0.1));
}

/* A disc whose boundary runs through a point, exactly: multiples of 1/64 and the triangle 3, 4, 5. */
static tdsp_disc disc_through(maker *m, tdsp_point end, double inward)
{
    static const double directions[][2] = {{3, 4}, {4, -3}, {5, 0}, {0, 5}, {0, -5}, {4, 3}};
    const double *to = directions[chance_index(m->r, 6)];
    const double part = (double)(1 + chance_index(m->r, 6)) / 64.0;
    return disc_at(end.x + inward * part * to[0], end.y + part * to[1], 5.0 * part, chance(m->r, 0.5) ? 0.0 : any_rate(m->r));
}

static tdsp_disc make_on_source(maker *m)
{
    m->source_open = 0.0;
    if (m->i > 1) return disc_around(m->r, m->count, any_rate(m->r));
    if (m->i == 1 && chance(m->r, 0.4)) return disc_at(m->journey->source.x, m->journey->source.y, 0.0, any_rate(m->r));
    return disc_through(m, m->journey->source, chance(m->r, 0.8) ? 1.0 : -1.0);
}

static tdsp_disc make_on_destination(maker *m)
{
    if (m->i > 0) return disc_around(m->r, m->count, any_rate(m->r));
    tdsp_disc disc = disc_through(m, m->journey->destination, chance(m->r, 0.8) ? -1.0 : 1.0);
    disc.growth = 0.0;
    return disc;
}

static tdsp_disc make_collinear(maker *m)
{
    const double cell = 0.25;
    if (chance(m->r, 0.5)) {
        const double radius = 0.125 * (1 + chance_index(m->r, 2));
        return disc_at(cell * (double)(chance_index(m->r, 7) - 3), 0.0, radius, m->rate);
    }
    const double rate = chance(m->r, 0.5) ? m->rate : 0.125, y = cell * (double)(chance_index(m->r, 5) - 2);
    return disc_at(cell * (double)(chance_index(m->r, 7) - 3), y, 0.125, rate);
}

static tdsp_disc ring_disc(maker *m, tdsp_point middle)
{
    static const double corners[][2] = {{1, 0}, {0.5, 0.866}, {-0.5, 0.866}, {-1, 0}, {-0.5, -0.866}, {0.5, -0.866}};
    const double *to = corners[m->i % 6], away = 0.35 + 0.3 * (double)(m->i / 6);
    const double rate = chance_between(m->r, 0.0, 0.15);
    return disc_at(middle.x + away * to[0], middle.y + away * to[1], away * chance_between(m->r, 0.3, 0.49), rate);
}

static tdsp_disc make_prison(maker *m)
{
    return ring_disc(m, m->journey->source);
}

static tdsp_disc make_fortress(maker *m)
{
    tdsp_disc disc = ring_disc(m, m->journey->destination);
    if (chance(m->r, 0.3)) disc.growth = any_rate(m->r) * 0.3;
    return disc;
}

#define make_large_units make_mixed_rates
#define make_small_units make_mixed_rates
#define make_far_origin make_mixed_rates

typedef tdsp_disc (*make_disc)(maker *m);

static const struct {
    const char *name;
    make_disc make;
} mixes[RANDOM_MIX_COUNT] = {
#define X(upper, lower, text) {#lower, make_##lower},
    RANDOM_MIXES(X)
#undef X
};

const char *random_mix_name(random_mix mix)
{
    return mixes[mix].name;
}

static int covers(const tdsp_disc *disc, tdsp_point point, double time)
{
    const double dx = point.x - disc->center.x, dy = point.y - disc->center.y;
    return sqrt(dx * dx + dy * dy) < disc->radius + disc->growth * time;
}

static int leaves_open(const maker *m, const tdsp_disc *disc, double share)
{
    return !covers(disc, m->journey->source, share * m->source_open) &&
           !covers(disc, m->journey->destination, share * m->destination_open);
}

/* A disc that covers an end too early is drawn again, then with less said about when, and in the end made small. */
static tdsp_disc make_valid(maker *m, make_disc make)
{
    for (int tries = 0; tries < 200; tries++) {
        const tdsp_disc disc = make(m);
        if (leaves_open(m, &disc, tries < 160 ? 1.0 : 0.0)) return disc;
    }
    return disc_at(0.0, 0.4, 0.05, m->rate * 0.2);
}

/* The scene in other units, turned and moved. */
typedef struct placement {
    double cosine, sine, scale, speed;
    tdsp_point shift;
} placement;

static tdsp_point placed(const placement *p, tdsp_point a)
{
    return (tdsp_point){p->shift.x + p->scale * (p->cosine * a.x - p->sine * a.y),
                        p->shift.y + p->scale * (p->sine * a.x + p->cosine * a.y)};
}

static placement choose_placement(uint64_t *r, random_mix mix)
{
    placement p = {1.0, 0.0, 1.0, 1.0, {0.0, 0.0}};
    if (mix == RANDOM_COLLINEAR || mix == RANDOM_ON_SOURCE || mix == RANDOM_ON_DESTINATION || chance(r, 0.2)) return p;
    const tdsp_point to = random_direction(r);
    p.cosine = to.x;
    p.sine = to.y;
    p.speed = chance_between(r, 0.5, 3.0);
    p.scale = chance_between(r, 1.0, 20.0);
    if (mix == RANDOM_LARGE_UNITS) p.scale *= 1e6;
    if (mix == RANDOM_SMALL_UNITS) p.scale *= 1e-3;
    if (mix == RANDOM_FAR_ORIGIN) {
        p.shift.x = p.scale * chance_between(r, -1e3, 1e3);
        p.shift.y = p.scale * chance_between(r, -1e3, 1e3);
    }
    return p;
}

static void place_scene(const placement *p, size_t count, tdsp_journey *journey, tdsp_disc *discs)
{
    journey->speed *= p->speed;
    journey->radius *= p->scale;
    journey->source = placed(p, journey->source);
    journey->destination = placed(p, journey->destination);
    for (size_t i = 0; i < count; i++) {
        discs[i].center = placed(p, discs[i].center);
        discs[i].radius *= p->scale;
        discs[i].growth *= p->speed;
    }
}

void random_scene(uint64_t seed, random_mix mix, size_t count, tdsp_journey *journey, tdsp_disc *discs)
{
    uint64_t r = seed * 1000003u + (uint64_t)mix;
    *journey = (tdsp_journey){1.0, 0.0, {-1.0, 0.0}, {1.0, 0.0}};
    maker m = {&r, 0, count, chance_between(&r, 0.0, 0.25), discs, journey, 0.0, 0.0};
    if (chance(&r, 0.9)) {
        m.source_open = chance_between(&r, 0.0, 2.0);
        m.destination_open = chance_between(&r, 2.0, 2.5) + m.source_open;
    }
    for (m.i = 0; m.i < count; m.i++)
        discs[m.i] = make_valid(&m, mixes[mix].make);
    if (mix == RANDOM_FAR_ORIGIN) {
        /* Part of each radius is the robot's. */
        journey->radius = 0.01;
        for (size_t i = 0; i < count; i++)
            discs[i].radius = discs[i].radius > 0.01 ? discs[i].radius - 0.01 : 0.0;
    }
    const placement p = choose_placement(&r, mix);
    place_scene(&p, count, journey, discs);
}
