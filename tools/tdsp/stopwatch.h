/* SPDX-License-Identifier: MIT */
/* Elapsed wall time. */
#ifndef STOPWATCH_H
#define STOPWATCH_H

#include <time.h>

typedef struct timespec Stopwatch;

static inline Stopwatch stopwatch_start(void)
{
    Stopwatch now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return now;
}

static inline double stopwatch_seconds(Stopwatch since)
{
    Stopwatch now = stopwatch_start();
    return ((double)(now.tv_sec - since.tv_sec) * 1e9 + (double)(now.tv_nsec - since.tv_nsec)) /
           1e9; /* a decimal without noise */
}

#endif
