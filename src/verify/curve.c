/* SPDX-License-Identifier: MIT */
/* See curve.h. */
#include "verify/curve.h"

#include "base/math.h"

#define SPEED_RESOLUTION 2e-11 /* of the square of the speed */

typedef struct curve_end {
    double value, slope, bend;
} curve_end;

static void curve_coefficients(curve_end from, curve_end to, double b[6])
{
    b[0] = from.value;
    b[1] = from.value + from.slope / 5.0;
    b[2] = from.value + 0.4 * from.slope + from.bend / 20.0;
    b[3] = to.value - 0.4 * to.slope + to.bend / 20.0;
    b[4] = to.value - to.slope / 5.0;
    b[5] = to.value;
}

/* The derivative of sqrt(v^2 - r'^2) / r, of which r' r'' / sqrt(v^2 - r'^2) comes from the root and r' sqrt(v^2 - r'^2) / r from the quotient. */
static curve_end curve_turning(double turned, double speed, double radius, double rate, double bend, double h)
{
    const double across = sqrt(speed - rate) * sqrt(speed + rate);
    const double pace = across / radius;
    return (curve_end){turned, pace * h, -rate / radius * (bend / across + pace) * h * h};
}

static void curve_shape(motion *m)
{
    const tdsp_leg *leg = &m->leg;
    const double h = m->duration;
    curve_coefficients((curve_end){leg->radius_from, leg->rate_from * h, leg->bend_from * h * h},
                       (curve_end){leg->radius_to, leg->rate_to * h, leg->bend_to * h * h}, m->distance);
    curve_coefficients(curve_turning(0.0, leg->speed, leg->radius_from, leg->rate_from, leg->bend_from, h),
                       curve_turning(leg->sweep, leg->speed, leg->radius_to, leg->rate_to, leg->bend_to, h), m->turned);
}

static bernstein curve_polynomial(const double b[6])
{
    return (bernstein){5, {b[0], b[1], b[2], b[3], b[4], b[5]}};
}

static int all_finite(const double *numbers, int count)
{
    for (int i = 0; i < count; i++)
        if (!isfinite(numbers[i])) return 0;
    return 1;
}

/* The greatest way per duration; infinite where that is no number. */
static double curve_reach(const bernstein *distance, const bernstein *outward, const bernstein *turning)
{
    const bernstein across = bernstein_times(distance, turning);
    const bernstein squares[2] = {bernstein_times(outward, outward), bernstein_times(&across, &across)};
    const bernstein square = bernstein_sum(&squares[0], &squares[1]);
    if (!all_finite(square.b, square.degree + 1)) return INFINITY;
    const double seen = math_max(bernstein_value(&square, 0.5), math_max(square.b[0], square.b[square.degree]));
    return sqrt(bernstein_maximum(&square, seen > 0.0 ? SPEED_RESOLUTION * seen : bernstein_size(&square)));
}

void curve_fill(motion *m)
{
    const tdsp_leg *leg = &m->leg;
    curve_shape(m);
    m->length = math_hypot(leg->radius_to - leg->radius_from, leg->sweep * math_max(leg->radius_from, leg->radius_to));
    if (!(m->duration > 0.0)) return;
    const bernstein distance = curve_polynomial(m->distance), turned = curve_polynomial(m->turned);
    const bernstein outward = bernstein_slope(&distance), turning = bernstein_slope(&turned);
    const bernstein away = bernstein_slope(&outward), spinning = bernstein_slope(&turning);
    const double radius = bernstein_size(&distance), pace = bernstein_size(&turning);
    const double along = bernstein_size(&away) + radius * pace * pace;
    const double across = 2.0 * bernstein_size(&outward) * pace + radius * bernstein_size(&spinning);
    m->length = curve_reach(&distance, &outward, &turning);
    m->speed = m->length / m->duration;
    m->bend = math_hypot(along, across) / m->duration / m->duration;
}

int curve_well_formed(const tdsp_leg *leg)
{
    const double numbers[] = {leg->rate_from, leg->rate_to, leg->bend_from, leg->bend_to, leg->speed};
    if (!all_finite(numbers, 5)) return 0;
    if (!(leg->speed > fabs(leg->rate_from)) || !(leg->speed > fabs(leg->rate_to))) return 0;
    motion m = {.leg = *leg, .duration = leg->end_time - leg->start_time};
    curve_shape(&m);
    return all_finite(m.distance, 6) && all_finite(m.turned, 6);
}

bernstein curve_distance(const motion *m, double from, double to)
{
    const bernstein whole = curve_polynomial(m->distance);
    return bernstein_part(&whole, from, to);
}

double curve_distance_at(const motion *m, double share)
{
    const bernstein distance = curve_polynomial(m->distance);
    return bernstein_value(&distance, share);
}

double curve_turned_at(const motion *m, double share)
{
    const bernstein turned = curve_polynomial(m->turned);
    return bernstein_value(&turned, share);
}
