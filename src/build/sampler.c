/* SPDX-License-Identifier: MIT */
/* What both ways of sampling share. */
#include "build/sampler.h"

#include "base/math.h"

#define SLACK 1e-3  /* of the allowed increase */
#define GIVE 5e-4   /* likewise, at jumps */
#define REVERSALS 4 /* a row: each may find another jump under the cap first */

inversion sampler_goal(const sampler *s, double departure, double ceiling, double lower)
{
    double cap = rows_cap(s->options, s->monotone, departure, lower);
    inversion goal = {.cap = cap,
                      .slack = SLACK * (cap - lower),
                      .room = cap - ceiling,
                      .anchor = -INFINITY,
                      .after = departure,
                      .give = GIVE * (cap - lower),
                      .seed = NAN,
                      .reversals = REVERSALS};
    if (s->options->guarantee != TDSP_GUARANTEE_ARRIVAL) return goal;
    /* What keeps this from needing more rows than geometric sampling: A(b_i) >= (1 + eps) A(b_(i-1)+) up to noise. */
    if (s->monotone == TDSP_MONOTONE_TRAVEL)
        goal.anchor = departure;
    else
        goal.slack = 0;
    return goal;
}

row sampler_row(const sampler *s, const sample *at, double lower_after)
{
    double waited = s->probe.by_arrival ? at->departure : 0;
    double right = math_max(math_max(lower_after, at->lower) - waited, 0);
    return (row){at->departure, math_max(at->upper - waited, 0), right};
}

tdsp_status sampler_finish(sampler *s)
{
    const sample *last = &s->domain.last;
    row end = sampler_row(s, last, s->domain.right);
    if (last->departure > s->rows.held.departure) {
        tdsp_status status = rows_add(&s->rows, &end, &s->domain.last_path);
        if (status != TDSP_OK) return status;
    }
    rows_raise_right(&s->rows, end.right);
    return rows_end(&s->rows);
}

tdsp_status sampler_recall_path(probe *p, sample *s, double cap)
{
    if (p->path.departure == s->departure) return TDSP_OK;
    sample again;
    tdsp_status status = probe_roughly(p, s->departure, &again);
    if (status == TDSP_OK && !(again.upper <= cap)) status = probe_forward(p, s->departure, &again);
    if (status != TDSP_OK) return status;
    if (!(again.upper <= cap)) return TDSP_BAD_ORACLE;
    s->upper = math_max(s->upper, again.upper);
    return probe_keep_path(p, &again);
}
