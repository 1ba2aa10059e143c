/* SPDX-License-Identifier: MIT */
/* Sums and products of sizes that say when they do not fit: each returns 1 and sets *out, or returns 0. */
#ifndef BASE_SIZES_H
#define BASE_SIZES_H

#include <stdint.h>

static inline int sizes_add(uint64_t a, uint64_t b, uint64_t *out)
{
    if (b > UINT64_MAX - a) return 0;
    *out = a + b;
    return 1;
}

static inline int sizes_multiply(uint64_t a, uint64_t b, uint64_t *out)
{
    if (a != 0 && b > UINT64_MAX / a) return 0;
    *out = a * b;
    return 1;
}

/* The next multiple of 8. */
static inline int sizes_align8(uint64_t a, uint64_t *out)
{
    if (a > UINT64_MAX - 7) return 0;
    *out = (a + 7) & ~(uint64_t)7;
    return 1;
}

#endif
