/* SPDX-License-Identifier: MIT */
/*
 * The latest departure: A^-1(a) = sup { t : A(t) <= a }.
 *
 * Where A is continuous, a search backwards in time from the destination at `a` finds it. Inside a jump no path arrives exactly at `a`: the
 * departure sought is the one at the jump, whose path is the last to pass a closing gap, or leaves as the source is covered. It is the best of
 *
 *   1. the reverse search from the destination at min(a, t_d),
 *   2. the moment t_s at which the source is covered, when A(t_s) <= a,
 *   3. reverse searches from the gap events, latest first: the first whose forward arrival is <= a.
 *
 * A is increasing, so a forward search just after the winner proves that nothing later will do. Where that proof fails, or nobody won (the jump had another
 * cause), the answer is found by bisection on A.
 */

#include "base/math.h"
#include "search/gap.h"
#include "search/general.h"
#include "search/reason.h"

/* A(t) counts as equal to a within this share of the times at hand. */
#define SAME_TIME 1e-11

/* ... and of the times themselves, which are rounded however short the journey. */
#define ROUNDING 1e-15

/* A departure solved for backwards is this far from the forward search's own last double, at most. */
#define STEP_BACK 1e-12

/* The proof looks this share of the times at hand past the answer. */
#define PROOF_STEP 2e-9

/* ... or this one, past an answer that the asker named himself and no search came upon: it may lie anywhere before a jump. */
#define CLOSE_STEP 1e-10

/* Halving leaves nothing of any interval of doubles after this. */
#define MOST_HALVINGS 1100

/* What is known so far; times in the user's units. */
typedef struct latest_state {
    tdsp_solver *solver;
    const disc_set *set;
    tdsp_solver_work before; /* the counters when the question came in */
    double arrival;  /* a */
    double best;     /* the latest departure known to arrive by a; negative when none */
    double arrives;  /* A(best) */
    double too_late; /* the earliest departure known to arrive after a */
    const gap_event *gap; /* the event that the best path passes, if that is what it is */
    double known_good; /* what the asker knows: this departure arrives by a; negative: nothing known ... */
    double known_late; /* ... and this one does not */
} latest_state;

static double latest_slack(const latest_state *state, double share)
{
    return share * (state->solver->ends.time + state->arrival - math_max(state->best, 0.0)) + ROUNDING * state->arrival;
}

/* Ask for A(t) and learn from the answer. *status is an error or TDSP_OK. Returns 1 when t arrives by a. */
static int latest_try(latest_state *state, double departure, tdsp_status *status)
{
    tdsp_solver *solver = state->solver;
    double found = INFINITY;
    double until = state->arrival + latest_slack(state, SAME_TIME);
    *status = solver_forward(solver, state->set, departure, until, &found);
    if (!tdsp_status_is_answer(*status)) return 0;
    int good = *status == TDSP_OK && found <= until;
    *status = TDSP_OK;
    if (!good) {
        state->too_late = math_min(state->too_late, departure);
        return 0;
    }
    double over = found - state->arrival;
    if (over > 0.0) state->too_late = math_min(state->too_late, departure);
    double earlier = math_max(departure - math_max(over, 0.0), 0.0); /* a path moved earlier stays a path */
    if (earlier > state->best) {
        state->best = earlier;
        state->arrives = math_min(found, state->arrival);
    }
    return 1;
}

/* The same for a departure that was solved for: rounding may have put it just past what it stands for. */
static int latest_try_solved(latest_state *state, double departure, tdsp_status *status)
{
    if (latest_try(state, departure, status) || *status != TDSP_OK) return *status == TDSP_OK;
    double earlier = departure - latest_slack(state, STEP_BACK);
    return earlier > state->best && latest_try(state, earlier, status);
}

tdsp_status solver_reverse(tdsp_solver *solver, const disc_set *set, const engine_question *question, double *departure)
{
    ++solver->work.reverse_searches;
    engine_question ask = *question;
    int lost = 0;
    tdsp_status status = TDSP_OK;
    if (set == &solver->scene->all && solver->relaxation.stage == RELAX_SCOUTED) status = engine_scout(&solver->engine, &ask, &lost);
    if (lost && solver->engine.gave_up) return TDSP_NO_ANSWER;
    if (status == TDSP_OK && !lost) status = engine_run(&solver->engine, set, &ask);
    *departure = -1.0;
    if (status == TDSP_OK && solver->engine.arrived != ENGINE_NONE) *departure = math_max(-engine_arrival(&solver->engine), 0.0);
    return status;
}

/* To the source at a true time that is neither negative nor after it is covered. */
engine_question solver_reverse_question(const tdsp_solver *solver, double time, double limit)
{
    const scene_ends *ends = &solver->ends;
    engine_question question = {ENGINE_REVERSE, ends->destination, ends->source, -time, -ends->source_cover.time / solver->scene->time,
                                0.0, limit, 1.0, 0, 0, NULL, 0};
    return question;
}

static tdsp_status latest_from_destination(latest_state *state)
{
    const tdsp_scene *scene = state->solver->scene;
    engine_question question = solver_reverse_question(state->solver, state->arrival / scene->time, -math_max(state->best, 0.0) / scene->time);
    double departure;
    tdsp_status status = solver_reverse(state->solver, state->set, &question, &departure);
    if (status != TDSP_OK || departure < 0.0) return status;
    latest_try_solved(state, math_min(departure * scene->time, state->solver->ends.source_cover.time), &status);
    return status;
}

static tdsp_status latest_solve_gap(latest_state *state, gap_event *event)
{
    const engine_seed seeds[2] = {{event->first, -event->side, event->normal[0]}, {event->second, event->side, event->normal[1]}};
    const tdsp_scene *scene = state->solver->scene;
    engine_question question = solver_reverse_question(state->solver, event->time, -math_max(state->best, 0.0) / scene->time);
    question.seeds = seeds;
    question.seed_count = 2;
    event->solved = 1;
    return solver_reverse(state->solver, state->set, &question, &event->departure);
}

/* The event with the latest departure, or NULL when none beats the best. */
static gap_event *latest_next_gap(const latest_state *state)
{
    tdsp_solver *solver = state->solver;
    gap_event *next = NULL;
    for (size_t i = 0; i < solver->gap_count; ++i)
        if (!next || solver->gaps[i].departure > next->departure) next = &solver->gaps[i];
    if (!next || next->departure * solver->scene->time <= state->best) return NULL;
    return next;
}

/* Can a robot at the corner at that moment still arrive by a? Only then is a look at the whole forward search worth it. */
static tdsp_status latest_gap_leads_on(latest_state *state, const gap_event *event, int *leads)
{
    const engine_seed seeds[2] = {{event->first, event->side, event->normal[0]}, {event->second, -event->side, event->normal[1]}};
    const scene_ends *ends = &state->solver->ends;
    double unit = state->solver->scene->time, until = (state->arrival + latest_slack(state, SAME_TIME)) / unit;
    engine_question question = {ENGINE_FORWARD, ends->source, ends->destination, event->time, -INFINITY,
                                math_min(until, ends->destination_cover.time / unit), until, 1.0, 0, 0, seeds, 2};
    tdsp_status status = engine_run(&state->solver->engine, state->set, &question);
    *leads = status == TDSP_OK && state->solver->engine.arrived != ENGINE_NONE;
    return status;
}

/* Candidates at or after a departure that arrives too late need no look. */
static tdsp_status latest_try_gap(latest_state *state, const gap_event *event)
{
    int leads = 0;
    double departure = event->departure * state->solver->scene->time;
    if (departure >= state->too_late) return TDSP_OK;
    tdsp_status status = latest_gap_leads_on(state, event, &leads);
    if (leads && latest_try_solved(state, departure, &status)) state->gap = event;
    return status;
}

static tdsp_status latest_from_gaps(latest_state *state)
{
    const tdsp_scene *scene = state->solver->scene;
    tdsp_status status = gap_collect(state->solver, state->set, state->best / scene->time, state->arrival / scene->time);
    while (status == TDSP_OK && !state->gap) {
        gap_event *event = latest_next_gap(state);
        if (!event) return TDSP_OK;
        if (!event->solved) {
            status = latest_solve_gap(state, event);
            continue;
        }
        status = latest_try_gap(state, event);
        if (!state->gap) event->departure = -1.0;
    }
    return status;
}

/* A jump without a known cause: bisection between a departure that is in time and one that is not. */
static tdsp_status latest_bisect(latest_state *state)
{
    tdsp_status status = TDSP_OK;
    state->gap = NULL;
    for (int step = 0; step < MOST_HALVINGS && status == TDSP_OK && state->too_late - state->best > latest_slack(state, 1e-13); ++step) {
        double middle = 0.5 * (state->best + state->too_late);
        if (middle <= state->best || middle >= state->too_late) break;
        latest_try(state, middle, &status);
    }
    return status;
}

/* Is nothing later good enough? A best that neither a gap explains nor the asker named is any one on this side of a jump: then the last one is halved down to. */
static tdsp_status latest_prove(latest_state *state)
{
    const int is_named = state->best <= state->known_good;
    double step = state->best + latest_slack(state, is_named ? CLOSE_STEP : PROOF_STEP);
    if (step < state->too_late) {
        latest_state after = *state;
        tdsp_status status;
        if (latest_try(&after, step, &status)) {
            *state = after;
            return latest_bisect(state);
        }
        if (status != TDSP_OK) return status;
        state->too_late = step;
    }
    return state->gap || is_named ? TDSP_OK : latest_bisect(state);
}

static tdsp_status latest_search(latest_state *state)
{
    tdsp_status status = latest_from_destination(state);
    if (status == TDSP_OK && state->best < 0.0 && state->too_late > 0.0) latest_try(state, 0.0, &status);
    if (status != TDSP_OK || state->best < 0.0) return status;
    if (state->arrival - state->arrives <= latest_slack(state, SAME_TIME)) return TDSP_OK;
    double covered = state->solver->ends.source_cover.time;
    if (covered < state->too_late && covered > state->best && covered < state->arrival)
        if (latest_try(state, covered, &status) || status != TDSP_OK) return status;
    status = latest_from_gaps(state);
    return status == TDSP_OK ? latest_prove(state) : status;
}

/*
 * The question among the discs of a set. Among some of them only, whose path says what else matters, the engine is left with the path of the
 * best departure. What arrives by a among all discs does so among fewer; what does not may.
 */
static tdsp_status ask_latest(void *ctx, const disc_set *set)
{
    latest_state *state = ctx;
    tdsp_solver *solver = state->solver;
    double arrives;
    state->set = set;
    solver->work = state->before;
    state->best = state->known_good;
    state->arrives = -1.0;
    state->too_late = state->arrival + latest_slack(state, PROOF_STEP); /* the journey takes some time */
    if (set == &solver->scene->all) state->too_late = math_min(state->too_late, state->known_late);
    state->gap = NULL;
    tdsp_status status = latest_search(state);
    solver->engine.arrived = ENGINE_NONE;
    if (status != TDSP_OK || state->best < 0.0 || set == &solver->scene->all) return status;
    --solver->work.forward_searches; /* this one only looks again at what is known */
    status = solver_forward(solver, set, state->best, INFINITY, &arrives);
    return tdsp_status_is_answer(status) ? TDSP_OK : status;
}

/* Nothing grows: the travel time is the same for ever. */
static tdsp_status latest_still(latest_state *state, double arrival)
{
    tdsp_solver *solver = state->solver;
    double travel;
    tdsp_status status = solver_arrival(solver, 0.0, &travel);
    if (status != TDSP_OK) return tdsp_status_is_answer(status) ? TDSP_OK : status;
    if (arrival < travel) return TDSP_OK;
    state->best = arrival - travel;
    while (state->best + travel > arrival) state->best = nextafter(state->best, -1.0);
    state->arrives = state->best + travel;
    return TDSP_OK;
}

/* Where the destination is never covered and the departures end all the same, A at the last one stands for any arrival. */
static tdsp_status latest_general(latest_state *state, double arrival)
{
    tdsp_status status = general_latest(state->solver, arrival, state->known_good, state->known_late, &state->best, &state->arrives);
    if (status == TDSP_OK && isinf(state->arrival) && state->best >= 0.0) state->arrival = state->arrives;
    return status;
}

/* The state after the search; best < 0 when there is no departure. `after` and `before` are what is known already. */
static tdsp_status latest_run(tdsp_solver *solver, double arrival, double after, double before, latest_state *state)
{
    const tdsp_scene *scene = solver->scene;
    const scene_ends *ends = &solver->ends;
    double straight = point_distance(ends->source, ends->destination) * scene->time;
    latest_state start = {solver, &scene->all, solver->work, math_min(arrival, ends->destination_cover.time), -1.0, -1.0, INFINITY, NULL,
                          after, before};
    *state = start;
    solver->has_path = 0;
    if (solver->growth) return latest_general(state, arrival);
    if (scene_is_still(scene)) return latest_still(state, arrival);
    /* Infinite also where rates are so small that the moment in which the destination is covered is beyond doubles. */
    if (isinf(state->arrival / scene->time) || solver_is_far(solver, math_min(state->arrival, ends->source_cover.time))) return TDSP_NOT_SUPPORTED;
    if (scene_covered(ends->source_cover, 0.0) || state->arrival < straight * (1.0 - SAME_TIME)) return TDSP_OK;
    if (straight > 0.0) return relax_run(&solver->relaxation, &solver->engine, ask_latest, state);
    state->best = state->arrives = math_min(state->arrival, ends->source_cover.time);
    solver->engine.arrived = ENGINE_NONE;
    return route_keep(solver, state->best, state->best);
}

/*
 * The answer as everyone else will find it: A at the departure is asked for once more among all discs, and kept with its path. At the last moment
 * of a gap rounding may lose that path again, and it may put the arrival just after a; then the departure goes back by rounding, and by more
 * each time.
 */
static tdsp_status latest_confirm(latest_state *state)
{
    tdsp_solver *solver = state->solver;
    double back = latest_slack(state, STEP_BACK), late = 0.0;
    for (;;) {
        double found = INFINITY;
        tdsp_status status = solver_arrival(solver, state->best, &found);
        if (!tdsp_status_is_answer(status)) return status;
        if ((status == TDSP_OK && found <= state->arrival) || state->best == 0.0) {
            state->arrives = math_min(found, state->arrival);
            return route_keep(solver, state->best, state->arrives);
        }
        late = math_max(2.0 * late, math_max(found - state->arrival, ROUNDING * state->arrival));
        state->best = math_max(state->best - math_min(late, back), 0.0);
        if (late > back) back *= 4.0;
    }
}

/* Why is there no departure at all that arrives by a? */
static tdsp_status latest_refuse(tdsp_solver *solver, double arrival)
{
    double found;
    tdsp_status status = tdsp_earliest_arrival(solver, 0.0, &found);
    solver->has_path = 0;
    return status == TDSP_OK && found > arrival ? TDSP_ARRIVAL_TOO_EARLY : status;
}

tdsp_status tdsp_latest_departure(tdsp_solver *solver, double arrival, double *departure, double *arrives)
{
    if (!solver || !departure || !(arrival >= 0.0)) return TDSP_INVALID_ARGUMENT;
    latest_state state;
    tdsp_status status = latest_run(solver, arrival, -1.0, INFINITY, &state);
    if (status != TDSP_OK) return status;
    if (state.best < 0.0) {
        status = latest_refuse(solver, arrival);
        return status == TDSP_OK ? TDSP_ARRIVAL_TOO_EARLY : status;
    }
    if (!isinf(state.best)) status = latest_confirm(&state);
    if (status != TDSP_OK) return status;
    *departure = state.best;
    if (arrives) *arrives = state.arrives;
    return TDSP_OK;
}

tdsp_status solver_departure_between(tdsp_solver *solver, double arrival, double after, double before, double *departure, double *arrives)
{
    latest_state state;
    tdsp_status status = latest_run(solver, arrival, after, before, &state);
    if (status == TDSP_OK && state.best > after && !isinf(state.best)) status = latest_confirm(&state);
    if (status != TDSP_OK) return status;
    *departure = math_max(state.best, after);
    *arrives = state.arrives;
    return TDSP_OK;
}

/* No path arrives exactly at a: mostly because it is too early. *known is 0 when that is not it. */
static tdsp_status latest_without(latest_state *state, int *known)
{
    double found = INFINITY;
    tdsp_status status = solver_arrival(state->solver, 0.0, &found);
    *known = status == TDSP_OK && found > state->arrival + latest_slack(state, SAME_TIME);
    return *known ? TDSP_ARRIVAL_TOO_EARLY : status;
}

/* A path leaves at state->best and arrives exactly at a, and none that leaves later does. If A there is a as well, that is the answer. */
static tdsp_status latest_with(latest_state *state, int *known)
{
    tdsp_status status = latest_confirm(state);
    *known = status == TDSP_OK && state->best > 0.0 && state->arrival - state->arrives <= latest_slack(state, SAME_TIME);
    return status;
}

tdsp_status solver_departure_at(tdsp_solver *solver, double arrival, double candidate, double *departure, double *arrives)
{
    const scene_ends *ends = &solver->ends;
    int known;
    if (scene_covered(ends->source_cover, 0.0)) return TDSP_SOURCE_COVERED;
    latest_state state = {solver, &solver->scene->all, solver->work, math_min(arrival, ends->destination_cover.time), -1.0, -1.0, INFINITY, NULL,
                          -1.0, INFINITY};
    state.best = math_min(candidate, ends->source_cover.time);
    tdsp_status status = candidate < 0.0 ? latest_without(&state, &known) : latest_with(&state, &known);
    if (!tdsp_status_is_answer(status)) return status;
    if (!known) return tdsp_latest_departure(solver, arrival, departure, arrives);
    *departure = state.best;
    *arrives = state.arrives;
    return status;
}

static uint32_t latest_given(const latest_state *state, uint32_t disc)
{
    return relax_given(&state->solver->relaxation, state->set, disc);
}

static void last_by_cover(tdsp_last_departure *out, tdsp_status reason, scene_cover cover, tdsp_point end)
{
    out->reason = reason;
    out->disc = cover.disc;
    out->time = cover.time;
    out->place = end;
}

/* The gap that the path of the last departure only just passes, if there is one. */
static void last_by_gap(const tdsp_solver *solver, tdsp_last_departure *out)
{
    tdsp_gap gap;
    if (solver_pinch(solver, &gap) != TDSP_OK) return;
    out->disc = gap.first;
    out->other = gap.second;
    out->time = gap.time;
    out->place = gap.place;
}

/* What stops the departures after state->best: the reason that holds right after it, and its witness. */
static tdsp_status last_explain(const latest_state *state, tdsp_last_departure *out)
{
    const scene_ends *ends = &state->solver->ends;
    if (state->best >= ends->source_cover.time - latest_slack(state, SAME_TIME)) {
        last_by_cover(out, TDSP_SOURCE_COVERED, ends->source_cover, ends->given.source);
        return TDSP_OK;
    }
    if (state->gap) { /* a witness for the cut; read before the next search replaces the set */
        const tdsp_scene *scene = state->solver->scene;
        out->disc = latest_given(state, state->gap->first);
        out->other = latest_given(state, state->gap->second);
        out->time = state->gap->time * scene->time;
        out->place = scene_place(scene, state->gap->place);
    }
    tdsp_status status = reason_find(state->solver, state->best + latest_slack(state, PROOF_STEP), &out->reason);
    if (status != TDSP_OK || out->reason == TDSP_CUT_OFF) return status;
    last_by_cover(out, TDSP_DESTINATION_COVERED, ends->destination_cover, ends->given.destination);
    out->other = TDSP_NO_DISC;
    return TDSP_OK;
}

tdsp_status solver_last_reason(tdsp_solver *solver, double last, tdsp_status *reason)
{
    latest_state state = {solver, &solver->scene->all, solver->work, solver->ends.destination_cover.time, last, last, INFINITY, NULL, -1.0, INFINITY};
    tdsp_last_departure out;
    tdsp_status status = last_explain(&state, &out);
    if (status == TDSP_OK) *reason = out.reason;
    return status;
}

tdsp_status tdsp_solver_last_departure(tdsp_solver *solver, tdsp_last_departure *out)
{
    if (!solver || !out) return TDSP_INVALID_ARGUMENT;
    latest_state state;
    tdsp_status status = latest_run(solver, INFINITY, -1.0, INFINITY, &state);
    if (status != TDSP_OK) return status;
    if (state.best < 0.0) return latest_refuse(solver, INFINITY);
    tdsp_last_departure last = {state.best, state.arrives, TDSP_OK, TDSP_NO_DISC, TDSP_NO_DISC, state.arrives, solver->ends.given.destination};
    if (!isinf(state.best)) status = last_explain(&state, &last);
    if (!isinf(state.best) && status == TDSP_OK) status = latest_confirm(&state);
    if (status != TDSP_OK) return status;
    if (solver->growth && last.reason == TDSP_CUT_OFF) last_by_gap(solver, &last);
    last.departure = state.best;
    last.arrival = state.arrives;
    *out = last;
    return TDSP_OK;
}
