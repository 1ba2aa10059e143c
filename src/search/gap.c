/* SPDX-License-Identifier: MIT */
/* Finding gap events: the equations are in gap.h. */
#include "search/gap.h"

#include "geom/tolerance.h"

/* How deep a corner may lie inside a third disc and still count as free, relative to the sizes that meet. */
#define CORNER_DEPTH 1e-10

typedef struct gap_job {
    tdsp_solver *solver;
    index_view view;
    uint32_t first;
    double departure;
    double arrival;
    tdsp_status status;
} gap_job;

/* A corner, and whether something covers it. */
typedef struct corner_job {
    const index_view *view;
    const gap_event *event;
    int covered;
} corner_job;

static int corner_visit(void *ctx, uint32_t k)
{
    corner_job *job = ctx;
    if (k == job->event->first || k == job->event->second) return 1;
    const geom_disc *disc = &job->view->discs[k];
    double distance = point_distance(job->event->place, disc->center), radius = disc_radius(disc, job->event->time);
    job->covered = distance - radius < -CORNER_DEPTH * (distance + radius);
    return !job->covered;
}

/* The moments of a pair's events: up to two. */
static int gap_times(const geom_disc *i, const geom_disc *j, double distance, double times[2])
{
    double cosine = i->rate * j->rate - i->sine * j->sine;
    double a = i->rate * i->rate + j->rate * j->rate - 2.0 * i->rate * j->rate * cosine;
    double b = i->radius * i->rate + j->radius * j->rate - cosine * (i->radius * j->rate + j->radius * i->rate);
    double c = i->radius * i->radius + j->radius * j->radius - 2.0 * i->radius * j->radius * cosine - distance * distance;
    double discriminant = b * b - a * c;
    if (a <= 0.0 || discriminant < 0.0) return 0;
    double q = -(b + (b < 0.0 ? -1.0 : 1.0) * sqrt(discriminant));
    times[0] = q / a;
    times[1] = q != 0.0 ? c / q : times[0];
    return times[0] == times[1] ? 1 : 2;
}

/* The corner of an event; 0 when it has none. */
static int gap_corner(const geom_disc *i, const geom_disc *j, gap_event *event)
{
    tdsp_point between = point_sub(j->center, i->center);
    double ri = disc_radius(i, event->time), rj = disc_radius(j, event->time);
    tdsp_point turn = point_unit(event->side * (i->theta + j->theta));
    tdsp_point divisor = point_make(ri - rj * turn.x, -rj * turn.y);
    tdsp_point normal = point_make(point_dot(between, divisor), point_cross(divisor, between));
    double length = point_length(normal);
    if (!(length > 0.0)) return 0;
    event->place = point_along(i->center, ri / length, normal);
    event->normal[0] = math_atan2(normal.y, normal.x);
    event->normal[1] = math_atan2(event->place.y - j->center.y, event->place.x - j->center.x);
    return 1;
}

static int gap_useful(const gap_job *job, gap_event *event)
{
    const scene_ends *ends = &job->solver->ends;
    event->departure = event->time - point_distance(event->place, ends->source);
    if (event->departure <= job->departure) return 0;
    if (event->time + point_distance(event->place, ends->destination) > job->arrival * (1.0 + GEOM_CONTACT)) return 0;
    corner_job corner = {&job->view, event, 0};
    index_near(&job->view, event->place, 0.0, event->time, corner_visit, &corner);
    return !corner.covered;
}

static void gap_add(gap_job *job, const gap_event *event)
{
    tdsp_solver *solver = job->solver;
    job->status = memory_reserve(&solver->scene->allocator, (void **)&solver->gaps, &solver->gap_capacity, solver->gap_count + 1,
                                 sizeof *solver->gaps);
    if (job->status == TDSP_OK) solver->gaps[solver->gap_count++] = *event;
}

static int gap_visit(void *ctx, uint32_t second)
{
    gap_job *job = ctx;
    const geom_disc *i = &job->view.discs[job->first], *j = &job->view.discs[second];
    double times[2];
    if (second <= job->first || !disc_ridable(j)) return 1;
    int count = gap_times(i, j, point_distance(i->center, j->center), times);
    for (int k = 0; k < count; ++k) {
        for (int side = -1; side <= 1 && times[k] >= 0.0 && times[k] > job->departure && times[k] <= job->arrival; side += 2) {
            gap_event event = {times[k], {0, 0}, job->first, second, side, {0, 0}, 0, 0};
            if (gap_corner(i, j, &event) && gap_useful(job, &event)) gap_add(job, &event);
            if (job->status != TDSP_OK) return 0;
        }
    }
    return 1;
}

tdsp_status gap_collect(tdsp_solver *solver, const disc_set *set, double departure, double arrival)
{
    const scene_ends *ends = &solver->ends;
    gap_job job = {solver, {&set->index, set->forward, 1.0}, 0, departure, arrival, TDSP_OK};
    solver->gap_count = 0;
    for (job.first = 0; job.first < set->count && job.status == TDSP_OK; ++job.first) {
        const geom_disc *disc = &set->forward[job.first];
        double reach = disc_radius(disc, arrival);
        double way = point_distance(disc->center, ends->source) + point_distance(disc->center, ends->destination);
        if (!disc_ridable(disc) || departure + way - 2.0 * reach > arrival) continue;
        index_near(&job.view, disc->center, reach, arrival, gap_visit, &job);
    }
    return job.status;
}
