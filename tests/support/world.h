/* SPDX-License-Identifier: MIT */
/* A scene with a solver, for tests that ask it questions. */
#ifndef SUPPORT_WORLD_H
#define SUPPORT_WORLD_H

#include "tdsp/solver.h"

typedef struct world {
    tdsp_scene *scene;
    tdsp_solver *solver;
    double unit; /* the time of the straight line */
} world;

/* Both are made or the test fails. */
world world_make(tdsp_journey journey, const tdsp_disc *discs, size_t count);
void world_free(world w);

/* A(departure), infinite where there is no way; an error fails the test. */
double world_arrival(world w, double departure);

#endif
