/* SPDX-License-Identifier: MIT */
/*
 * Curves as motions: the verifier's own reading of TDSP_LEG_CURVE in tdsp/types.h.
 *
 * The distance r(x) and the angle turned phi(x) are polynomials of degree 5 in the share x of the duration h. With value f0, slope a and bend c at x = 0 and
 * f1, b, d at x = 1 (per duration) their Bernstein coefficients are
 *
 *     f0,  f0 + a / 5,  f0 + 2 a / 5 + c / 20,  f1 - 2 b / 5 + d / 20,  f1 - b / 5,  f1
 *
 * (the first and second differences of the coefficients are a / 5 and c / 20). The square of the speed, (r'^2 + (r phi')^2) / h^2, is a polynomial of degree
 * 18, so its maximum is known as closely as one likes; the acceleration (r'' - r phi'^2 outwards, 2 r' phi' + r phi'' across) is bounded by the coefficients
 * of its parts.
 */
#ifndef VERIFY_CURVE_H
#define VERIFY_CURVE_H

#include "verify/bernstein.h"
#include "verify/motion.h"

/* Are its numbers finite and in their range, and do its polynomials have finite coefficients? Places and times are known to be good. */
int curve_well_formed(const tdsp_leg *leg);

/* Fill in what a motion has that is a curve; `leg` and `duration` are there. The speed is the greatest, over it by a share of 1e-11 at most. */
void curve_fill(motion *m);

/* The distance from the centre over the share [from, to] of the duration. */
bernstein curve_distance(const motion *m, double from, double to);

/* Distance from the centre and angle turned at a share of the duration. */
double curve_distance_at(const motion *m, double share);
double curve_turned_at(const motion *m, double share);

#endif
