/* SPDX-License-Identifier: MIT */
/*
 * A table, and a matrix, of a whole scene from bytes: what is built opens, the verifier takes it, and its intervals hold the solver's own answers.
 */
#include <math.h>
#include <string.h>

#include "job.h"
#include "tdsp/build.h"
#include "tdsp/verify.h"

enum { MOST_CALLS = 300, MOST_ROWS = 40, TIMES = 6 };

typedef struct build_budget {
    unsigned calls;
} build_budget;

static int build_enough(void *ctx, double settled, double all)
{
    build_budget *budget = ctx;
    (void)settled;
    (void)all;
    return ++budget->calls > MOST_CALLS;
}

static tdsp_build_options build_asked(const fuzz_job *job, build_budget *budget)
{
    static const tdsp_guarantee guarantees[] = {TDSP_GUARANTEE_TRAVEL, TDSP_GUARANTEE_ARRIVAL, TDSP_GUARANTEE_ABSOLUTE, TDSP_GUARANTEE_TRAVEL};
    static const double shares[] = {0.3, 0.1, 0.03, 1};
    const unsigned choice = job->w->choice;
    tdsp_build_options options;
    tdsp_build_options_init(&options);
    options.guarantee = guarantees[choice & 3u];
    options.epsilon = shares[choice >> 2 & 3u];
    options.delta = options.epsilon * job->w->unit;
    if (choice & 16u) options.sampling = TDSP_SAMPLING_GEOMETRIC;
    if (choice & 32u) options.horizon = job->w->departure;
    if (choice & 64u) options.oracle_share = 0.0;
    options.max_rows = MOST_ROWS;
    options.world = (tdsp_build_world){tdsp_scene_hash(job->scene), job->w->journey.speed, job->w->journey.source, job->w->journey.destination, "m", "s"};
    options.progress = build_enough;
    options.progress_ctx = budget;
    return options;
}

/* What a build may say besides what a question may. */
static int build_went_well(const fuzz_job *job, const tdsp_build_options *options, tdsp_status status)
{
    if (status == TDSP_CANCELLED || status == TDSP_TOO_MANY_ROWS) return 0;
    if (status == TDSP_NEEDS_HORIZON) {
        world_require(job->w, isinf(options->horizon), "a horizon is asked for, and there is one", options->horizon, 0.0);
        return 0;
    }
    if (status == TDSP_INVALID_ARGUMENT && !(options->delta > 0.0)) return 0; /* a journey of no length */
    return job_answered(job, status) && status == TDSP_OK;
}

static void build_verify(const fuzz_job *job, const tdsp_table *table)
{
    tdsp_table_verdict verdict;
    const tdsp_status status = tdsp_verify_table(job->scene, table, &verdict);
    world_require(job->w, status == TDSP_OK, "the verifier does not answer", (double)status, 0.0);
    if (verdict.ok) return;
    fprintf(stderr, "stale %d, order %g, ratio %g, paths %g, row %g; problems %u, leg %zu, clearance %.17g of disc %u at %.17g, tolerance %.3g\n", verdict.stale,
            (double)verdict.bad_order, (double)verdict.bad_ratio, (double)verdict.bad_paths, (double)verdict.first_bad_row, verdict.worst.problems,
            verdict.worst.leg, verdict.worst.min_clearance, verdict.worst.disc, verdict.worst.time, verdict.worst.tolerance);
    world_require(job->w, 0, "the verifier rejects the table", 0.0, 0.0);
}

/* A of the solver lies in the interval, but for its error; next to a jump, A on one of its sides does. */
static void build_compare(const fuzz_job *job, double departure, double lower, double upper)
{
    const double arrival = job_arrival(job, departure), error = job_error(job, departure, fmin(arrival, upper));
    if (isnan(arrival) || (arrival >= lower - error && arrival <= upper + error)) return;
    job_agrees(job, departure, arrival < lower ? lower : upper, "the interval does not hold the arrival");
}

static void build_ask(const fuzz_job *job, const tdsp_table *table)
{
    double departures[TIMES], lower[TIMES], upper[TIMES], latest[TIMES], after[TIMES];
    tdsp_status statuses[TIMES], back[TIMES];
    uint64_t rows[TIMES];
    tdsp_table_info info;
    tdsp_table_get_info(table, &info);
    for (int i = 0; i < TIMES; i++) departures[i] = info.last_departure * i / (double)(TIMES - 2);
    departures[1] = fmin(job->w->departure, info.last_departure);
    tdsp_table_arrivals(table, departures, TIMES, lower, upper, statuses);
    tdsp_table_departures(table, upper, TIMES, latest, after, back);
    tdsp_table_rows(table, departures, TIMES, rows, NULL);
    for (int i = 0; i < TIMES; i++) {
        if (statuses[i] != TDSP_OK) continue;
        world_require(job->w, lower[i] <= upper[i] && rows[i] < info.rows, "an interval upside down", lower[i], upper[i]);
        world_require(job->w, back[i] == TDSP_OK && latest[i] >= departures[i] && latest[i] <= after[i], "the way back does not lead back", departures[i], latest[i]);
        if (i < 3) build_compare(job, departures[i], lower[i], upper[i]);
    }
}

static void build_table(const fuzz_job *job)
{
    build_budget budget = {0};
    const tdsp_build_options options = build_asked(job, &budget);
    tdsp_oracle oracle;
    tdsp_table table;
    void *bytes = NULL;
    size_t length = 0;
    tdsp_build_report report;
    world_require(job->w, tdsp_solver_oracle(job->solver, &oracle) == TDSP_OK, "no oracle", 0.0, 0.0);
    const tdsp_status status = tdsp_build(&oracle, &options, NULL, &bytes, &length, &report);
    if (!build_went_well(job, &options, status)) return;
    world_require(job->w, tdsp_table_open(&table, bytes, length) == TDSP_OK && report.bytes == length, "what was built does not open", 0.0, 0.0);
    build_verify(job, &table);
    build_ask(job, &table);
    tdsp_bytes_free(NULL, bytes, length);
}

/* From both ends to both and another place; for other ends than the scene's own the solver is told so, and asked itself. */
static tdsp_status build_pair(void *ctx, size_t i, size_t j, size_t worker, tdsp_oracle *oracle, uint64_t *scene_hash)
{
    const fuzz_job *job = ctx;
    const tdsp_journey *own = &job->w->journey;
    const tdsp_point places[] = {own->source, own->destination, job->w->other};
    const tdsp_ends ends = {places[i], places[j]};
    (void)worker;
    *scene_hash = tdsp_scene_hash_for(job->scene, &ends);
    const tdsp_status status = tdsp_solver_set_ends(job->solver, &ends);
    return status == TDSP_OK ? tdsp_solver_oracle(job->solver, oracle) : status;
}

static void build_check_matrix(const fuzz_job *job, const tdsp_matrix_end *places, const void *bytes, size_t length)
{
    tdsp_matrix matrix;
    world_require(job->w, tdsp_matrix_open(&matrix, bytes, length) == TDSP_OK, "a matrix does not open", 0.0, 0.0);
    for (size_t i = 0; i < 2; i++) {
        for (size_t j = 0; j < 3; j++) {
            const tdsp_ends ends = {places[i].place, places[j].place};
            tdsp_table table;
            tdsp_table_verdict verdict;
            if (tdsp_matrix_table(&matrix, i, j, &table) != TDSP_OK) continue;
            world_require(job->w, tdsp_verify_table_for(job->scene, &ends, &table, &verdict) == TDSP_OK && verdict.ok, "a matrix's table is rejected", (double)i, (double)j);
        }
    }
}

static void build_matrix(const fuzz_job *job)
{
    build_budget budget = {0};
    const tdsp_build_options options = build_asked(job, &budget);
    const tdsp_matrix_end places[] = {{job->w->journey.source, "s", 1}, {job->w->journey.destination, NULL, 0}, {job->w->other, "o", 1}};
    const tdsp_matrix_plan plan = {places, 2, places, 3, build_pair, (void *)(uintptr_t)job};
    void *bytes = NULL;
    size_t length = 0;
    const tdsp_status status = tdsp_matrix_build(&plan, &options, NULL, &bytes, &length, NULL);
    if (!build_went_well(job, &options, status)) return;
    build_check_matrix(job, places, bytes, length);
    tdsp_bytes_free(NULL, bytes, length);
}

int LLVMFuzzerTestOneInput(const unsigned char *data, size_t size)
{
    fuzz_input in = {data, size, 0};
    fuzz_job job;
    world w;
    world_read(&w, &in);
    if (!job_open(&job, &w, TDSP_METHOD_AUTO)) return 0;
    if (w.choice & 128u)
        build_matrix(&job);
    else
        build_table(&job);
    job_close(&job);
    return 0;
}
