/* SPDX-License-Identifier: MIT */
/* What a kind of picture has to do for the canvas, and what the canvas keeps for it. */
#ifndef PLOT_BACKEND_H
#define PLOT_BACKEND_H

#include <cairo.h>

#include "plot_canvas.h"

/* A piece of the shape being made. */
typedef enum PieceKind { PIECE_MOVE, PIECE_LINE, PIECE_CURVE, PIECE_CLOSE, PIECE_CIRCLE, PIECE_DOT } PieceKind;

typedef struct Piece {
    PieceKind kind;
    tdsp_point to;            /* where it leads; the centre of a circle; a dot's place */
    tdsp_point first, second; /* of a curve: its control points */
    double radius;            /* of a circle */
} Piece;

typedef struct Shape {
    const GArray *pieces; /* of Piece */
    const guint32 *fill;  /* NULL: not filled */
    const Pen *pen;       /* NULL: no line */
} Shape;

/* Text with its place worked out. */
typedef struct Words {
    double x, base; /* the left end of its base line */
    gboolean upwards;
    const TextStyle *style;
    const char *text;
} Words;

typedef struct Backend {
    void (*begin)(Canvas *canvas);
    void (*shape)(Canvas *canvas, const Shape *shape);
    void (*words)(Canvas *canvas, const Words *words);
    void (*clip)(Canvas *canvas, double x, double y, double width, double height);
    void (*unclip)(Canvas *canvas);
    /* What is drawn becomes the bytes of a file. */
    gboolean (*finish)(Canvas *canvas, GByteArray *file, GError **error);
} Backend;

extern const Backend backend_png, backend_svg;

struct Canvas {
    const Backend *backend;
    char *path, *description;
    double width, height;
    gboolean moves;
    Timeline timeline;
    GArray *pieces;           /* of Piece */
    cairo_surface_t *surface; /* what measures text, and of a PNG the picture */
    cairo_t *cr;
    GString *svg;             /* of an SVG: what is written, */
    GString *attributes, *animations; /* and what the next element gets */
};

/* The font of a style at its size. */
void backend_choose_font(cairo_t *cr, const TextStyle *style);

#define BACKEND_HALO 5.0 /* width of the white line around letters */
#define BACKEND_SCALE 2.0 /* pixels of a PNG for each point */

gboolean backend_fail_cairo(cairo_status_t status, GError **error);

/* Of a moving SVG only. */
void svg_layer_begin(Canvas *canvas, Layer layer);
void svg_appear_begin(Canvas *canvas, double time);
void svg_ride_begin(Canvas *canvas, double from, double to);
void svg_group_end(Canvas *canvas);
void svg_animate(Canvas *canvas, Property property, const Key *keys, gsize count);

#endif
