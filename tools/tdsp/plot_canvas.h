/* SPDX-License-Identifier: MIT */
/*
 * Something to draw on that becomes an SVG or PNG file, text on it, and the colours of all pictures.
 *
 * What a picture shows is told once, as shapes and text; a back end for each kind of file (plot_backend.h) draws them. A canvas with a
 * timeline is a moving picture: what belongs to one layer only is drawn between canvas_layer_begin() and _end(), and what is told by
 * canvas_animate() moves the next shape.
 */
#ifndef PLOT_CANVAS_H
#define PLOT_CANVAS_H

#include <glib.h>

#include "tdsp/types.h"

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
    PLOT_BESIDE = 0x9a4f80, /* reddish purple, darkened: the second journey of a picture */
    PLOT_BESIDE_TINT = 0xdcbdd0,
    PLOT_ALARM = 0xd55e00,      /* vermilion: jumps, the end */
    PLOT_ALARM_TEXT = 0xb24a00, /* words about them: darker, to be read on white */
};

#define PLOT_TEXT 13.0 /* size of ordinary text */

/* How the time of a scene becomes the time of a moving picture: evenly from `from` to `to`, then it rests, then it begins anew. */
typedef struct Timeline {
    double from, to;      /* of the scene */
    double seconds, rest; /* of the picture */
} Timeline;

/* The share of a round at which a time of the scene is shown. */
double timeline_share(const Timeline *timeline, double time);

typedef struct Canvas Canvas;

/* Does the file's ending name a kind of picture, and one that can move where it is to? */
gboolean canvas_check_name(const char *path, gboolean moving, GError **error);

/* A white canvas for `path`; lengths are in points of SVG; a PNG has two pixels for each. `timeline`, which is copied, makes it move; NULL: it is still. */
Canvas *canvas_new(const char *path, double width, double height, const Timeline *timeline, GError **error);
/* What the picture shows, for those who do not see it. */
void canvas_describe(Canvas *canvas, const char *text);
/* Write it to the path given. */
gboolean canvas_write(Canvas *canvas, GError **error);
void canvas_free(Canvas *canvas);
G_DEFINE_AUTOPTR_CLEANUP_FUNC(Canvas, canvas_free)

double canvas_width(const Canvas *canvas);

const Timeline *canvas_timeline(const Canvas *canvas); /* NULL: still */

/* ------------------------------------------------------------------------------------------------------------- shapes */

/* Shapes are made of these, until one of the functions below draws what was made. */
void canvas_move_to(Canvas *canvas, double x, double y);
void canvas_line_to(Canvas *canvas, double x, double y);
/* A cubic Bézier curve. */
void canvas_curve_to(Canvas *canvas, tdsp_point first, tdsp_point second, tdsp_point to);
void canvas_close(Canvas *canvas);
void canvas_circle(Canvas *canvas, double x, double y, double radius);
/* A line of no length: with a round pen a disc as wide as the pen. */
void canvas_dot(Canvas *canvas, double x, double y);
void canvas_rectangle(Canvas *canvas, double x, double y, double width, double height);

typedef struct Pen {
    guint32 colour;
    double width;
    gboolean round;     /* ends and corners */
    double dash, space; /* 0: not dashed */
} Pen;

void canvas_fill(Canvas *canvas, guint32 colour);
void canvas_stroke(Canvas *canvas, const Pen *pen);
void canvas_fill_and_stroke(Canvas *canvas, guint32 colour, const Pen *pen);

/* Keep what is drawn next inside a rectangle, until canvas_unclip(). */
void canvas_clip(Canvas *canvas, double x, double y, double width, double height);
void canvas_unclip(Canvas *canvas);

/* --------------------------------------------------------------------------------------------------------------- text */

typedef struct TextStyle {
    double size;
    gboolean bold;
    guint32 colour;
    double across; /* 0: the point is at the text's left end, 0.5 its middle, 1 its right end */
    double up;     /* 0: at the base line, 0.5: at the middle of a digit, 1: at its top */
    gboolean halo; /* white around it, so that it stands out from what is below */
} TextStyle;

void canvas_text(Canvas *canvas, double x, double y, const TextStyle *style, const char *text);
/* Made smaller where it would be wider than `width`. */
void canvas_text_within(Canvas *canvas, double x, double y, double width, const TextStyle *style, const char *text);
/* Turned to read upwards. */
void canvas_text_upwards(Canvas *canvas, double x, double y, const TextStyle *style, const char *text);
double canvas_text_width(const Canvas *canvas, const TextStyle *style, const char *text);

/* ------------------------------------------------------------------------------------------------------------- moving */

/* Where a moving picture is shown to somebody who wants none, the still layer stands in for the moving one. */
typedef enum Layer { LAYER_STILL, LAYER_MOVING } Layer;

/* What is drawn until canvas_layer_end() belongs to one layer. On a canvas that is still there is only the still layer. */
void canvas_layer_begin(Canvas *canvas, Layer layer);
void canvas_layer_end(Canvas *canvas);

/* The value of a property from a moment of the scene on. */
typedef struct Key {
    double time;
    double value;
} Key;

/* The properties that can change. */
typedef enum Property {
    PROPERTY_PEN_WIDTH,
    PROPERTY_RADIUS,
    PROPERTY_SHOWN, /* 1 or 0, without anything between */
    PROPERTY_DRAWN, /* how much of a line, from its beginning: 0 to 1 of it */
    PROPERTY_OPACITY
} Property;

/* Let a property of the next shape or text go evenly from key to key, as it is before the first and after the last. On a moving canvas only. */
void canvas_animate(Canvas *canvas, Property property, const Key *keys, gsize count);

/* What is drawn until canvas_appear_end() is seen from a moment of the scene on; never where that is after the end. A still canvas shows it. */
void canvas_appear_begin(Canvas *canvas, double time);
void canvas_appear_end(Canvas *canvas);

/* Until canvas_ride_end() what is drawn at (0, 0) goes along the shape that was made, evenly from one time of the scene to another. */
void canvas_ride_begin(Canvas *canvas, double from, double to);
void canvas_ride_end(Canvas *canvas);

#endif
