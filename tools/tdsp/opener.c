/* SPDX-License-Identifier: MIT */
/* The desktop may be asked over a bus that never answers, so it has a few seconds. */
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

typedef struct Opening {
    GMainLoop *loop;
    gboolean opened, timed_out;
    GError *wrong;
} Opening;

static void opened(GObject *source, GAsyncResult *result, gpointer data)
{
    (void)source;
    Opening *opening = data;
    opening->opened = g_app_info_launch_default_for_uri_finish(result, &opening->wrong);
    g_main_loop_quit(opening->loop);
}

/* Nothing is called any more once the loop has ended, so what a later answer would be written to may go. */
static gboolean give_up(gpointer data)
{
    Opening *opening = data;
    opening->timed_out = TRUE;
    g_main_loop_quit(opening->loop);
    return G_SOURCE_REMOVE;
}

static void wait_for(Opening *opening, const char *uri)
{
    int saved[3];
    opening->loop = g_main_loop_new(NULL, FALSE);
    guint timer = g_timeout_add_seconds(PATIENCE, give_up, opening);
    redirect(saved);
    g_app_info_launch_default_for_uri_async(uri, NULL, NULL, opened, opening);
    g_main_loop_run(opening->loop);
    restore(saved);
    if (!opening->timed_out) g_source_remove(timer);
    g_main_loop_unref(opening->loop);
}

gboolean opener_open(const char *path, GError **error)
{
    g_autoptr(GFile) file = g_file_new_for_path(path);
    g_autofree char *uri = g_file_get_uri(file);
    Opening opening = {0};
    wait_for(&opening, uri);
    if (opening.timed_out) return cli_fail(error, CLI_SYSTEM, "the desktop does not answer");
    if (!opening.opened) g_propagate_error(error, opening.wrong);
    return opening.opened;
}
