/* SPDX-License-Identifier: MIT */
/* The interval in which a root is known to lie, and which every step towards it shrinks. */
#ifndef GEOM_BRACKET_H
#define GEOM_BRACKET_H

/* Does a step stay strictly between the ends? A step that is no number does not. */
static inline int bracket_holds(double lo, double hi, double step)
{
    return step > lo && step < hi;
}

#endif
