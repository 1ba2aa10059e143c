/* SPDX-License-Identifier: MIT */
/*
 * The slow solver (slow.h), counting in long double: where that has more digits than double, as on x86, it tells what A is far beyond what
 * the library promises. A touch is no collision as long as it is no deeper than its own rounding.
 */
#ifndef SLOW_PRECISE_H
#define SLOW_PRECISE_H

#include <stddef.h>

#include "tdsp/scene.h"
#include "tdsp/types.h"

/* slow_arrival(), relative error about 1e-17: infinite without a path, NAN when the search was given up as too large. */
long double precise_arrival(const tdsp_journey *journey, const tdsp_disc *discs, size_t count, long double departure);

#endif
