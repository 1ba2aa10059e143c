/* SPDX-License-Identifier: MIT */
/* Jumps: a line from the travel time before to the one after, with an end for each where it is long enough. */
#include "plot_jumps.h"

#include <math.h>

#include "shape_asked.h"

#define MARKED 0.012   /* of the frame's height: smaller jumps get no ends ... */
#define LABELLED 0.02  /* ... and no label */
#define MOST_LABELS 12
#define JUMP_END 3.6
#define OBSTACLE_EVERY 4.0
#define ARROW 6.0
#define LATE 0.98   /* of the last departure: departures after this are the very last ones */
#define FLAT 1e-3   /* of all travel times' range: so little is level anyway */
#define PRESSED 0.2 /* of it: most departures have to share less than this */

const Pen plot_jump_pen = {PLOT_ALARM, 1.6, FALSE, 0, 0};

void plot_jump_end(Canvas *canvas, double x, double y, gboolean filled)
{
    canvas_circle(canvas, x, y, JUMP_END);
    canvas_fill_and_stroke(canvas, filled ? PLOT_ALARM : PLOT_PAPER, &plot_jump_pen);
}

/* A jump goes on above the frame. */
static void draw_arrow(Canvas *canvas, double x, double top)
{
    canvas_move_to(canvas, x, top + 1);
    canvas_line_to(canvas, x - ARROW, top + 2 * ARROW);
    canvas_line_to(canvas, x + ARROW, top + 2 * ARROW);
    canvas_close(canvas);
    canvas_fill(canvas, PLOT_ALARM);
}

/* T is left-continuous: the lower end belongs to the curve, the upper one does not. */
static void draw_jump(Canvas *canvas, const Frame *frame, const tdsp_jump *jump, Labels *labels)
{
    double x = frame_x(frame, jump->departure), before = frame_y(frame, jump->before), after = frame_y(frame, jump->after);
    canvas_move_to(canvas, x, before);
    canvas_line_to(canvas, x, after);
    canvas_stroke(canvas, &plot_jump_pen);
    for (double y = before; y > after; y -= OBSTACLE_EVERY) labels_add_obstacle(labels, x, y);
    if (before - after < MARKED * frame->height) return;
    plot_jump_end(canvas, x, before, TRUE);
    if (after >= frame->top) plot_jump_end(canvas, x, after, FALSE);
    else draw_arrow(canvas, x, frame->top);
    labels_add_mark(labels, x, before, JUMP_END + 1);
    labels_add_mark(labels, x, after, JUMP_END + 1);
}

/* The first jump at a row after the last one; *from moves on. */
static gboolean next_jump(const tdsp_table *table, const tdsp_table_info *info, double *from, tdsp_jump *jump)
{
    tdsp_row next;
    if (*from > info->last_departure || tdsp_table_next_jump(table, *from, jump) != TDSP_OK) return FALSE;
    gboolean more = jump->row + 1 < info->rows && tdsp_table_row(table, jump->row + 1, &next) == TDSP_OK;
    *from = more ? next.departure : G_MAXDOUBLE;
    return TRUE;
}

double plot_jumps_cut(const tdsp_table *table, const tdsp_table_info *info, double low, double high)
{
    double from = LATE * info->last_departure;
    tdsp_jump jump;
    while (next_jump(table, info, &from, &jump)) {
        double share = (jump.before - low) / (high - low);
        if (share > FLAT && share < PRESSED) return jump.before;
    }
    return high;
}

guint plot_jumps(Canvas *canvas, const Frame *frame, const tdsp_table *table, const tdsp_table_info *info, Labels *labels)
{
    guint count = 0;
    double from = 0;
    tdsp_jump jump;
    while (next_jump(table, info, &from, &jump)) {
        draw_jump(canvas, frame, &jump, labels);
        count++;
    }
    return count;
}

static int larger_first(gconstpointer one, gconstpointer other)
{
    const tdsp_jump *a = one, *b = other;
    double difference = (b->after - b->before) - (a->after - a->before);
    return difference > 0 ? 1 : difference < 0 ? -1 : 0;
}

static void label_jump(Canvas *canvas, const Frame *frame, const tdsp_jump *jump, const char *unit, Labels *labels)
{
    const TextStyle style = {PLOT_TEXT - 1, FALSE, PLOT_ALARM_TEXT, 0, 0, TRUE};
    g_autofree char *departure = frame_with_unit(jump->departure, 6, unit);
    g_autofree char *discs = shape_gap_discs(&jump->gap);
    g_autofree char *reached = frame_with_unit(jump->after, 6, unit);
    g_autofree char *named = jump->gap.first == TDSP_NO_DISC
                                 ? g_strdup(departure)
                                 : g_strdup_printf("%s: discs %s close", departure, discs);
    gboolean leaves = frame_y(frame, jump->after) < frame->top;
    g_autofree char *text = leaves ? g_strdup_printf("%s, to %s", named, reached) : g_strdup(named);
    double x = frame_x(frame, jump->departure), top = fmax(frame_y(frame, jump->after), frame->top), bottom = frame_y(frame, jump->before);
    if (!labels_write_beside(labels, canvas, x, top, bottom, 9, &style, text))
        labels_write_beside(labels, canvas, x, top, bottom, 9, &style, departure);
}

void plot_jump_labels(Canvas *canvas, const Frame *frame, const tdsp_table *table, const tdsp_table_info *info, Labels *labels)
{
    g_autoptr(GArray) jumps = g_array_new(FALSE, FALSE, sizeof(tdsp_jump));
    double from = 0;
    tdsp_jump jump;
    while (next_jump(table, info, &from, &jump)) {
        if (frame_y(frame, jump.before) - frame_y(frame, jump.after) >= LABELLED * frame->height) g_array_append_val(jumps, jump);
    }
    g_array_sort(jumps, larger_first);
    for (guint i = 0; i < MIN(jumps->len, MOST_LABELS); i++)
        label_jump(canvas, frame, &g_array_index(jumps, tdsp_jump, i), info->time_unit, labels);
}
