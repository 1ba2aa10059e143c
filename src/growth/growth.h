/* SPDX-License-Identifier: MIT */
/*
 * Questions to the engine for changing rates: the face that the solver sees.
 *
 * Relaxation as in src/search/relax.h: the best path among some discs is a bound on the one among all, so discs join as a path runs into them.
 * Times are in the user's units.
 */
#ifndef GROWTH_GROWTH_H
#define GROWTH_GROWTH_H

#include "growth/engine.h"
#include "scene/scene.h"
#include "tdsp/solver.h"

typedef struct growth_solver {
    const tdsp_scene *scene;
    growth_engine engine;
    unsigned char *is_member;
    uint64_t rounds; /* questions put to a part of the discs */
} growth_solver;

/* TDSP_OK or TDSP_NO_MEMORY. Scenes whose discs all grow at one rate will do, too. O(pieces). */
tdsp_status growth_create(const tdsp_scene *scene, growth_solver **out);
void growth_free(growth_solver *self);
uint64_t growth_bytes(const growth_solver *self);

/* Add the labels, legs tested and rounds so far to a solver's counters. */
void growth_add_work(const growth_solver *self, tdsp_solver_work *work);

/* The earliest arrival: TDSP_OK; TDSP_CUT_OFF when there is no way, for whatever reason, as is clear from the discs up to *looked_until; TDSP_NO_MEMORY. The source is free at the departure. */
tdsp_status growth_arrival(growth_solver *self, const scene_ends *ends, double departure, double *arrival, double *looked_until);

/* Let the last answer be one without a path. */
void growth_forget(growth_solver *self);

/* When the last law stops growing; infinite where one never does, however slowly. */
double growth_still_from(const growth_solver *self);

/* The latest departure whose path, without waiting, ends exactly at this arrival; negative when there is none. TDSP_OK or TDSP_NO_MEMORY. */
tdsp_status growth_departure(growth_solver *self, const scene_ends *ends, double arrival, double *departure);

/* Is a robot on its way stopped by a disc that covers the destination by then? Asked among all discs. TDSP_OK or TDSP_NO_MEMORY. */
tdsp_status growth_explain(growth_solver *self, const scene_ends *ends, double departure, int *is_open);

/* The path of the last arrival: its legs in order of time, appended to *legs. TDSP_OK or TDSP_NO_MEMORY. */
typedef struct growth_path {
    tdsp_leg *legs;
    size_t count, capacity;
} growth_path;

tdsp_status growth_route(growth_solver *self, const scene_ends *ends, double departure, double arrival, growth_path *out);

#endif
