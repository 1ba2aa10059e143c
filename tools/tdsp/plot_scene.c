/* SPDX-License-Identifier: MIT */
/* The picture of a scene: discs at departure and at arrival, the path with times along it, and what is what. */
#include "plot_scene.h"

#include <math.h>
#include <string.h>

#include "cli.h"
#include "plot_discs.h"
#include "plot_frame.h"
#include "plot_gaps.h"
#include "plot_labels.h"
#include "plot_route.h"
#include "tdsp/growth.h"

#define LONG_SIDE 860.0 /* of the frame */
#define MARGIN_LEFT 92.0
#define MARGIN_RIGHT 28.0
#define MARGIN_TOP 66.0
#define MARGIN_BOTTOM 110.0
#define LEAST_SHAPE 0.8 /* the shorter side of the frame over the longer one */
#define FAR 1.5         /* discs count for the view up to so many lengths of the journey away */

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
    size_t count;
    const tdsp_disc *discs = tdsp_scene_discs(picture->scene->scene, &count);
    for (size_t i = 0; i < count; i++) {
        double radius = discs[i].radius;
        (void)tdsp_scene_disc_at(picture->scene->scene, (uint32_t)i, picture->departure, &radius, NULL);
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
    extent_add_legs(&extent, picture->legs);
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

/* The edge of the union at arrival is what a slightly larger union below it leaves to be seen. */
static void draw_discs(cairo_t *cr, const Frame *frame, const ScenePicture *picture)
{
    const DiscsStyle outline = {PLOT_DISC_OUTLINE, 1.2, 0.9}, later = {PLOT_DISC_LATER, 1.2, 0}, now = {PLOT_DISC, 1.2, 0};
    const tdsp_scene *scene = picture->scene->scene;
    if (isfinite(picture->arrival)) {
        plot_discs_fill(cr, frame, scene, picture->arrival, &outline);
        plot_discs_fill(cr, frame, scene, picture->arrival, &later);
    }
    plot_discs_fill(cr, frame, scene, picture->departure, &now);
}

static void draw_end(cairo_t *cr, double x, double y, gboolean filled)
{
    cairo_arc(cr, x, y, 6.5, 0, 2 * G_PI);
    canvas_colour(cr, filled ? PLOT_PATH : PLOT_PAPER);
    cairo_fill_preserve(cr);
    canvas_colour(cr, filled ? PLOT_PAPER : PLOT_PATH);
    cairo_set_line_width(cr, filled ? 1.5 : 3);
    cairo_stroke(cr);
}

static void label_ends(cairo_t *cr, const Frame *frame, const tdsp_journey *journey, Labels *labels)
{
    const TextStyle style = {PLOT_TEXT, TRUE, PLOT_PATH, 0, 0, TRUE};
    double sx = frame_x(frame, journey->source.x), sy = frame_y(frame, journey->source.y);
    double dx = frame_x(frame, journey->destination.x), dy = frame_y(frame, journey->destination.y);
    draw_end(cr, sx, sy, TRUE);
    draw_end(cr, dx, dy, FALSE);
    labels_add_mark(labels, sx, sy, 8);
    labels_add_mark(labels, dx, dy, 8);
    labels_write(labels, cr, sx, sy, 11, 0, &style, "source");
    labels_write(labels, cr, dx, dy, 11, 0, &style, "destination");
}

static double draw_journey(cairo_t *cr, const Frame *frame, const ScenePicture *picture)
{
    g_auto(Labels) labels = labels_new(frame);
    const tdsp_leg *legs = (const tdsp_leg *)picture->legs->data;
    gsize count = picture->legs->len;
    double step = 0;
    if (count > 0) {
        plot_route_ridden(cr, frame, legs, count);
        plot_route_draw(cr, frame, legs, count, &labels);
    }
    label_ends(cr, frame, tdsp_scene_journey(picture->scene->scene), &labels);
    plot_gaps(cr, frame, picture->jumps, picture->scene->time_unit, &labels);
    if (count > 0) step = plot_route_times(cr, frame, legs, count, &labels);
    return step;
}

static char *with_unit(double value, int digits, const char *unit)
{
    char format[8];
    g_snprintf(format, sizeof format, "%%.%dg", digits);
    char buffer[64];
    g_ascii_formatd(buffer, sizeof buffer, format, value);
    return *unit ? g_strdup_printf("%s %s", buffer, unit) : g_strdup(buffer);
}

static char *subtitle_of(const ScenePicture *picture)
{
    const tdsp_journey *journey = tdsp_scene_journey(picture->scene->scene);
    const char *time = picture->scene->time_unit, *length = picture->scene->length_unit;
    size_t count;
    tdsp_scene_discs(picture->scene->scene, &count);
    g_autofree char *departure = with_unit(picture->departure, 7, time);
    g_autofree char *arrival = with_unit(picture->arrival, 7, time);
    g_autofree char *speed = with_unit(journey->speed, 5, length);
    g_autofree char *reason = cli_reason(picture->status);
    g_autofree char *answer =
        isfinite(picture->arrival) ? g_strdup_printf("arrives at %s", arrival) : g_strdup_printf("no path: %s", reason);
    return g_strdup_printf("leaves at %s, %s \xc2\xb7 %" G_GSIZE_FORMAT " disc%s \xc2\xb7 robot's speed %s%s%s", departure,
                           answer, count, count == 1 ? "" : "s", speed, *length && *time ? "/" : "", *length ? time : "");
}

static void draw_titles(const Canvas *canvas, const ScenePicture *picture)
{
    const TextStyle title = {18, TRUE, PLOT_INK, 0, 0, FALSE}, subtitle = {PLOT_TEXT, FALSE, PLOT_GREY, 0, 0, FALSE};
    g_autofree char *text = subtitle_of(picture);
    const char *name = *picture->scene->name ? picture->scene->name : "Scene";
    canvas_text_within(canvas->cr, MARGIN_LEFT, 30, canvas->width - MARGIN_LEFT - 10, &title, name);
    canvas_text_within(canvas->cr, MARGIN_LEFT, 52, canvas->width - MARGIN_LEFT - 10, &subtitle, text);
}

/* A legend being written: items from left to right, in lines. */
typedef struct Legend {
    cairo_t *cr;
    double x, y, right;
} Legend;

/* Make room for a sample of this width with its text; returns where the sample begins. */
static double legend_item(Legend *legend, double sample, const char *text)
{
    const TextStyle style = {PLOT_TEXT, FALSE, PLOT_INK, 0, 0.5, FALSE};
    double width = sample + 7 + canvas_text_width(legend->cr, &style, text);
    if (legend->x > MARGIN_LEFT && legend->x + width > legend->right) {
        legend->x = MARGIN_LEFT;
        legend->y += 22;
    }
    double left = legend->x;
    canvas_text(legend->cr, left + sample + 7, legend->y, &style, text);
    legend->x += width + 22;
    return left;
}

static void legend_disc(Legend *legend, guint32 fill, guint32 edge, const char *text)
{
    double x = legend_item(legend, 14, text);
    cairo_arc(legend->cr, x + 7, legend->y, 6.5, 0, 2 * G_PI);
    canvas_colour(legend->cr, fill);
    cairo_fill_preserve(legend->cr);
    canvas_colour(legend->cr, edge);
    cairo_set_line_width(legend->cr, 1);
    cairo_stroke(legend->cr);
}

static void legend_line(Legend *legend, gboolean ridden, const char *text)
{
    static const double dashes[] = {3, 3};
    double x = legend_item(legend, 24, text);
    cairo_move_to(legend->cr, x, legend->y);
    cairo_line_to(legend->cr, x + 24, legend->y);
    if (ridden) cairo_set_dash(legend->cr, dashes, G_N_ELEMENTS(dashes), 0);
    canvas_colour(legend->cr, PLOT_PATH);
    cairo_set_line_width(legend->cr, ridden ? 0.9 : 2.4);
    cairo_stroke(legend->cr);
    cairo_set_dash(legend->cr, NULL, 0, 0);
}

static void legend_gap(Legend *legend)
{
    double x = legend_item(legend, 12, "gap that closes, and the last departure through it");
    plot_gap_mark(legend->cr, x + 6, legend->y);
}

static gboolean rides(const GArray *legs)
{
    for (guint i = 0; i < legs->len; i++)
        if (g_array_index(legs, tdsp_leg, i).kind != TDSP_LEG_LINE) return TRUE;
    return FALSE;
}

static void draw_legend(const Canvas *canvas, const ScenePicture *picture, double step)
{
    Legend legend = {canvas->cr, MARGIN_LEFT, canvas->height - 44, canvas->width - 10};
    g_autofree char *every = with_unit(step, 7, picture->scene->time_unit);
    g_autofree char *path = step > 0 ? g_strdup_printf("path, a tick every %s", every) : g_strdup("path");
    size_t count;
    tdsp_scene_discs(picture->scene->scene, &count);
    if (count > 0) legend_disc(&legend, PLOT_DISC, PLOT_DISC, "discs at departure");
    if (count > 0 && isfinite(picture->arrival)) legend_disc(&legend, PLOT_DISC_LATER, PLOT_DISC_OUTLINE, "at arrival");
    if (picture->legs->len > 0) legend_line(&legend, FALSE, path);
    if (rides(picture->legs)) legend_line(&legend, TRUE, "ridden disc, as the ride begins");
    if (tdsp_jumps_count(picture->jumps) > 0) legend_gap(&legend);
}

/* Metres become kilometres where there are many. */
static Axis axis_of(const char *name, const char *unit, double range)
{
    gboolean kilometres = strcmp(unit, "m") == 0 && range >= 5000;
    return (Axis){name, kilometres ? "km" : unit, kilometres ? 1000 : 1};
}

gboolean plot_scene(const ScenePicture *picture, const char *path, GError **error)
{
    g_auto(Canvas) canvas = {0};
    Frame frame = frame_of(extent_of(picture));
    const char *unit = picture->scene->length_unit;
    Axis x = axis_of("x", unit, frame.x_high - frame.x_low), y = axis_of("y", unit, frame.x_high - frame.x_low);
    double width = frame.width + MARGIN_LEFT + MARGIN_RIGHT;
    if (!canvas_begin(&canvas, path, width, frame.height + MARGIN_TOP + MARGIN_BOTTOM, error)) return FALSE;
    frame_draw_grid(canvas.cr, &frame);
    frame_clip(canvas.cr, &frame);
    draw_discs(canvas.cr, &frame, picture);
    double step = draw_journey(canvas.cr, &frame, picture);
    cairo_restore(canvas.cr);
    frame_draw_axes(canvas.cr, &frame, &x, &y);
    draw_titles(&canvas, picture);
    draw_legend(&canvas, picture, step);
    return canvas_write(&canvas, path, error);
}
