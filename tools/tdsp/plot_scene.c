/* SPDX-License-Identifier: MIT */
/*
 * The picture of a scene: discs at departure and at arrival, the path with times along it, and what is what. One that moves shows how the discs come from
 * the one to the other while the robot rides its path; where it ends, and rests, it is the still one.
 */
#include "plot_scene.h"

#include <math.h>
#include <string.h>

#include "cli.h"
#include "plot_clock.h"
#include "plot_discs.h"
#include "plot_frame.h"
#include "plot_gaps.h"
#include "plot_labels.h"
#include "plot_legend.h"
#include "plot_route.h"
#include "tdsp/growth.h"

#define LONG_SIDE 700.0 /* of the frame */
#define MARGIN_LEFT 92.0
#define MARGIN_RIGHT 28.0
#define MARGIN_TOP 66.0
#define MARGIN_BOTTOM 66.0 /* between the frame and the middle of the legend's first line */
#define LEAST_SHAPE 0.8 /* the shorter side of the frame over the longer one */
#define BELOW_LEGEND 24.0
#define REST 0.15        /* of the time that the journeys take: how long a moving picture rests at its end */
#define WIDEST_STEP 5e-10 /* a time between ticks as wide as one gets */
#define FAR 0.5         /* discs count for the view up to so many lengths of the journey away */

typedef struct Extent {
    double x_low, x_high, y_low, y_high;
} Extent;

static void extent_add(Extent *extent, tdsp_point at, double around)
{
    extent->x_low = fmin(extent->x_low, at.x - around);
    extent->x_high = fmax(extent->x_high, at.x + around);
    extent->y_low = fmin(extent->y_low, at.y - around);
    extent->y_high = fmax(extent->y_high, at.y + around);
}

static void extent_add_legs(Extent *extent, const GArray *legs)
{
    for (guint i = 0; i < legs->len; i++) {
        const tdsp_leg *leg = &g_array_index(legs, tdsp_leg, i);
        extent_add(extent, leg->from, 0);
        extent_add(extent, leg->to, 0);
        if (leg->kind != TDSP_LEG_LINE && leg->sweep > 0.5) extent_add(extent, leg->center, leg->radius_to);
    }
}

static double larger_side(const Extent *extent)
{
    return fmax(extent->x_high - extent->x_low, extent->y_high - extent->y_low);
}

/* Discs as far as `near` reaches, each no wider than the view it adds to. */
static void extent_add_discs(Extent *extent, const ScenePicture *picture, const Extent *near)
{
    double departure = picture->journeys[0].departure;
    size_t count;
    const tdsp_disc *discs = tdsp_scene_discs(picture->scene->scene, &count);
    for (size_t i = 0; i < count; i++) {
        double radius = discs[i].radius;
        (void)tdsp_scene_disc_at(picture->scene->scene, (uint32_t)i, departure, &radius, NULL);
        tdsp_point low = {fmax(discs[i].center.x - radius, near->x_low), fmax(discs[i].center.y - radius, near->y_low)};
        tdsp_point high = {fmin(discs[i].center.x + radius, near->x_high), fmin(discs[i].center.y + radius, near->y_high)};
        if (low.x > high.x || low.y > high.y) continue;
        extent_add(extent, low, 0);
        extent_add(extent, high, 0);
    }
}

static double first_disc_size(const tdsp_scene *scene)
{
    size_t count;
    const tdsp_disc *discs = tdsp_scene_discs(scene, &count);
    return count > 0 && discs[0].radius > 0 ? discs[0].radius : 1;
}

static Extent extent_of(const ScenePicture *picture)
{
    const tdsp_journey *journey = tdsp_scene_journey(picture->scene->scene);
    Extent extent = {INFINITY, -INFINITY, INFINITY, -INFINITY};
    extent_add(&extent, journey->source, 0);
    extent_add(&extent, journey->destination, 0);
    for (guint i = 0; i < picture->count; i++) extent_add_legs(&extent, picture->journeys[i].legs);
    double side = larger_side(&extent);
    if (!(side > 0)) side = first_disc_size(picture->scene->scene);
    Extent near = extent;
    extent_add(&near, journey->source, FAR * side);
    extent_add(&near, journey->destination, FAR * side);
    extent_add_discs(&extent, picture, &near);
    side = fmax(larger_side(&extent), side);
    double margin = 0.05 * side;
    return (Extent){extent.x_low - margin, extent.x_high + margin, extent.y_low - margin, extent.y_high + margin};
}

static void widen(double *low, double *high, double wanted)
{
    double more = fmax(0, wanted - (*high - *low)) / 2;
    *low -= more;
    *high += more;
}

/* A frame with one scale in both directions, and not too thin. */
static Frame frame_of(Extent extent)
{
    double side = larger_side(&extent);
    widen(&extent.x_low, &extent.x_high, LEAST_SHAPE * side);
    widen(&extent.y_low, &extent.y_high, LEAST_SHAPE * side);
    double scale = LONG_SIDE / side;
    return (Frame){MARGIN_LEFT,
                   MARGIN_TOP,
                   scale * (extent.x_high - extent.x_low),
                   scale * (extent.y_high - extent.y_low),
                   extent.x_low,
                   extent.x_high,
                   extent.y_low,
                   extent.y_high};
}

/* When the last robot is there; infinite when none gets there. */
static double last_arrival(const ScenePicture *picture)
{
    double last = -INFINITY;
    for (guint i = 0; i < picture->count; i++)
        if (isfinite(picture->journeys[i].arrival)) last = fmax(last, picture->journeys[i].arrival);
    return isfinite(last) ? last : INFINITY;
}

gboolean plot_scene_can_move(const ScenePicture *picture)
{
    double end = last_arrival(picture);
    return isfinite(end) && end > picture->journeys[0].departure;
}

static Timeline timeline_of(const ScenePicture *picture)
{
    return (Timeline){picture->journeys[0].departure, last_arrival(picture), picture->seconds, REST * picture->seconds};
}

/* The edge of the union at arrival is what a slightly larger union below it leaves to be seen. */
static void draw_discs(Canvas *canvas, const Frame *frame, const ScenePicture *picture)
{
    const DiscsStyle later[] = {{PLOT_DISC_OUTLINE, 1.2, 0.9}, {PLOT_DISC_LATER, 1.2, 0}}, now = {PLOT_DISC, 1.2, 0};
    const tdsp_scene *scene = picture->scene->scene;
    double end = last_arrival(picture);
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
    static const guint32 colours[] = {PLOT_PATH, PLOT_BESIDE}, tints[] = {PLOT_PATH_TINT, PLOT_BESIDE_TINT};
    guint count = 0;
    for (guint i = 0; i < picture->count; i++) {
        const GArray *legs = picture->journeys[i].legs;
        if (legs->len > 0) routes[count++] = (Route){(const tdsp_leg *)legs->data, legs->len, colours[i], tints[i]};
    }
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
    plot_gaps(canvas, frame, picture->jumps, picture->scene->time_unit, &labels);
    for (guint i = 0; i < count; i++) step = plot_route_times(canvas, frame, &routes[i], &labels);
    if (!canvas_timeline(canvas)) return step;
    canvas_layer_begin(canvas, LAYER_MOVING);
    for (guint i = count; i-- > 0;) plot_route_robot(canvas, frame, &routes[i]);
    canvas_layer_end(canvas);
    return step;
}

/* "leaves at 5 s, arrives at 25 s" */
static char *journey_text(const PictureJourney *journey, const char *unit)
{
    g_autofree char *departure = frame_with_unit(journey->departure, 7, unit);
    g_autofree char *arrival = frame_with_unit(journey->arrival, 7, unit);
    g_autofree char *reason = cli_reason(journey->status);
    if (isfinite(journey->arrival)) return g_strdup_printf("leaves at %s, arrives at %s", departure, arrival);
    return g_strdup_printf("leaves at %s, no path: %s", departure, reason);
}

static char *subtitle_of(const ScenePicture *picture)
{
    const char *time = picture->scene->time_unit, *length = picture->scene->length_unit;
    size_t count;
    tdsp_scene_discs(picture->scene->scene, &count);
    g_autofree char *speed = frame_with_unit(tdsp_scene_journey(picture->scene->scene)->speed, 5, length);
    g_autofree char *discs = g_strdup_printf("%" G_GSIZE_FORMAT " disc%s \xc2\xb7 robot's speed %s%s%s", count, count == 1 ? "" : "s", speed,
                                             *length && *time ? "/" : "", *length ? time : "");
    if (picture->count > 1) return g_steal_pointer(&discs); /* the legend tells when they leave and arrive */
    g_autofree char *journey = journey_text(&picture->journeys[0], time);
    return g_strdup_printf("%s \xc2\xb7 %s", journey, discs);
}

static void draw_titles(Canvas *canvas, const ScenePicture *picture)
{
    const TextStyle title = {18, TRUE, PLOT_INK, 0, 0, FALSE}, subtitle = {PLOT_TEXT, FALSE, PLOT_GREY, 0, 0, FALSE};
    const char *name = *picture->scene->name ? picture->scene->name : "Scene";
    double room = canvas_width(canvas) - MARGIN_LEFT - 10;
    g_autofree char *text = subtitle_of(picture);
    g_autofree char *first = journey_text(&picture->journeys[0], picture->scene->time_unit);
    g_autofree char *description = g_strdup_printf("%s: %s", name, first);
    canvas_describe(canvas, description);
    canvas_text_within(canvas, MARGIN_LEFT, 30, canvas_timeline(canvas) ? room - PLOT_CLOCK_WIDTH : room, &title, name);
    canvas_text_within(canvas, MARGIN_LEFT, 52, room, &subtitle, text);
    if (canvas_timeline(canvas)) plot_clock(canvas, canvas_width(canvas) - MARGIN_RIGHT, 30, picture->scene->time_unit);
}

static gboolean rides(const Route *route)
{
    for (gsize i = 0; i < route->count; i++)
        if (route->legs[i].kind != TDSP_LEG_LINE) return TRUE;
    return FALSE;
}

/* One path: what it is. Of two: which is which. */
static void legend_routes(Legend *legend, const ScenePicture *picture, double step)
{
    Route routes[PICTURE_JOURNEYS];
    guint count = routes_of(picture, routes), named = 0;
    const char *unit = picture->scene->time_unit;
    for (guint i = 0; i < picture->count && picture->count > 1; i++) {
        if (picture->journeys[i].legs->len == 0) continue;
        const Pen pen = plot_route_pen(&routes[named++]);
        g_autofree char *journey = journey_text(&picture->journeys[i], unit);
        legend_line(legend, &pen, journey);
    }
    g_autofree char *every = frame_with_unit(step, 7, unit);
    g_autofree char *path = step > 0 ? g_strdup_printf("path, a tick every %s", every) : g_strdup("path");
    const Pen first = count > 0 ? plot_route_pen(&routes[0]) : (Pen){0}, ridden = count > 0 ? plot_ridden_pen(&routes[0]) : (Pen){0};
    if (picture->count == 1 && count > 0) legend_line(legend, &first, path);
    if ((count > 0 && rides(&routes[0])) || (count > 1 && rides(&routes[1]))) legend_line(legend, &ridden, "ridden disc, as the ride begins");
}

/* Returns the middle of its last line. */
static double draw_legend(Canvas *canvas, const ScenePicture *picture, double y, double step)
{
    Legend legend = legend_new(canvas, MARGIN_LEFT, canvas_width(canvas) - 10, y);
    gboolean moves = picture->seconds > 0 && plot_scene_can_move(picture);
    size_t count;
    tdsp_scene_discs(picture->scene->scene, &count);
    if (count > 0) legend_disc(&legend, PLOT_DISC, PLOT_DISC, "discs at departure");
    if (count > 0 && isfinite(last_arrival(picture))) legend_disc(&legend, PLOT_DISC_LATER, PLOT_DISC_OUTLINE, moves ? "at the time shown" : "at arrival");
    legend_routes(&legend, picture, step);
    if (tdsp_jumps_count(picture->jumps) == 0) return legend.y;
    double x = legend_item(&legend, 12, "gap that closes, and the last departure through it");
    plot_gap_mark(canvas, x + 6, legend.y);
    return legend.y;
}

/* How far the legend reaches below its first line: it is drawn to be measured. */
static gboolean measure_legend(const ScenePicture *picture, double width, double *height, GError **error)
{
    g_autoptr(Canvas) paper = canvas_new("legend.svg", width, 1, NULL, error);
    if (!paper) return FALSE;
    *height = draw_legend(paper, picture, 0, WIDEST_STEP);
    return TRUE;
}

/* Metres become kilometres where there are many. */
static Axis axis_of(const char *name, const char *unit, double range)
{
    gboolean kilometres = strcmp(unit, "m") == 0 && range >= 5000;
    return (Axis){name, kilometres ? "km" : unit, kilometres ? 1000 : 1};
}

gboolean plot_scene(const ScenePicture *picture, const char *path, GError **error)
{
    Frame frame = frame_of(extent_of(picture));
    const char *unit = picture->scene->length_unit;
    Axis x = axis_of("x", unit, frame.x_high - frame.x_low), y = axis_of("y", unit, frame.x_high - frame.x_low);
    const Timeline timeline = timeline_of(picture);
    gboolean moves = picture->seconds > 0 && plot_scene_can_move(picture);
    double width = frame.width + MARGIN_LEFT + MARGIN_RIGHT, legend = MARGIN_TOP + frame.height + MARGIN_BOTTOM;
    double below;
    if (!measure_legend(picture, width, &below, error)) return FALSE;
    g_autoptr(Canvas) canvas = canvas_new(path, width, legend + below + BELOW_LEGEND, moves ? &timeline : NULL, error);
    if (!canvas) return FALSE;
    frame_draw_grid(canvas, &frame);
    frame_clip(canvas, &frame);
    draw_discs(canvas, &frame, picture);
    double step = draw_journeys(canvas, &frame, picture);
    canvas_unclip(canvas);
    frame_draw_axes(canvas, &frame, &x, &y);
    draw_titles(canvas, picture);
    draw_legend(canvas, picture, legend, step);
    return canvas_write(canvas, error);
}
