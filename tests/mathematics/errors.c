/* SPDX-License-Identifier: MIT */
/*
 * The errors and the price of the library's own mathematics, beside the C library's.
 *
 *   errors COUNT [SEED]     so many arguments of each range of tests/support/functions.c
 *
 * Prints a table in Markdown (docs/numerics.md), and fails where an error is over its bound. Times are the least of some rounds, of a call in a loop.
 */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#include "base/math.h"
#include "support/function_errors.h"

#define TIMED 4096
#define ROUNDS 200

/* The C library's functions must be called, not computed beforehand. */
static volatile double sink;

static double now(void)
{
    struct timespec at;
    clock_gettime(CLOCK_MONOTONIC, &at);
    return (double)at.tv_sec * 1e9 + (double)at.tv_nsec;
}

/* The nanoseconds of a call, by the fastest round. */
static double price(double (*one)(double), double (*two)(double, double), const double *x)
{
    double least = INFINITY;
    for (int round = 0; round < ROUNDS; round++) {
        double begin = now(), sum = 0.0;
        for (int i = 0; i < TIMED; i++) sum += one ? one(x[i]) : two(x[i], x[TIMED - 1 - i]);
        sink = sum;
        least = math_min(least, now() - begin);
    }
    return least / TIMED;
}

static int row(int i, const function_range *range, long count, uint64_t seed)
{
    static double x[TIMED];
    const function_case *function = &function_cases[i];
    const function_reference *reference = &function_references[i];
    function_worst worst = function_measure(i, range, count, seed);
    for (int k = 0; k < TIMED; k++) x[k] = function_argument(range, &seed);
    double own = price(function->one, function->two, x), peer = price(reference->peer, reference->peer_two, x);
    printf("| %s | %s | %.4f | %.4f | %.1f | %.1f |%s\n", function->name, range->name, worst.error, worst.peer_error, own, peer,
           worst.part > 1.0 ? " over its bound" : "");
    if (worst.part > 1.0) printf("at %a, %a\n", worst.x, worst.y);
    return worst.part <= 1.0;
}

int main(int argc, char **argv)
{
    long count = argc > 1 ? strtol(argv[1], NULL, 10) : 0;
    uint64_t seed = argc > 2 ? strtoull(argv[2], NULL, 10) : 1;
    int good = count > 0;
    printf("%ld arguments of each range, seed %" PRIu64 "\n\n", count, seed);
    printf("| function | arguments | worst error | the C library's | ns a call | the C library's |\n|---|---|---|---|---|---|\n");
    for (int i = 0; i < function_count; i++)
        for (const function_range *range = function_cases[i].ranges; range->name; range++) good = row(i, range, count, seed) && good;
    return good ? 0 : 1;
}
