/* SPDX-License-Identifier: MIT */
/* Errors, options and output common to all commands. */
#include "cli.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "describe.h"
#include "descriptor.h"
#include "numbers.h"

GQuark cli_error_quark(void)
{
    return g_quark_from_static_string("tdsp-cli-error");
}

gboolean cli_fail(GError **error, int status, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    g_autofree char *message = g_strdup_vprintf(format, arguments);
    va_end(arguments);
    g_set_error_literal(error, CLI_ERROR, status, message);
    return FALSE;
}

/* Families of status.h: mistakes of the caller are ours here, for the command line was checked before. */
static int exit_status_of(tdsp_status status)
{
    if (status == TDSP_NEEDS_HORIZON || status == TDSP_TOO_MANY_ROWS || status == TDSP_NOT_SUPPORTED) return CLI_USAGE;
    if ((status >= TDSP_BAD_SCENE && status < TDSP_BAD_ORACLE) || status == TDSP_SHRINKS) return CLI_INPUT;
    return CLI_SYSTEM;
}

char *cli_reason(tdsp_status status)
{
    char *text = g_strdup(tdsp_status_text(status));
    *text = g_ascii_tolower(*text);
    return text;
}

gboolean cli_fail_status(GError **error, const char *what, tdsp_status status)
{
    g_autofree char *reason = cli_reason(status);
    return cli_fail(error, exit_status_of(status), "%s: %s", what, reason);
}

/* Is this a control character that begins here, of one byte or, from U+0080 to U+009F, of two? Its bytes, or 0. */
static gsize control_at(const char *text, gsize left)
{
    const unsigned char first = (unsigned char)text[0];
    if (first == 0xc2 && left > 1) return (unsigned char)text[1] < 0xa0 ? 2 : 0;
    return first < 0x20 || first == 0x7f ? 1 : 0;
}

GString *cli_plain(const char *text, gsize length, const char *kept)
{
    GString *plain = g_string_sized_new(length);
    for (gsize i = 0; i < length;) {
        gsize control = strchr(kept, text[i]) && text[i] ? 0 : control_at(text + i, length - i);
        if (control == 0) g_string_append_c(plain, text[i++]);
        for (; control > 0; control--) g_string_append_printf(plain, "\\x%02x", (unsigned char)text[i++]);
    }
    return plain;
}

void cli_say(const char *before, const char *message)
{
    GString *plain = cli_plain(message, strlen(message), "");
    fprintf(stderr, "%s: %s\n", before, plain->str);
    g_string_free(plain, TRUE);
}

void cli_warn(const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    g_autofree char *message = g_strdup_vprintf(format, arguments);
    va_end(arguments);
    cli_say("tdsp: warning", message);
}

gboolean cli_print(const GString *text, GError **error)
{
    GString *plain = cli_plain(text->str, text->len, "\n\t");
    int code = descriptor_write_all(STDOUT_FILENO, plain->str, plain->len);
    g_string_free(plain, TRUE);
    return code == 0 ? TRUE : cli_fail(error, CLI_SYSTEM, "cannot write standard output: %s", g_strerror(code));
}

const char *cli_file_name(const char *path)
{
    return strcmp(path, "-") == 0 ? "standard input" : path;
}

int cli_answer(gboolean yes)
{
    return yes ? CLI_DONE : CLI_NO;
}

static char *usage_hint(const CliCommand *command)
{
    return g_strdup_printf("(usage: tdsp %s %s; more: tdsp %s --help)", command->name, command->arguments, command->name);
}

/* GOption prints its help by g_print() and ends the process, whether that could be written or not. */
static void print_help(const char *text)
{
    int code = descriptor_write_all(STDOUT_FILENO, text, strlen(text));
    if (code == 0) return;
    fprintf(stderr, "%s: cannot write standard output: %s\n", g_get_prgname(), g_strerror(code));
    exit(CLI_SYSTEM);
}

/* Where options are told and not parsed: entries point at variables of their command, so that only it can hand them over. */
static JsonOut *options_to;

void cli_tell_options(const CliCommand *command, JsonOut *out)
{
    g_autoptr(GError) none = NULL;
    char name[] = "tdsp";
    char *arguments[] = {name, NULL};
    options_to = out;
    command->run(command, 1, arguments, &none);
    options_to = NULL;
}

static gboolean tell_options(const GOptionEntry *shared, const GOptionEntry *entries)
{
    describe_options(options_to, entries);
    describe_options(options_to, shared);
    describe_help_option(options_to);
    return FALSE;
}

gboolean cli_parse_data(const CliCommand *command, const GOptionEntry *entries, gpointer data, gboolean *json, int *argc,
                        char ***argv, GError **error)
{
    const GOptionEntry shared[] = {
        {"json", 0, 0, G_OPTION_ARG_NONE, json, "Print JSON", NULL},
        G_OPTION_ENTRY_NULL,
    };
    if (options_to) return tell_options(shared, entries);
    g_autoptr(GOptionContext) context = g_option_context_new(command->arguments);
    GOptionGroup *group = g_option_group_new("main", "", "", data, NULL);
    g_option_group_add_entries(group, shared);
    if (entries) g_option_group_add_entries(group, entries);
    g_option_context_set_main_group(context, group);
    g_option_context_set_summary(context, command->help);
    g_autofree char *program = g_strdup_printf("tdsp %s", command->name);
    g_set_prgname(program);
    g_set_print_handler(print_help);
    GError *wrong = NULL;
    if (g_option_context_parse(context, argc, argv, &wrong)) return TRUE;
    if (wrong->domain == CLI_ERROR) {
        g_propagate_error(error, wrong);
        return FALSE;
    }
    g_autofree char *hint = usage_hint(command);
    cli_fail(error, CLI_USAGE, "%s %s", wrong->message, hint);
    g_error_free(wrong);
    return FALSE;
}

/* GOption leaves the separator "--" among the positional arguments. */
static void drop_separator(int *argc, char **argv)
{
    for (int i = 1; i < *argc; i++) {
        if (strcmp(argv[i], "--") != 0) continue;
        memmove(argv + i, argv + i + 1, (size_t)(*argc - i) * sizeof *argv);
        --*argc;
        return;
    }
}

gboolean cli_parse(const CliCommand *command, const GOptionEntry *entries, gboolean *json, int *argc, char ***argv,
                   GError **error)
{
    if (!cli_parse_data(command, entries, NULL, json, argc, argv, error)) return FALSE;
    drop_separator(argc, *argv);
    return TRUE;
}

gboolean cli_positional(const CliCommand *command, int argc, int least, int most, GError **error)
{
    int given = argc - 1;
    if (given >= least && (most < 0 || given <= most)) return TRUE;
    g_autofree char *hint = usage_hint(command);
    return cli_fail(error, CLI_USAGE, "%s %s", given < least ? "too few arguments" : "too many arguments", hint);
}

static gboolean fail_option(const char *option, const char *text, const char *wrong, GError **error)
{
    return cli_fail(error, CLI_USAGE, "%s \"%s\": %s", option, text, wrong);
}

gboolean cli_option_number(const char *option, const char *text, double *value, GError **error)
{
    const char *wrong = text ? number_parse_time(text, value) : NULL;
    return wrong ? fail_option(option, text, wrong, error) : TRUE;
}

gboolean cli_option_point(const char *option, const char *text, const char *form, tdsp_point *point, GError **error)
{
    if (!text) return TRUE;
    g_auto(GStrv) parts = g_strsplit(text, ",", 0);
    if (g_strv_length(parts) != 2) return cli_fail(error, CLI_USAGE, "%s \"%s\": must be two numbers, %s", option, text, form);
    const char *wrong = number_parse(g_strstrip(parts[0]), &point->x);
    if (!wrong) wrong = number_parse(g_strstrip(parts[1]), &point->y);
    return wrong ? fail_option(option, text, wrong, error) : TRUE;
}
