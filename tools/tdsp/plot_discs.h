/* SPDX-License-Identifier: MIT */
/* All discs of a scene as they are at one time, or as they grow, as one shape. */
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
void plot_discs_fill(Canvas *canvas, const Frame *frame, const tdsp_scene *scene, double time, const DiscsStyle *style);

/* The same as it grows over the timeline of the canvas. A radius is within a tenth of a point of the disc's, and exact where the disc grows at one rate. */
void plot_discs_grow(Canvas *canvas, const Frame *frame, const tdsp_scene *scene, const DiscsStyle *style);

#endif
