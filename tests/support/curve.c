/* SPDX-License-Identifier: MIT */
/* The integral of sqrt(v^2 - R'^2) / R by Gauss and Legendre's rule with five nodes on each of 64 parts, in long double. */
#include "support/curve.h"

#include <math.h>

#define PARTS 64

double curve_law_at(const curve_law *law, double time, int order)
{
    long double sum = 0;
    for (int k = 4; k >= order; k--) {
        long double factor = law->c[k];
        for (int i = 0; i < order; i++) factor *= k - i;
        sum = sum * time + factor;
    }
    return (double)sum;
}

static long double curve_pace(const curve_law *law, long double speed, long double t)
{
    const double *c = law->c;
    long double radius = c[0] + t * (c[1] + t * (c[2] + t * (c[3] + t * c[4])));
    long double rate = c[1] + t * (2 * c[2] + t * (3 * c[3] + t * 4 * c[4]));
    return sqrtl((speed - rate) * (speed + rate)) / radius;
}

static long double curve_part(const curve_law *law, double speed, long double from, long double width)
{
    static const long double node[] = {0, 0.538469310105683091036L, 0.906179845938663992798L};
    static const long double weight[] = {0.568888888888888888889L, 0.478628670499366468041L, 0.236926885056189087514L};
    long double middle = from + width / 2, sum = weight[0] * curve_pace(law, speed, middle);
    for (int i = 1; i < 3; i++)
        sum += weight[i] *
               (curve_pace(law, speed, middle - node[i] * width / 2) + curve_pace(law, speed, middle + node[i] * width / 2));
    return sum * width / 2;
}

double curve_law_turned(const curve_law *law, double speed, double from, double to)
{
    long double sum = 0, width = ((long double)to - from) / PARTS;
    for (int i = 0; i < PARTS; i++) sum += curve_part(law, speed, from + i * width, width);
    return (double)sum;
}

tdsp_point curve_law_place(const curve_law *law, tdsp_point center, double time, double angle)
{
    double radius = curve_law_at(law, time, 0);
    return (tdsp_point){center.x + radius * cos(angle), center.y + radius * sin(angle)};
}

tdsp_leg curve_leg(const curve_law *law, tdsp_point center, double speed, double start, double end, double angle, int turn)
{
    tdsp_leg leg = {.kind = TDSP_LEG_CURVE,
                    .turn = turn,
                    .start_time = start,
                    .end_time = end,
                    .center = center,
                    .angle_from = angle,
                    .speed = speed};
    leg.sweep = curve_law_turned(law, speed, start, end);
    leg.from = curve_law_place(law, center, start, angle);
    leg.to = curve_law_place(law, center, end, angle + turn * leg.sweep);
    leg.radius_from = curve_law_at(law, start, 0);
    leg.radius_to = curve_law_at(law, end, 0);
    leg.rate_from = curve_law_at(law, start, 1);
    leg.rate_to = curve_law_at(law, end, 1);
    leg.bend_from = curve_law_at(law, start, 2);
    leg.bend_to = curve_law_at(law, end, 2);
    return leg;
}

void curve_legs(const curve_law *law, tdsp_point center, double speed, double start, double end, double angle, int turn,
                tdsp_leg *legs, int count)
{
    double before = start;
    for (int i = 0; i < count; i++) {
        double after = i + 1 < count ? start + (end - start) * (i + 1) / count : end;
        legs[i] = curve_leg(law, center, speed, before, after, angle, turn);
        if (i > 0) legs[i].from = legs[i - 1].to;
        angle += turn * legs[i].sweep;
        before = after;
    }
}
