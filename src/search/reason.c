/* Why there is no way: the rule is in reason.h. */
#include "search/reason.h"

#include "tdsp/growth.h"

/* A search for the reason ends at this many times the times at hand: departure, cover of the destination, and journey. */
#define EXPLAIN_TIME 64.0

/* The discs are looked at this share of the times at hand before the destination is covered, so that it is free for certain. */
#define JUST_BEFORE 1e-9

/*
 * Is a robot on its way stopped by nothing but the destination's cover? This is asked among all discs at once: among fewer, what stops it first may be
 * a disc that stands behind the cover.
 */
static tdsp_status stopped_by_cover(tdsp_solver *solver, double departure, int *open)
{
    if (solver->growth) return growth_explain(solver->growth, &solver->ends, departure, open);
    engine_question why = solver_forward_question(solver, departure);
    why.explain = 1;
    why.limit = EXPLAIN_TIME * (point_distance(why.start, why.goal) + fabs(why.time) + fabs(why.goal_until));
    tdsp_status status = engine_run(&solver->engine, &solver->scene->all, &why);
    *open = status == TDSP_OK && solver->engine.arrived != ENGINE_NONE;
    return status;
}

/* The discs as they are at a time, as a scene of their own. */
static tdsp_status scene_at(const tdsp_solver *solver, double time, tdsp_scene **still)
{
    const tdsp_scene *scene = solver->scene;
    const tdsp_journey journey = {scene->journey.speed, scene->journey.radius, solver->ends.given.source, solver->ends.given.destination};
    tdsp_disc *discs = memory_array(&scene->allocator, scene->count, sizeof *discs);
    if (!discs) return TDSP_NO_MEMORY;
    for (size_t i = 0; i < scene->count; ++i) {
        discs[i] = scene->discs[i];
        (void)tdsp_scene_disc_at(scene, (uint32_t)i, time, &discs[i].radius, NULL);
        discs[i].growth = 0.0;
    }
    tdsp_status status = tdsp_scene_create(&journey, discs, scene->count, &scene->allocator, still);
    memory_free(&scene->allocator, discs, scene->count * sizeof *discs);
    return status;
}

/* Is there a way from the source to the destination in a scene where nothing grows? */
static tdsp_status still_open(const tdsp_scene *still, int *open)
{
    tdsp_solver *solver;
    double arrival = INFINITY;
    tdsp_status status = tdsp_solver_create(still, &solver);
    if (status != TDSP_OK) return status;
    status = solver_arrival(solver, 0.0, &arrival);
    tdsp_solver_free(solver);
    *open = status == TDSP_OK;
    return tdsp_status_is_answer(status) ? TDSP_OK : status;
}

static tdsp_status open_at_last_moment(const tdsp_solver *solver, int *open)
{
    double last = solver->ends.destination_cover.time;
    double before = last - JUST_BEFORE * (solver->ends.time + last);
    tdsp_scene *still;
    *open = 0;
    if (!(before >= 0.0) || isinf(last)) return TDSP_OK;
    tdsp_status status = scene_at(solver, before, &still);
    if (status != TDSP_OK) return status;
    status = still_open(still, open);
    tdsp_scene_free(still);
    return status;
}

tdsp_status reason_find(tdsp_solver *solver, double departure, tdsp_status *reason)
{
    int open, enclosed = 0;
    tdsp_status status = TDSP_OK;
    if (!solver->growth) status = enclosure_test(&solver->enclosure, &solver->engine, &solver->ends, departure / solver->scene->time, &enclosed);
    if (status != TDSP_OK) return status;
    if (enclosed) {
        *reason = TDSP_CUT_OFF;
        return TDSP_OK;
    }
    status = stopped_by_cover(solver, departure, &open); /* mostly the cheaper of the two */
    if (status == TDSP_OK && !open) status = open_at_last_moment(solver, &open);
    if (status == TDSP_OK) *reason = open ? TDSP_DESTINATION_COVERED : TDSP_CUT_OFF;
    return status;
}
