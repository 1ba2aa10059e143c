/* SPDX-License-Identifier: MIT */
/*
 * Growth that is given as numbers: checked, and turned into pieces.
 *
 * A polynomial R grows as long as R' >= 0, and R' is known up to its coefficients' last bits: where it touches zero, as that of (t - 5)^3 + 125, round-off
 * decides its sign. So what must not be negative is Q = R' + 2^-46 sum k |c_k| t^(k - 1): it exceeds R' by more than round-off and
 * by nothing that could be measured. Q is a polynomial too, whose first root over zero is found on the whole half-line (geom/polynomial.h). The
 * disc then shrinks from the root of R' right before it.
 */
#include "scene/growth.h"

#include <math.h>

#define ROUND_OFF 0x1p-46

static int is_moderate(double x)
{
    return x >= -GROWTH_LARGEST && x <= GROWTH_LARGEST;
}

static int is_size(double x)
{
    return x >= 0.0 && x <= GROWTH_LARGEST;
}

static size_t polynomial_count(const tdsp_growth *growth)
{
    size_t count = growth->count;
    while (count > 0 && growth->values[count - 1] == 0.0) --count;
    return count;
}

static int rates_are_equal(const tdsp_growth *growth)
{
    for (size_t k = 1; k < growth->count; ++k)
        if (growth->values[k] != growth->values[0]) return 0;
    return 1;
}

int growth_is_rate(const tdsp_growth *growth, double *rate)
{
    if (growth->kind == TDSP_GROWTH_RATE) {
        *rate = growth->rate;
        return 1;
    }
    if (growth->kind == TDSP_GROWTH_LAW || growth->count == 0 || !growth->values) return 0;
    *rate = growth->values[0];
    return growth->kind == TDSP_GROWTH_POLYNOMIAL ? polynomial_count(growth) <= 1 : rates_are_equal(growth);
}

static const char *rate_add(const tdsp_growing_disc *disc, piece_list *list)
{
    if (!is_size(disc->growth.rate)) return "the growth is not between 0 and 1e100";
    pieces_add_line(list, 0.0, disc->radius, disc->growth.rate);
    return NULL;
}

polynomial growth_rate_raised(const law_piece *piece)
{
    polynomial radius = law_piece_polynomial(piece), rate = polynomial_derivative(&radius);
    for (int k = 0; k <= rate.degree; ++k) rate.c[k] += ROUND_OFF * fabs(rate.c[k]);
    return rate;
}

/* The moment from which R shrinks; the lowest coefficient of its derivative is positive. */
static double polynomial_shrinks(const law_piece *piece)
{
    double roots[POLYNOMIAL_DEGREE];
    polynomial radius = law_piece_polynomial(piece), rate = polynomial_derivative(&radius), raised = growth_rate_raised(piece);
    double falls = polynomial_first_root(&raised);
    if (isinf(falls)) return falls;
    int found = polynomial_roots(&rate, 0.5 * falls, falls, roots);
    return found > 0 ? roots[found - 1] : falls;
}

static int polynomial_sinks_at_once(const law_piece *piece)
{
    for (uint32_t k = 1; k <= piece->degree; ++k)
        if (piece->c[k] != 0.0) return piece->c[k] < 0.0;
    return 0;
}

static const char *polynomial_add(const tdsp_growing_disc *disc, piece_list *list, double *shrinks)
{
    const tdsp_growth *growth = &disc->growth;
    if (growth->count == 0 || growth->count > TDSP_GROWTH_DEGREE || !growth->values) return "the growth has not 1 to 8 coefficients";
    for (size_t k = 0; k < growth->count; ++k)
        if (!is_moderate(growth->values[k])) return "a coefficient of the growth is not finite, or beyond 1e100";
    law_piece piece = {0.0, {disc->radius}, (uint32_t)polynomial_count(growth)};
    for (uint32_t k = 1; k <= piece.degree; ++k) piece.c[k] = growth->values[k - 1];
    if (polynomial_sinks_at_once(&piece)) return "the radius shrinks from t = 0";
    *shrinks = polynomial_shrinks(&piece);
    if (pieces_add(list, piece) && !isinf(*shrinks)) pieces_add_line(list, *shrinks, pieces_last_jet(list, *shrinks).radius, 0.0);
    return NULL;
}

static const char *rates_wrong(const tdsp_growth *growth)
{
    if (growth->count == 0 || growth->count > 0x7fffffff || !growth->values || !growth->times) return "the growth has no rates, or no times";
    if (growth->times[0] != 0.0) return "the first time of the growth is not 0";
    for (size_t k = 0; k < growth->count; ++k) {
        if (!is_size(growth->values[k])) return "a rate of the growth is not between 0 and 1e100";
        if (!is_size(growth->times[k])) return "a time of the growth is not between 0 and 1e100";
        if (k > 0 && growth->times[k] <= growth->times[k - 1]) return "the times of the growth do not increase";
    }
    return NULL;
}

static const char *rates_add(const tdsp_growing_disc *disc, piece_list *list)
{
    const tdsp_growth *growth = &disc->growth;
    const char *wrong = rates_wrong(growth);
    if (wrong) return wrong;
    double radius = disc->radius;
    for (size_t k = 0; k < growth->count; ++k) {
        if (k > 0) radius = pieces_last_jet(list, growth->times[k]).radius;
        if (!pieces_add_line(list, growth->times[k], radius, growth->values[k])) return NULL;
    }
    return NULL;
}

const char *growth_add(const tdsp_growing_disc *disc, piece_list *list, double *shrinks)
{
    *shrinks = INFINITY;
    list->begun = list->count;
    if (!is_moderate(disc->center.x) || !is_moderate(disc->center.y)) return "the centre is not finite, or beyond 1e100";
    if (!is_size(disc->radius)) return "the radius is not between 0 and 1e100";
    switch (disc->growth.kind) {
    case TDSP_GROWTH_RATE: return rate_add(disc, list);
    case TDSP_GROWTH_POLYNOMIAL: return polynomial_add(disc, list, shrinks);
    case TDSP_GROWTH_RATES: return rates_add(disc, list);
    case TDSP_GROWTH_LAW: return growth_follow(disc, list);
    }
    return "the kind of growth is unknown";
}

const char *tdsp_growing_disc_check(const tdsp_growing_disc *disc)
{
    piece_list list = {NULL, NULL, 0, 0, 0, {0.0, {0.0}, 0}, TDSP_OK};
    double shrinks;
    return growth_add(disc, &list, &shrinks);
}
