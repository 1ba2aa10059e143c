/* SPDX-License-Identifier: MIT */
/* Clocks: each reading is a text of its own, seen while it holds, for without a script nothing else changes a text. */
#include "plot_clock.h"

#include "plot_frame.h"

#define READINGS 10.0 /* in a second of the picture, about */
#define MOST_READINGS 200.0

/* Seen from the time that it tells until another. */
static void draw_reading(Canvas *canvas, double x, double y, double time, double until, const char *unit)
{
    const TextStyle style = {18, TRUE, PLOT_INK, 1, 0, FALSE};
    const Timeline *timeline = canvas_timeline(canvas);
    const Key keys[] = {{timeline->from, 0}, {time, 1}, {until, 0}};
    gsize first = time > timeline->from ? 0 : 1, last = time < timeline->to ? 2 : 1;
    g_autofree char *text = frame_with_unit(time, 6, unit);
    canvas_animate(canvas, PROPERTY_SHOWN, keys + first, last + 1 - first);
    canvas_text(canvas, x, y, &style, text);
}

void plot_clock(Canvas *canvas, double x, double y, const char *unit)
{
    const Timeline *timeline = canvas_timeline(canvas);
    double step = frame_nice_step(timeline->to - timeline->from, CLAMP(READINGS * timeline->seconds, 10, MOST_READINGS)), time = timeline->from;
    const Ticks ticks = frame_ticks(timeline->from, timeline->to, step);
    canvas_layer_begin(canvas, LAYER_MOVING);
    for (guint i = 0; i < ticks.count; i++) {
        double next = frame_tick(&ticks, i);
        if (next <= time || next >= timeline->to) continue;
        draw_reading(canvas, x, y, time, next, unit);
        time = next;
    }
    draw_reading(canvas, x, y, time, timeline->to, unit);
    draw_reading(canvas, x, y, timeline->to, timeline->to, unit);
    canvas_layer_end(canvas);
}
