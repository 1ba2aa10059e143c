/* SPDX-License-Identifier: MIT */
/*
 * The command told to programs: `tdsp help --json`. Manual pages, completions and their tests are made from it, so that what they say of options
 * is what the command parses.
 */
#ifndef DESCRIBE_H
#define DESCRIBE_H

#include "cli.h"
#include "json_out.h"

/* The entries that are options of the command line, as items of a list. */
void describe_options(JsonOut *out, const GOptionEntry *entries);

/* The option that GOption adds to all. */
void describe_help_option(JsonOut *out);

/* The commands, their arguments and options, and what may stand for each argument that has a choice or is a file. */
gboolean describe_print(const CliCommand *commands, gsize count, GError **error);

#endif
