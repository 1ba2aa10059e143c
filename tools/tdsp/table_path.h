/* SPDX-License-Identifier: MIT */
/* The path that a table gives for a departure. */
#ifndef TABLE_PATH_H
#define TABLE_PATH_H

#include <glib.h>

#include "tdsp/table.h"

typedef struct TablePath {
    tdsp_status status; /* TDSP_OK, or why there is no path */
    double arrival;     /* infinite without a path */
    guint64 row;
    double computed_for; /* b_i, the departure of the row */
    GArray *legs;        /* of tdsp_leg, empty without a path; owned by the caller */
} TablePath;

gboolean table_path_find(const tdsp_table *table, double departure, TablePath *out, GError **error);


#endif
