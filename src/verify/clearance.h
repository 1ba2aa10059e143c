/* SPDX-License-Identifier: MIT */
/*
 * The least clearance of a motion to discs that grow: f(t) = |x(t) - O| - R(t), over the whole motion. Where the rate changes, on curves, and around the disc's own
 * centre or nearly so, stretch.h says how; the rest is about R + V t.
 *
 * On a line f is convex (a norm of an affine function, less an affine one), least where motion_nearest() says.
 *
 * On an arc around another centre two bounds hold on any part [a, b], with the constant speed w, tangential rate u and least radius r:
 *   f falls at most at w + V and rises at most at w - V, for |x - O| changes at most at w;
 *   f'' <= w^2 / g + |x''| = w^2 / g + w u / r, with g the least |x - O|, which is at least (|x(a) - O| + |x(b) - O| - w (b - a)) / 2: the
 *   motion across the direction to O bends |x - O| by at most w^2 / g. So f >= min(f(a), f(b)) - (w^2 / g + w u / r) (b - a)^2 / 8.
 * The arc is halved until one of them shows that a part holds nothing lower, by more than the resolution, than what was found.
 */
#ifndef VERIFY_CLEARANCE_H
#define VERIFY_CLEARANCE_H

#include <stddef.h>
#include <stdint.h>

#include "verify/motion.h"
#include "verify/nearby.h"

typedef struct clearance {
    double found;  /* the least f evaluated: not below the true least */
    double bound;  /* not above the true least, found - coarse at the least */
    double fine;   /* resolution while an arc and a disc cost little */
    double coarse; /* resolution when they cost more: bounds the work */
    double time;   /* of `found`, as are the next three */
    double radius; /* of the disc then */
    uint32_t disc;
    size_t leg;
} clearance;

/* Lower `least` by the motion of leg `leg` against all discs. */
void clearance_of_leg(clearance *least, const motion *m, size_t leg, const nearby_index *index);

#endif
