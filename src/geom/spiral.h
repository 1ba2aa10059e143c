/* SPDX-License-Identifier: MIT */
/*
 * Riding a disc's boundary. The tangential speed is sin(theta), so the angle turned obeys d(angle)/dt = sin(theta) / R(t):
 *
 *     angle = sin(theta) / c * ln(R1 / R0)        for R = R0 + c (t - t0)
 *
 * a logarithmic spiral, and an arc of a circle as c -> 0. Both forms below stay accurate through c = 0.
 */
#ifndef GEOM_SPIRAL_H
#define GEOM_SPIRAL_H

#include "geom/disc.h"

/* The angle turned from t0 to t1. The radius at t0 is over 0. */
double spiral_angle(const geom_disc *disc, double t0, double t1);

/* How long a ride from t0 takes to turn by `angle` >= 0; infinite where a shrinking disc never lets it. */
double spiral_duration(const geom_disc *disc, double t0, double angle);

#endif
