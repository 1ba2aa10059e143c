/* SPDX-License-Identifier: MIT */
/*
 * Builds tables and prints a hash of their bytes: on any machine, by any compiler, the output must be the same. Nothing but the library is needed, no file either.
 *
 * Scenes come on the standard input, as tests/portable/bytes.py writes them. A number is the 16 hexadecimal digits of a double's bits, so that nothing depends on how
 * decimal numbers are read:
 *
 *   scene NAME speed radius source.x source.y destination.x destination.y COUNT
 *   disc center.x center.y radius KIND VALUES value ... TIMES time ...          COUNT times; KIND: tdsp_growth_kind
 */
#include <inttypes.h>
#include <stdio.h>
#include <string.h>

#include "tdsp/tdsp.h"

#define MOST_DISCS 512
#define MOST_VALUES 64
#define EPSILON 0.05
#define HORIZON 10.0 /* in journeys */

static double discs_values[MOST_DISCS][2][MOST_VALUES];
static tdsp_growing_disc discs[MOST_DISCS];

static double read_number(void)
{
    uint64_t bits = 0;
    double x;
    if (scanf("%" SCNx64, &bits) != 1) bits = UINT64_C(0x7ff8000000000000);
    memcpy(&x, &bits, sizeof x);
    return x;
}

static size_t read_count(size_t most)
{
    unsigned long count = 0;
    return scanf("%lu", &count) == 1 && count <= most ? (size_t)count : 0;
}

static const double *read_list(double *list, size_t *count)
{
    *count = read_count(MOST_VALUES);
    for (size_t i = 0; i < *count; i++) list[i] = read_number();
    return list;
}

static tdsp_growing_disc read_disc(double values[2][MOST_VALUES])
{
    size_t count, times;
    tdsp_growing_disc disc = {{0, 0}, 0, {.kind = TDSP_GROWTH_RATE}};
    disc.center.x = read_number();
    disc.center.y = read_number();
    disc.radius = read_number();
    disc.growth.kind = (tdsp_growth_kind)read_count(3);
    disc.growth.values = read_list(values[0], &count);
    disc.growth.times = read_list(values[1], &times);
    disc.growth.count = count;
    if (disc.growth.kind == TDSP_GROWTH_RATE) disc.growth.rate = values[0][0];
    return disc;
}

static uint64_t hash_of(const void *bytes, size_t length)
{
    const unsigned char *p = bytes;
    uint64_t hash = UINT64_C(0xcbf29ce484222325);
    for (size_t i = 0; i < length; i++) hash = (hash ^ p[i]) * UINT64_C(0x100000001b3);
    return hash;
}

static void say_table(const char *name, const tdsp_scene *scene, tdsp_solver *solver)
{
    const tdsp_journey *journey = tdsp_scene_journey(scene);
    tdsp_oracle oracle;
    tdsp_build_options options;
    tdsp_build_report report;
    void *bytes = NULL;
    size_t length = 0;
    double first = 0;
    tdsp_status status = tdsp_earliest_arrival(solver, 0.0, &first);
    if (status == TDSP_OK) status = tdsp_solver_oracle(solver, &oracle);
    if (status == TDSP_OK) {
        tdsp_build_options_init(&options);
        options.epsilon = EPSILON;
        options.horizon = HORIZON * first;
        options.world = (tdsp_build_world){tdsp_scene_hash(scene), journey->speed, journey->source, journey->destination, "m", "s"};
        status = tdsp_build(&oracle, &options, NULL, &bytes, &length, &report);
    }
    printf("%s %s", name, tdsp_status_name(status));
    if (status == TDSP_OK) {
        printf(" %lu bytes %016" PRIx64, (unsigned long)length, hash_of(bytes, length));
        tdsp_bytes_free(NULL, bytes, length);
    }
    printf("\n");
}

static void say_scene(const char *name, const tdsp_journey *journey, size_t count)
{
    tdsp_scene *scene = NULL;
    tdsp_solver *solver = NULL;
    tdsp_status status = tdsp_scene_create_growing(journey, discs, count, NULL, &scene);
    if (status == TDSP_OK) status = tdsp_solver_create(scene, &solver);
    if (status == TDSP_OK)
        say_table(name, scene, solver);
    else
        printf("%s %s\n", name, tdsp_status_name(status));
    tdsp_solver_free(solver);
    tdsp_scene_free(scene);
}

static int read_scene(void)
{
    char name[128];
    tdsp_journey journey;
    if (scanf(" scene %127s", name) != 1) return 0;
    journey.speed = read_number();
    journey.radius = read_number();
    journey.source.x = read_number();
    journey.source.y = read_number();
    journey.destination.x = read_number();
    journey.destination.y = read_number();
    size_t count = read_count(MOST_DISCS);
    for (size_t i = 0; i < count; i++) {
        int after = 0;
        if (scanf(" disc%n", &after) != 0 || after == 0) return 0;
        discs[i] = read_disc(discs_values[i]);
    }
    say_scene(name, &journey, count);
    return 1;
}

int main(void)
{
    while (read_scene()) continue;
    return 0;
}
