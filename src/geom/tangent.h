/* SPDX-License-Identifier: MIT */
/*
 * Straight legs between two moving boundaries.
 *
 * A rider on disc i (side s) leaves at time t, heading along its boundary's tangent in space and time, and reaches disc j
 * tangentially (side q) after the length L. With D = O_j - O_i, alpha = s theta_i - q theta_j and the radii at time t,
 *
 *     K = R_i cos(alpha) - R_j          w = -q R_i sin(alpha)          k = K / |D|
 *     departure normal = arg(D) - rho q acos(k) + q theta_j - s theta_i
 *     L = (rho sqrt(|D|^2 - K^2) - w) / sin(theta_j)
 *
 * for both roots rho = +1, -1; the leg exists where |K| <= |D| and L >= 0. K and w are linear in t, and
 * |D|^2 - K^2 - w^2 is a concave quadratic, so these times are closed form. Measured in the rider's sense, the angle h from
 * the rider to the departure point obeys
 *
 *     dh/dt = -rho sin(theta_i) sin(theta_j) L / (R_i sqrt(|D|^2 - K^2))
 *
 * which keeps its sign while L > 0: on each piece of the domain rho h falls, and has at most one root.
 * Derivation: docs/math/motion.md, 3.
 */
#ifndef GEOM_TANGENT_H
#define GEOM_TANGENT_H

#include "geom/disc.h"

/* One branch of the legs from one disc and side to another. */
typedef struct geom_tangent {
    const geom_disc *from;
    const geom_disc *to;
    int side;    /* s */
    int to_side; /* q */
    int root;    /* rho */
    double distance;
    double farthest;   /* |D| as far as rounding may have it: the ends of the domain are closed */
    double bearing;    /* arg(D) */
    double cos_alpha;
    double sin_alpha;
    double k_start; /* K = k_start + k_slope t: the same to the bit all the time where the slope is 0. Near |k| = 1 the rounding of two radii would be 1e-8 of acos(k) */
    double k_slope;
} geom_tangent;

/* What two discs have in common for all their branches. */
typedef struct geom_pair {
    const geom_disc *from;
    const geom_disc *to;
    double distance;
    double farthest;
    double bearing;
} geom_pair;

geom_pair pair_make(const geom_disc *from, const geom_disc *to);
geom_tangent tangent_make(const geom_pair *pair, int side, int to_side, int root);

/* Can this branch have legs at all between these times? Cheap and safe: no means none. */
int tangent_possible(const geom_tangent *tangent);

/* The times in [t0, t1] at which the leg exists, as up to two intervals ends[0..1], ends[2..3]; returns how many. */
int tangent_domain(const geom_tangent *tangent, double t0, double t1, double ends[4]);

/* The direction of the leg for a departure at `time` inside the domain. */
double tangent_heading(const geom_tangent *tangent, double time);

/* The leg's length for a departure at `time` inside the domain, not negative. */
double tangent_length(const geom_tangent *tangent, double time);

/* A leg as a rider takes it: his normal, the leg's direction, and its length, not negative. */
typedef struct geom_leg {
    double normal;
    double heading;
    double length;
} geom_leg;

/*
 * The leg at a departure that was solved for, `angle` being where the ride itself says the rider is. Of the ride and the departure point
 * the one decides that moves less in an ulp of time: on a pebble the ride spins, near |k| = 1 the departure point does. There sqrt(|D|^2 - K^2) is lost to
 * rounding, by up to 1e-8. What the ride says is not: with the arrival normal n_j that its heading leads to, rho sqrt(|D|^2 - K^2) = -q D x n_j.
 * TANGENT_NONE is its length where that lies behind by more than a touch and the place where a rounding of the time turns the ride to: a pebble on the other's boundary, which its
 * rider leaves for somewhere else on it.
 */
#define TANGENT_NONE (-1.0)
geom_leg tangent_leg(const geom_tangent *tangent, double angle, double time);

/*
 * The first time in [t0, t1] at which a rider, who is at the normal `angle` at t0 and rides until t1, meets the departure
 * point: stored in *leave. Returns 0 when there is none.
 */
int tangent_leave(const geom_tangent *tangent, double angle, double t0, double t1, double *leave);

/* The same for the first root between discs that are apart all the time, where the leg exists all the time. */
int tangent_leave_apart(const geom_tangent *tangent, double angle, double t0, double t1, double *leave);

#endif
