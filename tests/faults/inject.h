/* SPDX-License-Identifier: MIT */
/*
 * Failing the library's allocations under a CMocka test, each in a process of its own.
 *
 * Everything that the library allocates goes through src/scene/allocator.h (tests/check_objects.py holds it to that), so that is where these
 * programs are cut open (memory.h). The test runs once. At each allocation it forks: in the child, the victim, the allocation fails
 * and the test goes on as it can; the test itself goes on with memory. So each victim costs what comes after its failure, not what came before.
 */
#ifndef FAULTS_INJECT_H
#define FAULTS_INJECT_H

#include <stddef.h>
#include <stdint.h>

/* How a victim ends that did nothing wrong. Any other end is a finding. */
enum {
    VICTIM_REFUSED = 77, /* at the first assertion that fails, for the test had counted on memory */
    VICTIM_ENDURED = 78, /* with the end of the test: nothing was missing, or the test expects it */
    VICTIM_LEAKED = 79   /* either way, with a block that nothing points to any more */
};

/* What became of a test's allocations. In memory that the test shares with the program that started it. */
typedef struct inject_tally {
    uint64_t allocations; /* requests for memory */
    uint64_t failed;      /* of them, those that failed in a victim */
    uint64_t victims;
    uint64_t refused;
    uint64_t endured;
    uint64_t findings;
    uint64_t threaded; /* requests while more than one thread ran: a fork would lose the others, so none failed */
    uint64_t paths;    /* different ways through the calls to an allocation */
    uint64_t stopped;  /* 1: the plan's `stop` came before the test's end */
} inject_tally;

typedef struct inject_plan {
    uint64_t all;       /* of a test's allocations the first so many fail, and then one in k / all at number k */
    uint64_t each_path; /* and the first so many that are reached by the same calls */
    int depth;          /* so many calls count, the innermost */
    uint64_t stop;      /* the test ends after so many; 0: never */
    int once_only;      /* only the one fails; else a second victim also loses all that come after it */
    uint64_t at;        /* not 0: only this one */
    unsigned cpu_limit; /* seconds of a victim; then it hangs */
} inject_plan;

/* From here on allocations of this process are counted, and fail in victims. `stack_top` is the address of a frame above the test's. */
void inject_begin(const inject_plan *plan, inject_tally *tally, const char *test, const void *stack_top, int log);
void inject_end(void);

/* The end of a process that runs a test: what it covered is kept. */
void inject_leave(int status);

/* Is this process a victim? Then this ends it. */
int inject_is_victim(void);
void inject_end_victim(int status);

#endif
