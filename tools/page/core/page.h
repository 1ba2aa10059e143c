/* SPDX-License-Identifier: MIT */
/*
 * The library for JavaScript: the public C interface behind functions that a WebAssembly module exports.
 *
 * Only numbers cross. What has a fixed number of parts is written to an array of doubles that the caller hands over; what has not comes as
 * PageNumbers, which the caller releases. Indices and counts are doubles there as well: all are below 2^53. The other side of every layout is in
 * tools/page/js/core_*.js; both change together.
 */
#ifndef PAGE_H
#define PAGE_H

#include "tdsp/tdsp.h"

/* The name that JavaScript calls a function by. */
#define PAGE_EXPORT(name) __attribute__((export_name(#name)))

/* An array from page_allocate(). */
typedef struct PageNumbers {
    double *at;
    size_t count;
} PageNumbers;

/* A scene, and the one solver that answers all questions to it. */
typedef struct PageScene {
    tdsp_scene *scene;
    tdsp_solver *solver;
} PageScene;

/* memory.c: everything is allocated here, so that what is still held can be counted. */
extern const tdsp_allocator page_allocator;
void *page_allocate(size_t size);
void page_release(void *block);
/* Room for `count` numbers. TDSP_OK or TDSP_NO_MEMORY. */
tdsp_status page_numbers(size_t count, PageNumbers *out);

/* progress.c: told to JavaScript; its answer other than 0 cancels. */
int page_progress(void *ctx, double settled, double all);

/* legs.c: PAGE_LEG_NUMBERS numbers each, in the order of tdsp_leg's members. */
#define PAGE_LEG_NUMBERS 20
double *page_leg_write(const tdsp_leg *leg, double *at);
/* first, second, time, x, y */
#define PAGE_GAP_NUMBERS 5
double *page_gap_write(const tdsp_gap *gap, double *at);
tdsp_status page_legs_write(const tdsp_leg *legs, size_t count, PageNumbers *out);

#endif
