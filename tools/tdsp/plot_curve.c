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
#include "words.h"

#define WIDTH 1000.0
#define HEIGHT 600.0
#define MARGIN_LEFT 96.0
#define MARGIN_RIGHT 36.0
#define MARGIN_TOP 72.0
#define MARGIN_BOTTOM 100.0
#define FINE 0.2 /* points of the canvas that need not be told apart */
#define OBSTACLE_EVERY 4.0

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
    double low = row_at(curve, 0).left, high = highest(curve), last = curve->info.last_departure;
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
                   low + 1.1 * range};
}

/* A staircase being drawn: vertices that are not told apart are merged. */
typedef struct Pen {
    cairo_t *cr;
    double x, y; /* drawn last */
    gboolean down;
} Pen;

static void pen_to(Pen *pen, double x, double y)
{
    if (pen->down && fabs(x - pen->x) < FINE && fabs(y - pen->y) < FINE) return;
    cairo_line_to(pen->cr, x, y);
    *pen = (Pen){pen->cr, x, y, TRUE};
}

static void trace_upper(const Curve *curve, Pen *pen)
{
    const Frame *frame = &curve->frame;
    double x = frame_x(frame, 0);
    for (guint64 i = 0; i < curve->info.rows; i++) {
        tdsp_row row = row_at(curve, i);
        double y = frame_y(frame, row.left);
        pen_to(pen, x, y);
        x = frame_x(frame, row.departure);
        pen_to(pen, x, y);
    }
}

/* From the last departure back to the first. */
static void trace_lower(const Curve *curve, Pen *pen)
{
    const Frame *frame = &curve->frame;
    for (guint64 i = curve->info.rows - 1; i > 0; i--) {
        tdsp_row row = row_at(curve, i), before = row_at(curve, i - 1);
        double y = frame_y(frame, before.right);
        pen_to(pen, frame_x(frame, row.departure), y);
        pen_to(pen, frame_x(frame, before.departure), y);
    }
}

static void draw_band(const Curve *curve, cairo_t *cr)
{
    Pen pen = {.cr = cr};
    trace_upper(curve, &pen);
    trace_lower(curve, &pen);
    cairo_close_path(cr);
    canvas_colour(cr, PLOT_PATH_TINT);
    cairo_fill(cr);
    pen.down = FALSE;
    trace_upper(curve, &pen);
    cairo_set_line_width(cr, 1.6);
    cairo_set_line_join(cr, CAIRO_LINE_JOIN_ROUND);
    canvas_colour(cr, PLOT_PATH);
    cairo_stroke(cr);
}

static void draw_last_departure(const Curve *curve, cairo_t *cr)
{
    static const double dashes[] = {5, 4};
    const TextStyle style = {PLOT_TEXT, FALSE, PLOT_ALARM, 0.5, 0, TRUE};
    double x = frame_x(&curve->frame, curve->info.last_departure);
    cairo_move_to(cr, x, curve->frame.top);
    cairo_line_to(cr, x, curve->frame.top + curve->frame.height);
    cairo_set_dash(cr, dashes, G_N_ELEMENTS(dashes), 0);
    canvas_colour(cr, PLOT_ALARM);
    cairo_set_line_width(cr, 1.2);
    cairo_stroke(cr);
    cairo_set_dash(cr, NULL, 0, 0);
    canvas_text_upwards(cr, x - 7, curve->frame.top + curve->frame.height / 2, &style,
                        curve->info.last_reason == TDSP_HORIZON ? "horizon" : "last departure");
}

static char *with_unit(double value, const char *unit)
{
    char buffer[32];
    g_ascii_formatd(buffer, sizeof buffer, "%.7g", value);
    return *unit ? g_strdup_printf("%s %s", buffer, unit) : g_strdup(buffer);
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
    g_autofree char *when = with_unit(departure, curve->info.time_unit);
    g_autofree char *low = with_unit(lower - departure, "");
    g_autofree char *high = with_unit(upper - departure, "");
    g_autofree char *end = with_unit(upper - departure, curve->info.time_unit);
    if (strcmp(low, high) == 0) return g_strdup_printf("leave at %s: %s", when, end);
    return g_strdup_printf("leave at %s: %s to %s", when, low, end);
}

static void mark_departure(const Curve *curve, cairo_t *cr, double departure, Labels *labels)
{
    const TextStyle style = {PLOT_TEXT, TRUE, PLOT_INK, 0, 0, TRUE};
    double lower, upper;
    if (tdsp_table_arrival(curve->table, departure, &lower, &upper) != TDSP_OK) return;
    g_autofree char *text = interval_text(curve, departure, lower, upper);
    double x = frame_x(&curve->frame, departure), y = frame_y(&curve->frame, upper - departure);
    cairo_move_to(cr, x, curve->frame.top + curve->frame.height);
    cairo_line_to(cr, x, y);
    canvas_colour(cr, PLOT_INK);
    cairo_set_line_width(cr, 1);
    cairo_stroke(cr);
    cairo_arc(cr, x, y, 4, 0, 2 * G_PI);
    cairo_fill(cr);
    labels_add_mark(labels, x, y, 5);
    labels_write(labels, cr, x, y, 10, -G_PI / 2, &style, text);
}

static char *guarantee_of(const tdsp_table_info *info)
{
    if (info->guarantee == TDSP_GUARANTEE_ABSOLUTE) {
        g_autofree char *delta = with_unit(info->delta, info->time_unit);
        return g_strdup_printf("arrivals certified within %s", delta);
    }
    g_autofree char *percent = with_unit(100 * info->epsilon, "");
    return g_strdup_printf("%s times certified within %s %%", words_guarantee(info->guarantee), percent);
}

static char *end_of(const tdsp_table_info *info)
{
    g_autofree char *last = with_unit(info->last_departure, info->time_unit);
    g_autofree char *reason = cli_reason(info->last_reason);
    if (info->last_reason == TDSP_HORIZON) return g_strdup_printf("departures up to the horizon %s", last);
    return g_strdup_printf("last departure %s: then %s", last, reason);
}

static void draw_titles(const Curve *curve, cairo_t *cr, const char *name)
{
    const TextStyle title = {18, TRUE, PLOT_INK, 0, 0, FALSE}, subtitle = {PLOT_TEXT, FALSE, PLOT_GREY, 0, 0, FALSE};
    g_autofree char *guarantee = guarantee_of(&curve->info);
    g_autofree char *end = end_of(&curve->info);
    g_autofree char *heading = g_strdup_printf("Travel time: %s", name);
    g_autofree char *text = g_strdup_printf("%" G_GUINT64_FORMAT " row%s, %s \xc2\xb7 %s", curve->info.rows,
                                            curve->info.rows == 1 ? "" : "s", guarantee, end);
    canvas_text_within(cr, MARGIN_LEFT, 32, WIDTH - MARGIN_LEFT - 10, &title, heading);
    canvas_text_within(cr, MARGIN_LEFT, 54, WIDTH - MARGIN_LEFT - 10, &subtitle, text);
}

static void draw_legend(cairo_t *cr, guint jumps)
{
    const TextStyle style = {PLOT_TEXT, FALSE, PLOT_INK, 0, 0.5, FALSE};
    double x = MARGIN_LEFT, y = HEIGHT - 24;
    const char *band = "certified interval; upper edge: travel time of the stored path";
    g_autofree char *jumped = g_strdup_printf("jump%s (%u)", jumps == 1 ? "" : "s", jumps);
    cairo_rectangle(cr, x, y - 6, 24, 12);
    canvas_colour(cr, PLOT_PATH_TINT);
    cairo_fill(cr);
    cairo_move_to(cr, x, y - 6);
    cairo_line_to(cr, x + 24, y - 6);
    canvas_colour(cr, PLOT_PATH);
    cairo_set_line_width(cr, 1.6);
    cairo_stroke(cr);
    canvas_text(cr, x + 32, y, &style, band);
    if (jumps == 0) return;
    x += 32 + canvas_text_width(cr, &style, band) + 30;
    cairo_move_to(cr, x, y + 6);
    cairo_line_to(cr, x, y - 6);
    canvas_colour(cr, PLOT_ALARM);
    cairo_stroke(cr);
    plot_jump_end(cr, x, y + 6, TRUE);
    plot_jump_end(cr, x, y - 6, FALSE);
    canvas_text(cr, x + 12, y, &style, jumped);
}

gboolean plot_curve(const tdsp_table *table, const char *name, const double *departure, const char *path, GError **error)
{
    g_auto(Canvas) canvas = {0};
    Curve curve = {.table = table};
    tdsp_status status = tdsp_table_get_info(table, &curve.info);
    if (status != TDSP_OK) return cli_fail_status(error, "table", status);
    curve.frame = frame_of(&curve);
    const Axis x = {"departure", curve.info.time_unit, 1}, y = {"travel time", curve.info.time_unit, 1};
    if (!canvas_begin(&canvas, path, WIDTH, HEIGHT, error)) return FALSE;
    frame_draw_grid(canvas.cr, &curve.frame);
    frame_clip(canvas.cr, &curve.frame);
    draw_last_departure(&curve, canvas.cr);
    draw_band(&curve, canvas.cr);
    g_auto(Labels) labels = labels_new(&curve.frame);
    add_obstacles(&curve, &labels);
    guint jumps = plot_jumps(canvas.cr, &curve.frame, table, &curve.info);
    if (departure) mark_departure(&curve, canvas.cr, *departure, &labels);
    plot_jump_labels(canvas.cr, &curve.frame, table, &curve.info, &labels);
    cairo_restore(canvas.cr);
    frame_draw_axes(canvas.cr, &curve.frame, &x, &y);
    draw_titles(&curve, canvas.cr, name);
    draw_legend(canvas.cr, jumps);
    return canvas_write(&canvas, path, error);
}
