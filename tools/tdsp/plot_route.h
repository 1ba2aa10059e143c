/* SPDX-License-Identifier: MIT */
/* A path on the canvas: its legs, and marks of the time along it. */
#ifndef PLOT_ROUTE_H
#define PLOT_ROUTE_H

#include "plot_frame.h"
#include "plot_labels.h"

/* Draw the legs; arcs are drawn as the spirals they are. What is drawn becomes an obstacle for labels. */
void plot_route_draw(cairo_t *cr, const Frame *frame, const tdsp_leg *legs, gsize count, Labels *labels);

/* A tick and its time wherever a round time comes; returns the step. */
double plot_route_times(cairo_t *cr, const Frame *frame, const tdsp_leg *legs, gsize count, Labels *labels);

/* The circles of the discs that are ridden, as large as they are when the ride begins. */
void plot_route_ridden(cairo_t *cr, const Frame *frame, const tdsp_leg *legs, gsize count);

#endif
