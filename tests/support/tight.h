/* SPDX-License-Identifier: MIT */
/* Memory that runs out when a test says so, and that knows what is out and that sizes are told truly. */
#ifndef SUPPORT_TIGHT_H
#define SUPPORT_TIGHT_H

#include <stddef.h>

#include "tdsp/tdsp.h"

typedef struct tight_heap {
    size_t calls;  /* that asked for memory */
    size_t refuse; /* the call that fails, from 1; 0: none */
    int and_after; /* and all after it */
    size_t blocks; /* that are out, */
    size_t held;   /* and their bytes */
} tight_heap;

void *tight_resize(void *heap, void *block, size_t old_size, size_t new_size);
tdsp_allocator tight_allocator(tight_heap *heap);

#endif
