/*
 * Finding t_last = sup { t : A(t) < infinity }.
 *
 * Where there is no way for t there is none for any later t, so t_last is found like a jump: some departure with an answer, some
 * without, and halving down to neighbouring doubles, seeded by latest_departure(infinity) where the oracle has it. The forward function has
 * the last word: the last row has a path.
 *
 * Without latest_departure and without a horizon a departure without an answer is looked for at unit * 2^1, 2^2, 2^4, 2^8, ..., where the
 * unit is the larger of T(0) and the oracle's time scale (1 where both are 0). It is given up, TDSP_NEEDS_HORIZON, once the travel time drowns
 * in the rounding of the departure, t 2^-52 >= T(t) + time_scale and >= unit, and at unit * 2^256 at the latest.
 */
#include "build/domain.h"

#include <float.h>
#include <math.h>

#include "base/round.h"
#include "build/invert.h"
#include "scene/allocator.h"

#define LAST_EXPONENT 256
#define LATEST 0x1p500 /* later departures are not worth overflowing an oracle's squares for */

static tdsp_status keep_low(domain *d, probe *p, const sample *s)
{
    int falls = s->upper < d->last.lower && s->departure - d->last.departure > probe_blur(p, &d->last);
    if (falls) return TDSP_BAD_ORACLE;
    d->last = *s;
    return probe_keep_path(p, s);
}

/* Upwards from a departure with an answer that should be the last, until one has none. The steps grow from the next double on. */
static tdsp_status climb(domain *d, probe *p, sample *high)
{
    double reach = 0;
    double start = d->last.departure;
    do {
        sample s;
        tdsp_status status = probe_forward(p, fmax(start + reach, round_next_up(d->last.departure)), &s);
        if (status != TDSP_OK) return status;
        if (s.status != TDSP_OK) {
            *high = s;
            return TDSP_OK;
        }
        status = keep_low(d, p, &s);
        if (status != TDSP_OK) return status;
        reach = fmax(reach * 16, probe_blur(p, &s) / 4096);
    } while (d->last.departure < LATEST);
    return TDSP_BAD_ORACLE;
}

static int drowned(const probe *p, const sample *s, double unit)
{
    double travel = p->by_arrival ? s->value - s->departure : s->value;
    return s->departure * 0x1p-52 >= fmax(travel + p->oracle->time_scale, unit);
}

/* From 0 upwards in powers of 2 whose exponents double. */
static tdsp_status expand(domain *d, probe *p, sample *high)
{
    double travel = d->first.value; /* at departure 0 both values are the travel time */
    double unit = fmax(travel, p->oracle->time_scale);
    if (unit == 0) unit = 1;
    for (int exponent = 1; exponent <= LAST_EXPONENT; exponent *= 2) {
        sample s;
        double departure = fmin(ldexp(unit, exponent), LATEST);
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

/* latest_departure(infinity), or NaN. */
static tdsp_status ask_last(probe *p, double *seed)
{
    *seed = NAN;
    return p->oracle->latest_departure ? probe_reverse(p, INFINITY, seed) : TDSP_OK;
}

/* Some departure without an answer, where no horizon is given. d->last becomes the latest one seen with an answer. */
static tdsp_status find_end_beyond(domain *d, probe *p, double *seed, sample *high)
{
    tdsp_status status = ask_last(p, seed);
    if (status != TDSP_OK) return status;
    if (isnan(*seed)) return expand(d, p, high);
    if (isinf(*seed)) return TDSP_NEEDS_HORIZON;
    sample s;
    status = probe_forward(p, *seed, &s);
    if (status != TDSP_OK) return status;
    *high = s;
    if (s.status != TDSP_OK) return TDSP_OK;
    status = keep_low(d, p, &s);
    return status == TDSP_OK ? climb(d, p, high) : status;
}

/* The last departure with an answer, between d->last, which has one, and high, which has none. */
static tdsp_status close_end(domain *d, probe *p, double seed, sample *high)
{
    bracket b = {d->last, *high};
    trail t = trail_begin(&b.low, &b.high);
    int inside = seed >= b.low.departure && seed <= b.high.departure;
    inversion goal = {.cap = DBL_MAX, .room = DBL_MAX, .anchor = -INFINITY, .seed = inside ? seed : NAN, .reversals = 0};
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

/* Departures end by themselves. `high` has no answer; NULL: it is still to be found. */
static tdsp_status end_by_oracle(domain *d, probe *p, const sample *known)
{
    sample high;
    double seed;
    tdsp_status status;
    if (known) {
        high = *known;
        status = ask_last(p, &seed);
    } else status = find_end_beyond(d, p, &seed, &high);
    if (status == TDSP_OK) status = close_end(d, p, seed, &high);
    if (status != TDSP_OK) return status;
    kept_path_swap(&d->last_path, &p->path);
    return find_reason(d, p, &high);
}

/* The horizon ends departures where there is an answer right after it too; if it jumps exactly there, the jump is kept. */
static tdsp_status end_at_horizon(domain *d, probe *p)
{
    kept_path_swap(&d->last_path, &p->path);
    double next = round_next_up(d->last.departure);
    sample after;
    tdsp_status status = isfinite(next) ? probe_forward(p, next, &after) : TDSP_OK;
    if (status != TDSP_OK) return status;
    if (isfinite(next) && after.status != TDSP_OK) return find_reason(d, p, &after);
    d->right = isfinite(next) ? fmax(after.lower, d->last.lower) : d->last.lower;
    d->reason = TDSP_HORIZON;
    return TDSP_OK;
}

static tdsp_status find_end(domain *d, probe *p, double horizon)
{
    if (isinf(horizon)) return end_by_oracle(d, p, NULL);
    sample s;
    tdsp_status status = probe_forward(p, horizon, &s);
    if (status != TDSP_OK) return status;
    if (s.status != TDSP_OK) return end_by_oracle(d, p, &s);
    status = keep_low(d, p, &s);
    return status == TDSP_OK ? end_at_horizon(d, p) : status;
}

tdsp_status domain_find(domain *d, probe *p, double horizon)
{
    *d = (domain){.first_path = kept_path_none(), .last_path = kept_path_none()};
    tdsp_status status = probe_forward(p, 0, &d->first);
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
