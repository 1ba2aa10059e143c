/* SPDX-License-Identifier: MIT */
/*
 * The hunt for the largest amount by which rates may rise.
 *
 * Let L(x) be the latest departure that arrives by the deadline in the scene raised by x. A robot that leaves at t arrives by it exactly when
 * t <= L(x). L falls, and where A jumps with x, L does not: let a path leave at L(x), arrive at A, and be moved earlier by e. At the time c - e it is where
 * discs had the radius R + V c before; discs that grow at V (1 + y) are no larger there when (1 + y) (c - e) <= c, and that is so all along the path when
 * it holds at c = A. So
 *
 *     L(x (1 + y))  >=  L(x) - A y / (1 + y)                                                                  (1)
 *
 * L is continuous in a factor x, and L(x) = t is found by secants, in u = 1 / x: where a gap closes at the radius c, the moment is c u / V. With
 * one value alone the next is the amount at which (1) reaches t: it does no harm for certain.
 *
 * The parameter p is the factor; for an added rate it is the rate of the fastest disc that rises, so that both are over 0, and 0 stands for no
 * growth.
 */
#ifndef MARGIN_HUNT_H
#define MARGIN_HUNT_H

#include "tdsp/margin.h"

typedef struct hunt_value {
    double p;
    double ahead; /* L(p) - t */
    double time;  /* of arrival on the path of L(p) */
} hunt_value;

typedef struct hunt {
    const tdsp_scene *scene;
    tdsp_raise how;
    double departure; /* t */
    double deadline;
    double slowest; /* of the rates below the cap; infinite where nothing grows */
    double fastest; /* likewise; 0 where nothing grows */
    double lo;      /* a parameter that does no harm */
    double hi;      /* one that does, or may: */
    int hi_known;
    hunt_value values[2]; /* the last two known, the newer one last */
    int value_count;
    int same; /* how often in a row lo (positive) or hi (negative) has moved */
    uint32_t scenes;
} hunt;

/* The times of the last departure are too far away, or after what the scene knows: A(t) need not be. */
static inline int hunt_is_far(tdsp_status status)
{
    return status == TDSP_NOT_SUPPORTED || status == TDSP_SHRINKS;
}

/* The amount that a parameter stands for. */
double hunt_amount(const hunt *self, double p);

/* The solver of the raised scene, which the caller frees with hunt_drop(). */
tdsp_status hunt_solver(hunt *self, double p, tdsp_solver **out);
void hunt_drop(tdsp_solver *solver);

/* Does A(t) in the solver's scene keep the deadline? *answer is the status of A(t), *arrival A(t). */
tdsp_status hunt_keeps(const hunt *self, tdsp_solver *solver, tdsp_status *answer, double *arrival, int *keeps);

/* Ask about p; lo or hi moves there. */
tdsp_status hunt_step(hunt *self, double p);

/* From lo that does no harm and hi that does, or may: narrow them down until no double matters. Where hi does no harm either, lo becomes hi. */
tdsp_status hunt_run(hunt *self);

#endif
