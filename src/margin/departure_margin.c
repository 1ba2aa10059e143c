/* SPDX-License-Identifier: MIT */
/* How far all rates may rise before a departure fails, with planning anew: the hunt, its ends, and what limits it. */

#include "base/math.h"
#include "margin/hunt.h"
#include "margin/raise.h"

/* Where growth bends, factors are looked at up to this. */
#define MOST_FACTOR 1048576.0

/* Beyond this parameter nothing rises any more. */
static double most_raised(const tdsp_scene *scene, tdsp_raise how, double slowest, double fastest)
{
    if (how == TDSP_RAISE_ADDED) return fastest + raise_cap(scene);
    if (raise_bends(scene)) return MOST_FACTOR;
    return isinf(slowest) ? 0.0 : raise_cap(scene) / slowest;
}

/* A(t) at a parameter, and, when asked to explain, what limits it there. */
static tdsp_status margin_ask(hunt *self, double p, int explain, int *keeps, tdsp_margin *margin)
{
    tdsp_solver *solver;
    tdsp_deadline_answer latest;
    tdsp_status answer, status = hunt_solver(self, p, &solver);
    if (status != TDSP_OK) return status;
    status = hunt_keeps(self, solver, &answer, &margin->arrival, keeps);
    margin->status = answer == TDSP_OK && !*keeps ? TDSP_ARRIVAL_TOO_EARLY : answer;
    if (status == TDSP_OK && *keeps && explain) {
        status = tdsp_solver_deadline(solver, self->deadline, &latest);
        if (status == TDSP_OK) margin->witness = latest.witness;
        if (tdsp_status_is_answer(status) || hunt_is_far(status)) status = TDSP_OK;
    }
    hunt_drop(solver);
    return status;
}

/* Even without growth there is no way that keeps the deadline. */
static void margin_none(const hunt *self, tdsp_margin *margin)
{
    margin->most = -INFINITY;
    margin->arrival = INFINITY;
    if (margin->status != TDSP_ARRIVAL_TOO_EARLY) return;
    margin->witness.limit = TDSP_LIMIT_DEADLINE;
    margin->witness.time = self->deadline;
}

/* What was found, solved once more for the arrival and the witness; rounding may ask for a step back, and for longer ones. */
static tdsp_status margin_conclude(hunt *self, tdsp_margin *margin)
{
    for (double back = 1e-13;; back *= 8.0) {
        int keeps = 0;
        const tdsp_status status = margin_ask(self, self->lo, 1, &keeps, margin);
        margin->most = hunt_amount(self, self->lo);
        if (status != TDSP_OK || keeps) return status;
        if (self->lo == 0.0) {
            margin_none(self, margin);
            return TDSP_OK;
        }
        self->lo = back < 1.0 ? self->lo * (1.0 - back) : 0.0;
    }
}

/* It fails as it is: does it without any growth? */
static tdsp_status margin_below(hunt *self, tdsp_margin *margin, int *found)
{
    const tdsp_status status = margin_ask(self, 0.0, 0, found, margin);
    if (status == TDSP_OK && !*found) margin_none(self, margin);
    return status;
}

static tdsp_status margin_find(hunt *self, tdsp_margin *margin)
{
    const double start = self->how == TDSP_RAISE_FACTOR ? 1.0 : self->fastest;
    const double end = math_max(most_raised(self->scene, self->how, self->slowest, self->fastest), start);
    int found = 1;
    self->hi = end;
    tdsp_status status = hunt_step(self, start);
    if (status == TDSP_OK && self->hi_known) status = margin_below(self, margin, &found);
    if (status == TDSP_OK && found) status = hunt_run(self);
    if (status != TDSP_OK || !found) return status;
    if (self->lo < end) return margin_conclude(self, margin);
    margin->most = INFINITY;
    return margin_ask(self, end, 0, &found, margin);
}

tdsp_status tdsp_departure_margin(const tdsp_scene *scene, tdsp_raise how, double departure, double deadline, tdsp_margin *out)
{
    if (!scene || !out || (how != TDSP_RAISE_FACTOR && how != TDSP_RAISE_ADDED)) return TDSP_INVALID_ARGUMENT;
    if (!(departure >= 0.0) || isinf(departure) || !(deadline >= 0.0)) return TDSP_INVALID_ARGUMENT;
    hunt self = {.scene = scene, .how = how, .departure = departure, .deadline = deadline};
    raise_range(scene, &self.slowest, &self.fastest);
    tdsp_margin margin = {0};
    margin.witness =
        (tdsp_witness){TDSP_LIMIT_NONE, TDSP_NO_DISC, TDSP_NO_DISC, INFINITY, tdsp_scene_journey(scene)->destination};
    const tdsp_status status = margin_find(&self, &margin);
    margin.scenes = self.scenes;
    if (status == TDSP_OK) *out = margin;
    return status;
}
