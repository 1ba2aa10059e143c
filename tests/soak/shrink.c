/* SPDX-License-Identifier: MIT */
/*
 * Each step changes one thing (a disc less, a number rounder) and is kept when the same check still fails by a hundredth of what it did, at the same
 * departures or at others that the changed scene offers: a jump moves with the numbers.
 */
#include "soak/shrink.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "soak/checks.h"
#include "soak/departures.h"
#include "support/chance.h"

enum { SEARCHES = 3 };

typedef struct shrinker {
    soak_scene *scene; /* the smallest so far */
    soak_scene *trial;
    soak_failure *failure;
    double least; /* excess that still counts */
    double end;   /* of the processor's seconds */
} shrinker;

static double seconds_used(void)
{
    return (double)clock() / CLOCKS_PER_SEC;
}

int soak_fails(const soak_scene *scene, soak_failure *failure)
{
    soak_case c = {.scene = scene, .departure = failure->departure, .later = failure->later, .pick = failure->pick};
    if (!isfinite(c.departure) || !isfinite(c.later) || c.departure < 0.0) return 0;
    const tdsp_status status = soak_open(scene, TDSP_METHOD_AUTO, &c.world);
    if (status != TDSP_OK) return 0;
    soak_check_run(failure->check, &c);
    soak_close(&c.world);
    if (!c.failed) return 0;
    memcpy(failure->what, c.what, sizeof failure->what);
    failure->excess = c.excess;
    return 1;
}

static int fails_enough(const shrinker *s, soak_failure *failure)
{
    /* What is wrong by a number stays so: a status that is wrong would be something else. */
    return soak_fails(s->trial, failure) && failure->excess >= s->least && !isinf(failure->excess) == !isinf(s->failure->excess);
}

/* Elsewhere in the changed scene. */
static int fails_somewhere(const shrinker *s, soak_failure *failure)
{
    uint64_t chance = failure->pick;
    double departures[SOAK_DEPARTURES];
    for (int search = 0; search < SEARCHES; search++) {
        soak_world world;
        if (soak_open(s->trial, TDSP_METHOD_AUTO, &world) != TDSP_OK) return 0;
        const size_t count = soak_departures(&world, &chance, departures);
        soak_close(&world);
        for (size_t i = 0; i < count; i++) {
            failure->departure = departures[i];
            failure->later = departures[i] + fmax(0.0, s->failure->later - s->failure->departure);
            if (fails_enough(s, failure)) return 1;
        }
    }
    return 0;
}

/* Take the trial where the check still fails; the trial is the scene again afterwards. */
static int keep(shrinker *s)
{
    soak_failure failure = *s->failure;
    int kept = 0;
    if (seconds_used() < s->end) kept = fails_enough(s, &failure) || (s->trial->count <= 6 && fails_somewhere(s, &failure));
    if (kept) {
        soak_copy(s->scene, s->trial);
        *s->failure = failure;
    }
    soak_copy(s->trial, s->scene);
    return kept;
}

static int drop_discs(shrinker *s)
{
    int any = 0;
    for (size_t part = s->scene->count; part > 0; part /= 2)
        for (size_t i = 0; i + part <= s->scene->count;) {
            soak_disc *at = &s->trial->discs[i];
            memmove(at, at + part, (s->trial->count - i - part) * sizeof *at);
            s->trial->count -= part;
            if (keep(s))
                any = 1;
            else
                i += part;
        }
    return any;
}

/* To the origin, along the x axis, a journey of 2 with speed 1: each by itself. */
static int move_home(shrinker *s)
{
    const tdsp_journey *j = &s->scene->journey;
    const double far = soak_distance(s->scene), dx = j->destination.x - j->source.x, dy = j->destination.y - j->source.y;
    const grown_change here = {{1.0, 0.0}, {-j->source.x, -j->source.y}, 1.0, 1.0, 0},
                       level = {{dx / far, -dy / far}, {0.0, 0.0}, 1.0, 1.0, 0};
    const grown_change unit = {{1.0, 0.0}, {0.0, 0.0}, 2.0 / far, 2.0 * j->speed / far, 0};
    const grown_change *changes[] = {&here, &level, &unit};
    int any = 0;
    for (int k = 0; k < 3; k++) {
        const soak_failure before = *s->failure;
        if (!(far > 0.0) || (k == 0   ? j->source.x == 0.0 && j->source.y == 0.0
                             : k == 1 ? dy == 0.0
                                      : far == 2.0 && j->speed == 1.0))
            continue;
        soak_place(s->trial, changes[k]);
        s->failure->departure *= changes[k]->time;
        s->failure->later *= changes[k]->time;
        if (keep(s))
            any = 1;
        else
            *s->failure = before;
    }
    return any;
}

/* One rate instead of a law: the mean one over two journeys. */
static int simplify_growth(shrinker *s)
{
    int any = 0;
    for (size_t i = 0; i < s->scene->count; i++) {
        soak_disc *disc = &s->trial->discs[i];
        if (disc->growth.kind == TDSP_GROWTH_RATE) continue;
        const double time = 2.0 * soak_distance(s->scene) / s->scene->journey.speed;
        const double rate = (soak_radius(s->scene, i, time) - soak_radius(s->scene, i, 0.0)) / time;
        disc->growth = (tdsp_growth){.kind = TDSP_GROWTH_RATE, .rate = fmax(0.0, rate)};
        any |= keep(s);
    }
    return any;
}

/* Significant decimal digits; none at all is 0. */
static double rounded(double value, int digits)
{
    if (digits == 0 || value == 0.0) return 0.0;
    const double scale = pow(10.0, digits - 1 - floor(log10(fabs(value))));
    return round(value * scale) / scale;
}

static int round_number(shrinker *s, double *number)
{
    static const int digits[] = {0, 1, 2, 3, 4, 6, 9, 12};
    const double before = *number;
    for (size_t k = 0; k < sizeof digits / sizeof *digits; k++) {
        const double value = rounded(before, digits[k]);
        if (value == before) return 0;
        *number = value;
        if (keep(s)) return 1;
    }
    return 0;
}

static int round_discs(shrinker *s)
{
    int any = 0;
    for (size_t i = 0; i < s->trial->count; i++) {
        soak_disc *disc = &s->trial->discs[i];
        double *numbers[] = {&disc->center.x, &disc->center.y, &disc->radius, &disc->growth.rate};
        for (size_t k = 0; k < 4; k++) any |= round_number(s, numbers[k]);
        for (size_t k = 0; disc->growth.kind != TDSP_GROWTH_RATE && k < disc->growth.count; k++) {
            if (disc->growth.kind != TDSP_GROWTH_LAW) any |= round_number(s, &disc->values[k]);
            if (disc->growth.kind == TDSP_GROWTH_RATES) any |= round_number(s, &disc->times[k]);
        }
    }
    return any;
}

static int round_journey(shrinker *s)
{
    tdsp_journey *j = &s->trial->journey;
    double *numbers[] = {&j->source.x, &j->source.y, &j->destination.x, &j->destination.y, &j->speed, &j->radius};
    int any = 0;
    for (size_t k = 0; k < 6; k++) any |= round_number(s, numbers[k]);
    return any;
}

/* Departures are no part of the scene: the same trial, asked at rounder times. */
static int round_departures(shrinker *s)
{
    int any = 0;
    double *times[] = {&s->failure->departure, &s->failure->later};
    for (size_t k = 0; k < 2; k++)
        for (int digits = 0; digits <= 12; digits++) {
            soak_failure failure = *s->failure;
            const double value = rounded(*times[k], digits);
            *(k ? &failure.later : &failure.departure) = value;
            if (value == *times[k]) break;
            if (failure.later < failure.departure || !fails_enough(s, &failure)) continue;
            *s->failure = failure;
            any = 1;
            break;
        }
    return any;
}

void soak_shrink(soak_scene *scene, soak_failure *failure, double seconds)
{
    static soak_scene trial;
    shrinker s = {scene, &trial, failure, 0.01 * fmin(failure->excess, 0.1), seconds_used() + seconds};
    int (*const steps[])(shrinker *) = {drop_discs, move_home, simplify_growth, round_departures, round_journey, round_discs};
    soak_copy(&trial, scene);
    for (int any = 1; any && seconds_used() < s.end;) {
        any = 0;
        for (size_t k = 0; k < sizeof steps / sizeof *steps; k++) any |= steps[k](&s);
    }
}
