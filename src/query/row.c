/* SPDX-License-Identifier: MIT */
/* Rows as they are stored: numbers, legs, opaque bytes. Each function compares its row where it stands, as the proof needs (tests/proof). */
#include "table/read.h"
#include "tdsp/table.h"

tdsp_status tdsp_table_row(const tdsp_table *table, uint64_t row, tdsp_row *out)
{
    if (!out || !table || !table->bytes || row >= table->rows) return TDSP_INVALID_ARGUMENT;
    out->departure = table_departure(table, row);
    out->left = table_left(table, row);
    out->right = table_right(table, row);
    out->legs = table_row_path(table, row).legs;
    return TDSP_OK;
}

tdsp_status tdsp_table_row_leg(const tdsp_table *table, uint64_t row, uint64_t leg, tdsp_leg *out)
{
    if (!out || !table || !table->bytes || row >= table->rows) return TDSP_INVALID_ARGUMENT;
    table_path path = table_row_path(table, row);
    if (leg >= path.legs) return TDSP_NO_ANSWER;
    table_path_leg(table, path, leg, out);
    return TDSP_OK;
}

tdsp_status tdsp_table_row_bytes(const tdsp_table *table, uint64_t row, const void **bytes, size_t *length)
{
    if (!bytes || !length || !table || !table->bytes || row >= table->rows) return TDSP_INVALID_ARGUMENT;
    *bytes = NULL;
    *length = 0;
    if (table->opaque_length == 0) return TDSP_OK;
    const unsigned char *p = table_opaque_bounds(table, row);
    uint64_t first = bytes_get_u64(p);
    uint64_t end = bytes_get_u64(p + 8);
    if (first >= end || end > table->opaque_length) return TDSP_OK;
    *bytes = table_at(table, table->opaque + first, 1);
    *length = (size_t)(end - first);
    return TDSP_OK;
}
