/* SPDX-License-Identifier: MIT */
/*
 * Properties over random scenes: a loop over every mix, a solver for each scene, and the scene in full when a property fails.
 *
 * TDSP_PROPERTY_SCENES multiplies the number of scenes (default 1), TDSP_PROPERTY_SEED moves all seeds (default 0),
 * TDSP_PROPERTY_MIX names the one mix to try (default: all).
 */
#ifndef SUPPORT_PROPERTY_H
#define SUPPORT_PROPERTY_H

#include <stddef.h>
#include <stdint.h>

#include "support/random_scene.h"
#include "tdsp/scene.h"
#include "tdsp/solver.h"

typedef struct property_case {
    const char *name; /* of the mix */
    uint64_t seed;
    size_t count;
    tdsp_journey journey;
    tdsp_disc discs[RANDOM_MOST_DISCS];
    tdsp_scene *scene;
    tdsp_solver *solver;
    double unit;     /* |sd| / speed */
    uint64_t chance; /* for the property's own choices */
} property_case;

/* Call `check` with `scenes` scenes of each mix (times TDSP_PROPERTY_SCENES), of 1 to `most` discs. */
void property_each(int scenes, size_t most, void (*check)(property_case *c));

/* The scene and solver of a case made by hand; property_drop() frees them. */
void property_prepare(property_case *c);
void property_drop(property_case *c);

/* A(t) by the engine, infinite without a path; any other status fails. */
double property_arrival(property_case *c, double departure);

/* Print the case and fail. */
void property_fail(const property_case *c, const char *text, double a, double b, const char *file, int line);

#define property_holds(c, condition)                                                                                             \
    do {                                                                                                                         \
        if (!(condition)) property_fail((c), #condition, 0.0, 0.0, __FILE__, __LINE__);                                          \
    } while (0)

/* The same with two numbers that say why. */
#define property_relates(c, a, relation, b)                                                                                      \
    do {                                                                                                                         \
        const double relates_a = (a), relates_b = (b);                                                                           \
        if (!(relates_a relation relates_b)) property_fail((c), #a " " #relation " " #b, relates_a, relates_b, __FILE__, __LINE__); \
    } while (0)

/* Check the path of the solver's last answer with the verifier. */
void property_path_is_good(property_case *c, double departure, double arrival);

#endif
