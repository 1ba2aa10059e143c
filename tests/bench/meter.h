/* SPDX-License-Identifier: MIT */
/* An allocator that knows how much it has handed out. */
#ifndef BENCH_METER_H
#define BENCH_METER_H

#include <stdlib.h>

#include "tdsp/types.h"

typedef struct Meter {
    size_t held; /* bytes now */
    size_t peak; /* and at most */
} Meter;

static inline void *meter_resize(void *ctx, void *block, size_t old_size, size_t new_size)
{
    Meter *meter = ctx;
    void *moved = NULL;
    if (new_size == 0)
        free(block);
    else if (!(moved = realloc(block, new_size)))
        return NULL;
    meter->held += new_size - old_size;
    if (meter->held > meter->peak) meter->peak = meter->held;
    return moved;
}

#endif
