/* SPDX-License-Identifier: MIT */
/* The label-setting loop's own state. */
#ifndef SEARCH_SEARCH_H
#define SEARCH_SEARCH_H

#include "search/heap.h"

struct tdsp_search {
    tdsp_allocator allocator;
    label_heap open;
    double limit;
    const tdsp_search_problem *problem; /* of the run under way */
    uint64_t taken;                     /* labels taken from the heap since the search was made */
};

#endif
