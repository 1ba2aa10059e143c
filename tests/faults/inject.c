/* SPDX-License-Identifier: MIT */
/* Which allocations fail, and in whom. */
#define _GNU_SOURCE /* _Fork */
#include "faults/inject.h"

#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include <sanitizer/lsan_interface.h>

#include "faults/blocks.h"
#include "faults/memory.h"

/* There only where a sanitizer or the measuring of coverage brings them. */
#pragma weak __lsan_do_recoverable_leak_check
#pragma weak __llvm_profile_write_file
int __llvm_profile_write_file(void);

enum { PATHS = 1 << 16, PATIENCE = 500 };

static struct {
    inject_plan plan;
    inject_tally *tally; /* NULL: nothing is counted */
    const char *test;
    const char *stack_top;
    int log;
    int victim;
    int fail_all; /* in a victim: whatever comes */
    int in_vain;  /* and so many have come */
    uint64_t left;   /* in a victim with memory: so many requests until it is cut short */
    uint64_t number; /* of the last request */
    uint64_t from;   /* the number from which on they fail, less 1 */
} now;

/* How often each path was met, by its hash; 0 is an empty place. Shared with the victims, which do not look, so that no fork copies it. */
typedef struct path_count {
    uint64_t hash;
    uint64_t count;
} path_count;
static path_count *paths;

int inject_is_victim(void)
{
    return now.victim;
}

void inject_leave(int status)
{
    if (__llvm_profile_write_file) __llvm_profile_write_file();
    _exit(status);
}

static int has_leaked(void)
{
    if (!__lsan_do_recoverable_leak_check || blocks_are_reached(now.stack_top)) return 0;
    now.tally->searched++;
    return __lsan_do_recoverable_leak_check();
}

void inject_end_victim(int status)
{
    inject_leave(has_leaked() ? VICTIM_LEAKED : status);
}

/* The return addresses on the way up to the test, from the wrapper's caller on. Frames are read raw: their red zones are not ours to respect. */
__attribute__((no_sanitize("address", "undefined"), noinline)) static uint64_t path_hash(void)
{
    const char *frame = __builtin_frame_address(0), *above;
    uint64_t hash = 14695981039346656037u;
    for (int depth = 0; depth < now.plan.depth; depth++, frame = above) {
        void *caller;
        memcpy(&above, frame, sizeof above);
        memcpy(&caller, frame + sizeof above, sizeof caller);
        hash = (hash ^ (uintptr_t)caller) * 1099511628211u;
        if (above <= frame || above >= now.stack_top || (uintptr_t)above % sizeof above != 0) break;
    }
    return hash | 1;
}

static uint64_t count_path(uint64_t hash)
{
    for (uint64_t i = hash % PATHS, looked = 0; looked < PATHS; i = (i + 1) % PATHS, looked++) {
        if (paths[i].hash == 0) {
            paths[i].hash = hash;
            now.tally->paths++;
        }
        if (paths[i].hash == hash) return ++paths[i].count;
    }
    return UINT64_MAX; /* full: known no more */
}

/* The same choice in every run: a multiplicative hash of the number. */
static int is_chosen(uint64_t number, uint64_t met, uint64_t all)
{
    if (now.plan.at) return number == now.plan.at;
    if (met <= now.plan.each_path || number <= all) return 1;
    if (all == 0) return 0;
    return (number * 11400714819323198485u >> 32) % (number / all + 1) == 0;
}

static int is_alone(void)
{
    struct stat tasks;
    return stat("/proc/self/task", &tasks) == 0 && tasks.st_nlink == 3;
}

static void become_victim(int fail_all, uint64_t left)
{
    const struct rlimit no_core = {0, 0}, cpu = {now.plan.cpu_limit, now.plan.cpu_limit};
    now.victim = 1;
    now.fail_all = fail_all;
    now.left = left;
    dup2(now.log, STDOUT_FILENO);
    dup2(now.log, STDERR_FILENO);
    setrlimit(RLIMIT_CORE, &no_core);
    setrlimit(RLIMIT_CPU, &cpu);
}

static const char *describe(int end, char *text, size_t room)
{
    if (WIFEXITED(end) && WEXITSTATUS(end) == VICTIM_LEAKED) return "leaks";
    if (WIFSIGNALED(end) && (WTERMSIG(end) == SIGKILL || WTERMSIG(end) == SIGXCPU)) return "hangs";
    if (WIFSIGNALED(end))
        snprintf(text, room, "dies of signal %d", WTERMSIG(end));
    else
        snprintf(text, room, "ends with status %d", WEXITSTATUS(end));
    return text;
}

static void print_log(void)
{
    char line[4096];
    lseek(now.log, 0, SEEK_SET);
    for (ssize_t got; (got = read(now.log, line, sizeof line)) > 0;)
        if (write(STDOUT_FILENO, line, (size_t)got) != got) break;
}

static void judge(int end, int fail_all)
{
    char text[64];
    now.tally->victims++;
    if (WIFEXITED(end) && WEXITSTATUS(end) == VICTIM_REFUSED) {
        now.tally->refused++;
    } else if (WIFEXITED(end) && WEXITSTATUS(end) == VICTIM_ENDURED) {
        now.tally->endured++;
    } else if (WIFEXITED(end) && WEXITSTATUS(end) == VICTIM_CUT) {
        now.tally->cut++;
    } else {
        now.tally->findings++;
        printf("finding: %s: without allocation %llu%s it %s\n", now.test, (unsigned long long)now.number,
               fail_all ? " and all after it" : "", describe(end, text, sizeof text));
        fflush(stdout);
        print_log();
    }
}

/*
 * True in the victim: the allocation is to fail. One thread runs, so nothing is locked, and the handlers of fork() need not be called: the sanitizer's
 * goes through four megabytes of locks.
 */
static int fork_victim(int fail_all, uint64_t left)
{
    int end;
    fflush(NULL);
    if (ftruncate(now.log, 0) != 0 || lseek(now.log, 0, SEEK_SET) != 0) abort();
    pid_t victim = _Fork();
    if (victim < 0) abort();
    if (victim == 0) {
        become_victim(fail_all, left);
        return 1;
    }
    if (waitpid(victim, &end, 0) != victim) abort();
    judge(end, fail_all);
    return 0;
}

/* A test that tries again until there is memory would do so for ever. */
static int fail_again(void)
{
    if (++now.in_vain == PATIENCE) inject_end_victim(VICTIM_ENDURED);
    return 1;
}

/* There is memory for a victim that has done without once, until it is cut short; not while it has threads, which would go on. */
static int go_on(void)
{
    if (now.left > 0)
        now.left--;
    else if (is_alone())
        inject_end_victim(VICTIM_CUT);
    return 0;
}

static void leave_test(void)
{
    fflush(NULL);
    inject_leave(0);
}

/* True in a victim. */
static int fail_this(uint64_t met)
{
    const inject_plan *p = &now.plan;
    const uint64_t after = met <= p->each_path ? 100 * p->after : p->after;
    const int alone = is_chosen(now.number, met, p->all), with_others = !p->once_only && is_chosen(now.number, met, p->all_after);
    if ((alone && fork_victim(0, after)) || (with_others && fork_victim(1, after))) return 1;
    now.tally->failed += (uint64_t)(alone || with_others);
    now.tally->allocations = now.number;
    return 0;
}

int memory_must_fail(void)
{
    if (now.victim) return now.fail_all ? fail_again() : go_on();
    if (!now.tally) return 0;
    if (!is_alone()) {
        __atomic_add_fetch(&now.tally->threaded, 1, __ATOMIC_RELAXED);
        return 0;
    }
    if (now.plan.stop && now.number >= now.plan.stop) {
        now.tally->stopped = now.tally->whole = 1;
        leave_test();
    }
    if (now.plan.until && (uint64_t)time(NULL) >= now.plan.until) leave_test();
    now.number++;
    const uint64_t met = count_path(path_hash());
    return now.number > now.from && fail_this(met);
}

void inject_begin(const inject_plan *plan, inject_tally *tally, const char *test, const void *stack_top, int log)
{
    paths = mmap(NULL, PATHS * sizeof *paths, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (paths == MAP_FAILED) abort();
    now.plan = *plan;
    now.tally = tally;
    now.test = test;
    now.stack_top = stack_top;
    now.log = log;
    now.from = tally->allocations;
    tally->paths = tally->threaded = 0; /* told again on the way there */
    blocks_begin();
}

void inject_end(void)
{
    if (now.victim) return;
    now.tally->whole = 1;
    now.tally = NULL;
}
