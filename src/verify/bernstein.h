/* SPDX-License-Identifier: MIT */
/*
 * Polynomials on [0, 1] by their Bernstein coefficients: p(x) = sum b[k] C(n, k) x^k (1 - x)^(n - k).
 *
 * The weights are not negative and add up to 1, so p lies between the least and the greatest coefficient; the first and the last are its values at
 * both ends. Halving brings the coefficients as near to p as the second derivative times the square of the length is small. That makes bounds which hold between
 * samples, and which are as close as one likes.
 */
#ifndef VERIFY_BERNSTEIN_H
#define VERIFY_BERNSTEIN_H

#define BERNSTEIN_DEGREE 18

typedef struct bernstein {
    int degree;
    double b[BERNSTEIN_DEGREE + 1];
} bernstein;

/* sum c[k] u^k over u in [from, to]. */
bernstein bernstein_of_powers(const double *c, int degree, double from, double to);

/* The same polynomial over a part [from, to] of [0, 1], and over both halves. */
bernstein bernstein_part(const bernstein *p, double from, double to);
void bernstein_halve(const bernstein *p, bernstein *low, bernstein *high);

/* The derivative with respect to x. */
bernstein bernstein_slope(const bernstein *p);

bernstein bernstein_sum(const bernstein *p, const bernstein *q);
bernstein bernstein_less(const bernstein *p, const bernstein *q);

/* The degrees together are at most BERNSTEIN_DEGREE. */
bernstein bernstein_times(const bernstein *p, const bernstein *q);

double bernstein_value(const bernstein *p, double x);

/* The least, the greatest and the largest coefficient in size: bounds of p. */
double bernstein_least(const bernstein *p);
double bernstein_most(const bernstein *p);
double bernstein_size(const bernstein *p);

/* An upper bound of p, over its maximum by no more than the resolution, which is over 0. */
double bernstein_maximum(const bernstein *p, double resolution);

#endif
