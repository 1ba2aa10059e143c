/* SPDX-License-Identifier: MIT */
/*
 * Oracles whose function is known in closed form: pieces of parabolas with jumps between them. Each can be made forward-only, noisy, mistaken
 * about where it jumps, or wrong in ways that a builder must notice.
 */
#ifndef SUPPORT_TOY_ORACLES_H
#define SUPPORT_TOY_ORACLES_H

#include <stddef.h>
#include <stdint.h>

#include "tdsp/oracle.h"

/* The value at t in (from, until], from being where the piece before ends (0 for the first piece, which holds 0 too). */
typedef struct toy_piece {
    double until;
    double c0, c1, c2; /* c0 + c1 u + c2 u^2 with u = t - from; not decreasing */
} toy_piece;

typedef enum toy_fault {
    TOY_SOUND,
    TOY_FALLS,       /* the value falls by a tenth from call fault_at on */
    TOY_NAN,         /* arrival NaN at call fault_at */
    TOY_INFINITE,    /* arrival infinite with TDSP_OK */
    TOY_EARLY,       /* arrival before the departure */
    TOY_NEGATIVE,    /* arrival -1 */
    TOY_ODD_ANSWER,  /* an answer that is none to this question */
    TOY_ERROR,       /* fails with TDSP_FAILED */
    TOY_REVERSE_NAN, /* latest_departure says NaN, ... */
    TOY_REVERSE_ODD, /* ... TDSP_CUT_OFF where there is a way */
    TOY_REVERSE_ERROR,
    TOY_PATH_ERROR,
    TOY_CROSSED,     /* earliest_arrival_within: a lower bound over the arrival */
    TOY_BEFORE_LOWER, /* ... a lower bound before the departure */
    TOY_NOT_BETWEEN, /* latest_departure_between: before `after` */
    TOY_PATH_NULL /* path of one leg at NULL */
} toy_fault;

typedef struct toy {
    const toy_piece *pieces; /* the last one's `until` is the last departure; INFINITY for never */
    size_t count;
    int by_arrival;     /* pieces are A, not T */
    int legs;           /* paths are one leg, else eight bytes: the departure */
    tdsp_status reason; /* after the last departure */
    double error;       /* stated; the noise stays within it */
    double time_scale;
    double blur;       /* the forward function jumps this much later than latest_departure says */
    double lie;        /* added to what latest_departure says of a finite arrival, ... */
    uint64_t lie_from; /* ... from this reverse call on, ... */
    uint64_t lie_to;   /* ... and before this one; 0 for never ending */
    int rough;         /* has earliest_arrival_within, which is as far off as it may be, and latest_departure_between */
    uint64_t rough_calls;
    toy_fault fault;
    uint64_t fault_at; /* forward or reverse call, from 1 */
    uint64_t forward_calls;
    uint64_t reverse_calls;
    uint64_t paths;
    double asked; /* the last departure, for its path */
    double arrival;
    unsigned char bytes[8];
    tdsp_leg leg;
} toy;

/* A sound toy over pieces, with the reason TDSP_CUT_OFF. */
toy toy_over(const toy_piece *pieces, size_t count, int by_arrival);

/* The oracle; without latest_departure when forward_only. It borrows the toy. */
tdsp_oracle toy_oracle(toy *t, int forward_only);

/* The truth. */
long double toy_value(const toy *t, double departure); /* infinite after the last departure */
long double toy_arrival(const toy *t, double departure);
long double toy_value_after(const toy *t, double departure); /* the right limit */
double toy_last(const toy *t);

/* sup { t : value(t) <= cap }; -1 when not even 0 is. */
double toy_inverse(const toy *t, long double cap);

#endif
