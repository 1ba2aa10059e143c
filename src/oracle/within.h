/* SPDX-License-Identifier: MIT */
/* earliest_arrival_within: two bounds, no farther apart than was asked for, with the exact answer between them. */
#ifndef ORACLE_WITHIN_H
#define ORACLE_WITHIN_H

#include "oracle/examiner.h"

/* Only where the forward function is sound. */
void within_examine(examiner *x);

#endif
