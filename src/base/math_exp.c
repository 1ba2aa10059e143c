/* SPDX-License-Identifier: MIT */
/*
 * exp(x) and exp(x) - 1, after Tang: with x = n ln 2 / 32 + r and n = 32 m + j
 *
 *     exp(x) = 2^m 2^(j / 32) (1 + p)          p = exp(r) - 1,   |r| <= ln 2 / 64
 *
 * The first part of 2^(j / 32) has 40 bits, so that 2^m times it, less 1, is exact where neither term drowns in the other. For |x| < 1/8 exp(x) - 1 is
 * x + x^2 / 2 + x^3 times a polynomial.
 */
#include "base/math.h"

#define EXP_NEAR 0.125
#define EXP_STEPS 0x1.71547652b82fep+5 /* 32 / ln 2 */
/* Added to a double below 2^51 it leaves it rounded to a whole number, whose bits are the last ones. */
#define EXP_ROUND 0x1.8p52

typedef struct exp_part {
    double high, low;
} exp_part;

/* (exp r - 1 - r - r^2 / 2) / r^3, for |r| <= 1/8 and for |r| <= ln 2 / 64 */
static const double exp_near[8] = {0x1.5555555555555p-3, 0x1.5555555555555p-5, 0x1.1111111114723p-7, 0x1.6c16c16c19022p-10,
                                   0x1.a01a00923231ap-13, 0x1.a01a00ec2b51dp-16, 0x1.71f92c9428bbbp-19, 0x1.27f6f234d4449p-22};
static const double exp_step[4] = {0x1.555555555241p-3, 0x1.5555555553cb3p-5, 0x1.111143b0b4c09p-7, 0x1.6c16f40bb97bap-10};

/* ln 2 / 32, 2^(j / 32) */
static const exp_part exp_two[1] = {{0x1.62e42fefap-6, 0x1.cf79abc9e3b3ap-45}};
static const exp_part exp_nodes[32] = {
    {0x1p+0, 0.0}, {0x1.059b0d3158p+0, 0x1.5d0eb9f1523aep-42}, {0x1.0b5586cf98p+0, 0x1.21ec5317256e3p-41}, {0x1.11301d0126p+0, -0x1.2bd6c5103944ap-42},
    {0x1.172b83c7d6p+0, -0x1.d0a464106e75ep-41}, {0x1.1d4873168cp+0, -0x1.9561fe91ff5dap-42}, {0x1.2387a6e756p+0, 0x1.1c3360fd6d8e1p-43},
    {0x1.29e9df51fep+0, -0x1.1ed3da2ea0a5ep-44}, {0x1.306fe0a31cp+0, -0x1.1d5a42e54b73ap-41}, {0x1.371a7373aap+0, 0x1.3954e28aa05e9p-41},
    {0x1.3dea64c124p+0, -0x1.7bb9497dbb83ep-41}, {0x1.44e0860618p+0, 0x1.25a0626de813cp-41}, {0x1.4bfdad5362p+0, 0x1.44e3a872f5fd9p-41},
    {0x1.5342b569d4p+0, 0x1.f03be1507893bp-41}, {0x1.5ab07dd486p+0, -0x1.7ad4e6d9fd5cep-41}, {0x1.6247eb03a6p+0, -0x1.4f69c1e0bf206p-41},
    {0x1.6a09e667f4p+0, -0x1.0cdbdd3413b26p-42}, {0x1.71f75e8ec6p+0, -0x1.1845b91e1a21fp-45}, {0x1.7a11473ebp+0, 0x1.86d7d51023f6dp-44},
    {0x1.82589994ccp+0, 0x1.c25159f115f56p-41}, {0x1.8ace5422aap+0, 0x1.b6b74f8ab4326p-45}, {0x1.93737b0cdcp+0, 0x1.793d14070fc95p-42},
    {0x1.9c49182a4p+0, -0x1.edfc707729f1cp-41}, {0x1.a5503b23e2p+0, 0x1.5722d0912472cp-42}, {0x1.ae89f995aep+0, -0x1.8a542f1965d12p-41},
    {0x1.b7f76f2fb6p+0, -0x1.b915584f7e54bp-44}, {0x1.c199bdd856p+0, -0x1.ac7bbbe69dabfp-41}, {0x1.cb720dcefap+0, -0x1.f2dd5f8685c2dp-41},
    {0x1.d5818dcfbap+0, 0x1.21c976816badap-42}, {0x1.dfc97337bap+0, -0x1.2851a5cd4f185p-42}, {0x1.ea4afa2a4ap+0, -0x1.e4cf4e118bce1p-41},
    {0x1.f50765b6e4p+0, 0x1.5019d3e12dd8ap-42},
};

/* exp(x) = 2^power (high + low), for |x| < 800. Of a NaN `low` is one, whatever `power`. */
static inline exp_part exp_of(double x, int *power)
{
    double n = x * EXP_STEPS + EXP_ROUND;
    uint32_t biased = (uint32_t)(math_bits(n) & 0xffffffff) + (2048u << 5);
    const exp_part *node = &exp_nodes[biased & 31];
    n -= EXP_ROUND;
    double r = (x - n * exp_two->high) - n * exp_two->low;
    double p = r + r * r * (0.5 + r * (exp_step[0] + r * (exp_step[1] + r * (exp_step[2] + r * exp_step[3]))));
    exp_part found = {node->high, node->low + (node->high + node->low) * p};
    *power = (int)(biased >> 5) - 2048;
    return found;
}

double math_exp(double x)
{
    if (x > 710.0) return INFINITY;
    if (x < -746.0) return 0.0;
    int power;
    exp_part found = exp_of(x, &power);
    double size = found.high + found.low;
    if (power > 1000) return size * 0x1p1000 * math_power_of_two(power - 1000);
    return power < -1000 ? size * 0x1p-1000 * math_power_of_two(power + 1000) : size * math_power_of_two(power);
}

/* exp(x) - 1 where one of the two may drown in the other. */
static double exp_less_one_wide(double x)
{
    if (x > 50.0) return math_exp(x);
    if (x < -50.0) return -1.0;
    int power;
    exp_part found = exp_of(x, &power);
    double scale = math_power_of_two(power), high = scale * found.high, less = high - 1.0;
    return less + (round_sum_error(high, -1.0, less) + scale * found.low);
}

double math_expm1(double x)
{
    const double *a = exp_near;
    if (x == 0.0) return x; /* with its sign */
    if (fabs(x) < EXP_NEAR) {
        double z = x * x, more = a[4] + x * (a[5] + x * (a[6] + x * a[7]));
        return x + (0.5 * z + x * (z * (a[0] + x * (a[1] + x * (a[2] + x * (a[3] + x * more))))));
    }
    if (!(x > -8.0 && x < 20.0)) return exp_less_one_wide(x);
    int power;
    exp_part found = exp_of(x, &power);
    double scale = math_power_of_two(power);
    return (scale * found.high - 1.0) + scale * found.low;
}
