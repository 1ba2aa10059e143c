/* SPDX-License-Identifier: MIT */
/*
 * Scenes that random numbers never make: every maker below starts from something that holds exactly (a line that touches three discs, two boundaries that
 * meet where and when the robot is) and works back to radii at time 0; rounding then puts the scene on one side of it or on the other.
 * The journey is from (-1, 0) to (1, 0) with speed 1.
 */
#include "soak/mixes.h"

#include <math.h>

#include "support/chance.h"

typedef struct maker {
    uint64_t *r;
    size_t count;
    soak_scene *scene;
} maker;

static double between(maker *m, double low, double high)
{
    return chance_between(m->r, low, high);
}

static int likely(maker *m, double share)
{
    return chance_unit(m->r) < share;
}

/* 10 to a power between two. */
static double power(maker *m, double low, double high)
{
    return pow(10.0, between(m, low, high));
}

static tdsp_point direction(maker *m)
{
    const double angle = between(m, 0.0, 6.283185307179586);
    return (tdsp_point){cos(angle), sin(angle)};
}

static double some_rate(maker *m)
{
    const double share = chance_unit(m->r);
    return share < 0.25 ? 0.0 : share < 0.8 ? between(m, 0.0, 0.2) : between(m, 0.0, 0.95);
}

static void add_any(maker *m)
{
    const double radius = between(m, 0.02, 0.4) / sqrt((double)m->count);
    soak_add(m->scene, (tdsp_point){between(m, -0.9, 0.9), between(m, -0.6, 0.6)}, radius, some_rate(m));
}

/* In most scenes something else is about. */
static void add_company(maker *m)
{
    while (m->scene->count < m->count) add_any(m);
}

/* A disc that a robot at x(time) = from + (time - begin) u touches at `time`, on its left (+1) or right (-1): u . n = V there. */
static void add_tangent(maker *m, tdsp_point from, tdsp_point u, double begin, double time, double side)
{
    const double rate = some_rate(m), across = side * sqrt(1.0 - rate * rate), far = time - begin;
    const double radius = fmax(rate * time, between(m, 0.02, 0.4));
    const tdsp_point n = {rate * u.x + across * u.y, rate * u.y - across * u.x};
    soak_add(m->scene, (tdsp_point){from.x + far * u.x - radius * n.x, from.y + far * u.y - radius * n.y}, radius - rate * time,
             rate);
}

static void make_tangent_triple(maker *m)
{
    const tdsp_point from = m->scene->journey.source;
    const double lean = likely(m, 0.4) ? 0.0 : between(m, -0.3, 0.3), begin = likely(m, 0.5) ? 0.0 : between(m, 0.0, 1.0);
    const tdsp_point u = {cos(lean), sin(lean)};
    const size_t touched = 3 + (size_t)chance_below(m->r, 2);
    m->scene->moment = begin;
    for (size_t k = 0; k < touched; k++)
        add_tangent(m, from, u, begin, begin + between(m, 0.1, 1.9), likely(m, 0.5) ? 1.0 : -1.0);
    if (likely(m, 0.5)) add_company(m);
}

/* Two discs on either side of the way whose corner comes down to the robot's speed when the robot is there, or which touch when it is between. */
static void add_closing(maker *m, double begin, double x)
{
    const double half = between(m, 0.05, 0.5), rate = likely(m, 0.2) ? 0.0 : between(m, 0.0, 0.3), sine = sqrt(1.0 - rate * rate);
    if (likely(m, 0.5)) {
        const double radius = half / sine, time = begin + x + 1.0 + radius * rate, first = fmax(0.0, radius - rate * time);
        soak_add(m->scene, (tdsp_point){x, half}, first, rate);
        soak_add(m->scene, (tdsp_point){x, -half}, first, rate);
        return;
    }
    const double time = begin + x + 1.0, upper = half * between(m, 0.5, 1.5), lower = 2.0 * half - upper, other = some_rate(m);
    soak_add(m->scene, (tdsp_point){x, upper}, upper - rate * time, rate);
    soak_add(m->scene, (tdsp_point){x, -lower}, lower - other * time, other);
}

static void make_closing_exactly(maker *m)
{
    const double begin = likely(m, 0.3) ? 0.0 : between(m, 0.0, 2.0);
    m->scene->moment = begin;
    for (size_t pairs = 1 + (size_t)chance_below(m->r, 3); pairs > 0; pairs--) add_closing(m, begin, between(m, -0.8, 0.8));
    if (likely(m, 0.5)) add_company(m);
}

/* A column of discs with next to no room between each two. */
static void make_needle(maker *m)
{
    const double x = between(m, -0.5, 0.5), rate = likely(m, 0.5) ? 0.0 : power(m, -14.0, -2.0),
                 time = rate > 0.0 ? between(m, 0.0, 2.0) : 0.0;
    double y = -between(m, 0.1, 0.8);
    m->scene->moment = rate > 0.0 ? time : -1.0;
    for (size_t k = 0; k < m->count; k++) {
        const double radius = between(m, 0.03, 0.4);
        y += radius;
        soak_add(m->scene, (tdsp_point){x + (likely(m, 0.5) ? 0.0 : between(m, -0.01, 0.01)), y},
                 radius - rate * (time + x + 1.0), rate);
        y += radius + power(m, -13.0, -6.0) * (likely(m, 0.8) ? 1.0 : -1.0);
    }
}

/* Each touches one of those before at a common moment, from outside or from inside. */
static void make_kissing(maker *m)
{
    const double time = likely(m, 0.5) ? 0.0 : between(m, 0.0, 3.0);
    m->scene->moment = time > 0.0 ? fmax(0.0, time - between(m, 0.0, 1.5)) : -1.0;
    add_any(m);
    while (m->scene->count < m->count) {
        const size_t with = (size_t)chance_below(m->r, m->scene->count);
        const soak_disc other = m->scene->discs[with];
        const double rate = likely(m, 0.4) ? other.growth.rate : some_rate(m), theirs = soak_radius(m->scene, with, time);
        const double radius = rate * time + between(m, 0.02, 0.3),
                     away = likely(m, 0.7) ? theirs + radius : fabs(theirs - radius);
        const tdsp_point to = likely(m, 0.3) ? (tdsp_point){likely(m, 0.5) ? 1.0 : -1.0, 0.0} : direction(m);
        soak_add(m->scene, (tdsp_point){other.center.x + away * to.x, other.center.y + away * to.y}, radius - rate * time, rate);
    }
}

static void make_coincident(maker *m)
{
    const tdsp_journey *j = &m->scene->journey;
    while (m->scene->count < m->count) {
        const uint64_t kind = chance_below(m->r, 8);
        const size_t last = m->scene->count - 1;
        if (m->scene->count == 0 || kind < 2)
            add_any(m);
        else if (kind == 2)
            soak_add(m->scene, m->scene->discs[last].center, m->scene->discs[last].radius, m->scene->discs[last].growth.rate);
        else if (kind == 3)
            soak_add(m->scene, j->destination, 0.0, likely(m, 0.5) ? 0.0 : power(m, -12.0, -1.0));
        else if (kind == 4)
            soak_add(m->scene, j->source, 0.0, likely(m, 0.5) ? 0.0 : power(m, -12.0, -1.0));
        else
            soak_add(m->scene, m->scene->discs[last].center, likely(m, 0.3) ? m->scene->discs[last].radius : between(m, 0.0, 0.4),
                     some_rate(m));
    }
}

static void make_equal_radii(maker *m)
{
    const double radius = between(m, 0.02, 0.4), rate = some_rate(m), turn = between(m, 0.0, 6.28), around = between(m, 0.1, 0.9);
    const int ring = likely(m, 0.5);
    for (size_t k = 0; k < m->count; k++) {
        const double angle = turn + 6.283185307179586 * (double)k / (double)m->count;
        const tdsp_point at = {between(m, -0.9, 0.9), between(m, -0.6, 0.6)};
        soak_add(m->scene, ring ? (tdsp_point){around * cos(angle), around * sin(angle)} : at, radius, rate);
    }
}

static void make_lattice(maker *m)
{
    static const double cells[] = {0.25, 0.5, 0.125}, radii[] = {0.5, 0.25, 0.375, 0.5};
    const double cell = cells[chance_below(m->r, 3)], radius = cell * radii[chance_below(m->r, 4)],
                 low = likely(m, 0.5) ? 0.0 : 0.5 * cell;
    const double rate = likely(m, 0.3) ? 0.0 : likely(m, 0.5) ? 0.0625 : between(m, 0.0, 0.2);
    const size_t columns = 1 + (size_t)chance_below(m->r, 4), rows = 1 + m->count / columns;
    const double skip = between(m, 0.0, 0.4);
    for (size_t i = 0; i < columns * rows; i++) {
        if (likely(m, skip)) continue;
        const double x = cell * ((double)(i % columns) - floor(0.5 * (double)columns)),
                     y = low + cell * ((double)(i / columns) - floor(0.5 * (double)rows));
        soak_add(m->scene, (tdsp_point){x, y}, radius, rate);
    }
}

static void other_units(maker *m, double length)
{
    const grown_change change = {{1.0, 0.0}, {0.0, 0.0}, length, likely(m, 0.5) ? length : 1.0, 0};
    add_company(m);
    soak_place(m->scene, &change);
}

static void make_huge(maker *m)
{
    other_units(m, power(m, 8.0, 9.0));
}

static void make_tiny(maker *m)
{
    other_units(m, power(m, -9.0, -7.0));
}

static void make_far_away(maker *m)
{
    const double far = power(m, 5.0, 9.0);
    const tdsp_point to = direction(m);
    const grown_change change = {{1.0, 0.0}, {far * to.x, far * to.y}, 1.0, 1.0, 0};
    add_company(m);
    soak_place(m->scene, &change);
}

/* Great ones begin so far off that the ends are free. */
static void make_unlike_sizes(maker *m)
{
    for (size_t k = 0; k < m->count; k++) {
        const double radius = power(m, -9.0, likely(m, 0.5) ? -1.0 : 9.0), rate = likely(m, 0.5) ? 0.0 : power(m, -9.0, -0.1);
        const double away = radius < 0.3 ? between(m, 0.0, 0.8) : radius + between(m, 0.0, 1.2);
        const tdsp_point to = direction(m);
        soak_add(m->scene, (tdsp_point){away * to.x, away * to.y}, radius, rate);
    }
}

static void make_near_equal_rates(maker *m)
{
    const double rate = between(m, 0.0, likely(m, 0.8) ? 0.3 : 0.95);
    while (m->scene->count < m->count) {
        add_any(m);
        soak_disc *disc = &m->scene->discs[m->scene->count - 1];
        disc->growth.rate = rate * (1.0 + power(m, -16.0, -9.0) * (double)((int)chance_below(m->r, 3) - 1));
        if (m->scene->count > 1 && likely(m, 0.3)) disc->radius = disc[-1].radius;
    }
}

/* They begin far enough from both ends for an arrival, or beside the source, for they would cover everything soon. */
static void make_near_speed(maker *m)
{
    while (m->scene->count < m->count) {
        const double off = power(m, -16.0, -11.9) * (double)((int)chance_below(m->r, 3) - 1), radius = between(m, 0.0, 0.2);
        const tdsp_point to = direction(m);
        const double far = radius + (likely(m, 0.5) ? between(m, 0.01, 0.5) : between(m, 1.0, 4.0));
        if (likely(m, 0.5))
            add_any(m);
        else
            soak_add(m->scene, (tdsp_point){far * to.x - 1.0, far * to.y}, radius, 1.0 + off);
    }
}

static void make_crowd(maker *m)
{
    const size_t count = likely(m, 0.1) ? 100 + (size_t)chance_below(m->r, 300) : 20 + (size_t)chance_below(m->r, 80);
    const double size = between(m, 0.3, 1.4) / sqrt((double)count), rate = between(m, 0.0, 0.1);
    for (size_t k = 0; k < count; k++) {
        const tdsp_point at = {between(m, -1.2, 1.2), between(m, -1.0, 1.0)};
        const double radius = size * between(m, 0.3, 1.0), away = fmin(hypot(at.x + 1.0, at.y), hypot(at.x - 1.0, at.y));
        if (away > radius + 0.05) soak_add(m->scene, at, radius, likely(m, 0.5) ? rate : between(m, 0.0, 0.1));
    }
}

static void make_near_ends(maker *m)
{
    tdsp_journey *j = &m->scene->journey;
    j->destination = j->source;
    if (likely(m, 0.9)) j->destination.x += power(m, -9.0, -3.0);
    add_company(m);
}

/* Those made of another generator's scenes are mixes.c's. */
void soak_degenerate(soak_mix mix, uint64_t *chance, size_t count, soak_scene *scene)
{
    static void (*const makers[SOAK_MIX_COUNT])(maker *m) = {
        [SOAK_MIX_tangent_triple] = make_tangent_triple,
        [SOAK_MIX_closing_exactly] = make_closing_exactly,
        [SOAK_MIX_needle] = make_needle,
        [SOAK_MIX_kissing] = make_kissing,
        [SOAK_MIX_coincident] = make_coincident,
        [SOAK_MIX_equal_radii] = make_equal_radii,
        [SOAK_MIX_lattice] = make_lattice,
        [SOAK_MIX_huge] = make_huge,
        [SOAK_MIX_tiny] = make_tiny,
        [SOAK_MIX_far_away] = make_far_away,
        [SOAK_MIX_unlike_sizes] = make_unlike_sizes,
        [SOAK_MIX_near_equal_rates] = make_near_equal_rates,
        [SOAK_MIX_near_speed] = make_near_speed,
        [SOAK_MIX_crowd] = make_crowd,
        [SOAK_MIX_near_ends] = make_near_ends,
    };
    maker m = {chance, count, scene};
    if (makers[mix]) makers[mix](&m);
}
