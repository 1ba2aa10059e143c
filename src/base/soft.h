/* SPDX-License-Identifier: MIT */
/*
 * Does this machine do doubles in software, does it do floats so?
 *
 * There an addition of doubles is a call that takes some 70 instructions, and rounding outward needs several. Look-ups then work on the bits of
 * doubles as whole numbers, which gives the same answers (query/outward.h). TDSP_SOFT_DOUBLE and TDSP_SOFT_FLOAT say 0 or 1 where the compiler does not tell.
 */
#ifndef BASE_SOFT_H
#define BASE_SOFT_H

#if defined(TDSP_SOFT_DOUBLE)
#define SOFT_DOUBLE TDSP_SOFT_DOUBLE
#elif defined(__arm__) && !(defined(__ARM_FP) && (__ARM_FP & 8))
#define SOFT_DOUBLE 1
#elif defined(__riscv) && !(defined(__riscv_flen) && __riscv_flen >= 64)
#define SOFT_DOUBLE 1
#elif defined(__XTENSA__)
#define SOFT_DOUBLE 1
#else
#define SOFT_DOUBLE 0
#endif

#if defined(TDSP_SOFT_FLOAT)
#define SOFT_FLOAT TDSP_SOFT_FLOAT
#elif defined(__arm__) && !(defined(__ARM_FP) && (__ARM_FP & 4))
#define SOFT_FLOAT 1
#elif defined(__riscv) && !defined(__riscv_flen)
#define SOFT_FLOAT 1
#else
#define SOFT_FLOAT 0
#endif

#endif
