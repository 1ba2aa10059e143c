/* SPDX-License-Identifier: MIT */
/*
 * Roots by Descartes' rule in Bernstein's form.
 *
 * With x = from + w u, p(x) = sum b_j C(n, j) u^j (1 - u)^(n - j): the number of sign changes in b_0 ... b_n exceeds the number of roots in
 * (0, 1) by an even number. De Casteljau's halving gives the b of both halves by means of neighbours only, so that round-off does not
 * grow with the depth, and both halves share the value between them to the bit. Intervals are visited from left to right, and the last sign seen is carried
 * over: a root that falls on the end of an interval shows as a sign that differs from the carried one.
 */
#include "geom/polynomial.h"

#include <float.h>
#include <limits.h>
#include <stdint.h>
#include <string.h>

#include "base/math.h"
#include "geom/bracket.h"

/* Intervals are halved this often at most. */
#define DEPTH 47

double polynomial_value(const polynomial *p, double x)
{
    double value = 0.0;
    for (int k = p->degree; k >= 0; --k) value = value * x + p->c[k];
    return value;
}

polynomial polynomial_times(const polynomial *p, const polynomial *q)
{
    polynomial product = {p->degree + q->degree, {0.0}};
    for (int i = 0; i <= p->degree; ++i)
        for (int k = 0; k <= q->degree; ++k) product.c[i + k] += p->c[i] * q->c[k];
    return product;
}

polynomial polynomial_derivative(const polynomial *p)
{
    polynomial derivative = {p->degree > 0 ? p->degree - 1 : 0, {0.0}};
    for (int k = 1; k <= p->degree; ++k) derivative.c[k - 1] = k * p->c[k];
    return derivative;
}

/* p in units of powers of two: the ends are at most 1, and the largest coefficient lies in [1/2, 1). */
typedef struct scaled_polynomial {
    polynomial p;
    int unit;  /* x is 2^unit of its own */
    int power; /* p likewise */
    double from, to;
} scaled_polynomial;

/* A coefficient that is too small beside the others keeps its sign. */
static double coefficient_scaled(double c, int power)
{
    double scaled = ldexp(c, power);
    return c != 0.0 && fabs(scaled) < DBL_MIN ? copysign(DBL_MIN, c) : scaled;
}

/* 0 where p is zero everywhere. */
static int polynomial_scale(const polynomial *p, double from, double to, scaled_polynomial *out)
{
    out->p.degree = p->degree;
    while (out->p.degree > 0 && p->c[out->p.degree] == 0.0) --out->p.degree;
    (void)frexp(math_max(fabs(from), fabs(to)), &out->unit);
    out->power = INT_MIN;
    for (int k = 0; k <= out->p.degree; ++k) {
        int power;
        if (p->c[k] == 0.0) continue;
        (void)frexp(p->c[k], &power);
        if (power + k * out->unit > out->power) out->power = power + k * out->unit;
    }
    if (out->power == INT_MIN) return 0;
    for (int k = 0; k <= out->p.degree; ++k) out->p.c[k] = coefficient_scaled(p->c[k], k * out->unit - out->power);
    out->from = ldexp(from, -out->unit);
    out->to = ldexp(to, -out->unit);
    return 1;
}

/* From powers of x to Bernstein's form: Taylor's shift, then the table of differences backwards. The ends are Horner's, and so are their signs. */
static void bernstein_form(const scaled_polynomial *scaled, double *b)
{
    const polynomial *p = &scaled->p;
    int n = p->degree;
    double from = scaled->from, width = scaled->to - from, scale = 1.0, binomial = 1.0;
    memcpy(b, p->c, (size_t)(n + 1) * sizeof *b);
    for (int i = 0; i < n && from != 0.0; ++i)
        for (int j = n - 1; j >= i; --j) b[j] += from * b[j + 1];
    for (int k = 0; k <= n; ++k) {
        b[k] *= scale / binomial;
        scale *= width;
        binomial = binomial * (n - k) / (k + 1);
    }
    for (int i = 1; i <= n; ++i)
        for (int j = n; j >= i; --j) b[j] += b[j - 1];
    b[0] = polynomial_value(p, from);
    b[n] = polynomial_value(p, scaled->to);
}

/* The form becomes that of the left half; `right` receives the other. */
static void bernstein_halve(int n, double *b, double *right)
{
    memcpy(right, b, (size_t)(n + 1) * sizeof *b);
    for (int i = 1; i <= n; ++i) {
        for (int j = 0; j <= n - i; ++j) right[j] = 0.5 * (right[j] + right[j + 1]);
        b[i] = right[0];
    }
}

/* Signs of a form: the first and the last that is not 0, and how often they change. */
typedef struct sign_count {
    int first, last, changes;
} sign_count;

static sign_count bernstein_signs(int n, const double *b)
{
    sign_count count = {0, 0, 0};
    for (int j = 0; j <= n; ++j) {
        int sign = (b[j] > 0.0) - (b[j] < 0.0);
        if (!sign) continue;
        if (!count.first) count.first = sign;
        if (count.last == -sign) ++count.changes;
        count.last = sign;
    }
    return count;
}

static double polynomial_slope(const polynomial *p, double x)
{
    double slope = 0.0;
    for (int k = p->degree; k >= 1; --k) slope = slope * x + k * p->c[k];
    return slope;
}

/*
 * The crossing between lo, where p has the sign, and hi, where it has the other. Each step is at most half as long as the one before it, or halves what is left between them, so that
 * they come to an end; where lo is 0 and the crossing is far below hi, after as many halvings as there are powers of two between.
 */
static double root_refine(const polynomial *p, double lo, double hi, int sign)
{
    double x = 0.5 * (lo + hi), before = hi - lo;
    for (;;) {
        double value = polynomial_value(p, x);
        if (value == 0.0) return x;
        if ((value > 0.0) == (sign > 0)) lo = x;
        else hi = x;
        double next = x - value / polynomial_slope(p, x);
        if (!bracket_holds(lo, hi, next) || fabs(next - x) > 0.5 * before) next = 0.5 * (lo + hi);
        before = fabs(next - x);
        if (before <= 0.25 * DBL_EPSILON * fabs(x) || next <= lo || next >= hi) return x;
        x = next;
    }
}

typedef struct root_search {
    scaled_polynomial scaled;
    int sign; /* left of where the search is; 0 at its begin */
    int count;
    double *roots;
} root_search;

/* Halving, rounded as it is, puts nothing between two neighbours but what lies between them: no more signs change than at first, at most the degree. */
static void search_add(root_search *search, double x)
{
    search->roots[search->count++] = ldexp(x, search->scaled.unit);
}

/* An interval that is halved no further, from the share `low` of the whole to `high`. */
static void search_leaf(root_search *search, sign_count signs, double low, double high)
{
    const scaled_polynomial *scaled = &search->scaled;
    double width = scaled->to - scaled->from, lo = scaled->from + width * low, hi = math_min(scaled->from + width * high, scaled->to);
    if (!signs.first) return;
    if (search->sign == -signs.first) search_add(search, lo);
    if (signs.first != signs.last) search_add(search, root_refine(&scaled->p, lo, hi, signs.first));
    search->sign = signs.last;
}

static void search_run(root_search *search)
{
    double now[POLYNOMIAL_DEGREE + 1], later[DEPTH + 1][POLYNOMIAL_DEGREE + 1]; /* later[d]: the right half that waits at depth d */
    int n = search->scaled.p.degree, depth = 0;
    int64_t place = 0; /* the interval is number `place` of 2^depth */
    bernstein_form(&search->scaled, now);
    for (;;) {
        sign_count signs = bernstein_signs(n, now);
        if (signs.changes > 1 && depth < DEPTH) {
            bernstein_halve(n, now, later[++depth]);
            place *= 2;
            continue;
        }
        search_leaf(search, signs, ldexp((double)place, -depth), ldexp((double)(place + 1), -depth));
        for (; place % 2 == 1; place /= 2) --depth;
        if (depth == 0) return;
        ++place;
        memcpy(now, later[depth], (size_t)(n + 1) * sizeof *now);
    }
}

int polynomial_roots(const polynomial *p, double from, double to, double roots[POLYNOMIAL_DEGREE])
{
    root_search search;
    if (!(from < to) || !polynomial_scale(p, from, to, &search.scaled)) return 0;
    search.sign = 0;
    search.count = 0;
    search.roots = roots;
    search_run(&search);
    return search.count;
}

static int floor_divide(int a, int b)
{
    return a >= 0 ? a / b : -((b - 1 - a) / b);
}

/*
 * All roots but 0 have sizes between 2^low and 2^high; 0 where there are none. Where x <= 2^floor((e[k'] - 6 - e[k]) / (k - k')), with k' the lowest term
 * and 2^(e[k] - 1) <= |c[k]| < 2^e[k], each other term is below 2^-5 of the lowest, and there are at most 18. The other end is the same backwards.
 */
static int polynomial_root_sizes(const polynomial *p, int *low, int *high)
{
    int e[POLYNOMIAL_DEGREE + 1], m = 0, n = p->degree;
    while (n > 0 && p->c[n] == 0.0) --n;
    while (m < n && p->c[m] == 0.0) ++m;
    *low = INT_MAX;
    *high = INT_MIN;
    for (int k = m; k <= n; ++k) (void)frexp(p->c[k], &e[k]);
    for (int k = m; k <= n; ++k) {
        if (p->c[k] == 0.0) continue;
        if (k > m && floor_divide(e[m] - 6 - e[k], k - m) < *low) *low = floor_divide(e[m] - 6 - e[k], k - m);
        if (k < n && -floor_divide(e[n] - 6 - e[k], n - k) > *high) *high = -floor_divide(e[n] - 6 - e[k], n - k);
    }
    return n > m;
}

/* An interval for polynomial_first_root() ends at this many times its begin. */
#define STRIDE 4 /* as a power of two */

#define FARTHEST 1000

/* The sign of p, which is not 0 everywhere, inside of an interval in which it has one sign. */
static int polynomial_sign_within(const polynomial *p, double from, double to)
{
    scaled_polynomial scaled;
    (void)polynomial_scale(p, from, to, &scaled);
    double value = polynomial_value(&scaled.p, 0.5 * (scaled.from + scaled.to));
    return (value > 0.0) - (value < 0.0);
}

/*
 * One search over all sizes would see nothing small beside a root that is 2^47 times as large: hence intervals that grow. A root may lie where one ends and
 * the next begins.
 */
double polynomial_first_root(const polynomial *p)
{
    double roots[POLYNOMIAL_DEGREE];
    int low, high, sign = 0;
    if (!polynomial_root_sizes(p, &low, &high)) return INFINITY;
    low = low < -FARTHEST ? -FARTHEST : low;
    high = high > FARTHEST ? FARTHEST : high;
    for (int power = low; power <= high; power += STRIDE) {
        double from = ldexp(1.0, power), to = ldexp(1.0, power + STRIDE);
        int found = polynomial_roots(p, from, to, roots);
        int within = polynomial_sign_within(p, from, found ? 0.5 * (from + roots[0]) : to);
        if (sign * within < 0) return from;
        if (found) return roots[0];
        if (within) sign = within;
    }
    return INFINITY;
}

/* Round-off of bernstein_form() is below 8 (n + 1) half units in the last place of the same sums without signs. */
static double bernstein_error(const scaled_polynomial *scaled)
{
    double sum = 0.0, x = fabs(scaled->from) + (scaled->to - scaled->from);
    for (int k = scaled->p.degree; k >= 0; --k) sum = sum * x + fabs(scaled->p.c[k]);
    return 4.0 * (scaled->p.degree + 1) * DBL_EPSILON * sum;
}

double polynomial_least(const polynomial *p, double from, double to)
{
    double b[POLYNOMIAL_DEGREE + 1];
    scaled_polynomial scaled;
    if (!polynomial_scale(p, from, to, &scaled)) return 0.0;
    bernstein_form(&scaled, b);
    double least = b[0];
    for (int j = 1; j <= scaled.p.degree; ++j) least = math_min(least, b[j]);
    return ldexp(least - bernstein_error(&scaled), scaled.power);
}
