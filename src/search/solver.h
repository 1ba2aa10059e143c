/* A solver: one thread's workspace for one scene. */
#ifndef SEARCH_SOLVER_H
#define SEARCH_SOLVER_H

#include "search/engine.h"
#include "tdsp/solver.h"

struct tdsp_solver {
    const tdsp_scene *scene;
    disc_engine engine;
    tdsp_leg *path; /* of the last answer, in the user's units */
    size_t path_count, path_capacity;
    int has_path;
    struct gap_event *gaps; /* candidates of the question under way */
    size_t gap_count, gap_capacity;
    tdsp_solver_work work;
};

/* A(t) in the user's units, without keeping the path. As tdsp_earliest_arrival() otherwise. */
tdsp_status solver_forward(tdsp_solver *solver, double departure, double *arrival);

/* Keep the path that the last forward search found for this departure. */
tdsp_status route_keep(tdsp_solver *solver, double departure, double arrival);

#endif
