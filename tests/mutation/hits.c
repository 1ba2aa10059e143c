/* SPDX-License-Identifier: MIT */
/*
 * Which of these instructions does a program ever execute?
 *
 *     hits ADDRESSES PROGRAM       ADDRESSES: a file of addresses in hexadecimal, one a line; the program is not position-independent
 *
 * Each gets a breakpoint, which is taken away when it is met for the first time, so that the program soon runs at its own speed. The
 * addresses that were met are printed, one a line; the program's own output goes nowhere. Exits with 1 where the program fails.
 */
#define _POSIX_C_SOURCE 200809L

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ptrace.h>
#include <sys/types.h>
#include <sys/user.h>
#include <sys/wait.h>
#include <unistd.h>

#define MOST 65536
#define BREAKPOINT 0xccu

static unsigned long addresses[MOST];
static unsigned char bytes[MOST]; /* what stood there */
static size_t count;

static void die(const char *what)
{
    perror(what);
    exit(2);
}

static void read_addresses(const char *name)
{
    char line[64];
    FILE *file = fopen(name, "r");
    if (!file) die(name);
    while (count < MOST && fgets(line, sizeof line, file)) addresses[count++] = strtoul(line, NULL, 16);
    fclose(file);
}

static unsigned char swap_byte(pid_t child, unsigned long address, unsigned char byte)
{
    errno = 0;
    unsigned long word = (unsigned long)ptrace(PTRACE_PEEKTEXT, child, (void *)address, NULL);
    if (errno) die("hits: PTRACE_PEEKTEXT");
    unsigned long changed = (word & ~0xfful) | byte;
    if (ptrace(PTRACE_POKETEXT, child, (void *)address, (void *)changed) < 0) die("hits: PTRACE_POKETEXT");
    return (unsigned char)(word & 0xff);
}

static void run_program(char **argv)
{
    int nowhere = open("/dev/null", O_WRONLY);
    if (nowhere < 0 || dup2(nowhere, 1) < 0 || dup2(nowhere, 2) < 0) _exit(127);
    if (ptrace(PTRACE_TRACEME, 0, NULL, NULL) < 0) _exit(127);
    execv(argv[0], argv);
    _exit(127);
}

/* The breakpoint that the child stands behind, if any: it is taken away and printed. */
static int is_hit(pid_t child)
{
    struct user_regs_struct registers;
    if (ptrace(PTRACE_GETREGS, child, NULL, &registers) < 0) die("hits: PTRACE_GETREGS");
    unsigned long address = registers.rip - 1;
    for (size_t i = 0; i < count; ++i) {
        if (addresses[i] != address) continue;
        swap_byte(child, address, bytes[i]);
        registers.rip = address;
        if (ptrace(PTRACE_SETREGS, child, NULL, &registers) < 0) die("hits: PTRACE_SETREGS");
        printf("%lx\n", address);
        return 1;
    }
    return 0;
}

static int follow(pid_t child)
{
    int status, signal = 0;
    for (;;) {
        if (ptrace(PTRACE_CONT, child, NULL, (void *)(long)signal) < 0) die("hits: PTRACE_CONT");
        if (waitpid(child, &status, 0) < 0) die("hits: waitpid");
        if (WIFEXITED(status)) return WEXITSTATUS(status) != 0;
        if (WIFSIGNALED(status)) return 1;
        signal = WSTOPSIG(status);
        if (signal == SIGTRAP && is_hit(child)) signal = 0;
    }
}

int main(int argc, char **argv)
{
    int status;
    if (argc != 3) {
        fprintf(stderr, "usage: hits ADDRESSES PROGRAM\n");
        return 2;
    }
    read_addresses(argv[1]);
    pid_t child = fork();
    if (child < 0) die("hits: fork");
    if (child == 0) run_program(argv + 2);
    if (waitpid(child, &status, 0) < 0 || !WIFSTOPPED(status)) die("hits: the program did not start");
    for (size_t i = 0; i < count; ++i) bytes[i] = swap_byte(child, addresses[i], BREAKPOINT);
    return follow(child);
}
