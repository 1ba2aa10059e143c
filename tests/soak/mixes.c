/* SPDX-License-Identifier: MIT */
/* See mixes.h. Most scenes are small: a small one shows a mistake as well as a large one, and a million of them are affordable. */
#include "soak/mixes.h"

#include <math.h>

#include "support/chance.h"

static const char *const names[SOAK_ALL_MIXES] = {
#define X(upper, lower, text) #lower,
    RANDOM_MIXES(X)
#undef X
#define X(upper, lower, text) "growth_" #lower,
        GROWTH_MIXES(X)
#undef X
#define X(lower, text) #lower,
            SOAK_MIXES(X)
#undef X
};

const char *soak_mix_name(size_t mix)
{
    return names[mix];
}

static size_t choose_count(uint64_t *chance, size_t few, size_t some, size_t many)
{
    const uint64_t share = chance_below(chance, 100);
    return 1 + (size_t)chance_below(chance, share < 88 ? few : share < 98 ? some : many);
}

static void make_rates(uint64_t *chance, random_mix mix, soak_scene *scene)
{
    tdsp_journey journey;
    tdsp_disc discs[RANDOM_MOST_DISCS];
    const size_t count = choose_count(chance, 8, 16, RANDOM_MOST_DISCS);
    random_scene(chance_u64(chance), mix, count, &journey, discs);
    soak_take_rates(scene, &journey, discs, count);
}

static void make_growth(uint64_t *chance, grown_mix mix, soak_scene *scene)
{
    static grown_scene grown;
    random_growth(chance_u64(chance), mix, choose_count(chance, 5, 8, GROWTH_MOST_DISCS), &grown);
    soak_take_growth(scene, &grown);
}

static double snap(double value, double step)
{
    return step * round(value / step) + 0.0; /* no -0, for which angles turn to the other side */
}

static tdsp_point snap_point(tdsp_point p, double step)
{
    return (tdsp_point){snap(p.x, step), snap(p.y, step)};
}

/* Rates and their times. A polynomial whose coefficients were rounded might shrink from the start, and keeps them. */
static void snap_growth(soak_disc *disc, double rate, double time)
{
    disc->growth.rate = snap(disc->growth.rate, rate);
    for (size_t k = 0; k < GROWTH_MOST_VALUES && disc->growth.kind == TDSP_GROWTH_RATES; k++) {
        disc->values[k] = snap(disc->values[k], rate);
        const double before = k ? disc->times[k - 1] : -time;
        disc->times[k] = fmax(before + time, snap(disc->times[k], time));
    }
}

/* Everything to multiples of a power of two, near 1/16 or 1/64 of the journey and of the robot's speed. */
static void snap_scene(uint64_t *chance, soak_scene *scene)
{
    const double share = chance_below(chance, 2) ? 1.0 / 16.0 : 1.0 / 64.0;
    const double length = share * exp2(round(log2(soak_distance(scene)))), speed = exp2(round(log2(scene->journey.speed)));
    scene->journey.speed = speed;
    scene->journey.radius = snap(scene->journey.radius, length);
    scene->journey.source = snap_point(scene->journey.source, length);
    scene->journey.destination = snap_point(scene->journey.destination, length);
    for (size_t i = 0; i < scene->count; i++) {
        soak_disc *disc = &scene->discs[i];
        disc->center = snap_point(disc->center, length);
        if (disc->growth.kind == TDSP_GROWTH_LAW || disc->growth.kind == TDSP_GROWTH_POLYNOMIAL) continue;
        disc->radius = snap(disc->radius, length);
        snap_growth(disc, speed / 32.0, length / speed);
    }
}

static void turn_anyhow(uint64_t *chance, soak_scene *scene, soak_mix mix)
{
    if (mix == SOAK_MIX_lattice || chance_below(chance, 2)) return;
    const double angle = chance_between(chance, 0.0, 6.28), length = chance_between(chance, 0.1, 30.0);
    const double far = mix == SOAK_MIX_far_away ? 0.0 : length;
    const grown_change change = {{cos(angle), sin(angle)},
                                 {far * chance_between(chance, -3.0, 3.0), far * chance_between(chance, -3.0, 3.0)},
                                 length,
                                 chance_between(chance, 0.1, 10.0),
                                 0};
    soak_place(scene, &change);
}

static void make_any(uint64_t *chance, soak_scene *scene)
{
    if (chance_below(chance, 2))
        make_rates(chance, (random_mix)chance_below(chance, RANDOM_MIX_COUNT), scene);
    else
        make_growth(chance, (grown_mix)chance_below(chance, GROWTH_MIX_COUNT), scene);
}

/* The scene in units a great deal smaller or larger, or moved far off. */
static void make_elsewhere(uint64_t *chance, soak_scene *scene)
{
    const double power = pow(10.0, chance_between(chance, 5.0, 9.0)), angle = chance_between(chance, 0.0, 6.28);
    const uint64_t kind = chance_below(chance, 3);
    const double length = kind == 0 ? power : kind == 1 ? 1.0 / power : 1.0, far = kind == 2 ? power : 0.0;
    const grown_change change = {
        {1.0, 0.0}, {far * cos(angle), far * sin(angle)}, length, chance_below(chance, 2) ? 1.0 : length, 0};
    make_any(chance, scene);
    soak_place(scene, &change);
}

static void make_degenerate(uint64_t *chance, soak_mix mix, soak_scene *scene)
{
    if (mix == SOAK_MIX_snapped) {
        make_rates(chance, (random_mix)chance_below(chance, RANDOM_MIX_COUNT), scene);
        snap_scene(chance, scene);
        return;
    }
    if (mix == SOAK_MIX_snapped_growth) {
        make_growth(chance, (grown_mix)chance_below(chance, GROWTH_MIX_COUNT), scene);
        snap_scene(chance, scene);
        return;
    }
    if (mix == SOAK_MIX_elsewhere) {
        make_elsewhere(chance, scene);
        return;
    }
    scene->journey = (tdsp_journey){1.0, 0.0, {-1.0, 0.0}, {1.0, 0.0}};
    scene->count = 0;
    soak_degenerate(mix, chance, choose_count(chance, 8, 16, 40), scene);
    turn_anyhow(chance, scene, mix);
}

size_t soak_make(uint64_t seed, uint64_t number, size_t only, soak_scene *scene)
{
    uint64_t chance = seed * UINT64_C(0x9e3779b97f4a7c15) ^ number * UINT64_C(0xd1342543de82ef95);
    const size_t any = (size_t)chance_below(&chance, SOAK_ALL_MIXES), mix = only < SOAK_ALL_MIXES ? only : any;
    scene->mix = names[mix];
    scene->moment = -1.0;
    if (mix < RANDOM_MIX_COUNT)
        make_rates(&chance, (random_mix)mix, scene);
    else if (mix < (size_t)RANDOM_MIX_COUNT + (size_t)GROWTH_MIX_COUNT)
        make_growth(&chance, (grown_mix)(mix - RANDOM_MIX_COUNT), scene);
    else
        make_degenerate(&chance, (soak_mix)(mix - RANDOM_MIX_COUNT - (size_t)GROWTH_MIX_COUNT), scene);
    return mix;
}
