/* SPDX-License-Identifier: MIT */
/* Lists of times. */
#include "times.h"

#include <string.h>

#include "cli.h"
#include "file_in.h"
#include "numbers.h"

GArray *times_new(void)
{
    return g_array_new(FALSE, FALSE, sizeof(double));
}

gboolean times_add(GArray *times, const char *argument, const char *what, GError **error)
{
    double time;
    const char *wrong = number_parse_time(argument, &time);
    if (wrong) return cli_fail(error, CLI_USAGE, "%s \"%s\": %s", what, argument, wrong);
    g_array_append_val(times, time);
    return TRUE;
}

gboolean times_add_all(GArray *times, int argc, char **argv, int first, const char *what, GError **error)
{
    for (int i = first; i < argc; i++)
        if (!times_add(times, argv[i], what, error)) return FALSE;
    return TRUE;
}

/* `line` is cut and trimmed in place. */
static gboolean add_line(GArray *times, const char *path, guint number, char *line, GError **error)
{
    char *comment = strchr(line, '#');
    if (comment) *comment = '\0';
    g_strstrip(line);
    if (*line == '\0') return TRUE;
    double time;
    const char *wrong = number_parse_time(line, &time);
    if (wrong) return cli_fail(error, CLI_INPUT, "%s:%u: \"%.60s\": %s", cli_file_name(path), number, line, wrong);
    g_array_append_val(times, time);
    return TRUE;
}

gboolean times_add_text(GArray *times, const char *path, char *text, gsize length, GError **error)
{
    guint number = 1;
    for (char *line = text, *next; line; line = next, number++) {
        char *end = memchr(line, '\n', (gsize)(text + length - line));
        next = end ? end + 1 : NULL;
        if (end) *end = '\0';
        if (strlen(line) != (gsize)((end ? end : text + length) - line))
            return cli_fail(error, CLI_INPUT, "%s:%u: a zero byte", cli_file_name(path), number);
        if (!add_line(times, path, number, line, error)) return FALSE;
    }
    if (times->len == 0) return cli_fail(error, CLI_INPUT, "%s: no number in it", cli_file_name(path));
    return TRUE;
}

gboolean times_add_file(GArray *times, const char *path, GError **error)
{
    g_autofree char *text = NULL;
    gsize length;
    return file_in_read(path, &text, &length, error) && times_add_text(times, path, text, length, error);
}
