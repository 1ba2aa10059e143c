/* SPDX-License-Identifier: MIT */
/*
 * Logarithms.
 *
 * For u = 2^k m and a c = j / 64 next to m, 45/64 <= m < 90/64:
 *
 *     ln u = k ln 2 + ln c + 2 artanh s          s = (m - c) / (m + c),   |s| < 1/180
 *
 * where m - c is exact, and so is the sum of the first parts of k ln 2 and ln c: multiples of 2^-42. Where 1 + f is within 1/8 of 1 the first two terms would be zero, and
 * with s = f / (2 + f), since 2 s = f - s f and s f = f^2 / 2 (1 - s),
 *
 *     ln(1 + f) = f - (f^2 / 2 - s (f^2 / 2 + r))          r = 2 artanh(s) / s - 2
 */
#include "base/math.h"

#define LOG_NEAR 0.125
#define LOG_FIRST 45 /* of the nodes j / 64 */
#define LOG_LEAST_BITS UINT64_C(0x3fe6800000000000) /* 45/64 */

typedef struct log_part {
    double high, low;
} log_part;

/* (2 artanh s / s - 2) / s^2, in s^2, for s <= 1/15 and for s <= 1/180 */
static const double log_near[6] = {0x1.5555555555555p-1, 0x1.9999999999a2fp-2, 0x1.2492492432fa3p-2,
                                   0x1.c71c7490caee1p-3, 0x1.7458601d68484p-3, 0x1.3ebf99d13a334p-3};
static const double log_step[3] = {0x1.5555555555557p-1, 0x1.9999999755416p-2, 0x1.24951ff41e77ep-2};

/* ln 2, ln(j / 64) */
static const log_part log_two[1] = {{0x1.62e42fefa38p-1, 0x1.ef35793c7673p-45}};
static const log_part log_nodes[46] = {
    {-0x1.68ac83e9c7p-2, 0x1.7af966c548a3p-44}, {-0x1.522ae0738ap-2, -0x1.ebe708164c759p-45}, {-0x1.3c25277333p-2, -0x1.83b54b606bd5cp-46},
    {-0x1.269621134ep-2, 0x1.1b61f10522625p-44}, {-0x1.1178e8227ep-2, -0x1.1ef78ce2d07f2p-44}, {-0x1.f991c6cb3cp-3, 0x1.90d04cd7cc834p-44},
    {-0x1.d1037f2656p-3, 0x1.84a7e75b6f6e4p-47}, {-0x1.a93ed3c8aep-3, 0x1.8724350562169p-45}, {-0x1.823c16551ap-3, -0x1.e0ddb9a631e83p-46},
    {-0x1.5bf406b544p-3, 0x1.27023eb68981cp-46}, {-0x1.365fcb015ap-3, 0x1.fd3a0afb9691bp-44}, {-0x1.1178e8227ep-3, -0x1.1ef78ce2d07f2p-45},
    {-0x1.da72763844p-4, -0x1.a89401fa71733p-46}, {-0x1.9335e5d594p-4, -0x1.3115c3abd47dap-45}, {-0x1.4d3115d208p-4, 0x1.53a2582f4e1efp-48},
    {-0x1.08598b59e4p-4, 0x1.7e5dd7009902cp-46}, {-0x1.894aa149f8p-5, -0x1.9a19a8be97661p-44}, {-0x1.0415d89e78p-5, 0x1.dddc7f461c516p-44},
    {-0x1.020565893p-6, -0x1.611d27c8e8417p-44}, {0.0, 0.0}, {0x1.fc0a8b0fcp-7, 0x1.f1e7cf6d3a69cp-50}, {0x1.f829b0e78p-6, 0x1.980267c7e09e4p-45},
    {0x1.77458f633p-5, -0x1.181dce586af09p-44}, {0x1.f0a30c0118p-5, -0x1.d599e83368e91p-45}, {0x1.341d7961bcp-4, 0x1.1d0929983761p-44},
    {0x1.6f0d28ae58p-4, -0x1.4b4641b664613p-44}, {0x1.a926d3a4acp-4, 0x1.563650bd22a9cp-44}, {0x1.e27076e2bp-4, -0x1.a342c2af0003cp-45},
    {0x1.0d77e7cd08p-3, 0x1.cb2cd2ee2f482p-44}, {0x1.29552f82p-3, -0x1.5b967f4471dfcp-44}, {0x1.44d2b6ccb8p-3, -0x1.70cc16135783cp-46},
    {0x1.5ff3070a7ap-3, -0x1.8586f183bebf2p-44}, {0x1.7ab890210ep-3, -0x1.bdb9072534a58p-45}, {0x1.9525a9cf46p-3, -0x1.297137d9f158fp-44},
    {0x1.af3c94e80cp-3, -0x1.a4e633fcd9066p-52}, {0x1.c8ff7c79aap-3, -0x1.7794f689f8434p-45}, {0x1.e27076e2bp-3, -0x1.a342c2af0003cp-44},
    {0x1.fb9186d5e4p-3, -0x1.d572aab993c87p-47}, {0x1.0a324e2739p-2, 0x1.c6bee7ef4030ep-47}, {0x1.1675cababap-2, 0x1.8380e731f55c4p-44},
    {0x1.22941fbcf8p-2, -0x1.a6976f5eb0963p-44}, {0x1.2e8e2bae12p-2, -0x1.67b1e99b72bd8p-45}, {0x1.3a64c55694p-2, 0x1.7a71cbcd735dp-44},
    {0x1.4618bc21c6p-2, -0x1.3d82f484c84ccp-46}, {0x1.51aad872ep-2, -0x1.f4bd8db0a7cc1p-44}, {0x1.5d1bdbf581p-2, -0x1.8d6bdc9c7c238p-44},
};

static inline double log_of_near(double f)
{
    double s = f / (2.0 + f), z = s * s, half = 0.5 * f * f;
    double r = z * (log_near[0] + z * (log_near[1] + z * (log_near[2] + z * (log_near[3] + z * (log_near[4] + z * log_near[5])))));
    return f - (half - s * (half + r));
}

/* ln(u + low) for a normal u, and a `low` of at most half a unit in its last place. */
static inline double log_of(double u, double low, int k)
{
    uint64_t bits = math_bits(u);
    int power = (int)((bits + (UINT64_C(0x3ff0000000000000) - LOG_LEAST_BITS)) >> 52) - 1023;
    double m = math_of_bits(bits - ((uint64_t)(int64_t)power << 52));
    int j = (int)(64.0 * m + 0.5);
    double c = j * 0.015625, s = ((m - c) + low * math_power_of_two(-power)) / (m + c), z = s * s;
    const log_part *node = &log_nodes[j - LOG_FIRST];
    double high = (power + k) * log_two->high + node->high, more = (power + k) * log_two->low + node->low;
    return high + (2.0 * s + (more + s * (z * (log_step[0] + z * (log_step[1] + z * log_step[2])))));
}

/* Of zeros, what is negative, infinities, NaNs, and what is too small to be normal. */
static double log_of_extremes(double x)
{
    if (x == 0.0) return -INFINITY;
    if (x < 0.0) return (x - x) / (x - x);
    if (!(x <= DBL_MAX)) return x;
    return log_of(0x1p54 * x, 0.0, -54);
}

double math_log(double x)
{
    if (!(x >= DBL_MIN && x <= 0x1p1000)) return x > 0x1p1000 && x <= DBL_MAX ? log_of(0x1p-54 * x, 0.0, 54) : log_of_extremes(x);
    if (fabs(x - 1.0) < LOG_NEAR) return log_of_near(x - 1.0);
    return log_of(x, 0.0, 0);
}

double math_log1p(double x)
{
    if (fabs(x) < LOG_NEAR) return log_of_near(x);
    if (!(x > -1.0 && x < 0x1p60)) return x > 1.0 ? math_log(x) : log_of_extremes(1.0 + x);
    double u = 1.0 + x;
    return log_of(u, x < 1.0 ? x - (u - 1.0) : 1.0 - (u - x), 0);
}
