/* SPDX-License-Identifier: MIT */
/* What is what in a picture: samples with their names, from left to right, in as many lines as it takes. */
#ifndef PLOT_LEGEND_H
#define PLOT_LEGEND_H

#include "plot_canvas.h"

typedef struct Legend {
    Canvas *canvas;
    double left, right;
    double x, y; /* where the next sample goes: its left end, its middle */
} Legend;

Legend legend_new(Canvas *canvas, double left, double right, double y);

/* Make room for a sample of this width with its name, and write that; returns where the sample begins. Its middle is at the legend's y then. */
double legend_item(Legend *legend, double sample, const char *name);

void legend_disc(Legend *legend, guint32 fill, guint32 edge, const char *name);
void legend_line(Legend *legend, const Pen *pen, const char *name);

#endif
