/* SPDX-License-Identifier: MIT */
/* The path that a table gives for a departure. */
#include "table_path.h"

#include <math.h>

#include "cli.h"

static GArray *legs_at(const tdsp_table *table, double departure, GError **error)
{
    size_t count;
    tdsp_status status = tdsp_table_path(table, departure, NULL, 0, &count);
    GArray *legs = g_array_new(FALSE, TRUE, sizeof(tdsp_leg));
    if (status == TDSP_BUFFER_TOO_SMALL) {
        g_array_set_size(legs, (guint)count);
        status = tdsp_table_path(table, departure, (tdsp_leg *)legs->data, count, &count);
    }
    if (status == TDSP_OK) return legs;
    g_array_unref(legs);
    cli_fail_status(error, "path", status);
    return NULL;
}

/* The path itself arrives when its last leg ends; a row of an oracle whose paths are bytes has only its travel time. */
static double arrival_of(const TablePath *path, const tdsp_row *row, double departure)
{
    return path->legs->len > 0 ? g_array_index(path->legs, tdsp_leg, path->legs->len - 1).end_time : departure + row->left;
}

gboolean table_path_find(const tdsp_table *table, double departure, TablePath *out, GError **error)
{
    TablePath found = {.arrival = INFINITY};
    tdsp_row row;
    found.status = tdsp_table_find(table, departure, &found.row);
    if (!tdsp_status_is_answer(found.status)) return cli_fail_status(error, "table", found.status);
    if (found.status != TDSP_OK) {
        found.legs = g_array_new(FALSE, TRUE, sizeof(tdsp_leg));
        *out = found;
        return TRUE;
    }
    tdsp_status status = tdsp_table_row(table, found.row, &row);
    if (status != TDSP_OK) return cli_fail_status(error, "table", status);
    found.computed_for = row.departure;
    found.legs = legs_at(table, departure, error);
    if (!found.legs) return FALSE;
    found.arrival = arrival_of(&found, &row, departure);
    *out = found;
    return TRUE;
}
