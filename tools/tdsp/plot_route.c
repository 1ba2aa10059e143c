/* SPDX-License-Identifier: MIT */
/* Paths: lines as lines, arcs and curves as polylines so fine that the spiral is exact to the eye. */
#include "plot_route.h"

#include <math.h>

#include "tdsp/path.h"

#define ARC_STEP 0.04  /* radians between the points of an arc, */
#define ARC_PIXELS 2.0 /* and points of the canvas */
#define MOST_STEPS 4000
#define OBSTACLE_EVERY 4.0 /* points of the canvas */
#define TICKS 9.0          /* about so many times along the path */
#define TICK_HALF 5.0
#define MARK_RADIUS 7.0

static tdsp_point on_canvas(const Frame *frame, tdsp_point at)
{
    return (tdsp_point){frame_x(frame, at.x), frame_y(frame, at.y)};
}

static double scale_of(const Frame *frame)
{
    return frame->width / (frame->x_high - frame->x_low);
}

static guint steps_of(const Frame *frame, const tdsp_leg *leg)
{
    if (leg->kind == TDSP_LEG_LINE) return 1;
    double length = fmax(leg->radius_from, leg->radius_to) * leg->sweep * scale_of(frame);
    return (guint)CLAMP(fmin(length / ARC_PIXELS, leg->sweep / ARC_STEP), 1, MOST_STEPS);
}

static double leg_time(const tdsp_leg *leg, double share)
{
    return leg->start_time + (leg->end_time - leg->start_time) * share;
}

static void trace(cairo_t *cr, const Frame *frame, const tdsp_leg *legs, gsize count)
{
    for (gsize i = 0; i < count; i++) {
        tdsp_point at = on_canvas(frame, legs[i].from);
        guint steps = steps_of(frame, &legs[i]);
        if (i == 0) cairo_move_to(cr, at.x, at.y);
        for (guint j = 1; j <= steps; j++) {
            at = on_canvas(frame, tdsp_leg_position(&legs[i], leg_time(&legs[i], (double)j / steps)));
            cairo_line_to(cr, at.x, at.y);
        }
    }
}

static void add_obstacles(const Frame *frame, const tdsp_leg *leg, Labels *labels)
{
    tdsp_point from = on_canvas(frame, leg->from), to = on_canvas(frame, leg->to);
    double length =
        leg->kind != TDSP_LEG_LINE ? leg->radius_to * leg->sweep * scale_of(frame) : hypot(to.x - from.x, to.y - from.y);
    guint steps = (guint)CLAMP(length / OBSTACLE_EVERY, 1, MOST_STEPS);
    for (guint i = 0; i <= steps; i++) {
        tdsp_point at = on_canvas(frame, tdsp_leg_position(leg, leg_time(leg, (double)i / steps)));
        labels_add_obstacle(labels, at.x, at.y);
    }
}

static void stroke(cairo_t *cr, double width, guint32 colour)
{
    cairo_set_line_join(cr, CAIRO_LINE_JOIN_ROUND);
    cairo_set_line_cap(cr, CAIRO_LINE_CAP_ROUND);
    cairo_set_line_width(cr, width);
    canvas_colour(cr, colour);
    cairo_stroke_preserve(cr);
}

void plot_route_draw(cairo_t *cr, const Frame *frame, const tdsp_leg *legs, gsize count, Labels *labels)
{
    trace(cr, frame, legs, count);
    stroke(cr, 5, PLOT_PAPER);
    stroke(cr, 2.4, PLOT_PATH);
    cairo_new_path(cr);
    cairo_set_line_cap(cr, CAIRO_LINE_CAP_BUTT);
    for (gsize i = 0; i < count; i++) add_obstacles(frame, &legs[i], labels);
}

/* A ride on a disc whose rate changes is many curves. */
static gboolean begins_ride(const tdsp_leg *legs, gsize i)
{
    if (legs[i].kind == TDSP_LEG_LINE) return FALSE;
    return i == 0 || legs[i - 1].kind == TDSP_LEG_LINE || legs[i - 1].disc != legs[i].disc || legs[i - 1].turn != legs[i].turn;
}

void plot_route_ridden(cairo_t *cr, const Frame *frame, const tdsp_leg *legs, gsize count)
{
    static const double dashes[] = {3, 3};
    for (gsize i = 0; i < count; i++) {
        if (!begins_ride(legs, i)) continue;
        tdsp_point center = on_canvas(frame, legs[i].center);
        double radius = legs[i].radius_from * scale_of(frame);
        cairo_new_sub_path(cr);
        cairo_arc(cr, center.x, center.y, radius, 0, 2 * G_PI);
    }
    cairo_set_dash(cr, dashes, G_N_ELEMENTS(dashes), 0);
    cairo_set_line_width(cr, 0.9);
    canvas_colour(cr, PLOT_PATH);
    cairo_stroke(cr);
    cairo_set_dash(cr, NULL, 0, 0);
}

/* The path's direction at `time`, as a unit vector on the canvas; (0, 0) where it stands still. */
static tdsp_point direction_at(const Frame *frame, const tdsp_leg *legs, gsize count, double time, double around)
{
    tdsp_point before, after;
    if (tdsp_path_position(legs, count, time - around, &before) != TDSP_OK ||
        tdsp_path_position(legs, count, time + around, &after) != TDSP_OK)
        return (tdsp_point){0, 0};
    before = on_canvas(frame, before);
    after = on_canvas(frame, after);
    double x = after.x - before.x, y = after.y - before.y, length = hypot(x, y);
    return length > 0 ? (tdsp_point){x / length, y / length} : (tdsp_point){0, 0};
}

static void draw_tick(cairo_t *cr, tdsp_point at, tdsp_point direction)
{
    cairo_move_to(cr, at.x - direction.y * TICK_HALF, at.y + direction.x * TICK_HALF);
    cairo_line_to(cr, at.x + direction.y * TICK_HALF, at.y - direction.x * TICK_HALF);
    cairo_set_line_width(cr, 1.6);
    canvas_colour(cr, PLOT_INK);
    cairo_stroke(cr);
}

/* Across the path, and of the two sides the right one, or the upper one of a level path. */
static double beside(tdsp_point direction)
{
    double side = fabs(direction.y) > 0.2 ? direction.y : -direction.x;
    return side > 0 ? atan2(-direction.x, direction.y) : atan2(direction.x, -direction.y);
}

/* A tick there would hide the mark of the source or the destination. */
static gboolean near(tdsp_point tick, tdsp_point mark)
{
    return hypot(tick.x - mark.x, tick.y - mark.y) < MARK_RADIUS + TICK_HALF;
}

double plot_route_times(cairo_t *cr, const Frame *frame, const tdsp_leg *legs, gsize count, Labels *labels)
{
    const TextStyle style = {11, FALSE, PLOT_INK, 0, 0, TRUE};
    double start = legs[0].start_time, duration = legs[count - 1].end_time - start;
    if (!(duration > 0)) return 0;
    double step = frame_nice_step(duration, TICKS);
    tdsp_point first = on_canvas(frame, legs[0].from), last = on_canvas(frame, legs[count - 1].to);
    for (double i = floor(start / step) + 1; i * step < start + duration * (1 - 1e-6); i++) {
        tdsp_point place;
        if (tdsp_path_position(legs, count, i * step, &place) != TDSP_OK) continue;
        tdsp_point at = on_canvas(frame, place);
        if (near(at, first) || near(at, last)) continue;
        g_autofree char *number = frame_number(i * step);
        tdsp_point direction = direction_at(frame, legs, count, i * step, duration * 1e-4);
        draw_tick(cr, at, direction);
        labels_write(labels, cr, at.x, at.y, 7, beside(direction), &style, number);
    }
    return step;
}
