/* SPDX-License-Identifier: MIT */
/* A cross where a gap closes, and beside it the last departure that gets through. */
#include "plot_gaps.h"

#define ARM 4.5

void plot_gap_mark(cairo_t *cr, double x, double y)
{
    for (int halo = 1; halo >= 0; halo--) {
        cairo_move_to(cr, x - ARM, y - ARM);
        cairo_line_to(cr, x + ARM, y + ARM);
        cairo_move_to(cr, x - ARM, y + ARM);
        cairo_line_to(cr, x + ARM, y - ARM);
        canvas_colour(cr, halo ? PLOT_PAPER : PLOT_ALARM);
        cairo_set_line_width(cr, halo ? 5 : 2.2);
        cairo_stroke(cr);
    }
}

static int larger_first(gconstpointer one, gconstpointer other)
{
    const tdsp_arrival_jump *a = one, *b = other;
    return a->size < b->size ? 1 : a->size > b->size ? -1 : 0;
}

static void label_gap(cairo_t *cr, const Frame *frame, const tdsp_arrival_jump *jump, const char *unit, Labels *labels)
{
    const TextStyle style = {PLOT_TEXT - 1, TRUE, PLOT_ALARM, 0, 0, TRUE};
    char departure[32];
    g_ascii_formatd(departure, sizeof departure, "%.6g", jump->departure);
    g_autofree char *text = g_strdup_printf("%s%s%s", departure, *unit ? " " : "", unit);
    labels_write(labels, cr, frame_x(frame, jump->gap.place.x), frame_y(frame, jump->gap.place.y), 8, 0, &style, text);
}

void plot_gaps(cairo_t *cr, const Frame *frame, const tdsp_jumps *jumps, const char *unit, Labels *labels)
{
    g_autoptr(GArray) known = g_array_new(FALSE, FALSE, sizeof(tdsp_arrival_jump));
    tdsp_arrival_jump jump;
    for (gsize i = 0; tdsp_jumps_get(jumps, i, &jump) == TDSP_OK; i++) {
        if (jump.gap.first == TDSP_NO_DISC) continue;
        double x = frame_x(frame, jump.gap.place.x), y = frame_y(frame, jump.gap.place.y);
        plot_gap_mark(cr, x, y);
        labels_add_mark(labels, x, y, ARM + 1);
        g_array_append_val(known, jump);
    }
    g_array_sort(known, larger_first);
    for (guint i = 0; i < known->len; i++) label_gap(cr, frame, &g_array_index(known, tdsp_arrival_jump, i), unit, labels);
}
