/* SPDX-License-Identifier: MIT */
/* Typed access to parsed JSON, with places in its messages. */
#include "json_read.h"

#include <math.h>
#include <string.h>

#include "cli.h"
#include "json_scan.h"

static const char *place_file(const JsonPlace *place)
{
    while (place->above) place = place->above;
    return place->file;
}

/* The member path; with `generic`, items are written [] so that all of them are one kind of place. */
static void place_append(const JsonPlace *place, gboolean generic, GString *into)
{
    GPtrArray *chain = g_ptr_array_new();
    for (const JsonPlace *at = place; at->above; at = at->above) g_ptr_array_add(chain, (gpointer)at);
    for (guint i = chain->len; i-- > 0;) {
        const JsonPlace *at = g_ptr_array_index(chain, i);
        if (at->member)
            g_string_append_printf(into, "%s%s", into->len > 0 ? "." : "", at->member);
        else if (generic)
            g_string_append(into, "[]");
        else
            g_string_append_printf(into, "[%u]", at->item);
    }
    g_ptr_array_free(chain, TRUE);
}

gboolean json_read_fail(const JsonPlace *place, GError **error, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    g_autofree char *reason = g_strdup_vprintf(format, arguments);
    va_end(arguments);
    g_autoptr(GString) path = g_string_new(NULL);
    place_append(place, FALSE, path);
    return cli_fail(error, CLI_INPUT, "%s: %s%s%s", place_file(place), path->str, path->len > 0 ? ": " : "", reason);
}

gboolean json_read_document(const char *file, const char *text, gsize length, JsonParser **parser, JsonValue *root,
                            GError **error)
{
    g_autoptr(GString) clean = json_scan(file, text, length, error);
    if (!clean) return FALSE;
    g_autoptr(JsonParser) parsing = json_parser_new_immutable();
    g_autoptr(GError) wrong = NULL;
    if (!json_parser_load_from_data(parsing, clean->str, (gssize)clean->len, &wrong))
        return cli_fail(error, CLI_INPUT, "%s: %s", file, wrong->message);
    *root = (JsonValue){json_parser_get_root(parsing), {NULL, NULL, 0, file}};
    *parser = g_steal_pointer(&parsing);
    return TRUE;
}

static const char *type_of(JsonNode *node)
{
    if (JSON_NODE_HOLDS_OBJECT(node)) return "an object";
    if (JSON_NODE_HOLDS_ARRAY(node)) return "an array";
    if (JSON_NODE_HOLDS_NULL(node)) return "null";
    switch (json_node_get_value_type(node)) {
    case G_TYPE_STRING: return "a string";
    case G_TYPE_BOOLEAN: return "true or false";
    default: return "a number";
    }
}

static gboolean fail_type(const JsonValue *value, const char *wanted, GError **error)
{
    return json_read_fail(&value->place, error, "must be %s, not %s", wanted, type_of(value->node));
}

gboolean json_read_object(const JsonValue *value, GError **error)
{
    return JSON_NODE_HOLDS_OBJECT(value->node) ? TRUE : fail_type(value, "an object", error);
}

gboolean json_read_array(const JsonValue *value, guint *length, GError **error)
{
    if (!JSON_NODE_HOLDS_ARRAY(value->node)) return fail_type(value, "an array", error); /* NOLINT(clang-analyzer-core.CallAndMessage): a value that was read has a node */
    *length = json_array_get_length(json_node_get_array(value->node));
    return TRUE;
}

static gboolean holds(const JsonValue *value, GType type)
{
    return JSON_NODE_HOLDS_VALUE(value->node) && json_node_get_value_type(value->node) == type; /* NOLINT(clang-analyzer-core.CallAndMessage): a value that was read has a node */
}

gboolean json_read_number(const JsonValue *value, double *number, GError **error)
{
    if (!holds(value, G_TYPE_INT64) && !holds(value, G_TYPE_DOUBLE)) return fail_type(value, "a number", error);
    *number = json_node_get_double(value->node);
    return TRUE;
}

gboolean json_read_string(const JsonValue *value, const char **string, GError **error)
{
    if (!holds(value, G_TYPE_STRING)) return fail_type(value, "a string", error);
    *string = json_node_get_string(value->node);
    return TRUE;
}

gboolean json_read_point(const JsonValue *value, tdsp_point *point, GError **error)
{
    guint length = 0;
    tdsp_point read = {0.0, 0.0};
    if (!json_read_array(value, &length, error)) return FALSE;
    if (length != 2) return json_read_fail(&value->place, error, "a point has exactly two numbers, not %u", length);
    JsonValue x = json_read_item(value, 0), y = json_read_item(value, 1);
    if (!json_read_number(&x, &read.x, error) || !json_read_number(&y, &read.y, error)) return FALSE;
    *point = read;
    return TRUE;
}

gboolean json_read_optional(const JsonValue *object, const char *name, JsonValue *member)
{
    JsonNode *node = json_object_get_member(json_node_get_object(object->node), name);
    if (!node) return FALSE;
    *member = (JsonValue){node, {&object->place, name, 0, NULL}};
    return TRUE;
}

gboolean json_read_member(const JsonValue *object, const char *name, JsonValue *member, GError **error)
{
    if (json_read_optional(object, name, member)) return TRUE;
    JsonPlace place = {&object->place, name, 0, NULL};
    return json_read_fail(&place, error, "missing");
}

gboolean json_read_member_number(const JsonValue *object, const char *name, double *number, GError **error)
{
    JsonValue member;
    return json_read_member(object, name, &member, error) && json_read_number(&member, number, error);
}

gboolean json_read_member_point(const JsonValue *object, const char *name, tdsp_point *point, GError **error)
{
    JsonValue member;
    return json_read_member(object, name, &member, error) && json_read_point(&member, point, error);
}

JsonValue json_read_item(const JsonValue *array, guint index)
{
    return (JsonValue){json_array_get_element(json_node_get_array(array->node), index), {&array->place, NULL, index, NULL}};
}

/* So many unknown keys are named; a file may have any number. */
#define MOST_WARNINGS 20

void json_read_warn_unknown(const JsonValue *object, const char *const *known, GHashTable *warned)
{
    JsonObjectIter iter;
    const char *name;
    json_object_iter_init(&iter, json_node_get_object(object->node));
    while (json_object_iter_next(&iter, &name, NULL)) {
        if (g_strv_contains(known, name)) continue;
        JsonPlace place = {&object->place, name, 0, NULL};
        g_autoptr(GString) kind = g_string_new(NULL);
        place_append(&place, TRUE, kind);
        if (g_hash_table_size(warned) > MOST_WARNINGS || !g_hash_table_add(warned, g_strdup(kind->str))) continue;
        if (g_hash_table_size(warned) > MOST_WARNINGS)
            cli_warn("%s: more unknown keys ignored", place_file(&place));
        else
            cli_warn("%s: %s: unknown key ignored", place_file(&place), kind->str);
    }
}
