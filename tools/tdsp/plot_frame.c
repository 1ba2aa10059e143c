/* SPDX-License-Identifier: MIT */
/* Frames and axes. */
#include "plot_frame.h"

#include <math.h>

#include "numbers.h"

#define TICK_SPACING 95.0 /* points between ticks, about */
#define TICK_LENGTH 5.0
#define LEAST_BETWEEN 18.0 /* points between two numbers */
#define MOST_TICKS 1000.0

static const TextStyle number_style = {PLOT_TEXT, FALSE, PLOT_GREY, 0.5, 1, FALSE};

double frame_x(const Frame *frame, double x)
{
    return frame->left + (x - frame->x_low) / (frame->x_high - frame->x_low) * frame->width;
}

double frame_y(const Frame *frame, double y)
{
    return frame->top + (frame->y_high - y) / (frame->y_high - frame->y_low) * frame->height;
}

double frame_nice_step(double range, double pieces)
{
    double rough = range / pieces, power = pow(10, floor(log10(rough)));
    double share = rough / power;
    return power * (share < 1.5 ? 1 : share < 3.5 ? 2 : share < 7.5 ? 5 : 10);
}

char *frame_number(double value)
{
    char buffer[NUMBER_ROOM];
    number_brief(buffer, value == 0 ? 0 : value, 10);
    return *buffer == '-' ? g_strconcat("\xe2\x88\x92", buffer + 1, NULL) : g_strdup(buffer);
}

char *frame_with_unit(double value, int digits, const char *unit)
{
    char buffer[NUMBER_ROOM];
    number_brief(buffer, value, digits);
    return *unit ? g_strdup_printf("%s %s", buffer, unit) : g_strdup(buffer);
}

char *frame_axis_title(const Axis *axis)
{
    return *axis->unit ? g_strdup_printf("%s (%s)", axis->name, axis->unit) : g_strdup(axis->name);
}

/* Counted, for adding 1 to a multiple that is large enough changes nothing. */
Ticks frame_ticks(double low, double high, double step)
{
    double first = ceil(low / step - 1e-9), count = floor(high / step + 1e-9) - first + 1;
    return (Ticks){step, first, (guint)CLAMP(count, 0, MOST_TICKS)};
}

double frame_tick(const Ticks *ticks, guint i)
{
    return (ticks->first + i) * ticks->step;
}

static Ticks ticks_of(double low, double high, double points, double spacing)
{
    return frame_ticks(low, high, frame_nice_step(high - low, fmax(2, points / spacing)));
}

static double widest_number(const Canvas *canvas, const Ticks *ticks, const Axis *axis)
{
    double widest = 0;
    for (guint i = 0; i < ticks->count; i++) {
        g_autofree char *number = frame_number(frame_tick(ticks, i) / axis->divisor);
        widest = fmax(widest, canvas_text_width(canvas, &number_style, number));
    }
    return widest;
}

/* So far apart that the numbers have room beside each other. */
static Ticks ticks_x(const Canvas *canvas, const Frame *frame, const Axis *axis)
{
    Ticks ticks = ticks_of(frame->x_low, frame->x_high, frame->width, TICK_SPACING);
    double spacing = widest_number(canvas, &ticks, axis) + LEAST_BETWEEN;
    if (ticks.step / (frame->x_high - frame->x_low) * frame->width >= spacing) return ticks;
    return ticks_of(frame->x_low, frame->x_high, frame->width, 2 * spacing);
}

static Ticks ticks_y(const Frame *frame)
{
    return ticks_of(frame->y_low, frame->y_high, frame->height, TICK_SPACING);
}

static const Pen grid_pen = {PLOT_GRID, 1, FALSE, 0, 0}, axis_pen = {PLOT_GREY, 1, FALSE, 0, 0};

static void line(Canvas *canvas, double x0, double y0, double x1, double y1)
{
    canvas_move_to(canvas, x0, y0);
    canvas_line_to(canvas, x1, y1);
}

void frame_draw_grid(Canvas *canvas, const Frame *frame, const Axis *axis)
{
    Ticks x = ticks_x(canvas, frame, axis), y = ticks_y(frame);
    for (guint i = 0; i < x.count; i++) {
        double at = frame_x(frame, frame_tick(&x, i));
        line(canvas, at, frame->top, at, frame->top + frame->height);
    }
    for (guint i = 0; i < y.count; i++) {
        double at = frame_y(frame, frame_tick(&y, i));
        line(canvas, frame->left, at, frame->left + frame->width, at);
    }
    canvas_stroke(canvas, &grid_pen);
}

static void draw_ticks_x(Canvas *canvas, const Frame *frame, const Axis *axis)
{
    Ticks ticks = ticks_x(canvas, frame, axis);
    double bottom = frame->top + frame->height;
    for (guint i = 0; i < ticks.count; i++) {
        double x = frame_x(frame, frame_tick(&ticks, i));
        g_autofree char *number = frame_number(frame_tick(&ticks, i) / axis->divisor);
        canvas_text(canvas, x, bottom + TICK_LENGTH + 5, &number_style, number);
        line(canvas, x, bottom, x, bottom + TICK_LENGTH);
    }
    canvas_stroke(canvas, &axis_pen);
}

/* Returns how far the widest number reaches to the left. */
static double draw_ticks_y(Canvas *canvas, const Frame *frame, const Axis *axis)
{
    const TextStyle style = {PLOT_TEXT, FALSE, PLOT_GREY, 1, 0.5, FALSE};
    Ticks ticks = ticks_y(frame);
    double widest = 0;
    for (guint i = 0; i < ticks.count; i++) {
        double y = frame_y(frame, frame_tick(&ticks, i));
        g_autofree char *number = frame_number(frame_tick(&ticks, i) / axis->divisor);
        widest = fmax(widest, canvas_text_width(canvas, &style, number));
        canvas_text(canvas, frame->left - TICK_LENGTH - 4, y, &style, number);
        line(canvas, frame->left - TICK_LENGTH, y, frame->left, y);
    }
    canvas_stroke(canvas, &axis_pen);
    return widest;
}

void frame_draw_axes(Canvas *canvas, const Frame *frame, const Axis *x, const Axis *y)
{
    const TextStyle style_x = {PLOT_TEXT, FALSE, PLOT_INK, 0.5, 1, FALSE}, style_y = {PLOT_TEXT, FALSE, PLOT_INK, 0.5, 0, FALSE};
    g_autofree char *title_x = frame_axis_title(x);
    g_autofree char *title_y = frame_axis_title(y);
    draw_ticks_x(canvas, frame, x);
    double widest = draw_ticks_y(canvas, frame, y);
    canvas_text(canvas, frame->left + frame->width / 2, frame->top + frame->height + 28, &style_x, title_x);
    canvas_text_upwards(canvas, frame->left - TICK_LENGTH - 14 - widest, frame->top + frame->height / 2, &style_y, title_y);
    canvas_rectangle(canvas, frame->left, frame->top, frame->width, frame->height);
    canvas_stroke(canvas, &axis_pen);
}

void frame_clip(Canvas *canvas, const Frame *frame)
{
    canvas_clip(canvas, frame->left, frame->top, frame->width, frame->height);
}
