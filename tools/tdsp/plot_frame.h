/* SPDX-License-Identifier: MIT */
/* A rectangle of the canvas that shows a rectangle of the world, with axes around it. */
#ifndef PLOT_FRAME_H
#define PLOT_FRAME_H

#include "plot_canvas.h"
#include "tdsp/types.h"

typedef struct Frame {
    double left, top, width, height;     /* on the canvas */
    double x_low, x_high, y_low, y_high; /* in the world; y grows upwards */
} Frame;

double frame_x(const Frame *frame, double x);
double frame_y(const Frame *frame, double y);

/* 1, 2 or 5 times a power of ten: the step that divides `range` into about `pieces`. */
double frame_nice_step(double range, double pieces);

/* The multiples of a step in a range. */
typedef struct Ticks {
    double step, first; /* the first one as a multiple */
    guint count;
} Ticks;

Ticks frame_ticks(double low, double high, double step);
double frame_tick(const Ticks *ticks, guint i);

/* A number without noise in its last digits, with a true minus sign. Free with g_free(). */
char *frame_number(double value);

/* So many digits and the unit, where there is one. Free with g_free(). */
char *frame_with_unit(double value, int digits, const char *unit);

/* An axis: what it shows, and by what its numbers are divided (1000 for km of m). */
typedef struct Axis {
    const char *name;
    const char *unit; /* "" for none */
    double divisor;
} Axis;

/* "name (unit)". Free with g_free(). */
char *frame_axis_title(const Axis *axis);

/* Lines at the ticks, to lie under everything. */
void frame_draw_grid(Canvas *canvas, const Frame *frame, const Axis *x);
/* The border, the ticks' numbers and the axes' titles. */
void frame_draw_axes(Canvas *canvas, const Frame *frame, const Axis *x, const Axis *y);
/* Keep what is drawn next inside, until canvas_unclip(). */
void frame_clip(Canvas *canvas, const Frame *frame);

#endif
