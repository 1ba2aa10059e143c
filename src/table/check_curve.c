/* SPDX-License-Identifier: MIT */
/*
 * A curve that every reader can evaluate.
 *
 * Its polynomials (tdsp/types.h) are combinations, with factors of up to 15, of the values, the slopes times the duration h and the bends times h^2 at
 * both ends. For the distance these are given; for the angle the slope is w <= v / r, and with s = sqrt(v^2 - r'^2) >= (v^2 - r'^2) / v the bend
 * is at most |r'| |r''| v / ((v^2 - r'^2) r) + |r'| v / r^2. Where their sums are not over 2^1000 the coefficients are finite, and so are they
 * after the path is moved in time. No square root is needed, which not every machine that reads tables has.
 */
#include "base/round.h"
#include "table/check.h"

#define CURVE_MOST 0x1p1000

static double curve_size(double x)
{
    return x < 0 ? -x : x;
}

/* At most as large as the slope and the bend of the angle turned; NaN or infinite where that is not known. */
static void curve_turning(double speed, double radius, double rate, double bend, double *slope, double *bent)
{
    double share = (speed - rate) / speed * ((speed + rate) / speed);
    *slope = speed / radius;
    *bent = curve_size(rate) / speed / share * (curve_size(bend) / radius) + curve_size(rate) / radius * *slope;
}

static int curve_is_tame(const tdsp_leg *leg)
{
    double h = leg->end_time - leg->start_time;
    double slope_from, slope_to, bend_from, bend_to;
    curve_turning(leg->speed, leg->radius_from, leg->rate_from, leg->bend_from, &slope_from, &bend_from);
    curve_turning(leg->speed, leg->radius_to, leg->rate_to, leg->bend_to, &slope_to, &bend_to);
    double distance = leg->radius_from + leg->radius_to + h * (curve_size(leg->rate_from) + curve_size(leg->rate_to)) +
                      h * h * (curve_size(leg->bend_from) + curve_size(leg->bend_to));
    double turned = leg->sweep + h * (slope_from + slope_to) + h * h * (bend_from + bend_to);
    return distance <= CURVE_MOST && turned <= CURVE_MOST;
}

int check_curve(const tdsp_leg *leg)
{
    const double numbers[] = {leg->center.x,  leg->center.y, leg->radius_from, leg->radius_to, leg->angle_from, leg->sweep,
                              leg->rate_from, leg->rate_to,  leg->bend_from,   leg->bend_to,   leg->speed};
    for (size_t i = 0; i < sizeof numbers / sizeof numbers[0]; i++)
        if (!round_is_finite(numbers[i])) return 0;
    if (!(leg->radius_from > 0) || !(leg->radius_to > 0) || !(leg->sweep >= 0)) return 0;
    if (!(leg->speed > curve_size(leg->rate_from)) || !(leg->speed > curve_size(leg->rate_to))) return 0;
    return curve_is_tame(leg);
}
