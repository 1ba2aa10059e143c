/* SPDX-License-Identifier: MIT */
/*
 * Failing the library's allocations under a CMocka test, each in a process of its own.
 *
 * Everything that the library allocates goes through src/scene/allocator.h (tests/check_objects.py holds it to that), so that is where these
 * programs are cut open (memory.h). The test runs once. At each allocation it forks: in the child, the victim, the allocation fails
 * and the test goes on as it can; the test itself goes on with memory. So each victim costs what comes after its failure, not what came before; and
 * a victim that can do without goes on for a while only, for a test of n allocations that are all dispensable would be done n / 2 times.
 *
 * Most victims do without the fork: the process is saved and put back (rewind.h). One that ends well so is counted. One that does not, or cannot be
 * rewound, is forked after all, and one that takes the process with it is forked when the test is run again: a finding is always a fork's.
 */
#ifndef FAULTS_INJECT_H
#define FAULTS_INJECT_H

#include <stddef.h>
#include <stdint.h>

/* How a victim ends that did nothing wrong. Any other end is a finding. */
enum {
    VICTIM_REFUSED = 77, /* at the first assertion that fails, for the test had counted on memory */
    VICTIM_ENDURED = 78, /* with the end of the test: nothing was missing, or the test expects it */
    VICTIM_LEAKED = 79,  /* any way, with a block that nothing points to any more */
    VICTIM_CUT = 80      /* after as many more requests as it is given, having done without */
};

/* What became of a test's allocations. In memory that the test shares with the program that started it. */
typedef struct inject_tally {
    uint64_t allocations; /* requests for memory whose turn is over */
    uint64_t failed;      /* of them, those that failed in a victim */
    uint64_t victims;
    uint64_t refused;
    uint64_t endured;
    uint64_t cut; /* neither refused nor at the test's end before its requests were used up */
    uint64_t findings;
    uint64_t threaded; /* requests while more than one thread ran: a fork would lose the others, so none failed */
    uint64_t paths;    /* different ways through the calls to an allocation */
    uint64_t stopped;  /* 1: the plan's `stop` came before the test's end */
    uint64_t rewound;  /* victims without a fork */
    uint64_t searched; /* victims in which LeakSanitizer was asked (blocks.h) */
    uint64_t trying;   /* the number of a request whose victim is being rewound; 0: none */
    uint64_t avoid;    /* the number of one that took the process with it: it is forked */
    uint64_t whole;    /* 1: the test came to its end, or to `stop` */
} inject_tally;

typedef struct inject_plan {
    uint64_t all;       /* of a test's allocations the first so many fail alone, and then one in k / all at number k */
    uint64_t all_after; /* likewise, with all that come after */
    uint64_t each_path; /* and, both ways and in a fork, the first so many that are reached by the same calls */
    int depth;          /* so many calls count, the innermost */
    uint64_t stop;      /* the test ends after so many; 0: never */
    int once_only;      /* none fails with all that come after */
    uint64_t at;        /* not 0: only this one, both ways */
    uint64_t after;     /* a victim goes on for so many requests more; one of those of `each_path` a hundred times as long */
    int rewind;         /* may victims be rewound? */
    uint64_t until;     /* by the clock: the test ends then, to be gone on with; 0: never */
    uint64_t turn;      /* seconds of the processor after which the test ends, likewise; 0: never */
    unsigned cpu_limit; /* seconds of a victim; then it hangs */
} inject_plan;

/*
 * From here on allocations of this process are counted, and fail in victims. `stack_top` is the address of a frame above the test's. The tally goes on
 * from where it is: of its allocations none fails again. It is right at any moment, so that a process may be killed and its work gone on with.
 */
void inject_begin(const inject_plan *plan, inject_tally *tally, const char *test, const void *stack_top, int log);
void inject_end(void);

/* The end of a process that runs a test: what it covered is kept. */
void inject_leave(int status);

/* Is this process a victim? Then this ends it, or goes back to where it was none. */
int inject_is_victim(void);
void inject_end_victim(int status);

/* What victims and the test said, to the program's output. */
void inject_print_log(void);

#endif
