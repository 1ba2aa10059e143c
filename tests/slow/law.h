/* SPDX-License-Identifier: MIT */
/*
 * A second opinion on A(t) for any growth law: slow, written for its argument, for a handful of discs. It shares no code with the
 * library, nor with the slow solver for discs of one rate (slow.h), whose argument it extends, but how a zero is bracketed.
 *
 * Write the robot's speed as 1. Along a straight motion x(T) the square |x - O|^2 - T^2 is linear in T, so against one disc the motion
 * is a line in the plane of time and height, and free of the disc where that line is not below g(T) = R(T)^2 - T^2. Everything about
 * one disc and one line follows from where g is concave:
 *
 *   - a line is highest under g inside a concave stretch, or at an end of a stretch, so that is where a leg is tested;
 *   - a line that comes from above touches g inside a concave stretch, where R' = u . n at the contact, or at a kink where the rate
 *     falls, with R' after <= u . n <= R' before. For a given point and moment there is one such contact a stretch and side at most: D^2 =
 *     R^2 - 2 l R R' + l^2 (l the leg's length, D the distance of the centre) grows with the contact's time;
 *   - a rider whose disc's g is convex ahead does better to leave it straight and to touch it again later: a disc is a target of
 *     its own riders, in its later stretches;
 *   - at a kink where the rate falls a rider can leave in any direction between the two tangents.
 *
 * So the moves are: straight legs to a stretch or kink of any disc, on either side, and to the destination; rides along a boundary while
 * R' < 1. Rides are sampled for the moments at which their own direction is that of such a leg, and these moments are found by halving. All
 * that can be reached is explored in the order of time plus the straight way left. Whatever is told as an arrival is that of a motion
 * which was tested against every disc; nothing is left out but a ride that begins where, and not before, an earlier one could have been.
 */
#ifndef SLOW_LAW_H
#define SLOW_LAW_H

#include <stddef.h>

#include "tdsp/growth.h"
#include "tdsp/scene.h"
#include "tdsp/types.h"

#define SLOW_LAW_DISCS 16

/* Radius (without the robot's), its first and its second derivative, which only has to have the right sign and size. */
typedef struct slow_jet {
    double radius, rate, bend;
} slow_jet;

/* A disc whose law is smooth but at its breaks. */
typedef struct slow_law_disc {
    tdsp_point center;
    slow_jet (*jet)(const void *ctx, size_t piece, double time); /* of the given piece, up to both its ends */
    const void *ctx;
    const double *breaks; /* piece k ends at breaks[k], over 0, increasing */
    size_t break_count;
} slow_law_disc;

/* The same disc for the library and for this solver. A law by callback is differenced for its second derivative. `disc` is kept. */
slow_law_disc slow_law_of(const tdsp_growing_disc *disc);

#define SLOW_LAW_LINE ((size_t)-1)

/* A place on a path, and how the path goes on from there: riding on a disc, or straight. Rides have a place for every few degrees. */
typedef struct slow_law_place {
    tdsp_point at;
    double time;
    size_t disc; /* SLOW_LAW_LINE for a straight line */
    int side;    /* of a ride: +1 counter-clockwise */
} slow_law_place;

/*
 * The earliest arrival of those up to the time `until` (finite; no radius shrinks before), infinite when there is none; NAN when the
 * search was given up as too large. Relative error about 1e-10.
 */
double slow_law_arrival(const tdsp_journey *journey, const slow_law_disc *discs, size_t count, double until, double departure);

/* The same with its path from the source to the destination: up to `capacity` places, their number in *place_count (0 without an arrival). */
double slow_law_path(const tdsp_journey *journey, const slow_law_disc *discs, size_t count, double until, double departure,
                     slow_law_place *places, size_t capacity, size_t *place_count);

#endif
