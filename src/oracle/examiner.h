/* SPDX-License-Identifier: MIT */
/*
 * What the parts of the conformance kit share: the oracle under examination, what it has answered, and what was found.
 *
 * What an oracle computes is within
 *
 *     noise = error / (1 - error) * (T + time_scale) + 2^-49 A
 *
 * of the truth: the error it states, with the computed T in the place of the true one (docs/sampler.md, section 1), and rounding: eight half units
 * of A for the oracle, as many for the differences taken here. Where A jumps both directions may mistake the side within blur = 10 noise of
 * the jump (A for T), so that two answers may be 2 blur apart there. Every comparison allows for the noise of both sides, and for the blur where a jump
 * could explain what is seen: what is reported cannot be put down to rounding.
 *
 * Invariant: `seen` is sorted by departure, without doubles of one departure.
 */
#ifndef ORACLE_EXAMINER_H
#define ORACLE_EXAMINER_H

#include <stddef.h>
#include <stdint.h>

#include "tdsp/oracle_check.h"

/* An answer of earliest_arrival. */
typedef struct seen {
    double departure;
    double arrival; /* infinite when there is no way */
    tdsp_status status;
    int has_path;
    uint64_t path; /* its hash */
} seen;

typedef struct examiner {
    tdsp_oracle oracle; /* what it declares is brought into its range */
    const tdsp_oracle_check_options *options;
    tdsp_allocator allocator;
    tdsp_oracle_findings *out;
    seen *seen;
    size_t seen_count, seen_capacity;
    uint64_t chance;
    int unsound; /* earliest_arrival broke a rule that others rest on */
    int failed;  /* there was no memory */
} examiner;

/* ------------------------------------------------------------------------------------------------------------ calls */

/* May another callback be called? Counts it. */
int examiner_may_call(examiner *x);

/* Around a call: when it began, and that it ended. */
double examiner_begin(const examiner *x);
void examiner_end(examiner *x, tdsp_oracle_callback callback, double asked, double began);

/* ---------------------------------------------------------------------------------------------------------- findings */

void examiner_look(examiner *x, tdsp_oracle_rule rule);
void examiner_note(examiner *x, const tdsp_oracle_finding *finding);

/* Is the status one of those whose bits 1 << status are set in `allowed`? Noted when it is not. */
int examiner_allows(examiner *x, tdsp_oracle_callback callback, double asked, tdsp_status status, unsigned allowed);

#define ALLOW_OK (1u << TDSP_OK)
#define ALLOW_NO_WAY \
    (1u << TDSP_SOURCE_COVERED | 1u << TDSP_DESTINATION_COVERED | 1u << TDSP_CUT_OFF | 1u << TDSP_UNREACHABLE)
#define ALLOW_TOO_EARLY (1u << TDSP_ARRIVAL_TOO_EARLY)

/* ----------------------------------------------------------------------------------------------------------- numbers */

/* See above. `noise` is 0 where the travel time is: that is exact. */
double examiner_noise(const examiner *x, double departure, double arrival);
double examiner_blur(const examiner *x, double arrival);

/* The same to the bit? */
int examiner_same(double a, double b);

double examiner_unit(examiner *x);                  /* in [0, 1) */
size_t examiner_below(examiner *x, size_t count);   /* below count, which is over 0 */

#endif
