/* SPDX-License-Identifier: MIT */
/* Columns of text. */
#include "text_table.h"

#include "cli.h"
#include "numbers.h"

TextTable text_table_new(const char *const *heading)
{
    TextTable table = {g_strv_length((char **)heading), g_ptr_array_new_with_free_func(g_free)};
    for (guint i = 0; i < table.columns; i++)
        g_ptr_array_add(table.cells, g_strdup_printf("%s%s", i == 0 ? "# " : "", heading[i]));
    return table;
}

void text_table_clear(TextTable *table)
{
    g_clear_pointer(&table->cells, g_ptr_array_unref);
}

void text_table_string(TextTable *table, const char *value)
{
    g_ptr_array_add(table->cells, g_strdup(value));
}

void text_table_number(TextTable *table, double value)
{
    char buffer[NUMBER_ROOM];
    text_table_string(table, number_format(buffer, value));
}

static glong width_of(const TextTable *table, guint column)
{
    glong width = 0;
    for (guint i = column; i < table->cells->len; i += table->columns)
        width = MAX(width, g_utf8_strlen(g_ptr_array_index(table->cells, i), -1));
    return width;
}

void text_table_append(const TextTable *table, GString *into)
{
    g_autofree glong *widths = g_new(glong, table->columns);
    for (guint i = 0; i < table->columns; i++) widths[i] = width_of(table, i);
    for (guint i = 0; i < table->cells->len; i++) {
        const char *cell = g_ptr_array_index(table->cells, i);
        guint column = i % table->columns;
        g_string_append(into, cell);
        if (column + 1 == table->columns)
            g_string_append_c(into, '\n');
        else
            g_string_append_printf(into, "%*s", (int)(widths[column] - g_utf8_strlen(cell, -1)) + 2, "");
    }
}

gboolean text_table_print(const TextTable *table, GError **error)
{
    g_autoptr(GString) text = g_string_new(NULL);
    text_table_append(table, text);
    return cli_print(text, error);
}
