/* SPDX-License-Identifier: MIT */
/*
 * An upper bound on A(t) by nothing but straight steps on a grid: Dijkstra over the nodes of a square grid around the journey, from each to
 * those near it in some fifty directions, where the motion, sampled closely, stays clear of every disc. To be early at a node is never worse:
 * discs only grow. Whatever the slow solver leaves out, it must not arrive later than this.
 */
#ifndef SLOW_LAW_GRID_H
#define SLOW_LAW_GRID_H

#include "slow/law.h"

/* `cells` a journey, at least 8. Infinite where the grid finds no way, NAN where memory fails. */
double slow_law_grid(const tdsp_journey *journey, const slow_law_disc *discs, size_t count, double until, double departure,
                     int cells);

#endif
