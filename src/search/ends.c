/* SPDX-License-Identifier: MIT */
/* Questions about other ends than the scene's own: the solver holds those that it is asked about. */
#include "search/solver.h"

tdsp_status tdsp_solver_set_ends(tdsp_solver *solver, const tdsp_ends *ends)
{
    if (!solver) return TDSP_INVALID_ARGUMENT;
    if (ends) return scene_ends_make(solver->scene, ends, &solver->ends);
    solver->ends = solver->scene->ends;
    return TDSP_OK;
}

tdsp_status tdsp_solver_ends(const tdsp_solver *solver, tdsp_ends *out)
{
    if (!solver || !out) return TDSP_INVALID_ARGUMENT;
    *out = solver->ends.given;
    return TDSP_OK;
}

tdsp_status tdsp_earliest_arrival_for(tdsp_solver *solver, const tdsp_ends *ends, double departure, double *arrival)
{
    if (!solver) return TDSP_INVALID_ARGUMENT;
    const scene_ends before = solver->ends;
    tdsp_status status = tdsp_solver_set_ends(solver, ends);
    if (status == TDSP_OK) status = tdsp_earliest_arrival(solver, departure, arrival);
    solver->ends = before;
    return status;
}

tdsp_status tdsp_latest_departure_for(tdsp_solver *solver, const tdsp_ends *ends, double arrival, double *departure, double *arrives)
{
    if (!solver) return TDSP_INVALID_ARGUMENT;
    const scene_ends before = solver->ends;
    tdsp_status status = tdsp_solver_set_ends(solver, ends);
    if (status == TDSP_OK) status = tdsp_latest_departure(solver, arrival, departure, arrives);
    solver->ends = before;
    return status;
}
