/* SPDX-License-Identifier: MIT */
/*
 * Placing labels: twelve places around a point are tried, and the one that hides least of the lines wins; or places beside a line that
 * stands upright, of which only one will do that hides nothing.
 */
#include "plot_labels.h"

#include <math.h>

#define PLACES 12
#define BEYOND 26.0 /* past the ends of an upright line */
#define SHIFT 3.0   /* from one place beside it to the next */
#define APART 1.5   /* above and below a label beside a line stays free */

typedef struct Box {
    double left, top, right, bottom;
} Box;

Labels labels_new(const Frame *frame)
{
    return (Labels){frame, g_array_new(FALSE, FALSE, sizeof(Box)), g_array_new(FALSE, FALSE, sizeof(tdsp_point))};
}

void labels_clear(Labels *labels)
{
    g_clear_pointer(&labels->boxes, g_array_unref);
    g_clear_pointer(&labels->obstacles, g_array_unref);
}

void labels_add_mark(Labels *labels, double x, double y, double radius)
{
    labels_add_box(labels, x - radius, y - radius, x + radius, y + radius);
}

void labels_add_box(Labels *labels, double left, double top, double right, double bottom)
{
    Box box = {left, top, right, bottom};
    g_array_append_val(labels->boxes, box);
}

void labels_add_obstacle(Labels *labels, double x, double y)
{
    tdsp_point point = {x, y};
    g_array_append_val(labels->obstacles, point);
}

static gboolean apart(const Box *one, const Box *other)
{
    return one->right < other->left || other->right < one->left || one->bottom < other->top || other->bottom < one->top;
}

static gboolean is_free(const Labels *labels, const Box *box)
{
    const Frame *frame = labels->frame;
    if (box->left < frame->left + 3 || box->right > frame->left + frame->width - 3) return FALSE;
    if (box->top < frame->top + 3 || box->bottom > frame->top + frame->height - 3) return FALSE;
    for (guint i = 0; i < labels->boxes->len; i++)
        if (!apart(box, &g_array_index(labels->boxes, Box, i))) return FALSE;
    return TRUE;
}

static guint hidden(const Labels *labels, const Box *box)
{
    guint count = 0;
    for (guint i = 0; i < labels->obstacles->len; i++) {
        const tdsp_point *point = &g_array_index(labels->obstacles, tdsp_point, i);
        count += point->x > box->left && point->x < box->right && point->y > box->top && point->y < box->bottom;
    }
    return count;
}

/* The box of a text of this width whose nearest side is `distance` away in direction `angle`. */
static Box box_at(double x, double y, double distance, double angle, double width, double height)
{
    double middle_x = x + cos(angle) * (distance + width / 2), middle_y = y + sin(angle) * (distance + height / 2);
    return (Box){middle_x - width / 2, middle_y - height / 2, middle_x + width / 2, middle_y + height / 2};
}

/* 0, 1, -1, 2, -2, ... twelfths of a turn: the wanted direction first, the opposite one last. */
static double turned(double angle, int place)
{
    int twelfths = place % 2 == 1 ? (place + 1) / 2 : -(place / 2);
    return angle + 2 * G_PI * twelfths / PLACES;
}

static void write_in(Labels *labels, Canvas *canvas, const Box *box, const TextStyle *style, const char *text)
{
    TextStyle placed = *style;
    placed.across = placed.up = 0.5;
    canvas_text(canvas, (box->left + box->right) / 2, (box->top + box->bottom) / 2, &placed, text);
    g_array_append_val(labels->boxes, *box);
}

gboolean labels_write(Labels *labels, Canvas *canvas, double x, double y, double distance, double angle, const TextStyle *style,
                      const char *text)
{
    double width = canvas_text_width(canvas, style, text) + 4, height = style->size + 2;
    guint least = G_MAXUINT;
    Box best = {0, 0, 0, 0};
    for (int i = 0; i < PLACES; i++) {
        Box box = box_at(x, y, distance, turned(angle, i), width, height);
        guint cost = is_free(labels, &box) ? hidden(labels, &box) : G_MAXUINT;
        if (cost >= least) continue;
        least = cost;
        best = box;
    }
    if (least == G_MAXUINT) return FALSE;
    write_in(labels, canvas, &best, style, text);
    return TRUE;
}

gboolean labels_write_beside(Labels *labels, Canvas *canvas, double x, double top, double bottom, double distance, const TextStyle *style,
                             const char *text)
{
    double width = canvas_text_width(canvas, style, text) + 4, half = style->size / 2 + 1 + APART, reach = (bottom - top) / 2 + BEYOND;
    for (int i = 0; SHIFT * (i / 4) <= reach; i++) {
        double y = (top + bottom) / 2 + (i % 4 < 2 ? -1 : 1) * SHIFT * (i / 4);
        double left = i % 2 == 0 ? x + distance : x - distance - width;
        Box box = {left, y - half, left + width, y + half};
        if (!is_free(labels, &box) || hidden(labels, &box) > 0) continue;
        write_in(labels, canvas, &box, style, text);
        return TRUE;
    }
    return FALSE;
}
