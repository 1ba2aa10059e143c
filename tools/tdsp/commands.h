/* SPDX-License-Identifier: MIT */
/* The commands, one file each. */
#ifndef COMMANDS_H
#define COMMANDS_H

#include "cli.h"

int cmd_arrive(const CliCommand *command, int argc, char **argv, GError **error);
int cmd_depart(const CliCommand *command, int argc, char **argv, GError **error);
int cmd_margin(const CliCommand *command, int argc, char **argv, GError **error);
int cmd_path(const CliCommand *command, int argc, char **argv, GError **error);
int cmd_jumps(const CliCommand *command, int argc, char **argv, GError **error);
int cmd_envelope(const CliCommand *command, int argc, char **argv, GError **error);
int cmd_build(const CliCommand *command, int argc, char **argv, GError **error);
int cmd_matrix(const CliCommand *command, int argc, char **argv, GError **error);
int cmd_query(const CliCommand *command, int argc, char **argv, GError **error);
int cmd_info(const CliCommand *command, int argc, char **argv, GError **error);
int cmd_verify(const CliCommand *command, int argc, char **argv, GError **error);
int cmd_plot(const CliCommand *command, int argc, char **argv, GError **error);
int cmd_view(const CliCommand *command, int argc, char **argv, GError **error);
int cmd_embed(const CliCommand *command, int argc, char **argv, GError **error);
int cmd_convert(const CliCommand *command, int argc, char **argv, GError **error);
int cmd_generate(const CliCommand *command, int argc, char **argv, GError **error);

#endif
