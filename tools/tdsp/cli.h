/* SPDX-License-Identifier: MIT */
/*
 * What all commands share: exit statuses, errors that carry them, options, and output.
 *
 * A command is a function from its arguments to an exit status. Everything below it that can fail takes a GError whose code
 * is the exit status that the failure means; only main() prints errors. Results are gathered in memory and written once, so
 * that a failure half-way leaves standard output empty.
 */
#ifndef CLI_H
#define CLI_H

#include <glib.h>

#include "tdsp/status.h"
#include "tdsp/types.h"

/* Exit statuses; part of the command line's contract. */
enum {
    CLI_DONE = 0,
    CLI_NO = 1,     /* the answer is no: no path at any time asked for, nothing to build, verification failed */
    CLI_USAGE = 2,  /* the command line is wrong */
    CLI_INPUT = 3,  /* a file's content is wrong */
    CLI_SYSTEM = 4, /* no such file, cannot write, no memory */
    CLI_FAILED = -1 /* what a command returns when it has set its error, whose code is the exit status */
};

/* The domain of errors whose code is one of the exit statuses above. */
#define CLI_ERROR cli_error_quark()
GQuark cli_error_quark(void);

struct JsonOut;

typedef struct CliCommand {
    const char *name;
    const char *arguments; /* e.g. "SCENE T..." */
    const char *summary;   /* one line, for the list of commands */
    const char *help;      /* what it does and prints, with an example */
    int (*run)(const struct CliCommand *command, int argc, char **argv, GError **error);
} CliCommand;

/**
 * Parse options; what is left are the positional arguments, argv[1] on. Prints help and exits where asked to.
 * Every command has --json: `json` receives it. A command does this first, so that one whose options are asked for by
 * cli_tell_options() does nothing else.
 */
gboolean cli_parse(const CliCommand *command, const GOptionEntry *entries, gboolean *json, int *argc, char ***argv,
                   GError **error);

/* The same for entries with callbacks, which receive `data`. An error of a callback that is one of ours is handed on as it is. */
gboolean cli_parse_data(const CliCommand *command, const GOptionEntry *entries, gpointer data, gboolean *json, int *argc,
                        char ***argv, GError **error);

/* Write the command's options as items of a list, in the place of running it. */
void cli_tell_options(const CliCommand *command, struct JsonOut *out);

/* A usage error unless there are `least` to `most` positional arguments (most < 0: any number). */
gboolean cli_positional(const CliCommand *command, int argc, int least, int most, GError **error);

/*
 * The value of an option: a number that is not negative; two numbers in the form "X,Y" or "LON,LAT", which messages call `form`. What it goes to stays as it is
 * where `text` is NULL, for an option that was not given. Else a usage error that names the option.
 */
gboolean cli_option_number(const char *option, const char *text, double *value, GError **error);
gboolean cli_option_point(const char *option, const char *text, const char *form, tdsp_point *point, GError **error);

/* Set an error: `status` is an exit status. Returns FALSE, so that callers can return it. */
gboolean cli_fail(GError **error, int status, const char *format, ...) G_GNUC_PRINTF(3, 4);

/* Turn a library status that is no answer into an error about `what`. Returns FALSE. */
gboolean cli_fail_status(GError **error, const char *what, tdsp_status status);

/* The status as the end of a sentence: its text without the capital. Free with g_free(). */
char *cli_reason(tdsp_status status);

/* A line on standard error that does not stop the command. */
void cli_warn(const char *format, ...) G_GNUC_PRINTF(1, 2);

/*
 * The text with control characters written \xNN, but for those in `kept`: a terminal would obey what stands in the names of a file. The caller frees it.
 */
GString *cli_plain(const char *text, gsize length, const char *kept);

/* A message on standard error, behind a word and a colon. */
void cli_say(const char *before, const char *message);

/* Write all of `text`, made plain but for its lines, to standard output and make sure that it got there. */
gboolean cli_print(const GString *text, GError **error);

/* Quote-free name for messages: "standard input" for "-". */
const char *cli_file_name(const char *path);

/* CLI_DONE or CLI_NO. */
int cli_answer(gboolean yes);

#endif
