/* SPDX-License-Identifier: MIT */
/* latest_departure_between: told two departures around the answer, as the sampler does, and judged like any latest departure. */

#include "base/math.h"
#include "oracle/backward.h"
#include "oracle/forward.h"
#include "oracle/path.h"

typedef struct question {
    double arrival, after, before;
} question;

typedef struct reply {
    double departure, arrives;
    tdsp_status status;
} reply;

static int ask(examiner *x, const question *q, reply *out)
{
    *out = (reply){NAN, NAN, TDSP_OK};
    if (!examiner_may_call(x)) return 0;
    double began = examiner_begin(x);
    out->status = x->oracle.latest_departure_between(x->oracle.ctx, q->arrival, q->after, q->before, &out->departure, &out->arrives);
    examiner_end(x, TDSP_ORACLE_LATEST_DEPARTURE_BETWEEN, q->arrival, began);
    if (backward_is_refused(q->arrival, out->status)) return 0;
    return examiner_allows(x, TDSP_ORACLE_LATEST_DEPARTURE_BETWEEN, q->arrival, out->status, ALLOW_OK);
}

static tdsp_oracle_finding finding(tdsp_oracle_rule rule, const question *q, double answered, double number, double expected)
{
    return (tdsp_oracle_finding){rule, TDSP_ORACLE_LATEST_DEPARTURE_BETWEEN, TDSP_OK, q->arrival, answered, NAN, number, expected};
}

static int judge_number(examiner *x, const question *q, double d)
{
    tdsp_oracle_finding wrong = finding(TDSP_RULE_DEPARTURE, q, d, d, d < q->after ? q->after : q->before);
    examiner_look(x, TDSP_RULE_DEPARTURE);
    if (d >= q->after && d <= q->before) return 1;
    examiner_note(x, &wrong);
    return 0;
}

/* A(t) and what comes with it say the same. */
static int agrees(examiner *x, double t, const reply *r, int side)
{
    seen s;
    if (!forward_see(x, t, &s) || s.status != TDSP_OK) return side > 0; /* after the last departure nothing is too much */
    double noise = 2 * examiner_noise(x, s.departure, s.arrival);
    double over = r->arrives - s.arrival;
    return side > 0 ? over <= noise : side < 0 ? over >= -noise : fabs(over) <= noise;
}

static void judge_arrives(examiner *x, const question *q, const reply *r)
{
    seen at;
    double reach = backward_reach(x, r->departure);
    examiner_look(x, TDSP_RULE_ARRIVES);
    if (!forward_see(x, r->departure, &at) || at.status != TDSP_OK || agrees(x, r->departure, r, 0)) return;
    /* A jump there may be displaced. */
    if (agrees(x, math_max(r->departure - reach, 0), r, -1) && agrees(x, r->departure + reach, r, 1)) return;
    tdsp_oracle_finding wrong = finding(TDSP_RULE_ARRIVES, q, r->departure, r->arrives, at.arrival);
    examiner_note(x, &wrong);
}

/* The last departure, with what its arrival says; the path first, for it is that of the last answer. */
static void judge(examiner *x, const question *q, const reply *r)
{
    uint64_t hash;
    if (!judge_number(x, q, r->departure)) return;
    int has_arrival = r->departure > q->after && isfinite(r->departure);
    if (has_arrival && isfinite(r->arrives)) (void)path_examine(x, r->departure, r->arrives, &hash);
    if (has_arrival) judge_arrives(x, q, r);
    backward_judge(x, TDSP_ORACLE_LATEST_DEPARTURE_BETWEEN, q->arrival, r->departure);
}

static void judge_again(examiner *x, const question *q, const reply *first)
{
    reply second;
    if (!ask(x, q, &second)) return;
    int has_arrival = first->departure > q->after && isfinite(first->departure);
    int same = examiner_same(first->departure, second.departure) && (!has_arrival || examiner_same(first->arrives, second.arrives));
    tdsp_oracle_finding wrong = finding(TDSP_RULE_REPEATABLE, q, second.departure, second.departure, first->departure);
    examiner_look(x, TDSP_RULE_REPEATABLE);
    if (!same) examiner_note(x, &wrong);
}

static void ask_and_judge(examiner *x, const question *q, int again)
{
    reply first;
    if (!ask(x, q, &first)) return;
    judge(x, q, &first);
    if (again) judge_again(x, q, &first);
}

/* Two departures seen, and an arrival between theirs by more than the noise; 0 when chance finds none. */
static int choose(examiner *x, question *q)
{
    size_t with_way = forward_first_without_way(x);
    size_t i = examiner_below(x, with_way), j = examiner_below(x, x->seen_count);
    if (j <= i) return 0;
    const seen *after = &x->seen[i], *before = &x->seen[j];
    double most = isfinite(before->arrival) ? before->arrival : 2 * after->arrival - after->departure;
    double margin = 2 * (examiner_noise(x, after->departure, after->arrival) + examiner_noise(x, after->departure, most));
    *q = (question){after->arrival + (most - after->arrival) * examiner_unit(x), after->departure, before->departure};
    return q->arrival >= after->arrival + margin && (q->arrival <= most - margin || isinf(before->arrival));
}

void between_examine(examiner *x)
{
    size_t with_way = forward_first_without_way(x);
    if (!x->oracle.latest_departure_between || with_way == 0) return;
    question q = {INFINITY, 0, INFINITY};
    ask_and_judge(x, &q, 1);
    q.after = x->seen[with_way - 1].departure;
    ask_and_judge(x, &q, 1);
    for (uint32_t i = 0; i < x->options->departures && !x->failed; i++)
        if (choose(x, &q)) ask_and_judge(x, &q, i % 4 == 0);
}
