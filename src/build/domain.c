/* SPDX-License-Identifier: MIT */
/*
 * Finding t_last = sup { t : A(t) < infinity }.
 *
 * Where there is no way for t there is none for any later t. latest_departure(infinity) is the end where the oracle has it, if there is an
 * answer there and none a little later, by all that the stated error could mean. Else t_last is found like a jump: some departure with an
 * answer, some without, and halving down to error * (T + time_scale), or neighbouring doubles where no error is stated. The forward
 * function has the last word: the last row has a path.
 *
 * Without latest_departure and without a horizon a departure without an answer is looked for at unit * 2^1, 2^2, 2^4, 2^8, ..., where the
 * unit is the larger of T(0) and the oracle's time scale (1 where both are 0). It is given up, TDSP_NEEDS_HORIZON, once the travel time drowns
 * in the rounding of the departure, t 2^-52 >= T(t) + time_scale and >= unit, and at unit * 2^256 at the latest.
 */
#include "build/domain.h"

#include <float.h>

#include "base/math.h"
#include "base/round.h"
#include "build/invert.h"
#include "scene/allocator.h"

#define LAST_EXPONENT 256
#define GROWTH 16
#define LATEST 0x1p500 /* later departures are not worth overflowing an oracle's squares for */

static tdsp_status keep_low(domain *d, probe *p, const sample *s)
{
    int falls = s->upper < d->last.lower && s->departure - d->last.departure > probe_blur(p, &d->last);
    if (falls) return TDSP_BAD_ORACLE;
    d->last = *s;
    return probe_keep_path(p, s);
}

/* How near to the end is near enough: what the stated error leaves open. */
static double resolution(const probe *p, const sample *s)
{
    double travel = p->by_arrival ? s->value - s->departure : s->value;
    return p->oracle->error * (travel + p->oracle->time_scale);
}

static int drowned(const probe *p, const sample *s, double unit)
{
    double travel = p->by_arrival ? s->value - s->departure : s->value;
    return s->departure * 0x1p-52 >= math_max(travel + p->oracle->time_scale, unit);
}

/* From 0 upwards in powers of 2 whose exponents double. */
static tdsp_status expand(domain *d, probe *p, sample *high)
{
    double travel = d->first.value; /* at departure 0 both values are the travel time */
    double unit = math_max(travel, p->oracle->time_scale);
    if (unit == 0) unit = 1;
    for (int exponent = 1; exponent <= LAST_EXPONENT; exponent *= 2) {
        sample s;
        double departure = math_min(ldexp(unit, exponent), LATEST);
        tdsp_status status = probe_forward(p, departure, &s);
        if (status != TDSP_OK) return status;
        if (s.status != TDSP_OK) {
            *high = s;
            return TDSP_OK;
        }
        if (drowned(p, &s, unit)) return TDSP_NEEDS_HORIZON;
        status = keep_low(d, p, &s);
        if (status != TDSP_OK) return status;
    }
    return TDSP_NEEDS_HORIZON;
}

/* latest_departure(infinity), or NaN; with the answer there where it comes along. */
static tdsp_status ask_last(probe *p, sample *seed, int *known)
{
    seed->departure = NAN;
    *known = 0;
    return p->oracle->latest_departure ? probe_reverse_last(p, seed, known) : TDSP_OK;
}

/*
 * From a seed with an answer upwards, until a departure has none: that becomes high. The first step is over all that the oracle's error
 * could mean; when it has no answer, the seed is the end.
 */
static tdsp_status climb(domain *d, probe *p, sample *high)
{
    double start = d->last.departure;
    for (double reach = probe_blur(p, &d->last); start + reach < high->departure; reach *= GROWTH) {
        sample s;
        if (start + reach > LATEST) return TDSP_BAD_ORACLE;
        tdsp_status status = probe_forward(p, start + reach, &s);
        if (status != TDSP_OK) return status;
        if (s.status != TDSP_OK) {
            *high = s;
            return TDSP_OK;
        }
        status = keep_low(d, p, &s);
        if (status != TDSP_OK) return status;
    }
    return TDSP_OK;
}

/* What the seed says: an answer there is followed up, none makes it the new high. *settled when the seed is the end. */
static tdsp_status try_seed(domain *d, probe *p, const sample *found, int known, sample *high, int *settled)
{
    double seed = found->departure;
    *settled = 0;
    if (seed >= high->departure) return TDSP_OK;
    sample s = seed > 0 ? *found : d->first;
    if (seed > 0) {
        tdsp_status status = known ? TDSP_OK : probe_forward(p, seed, &s);
        if (status != TDSP_OK) return status;
        if (s.status == TDSP_OK) status = keep_low(d, p, &s);
        if (status != TDSP_OK) return status;
    }
    if (s.status != TDSP_OK) {
        *high = s;
        return TDSP_OK;
    }
    tdsp_status status = climb(d, p, high);
    *settled = d->last.departure == seed;
    return status;
}

/* The last departure with an answer, to the stated resolution, between d->last, which has one, and high, which has none. */
static tdsp_status close_end(domain *d, probe *p, double seed, sample *high)
{
    bracket b = {.low = d->last, .high = *high};
    trail t = trail_begin(&b.low, &b.high);
    inversion goal = {.cap = DBL_MAX, .room = DBL_MAX, .anchor = -INFINITY, .width = resolution(p, &b.low)};
    goal.seed = seed > b.low.departure ? seed : NAN;
    goal.asked = INFINITY;
    tdsp_status status = invert(p, &goal, &t, &b);
    if (status != TDSP_OK) return status;
    d->last = b.low;
    *high = b.high;
    return TDSP_OK;
}

static tdsp_status find_reason(domain *d, probe *p, const sample *high)
{
    const tdsp_oracle *oracle = p->oracle;
    d->right = INFINITY;
    d->reason = high->status;
    if (!oracle->last_reason) return TDSP_OK;
    tdsp_status status = oracle->last_reason(oracle->ctx, d->last.departure, &d->reason);
    if (status != TDSP_OK) return tdsp_status_is_answer(status) ? TDSP_BAD_ORACLE : status;
    return probe_means_no_way(d->reason) ? TDSP_OK : TDSP_BAD_ORACLE;
}

/* Some departure without an answer, and the end if the oracle knows it. high is where a search may stop: at the horizon, or nowhere. */
static tdsp_status bound_end(domain *d, probe *p, double *seed, sample *high, int *settled)
{
    int beyond = isinf(high->departure), known;
    sample found;
    *settled = 0;
    tdsp_status status = ask_last(p, &found, &known);
    *seed = found.departure;
    if (status != TDSP_OK) return status;
    if (isnan(*seed)) return beyond ? expand(d, p, high) : TDSP_OK;
    if (isinf(*seed)) return beyond ? TDSP_NEEDS_HORIZON : TDSP_BAD_ORACLE;
    return try_seed(d, p, &found, known, high, settled);
}

/* Departures end by themselves, before `high`, which has no answer. */
static tdsp_status end_by_oracle(domain *d, probe *p, sample high)
{
    double seed;
    int settled;
    tdsp_status status = bound_end(d, p, &seed, &high, &settled);
    if (status == TDSP_OK && !settled) status = close_end(d, p, seed, &high);
    if (status != TDSP_OK) return status;
    kept_path_swap(&d->last_path, &p->path);
    return find_reason(d, p, &high);
}

/* The horizon ends departures where there is an answer right after it too; if it jumps exactly there, the jump is kept. */
static tdsp_status end_at_horizon(domain *d, probe *p)
{
    kept_path_swap(&d->last_path, &p->path);
    double next = round_next_up(d->last.departure);
    sample after = d->last;
    tdsp_status status = isfinite(next) ? probe_roughly(p, next, &after) : TDSP_OK;
    if (status != TDSP_OK) return status;
    if (after.status != TDSP_OK) return find_reason(d, p, &after);
    d->right = math_max(after.lower, d->last.lower);
    d->reason = TDSP_HORIZON;
    return TDSP_OK;
}

static tdsp_status find_end(domain *d, probe *p, double horizon)
{
    sample s = {.departure = INFINITY, .status = TDSP_UNREACHABLE};
    if (isinf(horizon)) return end_by_oracle(d, p, s);
    tdsp_status status = probe_roughly(p, horizon, &s);
    if (status != TDSP_OK) return status;
    if (s.status != TDSP_OK) return end_by_oracle(d, p, s);
    status = keep_low(d, p, &s);
    return status == TDSP_OK ? end_at_horizon(d, p) : status;
}

tdsp_status domain_find(domain *d, probe *p, double horizon)
{
    *d = (domain){.first_path = kept_path_none(), .last_path = kept_path_none()};
    tdsp_status status = probe_roughly(p, 0, &d->first);
    if (status != TDSP_OK) return status;
    if (d->first.status != TDSP_OK) return d->first.status;
    status = keep_low(d, p, &d->first);
    if (status != TDSP_OK) return status;
    status = kept_path_again(&d->first_path, &p->allocator, &p->path);
    return status == TDSP_OK ? find_end(d, p, horizon) : status;
}

void domain_release(domain *d, const tdsp_allocator *allocator)
{
    kept_path_release(&d->first_path, allocator);
    kept_path_release(&d->last_path, allocator);
}
