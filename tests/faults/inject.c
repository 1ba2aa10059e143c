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
#include <sys/time.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include <sanitizer/lsan_interface.h>

#include "faults/blocks.h"
#include "faults/memory.h"
#include "faults/rewind.h"

/* There only where a sanitizer or the measuring of coverage brings them. */
#pragma weak __lsan_do_recoverable_leak_check
#pragma weak __llvm_profile_write_file
int __llvm_profile_write_file(void);

enum { PATHS = 1 << 16, PATIENCE = 500, REWIND_SECONDS = 10 };

static struct {
    inject_plan plan;
    inject_tally *tally; /* NULL: nothing is counted */
    const char *test;
    const char *stack_top;
    int log;
    int out; /* the program's output; that of the test goes to the log */
    int rewinds;
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
    if (rewind_is_under_way()) rewind_back(blocks_are_reached(now.stack_top) ? status : REWIND_UNSURE);
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

void inject_print_log(void)
{
    char line[4096];
    off_t at = 0;
    for (ssize_t got; (got = pread(now.log, line, sizeof line, at)) > 0; at += got)
        if (write(now.out, line, (size_t)got) != got) break;
}

static void empty_log(void)
{
    fflush(NULL);
    if (ftruncate(now.log, 0) != 0 || lseek(now.log, 0, SEEK_SET) != 0) abort();
}

/* 0 when `status` is none of a victim that did nothing wrong. */
static int count_end(int status)
{
    uint64_t *kind = status == VICTIM_REFUSED ? &now.tally->refused : status == VICTIM_ENDURED ? &now.tally->endured : status == VICTIM_CUT ? &now.tally->cut : NULL;
    if (kind) ++*kind;
    return kind != NULL;
}

static void judge(int end, int fail_all)
{
    char text[64];
    now.tally->victims++;
    if (WIFEXITED(end) && count_end(WEXITSTATUS(end))) return;
    now.tally->findings++;
    dprintf(now.out, "finding: %s: without allocation %llu%s it %s\n", now.test, (unsigned long long)now.number, fail_all ? " and all after it" : "",
            describe(end, text, sizeof text));
    inject_print_log();
}

/*
 * True in the victim: the allocation is to fail. One thread runs, so nothing is locked, and the handlers of fork() need not be called: the sanitizer's
 * goes through four megabytes of locks.
 */
static int fork_victim(int fail_all, uint64_t left)
{
    int end;
    empty_log();
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

static int is_over(void)
{
    return (now.plan.until && (uint64_t)time(NULL) >= now.plan.until) || (now.plan.turn && (uint64_t)clock() / CLOCKS_PER_SEC >= now.plan.turn);
}

static void leave_test(void)
{
    fflush(NULL);
    inject_leave(0);
}

/* One that hangs takes the process with it, and has more time in its fork. */
static void limit_time(unsigned seconds)
{
    const struct itimerval limit = {{0, 0}, {(time_t)seconds, 0}};
    setitimer(ITIMER_VIRTUAL, &limit, NULL);
}

/* As rewind_save(), from which it may come back a second time. */
static int rewind_victim(int fail_all, uint64_t left)
{
    const int result = rewind_save(now.stack_top);
    now.victim = result == REWIND_SAVED;
    now.fail_all = fail_all;
    now.left = left;
    now.in_vain = 0;
    return result;
}

/* True in a victim, which comes back here if it is rewound. */
static int fail_here(int fail_all, uint64_t left, int by_fork)
{
    if (by_fork || !now.rewinds || now.number == now.tally->avoid) return fork_victim(fail_all, left);
    now.tally->trying = now.number;
    limit_time(now.plan.cpu_limit < REWIND_SECONDS ? now.plan.cpu_limit : REWIND_SECONDS);
    const int result = rewind_victim(fail_all, left);
    if (result == REWIND_SAVED) return 1;
    limit_time(0);
    now.tally->trying = 0;
    if (!count_end(result)) return fork_victim(fail_all, left);
    now.tally->victims++;
    if (++now.tally->rewound % 1024 == 0) empty_log();
    return 0;
}

/* True in a victim. */
static int fail_this(uint64_t met)
{
    const inject_plan *p = &now.plan;
    const int first = met <= p->each_path;
    const uint64_t left = first ? 100 * p->after : p->after;
    const int alone = is_chosen(now.number, met, p->all), with_others = !p->once_only && is_chosen(now.number, met, p->all_after);
    if ((alone && fail_here(0, left, first)) || (with_others && fail_here(1, left, first))) return 1;
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
    if (is_over()) leave_test();
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
    now.out = dup(STDOUT_FILENO);
    dup2(log, STDOUT_FILENO);
    dup2(log, STDERR_FILENO);
    blocks_begin();
    now.rewinds = plan->rewind && rewind_is_possible();
}

void inject_end(void)
{
    if (now.victim) return;
    now.tally->whole = 1;
    now.tally = NULL;
}
