/* SPDX-License-Identifier: MIT */
/*
 * A table over a world of one's own: the sampler asks an oracle, and knows nothing of discs.
 *
 *   custom_oracle [NEW]    NEW receives the table that is made
 *
 * The world is a ferry that leaves on the hour and on the half hour until it stops for the night, and a crossing that takes longer against
 * the tide. Who is early waits, so arrivals never decrease with the departure, but travel times do: the oracle is monotone in arrival.
 * Its path is no list of legs but the number of a ferry, kept as the bytes of a row.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tdsp/build.h"
#include "tdsp/oracle.h"
#include "tdsp/table.h"

enum { FERRIES = 9 };
static const double minutes_between = 30.0;
/* Minutes of each crossing. A later ferry never arrives before an earlier one. */
static const double crossing[FERRIES] = {20.0, 20.0, 22.0, 25.0, 30.0, 32.0, 30.0, 26.0, 21.0};

typedef struct ferry_line {
    int last_taken;
} ferry_line;

static tdsp_status ferry_arrival(void *ctx, double departure, double *arrival)
{
    ferry_line *line = ctx;
    for (int i = 0; i < FERRIES; i++) {
        if (i * minutes_between >= departure) {
            line->last_taken = i;
            *arrival = i * minutes_between + crossing[i];
            return TDSP_OK;
        }
    }
    return TDSP_UNREACHABLE;
}

static tdsp_status ferry_path(void *ctx, tdsp_oracle_path *out)
{
    ferry_line *line = ctx;
    memset(out, 0, sizeof *out);
    out->bytes = &line->last_taken;
    out->byte_count = sizeof line->last_taken;
    return TDSP_OK;
}

static void must(tdsp_status status)
{
    if (status == TDSP_OK) return;
    fprintf(stderr, "custom_oracle: %s\n", tdsp_status_text(status));
    exit(EXIT_FAILURE);
}

static void print_answer(const tdsp_table *table, double departure)
{
    const void *bytes = NULL;
    size_t length = 0;
    uint64_t row = 0;
    double upper = 0.0;
    int ferry = 0;
    tdsp_status status = tdsp_table_find(table, departure, &row);
    if (status != TDSP_OK) {
        printf("at the quay at minute %.0f: %s\n", departure, tdsp_status_text(status));
        return;
    }
    must(tdsp_table_arrival(table, departure, NULL, &upper));
    must(tdsp_table_row_bytes(table, row, &bytes, &length));
    memcpy(&ferry, bytes, sizeof ferry);
    printf("at the quay at minute %.0f: take ferry %d, arrive at minute %.0f\n", departure, ferry, upper);
}

static void write_file(const char *name, const void *bytes, size_t length)
{
    FILE *file = fopen(name, "wb");
    if (file && fwrite(bytes, 1, length, file) == length && !fclose(file)) return;
    fprintf(stderr, "custom_oracle: %s: cannot be written\n", name);
    exit(EXIT_FAILURE);
}

int main(int argc, char **argv)
{
    ferry_line line = {0};
    tdsp_oracle oracle;
    tdsp_build_options options;
    tdsp_table table;
    void *bytes = NULL;
    size_t length = 0;

    tdsp_oracle_init(&oracle);
    oracle.ctx = &line;
    oracle.monotone = TDSP_MONOTONE_ARRIVAL;
    oracle.earliest_arrival = ferry_arrival;
    oracle.path = ferry_path;

    tdsp_build_options_init(&options);
    options.guarantee = TDSP_GUARANTEE_ABSOLUTE;
    options.delta = 1.0;
    must(tdsp_build(&oracle, &options, NULL, &bytes, &length, NULL));
    must(tdsp_table_open(&table, bytes, length));
    print_answer(&table, 0.0);
    print_answer(&table, 31.0);
    print_answer(&table, 89.0);
    print_answer(&table, 90.0);
    print_answer(&table, 239.0);
    print_answer(&table, 241.0);
    if (argc > 1) write_file(argv[1], bytes, length);
    tdsp_bytes_free(NULL, bytes, length);
    return EXIT_SUCCESS;
}
