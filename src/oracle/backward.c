/* SPDX-License-Identifier: MIT */
/*
 * d = sup { t : A(t) <= a } means two things: who leaves before d arrives by a (else d is late), and who leaves after d does not (else it is early). Both
 * are asked of the forward function beside d, and of every departure seen before: that holds the whole of A against each answer, so that
 * latest departures that do not rise with a, or miss a jump, cannot hide.
 */
#include "oracle/backward.h"

#include "base/math.h"
#include "base/round.h"
#include "oracle/forward.h"
#include "oracle/path.h"
#include "scene/allocator.h"

/* The most questions of ask_at_ends() and ask_in_jumps(). */
#define AT_ENDS 9
#define IN_JUMPS 12

/* A question and its answer. */
typedef struct reply {
    double arrival;
    double departure;
    tdsp_status status;
} reply;

/* ------------------------------------------------------------------------------------------------------------- judging */

double backward_reach(const examiner *x, double d)
{
    double arrival = 0;
    for (size_t i = x->seen_count; i-- > 0 && arrival == 0;)
        if (x->seen[i].status == TDSP_OK && x->seen[i].departure <= d) arrival = x->seen[i].arrival;
    return 2 * examiner_blur(x, math_max(arrival, isfinite(d) ? d : 0));
}

/* The noise of A(s) and of a reverse answer to a. */
static double tolerance_of(const examiner *x, const seen *s, double a)
{
    double noise = examiner_noise(x, s->departure, s->arrival);
    return isfinite(a) ? noise + examiner_noise(x, s->departure, math_max(a, s->arrival)) : noise;
}

static int is_late(const examiner *x, const seen *s, double a)
{
    return s->status != TDSP_OK || (isfinite(a) && s->arrival > a + tolerance_of(x, s, a));
}

static int is_in_time(const examiner *x, const seen *s, double a)
{
    return s->status == TDSP_OK && (isinf(a) || s->arrival < a - tolerance_of(x, s, a));
}

static void note(examiner *x, tdsp_oracle_rule rule, tdsp_oracle_callback callback, double a, double d, const seen *s)
{
    examiner_note(x, &(tdsp_oracle_finding){rule, callback, TDSP_OK, a, d, s->departure, s->arrival, a});
}

/* Against what is known: 1 when a finding is noted. */
static int contradicts_seen(examiner *x, tdsp_oracle_callback callback, double a, double d, double reach)
{
    for (size_t i = 0; i < x->seen_count; i++) {
        const seen *s = &x->seen[i];
        int late = s->departure < d - reach && is_late(x, s, a);
        int early = s->departure > d + reach && is_in_time(x, s, a);
        if (late) note(x, TDSP_RULE_LATE, callback, a, d, s);
        if (early) note(x, TDSP_RULE_EARLY, callback, a, d, s);
        if (late || early) return 1;
    }
    return 0;
}

static void judge_beside(examiner *x, tdsp_oracle_callback callback, double a, double d, double reach)
{
    seen at, before, after;
    int is_known = forward_see(x, d, &at);
    if (is_known && is_late(x, &at, a)) {
        int displaced = forward_see(x, math_max(d - reach, 0), &before) && !is_late(x, &before, a);
        if (!displaced) note(x, TDSP_RULE_LATE, callback, a, d, &at);
    }
    if (forward_see(x, math_max(d + reach, round_next_up(d)), &after) && is_in_time(x, &after, a)) note(x, TDSP_RULE_EARLY, callback, a, d, &after);
}

void backward_judge(examiner *x, tdsp_oracle_callback callback, double a, double d)
{
    double reach = backward_reach(x, d);
    examiner_look(x, TDSP_RULE_LATE);
    examiner_look(x, TDSP_RULE_EARLY);
    if (!contradicts_seen(x, callback, a, d, reach) && isfinite(d)) judge_beside(x, callback, a, d, reach);
}

int backward_is_refused(double a, tdsp_status status)
{
    return isinf(a) && (status == TDSP_NOT_SUPPORTED || status == TDSP_SHRINKS);
}

/* Is the answer one to the question, given that A(0) is known? 1 when there is a departure to judge. */
static int judge_status(examiner *x, const reply *r, const seen *first)
{
    double noise = tolerance_of(x, first, r->arrival);
    tdsp_oracle_finding wrong = {TDSP_RULE_BOTH_WAYS, TDSP_ORACLE_LATEST_DEPARTURE, r->status, r->arrival, r->departure, 0, first->arrival, r->arrival};
    examiner_look(x, TDSP_RULE_BOTH_WAYS);
    int has_way = r->status == TDSP_OK || r->status == TDSP_ARRIVAL_TOO_EARLY;
    if (has_way != (first->status == TDSP_OK)) {
        examiner_note(x, &wrong);
        return 0;
    }
    if (!has_way) return 0;
    examiner_look(x, TDSP_RULE_TOO_EARLY);
    wrong.rule = TDSP_RULE_TOO_EARLY;
    int wrongly_early = r->status != TDSP_OK && (isinf(r->arrival) || r->arrival > first->arrival + noise);
    int wrongly_not = r->status == TDSP_OK && r->arrival < first->arrival - noise;
    if (wrongly_early || wrongly_not) examiner_note(x, &wrong);
    return r->status == TDSP_OK && !wrongly_not;
}

static int judge_number(examiner *x, const reply *r)
{
    examiner_look(x, TDSP_RULE_DEPARTURE);
    if (r->departure >= 0 && (isfinite(r->departure) || isinf(r->arrival))) return 1;
    examiner_note(x, &(tdsp_oracle_finding){TDSP_RULE_DEPARTURE, TDSP_ORACLE_LATEST_DEPARTURE, r->status, r->arrival, r->departure, NAN, r->departure, 0});
    return 0;
}

/* -------------------------------------------------------------------------------------------------------------- asking */

static int ask(examiner *x, double arrival, reply *out)
{
    double departure = NAN;
    if (!examiner_may_call(x)) return 0;
    double began = examiner_begin(x);
    tdsp_status status = x->oracle.latest_departure(x->oracle.ctx, arrival, &departure);
    examiner_end(x, TDSP_ORACLE_LATEST_DEPARTURE, arrival, began);
    *out = (reply){arrival, status == TDSP_OK ? departure : NAN, status};
    if (backward_is_refused(arrival, status)) return 0;
    return examiner_allows(x, TDSP_ORACLE_LATEST_DEPARTURE, arrival, status, ALLOW_OK | ALLOW_NO_WAY | ALLOW_TOO_EARLY);
}

static void ask_and_judge(examiner *x, double arrival, reply *replies, size_t *count)
{
    seen first;
    reply r;
    if (!ask(x, arrival, &r)) return;
    replies[(*count)++] = r;
    if (!forward_first(x, &first) || !judge_status(x, &r, &first) || !judge_number(x, &r)) return;
    backward_judge(x, TDSP_ORACLE_LATEST_DEPARTURE, arrival, r.departure);
}

/* An arrival seen, or one between two of them: inside the jump where the two are beside one. */
static double choose_arrival(examiner *x)
{
    size_t with_way = forward_first_without_way(x);
    if (with_way == 0) return examiner_unit(x);
    size_t i = examiner_below(x, with_way);
    double arrival = x->seen[i].arrival;
    if (i + 1 >= with_way || examiner_unit(x) < 0.25) return arrival;
    return arrival + (x->seen[i + 1].arrival - arrival) * examiner_unit(x);
}

static void ask_at_ends(examiner *x, reply *replies, size_t *count)
{
    static const double shares[] = {0, 0.5, 0.999, 1, 1.001, 1.1};
    size_t with_way = forward_first_without_way(x);
    ask_and_judge(x, INFINITY, replies, count);
    for (size_t i = 0; i < sizeof shares / sizeof shares[0] && with_way > 0; i++)
        ask_and_judge(x, shares[i] * x->seen[0].arrival, replies, count);
    if (with_way == 0) return;
    const seen last = x->seen[with_way - 1];
    ask_and_judge(x, last.arrival, replies, count);
    ask_and_judge(x, last.arrival + (last.arrival - last.departure), replies, count);
}

/* The places that are easiest to get wrong: no path arrives inside a jump. */
static void ask_in_jumps(examiner *x, reply *replies, size_t *count)
{
    static const double shares[] = {0.01, 0.5, 0.99};
    size_t most = *count + IN_JUMPS;
    for (size_t i = 0; i + 1 < x->seen_count; i++) {
        if (!forward_jumps(x, i)) continue;
        double low = x->seen[i].arrival, high = x->seen[i + 1].arrival;
        for (size_t k = 0; k < sizeof shares / sizeof shares[0] && *count < most; k++)
            ask_and_judge(x, low + (high - low) * shares[k], replies, count);
    }
}

static void ask_again(examiner *x, const reply *replies, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        const reply *first = &replies[examiner_below(x, count)];
        reply second;
        if (!ask(x, first->arrival, &second)) continue;
        examiner_look(x, TDSP_RULE_REPEATABLE);
        int same = first->status == second.status && (second.status != TDSP_OK || examiner_same(first->departure, second.departure));
        tdsp_oracle_finding wrong = {TDSP_RULE_REPEATABLE, TDSP_ORACLE_LATEST_DEPARTURE, second.status, first->arrival, second.departure, NAN,
                                     second.departure, first->departure};
        if (!same) examiner_note(x, &wrong);
    }
}

void backward_examine(examiner *x)
{
    size_t capacity = (size_t)x->options->departures + AT_ENDS + IN_JUMPS, count = 0;
    if (!x->oracle.latest_departure) return;
    reply *replies = memory_array(&x->allocator, capacity, sizeof *replies);
    if (!replies) {
        x->failed = 1;
        return;
    }
    ask_at_ends(x, replies, &count);
    ask_in_jumps(x, replies, &count);
    for (uint32_t i = 0; i < x->options->departures && !x->failed; i++)
        ask_and_judge(x, choose_arrival(x), replies, &count);
    ask_again(x, replies, count);
    memory_free(&x->allocator, replies, capacity * sizeof *replies);
}

/* ------------------------------------------------------------------------------------------------------ the last reason */

void reason_examine(examiner *x)
{
    size_t without = forward_first_without_way(x);
    tdsp_status reason = TDSP_OK;
    if (!x->oracle.last_reason || without == 0 || without == x->seen_count || !examiner_may_call(x)) return;
    double last = x->seen[without - 1].departure;
    double began = examiner_begin(x);
    tdsp_status status = x->oracle.last_reason(x->oracle.ctx, last, &reason);
    examiner_end(x, TDSP_ORACLE_LAST_REASON, last, began);
    if (!examiner_allows(x, TDSP_ORACLE_LAST_REASON, last, status, ALLOW_OK)) return;
    examiner_look(x, TDSP_RULE_REASON);
    int is_one = tdsp_status_is_answer(reason) && (ALLOW_NO_WAY >> (unsigned)reason & 1u) != 0;
    if (!is_one) examiner_note(x, &(tdsp_oracle_finding){TDSP_RULE_REASON, TDSP_ORACLE_LAST_REASON, reason, last, NAN, NAN, NAN, NAN});
}
