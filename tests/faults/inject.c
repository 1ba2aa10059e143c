/* SPDX-License-Identifier: MIT */
/* Which allocations fail, and in whom. */
#include "faults/inject.h"

#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <sanitizer/lsan_interface.h>

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
} now;

/* How often each path was met, by its hash; 0 is an empty place. Shared by the tests of a program, which run in processes of their own. */
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

void inject_end_victim(int status)
{
    inject_leave(__lsan_do_recoverable_leak_check && __lsan_do_recoverable_leak_check() ? VICTIM_LEAKED : status);
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
static int is_chosen(uint64_t number, uint64_t met)
{
    if (now.plan.at) return number == now.plan.at;
    if (met <= now.plan.each_path || number <= now.plan.all) return 1;
    if (now.plan.all == 0) return 0;
    return (number * 11400714819323198485u >> 32) % (number / now.plan.all + 1) == 0;
}

static int is_alone(void)
{
    struct stat tasks;
    return stat("/proc/self/task", &tasks) == 0 && tasks.st_nlink == 3;
}

static void become_victim(int fail_all)
{
    const struct rlimit no_core = {0, 0}, cpu = {now.plan.cpu_limit, now.plan.cpu_limit};
    now.victim = 1;
    now.fail_all = fail_all;
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
    } else {
        now.tally->findings++;
        printf("finding: %s: without allocation %llu%s it %s\n", now.test, (unsigned long long)now.tally->allocations,
               fail_all ? " and all after it" : "", describe(end, text, sizeof text));
        fflush(stdout);
        print_log();
    }
}

/* True in the victim: the allocation is to fail. */
static int fork_victim(int fail_all)
{
    int end;
    fflush(NULL);
    if (ftruncate(now.log, 0) != 0 || lseek(now.log, 0, SEEK_SET) != 0) abort();
    pid_t victim = fork();
    if (victim < 0) abort();
    if (victim == 0) {
        become_victim(fail_all);
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

int memory_must_fail(void)
{
    if (now.victim) return now.fail_all && fail_again();
    if (!now.tally) return 0;
    if (!is_alone()) {
        __atomic_add_fetch(&now.tally->threaded, 1, __ATOMIC_RELAXED);
        return 0;
    }
    if (now.plan.stop && now.tally->allocations >= now.plan.stop) {
        now.tally->stopped = 1;
        fflush(NULL);
        inject_leave(0);
    }
    uint64_t number = ++now.tally->allocations, met = count_path(path_hash());
    if (!is_chosen(number, met)) return 0;
    now.tally->failed++;
    return fork_victim(0) || (!now.plan.once_only && fork_victim(1));
}

void inject_begin(const inject_plan *plan, inject_tally *tally, const char *test, const void *stack_top, int log)
{
    now.plan = *plan;
    now.tally = tally;
    now.test = test;
    now.stack_top = stack_top;
    now.log = log;
}

void inject_end(void)
{
    now.tally = NULL;
}

__attribute__((constructor)) static void share_paths(void)
{
    paths = mmap(NULL, PATHS * sizeof *paths, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (paths == MAP_FAILED) abort();
}
