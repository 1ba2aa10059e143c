/* SPDX-License-Identifier: MIT */
/* The reverse functions, latest_departure and latest_departure_between, held against the forward one; and the last reason. */
#ifndef ORACLE_BACKWARD_H
#define ORACLE_BACKWARD_H

#include "oracle/examiner.h"

/* Only where the forward function is sound. */
void backward_examine(examiner *x);
void between_examine(examiner *x);
void reason_examine(examiner *x);

/* Hold a latest departure d for arrival a against everything that was seen, and against A a little before and after it. */
void backward_judge(examiner *x, tdsp_oracle_callback callback, double a, double d);

/* The last departure of all may be farther away than the oracle can reckon, or than its world is known. */
int backward_is_refused(double a, tdsp_status status);

/* How far beside d an answer may be looked for that a jump at d could have displaced. */
double backward_reach(const examiner *x, double d);

#endif
