/* All discs of a scene as they are at one time, as one shape. */
#ifndef PLOT_DISCS_H
#define PLOT_DISCS_H

#include "plot_frame.h"
#include "tdsp/scene.h"

/* Fill the union of the discs at `time`, each `wider` points of the canvas larger than it is. */
void plot_discs_fill(cairo_t *cr, const Frame *frame, const tdsp_scene *scene, double time, double wider, guint32 colour);

#endif
