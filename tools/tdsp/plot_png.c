/* SPDX-License-Identifier: MIT */
/* Pictures of pixels, by cairo. */
#include "plot_backend.h"

static void set_colour(cairo_t *cr, guint32 rgb)
{
    cairo_set_source_rgb(cr, (rgb >> 16) / 255.0, (rgb >> 8 & 0xff) / 255.0, (rgb & 0xff) / 255.0);
}

static void begin(Canvas *canvas)
{
    set_colour(canvas->cr, PLOT_PAPER);
    cairo_paint(canvas->cr);
    cairo_scale(canvas->cr, BACKEND_SCALE, BACKEND_SCALE);
}

static void trace_piece(cairo_t *cr, const Piece *piece)
{
    tdsp_point to = piece->to;
    switch (piece->kind) {
    case PIECE_MOVE: cairo_move_to(cr, to.x, to.y); break;
    case PIECE_LINE: cairo_line_to(cr, to.x, to.y); break;
    case PIECE_CURVE: cairo_curve_to(cr, piece->first.x, piece->first.y, piece->second.x, piece->second.y, to.x, to.y); break;
    case PIECE_CLOSE: cairo_close_path(cr); break;
    case PIECE_CIRCLE:
        cairo_new_sub_path(cr);
        cairo_arc(cr, to.x, to.y, piece->radius, 0, 2 * G_PI);
        break;
    case PIECE_DOT:
        cairo_move_to(cr, to.x, to.y);
        cairo_line_to(cr, to.x, to.y);
        break;
    }
}

static void stroke(cairo_t *cr, const Pen *pen)
{
    const double dashes[] = {pen->dash, pen->space};
    set_colour(cr, pen->colour);
    cairo_set_line_width(cr, pen->width);
    cairo_set_line_cap(cr, pen->round ? CAIRO_LINE_CAP_ROUND : CAIRO_LINE_CAP_BUTT);
    cairo_set_line_join(cr, pen->round ? CAIRO_LINE_JOIN_ROUND : CAIRO_LINE_JOIN_MITER);
    cairo_set_dash(cr, dashes, pen->dash > 0 ? 2 : 0, 0);
    cairo_stroke(cr);
}

static void draw_shape(Canvas *canvas, const Shape *shape)
{
    for (guint i = 0; i < shape->pieces->len; i++) trace_piece(canvas->cr, &g_array_index(shape->pieces, Piece, i));
    if (shape->fill) {
        set_colour(canvas->cr, *shape->fill);
        cairo_fill_preserve(canvas->cr);
    }
    if (shape->pen) stroke(canvas->cr, shape->pen);
    cairo_new_path(canvas->cr);
}

static void draw_words(Canvas *canvas, const Words *words)
{
    const Pen halo = {PLOT_PAPER, BACKEND_HALO, TRUE, 0, 0};
    cairo_t *cr = canvas->cr;
    cairo_save(cr);
    cairo_translate(cr, words->x, words->base);
    if (words->upwards) cairo_rotate(cr, -G_PI / 2);
    backend_choose_font(cr, words->style);
    if (words->style->halo) {
        cairo_move_to(cr, 0, 0);
        cairo_text_path(cr, words->text);
        stroke(cr, &halo);
    }
    cairo_move_to(cr, 0, 0);
    set_colour(cr, words->style->colour);
    cairo_show_text(cr, words->text);
    cairo_new_path(cr);
    cairo_restore(cr);
}

static void clip(Canvas *canvas, double x, double y, double width, double height)
{
    cairo_save(canvas->cr);
    cairo_rectangle(canvas->cr, x, y, width, height);
    cairo_clip(canvas->cr);
}

static void unclip(Canvas *canvas)
{
    cairo_restore(canvas->cr);
}

static cairo_status_t append(void *bytes, const unsigned char *data, unsigned int length)
{
    g_byte_array_append(bytes, data, length);
    return CAIRO_STATUS_SUCCESS;
}

static gboolean finish(Canvas *canvas, GByteArray *file, GError **error)
{
    cairo_status_t status = cairo_status(canvas->cr);
    if (status == CAIRO_STATUS_SUCCESS) status = cairo_surface_write_to_png_stream(canvas->surface, append, file);
    return status == CAIRO_STATUS_SUCCESS ? TRUE : backend_fail_cairo(status, error);
}

const Backend backend_png = {begin, draw_shape, draw_words, clip, unclip, finish};
