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

#include <stdio.h>
#include <stdlib.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include "faults/inject.h"

#define EXPORTED __attribute__((visibility("default")))

EXPORTED void _fail(const char *file, int line)
{
    print_error("%s:%d: failed\n", file, line);
    fflush(NULL);
    if (inject_is_victim()) inject_end_victim(VICTIM_REFUSED);
    inject_leave(1);
}

static uint64_t number_of(const char *name, uint64_t otherwise)
{
    const char *text = getenv(name);
    return text ? strtoull(text, NULL, 10) : otherwise;
}

static inject_plan plan_given(void)
{
    return (inject_plan){.all = number_of("FAULTS_ALL", 3000),
                         .each_path = number_of("FAULTS_EACH_PATH", 2),
                         .depth = (int)number_of("FAULTS_DEPTH", 64),
                         .stop = number_of("FAULTS_STOP", 0),
                         .once_only = (int)number_of("FAULTS_ONCE_ONLY", 0),
                         .at = number_of("FAULTS_AT", 0),
                         .cpu_limit = (unsigned)number_of("FAULTS_CPU_LIMIT", 120)};
}

static void run_here(const struct CMUnitTest *test, inject_tally *tally, const void *stack_top, int log)
{
    const inject_plan plan = plan_given();
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
    if (!sound) printf("finding: %s: the test fails by itself\n", name);
    printf("test %s allocations %llu failed %llu victims %llu refused %llu endured %llu findings %llu threaded %llu paths %llu stopped %llu\n",
           name,
           (unsigned long long)t->allocations, (unsigned long long)t->failed, (unsigned long long)t->victims, (unsigned long long)t->refused,
           (unsigned long long)t->endured, (unsigned long long)t->findings + (sound ? 0 : 1), (unsigned long long)t->threaded,
           (unsigned long long)t->paths, (unsigned long long)t->stopped);
    return !sound || t->findings > 0;
}

EXPORTED int _cmocka_run_group_tests(const char *group, const struct CMUnitTest *const tests, const size_t count, CMFixtureFunction setup,
                                     CMFixtureFunction teardown)
{
    FILE *log = tmpfile();
    inject_tally *tally = mmap(NULL, sizeof *tally, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    int failed = 0;
    (void)group;
    if (!log || tally == MAP_FAILED || setup || teardown) abort(); /* no test here has a group's setup */
    for (size_t i = 0; i < count; i++) {
        *tally = (inject_tally){0};
        int sound = run_in_process(&tests[i], tally, fileno(log));
        failed += shown(tests[i].name, tally, sound);
    }
    fclose(log);
    munmap(tally, sizeof *tally);
    return failed;
}
