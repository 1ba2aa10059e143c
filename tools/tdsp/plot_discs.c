/* SPDX-License-Identifier: MIT */
/*
 * Discs as the dots of round pens: a stroke of no length with round ends is a disc. Discs of one size share a pen, so that a scene
 * of many thousand equal discs stays a small file; what lies outside the frame, or exactly under its neighbour, is left out.
 */
#include "plot_discs.h"

#include <math.h>
#include <stdlib.h>

#include "tdsp/growth.h"

typedef struct Dot {
    double radius, x, y; /* on the canvas, rounded to hundredths */
} Dot;

static double hundredth(double value)
{
    return rint(value * 100) / 100;
}

static int dot_order(const void *one, const void *other)
{
    const Dot *a = one, *b = other;
    if (a->radius != b->radius) return a->radius < b->radius ? -1 : 1;
    if (a->x != b->x) return a->x < b->x ? -1 : 1;
    return (a->y > b->y) - (a->y < b->y);
}

static gboolean in_view(const Frame *frame, const Dot *dot)
{
    double x = fmax(0, fmax(frame->left - dot->x, dot->x - frame->left - frame->width));
    double y = fmax(0, fmax(frame->top - dot->y, dot->y - frame->top - frame->height));
    return hypot(x, y) <= dot->radius;
}

static GArray *dots_of(const Frame *frame, const tdsp_scene *scene, double time, const DiscsStyle *style)
{
    size_t count;
    const tdsp_disc *discs = tdsp_scene_discs(scene, &count);
    double inflated = tdsp_scene_journey(scene)->radius, scale = frame->width / (frame->x_high - frame->x_low);
    GArray *dots = g_array_new(FALSE, FALSE, sizeof(Dot));
    for (size_t i = 0; i < count; i++) {
        double radius = discs[i].radius;
        (void)tdsp_scene_disc_at(scene, (uint32_t)i, time, &radius, NULL);
        Dot dot = {hundredth(fmax((radius + inflated) * scale, style->least) + style->wider), hundredth(frame_x(frame, discs[i].center.x)),
                   hundredth(frame_y(frame, discs[i].center.y))};
        if (in_view(frame, &dot)) g_array_append_val(dots, dot);
    }
    if (dots->len > 0) qsort(dots->data, dots->len, sizeof(Dot), dot_order);
    return dots;
}

void plot_discs_fill(cairo_t *cr, const Frame *frame, const tdsp_scene *scene, double time, const DiscsStyle *style)
{
    g_autoptr(GArray) dots = dots_of(frame, scene, time, style);
    canvas_colour(cr, style->colour);
    cairo_set_line_cap(cr, CAIRO_LINE_CAP_ROUND);
    for (guint i = 0; i < dots->len; i++) {
        const Dot *dot = &g_array_index(dots, Dot, i), *next = i + 1 < dots->len ? dot + 1 : NULL;
        if (next && dot_order(dot, next) == 0) continue;
        cairo_move_to(cr, dot->x, dot->y); /* NOLINT(clang-analyzer-core.NullDereference): an array with elements has data */
        cairo_line_to(cr, dot->x, dot->y);
        if (next && next->radius == dot->radius) continue;
        cairo_set_line_width(cr, 2 * dot->radius);
        cairo_stroke(cr);
    }
    cairo_set_line_cap(cr, CAIRO_LINE_CAP_BUTT);
}
