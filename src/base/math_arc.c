/* SPDX-License-Identifier: MIT */
/*
 * Angles: atan2, asin and acos.
 *
 * With `small` and `big` the sizes of the coordinates, the angle a = atan(small / big) <= pi / 4 is what the answer is made of, added to or taken from a multiple
 * of pi / 2. For c = j / 64 next to small / big
 *
 *     a = atan c + atan t          t = (small - c big) / (big + c small),   |t| <= 1/128
 *
 * where small - c big is rounded once, since c has seven bits. Below 1/8 the quotient itself is taken, with what its division left over. The angle comes as
 * high + low, neither of which need be rounded to the other: atan c and the multiples of pi / 2 have a first part that is a multiple of 2^-48, so that their sum is exact.
 *
 * asin x and acos x are the angle of (c, x) and of (x, c) with c = sqrt(1 - x^2), corrected by what c is off: an error d of c turns it by -x d, or x d.
 */
#include "base/math.h"

#define ARC_NEAR 0.125
#define ARC_FIRST 8 /* of the nodes j / 64 */
/* Between these no product or quotient of two coordinates is lost. */
#define ARC_LEAST 0x1p-500
#define ARC_MOST 0x1p500

typedef struct arc_part {
    double high, low;
} arc_part;

/* (atan q / q - 1) / q^2, in q^2, for q <= 1/8 and for q <= 1/128 */
static const double arc_near[7] = {-0x1.5555555555555p-2, 0x1.9999999999817p-3, -0x1.2492492433224p-3,
                                   0x1.c71c70adc0c3cp-4, -0x1.745c50f6e6b4p-4, 0x1.3acbca7185046p-4, -0x1.0412b84459a6p-4};
static const double arc_step[3] = {-0x1.5555555555546p-2, 0x1.999999913c746p-3, -0x1.248cd5228e57fp-3};

/* atan(j / 64) */
static const arc_part arc_nodes[57] = {
    {0x1.fd5ba9aac2fp-4, 0x1.b719644bcc4fap-50}, {0x1.1e1fafb0437p-3, 0x1.3725bd3759298p-50}, {0x1.3d6eee8c6628p-3, -0x1.3a79713cc5b6p-51},
    {0x1.5c9811e3ec28p-3, -0x1.620a95658021ep-51}, {0x1.7b97b4bce5bp-3, 0x1.1347b0b4f881dp-54}, {0x1.9a6a8e96c86p-3, 0x1.30e7b00f3da1ap-50},
    {0x1.b90d75292608p-3, 0x1.1022f621a5c1dp-50}, {0x1.d77d5df2057p-3, 0x1.b38c91a2a68b3p-50}, {0x1.f5b75f92c81p-3, -0x1.14ea9238610a1p-50},
    {0x1.09dc597d8638p-2, -0x1.da746e31bcd1ep-50}, {0x1.18bf5a30bf18p-2, -0x1.f679adc5ba72p-52}, {0x1.278372057ef4p-2, 0x1.6f88322c92038p-52},
    {0x1.362773707ebcp-2, 0x1.79a716aed2635p-51}, {0x1.44aa436c2afp-2, 0x1.35150de1d5262p-51}, {0x1.530ad9951cd4p-2, 0x1.3b6a66dfddefep-51},
    {0x1.614840309dp-2, -0x1.e69c95c55c47cp-50}, {0x1.6f61941e4dfp-2, -0x1.ee31d5737b749p-51}, {0x1.7d5604b63b4p-2, -0x1.14b1bbd1ea6dbp-51},
    {0x1.8b24d394a1b4p-2, -0x1.a924bd1722dc1p-50}, {0x1.98cd5454d6bp-2, 0x1.8679b2623f42ap-50}, {0x1.a64eec3cc24p-2, -0x1.a49bd836a17p-53},
    {0x1.b3a911da65c8p-2, -0x1.39479e138d6bfp-50}, {0x1.c0db4c94ecap-2, -0x1.0730739c24d31p-50}, {0x1.cde53432c134p-2, 0x1.0974c16ef9c39p-50},
    {0x1.dac670561bb4p-2, 0x1.ed15bf9117b2fp-51}, {0x1.e77eb7f175a4p-2, -0x1.778d611f2065ep-51}, {0x1.f40dd0b5414p-2, 0x1.7cb8cda478facp-50},
    {0x1.0039c73c1a4p-1, 0x1.72669b5b1b153p-50}, {0x1.0657e94db30cp-1, 0x1.f8a92da8272d8p-50}, {0x1.0c6145b5b43ep-1, -0x1.7cd160bd8957fp-51},
    {0x1.1255d9bfbd2ap-1, 0x1.1ed42511e3f12p-50}, {0x1.1835a88be7c2p-1, -0x1.91cef189ff9e8p-50}, {0x1.1e00babdefecp-1, -0x1.81928df287a67p-50},
    {0x1.23b71e2cc9e6p-1, 0x1.43884393e7045p-50}, {0x1.2958e59308e4p-1, -0x1.e4279cec31b02p-50}, {0x1.2ee628406cbcp-1, 0x1.4e2eaf4ff867cp-50},
    {0x1.345f01cce37cp-1, -0x1.2efdeec838efp-51}, {0x1.39c391cd4172p-1, -0x1.92304331d8bf4p-51}, {0x1.3f13fb89e97p-1, -0x1.784c1d2db66ecp-50},
    {0x1.445065b795b6p-1, -0x1.47ddb4058fde7p-50}, {0x1.4978fa3269eep-1, 0x1.2483350fe548bp-53}, {0x1.4e8de5bb6ecp-1, 0x1.14a33dbeb3797p-51},
    {0x1.538f57b89062p-1, -0x1.46edd2af69483p-53}, {0x1.587d81f732fcp-1, -0x1.4af2e4ec62d4bp-51}, {0x1.5d58987169b2p-1, -0x1.fbff5c6d0e861p-51},
    {0x1.6220d115d7b8p-1, 0x1.bda90f595e22ep-50}, {0x1.66d663923e08p-1, 0x1.b48ac80a0ba22p-51}, {0x1.6b798920b3dap-1, -0x1.da80386188c51p-51},
    {0x1.700a7c578464p-1, -0x1.8630d3496ab7cp-50}, {0x1.748978fba8ep-1, 0x1.e0bd9530b2c42p-50}, {0x1.78f6bbd5d316p-1, -0x1.afe57dd9ff23p-53},
    {0x1.7d528289fa0ap-1, -0x1.954fbef0e862bp-50}, {0x1.819d0b7158a4p-1, 0x1.990227758b11cp-50}, {0x1.85d69576cc2cp-1, 0x1.45ad9b9ff22e3p-51},
    {0x1.89ff5ff57f2p-1, -0x1.0aadcd2f0bbd1p-50}, {0x1.8e17aa99cc06p-1, -0x1.1ec182ab042f6p-52}, {0x1.921fb54442d2p-1, -0x1.ee59d9cceba4p-51},
};

/* 0, pi / 2, pi */
static const arc_part arc_bases[3] = {
    {0.0, 0.0}, {0x1.921fb54442d2p+0, -0x1.ee59d9cceba4p-50}, {0x1.921fb54442d18p+1, 0x1.1a62633145c07p-53},
};

/* sign atan(small / big) + base, for small <= big, both between ARC_LEAST and ARC_MOST. */
static inline arc_part arc_of(double small, double big, const arc_part *base, double sign)
{
    double q = small / big;
    arc_part angle;
    if (q < ARC_NEAR) {
        double z = q * q, p = q * big, more = arc_near[3] + z * (arc_near[4] + z * (arc_near[5] + z * arc_near[6]));
        double left = ((small - p) - math_product_error(q, big, p)) / big;
        q *= sign;
        angle.high = base->high + q;
        angle.low = ((base->high - angle.high) + q) + (base->low + (sign * left + q * (z * (arc_near[0] + z * (arc_near[1] + z * (arc_near[2] + z * more))))));
        return angle;
    }
    int j = (int)(64.0 * q + 0.5);
    const arc_part *node = &arc_nodes[j - ARC_FIRST];
    double c = j * 0.015625, upper = math_upper(big);
    double t = ((small - c * upper) - c * (big - upper)) / (big + c * small), z = t * t;
    angle.high = base->high + sign * node->high;
    angle.low = base->low + sign * (t + (node->low + t * (z * (arc_step[0] + z * (arc_step[1] + z * arc_step[2])))));
    return angle;
}

/* The angle of coordinates that are not negative, finite, and not both in bounds; `behind` of (-x, y). */
static arc_part arc_of_extremes(double y, double x, int behind)
{
    double small = y > x ? x : y, big = y > x ? y : x;
    if (small == big && big > 0.0) small = big = 1.0;
    if (!(small / big >= 0x1p-100)) { /* 0 / 0 too */
        if (y > x) return arc_bases[1];
        arc_part flat = {big > 0.0 ? small / big : 0.0, 0.0};
        return behind ? arc_bases[2] : flat;
    }
    double scale = big > 1.0 ? 0x1p-500 : 0x1p500; /* they are less than 2^100 apart */
    int swapped = y > x;
    return arc_of(scale * small, scale * big, &arc_bases[swapped ? 1 : 2 * behind], swapped == behind ? 1.0 : -1.0);
}

/* The angle of (x, |y|), from 0 to pi. */
static inline arc_part arc_upper_half(double y, double x)
{
    double ax = fabs(x), ay = fabs(y);
    int behind = (int)(math_bits(x) >> 63), swapped = ay > ax;
    double small = swapped ? ax : ay, big = swapped ? ay : ax;
    if (!(small >= ARC_LEAST && big <= ARC_MOST)) return arc_of_extremes(ay, ax, behind);
    return arc_of(small, big, &arc_bases[swapped ? 1 : 2 * behind], swapped == behind ? 1.0 : -1.0);
}

double math_atan2(double y, double x)
{
    if (x != x || y != y) return x + y;
    arc_part angle = arc_upper_half(y, x);
    return math_turned(angle.high + angle.low, math_bits(y) & MATH_SIGN);
}

/* sqrt(1 - x^2) for |x| <= 1, and what is to be added to it. */
static double arc_other_leg(double x, double *missing)
{
    double square = x * x, error = math_product_error(x, x, square);
    double rest = 1.0 - square, rest_low = ((1.0 - rest) - square) - error, leg = sqrt(rest + rest_low), p = leg * leg;
    *missing = leg > 0.0 ? (((rest - p) - math_product_error(leg, leg, p)) + rest_low) / (2.0 * leg) : 0.0;
    return leg;
}

double math_asin(double x)
{
    if (!(fabs(x) <= 1.0)) return (x - x) / (x - x);
    double missing, size = fabs(x), leg = arc_other_leg(size, &missing);
    arc_part angle = arc_upper_half(size, leg);
    return math_turned(angle.high + (angle.low - size * missing), math_bits(x) & MATH_SIGN);
}

double math_acos(double x)
{
    if (!(fabs(x) <= 1.0)) return (x - x) / (x - x);
    double missing, leg = arc_other_leg(x, &missing);
    arc_part angle = arc_upper_half(leg, x);
    return angle.high + (angle.low + x * missing);
}
