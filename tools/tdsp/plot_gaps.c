/* SPDX-License-Identifier: MIT */
/* Two triangles that face each other where a gap closes, along the line of the two discs' centres, and beside them when. */
#include "plot_gaps.h"

#include <math.h>

#define APART 3.5 /* of the tips from the place, while the gap is open */
#define LENGTH 9.0
#define HALF 5.5
#define REACH (APART + LENGTH)
#define FLASH 0.06 /* of the journey: how long the moment is to be seen */
#define FLASH_RADIUS 30.0

/* Along the unit vector (ux, uy), its tip `from` away from the place. */
static void triangle(Canvas *canvas, double x, double y, double ux, double uy, double from)
{
    double back = from + LENGTH;
    canvas_move_to(canvas, x + ux * from, y + uy * from);
    canvas_line_to(canvas, x + ux * back - uy * HALF, y + uy * back + ux * HALF);
    canvas_line_to(canvas, x + ux * back + uy * HALF, y + uy * back - ux * HALF);
    canvas_close(canvas);
}

static void both_triangles(Canvas *canvas, double x, double y, double direction, gboolean closed)
{
    double ux = cos(direction), uy = sin(direction), from = closed ? 0 : APART;
    triangle(canvas, x, y, ux, uy, from);
    triangle(canvas, x, y, -ux, -uy, from);
}

void plot_gap_mark(Canvas *canvas, double x, double y, double direction, gboolean closed)
{
    both_triangles(canvas, x, y, direction, closed);
    canvas_stroke(canvas, &(Pen){PLOT_PAPER, 4, TRUE, 0, 0});
    both_triangles(canvas, x, y, direction, closed);
    canvas_fill(canvas, PLOT_ALARM);
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

static int larger_first(gconstpointer one, gconstpointer other)
{
    const tdsp_arrival_jump *a = one, *b = other;
    return a->size < b->size ? 1 : a->size > b->size ? -1 : 0;
}

/* Of the line of the centres, on the canvas. */
static double direction_of(const tdsp_scene *scene, const tdsp_gap *gap)
{
    size_t count;
    const tdsp_disc *discs = tdsp_scene_discs(scene, &count);
    tdsp_point first = discs[gap->first].center, second = discs[gap->second].center;
    return atan2(first.y - second.y, second.x - first.x);
}

static char *label_of(const tdsp_arrival_jump *jump, gboolean moves, const char *unit)
{
    g_autofree char *time = frame_with_unit(moves ? jump->gap.time : jump->departure, 6, unit);
    return moves ? g_strdup_printf("closes at %s", time) : g_steal_pointer(&time);
}

static void draw_gap(Canvas *canvas, const Frame *frame, const SceneFile *scene, const tdsp_arrival_jump *jump, Labels *labels)
{
    const TextStyle style = {PLOT_TEXT - 1, TRUE, PLOT_ALARM_TEXT, 0, 0, TRUE};
    const Timeline *timeline = canvas_timeline(canvas);
    double x = frame_x(frame, jump->gap.place.x), y = frame_y(frame, jump->gap.place.y), direction = direction_of(scene->scene, &jump->gap);
    g_autofree char *text = label_of(jump, timeline != NULL, scene->time_unit);
    canvas_appear_begin(canvas, jump->gap.time);
    if (timeline) flash(canvas, x, y, jump->gap.time, FLASH * (timeline->to - timeline->from));
    plot_gap_mark(canvas, x, y, direction, timeline != NULL);
    labels_write(labels, canvas, x, y, REACH + 2, direction + G_PI / 2, &style, text);
    canvas_appear_end(canvas);
}

void plot_gaps(Canvas *canvas, const Frame *frame, const SceneFile *scene, const tdsp_jumps *jumps, Labels *labels)
{
    g_autoptr(GArray) known = g_array_new(FALSE, FALSE, sizeof(tdsp_arrival_jump));
    tdsp_arrival_jump jump;
    for (gsize i = 0; tdsp_jumps_get(jumps, i, &jump) == TDSP_OK; i++) {
        if (jump.gap.first == TDSP_NO_DISC) continue;
        labels_add_mark(labels, frame_x(frame, jump.gap.place.x), frame_y(frame, jump.gap.place.y), REACH);
        g_array_append_val(known, jump);
    }
    g_array_sort(known, larger_first);
    for (guint i = 0; i < known->len; i++) draw_gap(canvas, frame, scene, &g_array_index(known, tdsp_arrival_jump, i), labels);
}
