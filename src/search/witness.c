/*
 * What closes where A jumps.
 *
 * The latest departure for an arrival inside the jump is the departure of the jump, and where it passes a gap event the solver knows which. Not every
 * jump has one: the corner may lie within a third disc at the moment at which it is as slow as the robot. What every lost path has is a place at which no
 * later robot gets through: there one disc touches it on its left and another on its right at the same moment. For a jump's own path both
 * clearances are 0 up to the error of its departure, so the place is found among the least clearances of the path's legs to the discs that are not ridden.
 *
 * Only the public interface to paths and discs is used: it serves every law of growth.
 */
#include <math.h>

#include "search/solver.h"
#include "tdsp/growth.h"
#include "tdsp/path.h"

/* Two discs that touch come this near, of the journey's length; the departure of a jump is exact to 1e-11 or so. */
#define TOUCH 1e-7

/* A departure is that of the jump within this share of the travel time and the scene's own time. */
#define SAME_DEPARTURE 1e-8

/* Parts of a leg in which a clearance has one least value, and steps that find it; 0.618^60 is nothing. */
#define PARTS 24
#define STEPS 60
#define GOLDEN 0.61803398874989485

typedef struct pinch {
    const tdsp_solver *solver;
    const tdsp_leg *leg;
    double nearest; /* the larger of the two clearances, the best so far; at most TOUCH of the journey's length */
    tdsp_gap gap;
} pinch;

static double disc_reach(const tdsp_solver *solver, uint32_t disc, double time)
{
    double radius = 0.0;
    (void)tdsp_scene_disc_at(solver->scene, disc, time, &radius, NULL); /* of a disc and a time that are in range */
    return radius + solver->scene->journey.radius;
}

/* On which hand a disc is, +1 the left, and how far away: at `time` on the leg. */
typedef struct sight {
    double clearance;
    double hand; /* the sine of its bearing from the heading */
} sight;

static double clearance_at(const pinch *self, uint32_t disc, double time)
{
    return point_distance(tdsp_leg_position(self->leg, time), self->solver->scene->discs[disc].center) - disc_reach(self->solver, disc, time);
}

static tdsp_point heading_at(const tdsp_leg *leg, double time)
{
    double step = 1e-6 * (leg->end_time - leg->start_time);
    return point_sub(tdsp_leg_position(leg, time + step), tdsp_leg_position(leg, time - step));
}

static sight sight_of(const pinch *self, uint32_t disc, double time)
{
    tdsp_point to = point_sub(self->solver->scene->discs[disc].center, tdsp_leg_position(self->leg, time));
    return (sight){clearance_at(self, disc, time), point_cross(heading_at(self->leg, time), to)};
}

/* The moment of the least clearance between two, where it has one. */
static double least_between(const pinch *self, uint32_t disc, double low, double high)
{
    double left = high - GOLDEN * (high - low), right = low + GOLDEN * (high - low);
    double at_left = clearance_at(self, disc, left), at_right = clearance_at(self, disc, right);
    for (int i = 0; i < STEPS; ++i) {
        if (at_left <= at_right) {
            high = right;
            right = left;
            at_right = at_left;
            left = high - GOLDEN * (high - low);
            at_left = clearance_at(self, disc, left);
        } else {
            low = left;
            left = right;
            at_left = at_right;
            right = low + GOLDEN * (high - low);
            at_right = clearance_at(self, disc, right);
        }
    }
    return 0.5 * (low + high);
}

/* `disc` is near at `time`: who touches on the other hand? */
static void pinch_pair(pinch *self, uint32_t disc, double time)
{
    const tdsp_scene *scene = self->solver->scene;
    sight one = sight_of(self, disc, time);
    for (uint32_t k = 0; k < scene->count && one.clearance < self->nearest; ++k) {
        if (k == disc || fabs(clearance_at(self, k, time)) >= self->nearest) continue;
        sight other = sight_of(self, k, time);
        if (one.hand * other.hand >= 0.0) continue;
        self->nearest = fmax(fabs(one.clearance), fabs(other.clearance));
        self->gap = (tdsp_gap){disc < k ? disc : k, disc < k ? k : disc, time, tdsp_leg_position(self->leg, time)};
    }
}

/* No disc comes nearer than this on the leg: the robot and the boundary move at their speeds at most. */
static double least_possible(const pinch *self, uint32_t disc)
{
    const tdsp_leg *leg = self->leg;
    double duration = leg->end_time - leg->start_time;
    double grown = disc_reach(self->solver, disc, leg->end_time) - disc_reach(self->solver, disc, leg->start_time);
    double both = clearance_at(self, disc, leg->start_time) + clearance_at(self, disc, leg->end_time);
    return 0.5 * (both - self->solver->scene->journey.speed * duration - grown);
}

static void pinch_by(pinch *self, uint32_t disc)
{
    const tdsp_leg *leg = self->leg;
    if (disc == leg->disc || least_possible(self, disc) > self->nearest) return;
    double part = (leg->end_time - leg->start_time) / PARTS;
    for (int i = 0; i < PARTS; ++i) {
        double low = leg->start_time + i * part, time = least_between(self, disc, low, low + part);
        if (fabs(clearance_at(self, disc, time)) < self->nearest) pinch_pair(self, disc, time);
    }
}

/* Look along the path of the last answer. */
static void pinch_find(pinch *self)
{
    const tdsp_solver *solver = self->solver;
    for (size_t i = 0; i < solver->path_count; ++i) {
        self->leg = &solver->path[i];
        if (!(self->leg->end_time > self->leg->start_time)) continue;
        for (uint32_t k = 0; k < solver->scene->count; ++k) pinch_by(self, k);
    }
}

static tdsp_status witness_look(tdsp_solver *solver, double departure, tdsp_gap *out)
{
    const tdsp_scene *scene = solver->scene;
    pinch found = {solver, NULL, TOUCH * (scene->length + scene->journey.radius), {TDSP_NO_DISC, TDSP_NO_DISC, 0.0, {0, 0}}};
    double arrival;
    tdsp_status status = tdsp_earliest_arrival(solver, departure, &arrival);
    if (status != TDSP_OK) return tdsp_status_is_answer(status) ? TDSP_NO_ANSWER : status;
    pinch_find(&found);
    if (found.gap.first == TDSP_NO_DISC) return TDSP_NO_ANSWER;
    *out = found.gap;
    return TDSP_OK;
}

tdsp_status tdsp_solver_gap(tdsp_solver *solver, double departure, double travel_before, double travel_after, tdsp_gap *out)
{
    if (!solver || !out || !(departure >= 0.0) || isinf(departure)) return TDSP_INVALID_ARGUMENT;
    if (!(travel_before >= 0.0) || !(travel_after > travel_before) || isinf(travel_after)) return TDSP_INVALID_ARGUMENT;
    double slack = SAME_DEPARTURE * (travel_before + solver->ends.time), found, arrives;
    double after = departure > slack ? departure - slack : -1.0, arrival = departure + 0.5 * (travel_before + travel_after);
    tdsp_status status = solver_departure_between(solver, arrival, after, departure + slack, &found, &arrives);
    if (!tdsp_status_is_answer(status)) return status;
    if (status != TDSP_OK || fabs(found - departure) > slack || solver->passed.first == TDSP_NO_DISC) return witness_look(solver, departure, out);
    *out = solver->passed;
    if (out->first > out->second) {
        out->first = solver->passed.second;
        out->second = solver->passed.first;
    }
    return TDSP_OK;
}
