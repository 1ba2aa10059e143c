/* SPDX-License-Identifier: MIT */
/*
 * Output files appear whole or not at all: written to a temporary file in the same directory, synced, renamed. Signals wait
 * meanwhile, so that Ctrl-C leaves nothing behind, and a file that exists survives every failure.
 */
#ifndef FILE_OUT_H
#define FILE_OUT_H

#include <glib.h>

/* Can `path` become an output? Finds out early what would fail late: a directory, a missing directory, no permission, or the
 * same file as one of the `inputs` (NULL-terminated). */
gboolean file_out_check(const char *path, const char *const *inputs, GError **error);

/* Write `length` bytes to `path`. Something that is there and no regular file (a device, a pipe) is written as it is. */
gboolean file_out_write(const char *path, const void *bytes, gsize length, GError **error);

#endif
