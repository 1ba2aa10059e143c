/* SPDX-License-Identifier: MIT */
/* The forward function: asked at departures spread over its domain, where it jumps, and where it ends. */
#ifndef ORACLE_FORWARD_H
#define ORACLE_FORWARD_H

#include "oracle/examiner.h"

/* A(departure), from what was seen or by asking. 0 when there is none to be had: not a departure, no calls or memory left, or a bad answer. */
int forward_see(examiner *x, double departure, seen *out);

/* Ask everywhere, then again, and judge what was seen. */
void forward_examine(examiner *x);

/* Index of the first departure seen without a way; seen_count when there is none. */
size_t forward_first_without_way(const examiner *x);

/* Does the value jump between the departures seen at i and i + 1, so near together that nothing can be said of those between? */
int forward_jumps(const examiner *x, size_t i);

/* The answer for departure 0; 0 when it could not be had. */
int forward_first(const examiner *x, seen *out);

#endif
