/* SPDX-License-Identifier: MIT */
/*
 * The picture of a scene: discs at departure and at arrival, the path with times along it, and what is what. One that moves shows how the discs come from
 * the one to the other while the robot rides its path; where it ends, and rests, it is the still one.
 */
#include "plot_scene.h"

#include <math.h>
#include <string.h>

#include "plot_caption.h"
#include "plot_discs.h"
#include "plot_extent.h"
#include "plot_frame.h"
#include "plot_gaps.h"
#include "plot_labels.h"

#define MARGIN_LEFT 92.0
#define MARGIN_RIGHT 28.0
#define MARGIN_TOP 66.0
#define MARGIN_BOTTOM 66.0 /* between the frame and the middle of the legend's first line */
#define BELOW_LEGEND 24.0
#define REST 0.15 /* of the time that the journeys take: how long a moving picture rests at its end */

double plot_scene_end(const ScenePicture *picture)
{
    double last = -INFINITY;
    for (guint i = 0; i < picture->count; i++)
        if (isfinite(picture->journeys[i].arrival)) last = fmax(last, picture->journeys[i].arrival);
    return isfinite(last) ? last : INFINITY;
}

gboolean plot_scene_moves(const ScenePicture *picture)
{
    double end = plot_scene_end(picture);
    return picture->seconds > 0 && isfinite(end) && end > picture->journeys[0].departure;
}

Route plot_scene_route(const ScenePicture *picture, guint journey)
{
    static const guint32 colours[] = {PLOT_PATH, PLOT_BESIDE}, tints[] = {PLOT_PATH_TINT, PLOT_BESIDE_TINT};
    const GArray *legs = picture->journeys[journey].legs;
    return (Route){(const tdsp_leg *)legs->data, legs->len, colours[journey], tints[journey]};
}

static Timeline timeline_of(const ScenePicture *picture)
{
    return (Timeline){picture->journeys[0].departure, plot_scene_end(picture), picture->seconds, REST * picture->seconds};
}

/* The edge of the union at arrival is what a slightly larger union below it leaves to be seen. */
static void draw_discs(Canvas *canvas, const Frame *frame, const ScenePicture *picture)
{
    const DiscsStyle later[] = {{PLOT_DISC_OUTLINE, 1.2, 0.9}, {PLOT_DISC_LATER, 1.2, 0}}, now = {PLOT_DISC, 1.2, 0};
    const tdsp_scene *scene = picture->scene->scene;
    double end = plot_scene_end(picture);
    canvas_layer_begin(canvas, LAYER_STILL);
    for (gsize i = 0; i < G_N_ELEMENTS(later) && isfinite(end); i++) plot_discs_fill(canvas, frame, scene, end, &later[i]);
    canvas_layer_end(canvas);
    if (canvas_timeline(canvas)) {
        canvas_layer_begin(canvas, LAYER_MOVING);
        for (gsize i = 0; i < G_N_ELEMENTS(later); i++) plot_discs_grow(canvas, frame, scene, &later[i]);
        canvas_layer_end(canvas);
    }
    plot_discs_fill(canvas, frame, scene, picture->journeys[0].departure, &now);
}

static void draw_end(Canvas *canvas, double x, double y, gboolean filled)
{
    const Pen pen = {filled ? PLOT_PAPER : PLOT_PATH, filled ? 1.5 : 3, FALSE, 0, 0};
    canvas_circle(canvas, x, y, 6.5);
    canvas_fill_and_stroke(canvas, filled ? PLOT_PATH : PLOT_PAPER, &pen);
}

static void label_ends(Canvas *canvas, const Frame *frame, const tdsp_journey *journey, Labels *labels)
{
    const TextStyle style = {PLOT_TEXT, TRUE, PLOT_PATH, 0, 0, TRUE};
    double sx = frame_x(frame, journey->source.x), sy = frame_y(frame, journey->source.y);
    double dx = frame_x(frame, journey->destination.x), dy = frame_y(frame, journey->destination.y);
    draw_end(canvas, sx, sy, TRUE);
    draw_end(canvas, dx, dy, FALSE);
    labels_add_mark(labels, sx, sy, 8);
    labels_add_mark(labels, dx, dy, 8);
    labels_write(labels, canvas, sx, sy, 11, 0, &style, "source");
    labels_write(labels, canvas, dx, dy, 11, 0, &style, "destination");
}

/* The routes of the journeys that have one; returns their number. */
static guint routes_of(const ScenePicture *picture, Route *routes)
{
    guint count = 0;
    for (guint i = 0; i < picture->count; i++)
        if (picture->journeys[i].legs->len > 0) routes[count++] = plot_scene_route(picture, i);
    return count;
}

/* Returns the time between two ticks of the last path; 0 without one. The first path, which the picture is about, lies on top. */
static double draw_journeys(Canvas *canvas, const Frame *frame, const ScenePicture *picture)
{
    g_auto(Labels) labels = labels_new(frame);
    Route routes[PICTURE_JOURNEYS];
    guint count = routes_of(picture, routes);
    double step = 0;
    for (guint i = count; i-- > 0;) plot_route_ridden(canvas, frame, &routes[i]);
    for (guint i = count; i-- > 0;) plot_route_draw(canvas, frame, &routes[i], &labels);
    label_ends(canvas, frame, tdsp_scene_journey(picture->scene->scene), &labels);
    plot_gaps(canvas, frame, picture->scene, picture->jumps, &labels);
    for (guint i = 0; i < count; i++) step = plot_route_times(canvas, frame, &routes[i], &labels);
    if (!canvas_timeline(canvas)) return step;
    canvas_layer_begin(canvas, LAYER_MOVING);
    for (guint i = count; i-- > 0;) plot_route_robot(canvas, frame, &routes[i]);
    canvas_layer_end(canvas);
    return step;
}

/* Metres become kilometres where there are many. */
static Axis axis_of(const char *name, const char *unit, double range)
{
    gboolean kilometres = strcmp(unit, "m") == 0 && range >= 5000;
    return (Axis){name, kilometres ? "km" : unit, kilometres ? 1000 : 1};
}

gboolean plot_scene(const ScenePicture *picture, const char *path, GError **error)
{
    const Frame frame = plot_extent_frame(picture, MARGIN_LEFT, MARGIN_TOP);
    const char *unit = picture->scene->length_unit;
    const Axis x = axis_of("x", unit, frame.x_high - frame.x_low), y = axis_of("y", unit, frame.x_high - frame.x_low);
    const Timeline timeline = timeline_of(picture);
    double width = frame.width + MARGIN_LEFT + MARGIN_RIGHT, legend = MARGIN_TOP + frame.height + MARGIN_BOTTOM, below;
    if (!plot_caption_measure(&frame, picture, width, &below, error)) return FALSE;
    g_autoptr(Canvas) canvas = canvas_new(path, width, legend + below + BELOW_LEGEND, plot_scene_moves(picture) ? &timeline : NULL, error);
    if (!canvas) return FALSE;
    frame_draw_grid(canvas, &frame, &x);
    frame_clip(canvas, &frame);
    draw_discs(canvas, &frame, picture);
    double step = draw_journeys(canvas, &frame, picture);
    canvas_unclip(canvas);
    frame_draw_axes(canvas, &frame, &x, &y);
    plot_caption_titles(canvas, &frame, picture);
    plot_caption_legend(canvas, &frame, picture, legend, step);
    return canvas_write(canvas, error);
}
