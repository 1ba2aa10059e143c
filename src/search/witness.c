/* SPDX-License-Identifier: MIT */
/*
 * What closes where A jumps.
 *
 * Every path that is lost has a place at which no later robot gets through: one disc touches it there on its left and another on its right at
 * the same moment, for else the path could be bent aside. For a jump's own path both clearances are 0 up to the error of its departure, so the place is found
 * among the least clearances of the path's legs to the discs that are not ridden. That needs paths and discs only, and serves every law of growth.
 *
 * Where both discs grow at one rate the place is mostly a gap event, whose time and corner are known in closed form (gap.h): they then stand for what
 * was found. They do not where the corner lies within a third disc before it is as slow as the robot.
 */
#include "base/math.h"
#include "search/solver.h"
#include "tdsp/growth.h"
#include "tdsp/path.h"

/* Two discs that touch come this near, of the journey's length; the departure of a jump is exact to 1e-11 or so. */
#define TOUCH 1e-7

/* An event this near to what was found, of the journey's length, is it. */
#define POLISH 1e-3

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
        self->nearest = math_max(fabs(one.clearance), fabs(other.clearance));
        self->gap = (tdsp_gap){disc < k ? disc : k, disc < k ? k : disc, time, tdsp_leg_position(self->leg, time)};
    }
}

/* No disc comes nearer than this between two moments of the leg: robot and boundary move at their speeds at most. */
static double least_possible(const pinch *self, uint32_t disc, double low, double high)
{
    double grown = disc_reach(self->solver, disc, high) - disc_reach(self->solver, disc, low);
    double both = clearance_at(self, disc, low) + clearance_at(self, disc, high);
    return 0.5 * (both - self->solver->scene->journey.speed * (high - low) - grown);
}

static void pinch_by(pinch *self, uint32_t disc)
{
    const tdsp_leg *leg = self->leg;
    if (disc == leg->disc || least_possible(self, disc, leg->start_time, leg->end_time) > self->nearest) return;
    double part = (leg->end_time - leg->start_time) / PARTS;
    for (int i = 0; i < PARTS; ++i) {
        double low = leg->start_time + i * part, high = i + 1 < PARTS ? low + part : leg->end_time;
        if (least_possible(self, disc, low, high) > self->nearest) continue;
        double time = least_between(self, disc, low, high);
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

/* The moments of the gap events of two discs of one rate each, in the user's units: up to two (gap.h). */
static int event_times(const tdsp_solver *solver, const tdsp_gap *gap, double cosine, double times[2])
{
    const tdsp_disc *i = &solver->scene->discs[gap->first], *j = &solver->scene->discs[gap->second];
    double ri = i->radius + solver->scene->journey.radius, rj = j->radius + solver->scene->journey.radius, vi = i->growth, vj = j->growth;
    double distance = point_distance(i->center, j->center);
    double a = vi * vi + vj * vj - 2.0 * vi * vj * cosine, b = ri * vi + rj * vj - cosine * (ri * vj + rj * vi);
    double c = ri * ri + rj * rj - 2.0 * ri * rj * cosine - distance * distance, discriminant = b * b - a * c;
    if (!(a > 0.0) || discriminant < 0.0) return 0;
    double q = -(b + (b < 0.0 ? -1.0 : 1.0) * sqrt(discriminant));
    times[0] = q / a;
    times[1] = q != 0.0 ? c / q : times[0];
    return 2;
}

/* The corner of an event, with the first disc on the robot's left (side +1) or right. */
static tdsp_point event_corner(const tdsp_solver *solver, const tdsp_gap *gap, double angle, double time)
{
    tdsp_point o = solver->scene->discs[gap->first].center, between = point_sub(solver->scene->discs[gap->second].center, o);
    double ri = disc_reach(solver, gap->first, time), rj = disc_reach(solver, gap->second, time);
    tdsp_point turn = point_unit(angle), divisor = point_make(ri - rj * turn.x, -rj * turn.y);
    tdsp_point normal = point_make(point_dot(between, divisor), point_cross(divisor, between));
    return point_along(o, ri / point_length(normal), normal);
}

/* The event of the pair that is near what was found, if there is one. */
static void witness_polish(const tdsp_solver *solver, tdsp_gap *gap)
{
    const tdsp_scene *scene = solver->scene;
    double vi = scene->discs[gap->first].growth / scene->journey.speed, vj = scene->discs[gap->second].growth / scene->journey.speed;
    if (!tdsp_scene_has_rates_only(scene) || !(vi < 1.0) || !(vj < 1.0)) return;
    double angle = math_acos(vi) + math_acos(vj), times[2], near = POLISH * scene->length;
    int count = event_times(solver, gap, math_cos(angle), times);
    const tdsp_gap found = *gap;
    for (int k = 0; k < count; ++k)
        for (int side = -1; side <= 1; side += 2) {
            tdsp_point corner = event_corner(solver, gap, side * angle, times[k]);
            double off = point_distance(corner, found.place) + scene->journey.speed * fabs(times[k] - found.time);
            if (!(off < near)) continue;
            near = off;
            gap->time = times[k];
            gap->place = corner;
        }
}

tdsp_status solver_pinch(const tdsp_solver *solver, tdsp_gap *out)
{
    const tdsp_scene *scene = solver->scene;
    pinch found = {solver, NULL, TOUCH * (scene->length + scene->journey.radius), {TDSP_NO_DISC, TDSP_NO_DISC, 0.0, {0, 0}}};
    pinch_find(&found);
    if (found.gap.first == TDSP_NO_DISC) return TDSP_NO_ANSWER;
    witness_polish(solver, &found.gap);
    *out = found.gap;
    return TDSP_OK;
}

tdsp_status tdsp_solver_gap(tdsp_solver *solver, double departure, tdsp_gap *out)
{
    double arrival;
    if (!out) return TDSP_INVALID_ARGUMENT;
    tdsp_status status = tdsp_earliest_arrival(solver, departure, &arrival);
    if (status != TDSP_OK) return tdsp_status_is_answer(status) ? TDSP_NO_ANSWER : status;
    return solver_pinch(solver, out);
}
