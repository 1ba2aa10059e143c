/* SPDX-License-Identifier: MIT */
/* Why there is no way: the rule is in reason.h. */
#include "search/reason.h"

#include "scene/growth.h"
#include "tdsp/growth.h"

/* A search for the reason ends at this many times the times at hand: departure, cover of the destination, and journey. */
#define EXPLAIN_TIME 64.0

/* The discs are looked at this share of the times at hand before the destination is covered, so that it is free for certain. */
#define JUST_BEFORE 1e-9

/* The proof that a departure is the last looks this share of the times at hand past it. */
#define RIGHT_AFTER 2e-9

/* Halving leaves no more of a length than rounding. */
#define HALVINGS 60

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

/* A disc's radius at a time; the least that a robot meets which leaves the source then, as in enclosure.h. */
typedef double (*disc_size)(const tdsp_solver *solver, uint32_t disc, double time);

static double size_at(const tdsp_solver *solver, uint32_t disc, double time)
{
    double radius = 0.0;
    (void)tdsp_scene_disc_at(solver->scene, disc, time, &radius, NULL); /* of a disc and a time that are in range */
    return radius;
}

static double last_moment(const tdsp_solver *solver)
{
    double last = solver->ends.destination_cover.time;
    return last - JUST_BEFORE * (solver->ends.time + last);
}

/* Q = R(t + (|O - s| - Q) / v) by halving, the robot's radius in Q; rounded down. */
static double size_met(const tdsp_solver *solver, uint32_t disc, double time)
{
    const tdsp_journey *journey = &solver->scene->journey;
    double low = 0.0, high = point_distance(solver->scene->discs[disc].center, solver->ends.given.source), way = high, last = last_moment(solver);
    for (int step = 0; step < HALVINGS; ++step) {
        double middle = 0.5 * (low + high), met = math_min(time + (way - middle) / journey->speed, last);
        *(size_at(solver, disc, met) + journey->radius >= middle ? &low : &high) = middle;
    }
    return math_max(low - journey->radius, 0.0);
}

/*
 * A disc may have grown past what a scene takes for a radius, though not past the end that it leaves free, at most 2 sqrt(2) times as far away: everything
 * a quarter as large is the same question, and a scene.
 */
#define SMALLER 0.25

static tdsp_point scaled(tdsp_point p, double scale)
{
    return point_make(scale * p.x, scale * p.y);
}

/* The discs with their sizes for a time; 0 where one is too large for a scene. */
static int discs_of(const tdsp_solver *solver, disc_size size, double time, double scale, tdsp_disc *discs)
{
    int fit = 1;
    for (size_t i = 0; i < solver->scene->count; ++i) {
        discs[i] = (tdsp_disc){scaled(solver->scene->discs[i].center, scale), scale * size(solver, (uint32_t)i, time), 0.0};
        fit &= discs[i].radius <= GROWTH_LARGEST;
    }
    return fit;
}

/* The discs with their sizes for a time, as a scene of their own. */
static tdsp_status scene_of(const tdsp_solver *solver, disc_size size, double time, tdsp_scene **still)
{
    const tdsp_scene *scene = solver->scene;
    const tdsp_ends *ends = &solver->ends.given;
    tdsp_disc *discs = memory_array(&scene->allocator, scene->count, sizeof *discs);
    if (!discs) return TDSP_NO_MEMORY;
    double scale = discs_of(solver, size, time, 1.0, discs) ? 1.0 : SMALLER;
    if (scale < 1.0) (void)discs_of(solver, size, time, scale, discs);
    const tdsp_journey journey = {scene->journey.speed, scale * scene->journey.radius, scaled(ends->source, scale), scaled(ends->destination, scale)};
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

/* Is there a way among the discs of these sizes, which leave the ends free? */
static tdsp_status open_among(const tdsp_solver *solver, disc_size size, double time, int *open)
{
    tdsp_scene *still;
    tdsp_status status = scene_of(solver, size, time, &still);
    if (status != TDSP_OK) return status;
    status = still_open(still, open);
    tdsp_scene_free(still);
    return status;
}

static tdsp_status open_at_last_moment(const tdsp_solver *solver, int *open)
{
    double before = last_moment(solver);
    *open = 0;
    return before >= 0.0 && !isinf(before) ? open_among(solver, size_at, before, open) : TDSP_OK;
}

/* Is the destination walled in for who leaves then? The test of enclosure.h, which knows rates only, or its like. */
static tdsp_status walled_in(tdsp_solver *solver, double departure, int *enclosed)
{
    int open;
    *enclosed = 0;
    if (tdsp_scene_has_rates_only(solver->scene))
        return enclosure_test(&solver->enclosure, &solver->engine, &solver->ends, departure / solver->scene->time, enclosed);
    if (!(last_moment(solver) >= departure)) return TDSP_OK;
    tdsp_status status = open_among(solver, size_met, departure, &open);
    *enclosed = status == TDSP_OK && !open;
    return status;
}

/*
 * The latest departure whose path arrives in the moment of the destination's cover; negative where there is none, or that moment is not known. This is asked among all discs at
 * once: backwards in time nobody waits until the source is free again, and among fewer discs a way may be too short for that.
 */
static tdsp_status latest_to_cover(tdsp_solver *solver, double *departure)
{
    const double covered = solver->ends.destination_cover.time;
    const disc_set *all = &solver->scene->all;
    int lost;
    *departure = -1.0;
    if (!(covered > 0.0) || isinf(covered / solver->scene->time) || solver_is_far(solver, covered)) return TDSP_OK;
    if (solver->growth) {
        if (covered > tdsp_scene_valid_until(solver->scene, NULL)) return TDSP_OK;
        ++solver->work.reverse_searches;
        return growth_departure(solver->growth, &solver->ends, covered, departure);
    }
    engine_question question = solver_reverse_question(solver, covered / solver->scene->time, 0.0);
    tdsp_status status = engine_scout(&solver->engine, &question, &lost);
    if (status == TDSP_OK) status = solver_reverse(solver, all, &question, departure);
    if (*departure >= 0.0) *departure *= solver->scene->time;
    return status;
}

/* Did the destination's cover end the departures: is there a path that arrives in that moment, and none right after it? For this later departure there is none. */
static tdsp_status ended_by_cover(tdsp_solver *solver, double departure, int *ended)
{
    double last, arrival;
    *ended = 0;
    tdsp_status status = latest_to_cover(solver, &last);
    if (status != TDSP_OK || last < 0.0) return status;
    const double after = last + RIGHT_AFTER * (solver->ends.time + solver->ends.destination_cover.time - last);
    *ended = after >= departure;
    if (*ended) return TDSP_OK;
    status = solver_arrival(solver, after, &arrival);
    *ended = status != TDSP_OK && tdsp_status_is_answer(status);
    return tdsp_status_is_answer(status) || status == TDSP_SHRINKS ? TDSP_OK : status;
}

tdsp_status reason_find(tdsp_solver *solver, double departure, tdsp_status *reason)
{
    int open, enclosed;
    tdsp_status status = walled_in(solver, departure, &enclosed);
    if (status != TDSP_OK) return status;
    if (enclosed) {
        *reason = TDSP_CUT_OFF;
        return TDSP_OK;
    }
    status = stopped_by_cover(solver, departure, &open); /* mostly the cheaper of the two */
    if (status == TDSP_OK && !open) status = open_at_last_moment(solver, &open);
    if (status == TDSP_OK && !open) status = ended_by_cover(solver, departure, &open);
    if (status == TDSP_OK) *reason = open ? TDSP_DESTINATION_COVERED : TDSP_CUT_OFF;
    return status;
}
