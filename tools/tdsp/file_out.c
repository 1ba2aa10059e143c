/* SPDX-License-Identifier: MIT */
/* Atomic replacement of a file: temporary file, fsync, rename, with signals held back. Only SIGKILL leaves the temporary file. */
#include "file_out.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "cli.h"
#include "descriptor.h"

#define MOST_LINKS 40 /* as many as the system follows */

static gboolean fail_system(GError **error, const char *path, int code)
{
    return cli_fail(error, CLI_SYSTEM, "cannot write %s: %s", path, g_strerror(code));
}

/* Where the symbolic link `path` points to, or NULL when it is none. */
static char *link_target(const char *path)
{
    g_autofree char *content = g_file_read_link(path, NULL);
    if (!content) return NULL;
    if (g_path_is_absolute(content)) return g_steal_pointer(&content);
    g_autofree char *folder = g_path_get_dirname(path);
    return g_build_filename(folder, content, NULL);
}

/* The file behind `path`, so that a symbolic link stays a link, also one to a file that is still to be made. */
static char *target_of(const char *path)
{
    char *target = g_strdup(path);
    for (int i = 0; i < MOST_LINKS; i++) {
        char *next = link_target(target);
        if (!next) break;
        g_free(target);
        target = next;
    }
    return target;
}

static gboolean same_file(const struct stat *one, const char *other)
{
    struct stat that;
    return stat(other, &that) == 0 && one->st_dev == that.st_dev && one->st_ino == that.st_ino;
}

gboolean file_out_check(const char *path, const char *const *inputs, GError **error)
{
    if (strcmp(path, "-") == 0 || *path == '\0') return cli_fail(error, CLI_USAGE, "-o needs the name of a file");
    struct stat there;
    if (stat(path, &there) == 0) {
        if (S_ISDIR(there.st_mode)) return fail_system(error, path, EISDIR);
        for (; *inputs; inputs++)
            if (same_file(&there, *inputs)) return cli_fail(error, CLI_USAGE, "%s: the output would replace the input", path);
        if (!S_ISREG(there.st_mode)) return TRUE;
    } else if (errno == ELOOP) {
        return fail_system(error, path, ELOOP); /* links that lead nowhere: not ours to replace */
    }
    g_autofree char *target = target_of(path);
    g_autofree char *folder = g_path_get_dirname(target);
    if (access(folder, W_OK | X_OK) != 0) return fail_system(error, path, errno);
    return TRUE;
}

/* A new file gets what umask leaves of rw-rw-rw-, an old one keeps its permissions. */
static mode_t mode_for(const char *target)
{
    struct stat there;
    if (stat(target, &there) == 0) return there.st_mode & 07777;
    mode_t mask = umask(0);
    umask(mask);
    return 0666 & ~mask;
}

/* 0, or errno; `temporary` is gone afterwards either way. */
static int fill_and_rename(int file, const char *temporary, const char *target, const void *bytes, gsize length)
{
    int code = descriptor_write_all(file, bytes, length);
    if (code == 0 && fchmod(file, mode_for(target)) != 0) code = errno;
    if (code == 0 && fsync(file) != 0) code = errno;
    if (close(file) != 0 && code == 0) code = errno;
    if (code == 0 && rename(temporary, target) != 0) code = errno;
    if (code != 0) unlink(temporary);
    return code;
}

static int replace(const char *path, const void *bytes, gsize length)
{
    g_autofree char *target = target_of(path);
    g_autofree char *folder = g_path_get_dirname(target);
    g_autofree char *temporary = g_build_filename(folder, ".tdsp-XXXXXX", NULL);
    int file = mkstemp(temporary);
    if (file < 0) return errno;
    return fill_and_rename(file, temporary, target, bytes, length);
}

static int write_through(const char *path, const void *bytes, gsize length)
{
    int file = descriptor_open(path, O_WRONLY);
    if (file < 0) return errno;
    int code = descriptor_write_all(file, bytes, length);
    if (close(file) != 0 && code == 0) code = errno;
    return code;
}

/*
 * Signals wait until a regular file is replaced, so that none leaves the temporary file behind. What is written through, a pipe or a device, may
 * keep one waiting for ever and leaves nothing: it can be interrupted.
 */
gboolean file_out_write(const char *path, const void *bytes, gsize length, GError **error)
{
    struct stat there;
    if (stat(path, &there) == 0 && !S_ISREG(there.st_mode) && !S_ISDIR(there.st_mode)) {
        void (*before)(int) = signal(SIGPIPE, SIG_IGN); /* a reader that went away is an error like others */
        int code = write_through(path, bytes, length);
        signal(SIGPIPE, before);
        return code == 0 ? TRUE : fail_system(error, path, code);
    }
    sigset_t all, before;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before);
    int code = replace(path, bytes, length);
    pthread_sigmask(SIG_SETMASK, &before, NULL);
    return code == 0 ? TRUE : fail_system(error, path, code);
}
