/* SPDX-License-Identifier: MIT */
/*
 * Label-setting search on a binary heap: Dijkstra and A* over whatever `expand` unfolds. The disc engine runs on it,
 * and a graph can.
 */
#ifndef TDSP_SEARCH_H
#define TDSP_SEARCH_H

#include "tdsp/status.h"
#include "tdsp/types.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Something reached, or still to be confirmed, at a time. What `id` and `kind` mean is the problem's business. */
typedef struct tdsp_label {
    double time;   /* when */
    uint32_t id;   /* for the problem */
    uint32_t kind; /* for the problem */
} tdsp_label;

/** The open labels. Reusable: a run empties it and keeps its memory. */
typedef struct tdsp_search tdsp_search;

/** What is searched. */
typedef struct tdsp_search_problem {
    size_t size; /* sizeof(tdsp_search_problem) */
    void *ctx;   /* handed to each callback */

    /* A lower bound on the time from the label to the goal, not negative, consistent: along any expansion label.time + bound
     * never decreases. NULL is zero: Dijkstra. Called once for each label pushed. */
    double (*bound)(void *ctx, const tdsp_label *label);

    /* Called with the labels in the order of time + bound (ties: first pushed, first served). Pushes what follows with tdsp_search_push(),
     * none before this label's time + bound. Sets *done to 1 to end the search. An error ends it too. */
    tdsp_status (*expand)(void *ctx, const tdsp_label *label, tdsp_search *open, int *done);
} tdsp_search_problem;

/** Make an empty search. TDSP_OK, TDSP_INVALID_ARGUMENT or TDSP_NO_MEMORY. Since 0.1. */
TDSP_API tdsp_status tdsp_search_create(const tdsp_allocator *allocator, tdsp_search **out);

/** Free it; NULL is allowed. Since 0.1. */
TDSP_API void tdsp_search_free(tdsp_search *search);

/**
 * Run until `expand` says done or no label is left.
 *
 * @param starts  `count` labels to begin with
 * @param done    receives 1 when `expand` ended the search, 0 when the labels ran out; may be NULL
 * @return TDSP_OK; TDSP_INVALID_ARGUMENT; TDSP_NO_MEMORY; whatever expand returned that is not TDSP_OK
 *
 * O(m log m) for m pushed labels besides the callbacks. Since 0.1.
 */
TDSP_API tdsp_status tdsp_search_run(tdsp_search *search, const tdsp_search_problem *problem, const tdsp_label *starts,
                                     size_t count, int *done);

/** Add a label: from inside `expand` only. TDSP_OK, TDSP_INVALID_ARGUMENT (a time that is NaN), TDSP_NO_MEMORY. Since 0.1. */
TDSP_API tdsp_status tdsp_search_push(tdsp_search *search, const tdsp_label *label);

/** Labels with time + bound over `limit` are dropped when pushed, from now to the end of the run. Starts infinite. Since 0.1. */
TDSP_API void tdsp_search_limit(tdsp_search *search, double limit);

#ifdef __cplusplus
}
#endif

#endif
