/* SPDX-License-Identifier: MIT */
/* Checked oracle calls; the error model is in probe.h. */
#include "build/probe.h"

#include "base/math.h"

#define ROUNDING 0x1p-50  /* eight half units in the last place of A */
#define COMPARING 0x1p-49 /* what comparing bounds and a reader's outward rounding may cost */
#define BLUR 16.0         /* noises */

probe probe_over(const tdsp_oracle *oracle, const tdsp_allocator *allocator, int by_arrival)
{
    return (probe){
        .oracle = oracle, .allocator = *allocator, .by_arrival = by_arrival, .all = INFINITY, .path = kept_path_none()};
}

void probe_release(probe *p)
{
    kept_path_release(&p->path, &p->allocator);
}

static double noise(const tdsp_oracle *oracle, double travel, double arrival)
{
    return oracle->error / (1 - oracle->error) * (travel + oracle->time_scale) + ROUNDING * arrival;
}

static sample sample_without_way(double departure, tdsp_status why)
{
    return (sample){departure, INFINITY, INFINITY, INFINITY, INFINITY, INFINITY, why};
}

/* There is a path that arrives at `arrival`, and none that arrives before `earliest`: equal where the answer is exact. */
static sample sample_of(const probe *p, double departure, double earliest, double arrival)
{
    double travel = arrival - departure;
    double value = p->by_arrival ? arrival : travel;
    double least = p->by_arrival ? departure : 0;
    double e = travel > 0 ? noise(p->oracle, travel, arrival) : 0;
    double upper = value + e;
    double ceiling = travel > 0 ? upper + COMPARING * arrival : upper;
    double lower = p->by_arrival ? earliest : earliest - departure;
    return (sample){departure, value, math_max(lower - e, least), upper, ceiling, value, TDSP_OK};
}

int probe_means_no_way(tdsp_status status)
{
    return status == TDSP_SOURCE_COVERED || status == TDSP_DESTINATION_COVERED || status == TDSP_CUT_OFF ||
           status == TDSP_UNREACHABLE;
}

/* What an oracle may hand on as it is: its errors. Any other answer is not one to this question. */
static tdsp_status error_of(tdsp_status status)
{
    return tdsp_status_is_answer(status) ? TDSP_BAD_ORACLE : status;
}

tdsp_status probe_report_progress(probe *p)
{
    if (p->progress && !p->is_cancelled) p->is_cancelled = p->progress(p->progress_ctx, p->settled, p->all) != 0;
    return p->is_cancelled ? TDSP_CANCELLED : TDSP_OK;
}

/* The answer as the oracle gave it. */
static tdsp_status take_answer(const probe *p, tdsp_status answer, double departure, double earliest, double arrival, sample *out)
{
    if (probe_means_no_way(answer)) {
        *out = sample_without_way(departure, answer);
        return TDSP_OK;
    }
    if (answer != TDSP_OK) return error_of(answer);
    if (!(arrival >= earliest) || !(earliest >= departure) || !isfinite(arrival)) return TDSP_BAD_ORACLE;
    *out = sample_of(p, departure, earliest, arrival);
    return TDSP_OK;
}

tdsp_status probe_forward(probe *p, double departure, sample *out)
{
    tdsp_status status = probe_report_progress(p);
    if (status != TDSP_OK) return status;
    double arrival = NAN;
    p->forward_calls++;
    status = p->oracle->earliest_arrival(p->oracle->ctx, departure, &arrival);
    return take_answer(p, status, departure, arrival, arrival, out);
}

tdsp_status probe_roughly(probe *p, double departure, sample *out)
{
    if (!(p->delta > 0)) return probe_forward(p, departure, out);
    tdsp_status status = probe_report_progress(p);
    if (status != TDSP_OK) return status;
    double arrival = NAN, earliest = NAN;
    p->forward_calls++;
    status = p->oracle->earliest_arrival_within(p->oracle->ctx, departure, p->delta, &arrival, &earliest);
    if (status == TDSP_OK && earliest < arrival) p->rough_calls++;
    return take_answer(p, status, departure, earliest, arrival, out);
}

double probe_arrival(const probe *p, const sample *s)
{
    return p->by_arrival ? s->value : s->departure + s->value;
}

double probe_blur(const probe *p, const sample *s)
{
    if (!isfinite(s->value)) return BLUR * noise(p->oracle, s->departure, s->departure);
    double arrival = probe_arrival(p, s);
    return BLUR * noise(p->oracle, arrival, arrival);
}

double probe_margin(const probe *p, double arrival)
{
    return noise(p->oracle, arrival, arrival) + COMPARING * arrival;
}

static sample at(const sample *numbers, double departure)
{
    sample s = *numbers;
    s.departure = departure;
    return s;
}

tdsp_status probe_order(const probe *p, const sample *low, const sample *high, sample *s)
{
    if (s->upper < low->lower) {
        if (s->departure - low->departure > probe_blur(p, low)) return TDSP_BAD_ORACLE;
        *s = at(low, s->departure);
    } else if (s->lower > high->upper) {
        if (high->departure - s->departure > probe_blur(p, high) && s->departure - low->departure > probe_blur(p, low)) return TDSP_BAD_ORACLE;
        *s = at(high, s->departure);
    }
    return TDSP_OK;
}

tdsp_status probe_reverse(probe *p, double arrival, double *departure)
{
    tdsp_status status = probe_report_progress(p);
    if (status != TDSP_OK) return status;
    double t = NAN;
    p->reverse_calls++;
    status = p->oracle->latest_departure(p->oracle->ctx, arrival, &t);
    if (status == TDSP_ARRIVAL_TOO_EARLY)
        t = 0;
    else if (status != TDSP_OK)
        return error_of(status);
    if (!(t >= 0) || (isinf(t) && isfinite(arrival))) return TDSP_BAD_ORACLE;
    *departure = t;
    return TDSP_OK;
}

/* What the samples say of the question, where the oracle asks for it. */
static int is_between(const probe *p, double arrival, const sample *low, const sample *high)
{
    return p->oracle->latest_departure_between && probe_arrival(p, low) <= arrival && arrival < probe_arrival(p, high);
}

static tdsp_status ask_between(probe *p, double arrival, double low, double high, sample *out, int *known)
{
    tdsp_status status = probe_report_progress(p);
    if (status != TDSP_OK) return status;
    double t = NAN, arrives = NAN;
    p->reverse_calls++;
    status = p->oracle->latest_departure_between(p->oracle->ctx, arrival, low, high, &t, &arrives);
    if (status != TDSP_OK) return error_of(status);
    if (!(t >= low && t <= high)) return TDSP_BAD_ORACLE;
    out->departure = t;
    *known = t > low && t < high;
    return *known ? take_answer(p, TDSP_OK, t, arrives, arrives, out) : TDSP_OK;
}

tdsp_status probe_reverse_between(probe *p, double arrival, const sample *low, const sample *high, sample *out, int *known)
{
    *known = 0;
    if (!is_between(p, arrival, low, high)) return probe_reverse(p, arrival, &out->departure);
    return ask_between(p, arrival, low->departure, high->departure, out, known);
}

tdsp_status probe_reverse_last(probe *p, sample *out, int *known)
{
    *known = 0;
    if (!p->oracle->latest_departure_between) return probe_reverse(p, INFINITY, &out->departure);
    return ask_between(p, INFINITY, 0, INFINITY, out, known);
}

tdsp_status probe_keep_path(probe *p, const sample *s)
{
    p->path.departure = -1;
    tdsp_oracle_path lent = {NULL, 0, NULL, 0};
    if (p->oracle->path) {
        tdsp_status status = p->oracle->path(p->oracle->ctx, &lent);
        if (status != TDSP_OK) return error_of(status);
    }
    return kept_path_copy(&p->path, &p->allocator, &lent, s->departure);
}

double probe_travel_upper(const probe *p, const sample *s)
{
    return p->by_arrival ? math_max(s->upper - s->departure, 0) : s->upper;
}
