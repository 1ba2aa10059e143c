/* SPDX-License-Identifier: MIT */
/* The latest departure for an arrival whose cell is known. */
#ifndef QUERY_DEPARTURE_H
#define QUERY_DEPARTURE_H

#include "tdsp/table.h"

/* As tdsp_table_departure() with both outputs, for an arrival from the first row's to the last's, given its cell of the guide to arrivals and where
 * that starts. */
tdsp_status departure_from(const tdsp_table *table, uint64_t cell, uint64_t start, double arrival, double *departure,
                           double *upper);

#endif
