/* SPDX-License-Identifier: MIT */
/*
 * A whole scene from bytes: solved forwards, backwards, within a share and by each method, and for other ends; every path goes to the verifier, and answers that
 * must agree are compared.
 */
#include <math.h>

#include "job.h"

/* Of the bits of world.asked. */
enum { ASK_WITHIN = 1, ASK_LATEST = 2, ASK_LAST = 4, ASK_GENERAL = 8, ASK_OTHER_ENDS = 16, ASK_MANY = 32, ASK_LATER = 64, ASK_GAP = 128 };

/* T never falls. */
static void solve_later(const fuzz_job *job, double departure, double arrival)
{
    const double later = departure + 0.25 * job->w->unit * (1.0 + (job->w->choice & 7u)), then = job_arrival(job, later);
    if (isnan(then)) return;
    world_require(job->w, then - later >= arrival - departure - job_error(job, later, then) - job_error(job, departure, arrival), "a travel time falls",
                  arrival - departure, then - later);
}

static void solve_within(const fuzz_job *job, double departure, double exact)
{
    static const double shares[] = {0, 1e-3, 0.01, 0.1, 1, 1e-9, 0.3, 1e-300};
    const double delta = shares[job->w->choice & 7u], error = job_error(job, departure, exact);
    double arrival = NAN, lower = NAN;
    const tdsp_status status = tdsp_earliest_arrival_within(job->solver, departure, delta, &arrival, &lower);
    if (!job_answered(job, status)) return;
    if (status == TDSP_OK) {
        world_require(job->w, arrival < INFINITY && lower <= arrival, "bounds in the wrong order", lower, arrival);
        world_require(job->w, arrival - departure <= (1.0 + delta) * (lower - departure) + error, "bounds too far apart", lower, arrival);
        job_check_path(job, departure, arrival);
        if (exact < INFINITY) world_require(job->w, exact >= lower - error, "below the lower bound", exact, lower);
    }
    /* The path of one is a path for the other. */
    if (arrival < exact - error || (exact == INFINITY && arrival < INFINITY)) job_agrees(job, departure, arrival, "a rough answer is better");
    if (arrival == INFINITY && exact < INFINITY) job_agrees(job, departure, arrival, "a rough answer finds no way");
}

/*
 * Beside a disc hundreds of journeys large a gap closes when a touch says so (docs/numerics.md: radii within eta), which over the rate of its closing is longer than an answer's error.
 */
static int solve_gaps_are_sharp(const fuzz_job *job)
{
    return job_largest(job) <= 1e2 * job->w->unit;
}

/* The latest departure keeps its word, and nobody can leave later. */
static void solve_latest(const fuzz_job *job, double departure, double arrival)
{
    double latest = NAN, arrives = NAN;
    const double by = arrival + job->w->wait;
    const tdsp_status status = tdsp_latest_departure(job->solver, by, &latest, &arrives);
    if (status == TDSP_ARRIVAL_TOO_EARLY) {
        world_require(job->w, departure <= 10.0 * job_error(job, 0.0, arrival), "too early, and somebody arrives then", departure, by);
        return;
    }
    if (!job_answered(job, status)) return;
    const double error = job_error(job, departure, arrival) + job_error(job, latest, by), far = 10.0 * (error + TDSP_SOLVER_ERROR * by);
    world_require(job->w, status == TDSP_OK, "no way back, and there is one", departure, by);
    world_require(job->w, latest >= departure - far, "somebody leaves later", departure, latest);
    world_require(job->w, arrives <= by + error && arrives >= latest, "the latest departure arrives too late", by, arrives);
    job_check_path(job, latest, arrives);
    job_agrees(job, latest, arrives, "the latest departure arrives at another time");
    const double after = job_arrival(job, latest + far);
    if (job_is_far(job, latest) || !solve_gaps_are_sharp(job)) return;
    if (!isnan(after) && latest + far <= by) world_require(job->w, after >= by - error, "a later departure arrives in time", latest, after);
}

static void solve_last(const fuzz_job *job)
{
    tdsp_last_departure last = {.departure = -1.0};
    const tdsp_status status = tdsp_solver_last_departure(job->solver, &last);
    if (!job_answered(job, status) || status != TDSP_OK || last.departure < 0.0 || job_is_far(job, last.departure)) return;
    if (!solve_gaps_are_sharp(job)) return;
    const double far = 10.0 * (job_error(job, last.departure, last.arrival) + TDSP_SOLVER_ERROR * last.departure);
    const double after = job_arrival(job, last.departure + far), before = job_arrival(job, fmax(0.0, last.departure - far));
    world_require(job->w, !(after < INFINITY), "there is a way after the last departure", last.departure, after);
    world_require(job->w, !(before == INFINITY) || last.departure < far, "there is no way before the last departure", last.departure, before);
}

/* The engine for all laws says the same of discs of one rate. */
static void solve_general(const fuzz_job *job, double departure, double arrival)
{
    fuzz_job general;
    if (tdsp_solver_method(job->solver) == TDSP_METHOD_GENERAL || !job_open(&general, job->w, TDSP_METHOD_GENERAL)) return;
    job_agrees(&general, departure, arrival, "another method says otherwise");
    job_close(&general);
}

/* To another place and back to our own, one by one and in one search. */
static void solve_many(const fuzz_job *job, double departure, double arrival)
{
    const tdsp_journey *j = &job->w->journey;
    const tdsp_point places[] = {j->destination, job->w->other, j->source};
    double arrivals[3], departures[3], arrives[3];
    tdsp_status statuses[3];
    const tdsp_status status = tdsp_earliest_arrivals(job->solver, j->source, departure, places, 3, arrivals, statuses);
    if (!job_answered(job, status)) return;
    world_require(job->w, status == TDSP_OK, "many destinations have no answer", departure, arrival);
    job_agrees(job, departure, arrivals[0], "one of many destinations says otherwise");
    if (arrivals[0] == INFINITY) return;
    const tdsp_point sources[] = {j->source, job->w->other, j->destination};
    if (tdsp_latest_departures(job->solver, sources, 3, j->destination, arrivals[0] + job->w->wait, departures, arrives, statuses) != TDSP_OK) return;
    if (statuses[0] == TDSP_OK) job_agrees(job, departures[0], arrives[0], "one of many sources says otherwise");
}

/* Other ends for one question, for all, and the scene's own again. */
static void solve_other_ends(const fuzz_job *job, double departure)
{
    tdsp_ends held;
    double latest = NAN, arrives = NAN;
    const tdsp_ends ends = {job->w->journey.source, job->w->other};
    double arrival = NAN, again = NAN;
    const tdsp_status status = tdsp_earliest_arrival_for(job->solver, &ends, departure, &arrival);
    if (!job_answered(job, status)) return;
    world_require(job->w, tdsp_solver_set_ends(job->solver, &ends) == TDSP_OK, "ends for one question only", departure, arrival);
    world_require(job->w, tdsp_earliest_arrival(job->solver, departure, &again) == status, "the same question has another status", departure, arrival);
    world_require(job->w, tdsp_solver_ends(job->solver, &held) == TDSP_OK && held.destination.x == ends.destination.x, "other ends are held", held.destination.x, ends.destination.x);
    if (status == TDSP_OK && tdsp_latest_departure_for(job->solver, &ends, arrival, &latest, &arrives) == TDSP_OK)
        world_require(job->w, arrives >= latest && arrives <= arrival, "the latest departure arrives too late", latest, arrives);
    world_require(job->w, tdsp_solver_set_ends(job->solver, NULL) == TDSP_OK, "the scene's own ends are refused", departure, arrival);
    world_require(job->w, again == arrival, "the same question has another answer", arrival, again);
}

/* What closes, where something does; the corner is on the way of a path that exists. */
static void solve_gap(const fuzz_job *job, double departure, double arrival)
{
    tdsp_gap gap;
    const tdsp_status status = tdsp_solver_gap(job->solver, departure, &gap);
    if (status == TDSP_NO_ANSWER || !job_answered(job, status) || status != TDSP_OK) return;
    const double error = job_error(job, departure, arrival);
    world_require(job->w, gap.first < job->w->count && gap.second < job->w->count && gap.first != gap.second, "a gap between what is not there", departure, arrival);
    world_require(job->w, gap.time >= departure - error && gap.time <= arrival + error, "a gap at another time", gap.time, arrival);
}

/* What a solver says of itself, and words for numbers that are none. */
static void solve_words(const fuzz_job *job)
{
    tdsp_solver_work work;
    const tdsp_status status = (tdsp_status)((int)job->w->choice - 8);
    world_require(job->w, tdsp_solver_scene(job->solver) == job->scene, "another scene", 0.0, 0.0);
    world_require(job->w, tdsp_solver_work_done(job->solver, &work) == TDSP_OK, "no work done", 0.0, 0.0);
    world_require(job->w, *tdsp_method_name(tdsp_solver_method(job->solver)) && *tdsp_version(), "no name", 0.0, 0.0);
    world_require(job->w, *tdsp_method_name((tdsp_method)job->w->choice) && *tdsp_status_name(status) && *tdsp_status_text(status), "no word", 0.0, 0.0);
}

static void solve_all(const fuzz_job *job)
{
    const double departure = job->w->departure, arrival = job_arrival(job, departure);
    const unsigned asked = job->w->asked;
    if (isnan(arrival)) return;
    if (asked & ASK_WITHIN) solve_within(job, departure, arrival);
    if (asked & ASK_LAST) solve_last(job);
    if (asked & ASK_GENERAL) solve_general(job, departure, arrival);
    if (asked & ASK_MANY) solve_many(job, departure, arrival);
    if (asked & ASK_OTHER_ENDS) solve_other_ends(job, departure);
    if (arrival == INFINITY) return;
    if (asked & ASK_GAP) solve_gap(job, departure, arrival);
    if (asked & ASK_LATER) solve_later(job, departure, arrival);
    if (asked & ASK_LATEST) solve_latest(job, departure, arrival);
}

int LLVMFuzzerTestOneInput(const unsigned char *data, size_t size)
{
    fuzz_input in = {data, size, 0};
    fuzz_job job;
    world w;
    world_read(&w, &in);
    if (!job_open(&job, &w, TDSP_METHOD_AUTO)) return 0;
    solve_all(&job);
    solve_words(&job);
    job_close(&job);
    return 0;
}
