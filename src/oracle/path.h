/* SPDX-License-Identifier: MIT */
/* Paths that an oracle hands out: well formed, joined, from the departure to the arrival. */
#ifndef ORACLE_PATH_H
#define ORACLE_PATH_H

#include "oracle/examiner.h"

/*
 * Ask for the path of the last answer, which left at `departure` and arrives at `arrival`. 1 and a hash of the path's bytes; 0 when the oracle has no
 * paths, or hands out none that can be read.
 */
int path_examine(examiner *x, double departure, double arrival, uint64_t *hash);

/* Is the path of the last answer, asked for once more, the one with this hash? Noted when it is not. */
void path_examine_again(examiner *x, double departure, uint64_t hash);

#endif
