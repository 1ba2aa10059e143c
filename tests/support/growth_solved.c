/* See growth_solved.h. */
#include "support/growth_solved.h"

#include "support/chance.h"
#include "support/cmocka_all.h"
#include "tdsp/growth.h"
#include "tdsp/verify.h"

#define MOST_LEGS 4096

growth_solved growth_solve_scene(growth_case *c, const growth_scene *scene)
{
    growth_solved solved = {.c = c, .unit = scene->unit};
    growth_holds(c, tdsp_scene_create_growing(&scene->journey, scene->discs, scene->count, NULL, &solved.scene) == TDSP_OK);
    growth_holds(c, tdsp_solver_create(solved.scene, &solved.solver) == TDSP_OK);
    solved.valid = tdsp_scene_valid_until(solved.scene, NULL);
    return solved;
}

growth_solved growth_solve(growth_case *c)
{
    return growth_solve_scene(c, &c->scene);
}

void growth_drop(growth_solved *solved)
{
    tdsp_solver_free(solved->solver);
    tdsp_scene_free(solved->scene);
}

double growth_arrival(const growth_solved *solved, double departure)
{
    double arrival = INFINITY;
    const tdsp_status status = tdsp_earliest_arrival(solved->solver, departure, &arrival);
    if (status == TDSP_SHRINKS) {
        growth_holds(solved->c, solved->valid < INFINITY);
        return INFINITY;
    }
    if (!tdsp_status_is_answer(status)) growth_fail(solved->c, tdsp_status_name(status), departure, arrival, __FILE__, __LINE__);
    growth_holds(solved->c, (status == TDSP_OK) == (arrival < INFINITY));
    return arrival;
}

void growth_path_is_good(const growth_solved *solved, double departure, double arrival)
{
    static tdsp_leg legs[MOST_LEGS];
    size_t count;
    tdsp_verdict verdict;
    growth_holds(solved->c, tdsp_solver_path(solved->solver, legs, MOST_LEGS, &count) == TDSP_OK);
    growth_holds(solved->c, tdsp_verify_path(solved->scene, legs, count, departure, arrival, &verdict) == TDSP_OK);
    if (verdict.problems)
        growth_fail(solved->c, "the verifier rejects the path", departure, verdict.min_clearance, __FILE__, __LINE__);
}

double growth_departure(growth_case *c, int number)
{
    if (number == 0) return 0.0;
    return c->scene.unit * chance_between(&c->chance, 0.0, number == 1 ? 2.5 : 1.0);
}
