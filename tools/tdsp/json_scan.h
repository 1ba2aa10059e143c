/* SPDX-License-Identifier: MIT */
/*
 * A strict first pass over JSON text (RFC 8259). json-glib accepts comments, hexadecimal, trailing commas, duplicate keys and
 * numbers that do not fit, and a deep nest overruns its stack; whatever passes here it reads rightly.
 */
#ifndef JSON_SCAN_H
#define JSON_SCAN_H

#include <glib.h>

#define JSON_SCAN_DEPTH 32 /* a scene needs 4 */

/**
 * Check `text` (of `length` bytes, followed by a zero byte). On success returns the text for json-glib: the same, but with whole
 * numbers of more than 15 digits written as decimal fractions, for json-glib would squeeze them into 64 bits.
 * On failure NULL, and an error that names `file`, line, column and the reason.
 */
GString *json_scan(const char *file, const char *text, gsize length, GError **error);

#endif
