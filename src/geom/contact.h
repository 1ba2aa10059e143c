/* SPDX-License-Identifier: MIT */
/*
 * Who runs into whom: straight motions and rides against discs.
 *
 * A straight motion x(t) = p + u t meets a disc where f(t) = |x - O|^2 - R^2 < 0, a quadratic with leading coefficient 1 - c^2: its
 * least value decides. For |c| >= 1 it is concave, and the ends decide. A ride has no such closed form; see
 * ride_contact().
 */
#ifndef GEOM_CONTACT_H
#define GEOM_CONTACT_H

#include "geom/disc.h"

/* Uniform motion from `from` at `start`, with the unit heading, for `length` (= duration). */
typedef struct geom_line {
    tdsp_point from;
    tdsp_point heading;
    double start;
    double length;
} geom_line;

/* Does the motion enter the disc by more than a touch? */
int line_blocked(const geom_line *line, const geom_disc *disc);

/* The length after which it first enters the disc; infinite when it does not. */
double line_first_contact(const geom_line *line, const geom_disc *disc);

/* A ride on `disc` over [start, end], at the normal `angle` at start. */
typedef struct geom_ride {
    const geom_disc *disc;
    int side;
    double angle;
    double start;
    double end;
} geom_ride;

/* Where the rider is at a time: its normal. */
double ride_angle(const geom_ride *ride, double time);
tdsp_point ride_position(const geom_ride *ride, double time);

/* The first time at which the ride enters `other` by more than a touch; infinite when it does not. */
double ride_contact(const geom_ride *ride, const geom_disc *other);

/*
 * Does the ride pass `other`, which lies on the other side of its way, in no more than a touch, in either sense? *time: when it is nearest. Then the leg from the one
 * to the other has shrunk to nothing, and rounding decides whether it exists.
 */
int ride_touch(const geom_ride *ride, const geom_disc *other, double *time);

#endif
