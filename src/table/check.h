/* SPDX-License-Identifier: MIT */
/* What must hold between the numbers of a table whose sections are known to lie inside its bytes. */
#ifndef TABLE_CHECK_H
#define TABLE_CHECK_H

#include "tdsp/table.h"

/* Each: 1 when it holds, else 0. `bytes` of the table at least a header. */
int check_header(const tdsp_table *table);
int check_rows(const tdsp_table *table);
int check_paths(const tdsp_table *table);
int check_opaque(const tdsp_table *table);
int check_guides(const tdsp_table *table);
int check_gaps(const tdsp_table *table);

/* As tdsp_table_open(), but what it gives back when it fails is of no use. */
tdsp_status table_open_into(tdsp_table *view, const void *bytes, size_t length);

/*
 * Are a curve's numbers in their range, and so that its polynomials have finite coefficients? Its places and the order of its times are not
 * looked at.
 */
int check_curve(const tdsp_leg *leg);

#endif
