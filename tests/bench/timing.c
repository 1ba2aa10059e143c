/* SPDX-License-Identifier: MIT */
#include "bench/timing.h"

#include <stdlib.h>
#include <time.h>

#define LEAST_RUNS 3

double timing_now(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

static int ascending(const void *one, const void *other)
{
    double a = *(const double *)one, b = *(const double *)other;
    return (a > b) - (a < b);
}

static int run_once(const TimingJob *job, double *seconds)
{
    if (job->before && !job->before(job->ctx)) return 0;
    double begin = timing_now();
    int fine = job->timed(job->ctx);
    *seconds = timing_now() - begin;
    if (job->after) job->after(job->ctx);
    return fine;
}

static size_t runs_within(double share, double first)
{
    double runs = first > 0.0 ? share / first : TIMING_MOST_RUNS;
    if (runs > TIMING_MOST_RUNS) return TIMING_MOST_RUNS;
    return runs < LEAST_RUNS ? LEAST_RUNS : (size_t)runs;
}

int timing_measure(const TimingJob *job, double share, Timing *out)
{
    double seconds[TIMING_MOST_RUNS];
    if (!run_once(job, &seconds[0])) return 0;
    size_t runs = 1;
    if (seconds[0] < share) {
        runs = runs_within(share, seconds[0]);
        for (size_t i = 0; i < runs; i++)
            if (!run_once(job, &seconds[i])) return 0;
    }
    qsort(seconds, runs, sizeof *seconds, ascending);
    *out = (Timing){runs, seconds[runs / 2], seconds[runs / 4], seconds[runs - 1 - runs / 4]};
    return 1;
}
