/* SPDX-License-Identifier: MIT */
/*
 * The bits of many answers, one a line: built by other compilers, with other optimisation, the output must be the same to the last bit.
 *
 *   bits SCENES [FILE...]      SCENES random scenes of each mix, and scene files
 *
 * A line is what was asked, its status, and a hash of every number of the answer; numbers that are alone are printed as they are.
 */
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "support/chance.h"
#include "support/random_growth.h"
#include "support/random_scene.h"
#include "tdsp/scene_file.h"
#include "tdsp/tdsp.h"

#define MOST_LEGS 4096

static uint64_t mix_bytes(uint64_t hash, const void *bytes, size_t length)
{
    const unsigned char *p = bytes;
    for (size_t i = 0; i < length; i++) hash = (hash ^ p[i]) * UINT64_C(0x100000001b3);
    return hash;
}

static uint64_t mix_numbers(const double *numbers, size_t count)
{
    return mix_bytes(UINT64_C(0xcbf29ce484222325), numbers, count * sizeof *numbers);
}

static void say(const char *what, tdsp_status status, const double *numbers, size_t count)
{
    printf("  %s %s %016" PRIx64, what, tdsp_status_name(status), mix_numbers(numbers, count));
    for (size_t i = 0; i < count && i < 4; i++) printf(" %a", numbers[i]);
    printf("\n");
}

/* The last answer's path, where the verifier finds it, and what it says. Legs have no padding: their bytes are their numbers. */
static void say_path(const tdsp_scene *scene, const tdsp_solver *solver, double departure, double arrival)
{
    static tdsp_leg legs[MOST_LEGS];
    size_t count = 0;
    tdsp_verdict verdict;
    tdsp_status status = tdsp_solver_path(solver, legs, MOST_LEGS, &count);
    printf("  path %s %zu %016" PRIx64 "\n", tdsp_status_name(status), count,
           status == TDSP_OK ? mix_bytes(UINT64_C(0xcbf29ce484222325), legs, count * sizeof *legs) : 0);
    if (status != TDSP_OK) return;
    status = tdsp_verify_path(scene, legs, count, departure, arrival, &verdict);
    const double numbers[] = {verdict.min_clearance, verdict.time, verdict.disc};
    say("verdict", status, numbers, status == TDSP_OK ? 3 : 0);
}

static void say_arrival(const tdsp_scene *scene, tdsp_solver *solver, double departure)
{
    double numbers[4] = {departure, 0, 0, 0};
    tdsp_status status = tdsp_earliest_arrival(solver, departure, &numbers[1]);
    say("arrival", status, numbers, 2);
    if (status == TDSP_OK) say_path(scene, solver, departure, numbers[1]);
    status = tdsp_earliest_arrival_within(solver, departure, 0.125, &numbers[2], &numbers[3]);
    say("within", status, numbers, 4);
}

static void say_departure(const tdsp_scene *scene, tdsp_solver *solver, double arrival)
{
    double numbers[3] = {arrival, 0, 0};
    tdsp_status status = tdsp_latest_departure(solver, arrival, &numbers[1], &numbers[2]);
    say("departure", status, numbers, 3);
    if (status == TDSP_OK && isfinite(numbers[1])) say_path(scene, solver, numbers[1], numbers[2]);
}

static double say_last(tdsp_solver *solver)
{
    tdsp_last_departure last = {0};
    tdsp_status status = tdsp_solver_last_departure(solver, &last);
    const double numbers[] = {last.departure, last.arrival, last.time, last.reason, last.place.x, last.place.y, last.disc, last.other};
    say("last", status, numbers, sizeof numbers / sizeof numbers[0]);
    return status == TDSP_OK ? last.departure : -1;
}

/* A table of the first departures: its bytes. */
static void say_table(const tdsp_scene *scene, tdsp_solver *solver, double horizon)
{
    const tdsp_journey *journey = tdsp_scene_journey(scene);
    tdsp_oracle oracle;
    tdsp_build_options options;
    tdsp_build_report report;
    void *bytes = NULL;
    size_t length = 0;
    if (tdsp_solver_oracle(solver, &oracle) != TDSP_OK) return;
    tdsp_build_options_init(&options);
    options.epsilon = 0.05;
    options.horizon = horizon;
    options.world = (tdsp_build_world){tdsp_scene_hash(scene), journey->speed, journey->source, journey->destination, "m", "s"};
    tdsp_status status = tdsp_build(&oracle, &options, NULL, &bytes, &length, &report);
    printf("  table %s %zu %016" PRIx64 "\n", tdsp_status_name(status), length,
           status == TDSP_OK ? mix_bytes(UINT64_C(0xcbf29ce484222325), bytes, length) : 0);
    if (status == TDSP_OK) tdsp_bytes_free(NULL, bytes, length);
}

static void say_scene(const char *name, const tdsp_scene *scene, int whole)
{
    const tdsp_journey *journey = tdsp_scene_journey(scene);
    double unit = hypot(journey->destination.x - journey->source.x, journey->destination.y - journey->source.y) / journey->speed;
    tdsp_solver *solver = NULL;
    printf("%s %016" PRIx64 "\n", name, tdsp_scene_hash(scene));
    if (tdsp_solver_create(scene, &solver) != TDSP_OK) return;
    double last = whole ? say_last(solver) : unit;
    double end = isfinite(last) && last > 0 ? last : 2 * unit;
    for (int i = 0; i < 4; i++) say_arrival(scene, solver, end * i / 4);
    for (int i = 1; whole && i < 4; i++) say_departure(scene, solver, unit + end * i / 3);
    say_table(scene, solver, end);
    tdsp_solver_free(solver);
}

static void say_rates(random_mix mix, uint64_t seed)
{
    tdsp_journey journey;
    tdsp_disc discs[RANDOM_MOST_DISCS];
    tdsp_scene *scene = NULL;
    size_t count = 1 + (size_t)(seed * 7 % 24);
    random_scene(seed * 1000 + (uint64_t)mix, mix, count, &journey, discs);
    tdsp_status status = tdsp_scene_create(&journey, discs, count, NULL, &scene);
    if (status == TDSP_OK) say_scene(random_mix_name(mix), scene, 1);
    if (status != TDSP_OK) printf("%s %s\n", random_mix_name(mix), tdsp_status_name(status));
    tdsp_scene_free(scene);
}

static void say_growth(grown_mix mix, uint64_t seed)
{
    static grown_scene world;
    tdsp_scene *scene = NULL;
    random_growth(seed * 1000 + (uint64_t)mix, mix, 1 + (size_t)(seed * 3 % 7), &world);
    tdsp_status status = tdsp_scene_create_growing(&world.journey, world.discs, world.count, NULL, &scene);
    if (status == TDSP_OK) say_scene(grown_mix_name(mix), scene, seed % 4 == 0);
    if (status != TDSP_OK) printf("%s %s\n", grown_mix_name(mix), tdsp_status_name(status));
    tdsp_scene_free(scene);
}

static int say_file(const char *path)
{
    g_auto(SceneFile) file = {0};
    g_autoptr(GError) error = NULL;
    if (!scene_file_load(path, &file, &error)) {
        fprintf(stderr, "bits: %s\n", error->message);
        return 0;
    }
    say_scene(strrchr(path, '/') ? strrchr(path, '/') + 1 : path, file.scene, 1);
    return 1;
}

int main(int argc, char **argv)
{
    int good = argc > 1;
    uint64_t scenes = good ? strtoull(argv[1], NULL, 10) : 0;
    for (uint64_t seed = 0; seed < scenes; seed++) {
        for (int mix = 0; mix < RANDOM_MIX_COUNT; mix++) say_rates((random_mix)mix, seed);
        for (int mix = 0; mix < GROWTH_MIX_COUNT; mix++) say_growth((grown_mix)mix, seed);
    }
    for (int i = 2; i < argc; i++) good = say_file(argv[i]) && good;
    return good ? 0 : 1;
}
