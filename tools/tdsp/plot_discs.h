/* SPDX-License-Identifier: MIT */
/* All discs of a scene as they are at one time, as one shape. */
#ifndef PLOT_DISCS_H
#define PLOT_DISCS_H

#include "plot_frame.h"
#include "tdsp/scene.h"

typedef struct DiscsStyle {
    guint32 colour;
    double least; /* points of the canvas: no disc is drawn with a smaller radius, */
    double wider; /* and this comes on top */
} DiscsStyle;

/* Fill the union of the discs at `time`. */
void plot_discs_fill(cairo_t *cr, const Frame *frame, const tdsp_scene *scene, double time, const DiscsStyle *style);

#endif
