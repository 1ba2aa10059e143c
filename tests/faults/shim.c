/* SPDX-License-Identifier: MIT */
/*
 * The system's answers to the command, changed: the linker's --wrap puts these functions before the C library's. Operations are numbered from 1.
 *
 *   SHIM_LOG=FILE    append one line an operation: its number, what it is, on what
 *   SHIM_AT=N        at operation N ...
 *   SHIM_DO=WHAT     ... an errno by number: it fails with that, and nothing was done; `short`: only one byte is read or written; `end`: the
 *                    file ends here, or takes no more; `kill N`: the process is sent that signal before the operation
 *   SHIM_ON=1        ... and at all later operations of its kind
 *   SHIM_MEMORY=N    the library's N-th request for memory is refused, and has a line of its own
 *
 * What coverage writes when the program ends, to files named .profraw, is no operation of the command.
 */
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cairo.h>
#include <glib.h>

#include "faults/memory.h"
#include "tdsp/progress.h"

enum { DO_IT, FAIL, SHORT, END };

/* The linker wants these to be seen by the libraries that call the function, too. */
#define EXPORTED __attribute__((visibility("default")))

int __real_open(const char *path, int flags, ...);
int __wrap_open(const char *path, int flags, ...);
ssize_t __real_read(int file, void *into, size_t room);
ssize_t __wrap_read(int file, void *into, size_t room);
ssize_t __real_write(int file, const void *bytes, size_t length);
ssize_t __wrap_write(int file, const void *bytes, size_t length);
int __real_close(int file);
int __wrap_close(int file);
int __real_fsync(int file);
int __wrap_fsync(int file);
int __real_fchmod(int file, mode_t mode);
int __wrap_fchmod(int file, mode_t mode);
int __real_rename(const char *from, const char *to);
int __wrap_rename(const char *from, const char *to);
int __real_mkstemp(char *name);
int __wrap_mkstemp(char *name);
GThreadPool *__real_g_thread_pool_new(GFunc function, gpointer data, gint most, gboolean exclusive, GError **error);
EXPORTED GThreadPool *__wrap_g_thread_pool_new(GFunc function, gpointer data, gint most, gboolean exclusive, GError **error);
cairo_status_t __real_cairo_status(cairo_t *cr);
EXPORTED cairo_status_t __wrap_cairo_status(cairo_t *cr);
cairo_status_t __real_cairo_surface_status(cairo_surface_t *surface);
EXPORTED cairo_status_t __wrap_cairo_surface_status(cairo_surface_t *surface);
void __real_progress_show(Progress *progress, double settled, double all);
void __wrap_progress_show(Progress *progress, double settled, double all);

static long number; /* of the operation; only the main thread reads and writes files */

static void log_line(const char *kind, const char *what)
{
    char line[512];
    const char *path = getenv("SHIM_LOG");
    if (!path) return;
    int length = snprintf(line, sizeof line, "%ld %s %.400s\n", number, kind, what);
    int file = __real_open(path, O_WRONLY | O_CREAT | O_APPEND, 0666);
    if (file < 0 || __real_write(file, line, (size_t)length) != length) abort();
    __real_close(file);
}

static int act(const char *what)
{
    if (strncmp(what, "kill ", 5) == 0) {
        kill(getpid(), atoi(what + 5));
        return DO_IT;
    }
    if (strcmp(what, "short") == 0) return SHORT;
    if (strcmp(what, "end") == 0) return END;
    errno = atoi(what);
    return FAIL;
}

static int decide(const char *kind, const char *on)
{
    static char hit[16]; /* the kind of operation N */
    const char *at = getenv("SHIM_AT"), *what = getenv("SHIM_DO");
    ++number;
    log_line(kind, on);
    if (!at || !what) return DO_IT;
    if (number == atol(at))
        snprintf(hit, sizeof hit, "%s", kind);
    else if (number < atol(at) || !getenv("SHIM_ON") || strcmp(hit, kind) != 0)
        return DO_IT;
    return act(what);
}

static const char *descriptor_name(int file)
{
    static char text[32];
    snprintf(text, sizeof text, "%d", file);
    return text;
}

static int is_measurement(const char *path)
{
    const char *ending = strrchr(path, '.');
    return ending && strcmp(ending, ".profraw") == 0;
}

/* The command opens files without making them, so there is no third argument. */
int __wrap_open(const char *path, int flags, ...)
{
    if (is_measurement(path)) return __real_open(path, flags, 0666);
    return decide((flags & O_ACCMODE) == O_RDONLY ? "open" : "open-out", path) == FAIL ? -1 : __real_open(path, flags);
}

ssize_t __wrap_read(int file, void *into, size_t room)
{
    switch (decide("read", descriptor_name(file))) {
    case FAIL: return -1;
    case END: return 0;
    case SHORT: return __real_read(file, into, 1);
    default: return __real_read(file, into, room);
    }
}

ssize_t __wrap_write(int file, const void *bytes, size_t length)
{
    switch (decide(file == STDOUT_FILENO ? "print" : "write", descriptor_name(file))) {
    case FAIL: return -1;
    case END: return 0;
    case SHORT: return __real_write(file, bytes, 1);
    default: return __real_write(file, bytes, length);
    }
}

/* As on Linux a descriptor is gone even where close() fails. */
int __wrap_close(int file)
{
    int mode = fcntl(file, F_GETFL) & O_ACCMODE;
    int fails = decide(mode == O_RDONLY ? "close" : "close-out", descriptor_name(file)) == FAIL, code = errno;
    int done = __real_close(file);
    if (!fails) return done;
    errno = code;
    return -1;
}

int __wrap_fsync(int file)
{
    return decide("fsync", descriptor_name(file)) == FAIL ? -1 : __real_fsync(file);
}

int __wrap_fchmod(int file, mode_t mode)
{
    return decide("fchmod", descriptor_name(file)) == FAIL ? -1 : __real_fchmod(file, mode);
}

int __wrap_rename(const char *from, const char *to)
{
    return decide("rename", to) == FAIL ? -1 : __real_rename(from, to);
}

int __wrap_mkstemp(char *name)
{
    return decide("mkstemp", name) == FAIL ? -1 : __real_mkstemp(name);
}

/* GLib hands out the pool in any case, with the threads that it could start. */
EXPORTED GThreadPool *__wrap_g_thread_pool_new(GFunc function, gpointer data, gint most, gboolean exclusive, GError **error)
{
    int fails = decide("threads", "a pool") == FAIL, code = errno;
    GThreadPool *pool = __real_g_thread_pool_new(function, data, most, exclusive, error);
    if (fails) g_set_error_literal(error, G_THREAD_ERROR, G_THREAD_ERROR_AGAIN, strerror(code));
    return pool;
}

/* Cairo has one way to fail that does not depend on what is drawn: no memory. */
EXPORTED cairo_status_t __wrap_cairo_status(cairo_t *cr)
{
    return decide("draw", "a picture") == FAIL ? CAIRO_STATUS_NO_MEMORY : __real_cairo_status(cr);
}

EXPORTED cairo_status_t __wrap_cairo_surface_status(cairo_surface_t *surface)
{
    return decide("draw", "a picture") == FAIL ? CAIRO_STATUS_NO_MEMORY : __real_cairo_surface_status(surface);
}

/* No operation that could fail; a place for signals. */
void __wrap_progress_show(Progress *progress, double settled, double all)
{
    decide("progress", progress->what);
    __real_progress_show(progress, settled, all);
}

/* Requests come from every thread. */
int memory_must_fail(void)
{
    static long requests;
    const char *at = getenv("SHIM_MEMORY");
    if (!at || __atomic_add_fetch(&requests, 1, __ATOMIC_RELAXED) != atol(at)) return 0;
    log_line("memory", at);
    return 1;
}
