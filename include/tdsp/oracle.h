/* SPDX-License-Identifier: MIT */
/*
 * The oracle: the seam between fixed-time shortest paths and the sampler. Fill in the struct to build tables over
 * any kind of world; the sampler knows nothing of discs.
 */
#ifndef TDSP_ORACLE_H
#define TDSP_ORACLE_H

#include "tdsp/status.h"
#include "tdsp/types.h"

#ifdef __cplusplus
extern "C" {
#endif

/** A path handed out by an oracle: legs, or bytes that only the oracle understands, or neither. */
typedef struct tdsp_oracle_path {
    const tdsp_leg *legs; /* owned by the oracle, valid until its next call */
    size_t leg_count;     /* 0: no legs */
    const void *bytes; /* owned by the oracle, valid until its next call */
    size_t byte_count; /* at most 2^31 - 1 */
} tdsp_oracle_path;

/**
 * An oracle. Initialise with tdsp_oracle_init(), then set members. Callbacks return an answer (status.h) or an error; an
 * error stops the caller and is handed on. They are called one at a time.
 */
typedef struct tdsp_oracle {
    size_t size; /* sizeof(tdsp_oracle), set by tdsp_oracle_init() */
    void *ctx;   /* handed to each callback */
    tdsp_monotone monotone; /* what it promises of A */
    double error; /* stated error, 0 to 0.1: |returned A(t) - true A(t)| <= error * (T(t) + time_scale); default 0. Eight half units
                     of rounding of A are allowed for besides. An arrival equal to its departure is taken as exact. Where A jumps, the side
                     may be mistaken for departures as near to the jump as ten times this (with A(t) for T(t)): by earliest_arrival, by
                     latest_departure in the place of the jump, and so by the interval of a table, which is certified elsewhere. */
    double time_scale; /* a time that is typical of the problem, e.g. |sd| / speed; not negative; default 0 */

    /* A(t) for t >= 0: TDSP_OK and *arrival, finite and not before the departure; or TDSP_SOURCE_COVERED, TDSP_DESTINATION_COVERED,
     * TDSP_CUT_OFF or TDSP_UNREACHABLE when there is no way (*arrival is then ignored). Where there is no way for t there is none for
     * any later t. Required. */
    tdsp_status (*earliest_arrival)(void *ctx, double departure, double *arrival);

    /* sup { t >= 0 : A(t) <= arrival }: TDSP_OK and *departure, TDSP_ARRIVAL_TOO_EARLY, or why there is no way. `arrival` may be
     * infinite: the last departure of all, infinite when there is none. NULL: the sampler inverts earliest_arrival. */
    tdsp_status (*latest_departure)(void *ctx, double arrival, double *departure);

    /* The path of the last answer with an arrival that returned TDSP_OK. NULL: rows carry no path. */
    tdsp_status (*path)(void *ctx, tdsp_oracle_path *out);

    /* Why departures end at `departure`, the last one that earliest_arrival answered: one of its four reasons. NULL: the reason
     * that earliest_arrival gives after it. */
    tdsp_status (*last_reason)(void *ctx, double departure, tdsp_status *reason);

    /* A path and how good the best can be: lower <= A(departure) <= arrival, both up to the stated error, and
     * arrival - departure <= (1 + delta) (lower - departure); statuses as earliest_arrival, and path() hands out this path. delta is from 0 to
     * 1. For tables (tdsp_build_options.oracle_share). NULL: every answer is exact. */
    tdsp_status (*earliest_arrival_within)(void *ctx, double departure, double delta, double *arrival, double *lower);

    /* latest_departure where it is known that A(after) <= arrival < A(before), with an infinite `before` for the last departure of all:
     * TDSP_OK, *departure from `after` up to `before`, and *arrives = A(*departure) with its path for path(), which are both not looked at
     * when the answer is `after` itself or infinite. For oracles that can make use of it, beside latest_departure; NULL: that is asked. */
    tdsp_status (*latest_departure_between)(void *ctx, double arrival, double after, double before, double *departure, double *arrives);

    /* What closes at a jump of a table's row, which keeps it: after `departure` the travel time jumps from `before` at most to `after` at least. TDSP_OK
     * and *out, with numbers that are finite and a `first` that is not TDSP_NO_DISC; or TDSP_NO_ANSWER. Asked when all rows are placed. NULL: tables
     * do not tell. */
    tdsp_status (*jump_gap)(void *ctx, double departure, double before, double after, tdsp_gap *out);
} tdsp_oracle;

/** All members to their defaults. Since 0.1. */
TDSP_API void tdsp_oracle_init(tdsp_oracle *oracle);

#ifdef __cplusplus
}
#endif

#endif
