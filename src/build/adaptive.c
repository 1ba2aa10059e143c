/*
 * Adaptive sampling: b_i = sup { t : the guarantee holds on (b_(i-1), t] }, row by row.
 *
 * Greedy is optimal: the cap of a row rises with the lower bound it starts from, the lower bound with the departure, so a row
 * that ends later never leads to more rows (docs/sampler.md). Two rows meet in one of two ways:
 *
 *   at a jump       a lower bound of the value right after b is known, by a reverse call or by the value at the next double; the
 *                   following row starts from it;
 *   on a slope      the row stops within a thousandth of the allowed increase, and its right side is its own value,
 *                   rounded down, for values never decrease.
 */
#include "build/sampler.h"

#include <math.h>

#include "build/invert.h"
#include "build/trail.h"

#define SLACK 1e-3  /* of the allowed increase */
#define GIVE 5e-4   /* likewise, at jumps */
#define REVERSALS 4 /* a row: each may find another jump under the cap first */

/* The goal of the row after the one held, which starts at `base` from the bound `lower`. */
static inversion goal_after(const sampler *s, const sample *base, double lower)
{
    double b = s->rows.held.departure;
    double cap = rows_cap(s->options, s->monotone, b, lower);
    inversion goal = {.cap = cap,
                      .slack = SLACK * (cap - lower),
                      .room = cap - base->ceiling,
                      .anchor = -INFINITY,
                      .after = b,
                      .give = GIVE * (cap - lower),
                      .seed = NAN,
                      .reversals = REVERSALS};
    if (s->options->guarantee != TDSP_GUARANTEE_ARRIVAL) return goal;
    /* What keeps this from needing more rows than geometric sampling: A(b_i) >= (1 + eps) A(b_(i-1)+) up to noise. */
    if (s->monotone == TDSP_MONOTONE_TRAVEL)
        goal.anchor = b;
    else
        goal.slack = 0;
    return goal;
}

static tdsp_status add_row(sampler *s, const bracket *b, double cap)
{
    sample low = b->low;
    tdsp_status status = sampler_recall_path(&s->probe, &low, cap);
    if (status != TDSP_OK) return status;
    row next = sampler_row(s, &low, b->after);
    s->probe.settled = low.departure;
    return rows_add(&s->rows, &next, &s->probe.path);
}

/* Samples ahead that fit are where the row goes at least. Returns 1 when that is the end of the domain. */
static int pass_known(trail *t, double cap, bracket *b)
{
    while (t->ahead_count > 0 && sample_fits(&t->ahead[t->ahead_count - 1], cap)) b->low = t->ahead[--t->ahead_count];
    if (t->ahead_count == 0) return 1;
    b->high = t->ahead[t->ahead_count - 1];
    return 0;
}

/* One row more, or the right side of the row held when the value jumps just after it. *base is where the next one starts. */
static tdsp_status step(sampler *s, trail *t, sample *base, int *ended)
{
    const row *held = &s->rows.held;
    double lower = held->right + (s->probe.by_arrival ? held->departure : 0);
    inversion goal = goal_after(s, base, lower);
    if (!sample_fits(base, goal.cap)) return TDSP_NOT_SUPPORTED;
    bracket b = {.low = *base, .high = *base};
    *ended = pass_known(t, goal.cap, &b);
    if (*ended) return TDSP_OK;
    double pace = t->pace;
    tdsp_status status = invert(&s->probe, &goal, t, &b);
    if (status != TDSP_OK) return status;
    *base = b.jumps ? b.high : b.low;
    if (b.jumps) {
        trail_restart(t, &b.high);
        t->pace = pace;
    }
    if (b.low.departure > held->departure) return add_row(s, &b, goal.cap);
    rows_raise_right(&s->rows, sampler_row(s, &b.low, b.after).right);
    return TDSP_OK;
}

tdsp_status sampler_adaptive(sampler *s)
{
    sample base = s->domain.first;
    row first = sampler_row(s, &base, base.lower);
    tdsp_status status = rows_add(&s->rows, &first, &s->domain.first_path);
    trail t = trail_begin(&base, &s->domain.last);
    int ended = s->domain.last.departure == 0;
    while (status == TDSP_OK && !ended) status = step(s, &t, &base, &ended);
    return status == TDSP_OK ? sampler_finish(s) : status;
}
