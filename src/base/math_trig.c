/* SPDX-License-Identifier: MIT */
/*
 * Sine and cosine.
 *
 * |x| less the nearest multiple of pi / 2 is r = high + low (Cody and Waite, in three parts: n has 16 bits and two parts 37, so that their products are exact).
 * Where |r| < 1/4 a polynomial follows at once. Elsewhere r = c + t with c = j / 32 and |t| <= 1/64, t exact, and by the sums of angles
 *
 *     sin r = S + (C t + (S (cos t - 1) + C (sin t - t)))          cos r = C - (S t - (C (cos t - 1) - S (sin t - t)))
 *
 * with S and C in two doubles each from a table. What is added to the first term is at most 1/15 of it, and its roundings therefore little: the error
 * is below 0.65 units in the last place.
 */
#include "base/apart.h"
#include "base/math.h"
#include "base/math_reduce.h"

#define TRIG_NEAR 0.25
#define TRIG_FIRST 8 /* of the nodes j / 32 */
#define TRIG_TWO_OVER_PI 0x1.45f306dc9c883p-1
/* Added to a double below 2^51 it leaves it rounded to a whole number, whose bits are the last ones. */
#define TRIG_ROUND 0x1.8p52

/* (sin r / r - 1) / r^2 and (cos r - 1 + r^2 / 2) / r^4, in r^2 */
static const double trig_sine[5] = {-0x1.5555555555555p-3, 0x1.1111111111054p-7, -0x1.a01a019ebd2e7p-13, 0x1.71de2c390f99p-19, -0x1.aded09cbb4058p-26};
static const double trig_cosine[4] = {0x1.5555555555524p-5, -0x1.6c16c16b615c5p-10, 0x1.a019f485b18eap-16, -0x1.27976fc3dad26p-22};

typedef struct trig_node {
    double sine, sine_low, cosine, cosine_low;
} trig_node;

static const trig_node trig_nodes[18] = {
    {0x1.faaeed4f31577p-3, -0x1.15d88508e32b8p-57, 0x1.f01549f7deea1p-1, 0x1.d3c1e99e5cafdp-55},
    {0x1.1c37d64c6b876p-2, 0x1.46076fe0dcff4p-56, 0x1.ebe214f76efa8p-1, -0x1.02f9f12ba543ep-55},
    {0x1.3ad129769d3d8p-2, 0x1.03d550487839ap-63, 0x1.e733ea0193d4p-1, -0x1.6428b3546ce13p-55},
    {0x1.591bc9fa2f597p-2, 0x1.7c74bac3fe0cbp-57, 0x1.e20bf49acd6c1p-1, -0x1.660aec7ef636bp-58},
    {0x1.7710255764214p-2, -0x1.6ead7314bb6cep-57, 0x1.dc6b7eb995912p-1, 0x1.4b364776dcd35p-58},
    {0x1.94a6be9f546c5p-2, -0x1.69ce13e683f58p-56, 0x1.d653f073e404p-1, -0x1.76236434bec37p-55},
    {0x1.b1d8305321617p-2, -0x1.ae242cb99f519p-56, 0x1.cfc6cfa52ad9fp-1, 0x1.8b5b5508f2a0dp-55},
    {0x1.ce9d2e3d4a51fp-2, -0x1.2fc8a12dae298p-57, 0x1.c8c5bf8ce1a84p-1, 0x1.ab3d1a1590123p-56},
    {0x1.eaee8744b05fp-2, -0x1.789b43c9b027dp-58, 0x1.c1528065b7d5p-1, -0x1.892111312e828p-55},
    {0x1.0362939c69955p-1, -0x1.2d8cd78397b01p-55, 0x1.b96eeef58840ep-1, 0x1.45a3cc78fadep-58},
    {0x1.110d0c4b69c3bp-1, 0x1.d918998809981p-55, 0x1.b11d04162a4c6p-1, 0x1.1dd561efbc0c2p-56},
    {0x1.1e7343236574cp-1, 0x1.22a3fa4f41d5ap-56, 0x1.a85ed4373e02dp-1, 0x1.9be06385ec792p-57},
    {0x1.2b91dea88421ep-1, -0x1.fa371db216abp-55, 0x1.9f368ed912f85p-1, -0x1.1d200c5791606p-55},
    {0x1.386597456282bp-1, -0x1.10fada93b07a8p-56, 0x1.95a67e00cb1fdp-1, -0x1.0befda21f862dp-55},
    {0x1.44eb381cf386bp-1, -0x1.3ed6c1e6a5505p-55, 0x1.8bb105a5dc9p-1, 0x1.863e03e9474c1p-55},
    {0x1.511f9fd7b351cp-1, -0x1.5c0e861c48831p-55, 0x1.8158a31916d5dp-1, -0x1.de8b90b8228dep-57},
    {0x1.5cffc16bf8f0dp-1, 0x1.96cb370eb578ap-55, 0x1.769fec655211fp-1, -0x1.827d5cf8c68c5p-57},
    {0x1.6888a4e134b2fp-1, -0x1.6b7d37644d5e6p-55, 0x1.6b898fa9efb5dp-1, 0x1.15ac786ccf4b2p-56},
};

static APART reduce_rest trig_reduce_near(double x)
{
    static const double trig_half_pi[3] = {0x1.921fb5444p+0, 0x1.68c234c4cp-39, 0x1.98a2e03707345p-77};
    double n = x * TRIG_TWO_OVER_PI + TRIG_ROUND;
    reduce_rest rest = {0.0, 0.0, (unsigned)(math_bits(n) & 3)};
    n -= TRIG_ROUND;
    double first = x - n * trig_half_pi[0], second = n * trig_half_pi[1], r = first - second;
    double error = ((first - r) - second) - n * trig_half_pi[2];
    rest.high = r + error;
    rest.low = (r - rest.high) + error;
    return rest;
}

/* x >= 0 less a multiple of a quarter turn. */
static inline reduce_rest trig_reduce(double x)
{
    return x < REDUCE_FAR ? trig_reduce_near(x) : reduce_far(x);
}

/* An angle of at most pi / 4, not negative, as near or as node and step, with what both functions take of it. */
typedef struct trig_angle {
    const trig_node *node; /* NULL: near */
    double t, low;
    double z;         /* t^2 */
    double sine_more; /* sin(t + low) - t */
} trig_angle;

static inline trig_angle trig_angle_of(double r, double low)
{
    trig_angle angle = {NULL, r, low, 0.0, 0.0};
    if (r >= TRIG_NEAR) {
        int j = (int)(32.0 * r + 0.5);
        angle.node = &trig_nodes[j - TRIG_FIRST];
        angle.t = r - j * 0.03125;
    }
    double t = angle.t, z = t * t;
    const double *s = trig_sine;
    double more = angle.node ? s[0] + z * (s[1] + z * s[2]) : s[0] + z * (s[1] + z * (s[2] + z * (s[3] + z * s[4])));
    angle.z = z;
    angle.sine_more = low + t * z * more;
    return angle;
}

/* cos t - 1 at a node. */
static inline double trig_versed(const trig_angle *angle)
{
    return angle->z * (angle->z * (trig_cosine[0] + angle->z * trig_cosine[1]) - 0.5);
}

static inline double trig_sine_of(const trig_angle *angle)
{
    const trig_node *node = angle->node;
    if (!node) return angle->t + angle->sine_more;
    return node->sine + (node->cosine * angle->t + (node->sine_low + (node->sine * trig_versed(angle) + node->cosine * angle->sine_more)));
}

static inline double trig_cosine_of(const trig_angle *angle)
{
    const trig_node *node = angle->node;
    if (node) return node->cosine - (node->sine * angle->t - (node->cosine_low + (node->cosine * trig_versed(angle) - node->sine * angle->sine_more)));
    double z = angle->z, half = 0.5 * z, w = 1.0 - half;
    double more = z * z * (trig_cosine[0] + z * (trig_cosine[1] + z * (trig_cosine[2] + z * trig_cosine[3])));
    return w + (((1.0 - w) - half) + (more - angle->t * angle->low));
}

/* Of a rest, whose sign `sign` is the sine's. */
static inline trig_angle trig_angle_of_rest(const reduce_rest *rest, uint64_t *sign)
{
    *sign = math_bits(rest->high) & MATH_SIGN;
    return trig_angle_of(math_turned(rest->high, *sign), math_turned(rest->low, *sign));
}

/* The sign bit where the second last bit of `quarters` is set: half a turn away. */
static inline uint64_t trig_half_turn(unsigned quarters)
{
    return (uint64_t)(quarters & 2) << 62;
}

double math_sin(double x)
{
    uint64_t sign;
    reduce_rest rest = trig_reduce(fabs(x));
    trig_angle angle = trig_angle_of_rest(&rest, &sign);
    uint64_t turned = trig_half_turn(rest.quarters) ^ (math_bits(x) & MATH_SIGN);
    return rest.quarters & 1 ? math_turned(trig_cosine_of(&angle), turned) : math_turned(trig_sine_of(&angle), turned ^ sign);
}

double math_cos(double x)
{
    uint64_t sign;
    reduce_rest rest = trig_reduce(fabs(x));
    trig_angle angle = trig_angle_of_rest(&rest, &sign);
    uint64_t turned = trig_half_turn(rest.quarters + 1);
    return rest.quarters & 1 ? math_turned(trig_sine_of(&angle), turned ^ sign) : math_turned(trig_cosine_of(&angle), turned);
}

/* Of a rest, a sine whose sign is turned by `turned` beside. */
static APART void trig_both_of_rest(const reduce_rest *rest, uint64_t turned, double *sine, double *cosine)
{
    uint64_t sign;
    trig_angle angle = trig_angle_of_rest(rest, &sign);
    double s = math_turned(trig_sine_of(&angle), sign), c = trig_cosine_of(&angle);
    *sine = math_turned(rest->quarters & 1 ? c : s, trig_half_turn(rest->quarters) ^ turned);
    *cosine = math_turned(rest->quarters & 1 ? s : c, trig_half_turn(rest->quarters + 1));
}

void math_sincos(double x, double *sine, double *cosine)
{
    reduce_rest rest = trig_reduce(fabs(x));
    trig_both_of_rest(&rest, math_bits(x) & MATH_SIGN, sine, cosine);
}
