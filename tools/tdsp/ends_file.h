/* SPDX-License-Identifier: MIT */
/* Lists of places: one a line, "x,y" or "x y", with a name behind it where wanted; # begins a comment. */
#ifndef ENDS_FILE_H
#define ENDS_FILE_H

#include <glib.h>

#include "tdsp/matrix.h"

typedef struct EndsFile {
    GArray *ends;         /* of tdsp_matrix_end */
    GStringChunk *names;  /* what they point to */
} EndsFile;

/* Read `path` ("-": standard input): at least one place. */
gboolean ends_file_load(const char *path, EndsFile *out, GError **error);
void ends_file_clear(EndsFile *file);
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC(EndsFile, ends_file_clear)

#endif
