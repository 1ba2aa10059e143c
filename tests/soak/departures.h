/* SPDX-License-Identifier: MIT */
/* Which departures a scene is asked about. */
#ifndef SOAK_DEPARTURES_H
#define SOAK_DEPARTURES_H

#include "soak/scene.h"

enum { SOAK_DEPARTURES = 5 };

/* At most SOAK_DEPARTURES, of all kinds: 0, any, what the scene was made for, the end of all, and the sides of a jump. Returns how many. */
size_t soak_departures(const soak_world *world, uint64_t *chance, double departures[SOAK_DEPARTURES]);

/* Where the travel time rises most between two departures, by halving: the last double before; negative where it hardly rises. */
double soak_find_jump(const soak_world *world, double from, double to);

#endif
