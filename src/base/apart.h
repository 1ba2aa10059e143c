/* SPDX-License-Identifier: MIT */
/*
 * A function that stays a function where code is compiled for size (-Os), as firmware is.
 *
 * Put into its caller, it would leave there what it keeps on the stack while the caller goes on to call the next; apart, it gives that back. Compiled for speed, the
 * compiler decides. What is computed is the same to the bit.
 */
#ifndef BASE_APART_H
#define BASE_APART_H

#if defined(__GNUC__) && defined(__OPTIMIZE_SIZE__)
#define APART __attribute__((noinline))
#else
#define APART
#endif

#endif
