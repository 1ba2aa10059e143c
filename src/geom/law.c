/* SPDX-License-Identifier: MIT */
/* Reading growth laws: what they are stands in law.h. */
#include "geom/law.h"

#include "base/math.h"

uint32_t law_piece_at(const geom_law *law, double time)
{
    uint32_t low = 0, high = law->count; /* pieces[low] begins in time, pieces[high] does not */
    while (high - low > 1) {
        uint32_t middle = low + (high - low) / 2;
        if (law->pieces[middle].start <= time) low = middle;
        else high = middle;
    }
    return low;
}

law_jet law_piece_jet(const law_piece *piece, double time)
{
    double u = time - piece->start;
    law_jet jet = {piece->c[piece->degree], 0.0, 0.0};
    for (uint32_t k = piece->degree; k-- > 0;) {
        jet.bend = jet.bend * u + jet.rate;
        jet.rate = jet.rate * u + jet.radius;
        jet.radius = jet.radius * u + piece->c[k];
    }
    jet.bend *= 2.0;
    return jet;
}

polynomial law_piece_polynomial(const law_piece *piece)
{
    polynomial p = {(int)piece->degree, {0.0}};
    for (uint32_t k = 0; k <= piece->degree; ++k) p.c[k] = piece->c[k];
    return p;
}

/* The last piece that begins with no more than a radius. */
static uint32_t law_piece_within(const geom_law *law, double radius)
{
    uint32_t low = 0, high = law->count; /* pieces[low] does, pieces[high] does not */
    while (high - low > 1) {
        uint32_t middle = low + (high - low) / 2;
        if (law->pieces[middle].c[0] <= radius) low = middle;
        else high = middle;
    }
    return low;
}

/* The same in the last piece of all. */
static double law_end_within_until(const law_piece *piece, double radius)
{
    polynomial over = law_piece_polynomial(piece);
    over.c[0] -= radius;
    if (piece->degree == 0) return INFINITY;
    return over.c[0] < 0.0 ? piece->start + polynomial_first_root(&over) : piece->start;
}

/* Roots are told apart down to a share of an interval, and a piece may be far longer than this from what is asked for: an end of it that is still past that. */
#define SHORTER 0x1p-16

static double length_around_root(const polynomial *over, double length)
{
    while (polynomial_value(over, SHORTER * length) > 0.0) length *= SHORTER;
    return length;
}

double law_within_until(const geom_law *law, double radius)
{
    double roots[POLYNOMIAL_DEGREE];
    if (law->pieces[0].c[0] > radius) return -1.0;
    uint32_t k = law_piece_within(law, radius);
    const law_piece *piece = &law->pieces[k];
    if (k + 1 == law->count) return law_end_within_until(piece, radius);
    double length = piece[1].start - piece->start;
    polynomial over = law_piece_polynomial(piece);
    over.c[0] -= radius;
    int found = polynomial_roots(&over, 0.0, length_around_root(&over, length), roots);
    if (found > 0) return math_min(piece->start + roots[found - 1], piece[1].start);
    return polynomial_value(&over, length) > 0.0 ? piece->start : piece[1].start;
}
