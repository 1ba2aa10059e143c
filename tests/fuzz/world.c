/* SPDX-License-Identifier: MIT */
/* See world.h. The journey is laid out from (-1, 0) to (1, 0) at speed 1 first; units and a shift come last, as they round. */
#include "world.h"

#include <math.h>
#include <string.h>

#define STEP (1.0 / 64.0) /* of the grid that discs stand on */

typedef struct layout {
    double length, speed; /* units */
    tdsp_point shift;
} layout;

/* A unit vector: the triangle 3, 4, 5 and the axes to the bit, others to rounding. */
static tdsp_point world_direction(unsigned byte)
{
    static const tdsp_point exact[] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}, {0.6, 0.8}, {-0.8, 0.6}, {0.6, -0.8}, {-0.6, -0.8}};
    if (byte < 8) return exact[byte];
    const double t = (double)((int)byte - 128) / 32.0, n = 1.0 + t * t;
    return (tdsp_point){(1.0 - t * t) / n, 2.0 * t / n};
}

/* 1, or next to it on either side. */
static double world_nudge(unsigned byte)
{
    static const double by[] = {0, 0x1p-52, -0x1p-53, 1e-15, -1e-15, 1e-13, -1e-13, 1e-12, -1e-12, 1e-10, -1e-10, 1e-9, -1e-9, 1e-7, -1e-7, 1e-4};
    return 1.0 + by[byte % 16];
}

static double world_rate(const world *w, unsigned kind, unsigned nudge, size_t i)
{
    static const double odd[] = {0, 1, 1e-14, 1e-9, 1e-6, 0.5, 2, 40, 1e-300, 0.999, 1e9};
    const size_t odds = sizeof odd / sizeof *odd;
    if (kind < 200) return (double)kind / 200.0 * (nudge < 128 ? 0.25 : 1.0) * world_nudge(nudge);
    if (kind < 200 + odds) return odd[kind - 200] * world_nudge(nudge);
    return i ? w->discs[kind % i].growth.rate * world_nudge(nudge) : 0.125;
}

static double world_radius(const world *w, unsigned kind, unsigned nudge, size_t i)
{
    static const double odd[] = {0, 1e-300, 1e-13, 1e-12, 1e-9, 1e-6, 1, 2, 64, 1e9};
    const size_t odds = sizeof odd / sizeof *odd;
    if (kind < 200) return (double)kind * STEP / 4.0;
    if (kind < 200 + odds) return odd[kind - 200] * world_nudge(nudge);
    return i ? w->discs[kind % i].radius * world_nudge(nudge) : 0.25;
}

/* Where a disc stands: on the grid, or so that its boundary runs through an end, or touches another disc from outside or inside. */
static tdsp_point world_place(const world *w, unsigned kind, unsigned a, unsigned b, unsigned nudge, double radius, size_t i)
{
    const tdsp_point grid = {STEP * ((double)a - 128.0), STEP * ((double)b - 128.0)}, to = world_direction(a);
    const tdsp_growing_disc *other = &w->discs[i ? b % i : 0];
    tdsp_point from = b & 1u ? w->journey.destination : w->journey.source;
    double away = radius;
    if (kind < 128 || (i == 0 && kind >= 192)) return (tdsp_point){grid.x * world_nudge(nudge), grid.y};
    if (kind < 160) {
        away = kind < 144 ? radius : 0.0; /* through an end, or around it */
    } else if (kind < 192) {
        away = radius + (kind < 176 ? 1e-13 : 1e-9); /* nearly */
    } else {
        from = other->center;
        away = kind < 208 ? other->radius + radius : kind < 224 ? fabs(other->radius - radius) : kind < 240 ? 0.0 : sqrt(other->radius * radius);
    }
    away *= world_nudge(nudge);
    return (tdsp_point){from.x + away * to.x, from.y + away * to.y};
}

/* The law of a disc whose rate is known: that rate, or something that begins with it. */
static void world_growth(world *w, size_t i, unsigned kind, double rate)
{
    static const double shares[] = {0, 1, -1, 0.25, -0.25, 4, 1e-9, -1e-9};
    static const double spans[] = {1, 0.125, 8, 1e-6};
    const double share = shares[kind & 7u], span = spans[kind >> 3 & 3u];
    tdsp_growth *growth = &w->discs[i].growth;
    growth->rate = rate;
    if (kind < 128) return;
    growth->values = w->values[i];
    growth->times = w->times[i];
    growth->count = WORLD_VALUES;
    if (kind < 176) {
        growth->kind = TDSP_GROWTH_POLYNOMIAL;
        memcpy(w->values[i], (double[]){rate, rate * share / span, rate * fabs(share) / (span * span)}, sizeof w->values[i]);
    } else if (kind < 224) {
        growth->kind = TDSP_GROWTH_RATES;
        memcpy(w->values[i], (double[]){rate, rate * fabs(1.0 + share), rate * fabs(share)}, sizeof w->values[i]);
        memcpy(w->times[i], (double[]){0.0, 0.5 * span, span}, sizeof w->times[i]);
    } else {
        growth->kind = TDSP_GROWTH_LAW;
        growth->count = 0;
        growth->until = 16.0;
        w->laws[i] = (world_law){w->discs[i].radius, rate, span};
    }
}

static void world_law_at(void *ctx, double time, double *radius, double *rate)
{
    const world_law *law = ctx;
    const double slowed = 1.0 + time / law->span;
    *radius = law->radius + law->rate * time / slowed;
    *rate = law->rate / (slowed * slowed);
}

static void world_disc(world *w, fuzz_input *in)
{
    unsigned raw[8];
    const size_t i = w->count++;
    for (int k = 0; k < 8; k++) raw[k] = input_byte(in);
    tdsp_growing_disc *disc = &w->discs[i];
    disc->radius = world_radius(w, raw[3], raw[6] >> 4, i);
    disc->center = world_place(w, raw[0], raw[1], raw[2], raw[6], disc->radius, i);
    world_growth(w, i, raw[7], world_rate(w, raw[4], raw[5], i));
}

static tdsp_point layout_place(const layout *to, tdsp_point p)
{
    return (tdsp_point){p.x * to->length + to->shift.x, p.y * to->length + to->shift.y};
}

static void layout_growth(const layout *to, tdsp_growth *growth, double *values, double *times, world_law *law)
{
    const double time = to->length / to->speed;
    growth->rate *= to->speed;
    for (int k = 0; k < WORLD_VALUES; k++) {
        const double power = growth->kind == TDSP_GROWTH_POLYNOMIAL ? (double)k : 0.0;
        values[k] *= to->speed / pow(time, power);
        times[k] *= time;
    }
    growth->until *= time;
    *law = (world_law){law->radius * to->length, law->rate * to->speed, law->span * time};
    growth->law = world_law_at;
    growth->ctx = law;
}

static void world_lay_out(world *w, const layout *to)
{
    tdsp_journey *journey = &w->journey;
    journey->source = layout_place(to, journey->source);
    journey->destination = layout_place(to, journey->destination);
    w->other = layout_place(to, w->other);
    journey->radius *= to->length;
    journey->speed = to->speed;
    for (size_t i = 0; i < w->count; i++) {
        w->discs[i].center = layout_place(to, w->discs[i].center);
        w->discs[i].radius *= to->length;
        layout_growth(to, &w->discs[i].growth, w->values[i], w->times[i], &w->laws[i]);
    }
}

/* The scene's own time: a journey of no length takes it from the farthest disc, as the solver does. */
static double world_unit(const world *w)
{
    const tdsp_journey *j = &w->journey;
    double across = hypot(j->destination.x - j->source.x, j->destination.y - j->source.y);
    if (across > 0.0) return across / j->speed;
    for (size_t i = 0; i < w->count; i++)
        across = fmax(across, hypot(w->discs[i].center.x - j->source.x, w->discs[i].center.y - j->source.y) + w->discs[i].radius + j->radius);
    return across / j->speed;
}

void world_read(world *w, fuzz_input *in)
{
    static const double lengths[] = {1, 1, 1, 1e9, 1e-9, 3.7e4, 1e-3, 0x1p20}, speeds[] = {1, 1, 1, 1e-6, 1e6, 0.3, 7, 0x1p-20};
    static const double shifts[] = {0, 0, 0, 0, 1, 1e3, 1e6, -1e9}, robots[] = {0, 0, 0, 0, 0.03125, 0.25, 1e-12, 1e-300};
    static const double waits[] = {0, 1e-12, 1e-9, 1e-3, 0.5, 2, 10, 1e9};
    memset(w, 0, sizeof *w);
    const double length = input_pick(in, lengths, 8), speed = input_pick(in, speeds, 8), shift = length * input_pick(in, shifts, 8);
    const layout to = {length, speed, {shift, -0.5 * shift}};
    w->journey = (tdsp_journey){1.0, input_pick(in, robots, 8), {-1.0, 0.0}, {1.0, 0.0}};
    const unsigned x = input_byte(in), y = input_byte(in);
    if (x) w->journey.destination = (tdsp_point){STEP * ((double)x - 128.0), STEP * ((double)y - 128.0)};
    const double departure = (double)input_byte(in) / 64.0 * world_nudge(input_byte(in));
    w->wait = input_pick(in, waits, 8);
    w->asked = input_byte(in);
    w->choice = input_byte(in);
    const unsigned other = input_byte(in);
    w->other = (tdsp_point){(double)(other >> 4) / 4.0 - 2.0, (double)(other & 15u) / 4.0 - 2.0};
    while (input_left(in) && w->count < WORLD_DISCS) world_disc(w, in);
    world_lay_out(w, &to);
    w->unit = world_unit(w);
    w->departure = departure * length / speed;
    w->wait *= w->unit;
}

static int world_has_rates_only(const world *w)
{
    for (size_t i = 0; i < w->count; i++)
        if (w->discs[i].growth.kind != TDSP_GROWTH_RATE) return 0;
    return 1;
}

tdsp_scene *world_scene(const world *w)
{
    tdsp_scene *scene = NULL;
    tdsp_disc discs[WORLD_DISCS];
    tdsp_status status;
    if (world_has_rates_only(w)) {
        for (size_t i = 0; i < w->count; i++) discs[i] = (tdsp_disc){w->discs[i].center, w->discs[i].radius, w->discs[i].growth.rate};
        status = tdsp_scene_create(&w->journey, discs, w->count, NULL, &scene);
    } else {
        status = tdsp_scene_create_growing(&w->journey, w->discs, w->count, NULL, &scene);
    }
    world_require(w, status == TDSP_OK || status == TDSP_BAD_SCENE, tdsp_status_name(status), 0.0, 0.0);
    return scene;
}

static void print_numbers(const double *values, size_t count)
{
    for (size_t k = 0; k < count; k++) fprintf(stderr, "%s%.17g", k ? ", " : "", values[k]);
}

static void print_growth(const tdsp_growth *growth)
{
    if (growth->kind == TDSP_GROWTH_POLYNOMIAL) {
        fprintf(stderr, "[");
        print_numbers(growth->values, growth->count);
        fprintf(stderr, "]}");
    } else if (growth->kind == TDSP_GROWTH_RATES) {
        fprintf(stderr, "{\"times\": [");
        print_numbers(growth->times, growth->count);
        fprintf(stderr, "], \"rates\": [");
        print_numbers(growth->values, growth->count);
        fprintf(stderr, "]}}");
    } else {
        fprintf(stderr, "%.17g%s}", growth->rate, growth->kind == TDSP_GROWTH_LAW ? ", \"law\": true" : "");
    }
}

void world_print(const world *w)
{
    const tdsp_journey *j = &w->journey;
    fprintf(stderr, "{\"robot\": {\"speed\": %.17g, \"radius\": %.17g}, \"source\": [%.17g, %.17g], \"destination\": [%.17g, %.17g],\n \"discs\": [", j->speed,
            j->radius, j->source.x, j->source.y, j->destination.x, j->destination.y);
    for (size_t i = 0; i < w->count; i++) {
        const tdsp_growing_disc *disc = &w->discs[i];
        fprintf(stderr, "%s\n  {\"center\": [%.17g, %.17g], \"radius\": %.17g, \"growth\": ", i ? "," : "", disc->center.x, disc->center.y, disc->radius);
        print_growth(&disc->growth);
    }
    fprintf(stderr, "]}\n");
}

void world_require(const world *w, int holds, const char *wrong, double a, double b)
{
    if (holds) return;
    world_print(w);
    fprintf(stderr, "fuzz: %s: %.17g, %.17g (departure %.17g)\n", wrong, a, b, w->departure);
    abort();
}
