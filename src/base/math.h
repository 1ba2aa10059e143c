/* SPDX-License-Identifier: MIT */
/*
 * The mathematics that the library answers with: the same bits on every machine and by every compiler.
 *
 * C libraries differ in the last bits of these functions, one library even by the processor it finds. Here they are made of what IEEE 754 rounds
 * correctly, + - * / and sqrt of doubles, and of operations on bits; so there is one result. What rounds exactly in any C library (fabs, floor,
 * ldexp, frexp, copysign, sqrt) is taken from there. No function has state, a heap, or a loop that depends on its argument's size.
 *
 * Infinities, NaNs and zeros are answered as C99's Annex F says; the sign of a NaN and the exception flags are not promised. Errors are less than what
 * docs/numerics.md states: 1 unit in the last place for all arguments. Constants are made, and held to the sources, by tests/numerics/constants.py.
 */
#ifndef BASE_MATH_H
#define BASE_MATH_H

#include <math.h>
#include <stdint.h>
#include <string.h>

#include "base/round.h"

/* A product and a sum are rounded apart, also where a compiler is not told by -ffp-contract=off. */
#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#endif

/* Sine and cosine of any finite angle, however large. */
double math_sin(double x);
double math_cos(double x);
/* Both, to the bit what the two answer, at hardly more than the price of one. */
void math_sincos(double x, double *sine, double *cosine);

/* The angle of (x, y), from -pi to pi. */
double math_atan2(double y, double x);
double math_asin(double x);
double math_acos(double x);

double math_log(double x);
/* ln(1 + x) */
double math_log1p(double x);

double math_exp(double x);
/* exp(x) - 1 */
double math_expm1(double x);

/* sqrt(x^2 + y^2), where no square overflows or is lost. */
double math_hypot(double x, double y);

static inline uint64_t math_bits(double x)
{
    uint64_t bits;
    memcpy(&bits, &x, sizeof bits);
    return bits;
}

static inline double math_of_bits(uint64_t bits)
{
    double x;
    memcpy(&x, &bits, sizeof x);
    return x;
}

/* The smaller and the larger number; the other one where one is a NaN. Of zeros the second: fmin and fmax leave open which, and C libraries differ. */
static inline double math_min(double x, double y)
{
    return x < y || y != y ? x : y;
}

static inline double math_max(double x, double y)
{
    return x > y || y != y ? x : y;
}

#define MATH_SIGN (UINT64_C(1) << 63)

/* 2^n for a normal result: -1023 < n < 1024. */
static inline double math_power_of_two(int n)
{
    return math_of_bits((uint64_t)(n + 1023) << 52);
}

/* x with the sign turned where `sign` has the sign bit. */
static inline double math_turned(double x, uint64_t sign)
{
    return math_of_bits(math_bits(x) ^ sign);
}

/* The upper 26 bits of a double's 53. */
static inline double math_upper(double x)
{
    return math_of_bits(math_bits(x) & ~UINT64_C(0x7ffffff));
}

/* a b - p for p = fl(a b), to some 2^-106 of p, by Dekker's splitting: no product of halves is rounded but the last, by a bit. */
static inline double math_product_error(double a, double b, double p)
{
    double ah = math_upper(a), al = a - ah, bh = math_upper(b), bl = b - bh;
    return ((ah * bh - p) + ah * bl + al * bh) + al * bl;
}

#endif
