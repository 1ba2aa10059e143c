/* SPDX-License-Identifier: MIT */
/* The library's discs as this solver sees them. */
#include <math.h>

#include "slow/law.h"

static slow_jet rate_jet(const void *ctx, size_t piece, double time)
{
    const tdsp_growing_disc *disc = ctx;
    (void)piece;
    return (slow_jet){disc->radius + disc->growth.rate * time, disc->growth.rate, 0.0};
}

static slow_jet polynomial_jet(const void *ctx, size_t piece, double time)
{
    const tdsp_growing_disc *disc = ctx;
    double sum = 0.0, first = 0.0, half_second = 0.0;
    (void)piece;
    for (size_t k = disc->growth.count; k > 0; k--) {
        half_second = half_second * time + first;
        first = first * time + sum;
        sum = sum * time + disc->growth.values[k - 1];
    }
    /* The sum so far is R' s quotient: R = radius + time sum. */
    return (slow_jet){disc->radius + time * sum, sum + time * first, 2.0 * (first + time * half_second)};
}

static slow_jet rates_jet(const void *ctx, size_t piece, double time)
{
    const tdsp_growing_disc *disc = ctx;
    const tdsp_growth *g = &disc->growth;
    double radius = disc->radius;
    for (size_t k = 0; k < piece; k++) radius += g->values[k] * (g->times[k + 1] - g->times[k]);
    return (slow_jet){radius + g->values[piece] * (time - g->times[piece]), g->values[piece], 0.0};
}

/* A kink's own rate is the one that holds from then on; just before it, also by rounding, is the other. After the end the rate stays. */
static slow_jet law_jet(const void *ctx, size_t piece, double time)
{
    const tdsp_growing_disc *disc = ctx;
    const tdsp_growth *g = &disc->growth;
    const double end = piece < g->count ? g->times[piece] : g->until, begin = piece > 0 ? g->times[piece - 1] : 0.0;
    const double step = 1e-6 * (end - begin);
    double radius, rate, earlier, later, ignored;
    if (piece == g->count && time >= end) {
        g->law(g->ctx, end, &radius, &rate);
        return (slow_jet){radius + rate * (time - end), rate, 0.0};
    }
    const double inside = fmax(begin, fmin(time, end - 1e-15 * end));
    g->law(g->ctx, inside, &radius, &rate);
    const double middle = fmax(begin + step, fmin(end - 2.0 * step, inside));
    g->law(g->ctx, middle - step, &ignored, &earlier);
    g->law(g->ctx, middle + step, &ignored, &later);
    return (slow_jet){radius, rate, (later - earlier) / (2.0 * step)};
}

slow_law_disc slow_law_of(const tdsp_growing_disc *disc)
{
    const tdsp_growth *g = &disc->growth;
    switch (g->kind) {
    case TDSP_GROWTH_POLYNOMIAL: return (slow_law_disc){disc->center, polynomial_jet, disc, NULL, 0};
    case TDSP_GROWTH_RATES: return (slow_law_disc){disc->center, rates_jet, disc, g->times + 1, g->count - 1};
    case TDSP_GROWTH_LAW: return (slow_law_disc){disc->center, law_jet, disc, g->times, g->count};
    case TDSP_GROWTH_RATE: break;
    }
    return (slow_law_disc){disc->center, rate_jet, disc, NULL, 0};
}
