/* SPDX-License-Identifier: MIT */
/*
 * What earlier calls have taught: points of the curve behind, which steer the next guess, and samples ahead, which bound it.
 *
 * Invariants: `ahead` is sorted by departure, the nearest last, and ahead[0] is the end of the domain; nodes are points of one
 * continuous piece of the curve, the newest first.
 */
#ifndef BUILD_TRAIL_H
#define BUILD_TRAIL_H

#include <stddef.h>

#include "build/probe.h"

#define TRAIL_NODES 4
#define TRAIL_AHEAD 96

typedef struct trail {
    sample node[TRAIL_NODES];
    size_t nodes;
    double pace; /* departures for a unit of value where the curve last rose; 0 when that is not known */
    sample ahead[TRAIL_AHEAD];
    size_t ahead_count;
} trail;

/* A trail that knows one point and the end. */
trail trail_begin(const sample *first, const sample *last);

void trail_note(trail *t, const sample *s);

/* The curve jumped: what lies behind says nothing of its course, but its pace is still the best guess. */
void trail_restart(trail *t, const sample *after);

/* A sample nearer than all that are ahead. When there is no room a middle one is forgotten, which is harmless. */
void trail_push_ahead(trail *t, const sample *s);

/* Where the curve should reach `value`: inverse interpolation; NaN when nothing is known. */
double trail_predict(const trail *t, double value);

#endif
