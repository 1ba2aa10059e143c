/* SPDX-License-Identifier: MIT */
/* Lists of times from the command line and from files. */
#ifndef TIMES_H
#define TIMES_H

#include <glib.h>

/* An empty list (of double). */
GArray *times_new(void);

/* Add one argument; `what` says what it is in a message, e.g. "departure". A usage error unless it is finite and not negative. */
gboolean times_add(GArray *times, const char *argument, const char *what, GError **error);

/* Add argv[first] to argv[argc - 1]. */
gboolean times_add_all(GArray *times, int argc, char **argv, int first, const char *what, GError **error);

/* Add the numbers of a file ("-": standard input): one a line, '#' begins a comment, empty lines count for nothing. */
gboolean times_add_file(GArray *times, const char *path, GError **error);

/* The same for the text of a file, which messages call `path`. It is cut up in place, and ends with a zero byte behind its length. */
gboolean times_add_text(GArray *times, const char *path, char *text, gsize length, GError **error);

#endif
