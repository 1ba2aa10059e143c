/* SPDX-License-Identifier: MIT */
/* The jumps of a table's travel time, drawn into the picture of its curve. */
#ifndef PLOT_JUMPS_H
#define PLOT_JUMPS_H

#include "plot_labels.h"
#include "tdsp/table.h"

/* What jumps are drawn with. */
extern const Pen plot_jump_pen;

/* A jump's end: filled where it belongs to the curve. */
void plot_jump_end(Canvas *canvas, double x, double y, gboolean filled);

/* Draw all jumps; returns their number. No label is to hide their ends. */
guint plot_jumps(Canvas *canvas, const Frame *frame, const tdsp_table *table, const tdsp_table_info *info, Labels *labels);

/* Write beside the largest ones when they are, and what closes, as far as there is room. */
void plot_jump_labels(Canvas *canvas, const Frame *frame, const tdsp_table *table, const tdsp_table_info *info, Labels *labels);

/* The travel time up to which a picture goes whose travel times are from `low` to `high`: a jump that only the very last departures are
 * after leaves it, where it would press all others flat. */
double plot_jumps_cut(const tdsp_table *table, const tdsp_table_info *info, double low, double high);

#endif
