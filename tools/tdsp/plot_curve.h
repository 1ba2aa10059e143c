/* SPDX-License-Identifier: MIT */
/* The picture of a table. */
#ifndef PLOT_CURVE_H
#define PLOT_CURVE_H

#include <glib.h>

#include "tdsp/table.h"

/* Draw the travel times of `table`, called `name`; `departure`, where not NULL, is marked with its interval. */
gboolean plot_curve(const tdsp_table *table, const char *name, const double *departure, const char *path, GError **error);

#endif
