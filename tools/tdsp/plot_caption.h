/* SPDX-License-Identifier: MIT */
/* What the picture of a scene says in words: titles above the frame, and below it what is what. */
#ifndef PLOT_CAPTION_H
#define PLOT_CAPTION_H

#include "plot_frame.h"
#include "plot_scene.h"

/* The titles, and the clock of a picture that moves. */
void plot_caption_titles(Canvas *canvas, const Frame *frame, const ScenePicture *picture);

/* Begin the legend at the height `y`; `step` is the time between two ticks, 0 where there are none. Returns the middle of its last line. */
double plot_caption_legend(Canvas *canvas, const Frame *frame, const ScenePicture *picture, double y, double step);

/* How far the legend reaches below its first line on a canvas of this width. */
gboolean plot_caption_measure(const Frame *frame, const ScenePicture *picture, double width, double *height, GError **error);

#endif
