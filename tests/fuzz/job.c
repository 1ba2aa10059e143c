/* SPDX-License-Identifier: MIT */
/* See job.h. */
#include "job.h"

#include <math.h>

#include "tdsp/verify.h"

enum { MOST_LEGS = 4096 };

int job_open(fuzz_job *job, const world *w, tdsp_method method)
{
    *job = (fuzz_job){.w = w, .scene = world_scene(w)};
    if (!job->scene) return 0;
    job->valid = tdsp_scene_valid_until(job->scene, NULL);
    const tdsp_status status = tdsp_solver_create_for(job->scene, method, &job->solver);
    if (status == TDSP_OK) return 1;
    world_require(w, status == TDSP_NOT_SUPPORTED && method != TDSP_METHOD_AUTO, tdsp_status_name(status), 0.0, 0.0);
    job_close(job);
    return 0;
}

void job_close(fuzz_job *job)
{
    tdsp_solver_free(job->solver);
    tdsp_scene_free(job->scene);
}

int job_answered(const fuzz_job *job, tdsp_status status)
{
    switch (status) {
    case TDSP_OK:
    case TDSP_SOURCE_COVERED:
    case TDSP_DESTINATION_COVERED:
    case TDSP_CUT_OFF: return 1;
    case TDSP_SHRINKS: world_require(job->w, job->valid < INFINITY, "shrinks, and nothing does", 0.0, 0.0); return 0;
    case TDSP_NOT_SUPPORTED: return 0; /* times too far away */
    default: world_require(job->w, 0, tdsp_status_name(status), 0.0, 0.0); return 0;
    }
}

static void job_print_leg(const tdsp_leg *leg)
{
    fprintf(stderr, "kind %u of disc %u, turn %d: from %.17g (%.17g, %.17g) to %.17g (%.17g, %.17g)\n", leg->kind, leg->disc, leg->turn, leg->start_time, leg->from.x,
            leg->from.y, leg->end_time, leg->to.x, leg->to.y);
    if (leg->kind == TDSP_LEG_LINE) return;
    fprintf(stderr, "  radii %.17g %.17g, angle %.17g, sweep %.17g, rates %.17g %.17g, bends %.17g %.17g, speed %.17g\n", leg->radius_from, leg->radius_to, leg->angle_from,
            leg->sweep, leg->rate_from, leg->rate_to, leg->bend_from, leg->bend_to, leg->speed);
}

void job_check_path(const fuzz_job *job, double departure, double arrival)
{
    static tdsp_leg legs[MOST_LEGS];
    size_t count = 0;
    tdsp_verdict verdict;
    const tdsp_status status = tdsp_solver_path(job->solver, legs, MOST_LEGS, &count);
    world_require(job->w, status == TDSP_OK, "there is no path", departure, arrival);
    const tdsp_status checked = tdsp_verify_path(job->scene, legs, count, departure, arrival, &verdict);
    world_require(job->w, checked == TDSP_OK || (checked == TDSP_SHRINKS && job->valid < arrival), "the verifier does not answer", departure, arrival);
    if (checked != TDSP_OK || !verdict.problems || job_is_far(job, departure)) return;
    fprintf(stderr, "problems %u, leg %zu of %zu, clearance %.17g of disc %u at %.17g, tolerance %.3g\n", verdict.problems, verdict.leg, count,
            verdict.min_clearance, verdict.disc, verdict.time, verdict.tolerance);
    if (count) job_print_leg(&legs[verdict.leg]);
    world_require(job->w, 0, "the verifier rejects the path", departure, arrival);
}

/* The reason for no way must be the first that applies. */
static void job_check_reason(const fuzz_job *job, double departure, tdsp_status status)
{
    const double open = tdsp_scene_source_free_until(job->scene, NULL), slack = 1e-12 * (departure + job->w->unit);
    if (departure <= open - slack) world_require(job->w, status != TDSP_SOURCE_COVERED, "the source is free", departure, open);
    if (departure > open + slack && status != TDSP_SHRINKS && status != TDSP_NOT_SUPPORTED)
        world_require(job->w, status == TDSP_SOURCE_COVERED, "the source is covered", departure, open);
}

double job_arrival(const fuzz_job *job, double departure)
{
    double arrival = NAN;
    const tdsp_status status = tdsp_earliest_arrival(job->solver, departure, &arrival);
    job_check_reason(job, departure, status);
    if (!job_answered(job, status)) return NAN;
    world_require(job->w, (status == TDSP_OK) == (arrival < INFINITY), "the arrival does not go with its status", departure, arrival);
    if (status != TDSP_OK) return INFINITY;
    const tdsp_journey *j = &job->w->journey;
    const double least = hypot(j->destination.x - j->source.x, j->destination.y - j->source.y) / j->speed;
    world_require(job->w, arrival >= departure + least - job_error(job, departure, arrival), "faster than straight", departure, arrival);
    job_check_path(job, departure, arrival);
    return arrival;
}

double job_largest(const fuzz_job *job)
{
    double largest = 0.0;
    for (size_t i = 0; i < job->w->count; i++) largest = fmax(largest, job->w->discs[i].radius);
    return largest / job->w->journey.speed;
}

double job_error(const fuzz_job *job, double departure, double arrival)
{
    const double travel = arrival < INFINITY ? arrival - departure : 0.0, clock = arrival < INFINITY ? arrival : departure;
    return 2.0 * TDSP_SOLVER_ERROR * (travel + job->w->unit) + 0x1p-50 * (clock + job_largest(job));
}

int job_is_far(const fuzz_job *job, double time)
{
    return !(time <= 0x1p20 * job->w->unit);
}

void job_agrees(const fuzz_job *job, double departure, double arrival, const char *wrong)
{
    const double here = job_arrival(job, departure), error = job_error(job, departure, fmin(here, arrival));
    if (isnan(here) || here == arrival || fabs(here - arrival) <= error) return;
    if (job_is_far(job, departure) && (isinf(here) || isinf(arrival))) return;
    const double far = 10.0 * (error + TDSP_SOLVER_ERROR * departure);
    const double before = job_arrival(job, fmax(0.0, departure - far)), after = job_arrival(job, departure + far);
    if (!isnan(after)) world_require(job->w, arrival <= after + error, wrong, here, arrival);
    if (!isnan(before)) world_require(job->w, arrival >= before - error, wrong, here, arrival);
}
