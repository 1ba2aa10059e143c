/* SPDX-License-Identifier: MIT */
/*
 * The CSV reader. Invariant: between two records the cursor is at the begin of a line, whose number is next_line; the zero byte behind the text ends every loop.
 */
#include "csv.h"

#include <string.h>

#include "cli.h"

gboolean csv_fail(const Csv *csv, GError **error, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    g_autofree char *reason = g_strdup_vprintf(format, arguments);
    va_end(arguments);
    return cli_fail(error, CLI_INPUT, "%s:%u: %s", csv->file, csv->line, reason);
}

static guint line_of(const char *text, const char *at)
{
    guint line = 1;
    for (; text < at; text++) line += *text == '\n';
    return line;
}

gboolean csv_begin(const char *file, const char *text, gsize length, Csv *csv, GError **error)
{
    const char *bad;
    *csv = (Csv){.file = file, .at = text, .next_line = 1};
    if (!g_utf8_validate_len(text, length, &bad)) {
        csv->line = line_of(text, bad);
        return csv_fail(csv, error, *bad == '\0' ? "a zero byte" : "not UTF-8");
    }
    if (g_str_has_prefix(text, "\xef\xbb\xbf")) csv->at += 3;
    csv->fields = g_ptr_array_new_with_free_func(g_free);
    return TRUE;
}

/* The separator of the header that begins here: it may stand behind quotes, and not inside. */
static char separator_of(const char *at)
{
    for (gboolean quoted = FALSE; *at && (quoted || *at != '\n'); at++) {
        if (*at == '"') quoted = !quoted;
        if (!quoted && strchr(",;\t", *at)) return *at;
    }
    return ',';
}

/* Past the end of the line, "\n" or "\r\n", that the cursor is at. */
static void end_line(Csv *csv)
{
    if (*csv->at == '\r') csv->at++;
    if (*csv->at != '\n') return;
    csv->at++;
    csv->next_line++;
}

static gboolean is_line_end(const char *at)
{
    return *at == '\0' || *at == '\n' || (*at == '\r' && at[1] == '\n');
}

static void skip_empty_lines(Csv *csv)
{
    for (const char *at = csv->at; *at; at = csv->at) {
        if (*at != '#') at += strspn(at, " \t\r");
        if (*at != '\n' && *at != '\0' && *at != '#') return;
        if (*at == '#' && at != csv->at) return;
        csv->at = at + strcspn(at, "\n");
        end_line(csv);
    }
}

/* Up to the quote that ends the field; two of them are one. */
static gboolean read_quoted(Csv *csv, GString *field, GError **error)
{
    for (csv->at++; *csv->at; csv->at++) {
        if (*csv->at == '"' && csv->at[1] != '"') break;
        if (*csv->at == '"') csv->at++;
        if (*csv->at == '\n') csv->next_line++;
        g_string_append_c(field, *csv->at);
    }
    if (*csv->at != '"') return csv_fail(csv, error, "a quoted field that never ends");
    csv->at += 1 + strspn(csv->at + 1, csv->separator == '\t' ? " " : " \t");
    return *csv->at == csv->separator || is_line_end(csv->at) ? TRUE : csv_fail(csv, error, "something follows a quoted field");
}

static gboolean read_field(Csv *csv, GError **error)
{
    GString *field = g_string_new(NULL);
    gboolean read = TRUE;
    csv->at += strspn(csv->at, csv->separator == '\t' ? " " : " \t");
    if (*csv->at == '"')
        read = read_quoted(csv, field, error);
    else
        while (*csv->at != csv->separator && !is_line_end(csv->at)) g_string_append_c(field, *csv->at++);
    g_ptr_array_add(csv->fields, g_strstrip(g_string_free(field, FALSE)));
    return read;
}

gboolean csv_next(Csv *csv, GError **error)
{
    g_ptr_array_set_size(csv->fields, 0);
    skip_empty_lines(csv);
    csv->line = csv->next_line;
    if (*csv->at == '\0') return TRUE;
    if (!csv->separator) csv->separator = separator_of(csv->at);
    if (!read_field(csv, error)) return FALSE;
    while (*csv->at == csv->separator) {
        csv->at++;
        if (!read_field(csv, error)) return FALSE;
    }
    end_line(csv);
    return TRUE;
}

void csv_clear(Csv *csv)
{
    g_clear_pointer(&csv->fields, g_ptr_array_unref);
}
