/* SPDX-License-Identifier: MIT */
/*
 * The number that the slow solver for constant rates counts in.
 *
 * It is compiled twice: with double, and with SLOW_PRECISE and long double under other names (slow/precise.h). Every tolerance is a share of
 * the number's own rounding, so the precise one tells apart what the other, and the library, cannot.
 */
#ifndef SLOW_REAL_H
#define SLOW_REAL_H

#include <float.h>

#ifdef SLOW_PRECISE
typedef long double slow_real;
#define SLOW_EPSILON LDBL_EPSILON
#define slow_arrival precise_arrival
#define slow_path precise_path
#define slow_departure precise_departure
#define slow_world_make precise_world_make
#define slow_radius precise_radius
#define slow_clearance precise_clearance
#define slow_slack precise_slack
#define slow_point_free precise_point_free
#define slow_line_free precise_line_free
#define slow_tangent precise_tangent
#define slow_wrap precise_wrap
#define slow_wrap_positive precise_wrap_positive
#define slow_ride_at precise_ride_at
#define slow_ride_turned precise_ride_turned
#define slow_ride_free precise_ride_free
#define slow_ride_leaves precise_ride_leaves
#else
typedef double slow_real;
#define SLOW_EPSILON DBL_EPSILON
#endif

#define SLOW_PI ((slow_real)3.14159265358979323846264338327950288L)

#endif
