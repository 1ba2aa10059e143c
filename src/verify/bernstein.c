/* SPDX-License-Identifier: MIT */
/* See bernstein.h. */
#include "verify/bernstein.h"

#include "base/math.h"

#define MOST_HALVINGS 48

/* Times the binomials C(n, k), and divided by them. */
static void bernstein_weigh(double b[], int degree)
{
    double binomial = 1.0;
    for (int k = 0; k <= degree; binomial = binomial * (degree - k) / (k + 1), k++) b[k] *= binomial;
}

static void bernstein_unweigh(double b[], int degree)
{
    double binomial = 1.0;
    for (int k = 0; k <= degree; binomial = binomial * (degree - k) / (k + 1), k++) b[k] /= binomial;
}

/*
 * First the powers a[k] of x = (u - from) / (to - from), by repeated synthetic division. The power x^k has the Bernstein coefficients C(i, k) / C(n, k), so
 * b[i] = sum over k of C(i, k) a[k] / C(n, k): by repeated sums of neighbours, as in Pascal's triangle.
 */
bernstein bernstein_of_powers(const double *c, int degree, double from, double to)
{
    bernstein p = {degree, {0.0}};
    double scale = 1.0;
    for (int k = 0; k <= degree; k++) p.b[k] = c[k];
    for (int i = 0; i < degree; i++)
        for (int k = degree - 1; k >= i; k--) p.b[k] += from * p.b[k + 1];
    for (int k = 0; k <= degree; k++, scale *= to - from) p.b[k] *= scale;
    bernstein_unweigh(p.b, degree);
    for (int i = 1; i <= degree; i++)
        for (int k = degree; k >= i; k--) p.b[k] += p.b[k - 1];
    return p;
}

/* De Casteljau's scheme at x: the part before it and the part behind it. */
static void bernstein_cut(const bernstein *p, double x, bernstein *low, bernstein *high)
{
    bernstein at = *p;
    low->degree = high->degree = p->degree;
    for (int n = p->degree; n >= 0; n--) {
        low->b[p->degree - n] = at.b[0];
        high->b[n] = at.b[n];
        for (int k = 0; k < n; k++) at.b[k] = (1.0 - x) * at.b[k] + x * at.b[k + 1];
    }
}

bernstein bernstein_part(const bernstein *p, double from, double to)
{
    bernstein low, high, before;
    bernstein_cut(p, to, &low, &high);
    bernstein_cut(&low, to > 0.0 ? from / to : 0.0, &before, &high);
    return high;
}

void bernstein_halve(const bernstein *p, bernstein *low, bernstein *high)
{
    bernstein_cut(p, 0.5, low, high);
}

bernstein bernstein_slope(const bernstein *p)
{
    bernstein slope = {p->degree > 0 ? p->degree - 1 : 0, {0.0}};
    for (int k = 0; k < p->degree; k++) slope.b[k] = p->degree * (p->b[k + 1] - p->b[k]);
    return slope;
}

/* One degree more is a mean of neighbours. */
static bernstein bernstein_raised(const bernstein *p, int degree)
{
    bernstein out = *p;
    for (int n = p->degree + 1; n <= degree; n++) {
        out.b[n] = out.b[n - 1];
        for (int k = n - 1; k > 0; k--) out.b[k] += (out.b[k - 1] - out.b[k]) * k / n;
        out.degree = n;
    }
    return out;
}

static bernstein bernstein_combined(const bernstein *p, const bernstein *q, double sign)
{
    const int degree = p->degree > q->degree ? p->degree : q->degree;
    bernstein sum = bernstein_raised(p, degree);
    const bernstein other = bernstein_raised(q, degree);
    for (int k = 0; k <= degree; k++) sum.b[k] += sign * other.b[k];
    return sum;
}

bernstein bernstein_sum(const bernstein *p, const bernstein *q)
{
    return bernstein_combined(p, q, 1.0);
}

bernstein bernstein_less(const bernstein *p, const bernstein *q)
{
    return bernstein_combined(p, q, -1.0);
}

bernstein bernstein_times(const bernstein *p, const bernstein *q)
{
    bernstein product = {p->degree + q->degree, {0.0}}, one = *p, other = *q;
    bernstein_weigh(one.b, one.degree);
    bernstein_weigh(other.b, other.degree);
    for (int i = 0; i <= one.degree; i++)
        for (int k = 0; k <= other.degree; k++) product.b[i + k] += one.b[i] * other.b[k];
    bernstein_unweigh(product.b, product.degree);
    return product;
}

double bernstein_value(const bernstein *p, double x)
{
    bernstein low, high;
    bernstein_cut(p, x, &low, &high);
    return high.b[0];
}

double bernstein_least(const bernstein *p)
{
    double least = p->b[0];
    for (int k = 1; k <= p->degree; k++) least = math_min(least, p->b[k]);
    return least;
}

double bernstein_most(const bernstein *p)
{
    double most = p->b[0]; /* NOLINT(clang-analyzer-core.uninitialized.Assign): a degree is not below 0, so bernstein_cut() fills both parts */
    for (int k = 1; k <= p->degree; k++) most = math_max(most, p->b[k]);
    return most;
}

double bernstein_size(const bernstein *p)
{
    return math_max(fabs(bernstein_least(p)), fabs(bernstein_most(p)));
}

/* `found` is the greatest value seen. */
static double bernstein_maximum_of(const bernstein *p, double *found, double resolution, int halvings)
{
    const double bound = bernstein_most(p);
    *found = math_max(*found, math_max(p->b[0], p->b[p->degree])); /* NOLINT(clang-analyzer-core.CallAndMessage): likewise */
    if (!(bound > *found + resolution) || halvings == 0) return bound;
    bernstein low, high;
    bernstein_halve(p, &low, &high);
    const double first = bernstein_maximum_of(&low, found, resolution, halvings - 1);
    return math_max(first, bernstein_maximum_of(&high, found, resolution, halvings - 1));
}

double bernstein_maximum(const bernstein *p, double resolution)
{
    double found = -INFINITY;
    return bernstein_maximum_of(p, &found, resolution, MOST_HALVINGS);
}
