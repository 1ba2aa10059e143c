/* SPDX-License-Identifier: MIT */
/* The library's answers in random scenes of every growth law. */
#ifndef SUPPORT_GROWTH_SOLVED_H
#define SUPPORT_GROWTH_SOLVED_H

#include "support/growth_property.h"
#include "tdsp/solver.h"

typedef struct grown_solved {
    grown_case *c; /* for messages */
    tdsp_scene *scene;
    tdsp_solver *solver;
    double valid; /* up to when no radius shrinks */
    double unit;  /* |sd| / speed */
} grown_solved;

/* The scene of the case, or another one made from it, with a solver; any failure fails the test. */
grown_solved grown_solve(grown_case *c);
grown_solved grown_solve_scene(grown_case *c, const grown_scene *scene);
void grown_drop(grown_solved *solved);

/* A(t): infinite where there is no way, and where the answer lies after the time up to which no radius shrinks. */
double grown_arrival(const grown_solved *solved, double departure);

/* Check the path of the last answer with the verifier. */
void grown_path_is_good(const grown_solved *solved, double departure, double arrival);

/* Departures: 0, any, and some that are too late. */
double grown_departure(grown_case *c, int number);

#endif
