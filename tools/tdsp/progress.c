/* SPDX-License-Identifier: MIT */
/* The progress bar. */
#include "progress.h"

#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#define BAR_WIDTH 32
#define FIRST_DRAWN 0.3 /* seconds */
#define REDRAWN 0.1

static const char clear_line[] = "\r\033[K";

/* Ctrl-C: leave a clean line, then die of the signal as usual (the handler was reset on entry). */
static void clear_and_die(int signal_number)
{
    gssize ignored = write(STDERR_FILENO, clear_line, sizeof clear_line - 1);
    (void)ignored;
    raise(signal_number);
}

static void handle(void (*handler)(int))
{
    struct sigaction action;
    memset(&action, 0, sizeof action);
    action.sa_handler = handler;
    action.sa_flags = (int)SA_RESETHAND;
    sigaction(SIGINT, &action, NULL);
    sigaction(SIGTERM, &action, NULL);
}

Progress progress_begin(const char *what)
{
    Progress progress = {.what = what, .on = isatty(STDERR_FILENO) != 0, .begun = stopwatch_start()};
    if (progress.on) handle(clear_and_die);
    return progress;
}

static void append_remaining(GString *line, double share, double elapsed)
{
    double left = elapsed * (1 - share) / share;
    if (share < 0.02 || !(left < 360000)) return;
    int seconds = (int)ceil(left);
    g_string_append_printf(line, "  %d:%02d left", seconds / 60, seconds % 60);
}

static void draw(Progress *progress, double share, double elapsed)
{
    g_autoptr(GString) line = g_string_new(clear_line);
    int full = (int)(share * BAR_WIDTH);
    g_string_append_printf(line, "%s [", progress->what);
    for (int i = 0; i < BAR_WIDTH; i++) g_string_append_c(line, i < full ? '#' : '.');
    g_string_append_printf(line, "] %3d %%", (int)(share * 100));
    append_remaining(line, share, elapsed);
    fputs(line->str, stderr);
    fflush(stderr);
    progress->visible = TRUE;
    progress->drawn = elapsed;
}

void progress_show(Progress *progress, double settled, double all)
{
    if (!progress->on) return;
    double elapsed = stopwatch_seconds(progress->begun);
    if (elapsed < (progress->visible ? progress->drawn + REDRAWN : FIRST_DRAWN)) return;
    double share = all > 0 && isfinite(all) ? CLAMP(settled / all, 0, 1) : 0;
    progress->share = MAX(progress->share, share);
    draw(progress, progress->share, elapsed);
}

void progress_end(Progress *progress)
{
    if (progress->visible) fputs(clear_line, stderr);
    if (progress->on) handle(SIG_DFL);
    progress->visible = FALSE;
}
