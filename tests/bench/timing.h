/* SPDX-License-Identifier: MIT */
/*
 * Timing by repetition. One run is made beforehand to warm caches and to see how long it takes; what is quick is then
 * repeated for a while, what is slow counts as it is. The median says what it takes, the quartiles how far to trust it.
 */
#ifndef BENCH_TIMING_H
#define BENCH_TIMING_H

#include <stddef.h>

#define TIMING_MOST_RUNS 31

/* What is timed, and what has to be done before and after each run without being timed (may be NULL). Returns 0 to give up. */
typedef struct TimingJob {
    int (*before)(void *ctx);
    int (*timed)(void *ctx);
    void (*after)(void *ctx);
    void *ctx;
} TimingJob;

typedef struct Timing {
    size_t runs;
    double median; /* seconds */
    double low;    /* first quartile */
    double high;   /* third quartile */
} Timing;

double timing_now(void); /* seconds, from an arbitrary moment */

/* Spend about `share` seconds on runs after the first. 0 when the job gave up. */
int timing_measure(const TimingJob *job, double share, Timing *out);

#endif
