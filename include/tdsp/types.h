/* SPDX-License-Identifier: MIT */
/*
 * Points, discs, legs of a path, and the allocator: the values that every audience shares.
 *
 * Lengths are in the scene's unit of length, times in its unit of time, angles in radians, counter-clockwise
 * from the x axis. The robot's top speed and growth rates are lengths per time.
 */
#ifndef TDSP_TYPES_H
#define TDSP_TYPES_H

#include <stddef.h>
#include <stdint.h>

#include "tdsp/export.h"

#ifdef __cplusplus
extern "C" {
#endif

/** A place in the plane. */
typedef struct tdsp_point {
    double x; /* length */
    double y; /* length */
} tdsp_point;

/** A disc that covers, at time t >= 0, everything closer to its centre than radius + growth * t. */
typedef struct tdsp_disc {
    tdsp_point center; /* length */
    double radius;     /* length, at t = 0, not negative; the robot's radius is not included */
    double growth;     /* length per time, not negative; any relation to the robot's speed */
} tdsp_disc;

/** Values of tdsp_leg.kind. */
#define TDSP_LEG_LINE 0u /* straight at the robot's top speed */
#define TDSP_LEG_ARC 1u  /* riding on a disc's boundary while it grows at one rate: a logarithmic spiral, or a circle */
#define TDSP_LEG_CURVE 2u /* the same while its rate changes: polynomials of degree 5 in the distance and the angle */

/** The disc index of a leg that rides on no disc. */
#define TDSP_NO_DISC 0xffffffffu

/**
 * One leg of a path: the robot's motion over [start_time, end_time]. The first leg of a path starts at its departure, each other
 * exactly when, and up to rounding where, the one before ends.
 *
 * A line is uniform motion from `from` to `to`. On an arc the robot is, at the share x in [0, 1] of the leg's
 * duration, at distance r = radius_from + (radius_to - radius_from) x from `center`, in the direction
 * angle_from + turn * sweep * ln(r / radius_from) / ln(radius_to / radius_from)   (turn * sweep * x where the
 * radii are equal). On a curve, distance and angle turned are the polynomials of degree 5 in time that have, at both ends, the given values
 * (radius_from and radius_to; 0 and sweep) and these first and second derivatives: rate and bend for the distance r; for the angle
 * w = sqrt(speed^2 - r'^2) / r and its derivative, as the robot's speed is what the distance leaves to the angle.
 * The members from `center` on are zero for a line, those from `rate_from` on for an arc.
 */
typedef struct tdsp_leg {
    uint32_t kind;       /* TDSP_LEG_LINE, TDSP_LEG_ARC or TDSP_LEG_CURVE */
    uint32_t disc;       /* index of the disc ridden, as added to the scene; TDSP_NO_DISC for a line */
    int32_t turn;        /* +1 counter-clockwise, -1 clockwise, 0 for a line */
    uint32_t reserved;   /* 0 */
    double start_time;   /* time */
    double end_time;     /* time, not before start_time */
    tdsp_point from;     /* where the robot is at start_time */
    tdsp_point to;       /* where it is at end_time */
    tdsp_point center;   /* arc and curve: centre of the disc */
    double radius_from;  /* arc and curve: distance from the centre at start_time, over 0 (robot's radius included) */
    double radius_to;    /* arc and curve: distance from the centre at end_time */
    double angle_from;   /* arc and curve: direction of `from` seen from the centre */
    double sweep;        /* arc and curve: angle turned, not negative */
    double rate_from;    /* curve: the distance's change per time at start_time */
    double rate_to;      /* curve: at end_time */
    double bend_from;    /* curve: the rate's change per time at start_time */
    double bend_to;      /* curve: at end_time */
    double speed;        /* curve: the robot's, over both rates */
} tdsp_leg;

/** A gap that closes, after which the earliest arrival jumps. */
typedef struct tdsp_gap {
    uint32_t first;   /* what closes: two discs of a scene, first < second, or whatever else an oracle numbers; both TDSP_NO_DISC where it is */
    uint32_t second;  /* not known, and then the other members are 0 */
    double time;      /* when the last robot to pass is touched by both */
    tdsp_point place; /* where */
} tdsp_gap;

/** What an oracle promises about A(t), the earliest arrival, and T(t) = A(t) - t. */
typedef enum tdsp_monotone {
    /* T never decreases, and a path for departure t, moved earlier, serves every earlier departure (growing discs). */
    TDSP_MONOTONE_TRAVEL = 0,
    /* A never decreases, and a robot that is early waits at the source (a FIFO road network). */
    TDSP_MONOTONE_ARRIVAL = 1
} tdsp_monotone;

/** What holds between the lower and the upper end of every answer. Values are stored in tables. */
typedef enum tdsp_guarantee {
    TDSP_GUARANTEE_TRAVEL = 0,  /* upper - t <= (1 + epsilon) (lower - t) */
    TDSP_GUARANTEE_ARRIVAL = 1, /* upper <= (1 + epsilon) lower */
    TDSP_GUARANTEE_ABSOLUTE = 2 /* upper - lower <= delta */
} tdsp_guarantee;

/** How rows are placed. Values are stored in tables. */
typedef enum tdsp_sampling {
    TDSP_SAMPLING_ADAPTIVE = 0,
    TDSP_SAMPLING_GEOMETRIC = 1 /* guarantee arrival only; needs A(0) > 0 */
} tdsp_sampling;

/**
 * Where memory comes from. `resize` behaves like realloc with the old size told: block NULL and old_size 0
 * allocate, new_size 0 frees and returns NULL, and a failure returns NULL and leaves the block as it was. The blocks
 * are aligned for any type. The allocator is copied by the object that is given it; `ctx` must outlive the object.
 * Wherever a `const tdsp_allocator *` is asked for, NULL means the C library's realloc and free.
 */
typedef struct tdsp_allocator {
    void *ctx; /* handed to resize */
    void *(*resize)(void *ctx, void *block, size_t old_size, size_t new_size); /* allocates, resizes and frees */
} tdsp_allocator;

/** The version of the linked library, "MAJOR.MINOR.PATCH". Static storage; any thread. Since 0.1. */
TDSP_API const char *tdsp_version(void);

#ifdef __cplusplus
}
#endif

#endif
