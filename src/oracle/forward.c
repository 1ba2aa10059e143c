/* SPDX-License-Identifier: MIT */
/*
 * Where to ask. The end of the domain is found by doubling and halving, then departures are spread over it: one at random in each of equal
 * stretches, half of them in a long domain by its logarithm, and some beyond. Between neighbours with the steepest rise the half that rises more is taken again and again. What jumps keeps its
 * rise while the stretch shrinks, and so both sides of the jump come to be known; what is smooth loses it and is left alone.
 */
#include "oracle/forward.h"

#include <string.h>

#include "base/math.h"
#include "oracle/path.h"
#include "scene/allocator.h"

#define DOUBLINGS 10
#define HALVINGS 80
#define JUMPS 4
#define JUMP_SHARE 0.125 /* of the rise that was: less is smooth */
#define BEYOND 8         /* one departure in so many is after the last */
#define NEAR 0.125       /* of a journey: where logarithms begin */
#define LONG 64.0        /* of these: where they are worth it */

/* ---------------------------------------------------------------------------------------------------------- asking */

static int is_departure(double t)
{
    return t >= 0 && isfinite(t);
}

/* Call it, without a look at what is known. */
static int ask(examiner *x, double departure, seen *out)
{
    double arrival = NAN;
    if (!examiner_may_call(x)) return 0;
    double began = examiner_begin(x);
    tdsp_status status = x->oracle.earliest_arrival(x->oracle.ctx, departure, &arrival);
    examiner_end(x, TDSP_ORACLE_EARLIEST_ARRIVAL, departure, began);
    if (!examiner_allows(x, TDSP_ORACLE_EARLIEST_ARRIVAL, departure, status, ALLOW_OK | ALLOW_NO_WAY)) return 0;
    *out = (seen){departure, INFINITY, status, 0, 0};
    if (status != TDSP_OK) return 1;
    examiner_look(x, TDSP_RULE_ARRIVAL);
    out->arrival = arrival;
    if (arrival >= departure && isfinite(arrival)) return 1;
    examiner_note(x, &(tdsp_oracle_finding){TDSP_RULE_ARRIVAL, TDSP_ORACLE_EARLIEST_ARRIVAL, status, departure, NAN, NAN, arrival, departure});
    return 0;
}

/* The first index that is not before the departure. */
static size_t place_of(const examiner *x, double departure)
{
    size_t low = 0, high = x->seen_count;
    while (low < high) {
        size_t middle = low + (high - low) / 2;
        if (x->seen[middle].departure < departure)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

static int keep(examiner *x, size_t place, const seen *s)
{
    void *block = x->seen;
    tdsp_status status = memory_reserve(&x->allocator, &block, &x->seen_capacity, x->seen_count + 1, sizeof *x->seen);
    x->seen = block;
    if (status != TDSP_OK) {
        x->failed = 1;
        return 0;
    }
    memmove(x->seen + place + 1, x->seen + place, (x->seen_count - place) * sizeof *x->seen);
    x->seen[place] = *s;
    x->seen_count++;
    if (s->status == TDSP_OK) x->out->last_departure = math_max(x->out->last_departure, s->departure);
    return 1;
}

int forward_see(examiner *x, double departure, seen *out)
{
    if (!is_departure(departure) || x->failed) return 0;
    size_t place = place_of(x, departure);
    if (place < x->seen_count && x->seen[place].departure == departure) {
        *out = x->seen[place];
        return 1;
    }
    if (!ask(x, departure, out)) return 0;
    if (out->status == TDSP_OK) out->has_path = path_examine(x, departure, out->arrival, &out->path);
    return keep(x, place, out);
}

size_t forward_first_without_way(const examiner *x)
{
    size_t i = 0;
    while (i < x->seen_count && x->seen[i].status == TDSP_OK)
        i++;
    return i;
}

int forward_first(const examiner *x, seen *out)
{
    if (x->seen_count == 0 || x->seen[0].departure != 0) return 0;
    *out = x->seen[0];
    return 1;
}

/* ------------------------------------------------------------------------------------------------------ where to ask */

static double unit_of(const examiner *x)
{
    seen first;
    double travel = forward_first(x, &first) && first.status == TDSP_OK ? first.arrival : 0;
    double unit = math_max(travel, x->oracle.time_scale);
    return unit > 0 ? unit : 1;
}

/* A departure without a way, or the last that is looked at. */
static double expand(examiner *x)
{
    seen s;
    double horizon = x->options->horizon;
    if (isfinite(horizon)) {
        (void)forward_see(x, horizon, &s);
        return horizon;
    }
    double t = unit_of(x);
    for (int i = 0; i < DOUBLINGS; i++, t *= 2)
        if (!forward_see(x, t, &s) || s.status != TDSP_OK) return t;
    (void)forward_see(x, t, &s);
    return t;
}

/* The last departure with a way, to the noise. */
static double close_end(examiner *x)
{
    size_t without = forward_first_without_way(x);
    if (without == 0 || without == x->seen_count) return x->seen_count ? x->seen[x->seen_count - 1].departure : 0;
    seen low = x->seen[without - 1], high = x->seen[without], s;
    for (int i = 0; i < HALVINGS; i++) {
        double middle = low.departure + (high.departure - low.departure) / 2;
        int near = high.departure - low.departure <= examiner_noise(x, low.departure, low.arrival);
        if (near || middle <= low.departure || middle >= high.departure || !forward_see(x, middle, &s)) break;
        *(s.status == TDSP_OK ? &low : &high) = s;
    }
    return low.departure;
}

static void spread(examiner *x, double from, double to, uint32_t count)
{
    seen s;
    if (!(to > from)) return;
    for (uint32_t i = 0; i < count && !x->failed; i++)
        (void)forward_see(x, from + (to - from) * ((i + examiner_unit(x)) / count), &s);
}

/* The same in equal stretches of the logarithm, where the domain is long beside the journeys. */
static void spread_widely(examiner *x, double unit, double end, uint32_t count)
{
    seen s;
    for (uint32_t i = 0; i < count && !x->failed; i++)
        (void)forward_see(x, math_min(unit * math_exp(math_log(end / unit) * ((i + examiner_unit(x)) / count)), end), &s);
}

/* Of the travel time, which shows a jump of the arrival among arrivals that rise anyway. */
static double rise_of(const seen *low, const seen *high)
{
    return (high->arrival - low->arrival) - (high->departure - low->departure);
}

static double comparable(const examiner *x, const seen *low, const seen *high)
{
    return examiner_noise(x, low->departure, low->arrival) + examiner_noise(x, high->departure, high->arrival);
}

int forward_jumps(const examiner *x, size_t i)
{
    const seen *low = &x->seen[i], *high = &x->seen[i + 1];
    if (low->status != TDSP_OK || high->status != TDSP_OK) return 0;
    int is_near = high->departure - low->departure <= examiner_blur(x, low->arrival);
    return is_near && rise_of(low, high) > 4 * comparable(x, low, high);
}

/* The neighbours with the steepest rise that are not at a jump already; seen_count when nothing rises. */
static size_t steepest(const examiner *x)
{
    size_t found = x->seen_count;
    double most = 0;
    for (size_t i = 1; i < x->seen_count; i++) {
        const seen *low = &x->seen[i - 1], *high = &x->seen[i];
        if (low->status != TDSP_OK || high->status != TDSP_OK) continue;
        if (high->departure - low->departure <= examiner_blur(x, low->arrival)) continue;
        double rise = rise_of(low, high);
        if (rise <= math_max(most, 4 * comparable(x, low, high))) continue;
        most = rise;
        found = i - 1;
    }
    return found;
}

static void close_jump(examiner *x, seen low, seen high)
{
    seen s;
    double rise = rise_of(&low, &high);
    for (int i = 0; i < HALVINGS; i++) {
        double middle = low.departure + (high.departure - low.departure) / 2;
        if (middle <= low.departure || middle >= high.departure || !forward_see(x, middle, &s) || s.status != TDSP_OK) return;
        *(rise_of(&low, &s) > rise_of(&s, &high) ? &high : &low) = s;
        int is_near = high.departure - low.departure <= comparable(x, &low, &high);
        if (is_near || rise_of(&low, &high) < JUMP_SHARE * rise) return;
    }
}

static void look_for_jumps(examiner *x)
{
    for (int i = 0; i < JUMPS && !x->failed; i++) {
        size_t at = steepest(x);
        if (at < x->seen_count) close_jump(x, x->seen[at], x->seen[at + 1]);
    }
}

/* ------------------------------------------------------------------------------------------------------------ judging */

/* Once more about a departure; the path twice now and then, for it is that of the last answer until the next question. */
static void ask_once_more(examiner *x, const seen *first, int twice)
{
    seen second;
    if (!ask(x, first->departure, &second)) return;
    examiner_look(x, TDSP_RULE_REPEATABLE);
    if (first->status != second.status || !examiner_same(first->arrival, second.arrival)) {
        examiner_note(x, &(tdsp_oracle_finding){TDSP_RULE_REPEATABLE, TDSP_ORACLE_EARLIEST_ARRIVAL, second.status, first->departure, NAN, NAN,
                                                second.arrival, first->arrival});
        return;
    }
    for (int i = 0; i <= twice && first->has_path; i++)
        path_examine_again(x, first->departure, first->path);
}

/* In another order than the first time. */
static void ask_again(examiner *x)
{
    for (uint32_t i = 0; i < x->options->departures && x->seen_count > 0; i++) {
        const seen first = x->seen[examiner_below(x, x->seen_count)];
        ask_once_more(x, &first, i % 4 == 0);
    }
}

static double value_of(const examiner *x, const seen *s)
{
    return x->oracle.monotone == TDSP_MONOTONE_ARRIVAL ? s->arrival : s->arrival - s->departure;
}

/* A jump may be seen on the wrong side by both departures, of which one at least has a way. */
static int is_blurred(const examiner *x, const seen *earlier, const seen *later)
{
    return later->departure - earlier->departure <= 2 * examiner_blur(x, math_min(earlier->arrival, later->arrival));
}

/* So near to the end that it may be over already: the answer then is one to no question. */
static int is_at_end(const examiner *x, const seen *s, size_t without)
{
    return without < x->seen_count && is_blurred(x, s, &x->seen[without]);
}

static double certified_value(const examiner *x, const seen *s)
{
    return value_of(x, s) - examiner_noise(x, s->departure, s->arrival);
}

static void judge_pair(examiner *x, const seen *earlier, const seen *later)
{
    tdsp_oracle_finding wrong = {TDSP_RULE_ORDER, TDSP_ORACLE_EARLIEST_ARRIVAL, TDSP_OK, later->departure, NAN, earlier->departure,
                                 value_of(x, later), value_of(x, earlier)};
    double most = value_of(x, later) + examiner_noise(x, later->departure, later->arrival);
    if (most < certified_value(x, earlier) && !is_blurred(x, earlier, later)) examiner_note(x, &wrong);
}

/* Against the departure before that certifies most. */
static void judge_order(examiner *x)
{
    const seen *best = NULL;
    size_t without = forward_first_without_way(x);
    examiner_look(x, TDSP_RULE_ORDER);
    for (size_t i = 0; i < x->seen_count; i++) {
        const seen *s = &x->seen[i];
        if (s->status != TDSP_OK || is_at_end(x, s, without)) continue;
        if (best) judge_pair(x, best, s);
        if (!best || certified_value(x, s) > certified_value(x, best)) best = s;
    }
}

static void judge_no_way(examiner *x)
{
    size_t without = forward_first_without_way(x);
    if (without < x->seen_count) examiner_look(x, TDSP_RULE_NO_WAY);
    for (size_t i = without; i < x->seen_count; i++) {
        const seen *none = &x->seen[without], *s = &x->seen[i];
        if (s->status != TDSP_OK || is_blurred(x, none, s)) continue;
        examiner_note(x, &(tdsp_oracle_finding){TDSP_RULE_NO_WAY, TDSP_ORACLE_EARLIEST_ARRIVAL, TDSP_OK, s->departure, NAN, none->departure,
                                                s->arrival, INFINITY});
    }
}

void forward_examine(examiner *x)
{
    seen s;
    uint32_t count = x->options->departures;
    (void)forward_see(x, 0, &s);
    double high = expand(x);
    double end = close_end(x);
    double beyond = math_min(x->options->horizon, 2 * high);
    double unit = unit_of(x) * NEAR;
    uint32_t widely = end > LONG * unit ? count / 2 : 0;
    spread(x, 0, end, count - count / BEYOND - widely);
    spread(x, end, beyond, count / BEYOND);
    spread_widely(x, unit, end, widely);
    look_for_jumps(x);
    ask_again(x);
    judge_order(x);
    judge_no_way(x);
}
