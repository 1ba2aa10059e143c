/* SPDX-License-Identifier: MIT */
/*
 * Label setting: labels are expanded in the order of time + bound. With a consistent bound that order never goes back, so a label
 * is final when it is taken.
 */
#include "search/search.h"

#include <math.h>

tdsp_status tdsp_search_create(const tdsp_allocator *allocator, tdsp_search **out)
{
    if (!out) return TDSP_INVALID_ARGUMENT;
    tdsp_allocator memory = memory_allocator(allocator);
    tdsp_search *search = memory_array(&memory, 1, sizeof *search);
    if (!search) return TDSP_NO_MEMORY;
    search->allocator = memory;
    heap_init(&search->open);
    search->limit = INFINITY;
    search->problem = NULL;
    search->taken = 0;
    *out = search;
    return TDSP_OK;
}

void tdsp_search_free(tdsp_search *search)
{
    if (!search) return;
    tdsp_allocator memory = search->allocator;
    heap_free(&search->open, &memory);
    memory_free(&memory, search, sizeof *search);
}

void tdsp_search_limit(tdsp_search *search, double limit)
{
    search->limit = limit;
}

tdsp_status tdsp_search_push(tdsp_search *search, const tdsp_label *label)
{
    if (!search || !label || !search->problem || isnan(label->time)) return TDSP_INVALID_ARGUMENT;
    const tdsp_search_problem *problem = search->problem;
    double key = label->time + (problem->bound ? problem->bound(problem->ctx, label) : 0.0);
    if (isnan(key)) return TDSP_INVALID_ARGUMENT;
    if (key > search->limit) return TDSP_OK;
    return heap_push(&search->open, &search->allocator, key, *label);
}

static tdsp_status search_loop(tdsp_search *search, int *done)
{
    while (search->open.count > 0 && !*done) {
        tdsp_label label = heap_pop(&search->open);
        ++search->taken;
        tdsp_status status = search->problem->expand(search->problem->ctx, &label, search, done);
        if (status != TDSP_OK) return status;
    }
    return TDSP_OK;
}

tdsp_status tdsp_search_run(tdsp_search *search, const tdsp_search_problem *problem, const tdsp_label *starts, size_t count,
                            int *done)
{
    if (!search || !problem || problem->size < sizeof *problem || !problem->expand || (count && !starts))
        return TDSP_INVALID_ARGUMENT;
    int ended = 0;
    tdsp_status status = TDSP_OK;
    heap_clear(&search->open);
    search->problem = problem;
    search->limit = INFINITY;
    for (size_t i = 0; i < count && status == TDSP_OK; ++i) status = tdsp_search_push(search, &starts[i]);
    if (status == TDSP_OK) status = search_loop(search, &ended);
    search->problem = NULL;
    if (status == TDSP_OK && done) *done = ended;
    return status;
}
