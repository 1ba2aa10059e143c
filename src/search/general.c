/* SPDX-License-Identifier: MIT */
/* Scenes whose rates change: the description is in general.h. */
#include "search/general.h"

#include "base/math.h"
#include "tdsp/growth.h"

/* A(t) counts as equal to a within this share of the times at hand. */
#define SAME_TIME 1e-11

/* The proof looks this share of the times at hand past the answer; bisection goes on down to the other. */
#define PROOF_STEP 2e-9
#define LEAST_STEP 1e-14

/* A deadline later than the source is covered and so many straight ways is no time at hand: with one far beyond, steps would be longer than all departures. */
#define LONG_WAY 1e3

typedef struct general_state {
    tdsp_solver *solver;
    double arrival;  /* a */
    double best;     /* the latest departure known to arrive by a; negative when none */
    double arrives;  /* A(best); below 0 while not known */
    double too_late; /* the earliest departure known not to */
    double scale;    /* of the times at hand */
} general_state;

static double general_slack(const general_state *state, double share)
{
    return share * state->scale;
}

/* The scene as it is described holds up to some time; what the answer looked at must not lie beyond. */
static tdsp_status general_check(const tdsp_solver *solver, double latest)
{
    double valid = tdsp_scene_valid_until(solver->scene, NULL);
    return latest > valid * (1.0 + SAME_TIME) ? TDSP_SHRINKS : TDSP_OK;
}

tdsp_status general_arrival(tdsp_solver *solver, double departure, double *arrival)
{
    double looked_until = departure;
    solver->has_path = 0;
    if (scene_covered(solver->ends.source_cover, departure)) {
        tdsp_status known = general_check(solver, departure);
        return known == TDSP_OK ? TDSP_SOURCE_COVERED : known;
    }
    if (ends_meet(&solver->ends)) {
        growth_forget(solver->growth);
        *arrival = departure;
        return general_check(solver, departure);
    }
    ++solver->work.forward_searches;
    tdsp_status status = growth_arrival(solver->growth, &solver->ends, departure, arrival, &looked_until);
    if (!tdsp_status_is_answer(status)) return status;
    tdsp_status known = general_check(solver, status == TDSP_OK ? *arrival : looked_until);
    return known == TDSP_OK ? status : known;
}

/* Ask for A(t) and learn from the answer. *status is an error or TDSP_OK. Returns 1 when t arrives by a. */
static int general_try(general_state *state, double departure, tdsp_status *status)
{
    double found = INFINITY;
    *status = general_arrival(state->solver, departure, &found);
    if (!tdsp_status_is_answer(*status)) return 0;
    double over = *status == TDSP_OK ? found - state->arrival : INFINITY; /* -infinity where any arrival will do */
    *status = TDSP_OK;
    if (over > 0.0) state->too_late = math_min(state->too_late, departure);
    if (!(over <= general_slack(state, SAME_TIME))) return 0;
    double earlier = math_max(departure - math_max(over, 0.0), 0.0); /* a path moved earlier stays a path */
    if (earlier >= state->best) {
        state->best = earlier;
        state->arrives = math_min(found, state->arrival);
    }
    return 1;
}

static tdsp_status general_bisect(general_state *state)
{
    tdsp_status status = TDSP_OK;
    while (status == TDSP_OK && state->too_late - state->best > general_slack(state, LEAST_STEP)) {
        double middle = 0.5 * (state->best + state->too_late);
        if (!(middle > state->best && middle < state->too_late)) break;
        general_try(state, middle, &status);
    }
    return status;
}

static tdsp_status general_from_destination(general_state *state)
{
    double departure;
    tdsp_solver *solver = state->solver;
    ++solver->work.reverse_searches;
    tdsp_status status = growth_departure(solver->growth, &solver->ends, state->arrival, &departure);
    if (status != TDSP_OK || departure < 0.0 || departure >= state->too_late) return status;
    departure = math_min(departure, solver->ends.source_cover.time);
    if (departure > state->best && !general_try(state, departure, &status) && status == TDSP_OK)
        general_try(state, math_max(departure - general_slack(state, SAME_TIME), 0.0), &status);
    return status;
}

static tdsp_status general_search(general_state *state)
{
    double covered = state->solver->ends.source_cover.time;
    tdsp_status status = general_from_destination(state);
    if (status == TDSP_OK && state->best < 0.0 && state->too_late > 0.0) general_try(state, 0.0, &status);
    if (status != TDSP_OK || state->best < 0.0) return status;
    if (state->arrives >= 0.0 && state->arrival - state->arrives <= general_slack(state, SAME_TIME)) return TDSP_OK;
    if (covered < state->too_late && covered > state->best && (general_try(state, covered, &status) || status != TDSP_OK)) return status;
    double step = state->best + general_slack(state, PROOF_STEP);
    if (step < state->too_late) general_try(state, step, &status);
    return status == TDSP_OK ? general_bisect(state) : status;
}

/* No arrival is asked for and no disc ever covers the destination: nothing grows any more from some time on, or so slowly that doubles do not say when it covers anything. */
static tdsp_status general_endless(general_state *state)
{
    tdsp_solver *solver = state->solver;
    double covered = solver->ends.source_cover.time, last = math_min(covered, growth_still_from(solver->growth));
    tdsp_status status = general_check(solver, last);
    if (status != TDSP_OK || isinf(last)) return status == TDSP_OK ? TDSP_NOT_SUPPORTED : status;
    state->scale += last;
    if (general_try(state, last, &status) && isinf(covered)) state->best = state->arrives = INFINITY;
    if (status == TDSP_OK && state->best < 0.0 && last > 0.0) general_try(state, 0.0, &status);
    return status == TDSP_OK && state->best >= 0.0 && state->best < last ? general_bisect(state) : status;
}

tdsp_status general_latest(tdsp_solver *solver, double arrival, double after, double before, double *best, double *arrives)
{
    const scene_ends *ends = &solver->ends;
    double straight = point_distance(ends->source, ends->destination) * solver->scene->time;
    general_state state = {solver, math_min(arrival, ends->destination_cover.time), after, -1.0, before, ends->time};
    tdsp_status status = TDSP_OK;
    solver->has_path = 0;
    if (solver_is_far(solver, math_min(state.arrival, ends->source_cover.time)) && !isinf(state.arrival)) return TDSP_NOT_SUPPORTED;
    if (scene_covered(ends->source_cover, 0.0)) {
        state.best = -1.0;
    } else if (isinf(state.arrival)) {
        status = general_endless(&state);
    } else {
        state.scale += math_min(state.arrival, ends->source_cover.time + LONG_WAY * ends->time);
        state.too_late = math_min(state.too_late, state.arrival - straight + general_slack(&state, PROOF_STEP));
        status = general_check(solver, state.arrival);
        if (status == TDSP_OK) status = general_search(&state);
    }
    *best = state.best;
    *arrives = state.arrives;
    return status;
}

tdsp_status general_route(tdsp_solver *solver, double departure, double arrival)
{
    growth_path path = {solver->path, solver->path_count, solver->path_capacity};
    tdsp_status status = growth_route(solver->growth, &solver->ends, departure, arrival, &path);
    solver->path = path.legs;
    solver->path_count = path.count;
    solver->path_capacity = path.capacity;
    return status;
}
