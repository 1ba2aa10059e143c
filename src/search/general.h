/* SPDX-License-Identifier: MIT */
/*
 * Scenes whose rates change: what the solver asks of the engine for them (src/growth), in the solver's own terms.
 *
 * Arrivals and reverse searches are the engine's. Where A jumps, the latest departure is found by bisection on A, which is increasing: between a departure that is in
 * time and one that is not, with a forward search for each bit.
 */
#ifndef SEARCH_GENERAL_H
#define SEARCH_GENERAL_H

#include "search/solver.h"

/* As solver_arrival(). TDSP_SHRINKS when the answer reaches beyond the scene's validity. */
tdsp_status general_arrival(tdsp_solver *solver, double departure, double *arrival);

/*
 * The latest departure that arrives by `arrival`, where `after` is known to (negative: nothing is known) and `before` is known not to: *best is negative when there is
 * none, infinite when nothing ever ends the departures; *arrives is A there.
 */
tdsp_status general_latest(tdsp_solver *solver, double arrival, double after, double before, double *best, double *arrives);

/* Keep the path of the last arrival. */
tdsp_status general_route(tdsp_solver *solver, double departure, double arrival);

#endif
