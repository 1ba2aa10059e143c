/* SPDX-License-Identifier: MIT */
/*
 * How long one look-up in a table takes: nanoseconds for an arrival, and for a position on the way.
 *     lookup TABLE
 * Departures come in a scrambled order, so that the look-ups are not helped by the ones before them.
 */
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#include "tdsp/table.h"

enum { LOOKUPS = 2000000, ROOM = 1 << 24 };

static double now_ns(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return 1e9 * (double)now.tv_sec + (double)now.tv_nsec;
}

/* Shares of [0, 1) in an order without pattern: Weyl's sequence. */
static double scrambled(int i)
{
    double x = (double)i * 0.61803398874989484820;
    return x - (double)(long)x;
}

static double arrivals_ns(const tdsp_table *table, double last, double *sum)
{
    double begin = now_ns();
    for (int i = 0; i < LOOKUPS; i++) {
        double lower = 0.0, upper = 0.0;
        if (tdsp_table_arrival(table, last * scrambled(i), &lower, &upper) == TDSP_OK) *sum += upper - lower;
    }
    return (now_ns() - begin) / (double)LOOKUPS;
}

static double positions_ns(const tdsp_table *table, double last, double *sum)
{
    double begin = now_ns();
    for (int i = 0; i < LOOKUPS; i++) {
        double departure = last * scrambled(i);
        tdsp_point place;
        if (tdsp_table_position(table, departure, departure + last * scrambled(i / 7), &place) == TDSP_OK) *sum += place.x;
    }
    return (now_ns() - begin) / (double)LOOKUPS;
}

int main(int argc, char **argv)
{
    FILE *file = argc == 2 ? fopen(argv[1], "rb") : NULL;
    unsigned char *bytes = calloc(ROOM, 1);
    size_t length = file && bytes ? fread(bytes, 1, ROOM, file) : 0;
    tdsp_table table;
    tdsp_table_info info;
    double sum = 0.0;
    int opened = tdsp_table_open(&table, bytes, length) == TDSP_OK && tdsp_table_get_info(&table, &info) == TDSP_OK;
    if (file) fclose(file);
    if (opened) {
        double arrival = arrivals_ns(&table, info.last_departure, &sum);
        double position = positions_ns(&table, info.last_departure, &sum);
        printf("{\"rows\": %lu, \"arrival_ns\": %.1f, \"position_ns\": %.1f, \"sum\": %g}\n", (unsigned long)info.rows, arrival,
               position, sum);
    }
    free(bytes);
    return opened ? 0 : 1;
}
