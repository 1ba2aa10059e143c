/* SPDX-License-Identifier: MIT */
/* The JSON writer. */
#include "json_out.h"

#include <math.h>
#include <string.h>

#include "cli.h"
#include "numbers.h"

JsonOut json_out_new(void)
{
    return (JsonOut){g_string_new(NULL), FALSE};
}

void json_out_clear(JsonOut *out)
{
    if (out->text) g_string_free(g_steal_pointer(&out->text), TRUE);
}

gboolean json_out_print(JsonOut *out, GError **error)
{
    g_string_append_c(out->text, '\n');
    return cli_print(out->text, error);
}

/* Every item passes here once. */
static GString *item(JsonOut *out)
{
    if (out->comma) g_string_append(out->text, ", ");
    out->comma = TRUE;
    return out->text;
}

void json_out_begin(JsonOut *out, char bracket)
{
    g_string_append_c(item(out), bracket);
    out->comma = FALSE;
}

void json_out_end(JsonOut *out, char bracket)
{
    g_string_append_c(out->text, bracket);
    out->comma = TRUE;
}

void json_out_line(JsonOut *out)
{
    g_string_append(out->text, out->comma ? ",\n " : "\n ");
    out->comma = FALSE;
}

static void append_string(GString *into, const char *value)
{
    g_string_append_c(into, '"');
    for (const char *at = value; *at; at++) {
        unsigned char byte = (unsigned char)*at;
        if (byte == '"' || byte == '\\')
            g_string_append_printf(into, "\\%c", byte);
        else if (byte < 0x20)
            g_string_append_printf(into, "\\u%04x", byte);
        else
            g_string_append_c(into, *at);
    }
    g_string_append_c(into, '"');
}

void json_out_key(JsonOut *out, const char *key)
{
    append_string(item(out), key);
    g_string_append(out->text, ": ");
    out->comma = FALSE;
}

void json_out_number(JsonOut *out, double value)
{
    char buffer[NUMBER_ROOM];
    g_string_append(item(out), isfinite(value) ? number_format(buffer, value) : "null");
}

void json_out_whole(JsonOut *out, guint64 value)
{
    g_string_append_printf(item(out), "%" G_GUINT64_FORMAT, value);
}

void json_out_boolean(JsonOut *out, gboolean value)
{
    g_string_append(item(out), value ? "true" : "false");
}

void json_out_null(JsonOut *out)
{
    g_string_append(item(out), "null");
}

/* A file's name may hold any bytes; JSON holds UTF-8. */
void json_out_string(JsonOut *out, const char *value)
{
    if (!value) {
        json_out_null(out);
        return;
    }
    g_autofree char *valid = g_utf8_make_valid(value, -1);
    append_string(item(out), valid);
}

void json_out_point(JsonOut *out, tdsp_point point)
{
    json_out_begin(out, '[');
    json_out_number(out, point.x);
    json_out_number(out, point.y);
    json_out_end(out, ']');
}

void json_out_member_number(JsonOut *out, const char *key, double value)
{
    json_out_key(out, key);
    json_out_number(out, value);
}

void json_out_member_whole(JsonOut *out, const char *key, guint64 value)
{
    json_out_key(out, key);
    json_out_whole(out, value);
}

void json_out_member_string(JsonOut *out, const char *key, const char *value)
{
    json_out_key(out, key);
    json_out_string(out, value);
}

void json_out_member_point(JsonOut *out, const char *key, tdsp_point point)
{
    json_out_key(out, key);
    json_out_point(out, point);
}
