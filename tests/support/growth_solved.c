/* SPDX-License-Identifier: MIT */
/* See grown_solved.h. */
#include "support/growth_solved.h"

#include "support/chance.h"
#include "support/cmocka_all.h"
#include "tdsp/growth.h"
#include "tdsp/verify.h"

#define MOST_LEGS 4096

grown_solved grown_solve_scene(grown_case *c, const grown_scene *scene)
{
    grown_solved solved = {.c = c, .unit = scene->unit};
    grown_holds(c, tdsp_scene_create_growing(&scene->journey, scene->discs, scene->count, NULL, &solved.scene) == TDSP_OK);
    grown_holds(c, tdsp_solver_create(solved.scene, &solved.solver) == TDSP_OK);
    solved.valid = tdsp_scene_valid_until(solved.scene, NULL);
    return solved;
}

grown_solved grown_solve(grown_case *c)
{
    return grown_solve_scene(c, &c->scene);
}

void grown_drop(grown_solved *solved)
{
    tdsp_solver_free(solved->solver);
    tdsp_scene_free(solved->scene);
}

double grown_arrival(const grown_solved *solved, double departure)
{
    double arrival = INFINITY;
    const tdsp_status status = tdsp_earliest_arrival(solved->solver, departure, &arrival);
    if (status == TDSP_SHRINKS) {
        grown_holds(solved->c, solved->valid < INFINITY);
        return INFINITY;
    }
    if (!tdsp_status_is_answer(status)) grown_fail(solved->c, tdsp_status_name(status), departure, arrival, __FILE__, __LINE__);
    grown_holds(solved->c, (status == TDSP_OK) == (arrival < INFINITY));
    return arrival;
}

void grown_path_is_good(const grown_solved *solved, double departure, double arrival)
{
    static tdsp_leg legs[MOST_LEGS];
    size_t count;
    tdsp_verdict verdict;
    grown_holds(solved->c, tdsp_solver_path(solved->solver, legs, MOST_LEGS, &count) == TDSP_OK);
    grown_holds(solved->c, tdsp_verify_path(solved->scene, legs, count, departure, arrival, &verdict) == TDSP_OK);
    if (verdict.problems)
        grown_fail(solved->c, "the verifier rejects the path", departure, verdict.min_clearance, __FILE__, __LINE__);
}

double grown_departure(grown_case *c, int number)
{
    if (number == 0) return 0.0;
    return c->scene.unit * chance_between(&c->chance, 0.0, number == 1 ? 2.5 : 1.0);
}
