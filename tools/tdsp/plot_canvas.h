/* SPDX-License-Identifier: MIT */
/* Something to draw on that becomes an SVG or PNG file, text on it, and the colours of all pictures. */
#ifndef PLOT_CANVAS_H
#define PLOT_CANVAS_H

#include <cairo.h>
#include <glib.h>

/* Of the palette of Okabe and Ito, which people of every colour vision tell apart, and tints of it. */
enum {
    PLOT_INK = 0x222222,
    PLOT_GREY = 0x6b6b6b,
    PLOT_GRID = 0xe9e9e9,
    PLOT_PAPER = 0xffffff,
    PLOT_DISC = 0xe69f00,         /* a disc at departure: orange */
    PLOT_DISC_LATER = 0xfbecc9,   /* what it covers at arrival */
    PLOT_DISC_OUTLINE = 0xc98b00, /* its edge then */
    PLOT_PATH = 0x0072b2,         /* blue */
    PLOT_PATH_TINT = 0x9fcbe6,
    PLOT_ALARM = 0xd55e00, /* vermilion: jumps, the end */
};

#define PLOT_TEXT 13.0 /* size of ordinary text */

typedef struct Canvas {
    cairo_surface_t *surface;
    cairo_t *cr;
    GByteArray *svg; /* what the SVG surface wrote; NULL for PNG */
    double width, height;
} Canvas;

/* Does the file's ending name a kind of picture? */
gboolean canvas_check_name(const char *path, GError **error);

/* A white canvas for `path`; lengths are in points of SVG; a PNG has two pixels for each. */
gboolean canvas_begin(Canvas *canvas, const char *path, double width, double height, GError **error);
/* Write it to `path`. */
gboolean canvas_write(Canvas *canvas, const char *path, GError **error);
void canvas_clear(Canvas *canvas);
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC(Canvas, canvas_clear)

void canvas_colour(cairo_t *cr, guint32 rgb);

typedef struct TextStyle {
    double size;
    gboolean bold;
    guint32 colour;
    double across; /* 0: the point is at the text's left end, 0.5 its middle, 1 its right end */
    double up;     /* 0: at the base line, 0.5: at the middle of a digit, 1: at its top */
    gboolean halo; /* white around it, so that it stands out from what is below */
} TextStyle;

void canvas_text(cairo_t *cr, double x, double y, const TextStyle *style, const char *text);
/* Made smaller where it would be wider than `width`. */
void canvas_text_within(cairo_t *cr, double x, double y, double width, const TextStyle *style, const char *text);
/* Turned to read upwards. */
void canvas_text_upwards(cairo_t *cr, double x, double y, const TextStyle *style, const char *text);
double canvas_text_width(cairo_t *cr, const TextStyle *style, const char *text);

#endif
