/* SPDX-License-Identifier: MIT */
/* Values of which nothing is known, for the programs that the proof runs. */
#ifndef PROOF_ANY_H
#define PROOF_ANY_H

#include <stddef.h>
#include <stdint.h>

#include "__fc_builtin.h"

static inline void any_bytes(void *p, size_t size)
{
    Frama_C_make_unknown(p, size);
}

static inline uint64_t any_u64(void)
{
    uint64_t x;
    any_bytes(&x, sizeof x);
    return x;
}

/* Any bits: numbers, infinities, NaN. */
static inline double any_double(void)
{
    double x;
    any_bytes(&x, sizeof x);
    return x;
}

static inline float any_float(void)
{
    float x;
    any_bytes(&x, sizeof x);
    return x;
}

static inline int any_bit(void)
{
    return Frama_C_interval(0, 1);
}

static inline size_t any_size(size_t most)
{
    return Frama_C_unsigned_long_interval(0, most);
}

#endif
