/* The library's answers in random scenes of every growth law. */
#ifndef SUPPORT_GROWTH_SOLVED_H
#define SUPPORT_GROWTH_SOLVED_H

#include "support/growth_property.h"
#include "tdsp/solver.h"

typedef struct growth_solved {
    growth_case *c; /* for messages */
    tdsp_scene *scene;
    tdsp_solver *solver;
    double valid; /* up to when no radius shrinks */
    double unit;  /* |sd| / speed */
} growth_solved;

/* The scene of the case, or another one made from it, with a solver; any failure fails the test. */
growth_solved growth_solve(growth_case *c);
growth_solved growth_solve_scene(growth_case *c, const growth_scene *scene);
void growth_drop(growth_solved *solved);

/* A(t): infinite where there is no way, and where the answer lies after the time up to which no radius shrinks. */
double growth_arrival(const growth_solved *solved, double departure);

/* Check the path of the last answer with the verifier. */
void growth_path_is_good(const growth_solved *solved, double departure, double arrival);

/* Departures: 0, any, and some that are too late. */
double growth_departure(growth_case *c, int number);

#endif
