/* SPDX-License-Identifier: MIT */
/* The clock of a picture that moves. */
#ifndef PLOT_CLOCK_H
#define PLOT_CLOCK_H

#include "plot_canvas.h"

#define PLOT_CLOCK_WIDTH 150.0 /* what it may need of the canvas */

/* The scene's time, ending at `x` on the base line `y`, over the timeline of the canvas. */
void plot_clock(Canvas *canvas, double x, double y, const char *unit);

#endif
