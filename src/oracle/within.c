/* SPDX-License-Identifier: MIT */
/* Bounds are held against A at the departure itself, or, where a jump may be displaced, against A a little before and after it. */
#include "oracle/within.h"

#include "base/math.h"
#include "oracle/backward.h"
#include "oracle/forward.h"
#include "oracle/path.h"

typedef struct reply {
    double departure, delta, arrival, lower;
    tdsp_status status;
} reply;

static tdsp_oracle_finding finding(tdsp_oracle_rule rule, const reply *r, double number, double expected)
{
    return (tdsp_oracle_finding){rule, TDSP_ORACLE_EARLIEST_ARRIVAL_WITHIN, r->status, r->departure, NAN, r->delta, number, expected};
}

static int ask(examiner *x, double departure, double delta, reply *out)
{
    *out = (reply){departure, delta, NAN, NAN, TDSP_OK};
    if (!examiner_may_call(x)) return 0;
    double began = examiner_begin(x);
    out->status = x->oracle.earliest_arrival_within(x->oracle.ctx, departure, delta, &out->arrival, &out->lower);
    examiner_end(x, TDSP_ORACLE_EARLIEST_ARRIVAL_WITHIN, departure, began);
    if (out->status != TDSP_OK) out->arrival = out->lower = INFINITY;
    return examiner_allows(x, TDSP_ORACLE_EARLIEST_ARRIVAL_WITHIN, departure, out->status, ALLOW_OK | ALLOW_NO_WAY);
}

static int judge_number(examiner *x, const reply *r, double number)
{
    tdsp_oracle_finding wrong = finding(TDSP_RULE_ARRIVAL, r, number, r->departure);
    examiner_look(x, TDSP_RULE_ARRIVAL);
    if (number >= r->departure && isfinite(number)) return 1;
    examiner_note(x, &wrong);
    return 0;
}

static int judge_width(examiner *x, const reply *r)
{
    double noise = 2 * examiner_noise(x, r->departure, math_max(r->arrival, r->lower));
    double most = r->departure + (1 + r->delta) * (r->lower - r->departure) + noise;
    tdsp_oracle_finding crossed = finding(TDSP_RULE_WITHIN, r, r->lower, r->arrival), wide = finding(TDSP_RULE_WITHIN, r, r->arrival, most);
    examiner_look(x, TDSP_RULE_WITHIN);
    if (r->lower > r->arrival) examiner_note(x, &crossed);
    if (r->arrival > most) examiner_note(x, &wide);
    return r->lower <= r->arrival && r->arrival <= most;
}

/* Could A be as small as the upper bound at this departure, as large as the lower one at that? No way is an infinite arrival. */
static int holds(const examiner *x, const reply *r, const seen *least, const seen *most)
{
    int reaches = isinf(r->arrival) || least->arrival <= r->arrival + examiner_noise(x, r->departure, r->arrival) + examiner_noise(x, least->departure, math_min(least->arrival, r->arrival));
    int stays = isinf(most->arrival) || most->arrival >= r->lower - 2 * examiner_noise(x, most->departure, most->arrival);
    return reaches && stays;
}

static void judge_bounds(examiner *x, const reply *r, const seen *at)
{
    seen before, after;
    double reach = backward_reach(x, r->departure);
    examiner_look(x, TDSP_RULE_BOUNDS);
    if (holds(x, r, at, at)) return;
    int is_known = forward_see(x, math_max(r->departure - reach, 0), &before) && forward_see(x, r->departure + reach, &after);
    if (!is_known || holds(x, r, &before, &after)) return;
    tdsp_oracle_finding wrong = finding(TDSP_RULE_BOUNDS, r, r->arrival < at->arrival ? r->arrival : r->lower, at->arrival);
    examiner_note(x, &wrong);
}

static void judge_again(examiner *x, const reply *first)
{
    reply second;
    if (!ask(x, first->departure, first->delta, &second)) return;
    int same = first->status == second.status && examiner_same(first->arrival, second.arrival) && examiner_same(first->lower, second.lower);
    tdsp_oracle_finding wrong = finding(TDSP_RULE_REPEATABLE, first, second.arrival, first->arrival);
    examiner_look(x, TDSP_RULE_REPEATABLE);
    if (!same) examiner_note(x, &wrong);
}

static void ask_and_judge(examiner *x, const seen *at, double delta, int again)
{
    reply r;
    uint64_t hash;
    if (!ask(x, at->departure, delta, &r)) return;
    if (r.status == TDSP_OK) {
        if (!judge_number(x, &r, r.arrival) || !judge_number(x, &r, r.lower)) return;
        (void)path_examine(x, r.departure, r.arrival, &hash);
    }
    if (r.status != TDSP_OK || judge_width(x, &r)) judge_bounds(x, &r, at);
    if (again) judge_again(x, &r);
}

void within_examine(examiner *x)
{
    static const double deltas[] = {0, 1e-3, 0.01, 0.1, 1};
    const size_t count = sizeof deltas / sizeof deltas[0];
    if (!x->oracle.earliest_arrival_within || x->seen_count == 0) return;
    for (uint32_t i = 0; i < x->options->departures && !x->failed; i++) {
        const seen at = x->seen[examiner_below(x, x->seen_count)];
        ask_and_judge(x, &at, deltas[i % count], i % 4 == 0);
    }
}
