/* SPDX-License-Identifier: MIT */
/*
 * Public functions without memory: worlds to call them in, a heap whose allocations fail, and what a call said, to be compared.
 */
#ifndef SUPPORT_SCARCE_H
#define SUPPORT_SCARCE_H

#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include "support/tight.h"
#include "tdsp/tdsp.h"

enum { SCARCE_DISCS = 12, SCARCE_LEGS = 64, SCARCE_TOLD = 1024, SCARCE_BLANK = 0x5a };

/* Two discs that close a gap, many of rates of their own, two whose rates change. */
typedef enum scarce_world { SCARCE_GATE, SCARCE_MANY, SCARCE_BENT, SCARCE_WORLDS } scarce_world;

extern const tdsp_journey scarce_journey;
extern const tdsp_ends scarce_aside; /* other ends in all of them */
extern const tdsp_growing_disc scarce_bent[2];
const tdsp_disc *scarce_discs(size_t *count, scarce_world kind); /* of the first two */

/* What a call starts from. All memory is the heap's. */
typedef struct scarce {
    tight_heap heap;
    tdsp_allocator memory;
    scarce_world kind;
    tdsp_scene *scene;
    tdsp_solver *solver; /* that has not been asked yet */
} scarce;

/* They fail the test unless all goes well, and when anything is left. */
void scarce_open(scarce *f, scarce_world kind);
void scarce_close(scarce *f);

/* Options for a small table of the scene. */
tdsp_build_options scarce_options(const tdsp_scene *scene);

/* A path, of departure 1, and a table of each world, made with memory. */
typedef struct scarce_made {
    tdsp_leg legs[SCARCE_LEGS];
    size_t leg_count;
    double arrival;
    void *bytes;
    size_t length;
    tdsp_table table;
} scarce_made;
const scarce_made *scarce_made_of(scarce_world kind);

/* What a call said, as numbers in order. */
typedef struct scarce_answer {
    size_t count;
    double told[SCARCE_TOLD];
} scarce_answer;

void scarce_tell(scarce_answer *a, double number);
void scarce_tell_whole(scarce_answer *a, uint64_t number);
void scarce_tell_path(scarce_answer *a, const tdsp_solver *solver);

/* The status; the test fails when it is an error and the output is not blank any more. */
tdsp_status scarce_left(tdsp_status status, const void *output, size_t size);

#define BLANKED(type, name) \
    type name;              \
    memset(&name, SCARCE_BLANK, sizeof name)
#define LEFT(status, output) scarce_left((status), &(output), sizeof(output))

typedef struct scarce_call {
    const char *function;
    tdsp_status (*call)(scarce *f, scarce_answer *a);
} scarce_call;

/*
 * Each call in each world, without each of its allocations, once alone and once with all after it: it says so or does without, its outputs
 * are untouched, the same call with memory then answers in full, and nothing is left. Of a call with over 64 allocations the first 64 (the
 * environment's SCARCE_ALL: so many) and then ever fewer. Prints how many failed.
 */
void scarce_try(const scarce_call *calls, size_t count);

#endif
