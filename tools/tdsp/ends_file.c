/* SPDX-License-Identifier: MIT */
/* Reading lists of places. */
#include "ends_file.h"

#include <string.h>

#include "cli.h"
#include "file_in.h"
#include "numbers.h"

#define LARGEST 1e100 /* of a coordinate, as in a scene */

/* Cut the first field off *rest, in place: up to white space or a comma, one comma at most. */
static char *take_field(char **rest)
{
    char *field = *rest, *end = field + strcspn(field, ", \t");
    char *next = end + strspn(end, " \t");
    if (*next == ',') next += 1 + strspn(next + 1, " \t");
    *end = '\0';
    *rest = next;
    return field;
}

static const char *parse_coordinate(const char *text, double *value)
{
    if (*text == '\0') return "a place is two numbers, x and y";
    const char *wrong = number_parse(text, value);
    if (wrong) return wrong;
    return *value >= -LARGEST && *value <= LARGEST ? NULL : "is beyond 1e100";
}

/* A line without its comment and the white space around it, cut in place. NULL, or what is wrong. */
static const char *parse_line(char *line, EndsFile *file)
{
    tdsp_matrix_end end = {{0, 0}, NULL, 0};
    char *x = take_field(&line), *y = take_field(&line);
    const char *wrong = parse_coordinate(x, &end.place.x);
    if (!wrong) wrong = parse_coordinate(y, &end.place.y);
    if (wrong) return wrong;
    end.name_length = strlen(line);
    if (!g_utf8_validate(line, (gssize)end.name_length, NULL)) return "the name is not UTF-8";
    if (end.name_length > 0) end.name = g_string_chunk_insert(file->names, line);
    g_array_append_val(file->ends, end);
    return NULL;
}

static gboolean add_line(const char *path, guint number, char *line, EndsFile *file, GError **error)
{
    char *comment = strchr(line, '#');
    if (comment) *comment = '\0';
    g_strstrip(line);
    if (*line == '\0') return TRUE;
    g_autofree char *whole = g_utf8_make_valid(line, -1);
    const char *wrong = parse_line(line, file);
    return wrong ? cli_fail(error, CLI_INPUT, "%s:%u: \"%.60s\": %s", cli_file_name(path), number, whole, wrong) : TRUE;
}

static gboolean read_lines(const char *path, EndsFile *file, GError **error)
{
    g_autofree char *text = NULL;
    gsize length;
    if (!file_in_read(path, &text, &length, error)) return FALSE;
    if (memchr(text, '\0', length)) return cli_fail(error, CLI_INPUT, "%s: a zero byte", cli_file_name(path));
    guint number = 1;
    for (char *line = text, *next; line; line = next, number++) {
        next = strchr(line, '\n');
        if (next) *next++ = '\0';
        if (!add_line(path, number, line, file, error)) return FALSE;
    }
    return file->ends->len > 0 ? TRUE : cli_fail(error, CLI_INPUT, "%s: no place in it", cli_file_name(path));
}

gboolean ends_file_load(const char *path, EndsFile *out, GError **error)
{
    EndsFile file = {g_array_new(FALSE, FALSE, sizeof(tdsp_matrix_end)), g_string_chunk_new(256)};
    if (!read_lines(path, &file, error)) {
        ends_file_clear(&file);
        return FALSE;
    }
    *out = file;
    return TRUE;
}

void ends_file_clear(EndsFile *file)
{
    g_clear_pointer(&file->ends, g_array_unref);
    g_clear_pointer(&file->names, g_string_chunk_free);
}
