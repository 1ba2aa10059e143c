/* SPDX-License-Identifier: MIT */
/* See hard.h. Made from sums, products and square roots, so that a seed gives the same scene everywhere. */
#include "numerics/hard.h"

#include <math.h>

#include "support/chance.h"

typedef struct hard_maker {
    uint64_t chance;
    tdsp_journey *journey;
    tdsp_disc *discs;
    double first;
} hard_maker;

static const struct {
    const char *name, *text;
} mixes[HARD_MIX_COUNT] = {
#define X(upper, lower, text) {#lower, text},
    HARD_MIXES(X)
#undef X
};

const char *hard_mix_name(hard_mix mix)
{
    return mixes[mix].name;
}

const char *hard_mix_text(hard_mix mix)
{
    return mixes[mix].text;
}

static double between(hard_maker *m, double low, double high)
{
    return chance_between(&m->chance, low, high);
}

static int one_in(hard_maker *m, uint64_t n)
{
    return chance_below(&m->chance, n) == 0;
}

/* A power of ten with a mantissa, between 10^-most and 10^-least. */
static double little(hard_maker *m, int least, int most)
{
    double value = between(m, 1.0, 10.0);
    for (uint64_t k = (uint64_t)least + 1 + chance_below(&m->chance, (uint64_t)(most - least)); k > 0; k--) value /= 10.0;
    return value;
}

static double either_sign(hard_maker *m, double value)
{
    return one_in(m, 2) ? value : -value;
}

static tdsp_disc disc_at(double x, double y, double radius, double rate)
{
    return (tdsp_disc){{x, y}, radius > 0.0 ? radius : 0.0, rate};
}

static tdsp_disc any_disc(hard_maker *m, double rate)
{
    return disc_at(between(m, -0.6, 0.6), between(m, -0.5, 0.5), between(m, 0.02, 0.3), rate);
}

/*
 * A disc that touches the straight way from the source at `depart`: seen along the way its centre is L - c R ahead and s R aside at the contact, R
 * being the radius then.
 */
static tdsp_disc touching(hard_maker *m, double rate, double aside, double depart, double deeper)
{
    const double x = between(m, -0.6, 0.6), y = either_sign(m, aside), reached = aside / sqrt((1.0 - rate) * (1.0 + rate));
    const double length = x + 1.0 + rate * reached;
    return disc_at(x, y, reached - rate * (length + depart) + deeper, rate);
}

static size_t make_tangent(hard_maker *m)
{
    const size_t count = 1 + chance_below(&m->chance, 5);
    for (size_t i = 0; i < count; i++) {
        const double deeper = either_sign(m, little(m, 3, 17));
        m->discs[i] = one_in(m, 3) ? any_disc(m, between(m, 0.0, 0.4)) : touching(m, between(m, 0.0, 0.3), between(m, 0.2, 0.5), 0.0, deeper);
    }
    return count;
}

/* Two discs on either side of the way, which they nearly close. */
static size_t make_needles(hard_maker *m)
{
    const size_t pairs = 1 + chance_below(&m->chance, 3);
    const double depart = one_in(m, 2) ? 0.0 : between(m, 0.0, 0.3), rate = one_in(m, 3) ? 0.0 : between(m, 0.0, 0.3);
    m->first = depart;
    for (size_t i = 0; i < pairs; i++) {
        const double x = -0.6 + 0.6 * (double)i, y = between(m, 0.25, 0.5), gap = little(m, 3, 15);
        const double shift = between(m, -0.1, 0.1), radius = y - rate * (x + 1.0 + depart) - gap;
        m->discs[2 * i] = disc_at(x, y + shift, radius, rate);
        m->discs[2 * i + 1] = disc_at(x + (one_in(m, 2) ? 0.0 : between(m, -0.1, 0.1)), -y + shift, radius, one_in(m, 2) ? rate : rate + little(m, 3, 9));
    }
    return 2 * pairs;
}

static size_t make_same_rates(hard_maker *m)
{
    const size_t count = 2 + chance_below(&m->chance, 4);
    const double rate = between(m, 0.0, 0.5);
    for (size_t i = 0; i < count; i++) m->discs[i] = any_disc(m, rate + little(m, 5, 16));
    return count;
}

static size_t make_near_speed(hard_maker *m)
{
    const size_t count = 1 + chance_below(&m->chance, 4);
    for (size_t i = 0; i < count; i++) {
        /* Farther from the destination than the source is, or no path would be in time. */
        const double y = either_sign(m, between(m, 0.0, 1.0)), away = 2.0 + between(m, 0.001, 0.2), x = 1.0 - sqrt(away * away - y * y);
        const double beside = sqrt((x + 1.0) * (x + 1.0) + y * y);
        m->discs[i] = i > 0 && one_in(m, 2) ? any_disc(m, between(m, 0.0, 0.3)) : disc_at(x, y, beside * between(m, 0.0, 1.0), 1.0 - little(m, 3, 12));
    }
    return count;
}

static size_t make_company(hard_maker *m)
{
    const size_t count = 1 + chance_below(&m->chance, 5);
    for (size_t i = 0; i < count; i++) m->discs[i] = any_disc(m, one_in(m, 4) ? 0.0 : between(m, 0.0, 0.4));
    return count;
}

static void place(hard_maker *m, size_t count, double scale, double speed, double x, double y)
{
    tdsp_point *points[HARD_MOST_DISCS + 2] = {&m->journey->source, &m->journey->destination};
    for (size_t i = 0; i < count; i++) points[i + 2] = &m->discs[i].center;
    for (size_t i = 0; i < count + 2; i++) *points[i] = (tdsp_point){x + scale * points[i]->x, y + scale * points[i]->y};
    for (size_t i = 0; i < count; i++) {
        m->discs[i].radius *= scale;
        m->discs[i].growth *= speed;
    }
    m->journey->speed *= speed;
    m->journey->radius *= scale;
}

static size_t make_far_away(hard_maker *m)
{
    const size_t count = make_company(m);
    m->journey->radius = 0.01;
    double far = 1.0 / little(m, 2, 8);
    place(m, count, 1.0, 1.0, either_sign(m, far), either_sign(m, far * between(m, 0.0, 1.0)));
    return count;
}

static double any_speed(hard_maker *m)
{
    return one_in(m, 2) ? little(m, 0, 6) : 1.0 / little(m, 0, 6);
}

static size_t make_tiny(hard_maker *m)
{
    const size_t count = make_company(m);
    place(m, count, 1e-9 * between(m, 0.5, 2.0), any_speed(m), 0.0, 0.0);
    return count;
}

static size_t make_huge_units(hard_maker *m)
{
    const size_t count = make_company(m);
    place(m, count, 1e9 * between(m, 0.5, 2.0), any_speed(m), 0.0, 0.0);
    return count;
}

/* A seed beside the source that grows nearly as fast as the robot, or a disc that fills nearly all of the way. */
static size_t make_long_rides(hard_maker *m)
{
    const double rate = between(m, 0.5, 0.95);
    m->discs[0] = disc_at(-1.0 + between(m, 0.005, 0.1), either_sign(m, little(m, 2, 7)), little(m, 6, 9), rate);
    if (one_in(m, 2)) m->discs[0] = disc_at(0.0, either_sign(m, little(m, 2, 15)), 1.0 - little(m, 2, 10), 0.0);
    m->discs[1] = any_disc(m, between(m, 0.0, 0.2));
    return 1 + chance_below(&m->chance, 2);
}

static size_t make_slalom(hard_maker *m)
{
    const size_t count = 6 + chance_below(&m->chance, HARD_MOST_DISCS - 5);
    const double step = 1.6 / (double)count, rate = between(m, 0.0, 0.03);
    for (size_t i = 0; i < count; i++) {
        const double x = -0.8 + step * ((double)i + 0.5), y = (i % 2 ? 1.0 : -1.0) * step * between(m, 0.2, 0.7);
        m->discs[i] = disc_at(x, y, step * between(m, 0.3, 0.75), one_in(m, 2) ? rate : between(m, 0.0, 0.03));
    }
    return count;
}

static size_t make_late(hard_maker *m)
{
    const size_t count = 1 + chance_below(&m->chance, 5);
    m->first = 1.0 / little(m, 2, 7);
    for (size_t i = 0; i < count; i++) {
        m->discs[i] = any_disc(m, one_in(m, 4) ? 0.0 : between(m, 0.0, 0.2) / m->first);
        m->discs[i].radius *= 0.5;
    }
    return count;
}

size_t hard_scene(uint64_t seed, hard_mix mix, tdsp_journey *journey, tdsp_disc discs[HARD_MOST_DISCS], double *first)
{
    static size_t (*const make[HARD_MIX_COUNT])(hard_maker *) = {
#define X(upper, lower, text) make_##lower,
        HARD_MIXES(X)
#undef X
    };
    hard_maker m = {seed * 1000003u + 977u * (uint64_t)mix, journey, discs, 0.0};
    *journey = (tdsp_journey){1.0, 0.0, {-1.0, 0.0}, {1.0, 0.0}};
    const size_t count = make[mix](&m);
    *first = m.first;
    return count;
}
