/* SPDX-License-Identifier: MIT */
/* Tables over toy oracles: a catalogue of toys, building, and checking what a table says against the closed form. */
#ifndef SUPPORT_TOY_TABLES_H
#define SUPPORT_TOY_TABLES_H

#include <stddef.h>

#include "support/toy_oracles.h"
#include "tdsp/build.h"
#include "tdsp/table.h"

typedef struct toy_world {
    const char *name;
    toy toy;
} toy_world;

/* Sound toys of every kind, monotone in travel; those of the second are monotone in arrival. */
const toy_world *toy_worlds(size_t *count);
const toy_world *toy_networks(size_t *count);
const toy_world *toy_named(const char *name);

typedef struct toy_table {
    void *bytes;
    size_t length;
    tdsp_table table;
    tdsp_build_report report;
} toy_table;

/* Build, fail the test unless TDSP_OK, open. Free with toy_table_free(). */
toy_table toy_build(const tdsp_oracle *oracle, const tdsp_build_options *options);
void toy_table_free(toy_table *t);

/*
 * Check the table at `samples` random departures, at each row and beside it: the interval holds the truth and keeps the
 * guarantee, and after the last departure there is the reason. Fails the test otherwise.
 */
void toy_certify(const toy *truth, const tdsp_build_options *options, const toy_table *t, size_t samples);

/* The least number of rows that any table with this guarantee has: greedy in closed form. */
size_t toy_least_rows(const toy *t, const tdsp_build_options *options);

#endif
