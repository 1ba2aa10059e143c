/* SPDX-License-Identifier: MIT */
/* The gaps that close at the jumps of a scene, drawn into its picture. */
#ifndef PLOT_GAPS_H
#define PLOT_GAPS_H

#include "plot_labels.h"
#include "tdsp/shape.h"

/* The mark of a gap. */
void plot_gap_mark(Canvas *canvas, double x, double y);

/* Mark each gap that is known, the largest jumps with their departures as far as there is room. NULL: nothing. */
void plot_gaps(Canvas *canvas, const Frame *frame, const tdsp_jumps *jumps, const char *unit, Labels *labels);

#endif
