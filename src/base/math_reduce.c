/* SPDX-License-Identifier: MIT */
/*
 * Payne and Hanek's reduction: of x 2 / pi only the part below 4 matters, so of the bits of 2 / pi only those that do not make multiples of 4 with x = m 2^e,
 * and as many as the result needs. That part is found by multiplying whole numbers, exactly.
 *
 * No double is nearer than 2^-62 of a quarter to a multiple of it, so of the 128 bits behind the point at least 66 are left, which is what high and low take.
 */
#include "base/math_reduce.h"

#include "base/math.h"

#define REDUCE_WORDS 7
#define REDUCE_BITS (32 * REDUCE_WORDS)
#define PRODUCT_WORDS 11

/* pi / 2 */
static const double reduce_half_pi[2] = {0x1.921fb54442d18p+0, 0x1.1a62633145c07p-54};

/* 2 / pi: 64 bits before the point, and those behind it. */
static const uint32_t reduce_two_over_pi[39] = {
    0x0, 0x0,
    0xa2f9836e, 0x4e441529, 0xfc2757d1, 0xf534ddc0, 0xdb629599, 0x3c439041, 0xfe5163ab, 0xdebbc561, 0xb7246e3a, 0x424dd2e0, 0x06492eea, 0x09d1921c,
    0xfe1deb1c, 0xb129a73e, 0xe88235f5, 0x2ebb4484, 0xe99c7026, 0xb45f7e41, 0x3991d639, 0x835339f4, 0x9c845f8b, 0xbdf9283b, 0x1ff897ff, 0xde05980f,
    0xef2f118b, 0x5a0a6d1f, 0x6d367ecf, 0x27cb09b7, 0x4f463f66, 0x9e5fea2d, 0x7527bac7, 0xebe5f17b, 0x3d0739f7, 0x8a5292ea, 0x6bfb5fb1, 0x1f8d5d08,
    0x56033046,
};

/* product += m times the seven words from `words` on, shifted up by `shift` words; the highest word first there, the lowest here. */
static void reduce_multiply(uint32_t product[PRODUCT_WORDS], const uint32_t *words, uint32_t m, int shift)
{
    uint64_t carry = 0;
    for (int k = 0; k < REDUCE_WORDS; ++k) {
        uint64_t sum = (uint64_t)m * words[REDUCE_WORDS - 1 - k] + product[k + shift] + carry;
        product[k + shift] = (uint32_t)(sum & 0xffffffff);
        carry = sum >> 32;
    }
    product[REDUCE_WORDS + shift] = (uint32_t)carry;
}

/* 64 bits from bit `at` on. */
static uint64_t reduce_bits(const uint32_t product[PRODUCT_WORDS], unsigned at)
{
    unsigned word = at / 32, shift = at % 32;
    uint64_t low = ((uint64_t)product[word + 1] << 32 | product[word]) >> shift;
    return shift == 0 ? low : low | (uint64_t)product[word + 2] << (64 - shift);
}

/* high 2^-64 + low 2^-128 quarters of a turn, in two doubles: the first 53 bits, and those that follow. */
static void reduce_to_angle(uint64_t high, uint64_t low, reduce_rest *rest)
{
    int shift = 0;
    for (; !(high >> 63); ++shift) { /* 62 times at most: none is nearer to a multiple */
        high = high << 1 | low >> 63;
        low <<= 1;
    }
    double a = (double)(high >> 11) * math_power_of_two(-53 - shift);
    double b = (double)(int64_t)((high << 42 | low >> 22) & ((UINT64_C(1) << 53) - 1)) * math_power_of_two(-106 - shift);
    double p = a * reduce_half_pi[0];
    double error = math_product_error(a, reduce_half_pi[0], p) + (a * reduce_half_pi[1] + b * reduce_half_pi[0]);
    rest->high = p + error;
    rest->low = (p - rest->high) + error;
}

reduce_rest reduce_far(double x)
{
    reduce_rest rest = {x - x, 0.0, 0};
    if (!(x <= DBL_MAX)) return rest;
    uint32_t product[PRODUCT_WORDS] = {0};
    uint64_t m = (math_bits(x) & ((UINT64_C(1) << 52) - 1)) | UINT64_C(1) << 52;
    unsigned place = (unsigned)(math_bits(x) >> 52) - 1013; /* x = m 2^(place - 62), and place > 25 */
    const uint32_t *words = reduce_two_over_pi + place / 32;
    reduce_multiply(product, words, (uint32_t)(m & 0xffffffff), 0);
    reduce_multiply(product, words, (uint32_t)(m >> 32), 1);
    unsigned point = REDUCE_BITS - 2 - place % 32;
    uint64_t high = reduce_bits(product, point - 64), low = reduce_bits(product, point - 128);
    uint64_t beyond = high >> 63 ? ~UINT64_C(0) : 0; /* over half a quarter: seen from the next one, turned about */
    rest.quarters = (unsigned)(reduce_bits(product, point) & 3) + (unsigned)(beyond & 1);
    reduce_to_angle(high ^ beyond, low ^ beyond, &rest);
    if (beyond) {
        rest.high = -rest.high;
        rest.low = -rest.low;
    }
    return rest;
}
