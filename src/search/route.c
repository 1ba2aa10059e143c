/* SPDX-License-Identifier: MIT */
/*
 * From the labels of a forward search to the legs of a path, in the user's units.
 *
 * The chain of labels is walked back from the goal; each ride gives an arc (where it lasts) and each leg a line (where it has a length).
 * Neighbouring legs share their end to the bit: a leg starts where and when the one before ended.
 */
#include "geom/angle.h"
#include "geom/spiral.h"
#include "search/general.h"

/* Shorter than this share of the journey is nothing: it only joins. */
#define NOTHING 1e-15

static tdsp_status path_append(tdsp_solver *solver, const tdsp_leg *leg)
{
    tdsp_status status = memory_reserve(&solver->scene->allocator, (void **)&solver->path, &solver->path_capacity,
                                        solver->path_count + 1, sizeof *solver->path);
    if (status == TDSP_OK) solver->path[solver->path_count++] = *leg;
    return status;
}

static tdsp_leg line_of(const tdsp_solver *solver, const engine_leg *leg)
{
    tdsp_leg line = {.kind = TDSP_LEG_LINE, .disc = TDSP_NO_DISC};
    const disc_engine *engine = &solver->engine;
    tdsp_point to = engine->question.goal;
    if (leg->disc != ENGINE_GOAL) {
        const geom_disc *disc = engine_disc(engine, leg->disc);
        to = disc_boundary(disc, leg->heading - leg->side * disc->theta, leg_arrival(leg));
    }
    line.end_time = leg_arrival(leg);
    line.to = to;
    return line;
}

static tdsp_leg arc_of(const tdsp_solver *solver, const engine_ride *ride, double end)
{
    const disc_engine *engine = &solver->engine;
    const geom_disc *disc = engine_disc(engine, ride->disc);
    tdsp_leg arc = {.kind = TDSP_LEG_ARC, .turn = ride->side, .start_time = ride->start, .end_time = end};
    arc.disc = relax_given(&solver->relaxation, engine->set, ride->disc);
    arc.sweep = spiral_angle(disc, ride->start, end);
    arc.angle_from = ride->normal;
    arc.radius_from = disc_radius(disc, ride->start);
    arc.radius_to = disc_radius(disc, end);
    arc.center = disc->center;
    arc.to = disc_boundary(disc, ride->normal + ride->side * arc.sweep, end);
    return arc;
}

/* The legs from the goal back to the source, in the frame; an arc before the line that leaves it. */
static tdsp_status path_collect(tdsp_solver *solver)
{
    const disc_engine *engine = &solver->engine;
    uint32_t at = engine->arrived;
    tdsp_status status = TDSP_OK;
    while (at != ENGINE_NONE && status == TDSP_OK) {
        const engine_leg *leg = &engine->legs[at];
        tdsp_leg line = line_of(solver, leg);
        if (leg->length > NOTHING || leg->disc == ENGINE_GOAL) status = path_append(solver, &line);
        if (leg->ride == ENGINE_NONE || status != TDSP_OK) return status;
        const engine_ride *ride = &engine->rides[leg->ride];
        tdsp_leg arc = arc_of(solver, ride, leg->leave);
        if (leg->leave - ride->start > NOTHING) status = path_append(solver, &arc);
        at = ride->leg;
    }
    return status;
}

static void path_turn_round(tdsp_solver *solver)
{
    for (size_t i = 0, j = solver->path_count; i + 1 < j; ++i) {
        tdsp_leg swap = solver->path[--j];
        solver->path[j] = solver->path[i];
        solver->path[i] = swap;
    }
}

/*
 * Units, and the joins. An arc starts where the line before it ended: its first radius and angle say the same to rounding. They are the ride's own, not those of the places: on
 * a disc much smaller than the coordinates a place says where to no more than a part of a turn, and the spiral goes on from there to where the disc is large.
 */
static void path_finish(tdsp_solver *solver, double departure, double arrival)
{
    const tdsp_scene *scene = solver->scene;
    double start = solver->engine.question.time;
    tdsp_point at = solver->ends.given.source;
    double now = departure;
    for (size_t i = 0; i < solver->path_count; ++i) {
        tdsp_leg *leg = &solver->path[i];
        int last = i + 1 == solver->path_count;
        leg->from = at;
        leg->start_time = now;
        leg->to = at = last ? solver->ends.given.destination : scene_place(scene, leg->to);
        /* An arrival that is a touch late was set to the moment in which the destination is covered: nothing on the way is later. */
        leg->end_time = now = last ? arrival : math_min(math_max(now, departure + (leg->end_time - start) * scene->time), arrival);
        if (leg->kind != TDSP_LEG_ARC) continue;
        const tdsp_disc *disc = &scene->discs[leg->disc];
        leg->center = disc->center;
        leg->radius_from *= scene->length;
        leg->radius_to *= scene->length;
        leg->angle_from = angle_wrap(leg->angle_from);
    }
}

/* A goal leg of no length after an arc only closes the path: the arc ends at the goal itself. */
static void path_trim(tdsp_solver *solver)
{
    const engine_leg *last = &solver->engine.legs[solver->engine.arrived];
    if (solver->path_count > 1 && last->length <= NOTHING) --solver->path_count;
}

tdsp_status route_keep(tdsp_solver *solver, double departure, double arrival)
{
    solver->has_path = 0;
    solver->path_count = 0;
    if (solver->growth) {
        tdsp_status status = general_route(solver, departure, arrival);
        if (status != TDSP_OK) return status;
    } else if (solver->engine.arrived != ENGINE_NONE) {
        tdsp_status status = path_collect(solver);
        if (status != TDSP_OK) return status;
        path_turn_round(solver);
        path_trim(solver);
        path_finish(solver, departure, arrival);
    }
    solver->has_path = 1;
    return TDSP_OK;
}
