/* SPDX-License-Identifier: MIT */
/*
 * CSV as programs write it (RFC 4180): records of fields, quoted where they hold separators, quotes or lines. The separator is a comma, a semicolon or a tab, whichever
 * comes first in the header. Lines that are empty or begin with # are passed over. UTF-8, with or without a byte order mark.
 */
#ifndef CSV_H
#define CSV_H

#include <glib.h>

typedef struct Csv {
    const char *file; /* for messages */
    const char *at;   /* where the next record begins */
    guint next_line;
    char separator;
    guint line;        /* where the last record began, from 1 */
    GPtrArray *fields; /* of char *, trimmed: the last record; empty at the end */
} Csv;

/* `text`, which ends with a zero byte behind `length` bytes, is borrowed. */
gboolean csv_begin(const char *file, const char *text, gsize length, Csv *csv, GError **error);

/* Read the next record. At the end TRUE, and no fields. */
gboolean csv_next(Csv *csv, GError **error);

/* An error about the last record. Returns FALSE. */
gboolean csv_fail(const Csv *csv, GError **error, const char *format, ...) G_GNUC_PRINTF(3, 4);

void csv_clear(Csv *csv);
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC(Csv, csv_clear)

#endif
