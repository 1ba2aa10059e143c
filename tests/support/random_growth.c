/* SPDX-License-Identifier: MIT */
/*
 * Laws are made for the journey from (-1, 0) to (1, 0) of a robot with speed 1, which takes 2, and for times up to SPAN; afterwards the scene is
 * turned, scaled and moved. A polynomial is made as its rate, a product of factors that are not negative up to SPAN at least or up to where
 * the scene's answers end, and integrated.
 */
#include "support/random_growth.h"

#include <math.h>
#include <string.h>

#include "support/chance.h"

#define SPAN 8.0

typedef struct maker {
    uint64_t *r;
    grown_scene *scene;
    size_t i;
    double source_open, destination_open; /* until when no disc covers them, where that can be had */
} maker;

typedef void (*make_law)(maker *m, tdsp_growing_disc *disc);

static int chance(uint64_t *r, double share)
{
    return chance_unit(r) < share;
}

/* A unit vector, uniform, from sums and square roots alone. */
static tdsp_point random_direction(uint64_t *r)
{
    for (;;) {
        const double x = chance_between(r, -1.0, 1.0), y = chance_between(r, -1.0, 1.0), n = x * x + y * y;
        if (n > 0.01 && n <= 1.0) return (tdsp_point){x / sqrt(n), y / sqrt(n)};
    }
}

static double slow_rate(uint64_t *r)
{
    return chance_between(r, 0.0, chance(r, 0.6) ? 0.12 : 0.35);
}

static double peak_rate(uint64_t *r)
{
    const double share = chance_unit(r);
    if (share < 0.55) return chance_between(r, 0.02, 0.35);
    return share < 0.85 ? chance_between(r, 0.3, 0.95) : chance_between(r, 0.9, 1.6);
}

/* ----------------------------------------------------------------------------------------------------------- polynomials */

/* A rate as a polynomial in time, of degree GROWTH_MOST_VALUES - 1 at most. */
typedef struct rate_powers {
    double c[GROWTH_MOST_VALUES];
} rate_powers;

static double rate_value(const rate_powers *p, double time)
{
    double sum = 0.0;
    for (int k = GROWTH_MOST_VALUES - 1; k >= 0; k--) sum = sum * time + p->c[k];
    return sum;
}

/* Times a + b t. */
static void rate_multiply(rate_powers *p, double a, double b)
{
    for (int k = GROWTH_MOST_VALUES - 1; k >= 0; k--) p->c[k] = a * p->c[k] + (k > 0 ? b * p->c[k - 1] : 0.0);
}

static void rate_scale(rate_powers *p, double peak, double span)
{
    double most = 0.0;
    for (int i = 0; i <= 200; i++) most = fmax(most, rate_value(p, span * i / 200.0));
    for (int k = 0; k < GROWTH_MOST_VALUES; k++) p->c[k] *= peak / most;
}

static void grow_by_powers(maker *m, tdsp_growing_disc *disc, const rate_powers *p)
{
    double *values = m->scene->values[m->i];
    size_t count = 1;
    for (size_t k = 0; k < GROWTH_MOST_VALUES; k++) {
        values[k] = p->c[k] / (double)(k + 1);
        if (values[k] != 0.0) count = k + 1;
    }
    disc->growth = (tdsp_growth){.kind = TDSP_GROWTH_POLYNOMIAL, .count = count, .values = values};
}

static void make_convex(maker *m, tdsp_growing_disc *disc)
{
    rate_powers p = {{chance_between(m->r, 0.0, 0.3)}};
    const size_t power = 1 + (size_t)chance_below(m->r, GROWTH_MOST_VALUES - 1);
    double span = 1.0;
    for (size_t k = 0; k < power; k++) span *= SPAN * chance_between(m->r, 0.3, 1.0);
    p.c[power] = chance_between(m->r, 0.05, 1.3) / span;
    if (chance(m->r, 0.5)) p.c[1] += chance_between(m->r, 0.0, 0.1);
    grow_by_powers(m, disc, &p);
}

/* c (t / T)^up (1 - t / T)^down, with its greatest value given. */
static void make_bump(maker *m, tdsp_growing_disc *disc, int up, int down, double span, double peak)
{
    rate_powers p = {{1.0}};
    for (int i = 0; i < up; i++) rate_multiply(&p, 0.0, 1.0 / span);
    for (int i = 0; i < down; i++) rate_multiply(&p, 1.0, -1.0 / span);
    rate_scale(&p, peak, span);
    grow_by_powers(m, disc, &p);
}

static void make_concave(maker *m, tdsp_growing_disc *disc)
{
    const double span = chance(m->r, 0.7) ? chance_between(m->r, SPAN, 3.0 * SPAN) : chance_between(m->r, 0.4 * SPAN, SPAN);
    const double peak = peak_rate(m->r);
    make_bump(m, disc, 0, 1 + (int)chance_below(m->r, 7), span, peak);
}

static void make_s_shaped(maker *m, tdsp_growing_disc *disc)
{
    const int up = 1 + (int)chance_below(m->r, 4), down = 1 + (int)chance_below(m->r, 3);
    const double peak = peak_rate(m->r);
    make_bump(m, disc, up, down, SPAN * chance_between(m->r, 0.5, 1.8), peak);
}

static void make_wavy(maker *m, tdsp_growing_disc *disc)
{
    rate_powers p = {{1.0}};
    for (size_t zeros = 1 + (size_t)chance_below(m->r, 3); zeros > 0; zeros--) {
        const double zero = SPAN * chance_between(m->r, 0.05, 1.0);
        rate_multiply(&p, 1.0, -1.0 / zero);
        rate_multiply(&p, 1.0, -1.0 / zero);
    }
    rate_scale(&p, chance_between(m->r, 0.1, 3.0), SPAN);
    grow_by_powers(m, disc, &p);
}

static void make_steep(maker *m, tdsp_growing_disc *disc)
{
    const double peak = chance(m->r, 0.3) ? chance_between(m->r, 0.99, 1.01) : chance_between(m->r, 0.7, 2.0);
    const int up = (int)chance_below(m->r, 4);
    make_bump(m, disc, up, 7 - up, SPAN * chance_between(m->r, 0.6, 1.5), peak);
}

static void make_nearly_one_rate(maker *m, tdsp_growing_disc *disc)
{
    static const double sizes[] = {1e-14, 1e-10, 1e-7, 1e-4, 1e-2};
    rate_powers p = {{0.02 + slow_rate(m->r)}};
    const size_t power = 1 + (size_t)chance_below(m->r, 4);
    double size = sizes[chance_below(m->r, 5)] * p.c[0];
    if (!chance(m->r, 0.5)) size = -size;
    for (size_t k = 0; k < power; k++) size /= SPAN;
    p.c[power] = size;
    grow_by_powers(m, disc, &p);
}

/* ------------------------------------------------------------------------------------------------------------ other laws */

static void make_steps(maker *m, tdsp_growing_disc *disc, double still, double fast)
{
    const size_t count = 2 + (size_t)chance_below(m->r, 4);
    double *values = m->scene->values[m->i], *times = m->scene->times[m->i], time = 0.0;
    for (size_t k = 0; k < count; k++) {
        const double kind = chance_unit(m->r);
        values[k] = kind < still ? 0.0 : kind < still + fast ? chance_between(m->r, 1.0, 2.5) : peak_rate(m->r) * 0.6;
        times[k] = time;
        time += values[k] >= 1.0 ? chance_between(m->r, 0.02, 0.3) : chance_between(m->r, 0.1, 2.0);
    }
    if (values[count - 1] > 0.5) values[count - 1] *= 0.2;
    disc->growth = (tdsp_growth){.kind = TDSP_GROWTH_RATES, .count = count, .values = values, .times = times};
}

static void make_rates(maker *m, tdsp_growing_disc *disc)
{
    make_steps(m, disc, 0.15, 0.0);
}

static void make_pulses(maker *m, tdsp_growing_disc *disc)
{
    make_steps(m, disc, 0.4, 0.25);
}

static void make_ripples(maker *m, tdsp_growing_disc *disc)
{
    static const double sizes[] = {1e-13, 1e-11, 1e-9, 1e-8, 1e-7, 1e-6, 1e-5, 1e-3};
    double *values = m->scene->values[m->i], *times = m->scene->times[m->i], time = 0.0, rate = 0.01 + slow_rate(m->r);
    for (size_t k = 0; k < GROWTH_MOST_VALUES; k++) {
        values[k] = rate;
        times[k] = time;
        const double size = sizes[chance_below(m->r, 8)];
        rate += size * chance_between(m->r, -1.0, 1.0);
        time += chance_between(m->r, 0.05, 0.8);
    }
    disc->growth = (tdsp_growth){.kind = TDSP_GROWTH_RATES, .count = GROWTH_MOST_VALUES, .values = values, .times = times};
}

static void make_two_rates(maker *m, tdsp_growing_disc *disc, double first, double second, double time)
{
    double *values = m->scene->values[m->i], *times = m->scene->times[m->i];
    values[0] = first;
    values[1] = second;
    times[0] = 0.0;
    times[1] = time;
    disc->growth = (tdsp_growth){.kind = TDSP_GROWTH_RATES, .count = 2, .values = values, .times = times};
}

static void make_delayed(maker *m, tdsp_growing_disc *disc)
{
    if (chance(m->r, 0.5)) disc->radius = 0.0;
    const double change = chance_between(m->r, 0.1, 3.0);
    make_two_rates(m, disc, 0.0, peak_rate(m->r), change);
}

static void make_capped(maker *m, tdsp_growing_disc *disc)
{
    const double change = chance_between(m->r, 0.1, 3.0);
    make_two_rates(m, disc, peak_rate(m->r), 0.0, change);
}

/* A part that begins at b and comes near its share S of the radius in a span w: S x / (1 + x), or S x^2 / (1 + x^2) where it begins gently. */
static void parts_law(void *ctx, double time, double *radius, double *rate)
{
    const grown_parts *p = ctx;
    *radius = p->radius;
    *rate = 0.0;
    for (size_t k = 0; k < p->count && time >= p->begins[k]; k++) {
        const double x = (time - p->begins[k]) / p->spans[k], below = p->sharp ? 1.0 + x : 1.0 + x * x;
        *radius += p->shares[k] * (p->sharp ? x : x * x) / below;
        *rate += p->shares[k] * (p->sharp ? 1.0 : 2.0 * x) / (below * below * p->spans[k]);
    }
}

static void make_parts(maker *m, tdsp_growing_disc *disc, int sharp, double span, double first)
{
    grown_parts *p = &m->scene->parts[m->i];
    double *times = m->scene->times[m->i], begin = first;
    *p = (grown_parts){.count = 1 + (size_t)chance_below(m->r, 3), .sharp = sharp, .radius = disc->radius};
    for (size_t k = 0; k < p->count; k++) {
        if (k > 0) begin += span * chance_between(m->r, 0.2, 1.0);
        p->begins[k] = begin;
        p->spans[k] = span * chance_between(m->r, 0.15, 1.0);
        p->shares[k] = p->spans[k] * peak_rate(m->r);
        times[k] = begin;
    }
    const size_t skipped = times[0] == 0.0 ? 1 : 0;
    disc->growth = (tdsp_growth){.kind = TDSP_GROWTH_LAW,
                                 .count = p->count - skipped,
                                 .times = times + skipped,
                                 .law = parts_law,
                                 .ctx = p,
                                 .until = 4.0 * SPAN};
}

static void make_by_law(maker *m, tdsp_growing_disc *disc)
{
    const double begin = chance(m->r, 0.5) ? 0.0 : chance_between(m->r, 0.3, 2.0);
    make_parts(m, disc, chance(m->r, 0.5), 2.0, begin);
}

/* The rate rises and falls while the robot is on its way: riders leave a disc and come back to it. */
static void make_bouncing(maker *m, tdsp_growing_disc *disc)
{
    make_parts(m, disc, 0, 0.6, chance_between(m->r, 0.3, 1.3));
}

static void make_one_rate(maker *m, tdsp_growing_disc *disc)
{
    disc->growth =
        (tdsp_growth){.kind = TDSP_GROWTH_RATE, .rate = chance(m->r, 0.9) ? slow_rate(m->r) : chance_between(m->r, 0.9, 1.5)};
}

static void make_any(maker *m, tdsp_growing_disc *disc)
{
    static const make_law laws[] = {make_convex, make_concave,         make_s_shaped, make_wavy,    make_bouncing,
                                    make_steep,  make_nearly_one_rate, make_rates,    make_pulses,  make_delayed,
                                    make_capped, make_by_law,          make_one_rate, make_one_rate};
    laws[chance_below(m->r, sizeof laws / sizeof *laws)](m, disc);
}

/* ---------------------------------------------------------------------------------------------------------------- scenes */

#define make_assorted make_any
#define make_cluster make_any
#define make_wall make_any

static const struct {
    const char *name;
    make_law make;
} mixes[GROWTH_MIX_COUNT] = {
#define X(upper, lower, text) {#lower, make_##lower},
    GROWTH_MIXES(X)
#undef X
};

const char *grown_mix_name(grown_mix mix)
{
    return mixes[mix].name;
}

static double powers_radius(const tdsp_growing_disc *disc, double time)
{
    double sum = 0.0;
    for (size_t k = disc->growth.count; k > 0; k--) sum = (sum + disc->growth.values[k - 1]) * time;
    return disc->radius + sum;
}

static double steps_radius(const tdsp_growing_disc *disc, double time)
{
    const tdsp_growth *g = &disc->growth;
    double radius = disc->radius;
    for (size_t k = 0; k < g->count && g->times[k] < time; k++) {
        const double end = k + 1 < g->count ? fmin(g->times[k + 1], time) : time;
        radius += g->values[k] * (end - g->times[k]);
    }
    return radius;
}

double grown_radius(const tdsp_growing_disc *disc, double time)
{
    const tdsp_growth *g = &disc->growth;
    double radius, rate;
    switch (g->kind) {
    case TDSP_GROWTH_POLYNOMIAL: return powers_radius(disc, time);
    case TDSP_GROWTH_RATES: return steps_radius(disc, time);
    case TDSP_GROWTH_LAW: g->law(g->ctx, fmin(time, g->until), &radius, &rate); return radius + rate * fmax(0.0, time - g->until);
    case TDSP_GROWTH_RATE: break;
    }
    return disc->radius + g->rate * time;
}

static int covers(const maker *m, const tdsp_growing_disc *disc, tdsp_point point, double time)
{
    const double dx = point.x - disc->center.x, dy = point.y - disc->center.y;
    return sqrt(dx * dx + dy * dy) < grown_radius(disc, time) + m->scene->journey.radius;
}

static tdsp_point random_place(uint64_t *r, double width, double height)
{
    const double x = chance_between(r, -width, width), y = chance_between(r, -height, height);
    return (tdsp_point){x, y};
}

static void choose_place(maker *m, grown_mix mix, tdsp_growing_disc *disc)
{
    const double count = (double)m->scene->count;
    disc->center = random_place(m->r, 0.9, 0.6);
    disc->radius = chance_between(m->r, 0.03, 0.5) / sqrt(count);
    if (chance(m->r, 0.15)) disc->radius = 0.0;
    if (mix == GROWTH_MIX_CLUSTER) {
        const tdsp_point to = random_direction(m->r);
        const double away = chance_between(m->r, 0.0, 0.35);
        disc->center = (tdsp_point){away * to.x, away * to.y};
    }
    if (m->i == 0 && mix != GROWTH_MIX_STEEP && chance(m->r, mix == GROWTH_MIX_BOUNCING ? 1.0 : 0.4)) {
        /* A large one in the way is ridden for long. */
        disc->center = random_place(m->r, 0.3, 0.15);
        disc->radius = chance_between(m->r, 0.2, mix == GROWTH_MIX_BOUNCING ? 0.7 : 0.5);
    }
    if (mix == GROWTH_MIX_STEEP) {
        disc->center = random_place(m->r, 2.0, 2.0);
        disc->radius *= 0.3;
    }
    if (mix == GROWTH_MIX_WALL) {
        const double step = 1.6 / count;
        const double x = chance_between(m->r, -0.1, 0.1);
        disc->center = (tdsp_point){x, -0.8 + step * ((double)m->i + chance_between(m->r, 0.3, 0.7))};
        disc->radius = step * chance_between(m->r, 0.1, 0.35);
    }
}

/* A disc that covers an end too early is drawn again, then with less said about when, and in the end made small. */
static void make_disc(maker *m, grown_mix mix)
{
    tdsp_growing_disc *disc = &m->scene->discs[m->i];
    for (int tries = 0; tries < 200; tries++) {
        choose_place(m, mix, disc);
        mixes[mix].make(m, disc);
        const double share = tries < 160 ? 1.0 : 0.0;
        if (!covers(m, disc, m->scene->journey.source, share * m->source_open) &&
            !covers(m, disc, m->scene->journey.destination, share * m->destination_open))
            return;
    }
    *disc = (tdsp_growing_disc){.center = {0.0, 0.4}, .radius = 0.05, .growth = {.kind = TDSP_GROWTH_RATE, .rate = 0.02}};
}

void random_growth(uint64_t seed, grown_mix mix, size_t count, grown_scene *scene)
{
    uint64_t r = seed * 1000003u + 7919u * (uint64_t)mix + 1u;
    memset(scene, 0, sizeof *scene);
    scene->journey = (tdsp_journey){1.0, 0.0, {-1.0, 0.0}, {1.0, 0.0}};
    scene->count = count;
    scene->unit = 2.0;
    if (mix == GROWTH_MIX_ASSORTED && chance(&r, 0.5)) scene->journey.radius = chance_between(&r, 0.0, 0.05);
    maker m = {&r, scene, 0, 0.0, 0.0};
    if (chance(&r, 0.9)) {
        m.source_open = chance_between(&r, 0.0, 2.0);
        m.destination_open = chance_between(&r, 2.0, 3.0) + m.source_open;
    }
    for (m.i = 0; m.i < count; m.i++) make_disc(&m, mix);
    if (chance(&r, 0.2)) return;
    grown_change change = {0};
    change.turn = random_direction(&r);
    change.shift = random_place(&r, 5.0, 5.0);
    change.length = chance_between(&r, 0.5, 20.0);
    change.time = chance_between(&r, 0.3, 10.0);
    grown_place(scene, &change);
}

/* ---------------------------------------------------------------------------------------------------------------- copies */

static void attach(grown_scene *scene, size_t i, const grown_scene *from)
{
    tdsp_growth *g = &scene->discs[i].growth;
    if (g->values) g->values = scene->values[i];
    if (g->times) g->times = scene->times[i] + (g->times - from->times[i]);
    if (g->ctx) g->ctx = &scene->parts[i];
}

void grown_copy(const grown_scene *scene, grown_scene *copy)
{
    *copy = *scene;
    for (size_t i = 0; i < copy->count; i++) attach(copy, i, scene);
}

static tdsp_point placed(const grown_change *c, tdsp_point a)
{
    const double y = c->mirror ? -a.y : a.y;
    return (tdsp_point){c->shift.x + c->length * (c->turn.x * a.x - c->turn.y * y),
                        c->shift.y + c->length * (c->turn.y * a.x + c->turn.x * y)};
}

static void place_law(grown_scene *scene, size_t i, double length, double time)
{
    tdsp_growth *g = &scene->discs[i].growth;
    grown_parts *p = &scene->parts[i];
    double power = 1.0;
    for (size_t k = 0; k < GROWTH_MOST_VALUES; k++) {
        if (k == 0 || g->kind == TDSP_GROWTH_POLYNOMIAL) power *= time;
        scene->values[i][k] *= length / power;
        scene->times[i][k] *= time;
    }
    g->rate *= length / time;
    g->until *= time;
    p->radius *= length;
    for (size_t k = 0; k < p->count; k++) {
        p->begins[k] *= time;
        p->spans[k] *= time;
        p->shares[k] *= length;
    }
}

void grown_place(grown_scene *scene, const grown_change *change)
{
    tdsp_journey *j = &scene->journey;
    j->source = placed(change, j->source);
    j->destination = placed(change, j->destination);
    j->radius *= change->length;
    j->speed *= change->length / change->time;
    scene->unit *= change->time;
    for (size_t i = 0; i < scene->count; i++) {
        scene->discs[i].center = placed(change, scene->discs[i].center);
        scene->discs[i].radius *= change->length;
        place_law(scene, i, change->length, change->time);
    }
}
