/* SPDX-License-Identifier: MIT */
/* What GOption parses and the words of words.c, as JSON. */
#include "describe.h"

#include "generate.h"
#include "tdsp/export.h"
#include "words.h"

/* Names of arguments that are files, and the endings that such files have by custom. Any other name ends a file may have is as good. */
typedef struct FileArgument {
    const char *name, *ending; /* NULL: any */
} FileArgument;

static const FileArgument file_arguments[] = {
    {"SCENE", "json"}, {"TABLE", "tdsp"}, {"MATRIX", "tdspm"}, {"PATH", "json"}, {"FILE", NULL}, {"FILE.c", "c"},
};

static const char *takes(const GOptionEntry *entry)
{
    if (entry->arg == G_OPTION_ARG_NONE) return NULL;
    return entry->arg == G_OPTION_ARG_FILENAME ? "file" : "text";
}

static void describe_option(JsonOut *out, const char *name, char letter, const char *value, const char *what, gboolean may_lack, const char *text)
{
    const char letters[] = {letter, '\0'};
    json_out_line(out);
    json_out_begin(out, '{');
    json_out_member_string(out, "long", name);
    json_out_member_string(out, "short", letter ? letters : NULL);
    json_out_member_string(out, "takes", what);
    json_out_member_string(out, "value", value);
    json_out_key(out, "value_may_lack");
    json_out_boolean(out, may_lack);
    json_out_member_string(out, "text", text);
    json_out_end(out, '}');
}

void describe_options(JsonOut *out, const GOptionEntry *entries)
{
    /* G_OPTION_REMAINING, the empty name, stands for the arguments that are no options. */
    for (; entries && entries->long_name; entries++)
        if (*entries->long_name)
            describe_option(out, entries->long_name, entries->short_name, entries->arg_description, takes(entries),
                            (entries->flags & G_OPTION_FLAG_OPTIONAL_ARG) != 0, entries->description);
}

void describe_help_option(JsonOut *out)
{
    describe_option(out, "help", 'h', NULL, NULL, FALSE, "Print help and an example");
}

static void describe_command(JsonOut *out, const CliCommand *command)
{
    json_out_line(out);
    json_out_begin(out, '{');
    json_out_member_string(out, "name", command->name);
    json_out_member_string(out, "arguments", command->arguments);
    json_out_member_string(out, "summary", command->summary);
    json_out_member_string(out, "help", command->help);
    json_out_key(out, "options");
    json_out_begin(out, '[');
    cli_tell_options(command, out);
    json_out_end(out, ']');
    json_out_end(out, '}');
}

static void describe_words(JsonOut *out, const char *argument, const char *const *words)
{
    json_out_key(out, argument);
    json_out_begin(out, '{');
    json_out_key(out, "words");
    json_out_begin(out, '[');
    for (; *words; words++) json_out_string(out, *words);
    json_out_end(out, ']');
    json_out_end(out, '}');
}

static void describe_arguments(JsonOut *out)
{
    g_autofree const char **kinds = generate_kind_names();
    for (const WordsArgument *list = words_arguments(); list->name; list++) describe_words(out, list->name, list->words);
    describe_words(out, "KIND", kinds);
    for (gsize i = 0; i < G_N_ELEMENTS(file_arguments); i++) {
        json_out_key(out, file_arguments[i].name);
        json_out_begin(out, '{');
        json_out_member_string(out, "file", file_arguments[i].ending ? file_arguments[i].ending : "");
        json_out_end(out, '}');
    }
}

gboolean describe_print(const CliCommand *commands, gsize count, GError **error)
{
    g_auto(JsonOut) out = json_out_new();
    json_out_begin(&out, '{');
    json_out_member_string(&out, "version", TDSP_VERSION_STRING);
    json_out_key(&out, "commands");
    json_out_begin(&out, '[');
    for (gsize i = 0; i < count; i++) describe_command(&out, &commands[i]);
    json_out_end(&out, ']');
    json_out_line(&out);
    json_out_key(&out, "arguments");
    json_out_begin(&out, '{');
    describe_arguments(&out);
    json_out_end(&out, '}');
    json_out_end(&out, '}');
    return json_out_print(&out, error);
}
