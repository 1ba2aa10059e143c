/* SPDX-License-Identifier: MIT */
/* Columns of text, padded so that they stand under each other. The heading begins with '#': other programs skip it. */
#ifndef TEXT_TABLE_H
#define TEXT_TABLE_H

#include <glib.h>

typedef struct TextTable {
    guint columns;
    GPtrArray *cells; /* of char *, row by row, the heading first */
} TextTable;

/* `heading`: the names of the columns, NULL-terminated. */
TextTable text_table_new(const char *const *heading);
void text_table_clear(TextTable *table);
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC(TextTable, text_table_clear)

void text_table_number(TextTable *table, double value);
void text_table_string(TextTable *table, const char *value);
void text_table_append(const TextTable *table, GString *into);
gboolean text_table_print(const TextTable *table, GError **error);

#endif
