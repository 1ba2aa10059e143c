/* SPDX-License-Identifier: MIT */
/*
 * A second opinion on A(t): slow, written for its argument and not for its speed, for a handful of discs. It shares no code
 * and no formula for two discs with the library.
 *
 * Argument. A time-minimal path among growing discs consists of straight lines and of rides along boundaries, which a line
 * joins and leaves tangentially. So from the source, and from every moment of every ride, look at the tangents from that
 * point to every other disc, on either side, and at the line to the destination: the ride is left where its own direction is
 * the tangent's. Those moments are found by sampling the ride and halving. All that can be reached is explored in the order
 * of time plus the straight way left, so that the first arrival taken is the earliest.
 *
 * A ride is given up only on proof: when an earlier ride on the same disc was at the same angle and could from there run
 * straight out, freely, to where this one begins, then this one starts later where another has been before, and since discs
 * only grow, whatever it would find the other finds earlier.
 */
#ifndef SLOW_SLOW_H
#define SLOW_SLOW_H

#include <stddef.h>

#include "slow/slow_real.h"
#include "tdsp/scene.h"
#include "tdsp/types.h"

/* The earliest arrival, infinite when there is none; NAN when the search was given up as too large. Relative error about 1e-10. */
slow_real slow_arrival(const tdsp_journey *journey, const tdsp_disc *discs, size_t count, slow_real departure);

/* The same with its path: up to `capacity` legs, their number in *leg_count (0 without an arrival). */
slow_real slow_path(const tdsp_journey *journey, const tdsp_disc *discs, size_t count, slow_real departure, tdsp_leg *legs,
                 size_t capacity, size_t *leg_count);

/* sup { t : A(t) <= arrival } by halving on slow_arrival(); negative when A(0) > arrival; NAN as above. */
slow_real slow_departure(const tdsp_journey *journey, const tdsp_disc *discs, size_t count, slow_real arrival);

#endif
