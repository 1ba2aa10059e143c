/* SPDX-License-Identifier: MIT */
/*
 * Paths: lines as lines, arcs and curves as Bézier curves that are nowhere farther than EXACT from them.
 *
 * The robot keeps its top speed on every leg, so the length that it has gone grows evenly with time. What moves along the drawn path
 * evenly is therefore where the robot is, at every moment, up to what the curves differ in length.
 */
#include "plot_route.h"

#include <math.h>

#include "tdsp/path.h"

#define EXACT 0.01 /* points of the canvas */
#define PIECE_SWEEP 0.6 /* radians of a ride that one curve may cover */
#define MOST_PIECES 4096
#define OBSTACLE_EVERY 4.0 /* points of the canvas */
#define MOST_OBSTACLES 4000
#define TICKS 9.0          /* about so many times along the path */
#define TICK_HALF 5.0
#define MARK_RADIUS 7.0
#define ROBOT_RADIUS 6.0

static tdsp_point on_canvas(const Frame *frame, tdsp_point at)
{
    return (tdsp_point){frame_x(frame, at.x), frame_y(frame, at.y)};
}

static double scale_of(const Frame *frame)
{
    return frame->width / (frame->x_high - frame->x_low);
}

/* Where the robot is at a share of a leg's duration. */
static tdsp_point leg_point(const Frame *frame, const tdsp_leg *leg, double share)
{
    return on_canvas(frame, tdsp_leg_position(leg, leg->start_time + (leg->end_time - leg->start_time) * share));
}

/* --------------------------------------------------------------------------------------------------------------- rides */

typedef struct Curve {
    tdsp_point at[4]; /* ends and control points */
} Curve;

static tdsp_point combined(const tdsp_point at[4], const double weights[4])
{
    tdsp_point sum = {0, 0};
    for (int i = 0; i < 4; i++) {
        sum.x += weights[i] * at[i].x;
        sum.y += weights[i] * at[i].y;
    }
    return sum;
}

/* The cubic through the leg at the shares `from` and `to` and at the two thirds between. */
static Curve curve_through(const Frame *frame, const tdsp_leg *leg, double from, double to)
{
    static const double first[] = {-5.0 / 6, 3, -1.5, 1.0 / 3}, second[] = {1.0 / 3, -1.5, 3, -5.0 / 6};
    tdsp_point at[4];
    for (int i = 0; i < 4; i++) at[i] = leg_point(frame, leg, from + (to - from) * i / 3);
    return (Curve){{at[0], combined(at, first), combined(at, second), at[3]}};
}

static tdsp_point curve_point(const Curve *curve, double share)
{
    double rest = 1 - share;
    const double weights[] = {rest * rest * rest, 3 * rest * rest * share, 3 * rest * share * share, share * share * share};
    return combined(curve->at, weights);
}

/* How far the curve is from the leg, half-way between where they meet: there the difference, of the fourth order, is largest. */
static double curve_error(const Frame *frame, const tdsp_leg *leg, double from, double to)
{
    const Curve curve = curve_through(frame, leg, from, to);
    double error = 0;
    for (int i = 1; i < 6; i += 2) {
        tdsp_point one = curve_point(&curve, i / 6.0), other = leg_point(frame, leg, from + (to - from) * i / 6);
        error = fmax(error, hypot(one.x - other.x, one.y - other.y));
    }
    return error;
}

static gboolean fine_enough(const Frame *frame, const tdsp_leg *leg, guint pieces)
{
    for (guint i = 0; i < pieces; i++)
        if (curve_error(frame, leg, (double)i / pieces, (double)(i + 1) / pieces) > EXACT) return FALSE;
    return TRUE;
}

static guint pieces_of(const Frame *frame, const tdsp_leg *leg)
{
    guint pieces = (guint)CLAMP(ceil(leg->sweep / PIECE_SWEEP), 1, MOST_PIECES);
    while (pieces < MOST_PIECES && !fine_enough(frame, leg, pieces)) pieces *= 2;
    return pieces;
}

static void trace_ride(Canvas *canvas, const Frame *frame, const tdsp_leg *leg)
{
    guint pieces = pieces_of(frame, leg);
    for (guint i = 0; i < pieces; i++) {
        const Curve curve = curve_through(frame, leg, (double)i / pieces, (double)(i + 1) / pieces);
        canvas_curve_to(canvas, curve.at[1], curve.at[2], curve.at[3]);
    }
}

static void trace(Canvas *canvas, const Frame *frame, const Route *route)
{
    tdsp_point begin = on_canvas(frame, route->legs[0].from);
    canvas_move_to(canvas, begin.x, begin.y);
    for (gsize i = 0; i < route->count; i++) {
        const tdsp_leg *leg = &route->legs[i];
        tdsp_point to = on_canvas(frame, leg->to);
        if (leg->kind == TDSP_LEG_LINE)
            canvas_line_to(canvas, to.x, to.y);
        else
            trace_ride(canvas, frame, leg);
    }
}

/* ------------------------------------------------------------------------------------------------------------ the path */

static void add_obstacles(const Frame *frame, const tdsp_leg *leg, Labels *labels)
{
    tdsp_point from = on_canvas(frame, leg->from), to = on_canvas(frame, leg->to);
    double length =
        leg->kind != TDSP_LEG_LINE ? leg->radius_to * leg->sweep * scale_of(frame) : hypot(to.x - from.x, to.y - from.y);
    guint steps = (guint)CLAMP(length / OBSTACLE_EVERY, 1, MOST_OBSTACLES);
    for (guint i = 0; i <= steps; i++) {
        tdsp_point at = leg_point(frame, leg, (double)i / steps);
        labels_add_obstacle(labels, at.x, at.y);
    }
}

Pen plot_route_pen(const Route *route)
{
    return (Pen){route->colour, 2.4, TRUE, 0, 0};
}

static double begins(const Route *route)
{
    return route->legs[0].start_time;
}

static double ends(const Route *route)
{
    return route->legs[route->count - 1].end_time;
}

static void stroke(Canvas *canvas, const Frame *frame, const Route *route, const Pen *pen)
{
    trace(canvas, frame, route);
    canvas_stroke(canvas, pen);
}

/* All of the path faintly, and in its colour what the robot has gone. The end of a round pen would be seen before that. */
static void draw_moving(Canvas *canvas, const Frame *frame, const Route *route)
{
    const Key drawn[] = {{begins(route), 0}, {ends(route), 1}};
    const Pen tint = {route->tint, 2.4, TRUE, 0, 0}, gone = {route->colour, 2.4, FALSE, 0, 0};
    canvas_layer_begin(canvas, LAYER_MOVING);
    stroke(canvas, frame, route, &tint);
    canvas_animate(canvas, PROPERTY_DRAWN, drawn, G_N_ELEMENTS(drawn));
    stroke(canvas, frame, route, &gone);
    canvas_layer_end(canvas);
}

void plot_route_draw(Canvas *canvas, const Frame *frame, const Route *route, Labels *labels)
{
    const Pen halo = {PLOT_PAPER, 5, TRUE, 0, 0}, pen = plot_route_pen(route);
    stroke(canvas, frame, route, &halo);
    canvas_layer_begin(canvas, LAYER_STILL);
    stroke(canvas, frame, route, &pen);
    canvas_layer_end(canvas);
    if (canvas_timeline(canvas)) draw_moving(canvas, frame, route);
    for (gsize i = 0; i < route->count; i++) add_obstacles(frame, &route->legs[i], labels);
}

void plot_route_robot(Canvas *canvas, const Frame *frame, const Route *route)
{
    const Pen ring = {PLOT_PAPER, 2, FALSE, 0, 0};
    trace(canvas, frame, route);
    canvas_ride_begin(canvas, begins(route), ends(route));
    canvas_circle(canvas, 0, 0, ROBOT_RADIUS + 2.5);
    canvas_fill(canvas, route->colour);
    canvas_circle(canvas, 0, 0, ROBOT_RADIUS);
    canvas_fill_and_stroke(canvas, route->colour, &ring);
    canvas_ride_end(canvas);
}

/* A ride on a disc whose rate changes is many curves. */
static gboolean begins_ride(const tdsp_leg *legs, gsize i)
{
    if (legs[i].kind == TDSP_LEG_LINE) return FALSE;
    return i == 0 || legs[i - 1].kind == TDSP_LEG_LINE || legs[i - 1].disc != legs[i].disc || legs[i - 1].turn != legs[i].turn;
}

Pen plot_ridden_pen(const Route *route)
{
    return (Pen){route->colour, 0.9, FALSE, 3, 3};
}

void plot_route_ridden(Canvas *canvas, const Frame *frame, const Route *route)
{
    const Pen pen = plot_ridden_pen(route);
    for (gsize i = 0; i < route->count; i++) {
        if (!begins_ride(route->legs, i)) continue;
        tdsp_point center = on_canvas(frame, route->legs[i].center);
        canvas_circle(canvas, center.x, center.y, route->legs[i].radius_from * scale_of(frame));
    }
    canvas_stroke(canvas, &pen);
}

/* ------------------------------------------------------------------------------------------------------ times along it */

/* The path's direction at `time`, as a unit vector on the canvas; (0, 0) where it stands still. */
static tdsp_point direction_at(const Frame *frame, const Route *route, double time, double around)
{
    tdsp_point before, after;
    if (tdsp_path_position(route->legs, route->count, time - around, &before) != TDSP_OK ||
        tdsp_path_position(route->legs, route->count, time + around, &after) != TDSP_OK)
        return (tdsp_point){0, 0};
    before = on_canvas(frame, before);
    after = on_canvas(frame, after);
    double x = after.x - before.x, y = after.y - before.y, length = hypot(x, y);
    return length > 0 ? (tdsp_point){x / length, y / length} : (tdsp_point){0, 0};
}

static void trace_tick(Canvas *canvas, tdsp_point at, tdsp_point direction)
{
    canvas_move_to(canvas, at.x - direction.y * TICK_HALF, at.y + direction.x * TICK_HALF);
    canvas_line_to(canvas, at.x + direction.y * TICK_HALF, at.y - direction.x * TICK_HALF);
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

double plot_route_times(Canvas *canvas, const Frame *frame, const Route *route, Labels *labels)
{
    const TextStyle style = {11.5, FALSE, PLOT_INK, 0, 0, TRUE};
    double start = begins(route), duration = ends(route) - start;
    if (!(duration > 0)) return 0;
    double step = frame_nice_step(duration, TICKS);
    tdsp_point first = on_canvas(frame, route->legs[0].from), last = on_canvas(frame, route->legs[route->count - 1].to);
    const Ticks ticks = frame_ticks(start, start + duration, step);
    for (guint i = 0; i < ticks.count; i++) {
        double time = frame_tick(&ticks, i);
        tdsp_point place;
        if (time <= start || time >= start + duration * (1 - 1e-6)) continue;
        if (tdsp_path_position(route->legs, route->count, time, &place) != TDSP_OK) continue;
        tdsp_point at = on_canvas(frame, place);
        if (near(at, first) || near(at, last)) continue;
        g_autofree char *number = frame_number(time);
        tdsp_point direction = direction_at(frame, route, time, duration * 1e-4);
        trace_tick(canvas, at, direction);
        canvas_stroke(canvas, &(Pen){PLOT_INK, 1.6, FALSE, 0, 0});
        labels_write(labels, canvas, at.x, at.y, 7, beside(direction), &style, number);
    }
    return step;
}
