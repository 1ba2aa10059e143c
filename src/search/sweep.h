/* SPDX-License-Identifier: MIT */
/*
 * What has been ridden already, on each disc.
 *
 * Whoever is at a place on a boundary earlier can do whatever a later one can, moved earlier: discs only grow, and the boundary has moved outwards
 * no faster than a robot. So a ride that comes to a place, an angle on its disc, that another ride passed before has nothing more to find, whichever side the
 * other rides on: a path that goes on from there arrives later than it could. Riders of one side turn alike, so two rides either follow each other for good or share
 * nothing; riders of different sides meet once, and both end there.
 *
 * That asks of every ride that it may do what a robot in its place may: one that is let past a disc at a touch must be able to change over to it (ride_touch()).
 *
 * Only a slower disc that pokes out in between and is swallowed again can stop the one who goes straight outwards; where slower discs exist, it is tested.
 * Backwards in time the same holds with "later", for whoever has to leave a place earlier arrives before the arrival asked for.
 */
#ifndef SEARCH_SWEEP_H
#define SEARCH_SWEEP_H

#include "search/engine.h"

/* Was the angle `normal` on that boundary passed at `time` or before? */
int sweep_covers(disc_engine *engine, uint32_t disc, int side, double normal, double time);

/* The time up to which the ride has to be followed on [from, to]: where it comes upon an angle that another passed before. */
double sweep_cut(disc_engine *engine, uint32_t ride, double from, double to);

/* Start a list for a disc and side, or add to it. */
void sweep_add(disc_engine *engine, uint32_t ride);

#endif
