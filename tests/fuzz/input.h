/* SPDX-License-Identifier: MIT */
/*
 * What every target takes apart: the bytes of one input, and what to do when something is wrong.
 *
 * An input that is used up gives zeros, so that every prefix of an input is one, and zeros are the ordinary choice everywhere.
 */
#ifndef FUZZ_INPUT_H
#define FUZZ_INPUT_H

#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

/* The target. Returns 0 always; what is wrong aborts. */
int LLVMFuzzerTestOneInput(const unsigned char *data, size_t size);

typedef struct fuzz_input {
    const unsigned char *data;
    size_t size, at;
} fuzz_input;

static inline unsigned input_byte(fuzz_input *in)
{
    return in->at < in->size ? in->data[in->at++] : 0u;
}

static inline int input_left(const fuzz_input *in)
{
    return in->at < in->size;
}

static inline double input_pick(fuzz_input *in, const double *values, size_t count)
{
    return values[input_byte(in) % count];
}

/* Ends the run where a sentence says what is wrong. */
static inline void fuzz_require(int holds, const char *wrong)
{
    if (holds) return;
    fprintf(stderr, "fuzz: %s\n", wrong);
    abort();
}

#endif
