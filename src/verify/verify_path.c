/* SPDX-License-Identifier: MIT */
/*
 * The check of a path, after what include/tdsp/verify.h states.
 *
 * Two lengths decide what is rounding. The journey J is the greater of |sd| and the length of the way. The magnitude M is
 * the largest number that positions are computed from: coordinates of both ends, of legs and centres, radii of arcs, and the
 * way that the top speed makes in the time counted from zero; a double holds a position no better than 1.1e-16 M, and a few
 * hundred roundings are allowed. The tolerance is TDSP_VERIFY_TOLERANCE * J + TDSP_VERIFY_ROUNDING * M, M then taken over
 * the disc with the least clearance too.
 */
#include "tdsp/verify.h"

#include "base/math.h"
#include "scene/scene.h" /* the allocator, nothing else */
#include "tdsp/growth.h"
#include "tdsp/solver.h" /* its stated error, nothing else */
#include "verify/check.h"
#include "verify/clearance.h"
#include "verify/motion.h"
#include "verify/nearby.h"

#define SPEED_RELATIVE 1e-9 /* and the slack of a path_check, in the length of a leg */
#define LENGTH_SHARE 1e-11  /* of the way that the robot can go, for a leg that begins beside its disc */
#define FINE_SHARE 1e-3     /* of the tolerance: the resolution of the clearance */
#define COARSE_SHARE 0.25   /* the same where a leg creeps along a disc that it does not ride */

typedef struct path_check {
    const tdsp_journey *journey;
    const tdsp_disc *discs;
    size_t disc_count;
    const nearby_index *index;
    double magnitude;
    double slack; /* of the length of a leg */
    double tolerance;
    tdsp_verdict verdict;
} path_check;

static void check_note(path_check *check, uint32_t problem, size_t leg)
{
    if (check->verdict.problems == 0) check->verdict.leg = leg;
    check->verdict.problems |= problem;
}

static double point_magnitude(tdsp_point p)
{
    return math_max(fabs(p.x), fabs(p.y));
}

static double leg_magnitude(const tdsp_leg *leg, double speed)
{
    double size = math_max(point_magnitude(leg->from), point_magnitude(leg->to));
    size = math_max(size, speed * math_max(fabs(leg->start_time), fabs(leg->end_time)));
    if (leg->kind == TDSP_LEG_LINE) return size;
    return math_max(math_max(size, point_magnitude(leg->center)), math_max(leg->radius_from, leg->radius_to));
}

static void check_scales(path_check *check, const tdsp_leg *legs, size_t count)
{
    const tdsp_journey *journey = check->journey;
    double length = 0.0;
    check->magnitude = math_max(point_magnitude(journey->source), point_magnitude(journey->destination));
    for (size_t i = 0; i < count; i++) {
        check->magnitude = math_max(check->magnitude, leg_magnitude(&legs[i], journey->speed));
        length += motion_of(&legs[i]).length;
    }
    length = math_max(length, motion_distance(journey->source, journey->destination));
    check->tolerance = TDSP_VERIFY_TOLERANCE * length + TDSP_VERIFY_ROUNDING * check->magnitude;
}

/* A ride belongs to the disc it names, and its ends lie where its radii and angles put them. */
static int ride_fits(const path_check *check, const motion *m)
{
    const tdsp_leg *leg = &m->leg;
    if (leg->disc >= check->disc_count) return 0;
    if (motion_distance(leg->center, check->discs[leg->disc].center) > check->tolerance) return 0;
    return motion_distance(leg->from, motion_position(m, 0.0)) <= check->tolerance &&
           motion_distance(leg->to, motion_position(m, m->duration)) <= check->tolerance;
}

static void check_leg(path_check *check, const motion *m, size_t i)
{
    if (m->leg.kind != TDSP_LEG_LINE && !ride_fits(check, m)) check_note(check, TDSP_PROBLEM_LEG, i);
    const double reach = check->journey->speed * m->duration * (1.0 + SPEED_RELATIVE);
    if (m->length > reach + check->slack) check_note(check, TDSP_PROBLEM_SPEED, i);
}

/* Do two moments of the path agree in place and in time? */
static int same_moment(const path_check *check, tdsp_point a, double time_a, tdsp_point b, double time_b)
{
    return motion_distance(a, b) <= check->tolerance && check->journey->speed * fabs(time_a - time_b) <= check->tolerance;
}

static void check_joins(path_check *check, const tdsp_leg *legs, size_t count, double departure, double arrival)
{
    const tdsp_leg *last = &legs[count - 1];
    if (!same_moment(check, legs[0].from, legs[0].start_time, check->journey->source, departure))
        check_note(check, TDSP_PROBLEM_START, 0);
    for (size_t i = 1; i < count; i++)
        if (!same_moment(check, legs[i - 1].to, legs[i - 1].end_time, legs[i].from, legs[i].start_time))
            check_note(check, TDSP_PROBLEM_JOIN, i);
    if (!same_moment(check, last->to, last->end_time, check->journey->destination, arrival))
        check_note(check, TDSP_PROBLEM_END, count - 1);
}

/* The verdict's clearance; the disc that is nearest brings its own rounding. */
static void check_clearance(path_check *check, const clearance *least)
{
    tdsp_verdict *verdict = &check->verdict;
    verdict->min_clearance = math_min(least->found, least->bound);
    verdict->time = least->time;
    verdict->disc = least->disc;
    if (verdict->problems == 0) verdict->leg = least->leg;
    if (least->disc != TDSP_NO_DISC) {
        const double magnitude = math_max(least->radius, point_magnitude(check->discs[least->disc].center));
        if (magnitude > check->magnitude) check->tolerance += TDSP_VERIFY_ROUNDING * (magnitude - check->magnitude);
    }
    verdict->tolerance = check->tolerance;
    if (verdict->min_clearance < -check->tolerance) check_note(check, TDSP_PROBLEM_CLEARANCE, least->leg);
}

static void check_legs(path_check *check, const tdsp_leg *legs, size_t count, double departure, double arrival)
{
    check_scales(check, legs, count);
    check->slack = LENGTH_SHARE * check->journey->speed * fabs(arrival - departure) + TDSP_VERIFY_ROUNDING * check->magnitude;
    clearance least = {INFINITY,     INFINITY, FINE_SHARE * check->tolerance, COARSE_SHARE * check->tolerance, departure, 0.0,
                       TDSP_NO_DISC, 0};
    check_joins(check, legs, count, departure, arrival);
    for (size_t i = 0; i < count; i++) {
        const motion m = motion_of(&legs[i]);
        check_leg(check, &m, i);
        clearance_of_leg(&least, &m, i, check->index);
    }
    check_clearance(check, &least);
}

tdsp_verdict check_path(const tdsp_scene *scene, const tdsp_journey *journey, const nearby_index *index, const tdsp_leg *legs,
                        size_t count, double departure, double arrival)
{
    path_check check = {journey, NULL, 0, index, 0.0, 0.0, 0.0, {0, -INFINITY, departure, TDSP_NO_DISC, 0, 0.0}};
    check.discs = tdsp_scene_discs(scene, &check.disc_count);
    for (size_t i = 0; i < count; i++)
        if (!motion_well_formed(&legs[i])) check_note(&check, TDSP_PROBLEM_LEG, i);
    if (check.verdict.problems) return check.verdict;
    /* A path of no legs stays at the source for a moment. */
    const tdsp_point source = check.journey->source;
    const tdsp_leg rest = {
        .kind = TDSP_LEG_LINE, .disc = TDSP_NO_DISC, .start_time = departure, .end_time = departure, .from = source, .to = source};
    if (count == 0)
        check_legs(&check, &rest, 1, departure, arrival);
    else
        check_legs(&check, legs, count, departure, arrival);
    return check.verdict;
}

tdsp_journey check_journey(const tdsp_scene *scene, const tdsp_ends *ends)
{
    tdsp_journey journey = *tdsp_scene_journey(scene);
    if (!ends) return journey;
    journey.source = ends->source;
    journey.destination = ends->destination;
    return journey;
}

/* The last moment that the path knows of. */
static double path_end(const tdsp_leg *legs, size_t count, double arrival)
{
    double end = arrival;
    for (size_t i = 0; i < count; i++)
        if (isfinite(legs[i].end_time)) end = math_max(end, legs[i].end_time);
    return end;
}

int check_is_described(const tdsp_scene *scene, double time)
{
    return time <= tdsp_scene_valid_until(scene, NULL) * (1.0 + TDSP_SOLVER_ERROR);
}

tdsp_status tdsp_verify_path(const tdsp_scene *scene, const tdsp_leg *legs, size_t count, double departure, double arrival,
                             tdsp_verdict *out)
{
    return tdsp_verify_path_for(scene, NULL, legs, count, departure, arrival, out);
}

tdsp_status tdsp_verify_path_for(const tdsp_scene *scene, const tdsp_ends *ends, const tdsp_leg *legs, size_t count, double departure,
                                 double arrival, tdsp_verdict *out)
{
    if (!scene || !out || (!legs && count > 0)) return TDSP_INVALID_ARGUMENT;
    if (!isfinite(departure) || departure < 0.0 || !isfinite(arrival)) return TDSP_INVALID_ARGUMENT;
    const tdsp_journey journey = check_journey(scene, ends);
    if (tdsp_journey_check(&journey)) return TDSP_INVALID_ARGUMENT;
    nearby_index index;
    const double end = path_end(legs, count, arrival);
    if (!check_is_described(scene, end)) return TDSP_SHRINKS;
    const tdsp_status status = nearby_build(scene, math_max(departure, end), &scene->allocator, &index);
    if (status != TDSP_OK) return status;
    *out = check_path(scene, &journey, &index, legs, count, departure, arrival);
    nearby_free(&index);
    return TDSP_OK;
}
