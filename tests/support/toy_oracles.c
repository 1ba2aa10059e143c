/* SPDX-License-Identifier: MIT */
/* Oracles in closed form. The inverse solves each piece's parabola in long double, from the last piece backwards. */
#include "support/toy_oracles.h"

#include <math.h>
#include <string.h>

toy toy_over(const toy_piece *pieces, size_t count, int by_arrival)
{
    return (toy){.pieces = pieces, .count = count, .by_arrival = by_arrival, .reason = TDSP_CUT_OFF};
}

static double piece_from(const toy *t, size_t i)
{
    return i == 0 ? 0 : t->pieces[i - 1].until;
}

static long double piece_value(const toy *t, size_t i, long double departure)
{
    const toy_piece *p = &t->pieces[i];
    long double u = departure - (long double)piece_from(t, i);
    return p->c0 + u * (p->c1 + u * (long double)p->c2);
}

long double toy_value(const toy *t, double departure)
{
    for (size_t i = 0; i < t->count; i++)
        if (departure <= t->pieces[i].until) return piece_value(t, i, departure);
    return INFINITY;
}

long double toy_value_after(const toy *t, double departure)
{
    for (size_t i = 0; i < t->count; i++)
        if (departure < t->pieces[i].until) return piece_value(t, i, departure);
    return INFINITY;
}

long double toy_arrival(const toy *t, double departure)
{
    return toy_value(t, departure) + (t->by_arrival ? 0 : (long double)departure);
}

double toy_last(const toy *t)
{
    return t->pieces[t->count - 1].until;
}

/* The last departure of piece i at which value + share * t <= cap, knowing that its beginning is. */
static long double piece_inverse(const toy *t, size_t i, long double cap, int share)
{
    const toy_piece *p = &t->pieces[i];
    long double from = piece_from(t, i);
    long double rest = cap - p->c0 - (share ? from : 0);
    long double b = p->c1 + (share ? 1 : 0);
    long double a = p->c2;
    long double u = INFINITY;
    if (a == 0 && b > 0)
        u = rest / b;
    else if (a != 0) {
        /* Increasing over the piece, whichever way it bends: the root with b + 2 a u >= 0. */
        long double d = b * b + 4 * a * rest;
        if (d >= 0) u = 2 * rest / (b + sqrtl(d));
    }
    return fminl(from + u, p->until);
}

static double inverse(const toy *t, long double cap, int share)
{
    for (size_t i = t->count; i-- > 0;) {
        long double from = piece_from(t, i);
        if (t->pieces[i].c0 + (share ? from : 0) > cap) continue;
        return (double)piece_inverse(t, i, cap, share);
    }
    return -1;
}

double toy_inverse(const toy *t, long double cap)
{
    return inverse(t, cap, 0);
}

static size_t piece_of(const toy *t, double departure)
{
    size_t i = 0;
    while (i < t->count && departure > t->pieces[i].until) i++;
    return i;
}

/* A number in [-1, 1] that only the departure decides. */
static double wobble(double departure)
{
    uint64_t x;
    memcpy(&x, &departure, sizeof x);
    x ^= x >> 33;
    x *= 0xff51afd7ed558ccdu;
    x ^= x >> 33;
    x *= 0xc4ceb9fe1a85ec53u;
    x ^= x >> 33;
    return (double)(x >> 11) * 0x1p-52 - 1;
}

static double computed_arrival(const toy *t, double departure)
{
    double seen = departure > t->blur ? departure - t->blur : 0;
    double value = (double)toy_value(t, piece_of(t, seen) < piece_of(t, departure) ? seen : departure);
    if (isinf(value)) return value;
    double travel = t->by_arrival ? value - departure : value;
    double noise = wobble(departure) * t->error * (travel + t->time_scale);
    return fmax((t->by_arrival ? value : departure + value) + noise, departure);
}

static tdsp_status faulty(const toy *t, double departure, double *arrival)
{
    switch (t->fault) {
    case TOY_FALLS: *arrival = departure + 0.9 * (*arrival - departure); return TDSP_OK;
    case TOY_NAN: *arrival = NAN; return TDSP_OK;
    case TOY_INFINITE: *arrival = INFINITY; return TDSP_OK;
    case TOY_EARLY: *arrival = departure - 1e-6; return TDSP_OK;
    case TOY_NEGATIVE: *arrival = -1; return TDSP_OK;
    case TOY_ODD_ANSWER: return TDSP_ARRIVAL_TOO_EARLY;
    case TOY_ERROR: return TDSP_FAILED;
    default: return TDSP_OK;
    }
}

/* Faults of the forward function that do not need a way. */
static int is_forward(toy_fault fault)
{
    return fault >= TOY_NAN && fault <= TOY_ERROR;
}

static tdsp_status forward(void *ctx, double departure, double *arrival)
{
    toy *t = ctx;
    t->forward_calls++;
    t->asked = departure;
    int due = t->fault == TOY_FALLS ? t->forward_calls >= t->fault_at : t->forward_calls == t->fault_at;
    double computed = computed_arrival(t, departure);
    int no_way = isinf(computed);
    *arrival = no_way ? departure + 1 : computed;
    tdsp_status status = due ? faulty(t, departure, arrival) : TDSP_OK;
    t->arrival = *arrival;
    return no_way && !(due && is_forward(t->fault)) ? t->reason : status;
}

static tdsp_status reverse(void *ctx, double arrival, double *departure)
{
    toy *t = ctx;
    t->reverse_calls++;
    int due = t->reverse_calls == t->fault_at;
    if (due && t->fault == TOY_REVERSE_ODD) return TDSP_CUT_OFF;
    if (due && t->fault == TOY_REVERSE_ERROR) return TDSP_FAILED;
    double found = isinf(arrival) ? toy_last(t) : inverse(t, arrival, !t->by_arrival);
    if (found < 0) return TDSP_ARRIVAL_TOO_EARLY;
    *departure = due && t->fault == TOY_REVERSE_NAN ? NAN : found;
    int lies = t->lie != 0 && t->reverse_calls >= t->lie_from && (t->lie_to == 0 || t->reverse_calls < t->lie_to);
    if (lies && isfinite(arrival)) *departure = fmax(found + t->lie, 0);
    return TDSP_OK;
}

/* The whole of delta lies between the two, with the truth anywhere between them. */
static tdsp_status within(void *ctx, double departure, double delta, double *arrival, double *lower)
{
    toy *t = ctx;
    tdsp_status status = forward(ctx, departure, arrival);
    if (status != TDSP_OK) return status;
    double share = (wobble(departure + 1) + 1) / 2;
    *lower = departure + (*arrival - departure) / (1 + share * delta);
    *arrival = departure + (*lower - departure) * (1 + delta);
    t->arrival = *arrival;
    t->rough_calls += *lower < *arrival;
    int due = t->forward_calls == t->fault_at;
    if (due && t->fault == TOY_CROSSED) *lower = *arrival + 1;
    if (due && t->fault == TOY_BEFORE_LOWER) *lower = departure - 1;
    return TDSP_OK;
}

static tdsp_status between(void *ctx, double arrival, double after, double before, double *departure, double *arrives)
{
    toy *t = ctx;
    tdsp_status status = reverse(ctx, arrival, departure);
    if (status != TDSP_OK) return status;
    *departure = fmin(fmax(*departure, after), before);
    t->asked = *departure;
    t->arrival = *arrives = computed_arrival(t, *departure);
    if (t->fault == TOY_NOT_BETWEEN && t->reverse_calls == t->fault_at) *departure = after - 1;
    return TDSP_OK;
}

static tdsp_status path(void *ctx, tdsp_oracle_path *out)
{
    toy *t = ctx;
    t->paths++;
    if (t->fault == TOY_PATH_ERROR && t->paths == t->fault_at) return TDSP_NO_ANSWER;
    memcpy(t->bytes, &t->asked, sizeof t->bytes);
    t->leg =
        (tdsp_leg){.kind = TDSP_LEG_LINE, .disc = TDSP_NO_DISC, .start_time = t->asked, .end_time = t->arrival, .to = {1, 0}};
    *out = t->legs ? (tdsp_oracle_path){&t->leg, 1, NULL, 0} : (tdsp_oracle_path){NULL, 0, t->bytes, sizeof t->bytes};
    if (t->fault == TOY_PATH_NULL && t->paths == t->fault_at) *out = (tdsp_oracle_path){NULL, 1, NULL, 0};
    return TDSP_OK;
}

tdsp_oracle toy_oracle(toy *t, int forward_only)
{
    tdsp_oracle oracle;
    tdsp_oracle_init(&oracle);
    oracle.ctx = t;
    oracle.monotone = t->by_arrival ? TDSP_MONOTONE_ARRIVAL : TDSP_MONOTONE_TRAVEL;
    oracle.error = t->error;
    oracle.time_scale = t->time_scale;
    oracle.earliest_arrival = forward;
    oracle.latest_departure = forward_only ? NULL : reverse;
    oracle.path = path;
    oracle.earliest_arrival_within = t->rough ? within : NULL;
    oracle.latest_departure_between = t->rough && !forward_only ? between : NULL;
    return oracle;
}
