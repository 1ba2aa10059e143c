/* SPDX-License-Identifier: MIT */
/* Tables to look things up in, together with the rows they were made of. */
#ifndef SUPPORT_SAMPLE_H
#define SUPPORT_SAMPLE_H

#include "support/golden.h"
#include "tdsp/table.h"

typedef struct sample {
    unsigned char *bytes;
    tdsp_table table;
    writer_row *rows;
    size_t count;
    double first_lower;
    int travel;
} sample;

/* A golden table (support/golden.h). */
sample sample_golden(size_t which);

/* A random staircase; all of these end the test when anything fails. */
sample sample_random(uint64_t *chance, size_t count, int travel, int horizon);

void sample_free(sample *s);

/* The row that answers a departure, by looking at one after the other; s->count when there is none. */
size_t sample_scan_row(const sample *s, double departure);

/* A departure at a row, beside one, or anywhere; an arrival at either side of a row, beside one, or anywhere. */
double sample_departure(uint64_t *chance, const sample *s);
double sample_arrival(uint64_t *chance, const sample *s);

#endif
