/* SPDX-License-Identifier: MIT */
/*
 * The picture of a table: travel time over departure. Between the rows i - 1 and i the true curve lies between T(b_(i-1)+) and T(b_i);
 * this band is filled, and where it leaps up the leap is drawn.
 *
 * Tables have up to millions of rows. Both edges of the band never fall, so a point is left out when it is nearer than a fraction of a
 * point of the canvas to the one drawn last, and the picture stays as small as its size allows.
 */
#include "plot_curve.h"

#include <math.h>
#include <string.h>

#include "cli.h"
#include "plot_frame.h"
#include "plot_jumps.h"
#include "plot_labels.h"
#include "plot_legend.h"
#include "words.h"

#define WIDTH 840.0
#define HEIGHT 540.0
#define MARGIN_LEFT 96.0
#define MARGIN_RIGHT 36.0
#define MARGIN_TOP 88.0
#define MARGIN_BOTTOM 100.0
#define FINE 0.2 /* points of the canvas that need not be told apart */
#define OBSTACLE_EVERY 4.0
#define ABOVE 0.1      /* of the range of travel times, over the highest */
#define ABOVE_CUT 0.25 /* the same where a jump leaves the frame, which has to be said there */
#define LAST_TEXT 15.0 /* from the line of the last departure to the base line of its name */

/* The upper edge of the band: the travel time that is kept. */
static const Pen edge_pen = {PLOT_PATH, 1.6, TRUE, 0, 0};

typedef struct Curve {
    const tdsp_table *table;
    tdsp_table_info info;
    Frame frame;
} Curve;

static tdsp_row row_at(const Curve *curve, guint64 i)
{
    tdsp_row row = {0, 0, 0, 0};
    tdsp_table_row(curve->table, i, &row);
    return row;
}

/* Where the last row's right side is infinite the curve ends. */
static double highest(const Curve *curve)
{
    tdsp_row last = row_at(curve, curve->info.rows - 1);
    return isfinite(last.right) ? fmax(last.left, last.right) : last.left;
}

static Frame frame_of(const Curve *curve)
{
    double low = row_at(curve, 0).left, all = highest(curve), last = curve->info.last_departure;
    double high = plot_jumps_cut(curve->table, &curve->info, low, all), above = high < all ? ABOVE_CUT : ABOVE;
    double range = high - low;
    if (!(range > 1e-9 * fabs(high))) range = high > 0 ? 0.1 * high : 1;
    double width = last > 0 ? last : 1;
    double bottom = low > 0 ? fmax(low - 0.08 * range, 0) : -0.08 * range;
    return (Frame){MARGIN_LEFT,
                   MARGIN_TOP,
                   WIDTH - MARGIN_LEFT - MARGIN_RIGHT,
                   HEIGHT - MARGIN_TOP - MARGIN_BOTTOM,
                   -0.01 * width,
                   1.04 * width,
                   bottom,
                   low + (1 + above) * range};
}

/* A staircase being drawn: vertices that are not told apart are merged. */
typedef struct Steps {
    Canvas *canvas;
    double x, y; /* drawn last */
    gboolean begun;
} Steps;

static void steps_to(Steps *steps, double x, double y)
{
    if (steps->begun && fabs(x - steps->x) < FINE && fabs(y - steps->y) < FINE) return;
    canvas_line_to(steps->canvas, x, y);
    *steps = (Steps){steps->canvas, x, y, TRUE};
}

static void trace_upper(const Curve *curve, Steps *steps)
{
    const Frame *frame = &curve->frame;
    double x = frame_x(frame, 0);
    for (guint64 i = 0; i < curve->info.rows; i++) {
        tdsp_row row = row_at(curve, i);
        double y = frame_y(frame, row.left);
        steps_to(steps, x, y);
        x = frame_x(frame, row.departure);
        steps_to(steps, x, y);
    }
}

/* From the last departure back to the first. */
static void trace_lower(const Curve *curve, Steps *steps)
{
    const Frame *frame = &curve->frame;
    for (guint64 i = curve->info.rows - 1; i > 0; i--) {
        tdsp_row row = row_at(curve, i), before = row_at(curve, i - 1);
        double y = frame_y(frame, before.right);
        steps_to(steps, frame_x(frame, row.departure), y);
        steps_to(steps, frame_x(frame, before.departure), y);
    }
}

static void draw_band(const Curve *curve, Canvas *canvas)
{
    Steps steps = {.canvas = canvas};
    trace_upper(curve, &steps);
    trace_lower(curve, &steps);
    canvas_close(canvas);
    canvas_fill(canvas, PLOT_PATH_TINT);
    steps.begun = FALSE;
    trace_upper(curve, &steps);
    canvas_stroke(canvas, &edge_pen);
}

/* Its name stands right of it, where there is no curve. */
static void draw_last_departure(const Curve *curve, Canvas *canvas, Labels *labels)
{
    const Pen pen = {PLOT_ALARM, 1.2, FALSE, 5, 4};
    const TextStyle style = {PLOT_TEXT, FALSE, PLOT_ALARM_TEXT, 0, 0, TRUE};
    double x = frame_x(&curve->frame, curve->info.last_departure);
    canvas_move_to(canvas, x, curve->frame.top);
    canvas_line_to(canvas, x, curve->frame.top + curve->frame.height);
    canvas_stroke(canvas, &pen);
    const char *text = curve->info.last_reason == TDSP_HORIZON ? "horizon" : "last departure";
    double bottom = curve->frame.top + curve->frame.height;
    canvas_text_upwards(canvas, x + LAST_TEXT, bottom - 10, &style, text);
    labels_add_box(labels, x, curve->frame.top, x + LAST_TEXT + 4, bottom);
}

/* The curve and its jumps, as far as a label should not hide them. */
static void add_obstacles(const Curve *curve, Labels *labels)
{
    const Frame *frame = &curve->frame;
    double before = frame_y(frame, row_at(curve, 0).left);
    for (double x = frame_x(frame, 0); x < frame_x(frame, curve->info.last_departure); x += OBSTACLE_EVERY) {
        double departure = curve->info.last_departure * (x - frame_x(frame, 0)) /
                           (frame_x(frame, curve->info.last_departure) - frame_x(frame, 0));
        double upper;
        if (tdsp_table_arrival(curve->table, departure, NULL, &upper) != TDSP_OK) continue;
        double now = frame_y(frame, upper - departure);
        for (double y = before; y > now; y -= OBSTACLE_EVERY) labels_add_obstacle(labels, x, y);
        labels_add_obstacle(labels, x, now);
        before = now;
    }
}

static char *interval_text(const Curve *curve, double departure, double lower, double upper)
{
    g_autofree char *when = frame_with_unit(departure, 7, curve->info.time_unit);
    g_autofree char *low = frame_with_unit(lower - departure, 7, "");
    g_autofree char *high = frame_with_unit(upper - departure, 7, "");
    g_autofree char *end = frame_with_unit(upper - departure, 7, curve->info.time_unit);
    if (strcmp(low, high) == 0) return g_strdup_printf("leave at %s: %s", when, end);
    return g_strdup_printf("leave at %s: %s to %s", when, low, end);
}

static void mark_departure(const Curve *curve, Canvas *canvas, double departure, Labels *labels)
{
    const TextStyle style = {PLOT_TEXT, TRUE, PLOT_INK, 0, 0, TRUE};
    double lower, upper;
    if (tdsp_table_arrival(curve->table, departure, &lower, &upper) != TDSP_OK) return;
    g_autofree char *text = interval_text(curve, departure, lower, upper);
    double x = frame_x(&curve->frame, departure), y = frame_y(&curve->frame, upper - departure);
    canvas_move_to(canvas, x, curve->frame.top + curve->frame.height);
    canvas_line_to(canvas, x, y);
    canvas_stroke(canvas, &(Pen){PLOT_INK, 1, FALSE, 0, 0});
    canvas_circle(canvas, x, y, 4);
    canvas_fill(canvas, PLOT_INK);
    labels_add_mark(labels, x, y, 5);
    labels_write(labels, canvas, x, y, 10, -G_PI / 2, &style, text);
}

static char *guarantee_of(const tdsp_table_info *info)
{
    if (info->guarantee == TDSP_GUARANTEE_ABSOLUTE) {
        g_autofree char *delta = frame_with_unit(info->delta, 7, info->time_unit);
        return g_strdup_printf("arrivals certified within %s", delta);
    }
    g_autofree char *percent = frame_with_unit(100 * info->epsilon, 7, "");
    return g_strdup_printf("%s times certified within %s %%", words_guarantee(info->guarantee), percent);
}

static char *end_of(const tdsp_table_info *info)
{
    g_autofree char *last = frame_with_unit(info->last_departure, 7, info->time_unit);
    g_autofree char *reason = cli_reason(info->last_reason);
    if (info->last_reason == TDSP_HORIZON) return g_strdup_printf("departures up to the horizon %s", last);
    return g_strdup_printf("last departure %s: then %s", last, reason);
}

static void draw_titles(const Curve *curve, Canvas *canvas, const char *name)
{
    const TextStyle title = {18, TRUE, PLOT_INK, 0, 0, FALSE}, subtitle = {PLOT_TEXT, FALSE, PLOT_GREY, 0, 0, FALSE};
    g_autofree char *guarantee = guarantee_of(&curve->info);
    g_autofree char *end = end_of(&curve->info);
    g_autofree char *heading = g_strdup_printf("Travel time: %s", name);
    g_autofree char *text = g_strdup_printf("%" G_GUINT64_FORMAT " row%s, %s", curve->info.rows, curve->info.rows == 1 ? "" : "s", guarantee);
    const double room = WIDTH - MARGIN_LEFT - 10;
    canvas_describe(canvas, heading);
    canvas_text_within(canvas, MARGIN_LEFT, 32, room, &title, heading);
    canvas_text_within(canvas, MARGIN_LEFT, 54, room, &subtitle, text);
    canvas_text_within(canvas, MARGIN_LEFT, 72, room, &subtitle, end);
}

static void draw_legend(Canvas *canvas, guint jumps)
{
    Legend legend = legend_new(canvas, MARGIN_LEFT, WIDTH - 10, HEIGHT - 24);
    g_autofree char *jumped = g_strdup_printf("jump%s (%u)", jumps == 1 ? "" : "s", jumps);
    double x = legend_item(&legend, 24, "certified interval; upper edge: travel time of the stored path"), y = legend.y;
    canvas_rectangle(canvas, x, y - 6, 24, 12);
    canvas_fill(canvas, PLOT_PATH_TINT);
    canvas_move_to(canvas, x, y - 6);
    canvas_line_to(canvas, x + 24, y - 6);
    canvas_stroke(canvas, &edge_pen);
    if (jumps == 0) return;
    x = legend_item(&legend, 10, jumped) + 5;
    canvas_move_to(canvas, x, y + 6);
    canvas_line_to(canvas, x, y - 6);
    canvas_stroke(canvas, &plot_jump_pen);
    plot_jump_end(canvas, x, y + 6, TRUE);
    plot_jump_end(canvas, x, y - 6, FALSE);
}

gboolean plot_curve(const tdsp_table *table, const char *name, const double *departure, const char *path, GError **error)
{
    Curve curve = {.table = table};
    tdsp_status status = tdsp_table_get_info(table, &curve.info);
    if (status != TDSP_OK) return cli_fail_status(error, "table", status);
    curve.frame = frame_of(&curve);
    const Axis x = {"departure", curve.info.time_unit, 1}, y = {"travel time", curve.info.time_unit, 1};
    g_autoptr(Canvas) canvas = canvas_new(path, WIDTH, HEIGHT, NULL, error);
    if (!canvas) return FALSE;
    frame_draw_grid(canvas, &curve.frame, &x);
    frame_clip(canvas, &curve.frame);
    g_auto(Labels) labels = labels_new(&curve.frame);
    draw_last_departure(&curve, canvas, &labels);
    draw_band(&curve, canvas);
    add_obstacles(&curve, &labels);
    guint jumps = plot_jumps(canvas, &curve.frame, table, &curve.info, &labels);
    if (departure) mark_departure(&curve, canvas, *departure, &labels);
    plot_jump_labels(canvas, &curve.frame, table, &curve.info, &labels);
    canvas_unclip(canvas);
    frame_draw_axes(canvas, &curve.frame, &x, &y);
    draw_titles(&curve, canvas, name);
    draw_legend(canvas, jumps);
    return canvas_write(canvas, error);
}
