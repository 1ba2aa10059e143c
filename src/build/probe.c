/* Checked oracle calls; the error model is in probe.h. */
#include "build/probe.h"

#include <math.h>

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

static sample sample_of(const probe *p, double departure, double arrival)
{
    double travel = arrival - departure;
    double value = p->by_arrival ? arrival : travel;
    double least = p->by_arrival ? departure : 0;
    double e = travel > 0 ? noise(p->oracle, travel, arrival) : 0;
    double upper = value + e;
    double ceiling = travel > 0 ? upper + COMPARING * arrival : upper;
    return (sample){departure, value, fmax(value - e, least), upper, ceiling, value, TDSP_OK};
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

tdsp_status probe_report_progress(const probe *p)
{
    return p->progress && p->progress(p->progress_ctx, p->settled, p->all) != 0 ? TDSP_CANCELLED : TDSP_OK;
}

tdsp_status probe_forward(probe *p, double departure, sample *out)
{
    tdsp_status status = probe_report_progress(p);
    if (status != TDSP_OK) return status;
    double arrival = NAN;
    p->forward_calls++;
    status = p->oracle->earliest_arrival(p->oracle->ctx, departure, &arrival);
    if (probe_means_no_way(status)) {
        *out = sample_without_way(departure, status);
        return TDSP_OK;
    }
    if (status != TDSP_OK) return error_of(status);
    if (!(arrival >= departure) || !isfinite(arrival)) return TDSP_BAD_ORACLE;
    *out = sample_of(p, departure, arrival);
    return TDSP_OK;
}

double probe_blur(const probe *p, const sample *s)
{
    if (!isfinite(s->value)) return BLUR * noise(p->oracle, s->departure, s->departure);
    double arrival = p->by_arrival ? s->value : s->departure + s->value;
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

tdsp_status probe_between(probe *p, const sample *low, const sample *high, double departure, sample *out)
{
    sample s;
    tdsp_status status = probe_forward(p, departure, &s);
    if (status != TDSP_OK) return status;
    if (s.upper < low->lower) {
        if (departure - low->departure > probe_blur(p, low)) return TDSP_BAD_ORACLE;
        s = at(low, departure);
    } else if (s.lower > high->upper) {
        if (high->departure - departure > probe_blur(p, high)) return TDSP_BAD_ORACLE;
        s = at(high, departure);
    }
    *out = s;
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
    return p->by_arrival ? fmax(s->upper - s->departure, 0) : s->upper;
}

double probe_travel_lower(const probe *p, const sample *s)
{
    return p->by_arrival ? fmax(s->lower - s->departure, 0) : s->lower;
}
