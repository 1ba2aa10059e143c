/* SPDX-License-Identifier: MIT */
/* Words for values. Each list is in the order of its enumeration (tdsp/types.h, tdsp/solver.h). */
#include "words.h"

#include <string.h>

#include "cli.h"
#include "tdsp/types.h"

static const char *const guarantees[] = {"travel", "arrival", "absolute", NULL};
static const char *const samplings[] = {"adaptive", "geometric", NULL};
static const char *const methods[] = {"auto", "same-speed", "different-speeds", "general", NULL};
static const char *const formats[] = {"json", "csv", "geojson", "gpx", NULL};
static const char *const monotones[] = {"travel", "arrival", NULL};

const WordsArgument *words_arguments(void)
{
    static const WordsArgument arguments[] = {
        {"GUARANTEE", guarantees}, {"SAMPLING", samplings}, {"METHOD", methods}, {"FORMAT", formats}, {NULL, NULL}};
    return arguments;
}

static const char *word_of(const char *const *words, guint32 value)
{
    for (guint32 i = 0; words[i]; i++)
        if (i == value) return words[i];
    return "unknown";
}

const char *words_guarantee(guint32 guarantee)
{
    return word_of(guarantees, guarantee);
}

const char *words_sampling(guint32 sampling)
{
    return word_of(samplings, sampling);
}

const char *words_monotone(guint32 monotone)
{
    return word_of(monotones, monotone);
}

const char *words_format(guint32 format)
{
    return word_of(formats, format);
}

const char *words_method(guint32 method)
{
    return word_of(methods, method);
}

static gboolean parse(const char *const *words, const char *option, const char *word, guint32 *value, GError **error)
{
    *value = 0;
    if (!word) return TRUE;
    for (guint32 i = 0; words[i]; i++) {
        if (strcmp(words[i], word) != 0) continue;
        *value = i;
        return TRUE;
    }
    g_autoptr(GString) list = g_string_new(NULL);
    for (guint32 i = 0; words[i]; i++) g_string_append_printf(list, "%s%s", i > 0 ? ", " : "", words[i]);
    return cli_fail(error, CLI_USAGE, "%s \"%s\": must be one of %s", option, word, list->str);
}

gboolean words_parse_guarantee(const char *option, const char *word, guint32 *value, GError **error)
{
    return parse(guarantees, option, word, value, error);
}

gboolean words_parse_method(const char *option, const char *word, guint32 *value, GError **error)
{
    return parse(methods, option, word, value, error);
}

gboolean words_parse_sampling(const char *option, const char *word, guint32 *value, GError **error)
{
    return parse(samplings, option, word, value, error);
}

gboolean words_parse_format(const char *option, const char *word, guint32 *value, GError **error)
{
    return parse(formats, option, word, value, error);
}
