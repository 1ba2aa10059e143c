/* SPDX-License-Identifier: MIT */
/* A path on the canvas: its legs, marks of the time along it, and the robot that rides it. */
#ifndef PLOT_ROUTE_H
#define PLOT_ROUTE_H

#include "plot_frame.h"
#include "plot_labels.h"

typedef struct Route {
    const tdsp_leg *legs;
    gsize count;          /* at least 1 where it is drawn */
    guint32 colour, tint; /* the tint shows where the robot has yet to go */
} Route;

/* What is still drawn with. */
Pen plot_route_pen(const Route *route);
/* What the circles of ridden discs are drawn with. */
Pen plot_ridden_pen(const Route *route);

/* Draw the legs; where the picture moves, as the robot goes along. What is drawn becomes an obstacle for labels. */
void plot_route_draw(Canvas *canvas, const Frame *frame, const Route *route, Labels *labels);

/* A tick and its time wherever a round time comes; returns the step. */
double plot_route_times(Canvas *canvas, const Frame *frame, const Route *route, Labels *labels);

/* The circles of the discs that are ridden, as large as they are when the ride begins. */
void plot_route_ridden(Canvas *canvas, const Frame *frame, const Route *route);

/* The robot, going along the path. On a moving canvas only. */
void plot_route_robot(Canvas *canvas, const Frame *frame, const Route *route);

#endif
