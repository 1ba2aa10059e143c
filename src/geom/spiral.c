/* SPDX-License-Identifier: MIT */
/* Riding a disc's boundary: the equation is in spiral.h. */
#include "geom/spiral.h"

/* ln(1 + x) / x */
static double log1p_over(double x)
{
    if (fabs(x) < 1e-5) return 1.0 - x * (0.5 - x * (1.0 / 3.0 - x * 0.25));
    return math_log1p(x) / x;
}

/* (exp(x) - 1) / x */
static double expm1_over(double x)
{
    if (fabs(x) < 1e-5) return 1.0 + x * (0.5 + x * (1.0 / 6.0 + x * (1.0 / 24.0)));
    return math_expm1(x) / x;
}

double spiral_angle(const geom_disc *disc, double t0, double t1)
{
    double radius = disc_radius(disc, t0);
    double ratio = (t1 - t0) / radius;
    return disc->sine * ratio * log1p_over(disc->rate * ratio);
}

double spiral_duration(const geom_disc *disc, double t0, double angle)
{
    double per_sine = angle / disc->sine;
    return disc_radius(disc, t0) * per_sine * expm1_over(disc->rate * per_sine);
}
