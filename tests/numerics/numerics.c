/* SPDX-License-Identifier: MIT */
/*
 * The library's numbers beside precise ones (docs/numerics.md).
 *
 *   numerics check           a fixed subset: one line "ok" or "not ok" for each mix
 *   numerics table SCENES    SCENES scenes of each mix, as a table in Markdown
 *   numerics one MIX SEED    one scene
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "numerics/hard.h"
#include "numerics/measure.h"
#include "support/random_scene.h"

enum { QUESTIONS = 5, MOST_RANDOM = 6, CHECKED = 12, HARD = HARD_MIX_COUNT, MIXES = HARD + (int)RANDOM_MIX_COUNT };

static const char *mix_name(int mix)
{
    return mix < HARD ? hard_mix_name((hard_mix)mix) : random_mix_name((random_mix)(mix - HARD));
}

static void measure_one(int mix, uint64_t seed, measured *into)
{
    static tdsp_disc discs[RANDOM_MOST_DISCS];
    numeric_case c = {.name = mix_name(mix), .seed = seed, .chance = seed, .discs = discs, .into = into};
    if (mix < HARD) {
        c.count = hard_scene(seed, (hard_mix)mix, &c.journey, discs, &c.first);
    } else {
        c.count = 1 + (size_t)(seed % MOST_RANDOM);
        random_scene(seed, (random_mix)(mix - HARD), c.count, &c.journey, discs);
    }
    c.unit = hypot(c.journey.destination.x - c.journey.source.x, c.journey.destination.y - c.journey.source.y) / c.journey.speed;
    if (tdsp_scene_create(&c.journey, discs, c.count, NULL, &c.scene) != TDSP_OK || tdsp_solver_create(c.scene, &c.solver) != TDSP_OK) {
        fprintf(stderr, "%s, seed %llu: no scene\n", c.name, (unsigned long long)seed);
        exit(1);
    }
    measure_scene(&c, QUESTIONS);
    tdsp_solver_free(c.solver);
    tdsp_scene_free(c.scene);
}

static measured measure_mix(int mix, uint64_t first, uint64_t scenes)
{
    measured m = {0};
    for (uint64_t i = 0; i < scenes; i++) measure_one(mix, first + i, &m);
    return m;
}

static void print_row(const char *name, const measured *m)
{
    printf("| %s | %zu | %zu | %.1f | %.1e | %.1e | %.1e | %zu | %.0e | %.0e | %.1e | %.1e |\n", name, m->scenes, m->arrivals + m->departures, m->roundings, m->error, m->late, m->early, m->touches,
           fmax(m->touch, m->depart_touch), m->outside, m->fall, m->depth);
    fflush(stdout);
}

static void print_table(uint64_t scenes)
{
    printf("| mix | scenes | questions | roundings | error of A | too late | too early | touches | touch | outside | fall | depth |\n|---|---|---|---|---|---|---|---|---|---|---|---|\n");
    for (int mix = 0; mix < MIXES; mix++) {
        const measured m = measure_mix(mix, 0, scenes);
        print_row(mix_name(mix), &m);
        if (m.worst[0]) fprintf(stderr, "beyond a bound: %s\n", m.worst);
    }
}

static int check(void)
{
    int failed = 0;
    for (int mix = 0; mix < MIXES; mix++) {
        const measured m = measure_mix(mix, 0, CHECKED);
        failed |= m.worst[0] != '\0';
        printf("%s %s stays within the stated errors%s%s\n", m.worst[0] ? "not ok" : "ok", mix_name(mix), m.worst[0] ? ": " : "", m.worst);
    }
    return failed;
}

static int one(const char *name, uint64_t seed)
{
    for (int mix = 0; mix < MIXES; mix++) {
        if (strcmp(name, mix_name(mix)) != 0) continue;
        const measured m = measure_mix(mix, seed, 1);
        print_row(name, &m);
        if (m.worst[0]) printf("beyond a bound: %s\n", m.worst);
        return 0;
    }
    fprintf(stderr, "no such mix: %s\n", name);
    return 2;
}

int main(int argc, char **argv)
{
    if (argc == 2 && strcmp(argv[1], "check") == 0) return check();
    if (argc == 4 && strcmp(argv[1], "one") == 0) return one(argv[2], strtoull(argv[3], NULL, 10));
    if (argc != 3 || strcmp(argv[1], "table") != 0) {
        fprintf(stderr, "usage: numerics check | table SCENES | one MIX SEED\n");
        return 2;
    }
    print_table(strtoull(argv[2], NULL, 10));
    return 0;
}
