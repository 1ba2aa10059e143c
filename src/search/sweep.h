/*
 * What has been ridden already, for each disc and side.
 *
 * All riders of one disc and side turn alike, so two rides either follow each other for good or share nothing. A ride that passed the
 * angle earlier dominates one that passes it later: its rider can go straight outwards and be where the later one is, before it. Only
 * a slower disc that pokes out in between and is swallowed again can stop that; where slower discs exist, it is tested.
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
