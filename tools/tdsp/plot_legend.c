/* SPDX-License-Identifier: MIT */
/* Legends. */
#include "plot_legend.h"

#define LINE_HEIGHT 22.0
#define BEFORE_NAME 7.0
#define BETWEEN 22.0

Legend legend_new(Canvas *canvas, double left, double right, double y)
{
    return (Legend){canvas, left, right, left, y};
}

double legend_item(Legend *legend, double sample, const char *name)
{
    const TextStyle style = {PLOT_TEXT, FALSE, PLOT_INK, 0, 0.5, FALSE};
    double width = sample + BEFORE_NAME + canvas_text_width(legend->canvas, &style, name);
    if (legend->x > legend->left && legend->x + width > legend->right) {
        legend->x = legend->left;
        legend->y += LINE_HEIGHT;
    }
    double begin = legend->x;
    canvas_text(legend->canvas, begin + sample + BEFORE_NAME, legend->y, &style, name);
    legend->x += width + BETWEEN;
    return begin;
}

void legend_disc(Legend *legend, guint32 fill, guint32 edge, const char *name)
{
    double x = legend_item(legend, 14, name);
    canvas_circle(legend->canvas, x + 7, legend->y, 6.5);
    canvas_fill_and_stroke(legend->canvas, fill, &(Pen){edge, 1, FALSE, 0, 0});
}

void legend_line(Legend *legend, const Pen *pen, const char *name)
{
    double x = legend_item(legend, 24, name);
    canvas_move_to(legend->canvas, x, legend->y);
    canvas_line_to(legend->canvas, x + 24, legend->y);
    canvas_stroke(legend->canvas, pen);
}
