/* SPDX-License-Identifier: MIT */
/*
 * The world of law.h: the source is the origin, the robot's speed is 1, the journey's length is 1 (or what is given where the journey
 * has none). Discs carry the robot's radius. All about one disc and one line.
 */
#ifndef SLOW_LAW_WORLD_H
#define SLOW_LAW_WORLD_H

#include <stddef.h>

#include "slow/law.h"

#define LAW_STRETCHES 128
#define LAW_PANELS 20000

/* Where the disc's g is concave or convex all over, and its rate below the robot's speed or not. */
typedef struct law_stretch {
    double from, to;
    size_t piece;
    int empty; /* the radius is 0 all over */
    int concave;
    int ridable;
} law_stretch;

/* Where a line can touch: a concave ridable stretch; or a kink, from = to, where rates from `slow` to `fast` do. */
typedef struct law_spot {
    double from, to;
    size_t piece; /* the one that holds from then on */
    int kink;
    double slow, fast;
} law_spot;

/* A part of a ridable stretch over which little changes, and less the angle that a rider turns from its begin to the end of all. */
typedef struct law_panel {
    double from, to;
    size_t piece;
    double turned;
} law_panel;

typedef struct law_disc {
    const slow_law_disc *law;
    double x, y;
    law_stretch stretches[LAW_STRETCHES];
    size_t stretch_count;
    law_spot spots[2 * LAW_STRETCHES];
    size_t spot_count;
    law_panel *panels;
    size_t panel_count;
} law_disc;

typedef struct law_world {
    law_disc discs[SLOW_LAW_DISCS];
    size_t count;
    double to_x, to_y; /* the destination */
    double until;
    double radius; /* the robot's, in the user's units, as the next two */
    double length;
    double time;
} law_world;

/* 0 when the scene is too large or memory fails. */
int law_world_make(law_world *world, const tdsp_journey *journey, const slow_law_disc *discs, size_t count, double until);
void law_world_drop(law_world *world);

slow_jet law_world_jet(const law_world *world, size_t disc, size_t piece, double time);

/* Distance of a point from a disc's boundary, negative inside. */
double law_world_clearance(const law_world *world, size_t disc, size_t piece, double x, double y, double time);

/* Is the point not deeper in the disc than a touch? */
int law_world_clear(const law_world *world, size_t disc, size_t piece, double x, double y, double time);

/* Is the point in no disc? */
int law_world_point_free(const law_world *world, double x, double y, double time);

/* Is the straight motion from there at speed 1, for `length`, in no disc? */
int law_world_line_free(const law_world *world, double x, double y, double heading, double time, double length);

/* The line from a point that is at a spot's disc when it touches there. */
typedef struct law_landing {
    double time;
    double aside;  /* angle between the heading and the direction of the centre */
    double excess; /* how far u . n is from what the spot allows: about 0 for a touch */
} law_landing;

/*
 * From a point and a moment to a spot; where no line touches, the one to the nearest end of the spot, so that the answer is continuous.
 * 0 when the spot is over. `hint`: a guess at the contact's time.
 */
int law_world_land(const law_world *world, size_t disc, const law_spot *spot, double x, double y, double time, double hint,
                   law_landing *out);

/* An angle brought into (-pi, pi]; into [0, 2 pi). */
double law_wrap(double angle);
double law_wrap_positive(double angle);

#endif
