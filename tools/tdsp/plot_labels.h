/* SPDX-License-Identifier: MIT */
/* Labels that avoid each other, what they would hide, and the edge of the picture. */
#ifndef PLOT_LABELS_H
#define PLOT_LABELS_H

#include "plot_frame.h"

typedef struct Labels {
    const Frame *frame;
    GArray *boxes;     /* of Box: labels and marks that exist */
    GArray *obstacles; /* of tdsp_point on the canvas: better not hidden */
} Labels;

Labels labels_new(const Frame *frame);
void labels_clear(Labels *labels);
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC(Labels, labels_clear)

/* Something at (x, y) that labels may not cover. */
void labels_add_mark(Labels *labels, double x, double y, double radius);
/* The same as a rectangle. */
void labels_add_box(Labels *labels, double left, double top, double right, double bottom);
/* A point of a line that labels should not cover. */
void labels_add_obstacle(Labels *labels, double x, double y);

/* Write `text` beside (x, y), at about `distance`, where it hides least; of equal places the one nearest to the direction `angle`
 * (clockwise from the right). FALSE when there is no room: nothing is written. */
gboolean labels_write(Labels *labels, Canvas *canvas, double x, double y, double distance, double angle, const TextStyle *style,
                      const char *text);

/* Write `text` beside the line from (x, top) to (x, bottom), best right of its middle, where it hides nothing at all. FALSE when there
 * is no such place: nothing is written. */
gboolean labels_write_beside(Labels *labels, Canvas *canvas, double x, double top, double bottom, double distance, const TextStyle *style,
                             const char *text);

#endif
