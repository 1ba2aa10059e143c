/* SPDX-License-Identifier: MIT */
/* The jumps of a table's travel time, drawn into the picture of its curve. */
#ifndef PLOT_JUMPS_H
#define PLOT_JUMPS_H

#include "plot_labels.h"
#include "tdsp/table.h"

/* A jump's end: filled where it belongs to the curve. */
void plot_jump_end(cairo_t *cr, double x, double y, gboolean filled);

/* Draw all jumps; returns their number. */
guint plot_jumps(cairo_t *cr, const Frame *frame, const tdsp_table *table, const tdsp_table_info *info);

/* Write beside the largest ones when they are, and what closes, as far as there is room. */
void plot_jump_labels(cairo_t *cr, const Frame *frame, const tdsp_table *table, const tdsp_table_info *info, Labels *labels);

#endif
