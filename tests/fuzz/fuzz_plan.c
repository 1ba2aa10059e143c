/* SPDX-License-Identifier: MIT */
/*
 * What is made of the answers for a whole scene from bytes: jumps, pieces, deadlines with their reasons, slack, and how far growth may rise. Each claim is put to the solver
 * or the verifier again.
 */
#include <math.h>
#include <string.h>

#include "job.h"
#include "tdsp/margin.h"
#include "tdsp/shape.h"
#include "tdsp/verify.h"

enum { ASK_JUMPS = 1, ASK_ENVELOPE = 2, ASK_DEADLINE = 4, ASK_SLACK = 8, ASK_DEPARTURE_MARGIN = 16, ASK_PATH_MARGIN = 32, ASK_RAISE = 64, ASK_ADDED = 128 };
enum { MOST_STEPS = 24, MOST_LEGS = 4096 };

static int plan_enough(void *ctx, double settled, double all)
{
    unsigned *steps = ctx;
    (void)settled;
    (void)all;
    return ++*steps > MOST_STEPS;
}

static tdsp_shape_options plan_options(const fuzz_job *job, unsigned *steps)
{
    tdsp_shape_options options;
    tdsp_shape_options_init(&options);
    options.from = job->w->choice & 8u ? 0.0 : job->w->departure;
    options.until = options.from + job->w->unit * (1.0 + (job->w->choice & 3u));
    if (job->w->choice & 4u) options.until = INFINITY;
    options.least = 0.05 * job->w->unit;
    options.resolution = 0.1 * job->w->unit;
    options.progress = plan_enough;
    options.progress_ctx = steps;
    return options;
}

static int plan_answered(const fuzz_job *job, tdsp_status status)
{
    if (status == TDSP_CANCELLED || status == TDSP_NEEDS_HORIZON) return 0;
    return job_answered(job, status) && status == TDSP_OK;
}

static void plan_jumps(const fuzz_job *job)
{
    unsigned steps = 0;
    const tdsp_shape_options options = plan_options(job, &steps);
    tdsp_jumps *jumps = NULL;
    double before = -1.0;
    if (!plan_answered(job, tdsp_jumps_find(job->solver, &options, &jumps))) return;
    for (size_t i = 0; i < tdsp_jumps_count(jumps); i++) {
        tdsp_arrival_jump jump;
        world_require(job->w, tdsp_jumps_get(jumps, i, &jump) == TDSP_OK && jump.departure > before, "jumps out of order", before, jump.departure);
        world_require(job->w, jump.size > 0.0 && jump.travel_after >= jump.travel_before, "a jump that falls", jump.travel_before, jump.travel_after);
        job_agrees(job, jump.departure, jump.departure + jump.travel_before, "the arrival before a jump is another");
        before = jump.departure;
    }
    tdsp_jumps_free(jumps);
}

static void plan_envelope(const fuzz_job *job)
{
    unsigned steps = 0;
    const tdsp_shape_options options = plan_options(job, &steps);
    tdsp_envelope *envelope = NULL;
    double at = options.from;
    if (!plan_answered(job, tdsp_envelope_find(job->solver, &options, &envelope))) return;
    world_require(job->w, tdsp_envelope_forms(envelope) <= tdsp_envelope_pieces(envelope), "more forms than pieces", 0.0, 0.0);
    world_require(job->w, tdsp_envelope_resolution(envelope) > 0.0, "no resolution", tdsp_envelope_resolution(envelope), 0.0);
    for (size_t i = 0; i < tdsp_envelope_pieces(envelope); i++) {
        tdsp_piece piece;
        world_require(job->w, tdsp_envelope_piece(envelope, i, &piece) == TDSP_OK && piece.from == at && piece.until >= at, "pieces do not join", at, piece.from);
        at = piece.until;
    }
    tdsp_envelope_free(envelope);
}

/* The latest departure for a deadline is tdsp_latest_departure()'s, and its word for the reason is one of the list. */
static void plan_deadline(const fuzz_job *job, double departure, double arrival)
{
    const double deadline = job->w->choice & 16u ? INFINITY : arrival + job->w->wait;
    tdsp_deadline_answer answer;
    double latest = NAN, arrives = NAN;
    const tdsp_status status = tdsp_solver_deadline(job->solver, deadline, &answer);
    const tdsp_status again = tdsp_latest_departure(job->solver, deadline, &latest, &arrives);
    if (status == TDSP_NOT_SUPPORTED || status == TDSP_SHRINKS) return;
    world_require(job->w, status == again, "a deadline has another status than a latest departure", (double)status, (double)again);
    if (status != TDSP_OK) return;
    const double far = 10.0 * (job_error(job, latest, fmin(deadline, arrives)) + TDSP_SOLVER_ERROR * fmin(latest, deadline));
    if (isinf(latest))
        world_require(job->w, isinf(answer.departure), "a deadline ends what nothing ends", answer.departure, latest);
    else
        world_require(job->w, fabs(answer.departure - latest) <= far, "two latest departures", answer.departure, latest);
    world_require(job->w, strcmp(tdsp_limit_name(answer.witness.limit), "unknown") != 0, "a limit without a name", departure, deadline);
}

static void plan_slack(const fuzz_job *job, double departure, double arrival)
{
    tdsp_slack slack;
    const double deadline = arrival < INFINITY ? arrival + job->w->wait : departure + job->w->unit;
    const tdsp_status status = tdsp_solver_slack(job->solver, departure, deadline, &slack);
    if (status == TDSP_NOT_SUPPORTED || status == TDSP_SHRINKS) return;
    world_require(job->w, status == TDSP_OK, "no slack", (double)status, 0.0);
    world_require(job->w, slack.arrival == arrival, "slack sees another arrival", slack.arrival, arrival);
    world_require(job->w, (slack.status == TDSP_OK) == (arrival < INFINITY), "slack has another status", (double)slack.status, arrival);
}

static int plan_margin_answered(const fuzz_job *job, tdsp_status status)
{
    if (status == TDSP_NOT_SUPPORTED || (status == TDSP_SHRINKS && job->valid < INFINITY)) return 0;
    world_require(job->w, status == TDSP_OK, tdsp_status_name(status), 0.0, 0.0);
    return 1;
}

static tdsp_raise plan_raise_asked(const fuzz_job *job)
{
    return job->w->asked & ASK_ADDED ? TDSP_RAISE_ADDED : TDSP_RAISE_FACTOR;
}

/* In the scene raised by what is said to do no harm there is a way in time. */
static void plan_departure_margin(const fuzz_job *job, double departure, double arrival)
{
    const tdsp_raise how = plan_raise_asked(job);
    const double deadline = job->w->choice & 16u || arrival == INFINITY ? INFINITY : arrival + job->w->wait;
    tdsp_margin margin;
    if (!plan_margin_answered(job, tdsp_departure_margin(job->scene, how, departure, deadline, &margin))) return;
    if (!(margin.most < INFINITY) || !(margin.most > -INFINITY)) return;
    fuzz_job raised = {.w = job->w};
    double found = INFINITY;
    const tdsp_status status = tdsp_scene_raise(job->scene, how, margin.most, &raised.scene);
    world_require(job->w, status == TDSP_OK, "the margin's own scene is refused", margin.most, (double)status);
    world_require(job->w, tdsp_solver_create(raised.scene, &raised.solver) == TDSP_OK, "no solver", 0.0, 0.0);
    const tdsp_status solved = tdsp_earliest_arrival(raised.solver, departure, &found);
    world_require(job->w, solved == TDSP_OK && found <= deadline + job_error(job, departure, found), "what does no harm does harm", margin.most, found);
    job_close(&raised);
}

static void plan_path_margin(const fuzz_job *job, double departure, double arrival)
{
    static tdsp_leg legs[MOST_LEGS];
    size_t count = 0;
    tdsp_margin margin;
    if (tdsp_earliest_arrival(job->solver, departure, &arrival) != TDSP_OK) return;
    world_require(job->w, tdsp_solver_path(job->solver, legs, MOST_LEGS, &count) == TDSP_OK, "no path", departure, arrival);
    if (!plan_margin_answered(job, tdsp_path_margin(job->scene, plan_raise_asked(job), legs, count, departure, &margin))) return;
    world_require(job->w, !isnan(margin.most), "a margin that is no number", margin.most, 0.0);
}

/* Nobody arrives earlier when everything grows faster. */
static void plan_raise(const fuzz_job *job, double departure, double arrival)
{
    const tdsp_raise how = plan_raise_asked(job);
    const double amount = how == TDSP_RAISE_FACTOR ? 1.0 + job->w->wait / job->w->unit : 0.1 * job->w->journey.speed;
    fuzz_job raised = {.w = job->w};
    double found = INFINITY;
    if (tdsp_scene_raise(job->scene, how, amount, &raised.scene) != TDSP_OK) return;
    world_require(job->w, tdsp_solver_create(raised.scene, &raised.solver) == TDSP_OK, "no solver", 0.0, 0.0);
    const tdsp_status status = tdsp_earliest_arrival(raised.solver, departure, &found);
    if (tdsp_status_is_answer(status) && found < arrival - job_error(job, departure, fmin(found, arrival))) job_agrees(job, departure, found, "faster growth, earlier arrival");
    job_close(&raised);
}

static void plan_all(const fuzz_job *job)
{
    const double departure = job->w->departure, arrival = job_arrival(job, departure);
    const unsigned asked = job->w->asked;
    if (isnan(arrival) || !(job->w->unit > 0.0)) return;
    if (asked & ASK_JUMPS) plan_jumps(job);
    if (asked & ASK_ENVELOPE) plan_envelope(job);
    if (asked & ASK_DEADLINE && arrival < INFINITY) plan_deadline(job, departure, arrival);
    if (asked & ASK_SLACK) plan_slack(job, departure, arrival);
    if (asked & ASK_DEPARTURE_MARGIN) plan_departure_margin(job, departure, arrival);
    if (asked & ASK_PATH_MARGIN && arrival < INFINITY) plan_path_margin(job, departure, arrival);
    if (asked & ASK_RAISE) plan_raise(job, departure, arrival);
}

int LLVMFuzzerTestOneInput(const unsigned char *data, size_t size)
{
    fuzz_input in = {data, size, 0};
    fuzz_job job;
    world w;
    world_read(&w, &in);
    if (!job_open(&job, &w, TDSP_METHOD_AUTO)) return 0;
    plan_all(&job);
    job_close(&job);
    return 0;
}
