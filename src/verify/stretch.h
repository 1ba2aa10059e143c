/* SPDX-License-Identifier: MIT */
/*
 * The least clearance of a motion to a disc while it grows by one polynomial R: f(t) = |x(t) - O| - R(t).
 *
 * Around the motion's own centre O' f is r(t) - R(t), a polynomial: its Bernstein coefficients bound it. Where O is beside that by e, |x - O| - |x - O'| comes to it, which
 * is at most e in size and, as the directions to both differ by no more than 2 e / (|x - O| + |x - O'|), changes at most at w e / (least r - e / 2).
 *
 * Else the time is halved until a part [a, b] holds nothing lower, by more than the resolution, than what was found. With the greatest speed w, and rates
 * between V0 and V1 and a least R'' on the part (Bernstein coefficients again) two bounds hold:
 *   f falls at most at w + V1 and rises at most at w - V0, for |x - O| changes at most at w; a disc with V0 >= w only comes closer;
 *   f'' <= w^2 / g + |x''| - R'', with g the least |x - O|, which is at least (|x(a) - O| + |x(b) - O| - w (b - a)) / 2: the motion across the direction to O
 *   bends |x - O| by at most w^2 / g. So f >= min(f(a), f(b)) - max(0, f'') (b - a)^2 / 8.
 * The second brings the parts down to the square root of the resolution where the robot grazes the disc.
 *
 * A line past a disc that grows evenly has its least clearance in closed form (clearance.h).
 */
#ifndef VERIFY_STRETCH_H
#define VERIFY_STRETCH_H

#include "verify/clearance.h"
#include "verify/swell.h"

/* What a stretch is about. */
typedef struct stretch {
    clearance *least;
    const motion *m;
    size_t leg;
    tdsp_point center;
    uint32_t disc;
    swell_piece piece;
} stretch;

/* Does the motion go around a centre, to a small share of its radius or to the resolution `fine`? */
int stretch_is_around(const motion *m, tdsp_point center, double fine);

/* Lower `least` by the motion between two times elapsed, while the piece holds. */
void stretch_clear(const stretch *s, double from, double to);

#endif
