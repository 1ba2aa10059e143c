/*
 * The slow solver's world: the source is the origin, the robot's speed is 1, the journey's length is 1 (or what is given
 * where the journey has none). Discs carry the robot's radius.
 */
#ifndef SLOW_WORLD_H
#define SLOW_WORLD_H

#include <stddef.h>

#include "tdsp/scene.h"
#include "tdsp/types.h"

#define SLOW_DISCS 64
#define SLOW_TOUCH 1e-12 /* a contact less deep than this share of the sizes that meet is no collision */
#define SLOW_ROUNDING 1e-14 /* nor is one less deep than this share of the journey */

typedef struct slow_disc {
    double x, y;
    double radius; /* at time 0 */
    double rate;   /* in units of the robot's speed */
} slow_disc;

typedef struct slow_world {
    slow_disc discs[SLOW_DISCS];
    size_t count;
    double to_x, to_y; /* the destination */
    tdsp_point origin; /* the rest turns answers back into the user's units */
    double length;
    double time;
} slow_world;

void slow_world_make(slow_world *world, const tdsp_journey *journey, const tdsp_disc *discs, size_t count);

double slow_radius(const slow_disc *disc, double time);

/* Distance of a point from a disc's boundary, negative inside. */
double slow_clearance(const slow_disc *disc, double x, double y, double time);

/* How deep a touch of this disc at this place is still no collision. */
double slow_slack(const slow_disc *disc, double x, double y, double time);

/* Is the point in no disc? */
int slow_point_free(const slow_world *world, double x, double y, double time);

/* Is the straight motion from there at speed 1, for `length`, in no disc? */
int slow_line_free(const slow_world *world, double x, double y, double heading, double time, double length);

/*
 * The tangent from a point to a disc on a side: +1 has the disc on the left at the contact, -1 on the right. Returns 0 where
 * there is none: the disc is as fast as the robot, is a mere point for ever, or contains the point.
 */
int slow_tangent(const slow_disc *disc, int side, double x, double y, double time, double *heading, double *length);

/* An angle brought into (-pi, pi]; into [0, 2 pi). */
double slow_wrap(double angle);
double slow_wrap_positive(double angle);

/* A ride: `turned` is the angle since its begin, counted in its own sense. */
typedef struct slow_ride {
    size_t disc;
    int side;     /* +1 counter-clockwise */
    double angle; /* where it begins, seen from the centre */
    double time;  /* when */
} slow_ride;

typedef struct slow_moment {
    double x, y;
    double time;
    double heading; /* of the robot */
} slow_moment;

slow_moment slow_ride_at(const slow_world *world, const slow_ride *ride, double turned);

/* The angle turned up to a time. */
double slow_ride_turned(const slow_world *world, const slow_ride *ride, double time);

#endif
