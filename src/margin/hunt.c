/* SPDX-License-Identifier: MIT */
/* Narrowing down: the method is in hunt.h. */
#include "margin/hunt.h"

#include <stdlib.h>

#include "base/math.h"
#include "scene/scene.h" /* the unit of time, nothing else */

/* lo and hi this near together are as good as one. */
#define SAME 1e-12

/* A latest departure this far from t, relative to the times at hand, decides; nearer ones leave it to A(t). */
#define DECIDES 1e-9
#define ROUNDING 1e-14

/* One this near says nothing of the slope. */
#define FLAT 1e-12

/* Below this share of where the hunt began an amount counts as none: what so little growth does to a touch, rounding does as well. */
#define NOTHING 1e-9

/* So many steps that do not quarter the interval are followed by a halving, whatever the values say. */
#define PATIENCE 3
#define MOST_STEPS 400

/* How far past a guess, as a share of the way to it; and how far outside of the interval one still means its end. */
#define PAST 0.02
#define NEAR 1e-3

/* 2 squared so often is infinite. */
#define MOST_SQUARINGS 10

double hunt_amount(const hunt *self, double p)
{
    return self->how == TDSP_RAISE_FACTOR ? p : p - self->fastest;
}

tdsp_status hunt_solver(hunt *self, double p, tdsp_solver **out)
{
    tdsp_scene *scene;
    tdsp_status status = tdsp_scene_raise(self->scene, self->how, hunt_amount(self, p), &scene);
    if (status != TDSP_OK) return status;
    self->scenes++;
    status = tdsp_solver_create(scene, out);
    if (status != TDSP_OK) tdsp_scene_free(scene);
    return status;
}

void hunt_drop(tdsp_solver *solver)
{
    tdsp_scene *scene = (tdsp_scene *)tdsp_solver_scene(solver); /* made by hunt_solver() */
    tdsp_solver_free(solver);
    tdsp_scene_free(scene);
}

tdsp_status hunt_keeps(const hunt *self, tdsp_solver *solver, tdsp_status *answer, double *arrival, int *keeps)
{
    *answer = tdsp_earliest_arrival(solver, self->departure, arrival);
    if (!tdsp_status_is_answer(*answer)) return *answer;
    *keeps = *answer == TDSP_OK && *arrival <= self->deadline;
    return TDSP_OK;
}

static void hunt_learn(hunt *self, hunt_value value)
{
    if (value.p == 0.0 || fabs(value.ahead) <= FLAT * (self->scene->time + value.time)) return;
    if (self->value_count == 2) self->values[0] = self->values[1];
    if (self->value_count < 2) self->value_count++;
    self->values[self->value_count - 1] = value;
}

/* What the latest departure tells. */
static void hunt_by_latest(hunt *self, double p, double latest, double arrives, int *decided, int *keeps)
{
    const double ahead = latest - self->departure, scale = self->scene->time + arrives;
    *keeps = ahead > 0.0;
    *decided = isinf(latest) || fabs(ahead) > DECIDES * scale + ROUNDING * self->departure;
    if (!isinf(latest)) hunt_learn(self, (hunt_value){p, ahead, arrives});
}

/* What A(t) tells; where it is late, about how much earlier one would have to leave. */
static tdsp_status hunt_by_arrival(hunt *self, tdsp_solver *solver, double p, int has_latest, int *keeps)
{
    tdsp_status answer;
    double arrival;
    const tdsp_status status = hunt_keeps(self, solver, &answer, &arrival, keeps);
    if (status == TDSP_OK && answer == TDSP_OK && !has_latest && !*keeps)
        hunt_learn(self, (hunt_value){p, self->deadline - arrival, self->deadline});
    return status;
}

/* The latest departure decides where there is one, far enough from t; its times may also be too far away, when A(t) is not. */
static tdsp_status hunt_ask(hunt *self, tdsp_solver *solver, double p, int *keeps)
{
    double latest, arrives;
    int decided = 0;
    const tdsp_status status = tdsp_latest_departure(solver, self->deadline, &latest, &arrives);
    if (!hunt_is_far(status) && !tdsp_status_is_answer(status)) return status;
    const int has_latest = status == TDSP_OK;
    if (has_latest) hunt_by_latest(self, p, latest, arrives, &decided, keeps);
    return decided ? TDSP_OK : hunt_by_arrival(self, solver, p, has_latest, keeps);
}

tdsp_status hunt_step(hunt *self, double p)
{
    int keeps = 0;
    tdsp_solver *solver;
    tdsp_status status = hunt_solver(self, p, &solver);
    if (status != TDSP_OK) return status;
    status = hunt_ask(self, solver, p, &keeps);
    hunt_drop(solver);
    if (status != TDSP_OK) return status;
    if (keeps) {
        self->lo = p;
        self->same = self->same > 0 ? self->same + 1 : 1;
    } else {
        self->hi = p;
        self->hi_known = 1;
        self->same = self->same < 0 ? self->same - 1 : -1;
    }
    return TDSP_OK;
}

/* Where L is expected to reach t; NAN when nothing is known. */
static double hunt_guess(const hunt *self)
{
    if (self->value_count == 0) return NAN;
    const hunt_value b = self->values[self->value_count - 1];
    if (self->value_count == 1) return b.time > b.ahead ? b.p * b.time / (b.time - b.ahead) : INFINITY;
    const hunt_value a = self->values[0];
    const double u = 1.0 / b.p - b.ahead * (1.0 / b.p - 1.0 / a.p) / (b.ahead - a.ahead);
    return u > 0.0 ? 1.0 / u : INFINITY;
}

static double hunt_middle(const hunt *self)
{
    if (self->lo <= 0.0) return self->hi / 16.0;
    return self->hi > 2.0 * self->lo ? sqrt(self->lo) * sqrt(self->hi) : 0.5 * (self->lo + self->hi);
}

/* The least step that tells two amounts apart; the more often the same end has moved, the longer. */
static double hunt_least(const hunt *self, double p)
{
    return 0.5 * SAME * p * ldexp(1.0, 3 * (abs(self->same) - 1));
}

/* Nothing does harm so far: trust a guess no farther than this, 4, 16, 256, ... times as far. */
static double hunt_farther(const hunt *self, double guess)
{
    const double far = ldexp(self->lo, 1 << (self->same < MOST_SQUARINGS ? self->same : MOST_SQUARINGS));
    if (guess > self->lo && guess < far) return guess;
    return guess > self->lo * (1.0 - NEAR) && guess <= self->lo ? self->lo + hunt_least(self, self->lo) : far;
}

/*
 * After two moves of one end go a little past the guess, so that the other end follows. A guess at an end or just beyond it, where rounding or a
 * value that is missing puts it, looks inside of it: the more often, the deeper.
 */
static double hunt_inside(const hunt *self, double guess)
{
    const double width = self->hi - self->lo, least = hunt_least(self, self->hi);
    double p = guess;
    if (self->same >= 2) p += PAST * (guess - self->lo);
    if (self->same <= -2) p -= PAST * (self->hi - guess);
    if (p >= self->hi) p = self->hi - math_max(PAST * width, least);
    if (p <= self->lo) p = self->lo + least;
    p = math_min(math_max(p, self->lo + least), self->hi - least);
    return p > self->lo ? p : hunt_middle(self);
}

static double hunt_next(const hunt *self, int is_slow)
{
    const double guess = hunt_guess(self), width = self->hi - self->lo;
    if (!self->hi_known) return math_min(self->lo > 0.0 ? hunt_farther(self, guess) : self->hi, self->hi);
    if (is_slow || !(guess > self->lo - NEAR * width && guess < self->hi + NEAR * width)) return hunt_middle(self);
    return hunt_inside(self, guess);
}

static int hunt_is_done(const hunt *self, double least)
{
    return self->lo >= self->hi || self->hi <= least || (self->hi_known && self->hi - self->lo <= SAME * self->hi);
}

tdsp_status hunt_run(hunt *self)
{
    const double least = self->lo > 0.0 ? 0.0 : NOTHING * self->hi;
    double width = INFINITY;
    tdsp_status status = TDSP_OK;
    for (int step = 0; step < MOST_STEPS && status == TDSP_OK && !hunt_is_done(self, least); step++) {
        int is_slow = 0;
        if (step % PATIENCE == PATIENCE - 1) {
            is_slow = self->hi - self->lo > 0.25 * width;
            width = self->hi - self->lo;
        }
        status = hunt_step(self, math_max(hunt_next(self, is_slow), least));
    }
    return status;
}
