/* SPDX-License-Identifier: MIT */
/*
 * Strict scanner for JSON: recursive descent, one function for each production of the grammar, depth bounded by JSON_SCAN_DEPTH.
 *
 * Invariant: a function is called with the cursor on the first byte of its production and returns TRUE with the cursor just
 * behind it, or FALSE with the cursor on the offending byte and `wrong` set. The zero byte behind the text stops every loop.
 */
#include "json_scan.h"

#include <math.h>
#include <string.h>

#include "cli.h"
#include "numbers.h"

typedef struct Scan {
    const char *text;
    const char *end;
    const char *at;
    const char *wrong; /* the reason, once something is wrong */
    char *detail;      /* what it is about, or NULL */
    int depth;
    GString *out;
    GString *string;                   /* the last string, its escapes resolved */
    GHashTable *keys[JSON_SCAN_DEPTH]; /* of the objects that are open */
} Scan;

static gboolean scan_value(Scan *scan);

static gboolean fail(Scan *scan, const char *at, const char *wrong)
{
    scan->at = at;
    scan->wrong = wrong;
    return FALSE;
}

static void skip_space(Scan *scan)
{
    scan->at += strspn(scan->at, " \t\r\n");
}

static void copy(Scan *scan, const char *from)
{
    g_string_append_len(scan->out, from, scan->at - from);
}

static gboolean hex4(const char *at, gunichar *value)
{
    gunichar sum = 0;
    for (int i = 0; i < 4; i++) {
        if (!g_ascii_isxdigit(at[i])) return FALSE;
        sum = sum * 16 + (gunichar)g_ascii_xdigit_value(at[i]);
    }
    *value = sum;
    return TRUE;
}

/* \uXXXX, or two of them for a character beyond the first plane. */
static gboolean scan_unicode_escape(Scan *scan)
{
    gunichar high, low;
    const char *start = scan->at;
    if (!hex4(start + 2, &high)) return fail(scan, start, "a \\u escape needs four hexadecimal digits");
    scan->at += 6;
    if (high >= 0xd800 && high < 0xe000) {
        if (high >= 0xdc00 || scan->at[0] != '\\' || scan->at[1] != 'u' || !hex4(scan->at + 2, &low) || low < 0xdc00 ||
            low >= 0xe000)
            return fail(scan, start, "half of a surrogate pair");
        high = 0x10000 + ((high - 0xd800) << 10) + (low - 0xdc00);
        scan->at += 6;
    }
    if (high == 0) return fail(scan, start, "a zero character in a string");
    g_string_append_unichar(scan->string, high);
    return TRUE;
}

static gboolean scan_escape(Scan *scan)
{
    static const char names[] = "\"\\/bfnrt", values[] = "\"\\/\b\f\n\r\t";
    char name = scan->at[1];
    if (name == 'u') return scan_unicode_escape(scan);
    const char *found = name == '\0' ? NULL : strchr(names, name);
    if (!found) return fail(scan, scan->at, "unknown escape in a string");
    g_string_append_c(scan->string, values[found - names]);
    scan->at += 2;
    return TRUE;
}

static gboolean scan_string(Scan *scan)
{
    const char *start = scan->at++;
    g_string_truncate(scan->string, 0);
    while (*scan->at != '"') {
        if ((unsigned char)*scan->at < 0x20)
            return scan->at == scan->end ? fail(scan, start, "a string that never ends")
                                         : fail(scan, scan->at, "a control character in a string");
        if (*scan->at == '\\') {
            if (!scan_escape(scan)) return FALSE;
        } else {
            g_string_append_c(scan->string, *scan->at++);
        }
    }
    scan->at++;
    copy(scan, start);
    return TRUE;
}

static const char *digits_from(const char *at)
{
    while (g_ascii_isdigit(*at)) at++;
    return at;
}

/* The token's end, or NULL. */
static const char *number_end(const char *at)
{
    if (*at == '-') at++;
    if (!g_ascii_isdigit(*at) || (*at == '0' && g_ascii_isalnum(at[1]) && at[1] != 'e' && at[1] != 'E')) return NULL;
    at = digits_from(at);
    if (*at == '.') {
        if (!g_ascii_isdigit(at[1])) return NULL;
        at = digits_from(at + 1);
    }
    if (*at == 'e' || *at == 'E') {
        at += at[1] == '+' || at[1] == '-' ? 2 : 1;
        if (!g_ascii_isdigit(*at)) return NULL;
        at = digits_from(at);
    }
    return at;
}

static gboolean scan_number(Scan *scan)
{
    const char *start = scan->at, *end = number_end(start);
    if (!end) return fail(scan, start, "not a number as JSON writes them");
    double value;
    g_autofree char *token = g_strndup(start, (gsize)(end - start));
    if (number_parse(token, &value)) return fail(scan, start, "a number too large for a double");
    scan->at = end;
    copy(scan, start);
    if (end - start > 15 && !strpbrk(token, ".eE")) g_string_append(scan->out, ".0");
    return TRUE;
}

static gboolean scan_word(Scan *scan)
{
    static const char *const words[] = {"true", "false", "null"};
    const char *start = scan->at;
    gsize length = 0;
    while (g_ascii_isalnum(start[length])) length++;
    for (gsize i = 0; i < G_N_ELEMENTS(words); i++) {
        if (length != strlen(words[i]) || strncmp(start, words[i], length) != 0) continue;
        scan->at += length;
        copy(scan, start);
        return TRUE;
    }
    if (start == scan->end) return fail(scan, start, "the text ends too early");
    if (length > 0) scan->detail = g_strndup(start, MIN(length, 40));
    return fail(scan, start, length > 0 ? "not a JSON value" : "expected a value");
}

/* The separator or the closing bracket; `more` tells which. */
static gboolean scan_separator(Scan *scan, char close, const char *wrong, gboolean *more)
{
    skip_space(scan);
    *more = *scan->at == ',';
    if (*scan->at != close && !*more) return fail(scan, scan->at, scan->at == scan->end ? "the text ends too early" : wrong);
    g_string_append_c(scan->out, *scan->at++);
    if (*more) skip_space(scan);
    return TRUE;
}

/* "key": value; the key must be new in this object. */
static gboolean scan_member(Scan *scan, GHashTable *keys)
{
    const char *start = scan->at;
    if (*start != '"')
        return fail(scan, start, start == scan->end ? "the text ends too early" : "expected a key in double quotes");
    if (!scan_string(scan)) return FALSE;
    if (!g_hash_table_add(keys, g_strdup(scan->string->str))) {
        scan->detail = g_strdup(scan->string->str);
        return fail(scan, start, "duplicate key");
    }
    skip_space(scan);
    if (*scan->at != ':') return fail(scan, scan->at, "expected a colon after the key");
    g_string_append_c(scan->out, *scan->at++);
    return scan_value(scan);
}

static GHashTable *empty_keys(Scan *scan)
{
    GHashTable **keys = &scan->keys[scan->depth - 1];
    if (!*keys) *keys = g_hash_table_new_full(g_str_hash, g_str_equal, g_free, NULL);
    g_hash_table_remove_all(*keys);
    return *keys;
}

/* An object or an array: items between brackets, with separators. */
static gboolean scan_bracketed(Scan *scan)
{
    gboolean object = *scan->at == '{', more = TRUE;
    char close = object ? '}' : ']';
    if (scan->depth == JSON_SCAN_DEPTH) return fail(scan, scan->at, "nested too deeply");
    scan->depth++;
    GHashTable *keys = object ? empty_keys(scan) : NULL;
    g_string_append_c(scan->out, *scan->at++);
    skip_space(scan);
    if (*scan->at == close) {
        g_string_append_c(scan->out, *scan->at++);
        more = FALSE;
    }
    while (more) {
        if (!(object ? scan_member(scan, keys) : scan_value(scan))) return FALSE;
        if (!scan_separator(scan, close, object ? "expected a comma or }" : "expected a comma or ]", &more)) return FALSE;
    }
    scan->depth--;
    return TRUE;
}

static gboolean scan_value(Scan *scan)
{
    skip_space(scan);
    char first = *scan->at;
    if (first == '{' || first == '[') return scan_bracketed(scan);
    if (first == '"') return scan_string(scan);
    if (first == '-' || g_ascii_isdigit(first)) return scan_number(scan);
    return scan_word(scan);
}

static gboolean scan_document(Scan *scan)
{
    const char *bad;
    if (!g_utf8_validate_len(scan->text, (gsize)(scan->end - scan->text), &bad))
        return fail(scan, bad, *bad == '\0' ? "a zero byte" : "not UTF-8");
    if (!scan_value(scan)) return FALSE;
    skip_space(scan);
    return scan->at == scan->end ? TRUE : fail(scan, scan->at, "something follows the end of the JSON value");
}

/* Line and column, in characters, of the place where it went wrong. */
static void report(const Scan *scan, const char *file, GError **error)
{
    const char *line = scan->text;
    guint number = 1;
    for (const char *at = scan->text; at < scan->at; at++) {
        if (*at != '\n') continue;
        number++;
        line = at + 1;
    }
    glong column = g_utf8_strlen(line, scan->at - line) + 1;
    cli_fail(error, CLI_INPUT, "%s:%u:%ld: %s%s%s", file, number, column, scan->wrong, scan->detail ? ": " : "",
             scan->detail ? scan->detail : "");
}

GString *json_scan(const char *file, const char *text, gsize length, GError **error)
{
    Scan scan = {.text = text, .end = text + length, .at = text};
    if (g_str_has_prefix(text, "\xef\xbb\xbf")) scan.text = scan.at = text + 3;
    scan.out = g_string_sized_new(length + 1);
    scan.string = g_string_new(NULL);
    gboolean whole = scan_document(&scan);
    if (!whole) {
        report(&scan, file, error);
        g_string_free(g_steal_pointer(&scan.out), TRUE);
    }
    g_string_free(scan.string, TRUE);
    g_free(scan.detail);
    for (gsize i = 0; i < G_N_ELEMENTS(scan.keys); i++) g_clear_pointer(&scan.keys[i], g_hash_table_unref);
    return scan.out;
}
