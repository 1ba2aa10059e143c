/* SPDX-License-Identifier: MIT */
/*
 * Certifying the right side of a jump by a question backwards, instead of settling it to neighbouring doubles by forward ones.
 */
#ifndef BUILD_SEAL_H
#define BUILD_SEAL_H

#include "build/probe.h"

/* What a reverse call has shown: no departure after this one arrives by `arrival`. */
typedef struct seal {
    double departure; /* NaN when nothing is known */
    double arrival;
} seal;

/*
 * Ask backwards for an arrival just under that of `high`, which is a little after the jump that follows `low`. `slope` is a guess of how
 * steeply values rise after it, corrected once; `give` is the most that the bound may lie under the value of `high`. *out is what was
 * learned last; its departure is NaN when there is nothing to ask.
 */
tdsp_status seal_ask(probe *p, const sample *low, const sample *high, double slope, double give, seal *out);

/* Does it mean that the value jumps right after `low`? Then *after is a certified lower bound of the value right after it. */
int seal_holds(const probe *p, const seal *known, const sample *low, const sample *high, double give, double *after);

#endif
