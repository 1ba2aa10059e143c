/* SPDX-License-Identifier: MIT */
/*
 * Typed access to parsed JSON. Every failure names the file, the place as a member path such as discs[3].radius, and the reason.
 */
#ifndef JSON_READ_H
#define JSON_READ_H

#include <glib.h>
#include <json-glib/json-glib.h>

#include "tdsp/types.h"

/* Where a value stands: a member of, or an item in, the place above it. Lives on the stack of the reader. */
typedef struct JsonPlace {
    const struct JsonPlace *above; /* NULL for the whole document */
    const char *member;            /* NULL for an item */
    guint item;
    const char *file; /* of the document; the others leave it NULL */
} JsonPlace;

/* A value and where it stands. */
typedef struct JsonValue {
    JsonNode *node;
    JsonPlace place;
} JsonValue;

/* Parse a whole document. The parser owns every node; `root` is for `file`. */
gboolean json_read_document(const char *file, const char *text, gsize length, JsonParser **parser, JsonValue *root,
                            GError **error);

/* An error about a place. Returns FALSE. */
gboolean json_read_fail(const JsonPlace *place, GError **error, const char *format, ...) G_GNUC_PRINTF(3, 4);

/* Is it of the type? Else an error. */
gboolean json_read_object(const JsonValue *value, GError **error);
gboolean json_read_array(const JsonValue *value, guint *length, GError **error);
gboolean json_read_number(const JsonValue *value, double *number, GError **error);
gboolean json_read_string(const JsonValue *value, const char **string, GError **error);
/* Exactly two numbers. */
gboolean json_read_point(const JsonValue *value, tdsp_point *point, GError **error);

/* A member of an object: an error when it is missing, or FALSE without one for the optional form. */
gboolean json_read_member(const JsonValue *object, const char *name, JsonValue *member, GError **error);
gboolean json_read_optional(const JsonValue *object, const char *name, JsonValue *member);
gboolean json_read_member_number(const JsonValue *object, const char *name, double *number, GError **error);
gboolean json_read_member_point(const JsonValue *object, const char *name, tdsp_point *point, GError **error);

/* An item of an array of known length. */
JsonValue json_read_item(const JsonValue *array, guint index);

/* Warn of members that are not in `known` (NULL-terminated), once for each name under each kind of place. */
void json_read_warn_unknown(const JsonValue *object, const char *const *known, GHashTable *warned);

#endif
