/* SPDX-License-Identifier: MIT */
/* A leg with what its bounds are made from. On lines and arcs the speed is constant, and so are its parts along and across the radius. */
#ifndef MARGIN_WAY_H
#define MARGIN_WAY_H

#include "tdsp/types.h"

typedef struct way {
    const tdsp_leg *leg;
    double length;     /* of the way */
    double speed;      /* 0 where the leg takes no time */
    double across;     /* arc: the part of the speed across the radius */
    tdsp_point middle; /* halfway in time: nothing of the way is farther from it than half the length */
} way;

/* Is every number finite, in its range, and are the times not negative and in order? */
int way_well_formed(const tdsp_leg *leg);

/* Of a well-formed line or arc. */
way way_of(const tdsp_leg *leg);

double way_distance(tdsp_point a, tdsp_point b);

/* The distance from the centre, the leg being an arc. */
double way_radius(const way *leg, double time);

#endif
