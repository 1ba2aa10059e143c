/* SPDX-License-Identifier: MIT */
/* A cross where a gap closes, and beside it the last departure that gets through. */
#include "plot_gaps.h"

#define ARM 4.5
#define FLASH 0.06 /* of the journey: how long the moment is to be seen */
#define FLASH_RADIUS 30.0

void plot_gap_mark(Canvas *canvas, double x, double y)
{
    static const Pen pens[] = {{PLOT_ALARM, 2.2, FALSE, 0, 0}, {PLOT_PAPER, 5, FALSE, 0, 0}};
    for (int halo = 1; halo >= 0; halo--) {
        canvas_move_to(canvas, x - ARM, y - ARM);
        canvas_line_to(canvas, x + ARM, y + ARM);
        canvas_move_to(canvas, x - ARM, y + ARM);
        canvas_line_to(canvas, x + ARM, y - ARM);
        canvas_stroke(canvas, &pens[halo]);
    }
}

/* A ring that goes out from the place at the moment. */
static void flash(Canvas *canvas, double x, double y, double time, double duration)
{
    const Key radius[] = {{time, 0}, {time + duration, FLASH_RADIUS}}, opacity[] = {{time, 1}, {time + duration, 0}};
    canvas_animate(canvas, PROPERTY_RADIUS, radius, G_N_ELEMENTS(radius));
    canvas_animate(canvas, PROPERTY_OPACITY, opacity, G_N_ELEMENTS(opacity));
    canvas_circle(canvas, x, y, FLASH_RADIUS);
    canvas_stroke(canvas, &(Pen){PLOT_ALARM, 3, FALSE, 0, 0});
}

/* A gap of the picture, with the jump that it makes. */
static void draw_gap(Canvas *canvas, const Frame *frame, const tdsp_arrival_jump *jump)
{
    double x = frame_x(frame, jump->gap.place.x), y = frame_y(frame, jump->gap.place.y);
    const Timeline *timeline = canvas_timeline(canvas);
    if (timeline) flash(canvas, x, y, jump->gap.time, FLASH * (timeline->to - timeline->from));
    plot_gap_mark(canvas, x, y);
}

static int larger_first(gconstpointer one, gconstpointer other)
{
    const tdsp_arrival_jump *a = one, *b = other;
    return a->size < b->size ? 1 : a->size > b->size ? -1 : 0;
}

static void label_gap(Canvas *canvas, const Frame *frame, const tdsp_arrival_jump *jump, const char *unit, Labels *labels)
{
    const TextStyle style = {PLOT_TEXT - 1, TRUE, PLOT_ALARM, 0, 0, TRUE};
    g_autofree char *text = frame_with_unit(jump->departure, 6, unit);
    labels_write(labels, canvas, frame_x(frame, jump->gap.place.x), frame_y(frame, jump->gap.place.y), 8, 0, &style, text);
}

void plot_gaps(Canvas *canvas, const Frame *frame, const tdsp_jumps *jumps, const char *unit, Labels *labels)
{
    g_autoptr(GArray) known = g_array_new(FALSE, FALSE, sizeof(tdsp_arrival_jump));
    tdsp_arrival_jump jump;
    for (gsize i = 0; tdsp_jumps_get(jumps, i, &jump) == TDSP_OK; i++) {
        if (jump.gap.first == TDSP_NO_DISC) continue;
        labels_add_mark(labels, frame_x(frame, jump.gap.place.x), frame_y(frame, jump.gap.place.y), ARM + 1);
        g_array_append_val(known, jump);
    }
    g_array_sort(known, larger_first);
    for (guint i = 0; i < known->len; i++) {
        const tdsp_arrival_jump *one = &g_array_index(known, tdsp_arrival_jump, i);
        canvas_appear_begin(canvas, one->gap.time);
        draw_gap(canvas, frame, one);
        label_gap(canvas, frame, one, unit, labels);
        canvas_appear_end(canvas);
    }
}
