/* SPDX-License-Identifier: MIT */
/* A solver: one thread's workspace for one scene. */
#ifndef SEARCH_SOLVER_H
#define SEARCH_SOLVER_H

#include "growth/growth.h"
#include "search/enclosure.h"
#include "search/relax.h"
#include "tdsp/solver.h"

struct tdsp_solver {
    const tdsp_scene *scene;
    scene_ends ends; /* of the question under way */
    tdsp_method method;
    growth_solver *growth; /* for scenes whose rates change, or when asked for; else NULL */
    disc_engine engine;
    relaxation relaxation;
    enclosure enclosure;
    int is_enclosed; /* the last forward search found the destination walled in */
    uint64_t patience; /* of searches among all discs: give up after so many chunks of rides; 0: never */
    tdsp_leg *path; /* of the last answer, in the user's units */
    size_t path_count, path_capacity;
    int has_path;
    struct gap_event *gaps; /* candidates of the question under way */
    size_t gap_count, gap_capacity;
    tdsp_solver_work work;
};

/*
 * A(t) among the discs of a set, as far as it is not after `until`, the engine keeping the path: TDSP_OK with *arrival, in the user's
 * units; TDSP_SOURCE_COVERED; TDSP_CUT_OFF for any other reason; or an error.
 */
tdsp_status solver_forward(tdsp_solver *solver, const disc_set *set, double departure, double until, double *arrival);

/* The engine's question behind solver_forward(). */
engine_question solver_forward_question(const tdsp_solver *solver, double departure);

/* A time of the frame in a search that began at `began` for this departure, in the user's units. */
double solver_time_of(const tdsp_solver *solver, double departure, double began, double time);

/* As solver_forward() among all discs, by relaxation. */
tdsp_status solver_arrival(tdsp_solver *solver, double departure, double *arrival);

/*
 * tdsp_latest_departure() where A(after) <= arrival < A(before) is known, which leaves it less to search. *arrives and the path are those of
 * *departure unless that is `after` itself.
 */
tdsp_status solver_departure_between(tdsp_solver *solver, double arrival, double after, double before, double *departure, double *arrives);

/*
 * tdsp_latest_departure() where the last departure from which a path arrives exactly at `arrival`, or as late as the destination is free, is known: not
 * later than that; negative where there is none.
 */
tdsp_status solver_departure_at(tdsp_solver *solver, double arrival, double candidate, double *departure, double *arrives);

/* The engine's question backwards in time from the destination, at a time of the frame: to the source, as far as it is free. */
engine_question solver_reverse_question(const tdsp_solver *solver, double time, double limit);

/* Such a question among the discs of a set: the latest departure, as a time of the frame, or a negative number. */
tdsp_status solver_reverse(tdsp_solver *solver, const disc_set *set, const engine_question *question, double *departure);

/* Why there is no way right after the last departure, which the caller knows. */
tdsp_status solver_last_reason(tdsp_solver *solver, double last, tdsp_status *reason);

/* Where the path kept is touched by two discs at one moment, on either hand. TDSP_OK, or TDSP_NO_ANSWER where it is not. */
tdsp_status solver_pinch(const tdsp_solver *solver, tdsp_gap *out);

/* Is something too many journeys away for an answer: this time, in a scene where something grows, or a disc? */
int solver_is_far(const tdsp_solver *solver, double time);

/* What to tell of A(t) after a search with this answer: keeps the path, or finds out why there is no way. An answer or an error. */
tdsp_status solver_conclude(tdsp_solver *solver, double departure, double arrival, tdsp_status answer);

/* Keep the path that the last forward search found for this departure. */
tdsp_status route_keep(tdsp_solver *solver, double departure, double arrival);

#endif
