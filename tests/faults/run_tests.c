/* SPDX-License-Identifier: MIT */
/*
 * In the place of CMocka's runner: each test of a group in a process of its own, with its allocations failing in victims.
 *
 * The linker finds these two functions before libcmocka's. A victim ends at its first failed assertion: what a test does after one, CMocka never does
 * either. Its frames are still there then, so whatever it holds has a pointer to it, and what has none is lost.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include "faults/inject.h"

#define EXPORTED __attribute__((visibility("default")))

EXPORTED void _fail(const char *file, int line)
{
    if (inject_is_victim()) inject_end_victim(VICTIM_REFUSED);
    print_error("%s:%d: failed\n", file, line);
    fflush(NULL);
    inject_leave(1);
}

static uint64_t number_of(const char *name, uint64_t otherwise)
{
    const char *text = getenv(name);
    return text ? strtoull(text, NULL, 10) : otherwise;
}

static inject_plan plan_given(void)
{
    return (inject_plan){.all = number_of("FAULTS_ALL", UINT64_MAX),
                         .all_after = number_of("FAULTS_ALL_AFTER", UINT64_MAX),
                         .each_path = number_of("FAULTS_EACH_PATH", 1),
                         .depth = (int)number_of("FAULTS_DEPTH", 64),
                         .stop = number_of("FAULTS_STOP", 0),
                         .once_only = (int)number_of("FAULTS_ONCE_ONLY", 0),
                         .at = number_of("FAULTS_AT", 0),
                         .after = number_of("FAULTS_AFTER", 50),
                         .rewind = (int)number_of("FAULTS_REWIND", 1),
                         .until = number_of("FAULTS_UNTIL", 0),
                         .turn = number_of("FAULTS_TURN", 0),
                         .cpu_limit = (unsigned)number_of("FAULTS_CPU_LIMIT", 120)};
}

static void run_here(const struct CMUnitTest *test, inject_tally *tally, const void *stack_top, int log)
{
    const inject_plan plan = plan_given();
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    void *state = test->initial_state;
    inject_begin(&plan, tally, test->name, stack_top, log);
    if (test->setup_func && test->setup_func(&state) != 0) _fail(test->name, 0);
    test->test_func(&state);
    if (test->teardown_func && test->teardown_func(&state) != 0) _fail(test->name, 0);
    inject_end();
    fflush(NULL);
    if (inject_is_victim()) inject_end_victim(VICTIM_ENDURED);
    inject_leave(0);
}

/* True unless the test itself went wrong. */
static int run_in_process(const struct CMUnitTest *test, inject_tally *tally, int log)
{
    int end;
    fflush(NULL);
    pid_t child = fork();
    if (child < 0) abort();
    if (child == 0) run_here(test, tally, __builtin_frame_address(0), log);
    if (waitpid(child, &end, 0) != child) abort();
    return WIFEXITED(end) && WEXITSTATUS(end) == 0;
}

static int shown(const char *name, const inject_tally *t, int sound)
{
    const struct {
        const char *what;
        uint64_t count;
    } told[] = {{"allocations", t->allocations}, {"failed", t->failed},     {"victims", t->victims},   {"refused", t->refused},
                {"endured", t->endured},         {"cut", t->cut},           {"threaded", t->threaded}, {"paths", t->paths},
                {"rewound", t->rewound},         {"searched", t->searched},       {"stopped", t->stopped},   {"unfinished", !t->whole}, {"findings", t->findings + !sound}};
    if (!sound) printf("finding: %s: the test fails by itself, after %llu allocations\n", name, (unsigned long long)t->allocations);
    printf("test %s", name);
    for (size_t i = 0; i < sizeof told / sizeof told[0]; i++) printf(" %s %llu", told[i].what, (unsigned long long)told[i].count);
    printf("\n");
    return !sound || t->findings > 0;
}

/* The tallies of `count` tests: in the file that FAULTS_TALLY names, as an earlier run left them, however it ended; without a name, from nothing. */
static inject_tally *tallies_of(size_t count)
{
    const char *name = getenv("FAULTS_TALLY");
    const size_t size = count * sizeof(inject_tally);
    int file = name ? open(name, O_RDWR | O_CREAT, 0666) : -1;
    if (name && (file < 0 || ftruncate(file, (off_t)size) != 0)) abort();
    inject_tally *tallies = mmap(NULL, size, PROT_READ | PROT_WRITE, MAP_SHARED | (name ? 0 : MAP_ANONYMOUS), file, 0);
    if (tallies == MAP_FAILED) abort();
    if (name) close(file);
    return tallies;
}

/* Requests of a test with threads have other numbers each time: it is not gone on with, but begun anew. */
static int run_or_go_on(const struct CMUnitTest *test, inject_tally *tally, int log)
{
    if (tally->whole) return 1;
    if (tally->threaded > 0) *tally = (inject_tally){0};
    tally->trying = 0;
    while (!run_in_process(test, tally, log)) {
        if (tally->trying == 0 || tally->trying == tally->avoid) return 0;
        tally->avoid = tally->trying;
    }
    return 1;
}

EXPORTED int _cmocka_run_group_tests(const char *group, const struct CMUnitTest *const tests, const size_t count, CMFixtureFunction setup,
                                     CMFixtureFunction teardown)
{
    FILE *log = tmpfile();
    inject_tally *tallies = tallies_of(count);
    int failed = 0;
    (void)group;
    if (!log || setup || teardown) abort(); /* no test here has a group's setup */
    for (size_t i = 0; i < count; i++) {
        int sound = run_or_go_on(&tests[i], &tallies[i], fileno(log));
        failed += shown(tests[i].name, &tallies[i], sound);
    }
    fclose(log);
    munmap(tallies, count * sizeof *tallies);
    return failed;
}
