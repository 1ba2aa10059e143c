/* SPDX-License-Identifier: MIT */
/* Input files, read whole. What a file is, its first bytes decide. */
#ifndef FILE_IN_H
#define FILE_IN_H

#include <glib.h>

#include "tdsp/matrix.h"
#include "tdsp/table.h"

typedef enum FileKind {
    FILE_JSON, /* a scene, or a path */
    FILE_TABLE,
    FILE_MATRIX /* by file_in_load_any() only */
} FileKind;

/* Read all of `path` ("-": standard input). The result ends with a zero byte that does not count. */
gboolean file_in_read(const char *path, char **text, gsize *length, GError **error);

/* A file with its kind; a table is opened, that is, checked whole. */
typedef struct FileIn {
    const char *path; /* borrowed */
    char *text;
    gsize length;
    FileKind kind;
    tdsp_table table;
    tdsp_matrix matrix;
} FileIn;

gboolean file_in_load(const char *path, FileIn *file, GError **error);
/* The same, and matrices too. */
gboolean file_in_load_any(const char *path, FileIn *file, GError **error);
gboolean file_in_load_table(const char *path, FileIn *file, GError **error);
/* An error unless it is a table. */
gboolean file_in_need_table(const FileIn *file, GError **error);
void file_in_clear(FileIn *file);
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC(FileIn, file_in_clear)

#endif
