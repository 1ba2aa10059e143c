/* SPDX-License-Identifier: MIT */
/*
 * A leg as a motion in the plane: the verifier's own reading of tdsp/types.h, written without a look at the engine's.
 *
 * With x in [0, 1] the share of the leg's duration, a line is from + (to - from) x. On an arc the distance from the centre
 * is r = r0 + (r1 - r0) x and the direction is a0 + turn * sweep * ln(1 + q x) / ln(1 + q), q = (r1 - r0) / r0. Its radial
 * rate is r1 - r0 a duration; its tangential rate r * d(angle)/dx = sweep * r0 * q / ln(1 + q) a duration. Both are
 * constant, so the speed is too, and the velocity turns at the rate (tangential rate) / r: that bounds the acceleration. Curves: curve.h.
 */
#ifndef VERIFY_MOTION_H
#define VERIFY_MOTION_H

#include "tdsp/types.h"

typedef struct motion {
    tdsp_leg leg;
    double duration;    /* time */
    double length;      /* of the way, a length; curve: no less than that */
    double speed;       /* length / duration; 0 where the duration is 0. Curve: the greatest */
    double tangential;  /* arc: the part of the speed across the radius */
    double growth;      /* arc: q */
    double log_growth;  /* arc: ln(1 + q) */
    double distance[6]; /* curve: Bernstein coefficients of the distance from the centre ... */
    double turned[6];   /* ... and of the angle turned, over the duration */
    double bend;        /* curve: no less than the acceleration */
} motion;

/* Is every number finite and in its range, so that motion_of() means something? */
int motion_well_formed(const tdsp_leg *leg);

/* Of a well-formed leg. */
motion motion_of(const tdsp_leg *leg);

/* Where the robot is at start_time + elapsed, 0 <= elapsed <= duration. */
tdsp_point motion_position(const motion *m, double elapsed);

/* Arc and curve: the distance from the centre then. */
double motion_radius(const motion *m, double elapsed);

/* The share of the duration that has passed. */
static inline double motion_share(const motion *m, double elapsed)
{
    if (!(m->duration > 0.0) || elapsed <= 0.0) return 0.0;
    return elapsed >= m->duration ? 1.0 : elapsed / m->duration;
}

/* A bound on the acceleration between two times. */
double motion_bend(const motion *m, double from, double to);

/*
 * Line: when a disc that grows evenly is nearest, as a time elapsed; NaN when it comes nearer all the time. With the distance h from the centre to the line that is
 * where the robot is h V / sqrt(w^2 - V^2) past the foot of the perpendicular, w being its speed: the slope of the clearance is zero there.
 */
double motion_nearest(const motion *m, tdsp_point center, double growth);

/* A circle that holds the whole motion. */
typedef struct motion_circle {
    tdsp_point center;
    double radius;
} motion_circle;

motion_circle motion_bound(const motion *m);

double motion_distance(tdsp_point a, tdsp_point b);

#endif
