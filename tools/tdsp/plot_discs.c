/* SPDX-License-Identifier: MIT */
/*
 * Discs as the dots of round pens: a stroke of no length with round ends is a disc. Discs of one size share a pen, and those that grow alike an
 * animation, so that a scene of many thousand equal discs stays a small file; what lies outside the frame, or exactly under its neighbour, is left out.
 */
#include "plot_discs.h"

#include <math.h>

#include "tdsp/growth.h"

/* Points of the canvas: how far a radius is from the straight line between two samples, as it never falls, and how far that is from the keys that are kept. */
#define FINE 0.05
#define MOST_HALVINGS 40

typedef struct Dot {
    double x, y;       /* on the canvas, rounded to hundredths */
    guint first, keys; /* the radius over time: so many of the view's keys, from the first on */
} Dot;

/* The discs over a while (one moment: from = to) as they come to the canvas. */
typedef struct View {
    const Frame *frame;
    const tdsp_scene *scene;
    const DiscsStyle *style;
    double from, to, scale;
    GArray *keys; /* of Key */
    GArray *dots; /* of Dot */
} View;

static double hundredth(double value)
{
    return rint(value * 100) / 100;
}

static double radius_at(const View *view, uint32_t disc, double time)
{
    double radius = 0;
    (void)tdsp_scene_disc_at(view->scene, disc, time, &radius, NULL);
    return fmax((radius + tdsp_scene_journey(view->scene)->radius) * view->scale, view->style->least) + view->style->wider;
}

static void add_key(GArray *keys, double time, double radius)
{
    Key key = {time, radius};
    g_array_append_val(keys, key);
}

/* One rate: straight, but for the moment at which the disc becomes larger than the least that is drawn. */
static void sample_rate(const View *view, uint32_t disc, GArray *samples)
{
    double begin = radius_at(view, disc, view->from), end = radius_at(view, disc, view->to), rate = 0;
    (void)tdsp_scene_disc_at(view->scene, disc, view->from, NULL, &rate);
    double grows = rate * view->scale > 0 ? view->to - (end - begin) / (rate * view->scale) : view->from;
    add_key(samples, view->from, begin);
    if (grows > view->from + 1e-9 * (view->to - view->from) && end > begin) add_key(samples, grows, begin);
    add_key(samples, view->to, end);
}

/* Any law: so often that it grows by less than FINE between. */
static void sample_law(const View *view, uint32_t disc, GArray *samples)
{
    double time = view->from, radius = radius_at(view, disc, time), step = view->to - view->from;
    double least = ldexp(step, -MOST_HALVINGS);
    add_key(samples, time, radius);
    while (time < view->to) {
        double next = step < view->to - time ? time + step : view->to, grown = radius_at(view, disc, next);
        if (grown - radius > FINE && step > least) {
            step /= 2;
            continue;
        }
        time = next;
        radius = grown;
        add_key(samples, time, radius);
        step *= 2;
    }
}

/* Of the samples the fewest, going from each as far as a straight line comes within FINE of all between. */
static void keep_needed(const GArray *samples, GArray *keys)
{
    const Key *all = (const Key *)samples->data, *from = all;
    double least = -INFINITY, most = INFINITY;
    g_array_append_val(keys, *from);
    for (guint i = 1; i < samples->len; i++) {
        double slope = (all[i].value - from->value) / (all[i].time - from->time);
        if (slope < least || slope > most) {
            from = &all[i - 1];
            g_array_append_val(keys, *from);
            least = -INFINITY;
            most = INFINITY;
        }
        double width = all[i].time - from->time;
        least = fmax(least, (all[i].value - FINE - from->value) / width);
        most = fmin(most, (all[i].value + FINE - from->value) / width);
    }
    g_array_append_val(keys, all[samples->len - 1]);
}

static void add_keys(View *view, uint32_t disc, GArray *samples)
{
    g_array_set_size(samples, 0);
    if (view->from == view->to) {
        add_key(view->keys, view->from, radius_at(view, disc, view->from));
        return;
    }
    if (tdsp_scene_has_rates_only(view->scene))
        sample_rate(view, disc, samples);
    else
        sample_law(view, disc, samples);
    keep_needed(samples, view->keys);
}

static int order(double one, double other)
{
    return (one > other) - (one < other);
}

static int key_order(const View *view, const Dot *a, const Dot *b)
{
    if (a->keys != b->keys) return a->keys < b->keys ? -1 : 1;
    int result = 0;
    for (guint i = 0; i < a->keys && result == 0; i++) {
        const Key *one = &g_array_index(view->keys, Key, a->first + i), *other = &g_array_index(view->keys, Key, b->first + i);
        result = order(one->value, other->value);
        if (result == 0) result = order(one->time, other->time);
    }
    return result;
}

static int dot_order(gconstpointer one, gconstpointer other, gpointer view)
{
    const Dot *a = one, *b = other;
    int result = key_order(view, a, b);
    if (result == 0) result = order(a->x, b->x);
    return result != 0 ? result : order(a->y, b->y);
}

static gboolean in_view(const Frame *frame, const Dot *dot, double radius)
{
    double x = fmax(0, fmax(frame->left - dot->x, dot->x - frame->left - frame->width));
    double y = fmax(0, fmax(frame->top - dot->y, dot->y - frame->top - frame->height));
    return hypot(x, y) <= radius;
}

static void add_dots(View *view)
{
    size_t count;
    const tdsp_disc *discs = tdsp_scene_discs(view->scene, &count);
    g_autoptr(GArray) samples = g_array_new(FALSE, FALSE, sizeof(Key));
    for (size_t i = 0; i < count; i++) {
        Dot dot = {hundredth(frame_x(view->frame, discs[i].center.x)), hundredth(frame_y(view->frame, discs[i].center.y)), view->keys->len, 0};
        if (!in_view(view->frame, &dot, radius_at(view, (uint32_t)i, view->to))) continue;
        add_keys(view, (uint32_t)i, samples);
        dot.keys = view->keys->len - dot.first;
        for (guint j = dot.first; j < view->keys->len; j++) {
            Key *key = &g_array_index(view->keys, Key, j);
            key->value = hundredth(key->value);
        }
        g_array_append_val(view->dots, dot);
    }
    g_array_sort_with_data(view->dots, dot_order, view);
}

/* The dots that were made since share the keys of `dot`. */
static void draw_alike(Canvas *canvas, const View *view, const Dot *dot)
{
    const Key *radii = &g_array_index(view->keys, Key, dot->first);
    g_autoptr(GArray) widths = g_array_new(FALSE, FALSE, sizeof(Key));
    for (guint i = 0; i < dot->keys; i++) add_key(widths, radii[i].time, 2 * radii[i].value);
    if (dot->keys > 1) canvas_animate(canvas, PROPERTY_PEN_WIDTH, (const Key *)widths->data, widths->len);
    canvas_stroke(canvas, &(Pen){view->style->colour, g_array_index(widths, Key, widths->len - 1).value, TRUE, 0, 0});
}

static void draw(Canvas *canvas, View *view)
{
    view->scale = view->frame->width / (view->frame->x_high - view->frame->x_low);
    view->keys = g_array_new(FALSE, FALSE, sizeof(Key));
    view->dots = g_array_new(FALSE, FALSE, sizeof(Dot));
    add_dots(view);
    for (guint i = 0; i < view->dots->len; i++) {
        const Dot *dot = &g_array_index(view->dots, Dot, i), *next = i + 1 < view->dots->len ? dot + 1 : NULL;
        if (next && dot_order(dot, next, view) == 0) continue;
        canvas_dot(canvas, dot->x, dot->y); /* NOLINT(clang-analyzer-core.NullDereference): an array with elements has data */
        if (!next || key_order(view, dot, next) != 0) draw_alike(canvas, view, dot);
    }
    g_array_unref(view->dots);
    g_array_unref(view->keys);
}

void plot_discs_fill(Canvas *canvas, const Frame *frame, const tdsp_scene *scene, double time, const DiscsStyle *style)
{
    draw(canvas, &(View){.frame = frame, .scene = scene, .style = style, .from = time, .to = time});
}

void plot_discs_grow(Canvas *canvas, const Frame *frame, const tdsp_scene *scene, const DiscsStyle *style)
{
    const Timeline *timeline = canvas_timeline(canvas);
    draw(canvas, &(View){.frame = frame, .scene = scene, .style = style, .from = timeline->from, .to = timeline->to});
}
