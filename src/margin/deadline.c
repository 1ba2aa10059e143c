/* SPDX-License-Identifier: MIT */
/*
 * The latest departure for a deadline, and why no later one is in time.
 *
 * A is strictly increasing and left-continuous. When the latest departure arrives at the deadline itself, A is continuous enough there: the deadline
 * is the limit. When it arrives earlier, A jumps over the deadline right after it, or ends: the search for a moment later tells which. Only the public
 * solver is asked: it serves every law of growth.
 */

#include "base/math.h"
#include "scene/scene.h" /* the unit of time, nothing else */
#include "tdsp/margin.h"

/* An arrival this near to the deadline, relative to the journey and to the time itself, is at the deadline. */
#define SAME_TIME 1e-10
#define ROUNDING 1e-14

/* "A moment later", relative to the same. */
#define MOMENT 2e-9
#define MOMENT_ROUNDING 1e-13

const char *tdsp_limit_name(tdsp_limit limit)
{
    switch (limit) {
    case TDSP_LIMIT_NONE: return "none";
    case TDSP_LIMIT_DEADLINE: return "deadline";
    case TDSP_LIMIT_GAP: return "gap";
    case TDSP_LIMIT_JUMP: return "jump";
    case TDSP_LIMIT_SOURCE_COVERED: return "source_covered";
    case TDSP_LIMIT_DESTINATION_COVERED: return "destination_covered";
    case TDSP_LIMIT_CUT_OFF: return "cut_off";
    case TDSP_LIMIT_TOUCH: return "touch";
    }
    return "unknown";
}

/* A question under way. */
typedef struct deadline_state {
    tdsp_solver *solver;
    tdsp_deadline_answer answer;
} deadline_state;

static double share_of(const deadline_state *state, double share, double rounding)
{
    const tdsp_deadline_answer *answer = &state->answer;
    const double unit = tdsp_solver_scene(state->solver)->time;
    return share * (unit + answer->arrival - answer->departure) + rounding * answer->arrival;
}

/* The gap that closes where A jumps to answer.after_arrival at the departure `after`. */
static tdsp_status deadline_gap(deadline_state *state, double after)
{
    tdsp_deadline_answer *answer = &state->answer;
    tdsp_gap gap;
    const double travel_before = answer->arrival - answer->departure, travel_after = answer->after_arrival - after;
    tdsp_status status = TDSP_NO_ANSWER;
    answer->witness.limit = TDSP_LIMIT_JUMP;
    answer->witness.time = answer->departure;
    if (travel_after > travel_before) status = tdsp_solver_gap(state->solver, answer->departure, &gap);
    if (status == TDSP_NO_ANSWER) return TDSP_OK;
    if (status == TDSP_OK) answer->witness = (tdsp_witness){TDSP_LIMIT_GAP, gap.first, gap.second, gap.time, gap.place};
    return status;
}

static tdsp_limit limit_of(const tdsp_last_departure *last)
{
    if (last->reason == TDSP_SOURCE_COVERED) return TDSP_LIMIT_SOURCE_COVERED;
    if (last->reason == TDSP_DESTINATION_COVERED) return TDSP_LIMIT_DESTINATION_COVERED;
    return last->other == TDSP_NO_DISC ? TDSP_LIMIT_CUT_OFF : TDSP_LIMIT_GAP;
}

/* There is no way any more. */
static tdsp_status deadline_end(deadline_state *state)
{
    tdsp_last_departure last;
    const tdsp_status status = tdsp_solver_last_departure(state->solver, &last);
    if (status != TDSP_OK) return status;
    const int is_swapped = last.other < last.disc; /* a gap's discs are named in their order; no disc is the largest number */
    const uint32_t first = is_swapped ? last.other : last.disc, second = is_swapped ? last.disc : last.other;
    state->answer.witness = (tdsp_witness){limit_of(&last), first, second, last.time, last.place};
    return TDSP_OK;
}

/* What happens a moment after the latest departure. */
static tdsp_status deadline_look_after(deadline_state *state)
{
    tdsp_deadline_answer *answer = &state->answer;
    const double after = answer->departure + share_of(state, MOMENT, MOMENT_ROUNDING);
    answer->after = tdsp_earliest_arrival(state->solver, after, &answer->after_arrival);
    if (answer->after == TDSP_OK) return deadline_gap(state, after);
    return tdsp_status_is_answer(answer->after) ? deadline_end(state) : answer->after;
}

/* The limit of a latest departure that arrives before the deadline; leaves the solver with its path. */
static tdsp_status deadline_explain(deadline_state *state)
{
    double again;
    tdsp_status status = deadline_look_after(state);
    if (status == TDSP_OK) status = tdsp_earliest_arrival(state->solver, state->answer.departure, &again);
    return status;
}

tdsp_status tdsp_solver_deadline(tdsp_solver *solver, double deadline, tdsp_deadline_answer *out)
{
    tdsp_ends ends;
    if (!solver || !out) return TDSP_INVALID_ARGUMENT;
    (void)tdsp_solver_ends(solver, &ends); /* which every solver has */
    const tdsp_witness none = {TDSP_LIMIT_NONE, TDSP_NO_DISC, TDSP_NO_DISC, INFINITY, ends.destination};
    deadline_state state = {solver, {INFINITY, INFINITY, none, TDSP_OK, INFINITY}};
    tdsp_deadline_answer *answer = &state.answer;
    tdsp_status status = tdsp_latest_departure(solver, deadline, &answer->departure, &answer->arrival);
    if (status != TDSP_OK) return status;
    if (deadline - answer->arrival <= share_of(&state, SAME_TIME, ROUNDING)) {
        answer->witness.limit = TDSP_LIMIT_DEADLINE;
        answer->witness.time = answer->after_arrival = deadline;
    } else if (!isinf(answer->departure)) {
        status = deadline_explain(&state);
    }
    if (status == TDSP_OK) *out = *answer;
    return status;
}

tdsp_status tdsp_solver_slack(tdsp_solver *solver, double departure, double deadline, tdsp_slack *out)
{
    if (!solver || !out || isnan(deadline)) return TDSP_INVALID_ARGUMENT;
    tdsp_slack slack = {.arrival = INFINITY, .early = -INFINITY, .later = -INFINITY};
    slack.status = tdsp_earliest_arrival(solver, departure, &slack.arrival);
    if (!tdsp_status_is_answer(slack.status)) return slack.status;
    if (slack.status == TDSP_OK) slack.early = deadline - slack.arrival;
    slack.latest_status = tdsp_solver_deadline(solver, deadline, &slack.latest);
    if (!tdsp_status_is_answer(slack.latest_status)) return slack.latest_status;
    if (slack.latest_status == TDSP_OK) slack.later = slack.latest.departure - departure;
    /* A departure at the limit is in time, whatever the rounding of the latest. */
    if (slack.early >= 0.0) slack.later = math_max(slack.later, 0.0);
    *out = slack;
    return TDSP_OK;
}
