/* SPDX-License-Identifier: MIT */
/*
 * JSON as text, written front to back. Numbers read back as the same double; what is not finite becomes null.
 */
#ifndef JSON_OUT_H
#define JSON_OUT_H

#include <glib.h>

#include "tdsp/types.h"

typedef struct JsonOut {
    GString *text;
    gboolean comma; /* the next item needs one */
} JsonOut;

JsonOut json_out_new(void);
/* End the document with a line feed and write it to standard output. */
gboolean json_out_print(JsonOut *out, GError **error);
void json_out_clear(JsonOut *out);
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC(JsonOut, json_out_clear)

void json_out_begin(JsonOut *out, char bracket);
void json_out_end(JsonOut *out, char bracket);
void json_out_key(JsonOut *out, const char *key);
/* The next item starts a line of its own. */
void json_out_line(JsonOut *out);

void json_out_number(JsonOut *out, double value);
void json_out_whole(JsonOut *out, guint64 value);
void json_out_boolean(JsonOut *out, gboolean value);
void json_out_null(JsonOut *out);
void json_out_string(JsonOut *out, const char *value); /* NULL: null */
void json_out_point(JsonOut *out, tdsp_point point);

/* A key with its value. */
void json_out_member_number(JsonOut *out, const char *key, double value);
void json_out_member_whole(JsonOut *out, const char *key, guint64 value);
void json_out_member_string(JsonOut *out, const char *key, const char *value);
void json_out_member_point(JsonOut *out, const char *key, tdsp_point point);

#endif
