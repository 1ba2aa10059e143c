/* SPDX-License-Identifier: MIT */
/* A progress bar on standard error: only where that is a terminal, and only once work takes long enough to be worth one. */
#ifndef PROGRESS_H
#define PROGRESS_H

#include <glib.h>

#include "stopwatch.h"

typedef struct Progress {
    const char *what;
    gboolean on;      /* standard error is a terminal */
    gboolean visible; /* a bar was drawn */
    Stopwatch begun;
    double drawn; /* seconds after the beginning */
    double share; /* done; several workers settle things in no order, but a bar does not go back */
} Progress;

Progress progress_begin(const char *what);
/* Show that `settled` of `all` is done. Draws at most ten times a second. */
void progress_show(Progress *progress, double settled, double all);
/* Clear the line. */
void progress_end(Progress *progress);

#endif
