/* SPDX-License-Identifier: MIT */
/*
 * Growth laws as the geometry sees them: pieces of polynomials, one after the other in time.
 *
 * R(t) = sum c[k] (t - start)^k from a piece's start to the next piece's, the last for ever. R is continuous and never falls; its rate may jump where
 * a piece begins.
 */
#ifndef GEOM_LAW_H
#define GEOM_LAW_H

#include <stdint.h>

#include "geom/polynomial.h"

#define LAW_DEGREE 8

typedef struct law_piece {
    double start;
    double c[LAW_DEGREE + 1];
    uint32_t degree; /* c[k] is 0 above */
} law_piece;

typedef struct geom_law {
    const law_piece *pieces; /* pieces[0].start is 0 */
    uint32_t count;          /* at least 1 */
} geom_law;

/* Radius, its first and its second derivative. */
typedef struct law_jet {
    double radius;
    double rate;
    double bend;
} law_jet;

/* The piece that holds at a time and right after it. O(log count). */
uint32_t law_piece_at(const geom_law *law, double time);

/* A piece's polynomial at a time, which may lie beyond its ends. */
law_jet law_piece_jet(const law_piece *piece, double time);

/* Its polynomial, of the time since its start. */
polynomial law_piece_polynomial(const law_piece *piece);

/* The last moment at which R is not over a radius: infinite where it never is, -1 where it always is. O(log count) and a root. */
double law_within_until(const geom_law *law, double radius);

#endif
