/* SPDX-License-Identifier: MIT */
/* Frames and axes. */
#include "plot_frame.h"

#include <math.h>

#include "numbers.h"

#define TICK_SPACING 95.0 /* points between ticks, about */
#define TICK_LENGTH 5.0

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

char *frame_axis_title(const Axis *axis)
{
    return *axis->unit ? g_strdup_printf("%s (%s)", axis->name, axis->unit) : g_strdup(axis->name);
}

/* The ticks of a range: multiples of a step. */
typedef struct Ticks {
    double step;
    double first, last; /* as multiples */
} Ticks;

static Ticks ticks_of(double low, double high, double points)
{
    double step = frame_nice_step(high - low, fmax(2, points / TICK_SPACING));
    return (Ticks){step, ceil(low / step - 1e-9), floor(high / step + 1e-9)};
}

static Ticks ticks_x(const Frame *frame)
{
    return ticks_of(frame->x_low, frame->x_high, frame->width);
}

static Ticks ticks_y(const Frame *frame)
{
    return ticks_of(frame->y_low, frame->y_high, frame->height);
}

static void line(cairo_t *cr, double x0, double y0, double x1, double y1)
{
    cairo_move_to(cr, x0, y0);
    cairo_line_to(cr, x1, y1);
}

void frame_draw_grid(cairo_t *cr, const Frame *frame)
{
    Ticks x = ticks_x(frame), y = ticks_y(frame);
    for (double i = x.first; i <= x.last; i++)
        line(cr, frame_x(frame, i * x.step), frame->top, frame_x(frame, i * x.step), frame->top + frame->height);
    for (double i = y.first; i <= y.last; i++)
        line(cr, frame->left, frame_y(frame, i * y.step), frame->left + frame->width, frame_y(frame, i * y.step));
    canvas_colour(cr, PLOT_GRID);
    cairo_set_line_width(cr, 1);
    cairo_stroke(cr);
}

static void draw_ticks_x(cairo_t *cr, const Frame *frame, const Axis *axis)
{
    const TextStyle style = {PLOT_TEXT, FALSE, PLOT_GREY, 0.5, 1, FALSE};
    Ticks ticks = ticks_x(frame);
    double bottom = frame->top + frame->height;
    for (double i = ticks.first; i <= ticks.last; i++) {
        double x = frame_x(frame, i * ticks.step);
        g_autofree char *number = frame_number(i * ticks.step / axis->divisor);
        canvas_text(cr, x, bottom + TICK_LENGTH + 5, &style, number);
        line(cr, x, bottom, x, bottom + TICK_LENGTH);
        canvas_colour(cr, PLOT_GREY);
        cairo_set_line_width(cr, 1);
        cairo_stroke(cr);
    }
}

/* Returns how far the widest number reaches to the left. */
static double draw_ticks_y(cairo_t *cr, const Frame *frame, const Axis *axis)
{
    const TextStyle style = {PLOT_TEXT, FALSE, PLOT_GREY, 1, 0.5, FALSE};
    Ticks ticks = ticks_y(frame);
    double widest = 0;
    for (double i = ticks.first; i <= ticks.last; i++) {
        double y = frame_y(frame, i * ticks.step);
        g_autofree char *number = frame_number(i * ticks.step / axis->divisor);
        widest = fmax(widest, canvas_text_width(cr, &style, number));
        canvas_text(cr, frame->left - TICK_LENGTH - 4, y, &style, number);
        line(cr, frame->left - TICK_LENGTH, y, frame->left, y);
        canvas_colour(cr, PLOT_GREY);
        cairo_set_line_width(cr, 1);
        cairo_stroke(cr);
    }
    return widest;
}

void frame_draw_axes(cairo_t *cr, const Frame *frame, const Axis *x, const Axis *y)
{
    const TextStyle style_x = {PLOT_TEXT, FALSE, PLOT_INK, 0.5, 1, FALSE}, style_y = {PLOT_TEXT, FALSE, PLOT_INK, 0.5, 0, FALSE};
    g_autofree char *title_x = frame_axis_title(x);
    g_autofree char *title_y = frame_axis_title(y);
    draw_ticks_x(cr, frame, x);
    double widest = draw_ticks_y(cr, frame, y);
    canvas_text(cr, frame->left + frame->width / 2, frame->top + frame->height + 28, &style_x, title_x);
    canvas_text_upwards(cr, frame->left - TICK_LENGTH - 14 - widest, frame->top + frame->height / 2, &style_y, title_y);
    cairo_rectangle(cr, frame->left, frame->top, frame->width, frame->height);
    canvas_colour(cr, PLOT_GREY);
    cairo_set_line_width(cr, 1);
    cairo_stroke(cr);
}

void frame_clip(cairo_t *cr, const Frame *frame)
{
    cairo_save(cr);
    cairo_rectangle(cr, frame->left, frame->top, frame->width, frame->height);
    cairo_clip(cr);
}
