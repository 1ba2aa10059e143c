/* SPDX-License-Identifier: MIT */
/* A scene of examples/, with a solver, for tests that ask it questions. */
#ifndef SUPPORT_EXAMPLE_H
#define SUPPORT_EXAMPLE_H

#include "tdsp/scene_file.h"
#include "tdsp/solver.h"

typedef struct example {
    SceneFile file;
    const tdsp_journey *journey;
    const tdsp_disc *discs;
    size_t count;
    tdsp_solver *solver;
} example;

/* Both are made or the test fails. */
example example_load(const char *path);
void example_free(example *e);

/* A(t), infinite where there is no way, and T(t). */
double example_arrival(const example *e, double departure);
double example_travel_time(const example *e, double departure);

/* A(t), and the slow solver says so too. */
double example_agreed_arrival(const example *e, double departure);

/* The latest departure that arrives by a time, and the last of all. */
double example_latest(const example *e, double by);
double example_last(const example *e);

#endif
