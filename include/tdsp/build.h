/* SPDX-License-Identifier: MIT */
/*
 * The sampler: any oracle in, the bytes of a table out.
 *
 * Adaptive sampling places each row as late as the guarantee allows; geometric sampling is Algorithm 1 of Maheshwari,
 * Nouri, Sack (arXiv 1808.01984) with its indices mended. See docs/sampler.md.
 */
#ifndef TDSP_BUILD_H
#define TDSP_BUILD_H

#include "tdsp/matrix.h"
#include "tdsp/oracle.h"
#include "tdsp/status.h"
#include "tdsp/types.h"

#ifdef __cplusplus
extern "C" {
#endif

#define TDSP_MAX_ROWS 16777216u /* 2^24 */

/** What the table says of the world it was built for; copied into its header. */
typedef struct tdsp_build_world {
    uint64_t scene_hash;     /* tdsp_scene_hash(), or any number that identifies the world */
    double speed;            /* the robot's top speed; 0 where that means nothing */
    tdsp_point source;       /* where journeys begin */
    tdsp_point destination;  /* where they end */
    const char *length_unit; /* at most 15 bytes of UTF-8; NULL is "" */
    const char *time_unit;   /* at most 15 bytes of UTF-8; NULL is "" */
} tdsp_build_world;

/**
 * Called before each call of the oracle (with workers: of worker 0, and between batches) with the departure settled so far and the last of all, which
 * is infinite until it is known; a return other than 0 cancels.
 */
typedef int (*tdsp_progress)(void *ctx, double settled, double all);

/**
 * Called to run task(task_ctx, i, worker) once for each i < count, in any order, and to return when all are done; worker < worker_count
 * says which oracle to use, one task at a time for each. Worker 0 reports progress: its tasks belong in the calling thread. Tasks use the allocator: with
 * threads it must be safe to call from them.
 */
typedef void (*tdsp_task)(void *task_ctx, size_t i, size_t worker);
typedef void (*tdsp_run_tasks)(void *ctx, tdsp_task task, void *task_ctx, size_t count);

/** What to build, and how. Initialise with tdsp_build_options_init(), then set members. */
typedef struct tdsp_build_options {
    size_t size; /* sizeof(tdsp_build_options), set by tdsp_build_options_init() */
    tdsp_guarantee guarantee; /* what every answer is held to */
    tdsp_sampling sampling;   /* how rows are placed */
    double epsilon;         /* travel and arrival: 1e-9 to 1 */
    double delta;           /* absolute: over 0, in the unit of time */
    double horizon;         /* departures are sampled up to this; infinity for none */
    uint32_t max_rows;      /* 1 to TDSP_MAX_ROWS */
    tdsp_build_world world; /* copied into the table's header */
    tdsp_progress progress; /* may be NULL */
    void *progress_ctx;     /* handed to progress */
    tdsp_run_tasks run_tasks;   /* the caller's threads; NULL: everything in this one */
    void *run_tasks_ctx;        /* handed to run_tasks */
    const tdsp_oracle *workers; /* one oracle a worker, equal in what they declare and answer; NULL: only the oracle given */
    size_t worker_count;        /* how many workers; not looked at without run_tasks */
    double oracle_share; /* adaptive sampling of the guarantees travel and absolute, with an oracle that has earliest_arrival_within:
                            how much of the guarantee that may take up, 0 to 0.9; 0: exact answers only */
} tdsp_build_options;

/** Defaults: travel, 0.01, adaptive, no horizon, TDSP_MAX_ROWS, an empty world, one thread, a share of 3/4. Since 0.1. */
TDSP_API void tdsp_build_options_init(tdsp_build_options *options);

/** What was built, and what it cost. */
typedef struct tdsp_build_report {
    uint64_t rows;          /* departures in the table, the first at 0 */
    uint64_t bytes;         /* of the table */
    uint64_t forward_calls; /* calls of earliest_arrival and earliest_arrival_within */
    uint64_t reverse_calls; /* calls of latest_departure and latest_departure_between */
    double last_departure;  /* the end of the table's domain */
    tdsp_status last_reason; /* why there is no answer after it; TDSP_HORIZON where the horizon ended it */
    double oracle_delta;    /* what earliest_arrival_within was asked for; 0: exact answers only */
    uint64_t rough_calls;   /* forward calls that were answered by a path not known to be the best */
    uint64_t gaps;          /* jumps at rows of which the table says what closes */
} tdsp_build_report;

/**
 * Build a table.
 *
 * @param oracle     asked one call at a time, unless options->run_tasks spreads them over options->workers
 * @param options    see above
 * @param allocator  for the bytes and for what is needed meanwhile; NULL for the C library's
 * @param bytes      receives the table, owned by the caller: free with tdsp_bytes_free() and the same allocator
 * @param length     receives its length in bytes
 * @param report     may be NULL; filled on success
 * @return TDSP_OK; TDSP_SOURCE_COVERED, TDSP_DESTINATION_COVERED, TDSP_CUT_OFF or TDSP_UNREACHABLE when there is no way at departure 0;
 *         TDSP_INVALID_ARGUMENT; TDSP_NOT_SUPPORTED (geometric with another guarantee than arrival or with A(0) = 0; travel with an
 *         oracle that is monotone in arrival; a guarantee finer than the oracle's error, as a relative one is where T grows from 0);
 *         TDSP_NEEDS_HORIZON; TDSP_TOO_MANY_ROWS; TDSP_BAD_ORACLE for answers that contradict each other; TDSP_BAD_PATH for legs of the
 *         oracle's that are not well formed, do not join, or do not begin at the departure and end by the arrival; TDSP_CANCELLED;
 *         TDSP_NO_MEMORY; an error of the oracle. Outputs are untouched unless TDSP_OK.
 *
 * The bytes depend on the oracle and the options only, not on the number of workers. Since 0.1.
 */
TDSP_API tdsp_status tdsp_build(const tdsp_oracle *oracle, const tdsp_build_options *options, const tdsp_allocator *allocator,
                                void **bytes, size_t *length, tdsp_build_report *report);

/** Free the bytes of a table that tdsp_build() made. Since 0.1. */
TDSP_API void tdsp_bytes_free(const tdsp_allocator *allocator, void *bytes, size_t length);

/**
 * The oracle from source i to destination j, for one build with it: valid until the next call for the same worker. `scene_hash` goes into the header of the
 * pair's table. TDSP_OK, or an error.
 */
typedef tdsp_status (*tdsp_pair_oracle)(void *ctx, size_t i, size_t j, size_t worker, tdsp_oracle *oracle, uint64_t *scene_hash);

/** The pairs of a matrix. Initialise with zeros. */
typedef struct tdsp_matrix_plan {
    const tdsp_matrix_end *sources; /* each with a finite place, and a name in UTF-8 or none; at least one */
    size_t source_count;           /* at least 1 */
    const tdsp_matrix_end *destinations; /* likewise */
    size_t destination_count;            /* at least 1 */
    tdsp_pair_oracle oracle_for; /* makes the oracle of a pair */
    void *ctx;                   /* handed to it */
} tdsp_matrix_plan;

/** What was built of a matrix, and what it cost; or where it failed. */
typedef struct tdsp_matrix_report {
    uint64_t tables; /* pairs with a way */
    uint64_t rows;   /* of all tables */
    uint64_t bytes;  /* of the matrix */
    uint64_t forward_calls; /* as in tdsp_build_report, of all pairs */
    uint64_t reverse_calls; /* likewise */
    size_t source;      /* on an error of a pair: which; else the numbers of sources and destinations */
    size_t destination; /* likewise */
} tdsp_matrix_report;

/**
 * Build the tables of all pairs into one matrix.
 *
 * @param plan      the pairs, and where their oracles come from
 * @param options   for each table; of its world, speed and units count. `workers` must be NULL: where there is run_tasks, whole pairs are its tasks, spread
 *                  over worker_count workers (0: one), and progress is told the number of pairs
 * @param report    may be NULL; filled also when a pair fails
 * @return TDSP_OK, also where no pair has a way; TDSP_INVALID_ARGUMENT; TDSP_NO_MEMORY; the error of the first pair that fails, as tdsp_build().
 *         `bytes` and `length` are untouched unless TDSP_OK. Free with tdsp_bytes_free().
 *
 * The bytes do not depend on the number of workers. Since 0.1.
 */
TDSP_API tdsp_status tdsp_matrix_build(const tdsp_matrix_plan *plan, const tdsp_build_options *options, const tdsp_allocator *allocator,
                                       void **bytes, size_t *length, tdsp_matrix_report *report);

#ifdef __cplusplus
}
#endif

#endif
