/* SPDX-License-Identifier: MIT */
/*
 * Real roots of polynomials, none missed.
 *
 * On an interval a polynomial lies between the least and the greatest of its Bernstein coefficients, and changes its sign no more often than they do:
 * halving the interval until they change it not at all or once isolates every crossing, and a bracketed Newton finds it.
 *
 * Coefficients and ends of intervals are finite; they may be of any size, as powers of two are taken out first.
 */
#ifndef GEOM_POLYNOMIAL_H
#define GEOM_POLYNOMIAL_H

#define POLYNOMIAL_DEGREE 18

typedef struct polynomial {
    int degree;
    double c[POLYNOMIAL_DEGREE + 1]; /* of the powers */
} polynomial;

double polynomial_value(const polynomial *p, double x);

/* The product; the degrees together are at most POLYNOMIAL_DEGREE. */
polynomial polynomial_times(const polynomial *p, const polynomial *q);

polynomial polynomial_derivative(const polynomial *p);

/*
 * The places between `from` and `to` where p changes its sign, in order; returns how many. A double root where it touches zero without crossing,
 * or two roots closer than 2^-46 of the interval, may be left out or reported as two; a zero at an end is no change. The
 * signs at the ends are those of polynomial_value(). None where from >= to. A place is as sure as the sum of the terms is there: round-off moves a root by about
 * 2^-50 sum |c_k x^k| / |p'(x)|.
 */
int polynomial_roots(const polynomial *p, double from, double to, double roots[POLYNOMIAL_DEGREE]);

/* The first place over 0 where p changes its sign, however far; infinite where it never does. */
double polynomial_first_root(const polynomial *p);

/* A lower bound on p over [from, to], round-off included; tight as the interval shrinks. */
double polynomial_least(const polynomial *p, double from, double to);

#endif
