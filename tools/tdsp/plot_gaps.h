/* SPDX-License-Identifier: MIT */
/* The gaps that close at the jumps of a scene, drawn into its picture. */
#ifndef PLOT_GAPS_H
#define PLOT_GAPS_H

#include "plot_labels.h"
#include "scene_file.h"
#include "tdsp/shape.h"

/* The mark of a gap, open or closed, between discs in that direction (clockwise from the right). */
void plot_gap_mark(Canvas *canvas, double x, double y, double direction, gboolean closed);

/* Mark each gap that is known, and say when, as far as there is room, the largest jumps first: in a still picture the last departure that gets through, in
 * one that moves, from the moment on at which the gap closes, that moment. NULL: nothing. */
void plot_gaps(Canvas *canvas, const Frame *frame, const SceneFile *scene, const tdsp_jumps *jumps, Labels *labels);

#endif
