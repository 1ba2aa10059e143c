/* SPDX-License-Identifier: MIT */
/*
 * The desktop may be asked over a bus that never answers, so it has a few seconds. GLib connects to the bus before it returns, whichever function is called, so
 * a thread asks, which is left behind when it hangs: the command ends soon after.
 */
#include "opener.h"

#include <fcntl.h>
#include <gio/gio.h>
#include <unistd.h>

#include "cli.h"

#define PATIENCE 10 /* seconds */

gboolean opener_has_display(void)
{
#if defined(__APPLE__) || defined(_WIN32)
    return TRUE;
#else
    const char *x = g_getenv("DISPLAY"), *wayland = g_getenv("WAYLAND_DISPLAY");
    return (x && *x) || (wayland && *wayland);
#endif
}

/* The program that opens the file outlives this one: with our output it would keep whoever reads that waiting for its end. */
static void redirect(int saved[3])
{
    int nothing = open("/dev/null", O_RDWR);
    for (int i = 0; i < 3; i++) {
        saved[i] = fcntl(i, F_DUPFD_CLOEXEC, 3);
        if (nothing >= 0 && saved[i] >= 0) dup2(nothing, i);
    }
    if (nothing >= 0) close(nothing);
}

static void restore(const int saved[3])
{
    for (int i = 0; i < 3; i++) {
        if (saved[i] < 0) continue;
        dup2(saved[i], i);
        close(saved[i]);
    }
}

/* A question to the desktop, kept by who asks and who waits: either may be the last. */
typedef struct Opening {
    char *uri;
    GMutex lock;
    GCond answered;
    gboolean done, opened;
    GError *wrong;
} Opening;

static void opening_clear(gpointer data)
{
    Opening *opening = data;
    g_free(opening->uri);
    g_mutex_clear(&opening->lock);
    g_cond_clear(&opening->answered);
    g_clear_error(&opening->wrong);
}

static gpointer ask(gpointer data)
{
    Opening *opening = data;
    GError *wrong = NULL;
    gboolean opened = g_app_info_launch_default_for_uri(opening->uri, NULL, &wrong);
    g_mutex_lock(&opening->lock);
    opening->opened = opened;
    opening->wrong = wrong;
    opening->done = TRUE;
    g_cond_signal(&opening->answered);
    g_mutex_unlock(&opening->lock);
    g_atomic_rc_box_release_full(opening, opening_clear);
    return NULL;
}

/* Has it answered in time? */
static gboolean wait_for(Opening *opening)
{
    gint64 end = g_get_monotonic_time() + PATIENCE * G_TIME_SPAN_SECOND;
    g_mutex_lock(&opening->lock);
    while (!opening->done && g_cond_wait_until(&opening->answered, &opening->lock, end)) continue;
    gboolean done = opening->done;
    g_mutex_unlock(&opening->lock);
    return done;
}

gboolean opener_open(const char *path, GError **error)
{
    g_autoptr(GFile) file = g_file_new_for_path(path);
    Opening *opening = g_atomic_rc_box_new0(Opening);
    int saved[3];
    opening->uri = g_file_get_uri(file);
    g_mutex_init(&opening->lock);
    g_cond_init(&opening->answered);
    redirect(saved);
    g_thread_unref(g_thread_new("opener", ask, g_atomic_rc_box_acquire(opening)));
    gboolean done = wait_for(opening), opened = done && opening->opened;
    restore(saved);
    if (!done) cli_fail(error, CLI_SYSTEM, "the desktop does not answer");
    if (done && !opened) g_propagate_error(error, g_steal_pointer(&opening->wrong));
    g_atomic_rc_box_release_full(opening, opening_clear);
    return opened;
}
