/* SPDX-License-Identifier: MIT */
/* The words of the command line for values of enumerations. */
#ifndef WORDS_H
#define WORDS_H

#include <glib.h>

/* "travel", "arrival", "absolute"; "unknown" for any other value. */
const char *words_guarantee(guint32 guarantee);
const char *words_sampling(guint32 sampling);
const char *words_monotone(guint32 monotone);

const char *words_method(guint32 method);

/* Of tdsp convert: json, csv, geojson, gpx. */
const char *words_format(guint32 format);

/* The value of a word, or a usage error about `option` that lists the words. NULL is the first word. */
gboolean words_parse_guarantee(const char *option, const char *word, guint32 *value, GError **error);
gboolean words_parse_method(const char *option, const char *word, guint32 *value, GError **error);
gboolean words_parse_sampling(const char *option, const char *word, guint32 *value, GError **error);
gboolean words_parse_format(const char *option, const char *word, guint32 *value, GError **error);

/* What may be written where a command's arguments and options name one of these lists. The last has no name. */
typedef struct WordsArgument {
    const char *name;
    const char *const *words; /* ends with NULL */
} WordsArgument;

const WordsArgument *words_arguments(void);

#endif
