/* SPDX-License-Identifier: MIT */
/* What closes at the jumps of rows, on its way into a table. */
#ifndef BUILD_GAP_LIST_H
#define BUILD_GAP_LIST_H

#include <stddef.h>

#include "tdsp/status.h"
#include "tdsp/types.h"

typedef struct gap_entry {
    size_t row;
    tdsp_gap gap;
} gap_entry;

typedef struct gap_list {
    gap_entry *items; /* by row */
    size_t count, capacity;
} gap_list;

void gap_list_free(gap_list *list, const tdsp_allocator *allocator);

/* Append; rows come in order. TDSP_INVALID_ARGUMENT for a row out of order, TDSP_BAD_ORACLE for numbers no table may hold, TDSP_NO_MEMORY. */
tdsp_status gap_list_add(gap_list *list, const tdsp_allocator *allocator, size_t row, const tdsp_gap *gap);

/* The bytes of the section. */
void gap_list_put(const gap_list *list, unsigned char *bytes);

#endif
