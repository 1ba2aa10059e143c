/* SPDX-License-Identifier: MIT */
/*
 * How far the library's answers to one scene are from those of the precise solver (slow/precise.h), as docs/numerics.md states them:
 *
 *   error   of an arrival: what is left of |A - A*| after the rounding of departure and arrival, as a share of travel time plus |sd| / v
 *   touch   the least share eta for which A lies between the A* of the scene with all discs smaller by eta and the A* of the one with all larger: 0 where
 *           the error alone is within its bound. A disc's share is of |sd| plus its radius as the robot arrives
 *
 * A is monotone in the radii, so an answer is right, for radii that are off by less than eta, exactly where it lies between these two.
 */
#ifndef NUMERICS_MEASURE_H
#define NUMERICS_MEASURE_H

#include <stddef.h>
#include <stdint.h>

#include "tdsp/scene.h"
#include "tdsp/solver.h"
#include "tdsp/types.h"

/* The bounds that are stated. */
#define BOUND_ERROR TDSP_SOLVER_ERROR
#define BOUND_TOUCH 1e-11

typedef struct measured {
    size_t scenes, arrivals, departures, tables;
    size_t touches;         /* answers for which the error alone was over its bound */
    size_t given_up;        /* the precise solver found the scene too large */
    double roundings;       /* |A - A*| in units of 2^-52 (t + A), the worst of arrivals */
    double error, touch;    /* the worst of arrivals */
    double late, early;     /* latest departures: the worst, as errors of an arrival */
    double depart_touch;
    double fall;            /* of travel times over growing departures: the worst */
    double depth;           /* of a path in a disc, as a share of the verifier's tolerance */
    double outside;         /* of a table's interval: the worst by which A* lies outside */
    char worst[256];        /* the question of the worst answer beyond a bound; empty where there is none */
    double worst_ratio;     /* to its bound */
} measured;

typedef struct numeric_case {
    const char *name;
    uint64_t seed, chance;
    size_t count;
    tdsp_journey journey;
    const tdsp_disc *discs;
    double first; /* departures of interest begin here */
    double unit;  /* |sd| / v */
    tdsp_scene *scene;
    tdsp_solver *solver;
    measured *into;
} numeric_case;

/* Ask the library about a scene and add what is found. Prints what is beyond a bound. */
void measure_scene(numeric_case *c, int questions);

#endif
