/* SPDX-License-Identifier: MIT */
/* See property.h. */
#include "support/property.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "support/cmocka_all.h"
#include "tdsp/verify.h"

#define MOST_LEGS 1024

static uint64_t from_environment(const char *name, uint64_t otherwise)
{
    const char *text = getenv(name);
    return text && *text ? strtoull(text, NULL, 10) : otherwise;
}

static double journey_time(const tdsp_journey *journey)
{
    const double dx = journey->destination.x - journey->source.x, dy = journey->destination.y - journey->source.y;
    return hypot(dx, dy) / journey->speed;
}

void property_prepare(property_case *c)
{
    c->unit = journey_time(&c->journey);
    property_holds(c, tdsp_scene_create(&c->journey, c->discs, c->count, NULL, &c->scene) == TDSP_OK);
    property_holds(c, tdsp_solver_create(c->scene, &c->solver) == TDSP_OK);
}

void property_drop(property_case *c)
{
    tdsp_solver_free(c->solver);
    tdsp_scene_free(c->scene);
}

void property_each(int scenes, size_t most, void (*check)(property_case *c))
{
    const uint64_t first = from_environment("TDSP_PROPERTY_SEED", 0);
    const uint64_t number = (uint64_t)scenes * from_environment("TDSP_PROPERTY_SCENES", 1);
    const char *only = getenv("TDSP_PROPERTY_MIX");
    for (int mix = 0; mix < RANDOM_MIX_COUNT; mix++) {
        if (only && *only && strcmp(only, random_mix_name((random_mix)mix)) != 0) continue;
        for (uint64_t i = 0; i < number; i++) {
            property_case c = {
                .name = random_mix_name((random_mix)mix), .seed = first + i, .count = 1 + (size_t)(i % most), .chance = i};
            random_scene(c.seed, (random_mix)mix, c.count, &c.journey, c.discs);
            property_prepare(&c);
            check(&c);
            property_drop(&c);
        }
    }
}

double property_arrival(property_case *c, double departure)
{
    double arrival = -1.0;
    const tdsp_status status = tdsp_earliest_arrival(c->solver, departure, &arrival);
    if (!tdsp_status_is_answer(status)) property_fail(c, tdsp_status_name(status), departure, arrival, __FILE__, __LINE__);
    property_holds(c, (status == TDSP_OK) == (arrival < INFINITY));
    return arrival;
}

void property_fail(const property_case *c, const char *text, double a, double b, const char *file, int line)
{
    const tdsp_journey *j = &c->journey;
    print_error("%s: %.17g, %.17g in the scene\n", text, a, b);
    print_error("{\"name\": \"%s, seed %llu\", \"robot\": {\"speed\": %.17g, \"radius\": %.17g}, ", c->name,
                (unsigned long long)c->seed, j->speed, j->radius);
    print_error("\"source\": [%.17g, %.17g], \"destination\": [%.17g, %.17g], \"discs\": [", j->source.x, j->source.y,
                j->destination.x, j->destination.y);
    for (size_t i = 0; i < c->count; i++)
        print_error("%s{\"center\": [%.17g, %.17g], \"radius\": %.17g, \"growth\": %.17g}", i ? ",\n" : "\n",
                    c->discs[i].center.x, c->discs[i].center.y, c->discs[i].radius, c->discs[i].growth);
    print_error("]}\n");
    _fail(file, line);
}

void property_path_is_good(property_case *c, double departure, double arrival)
{
    static tdsp_leg legs[MOST_LEGS];
    size_t count;
    tdsp_verdict verdict;
    property_holds(c, tdsp_solver_path(c->solver, legs, MOST_LEGS, &count) == TDSP_OK);
    property_holds(c, tdsp_verify_path(c->scene, legs, count, departure, arrival, &verdict) == TDSP_OK);
    if (verdict.problems) property_fail(c, "the verifier rejects the path", departure, verdict.min_clearance, __FILE__, __LINE__);
}
