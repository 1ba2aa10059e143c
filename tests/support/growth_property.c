/* SPDX-License-Identifier: MIT */
/* See growth_property.h. */
#include "support/growth_property.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "support/cmocka_all.h"

#define JOURNEYS 20.0 /* times looked at for a radius that shrinks */

static uint64_t from_environment(const char *name, uint64_t otherwise)
{
    const char *text = getenv(name);
    return text && *text ? strtoull(text, NULL, 10) : otherwise;
}

/* Up to when a disc's rate, looked at closely, is not negative. */
static double valid_until(const tdsp_growing_disc *disc, double until)
{
    const slow_law_disc law = slow_law_of(disc);
    if (disc->growth.kind != TDSP_GROWTH_POLYNOMIAL) return until;
    double before = 0.0;
    for (int i = 0; i <= 4000; i++) {
        double now = until * i / 4000.0;
        if (law.jet(law.ctx, 0, now).rate >= 0.0) {
            before = now;
            continue;
        }
        for (int halvings = 0; halvings < 60; halvings++) {
            const double middle = 0.5 * (before + now);
            if (law.jet(law.ctx, 0, middle).rate >= 0.0)
                before = middle;
            else
                now = middle;
        }
        return before;
    }
    return until;
}

void grown_each(int scenes, size_t most, void (*check)(grown_case *c))
{
    static grown_case c;
    const uint64_t first = from_environment("TDSP_PROPERTY_SEED", 0);
    const uint64_t number = (uint64_t)scenes * from_environment("TDSP_PROPERTY_SCENES", 1);
    const char *only = getenv("TDSP_PROPERTY_MIX");
    for (int mix = 0; mix < GROWTH_MIX_COUNT; mix++) {
        if (only && *only && strcmp(only, grown_mix_name((grown_mix)mix)) != 0) continue;
        for (uint64_t i = 0; i < number; i++) {
            c.name = grown_mix_name((grown_mix)mix);
            c.seed = first + i;
            c.chance = i;
            random_growth(c.seed, (grown_mix)mix, 1 + (size_t)(i % most), &c.scene);
            c.valid = JOURNEYS * c.scene.unit;
            for (size_t k = 0; k < c.scene.count; k++) c.valid = valid_until(&c.scene.discs[k], c.valid);
            check(&c);
        }
    }
}

double grown_slow_path(const grown_case *c, double until, double departure, slow_law_place *places, size_t capacity,
                       size_t *count)
{
    slow_law_disc laws[GROWTH_MOST_DISCS];
    for (size_t i = 0; i < c->scene.count; i++) laws[i] = slow_law_of(&c->scene.discs[i]);
    const double arrival = slow_law_path(&c->scene.journey, laws, c->scene.count, until, departure, places, capacity, count);
    grown_holds(c, !isnan(arrival));
    return arrival;
}

double grown_slow(const grown_case *c, double until, double departure)
{
    size_t count;
    return grown_slow_path(c, until, departure, NULL, 0, &count);
}

int grown_clear(const grown_case *c, tdsp_point at, double time, double slack)
{
    for (size_t i = 0; i < c->scene.count; i++) {
        const tdsp_growing_disc *disc = &c->scene.discs[i];
        const double radius = grown_radius(disc, time) + c->scene.journey.radius;
        if (radius > 0.0 && hypot(at.x - disc->center.x, at.y - disc->center.y) < radius - slack) return 0;
    }
    return 1;
}

static void print_numbers(const char *name, const double *numbers, size_t count)
{
    print_error("\"%s\": [", name);
    for (size_t i = 0; i < count; i++) print_error("%s%.17g", i ? ", " : "", numbers[i]);
    print_error("]");
}

/* As in a scene file, but for a law by callback, which a file cannot hold: its parts. */
static void print_growth(const grown_scene *scene, size_t i)
{
    const tdsp_growth *g = &scene->discs[i].growth;
    const grown_parts *p = &scene->parts[i];
    if (g->kind == TDSP_GROWTH_RATE) print_error("\"growth\": %.17g", g->rate);
    if (g->kind == TDSP_GROWTH_POLYNOMIAL) print_numbers("growth", g->values, g->count);
    if (g->kind == TDSP_GROWTH_RATES) {
        print_error("\"growth\": {");
        print_numbers("times", g->times, g->count);
        print_error(", ");
        print_numbers("rates", g->values, g->count);
        print_error("}");
    }
    if (g->kind == TDSP_GROWTH_LAW) {
        print_error("\"sharp\": %d, \"until\": %.17g, ", p->sharp, g->until);
        print_numbers("begins", p->begins, p->count);
        print_error(", ");
        print_numbers("spans", p->spans, p->count);
        print_error(", ");
        print_numbers("shares", p->shares, p->count);
    }
}

void grown_fail(const grown_case *c, const char *text, double a, double b, const char *file, int line)
{
    const tdsp_journey *j = &c->scene.journey;
    print_error("%s: %.17g, %.17g in the scene\n", text, a, b);
    print_error("{\"name\": \"%s, seed %llu\", \"robot\": {\"speed\": %.17g, \"radius\": %.17g}, ", c->name,
                (unsigned long long)c->seed, j->speed, j->radius);
    print_error("\"source\": [%.17g, %.17g], \"destination\": [%.17g, %.17g], \"discs\": [", j->source.x, j->source.y,
                j->destination.x, j->destination.y);
    for (size_t i = 0; i < c->scene.count; i++) {
        const tdsp_growing_disc *disc = &c->scene.discs[i];
        print_error("%s{\"center\": [%.17g, %.17g], \"radius\": %.17g, ", i ? ",\n" : "\n", disc->center.x, disc->center.y,
                    disc->radius);
        print_growth(&c->scene, i);
        print_error("}");
    }
    print_error("]}\n");
    _fail(file, line);
}
