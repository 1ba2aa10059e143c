/* SPDX-License-Identifier: MIT */
/* Matrices on the command line: a pair by numbers or names, what a matrix holds, and its check. */
#ifndef MATRIX_PAIR_H
#define MATRIX_PAIR_H

#include "file_in.h"
#include "verify_report.h"

/* The numbers of the pair, each given as a number or as a name. */
gboolean matrix_pair_find(const FileIn *file, const char *from, const char *to, guint64 *i, guint64 *j, GError **error);

/* What it holds, pair by pair. */
gboolean matrix_pair_print(const FileIn *file, gboolean json, GError **error);

/* Check every table, and that there is a covered end where the matrix says so. */
gboolean matrix_pair_verify(VerifyReport *report, const tdsp_scene *scene, const tdsp_matrix *matrix, GError **error);

#endif
