/* SPDX-License-Identifier: MIT */
/*
 * Pictures as SVG, and those that move by its animations (SMIL), which browsers play without any script, in an <img> too.
 *
 * All animations have one duration, a round of the timeline, and begin when the picture is loaded, so they never drift apart. What does not play
 * them shows the values that the attributes have, which are those at the end. Coordinates are rounded to hundredths of a point.
 */
#include <math.h>
#include <string.h>

#include "plot_backend.h"

#define FONTS "DejaVu Sans,Verdana,Arial,sans-serif"

/* At most so many digits after the point, and none that say nothing. */
static void append_number(GString *out, double value, int digits)
{
    char format[8], buffer[G_ASCII_DTOSTR_BUF_SIZE * 16];
    g_snprintf(format, sizeof format, "%%.%df", digits);
    g_ascii_formatd(buffer, sizeof buffer, format, value);
    char *end = buffer + strlen(buffer);
    while (end[-1] == '0') *--end = '\0';
    if (end[-1] == '.') end[-1] = '\0';
    g_string_append(out, strcmp(buffer, "-0") == 0 ? "0" : buffer);
}

static void append_attribute(GString *out, const char *name, double value)
{
    g_string_append_printf(out, " %s=\"", name);
    append_number(out, value, 2);
    g_string_append_c(out, '"');
}

static void append_colour(GString *out, const char *name, guint32 colour)
{
    g_string_append_printf(out, " %s=\"#%06x\"", name, colour);
}

static void append_escaped(GString *out, const char *text)
{
    g_autofree char *escaped = g_markup_escape_text(text, -1);
    g_string_append(out, escaped);
}

static void begin(Canvas *canvas)
{
    canvas->svg = g_string_new(NULL);
    canvas->attributes = g_string_new(NULL);
    canvas->animations = g_string_new(NULL);
}

/* ------------------------------------------------------------------------------------------------------------- shapes */

static void append_point(GString *out, char letter, tdsp_point point)
{
    g_string_append_c(out, letter);
    append_number(out, point.x, 2);
    g_string_append_c(out, ' ');
    append_number(out, point.y, 2);
}

/* Two half turns: an arc that ends where it begins would be none. */
static void append_circle(GString *out, const Piece *circle)
{
    g_autoptr(GString) radius = g_string_new(NULL);
    append_number(radius, circle->radius, 2);
    append_point(out, 'M', (tdsp_point){circle->to.x - circle->radius, circle->to.y});
    for (int half = 0; half < 2; half++) {
        g_string_append_printf(out, "a%s %s 0 0 1 ", radius->str, radius->str);
        append_number(out, half == 0 ? 2 * circle->radius : -2 * circle->radius, 2);
        g_string_append(out, " 0");
    }
    g_string_append_c(out, 'z');
}

static void append_piece(GString *out, const Piece *piece)
{
    switch (piece->kind) {
    case PIECE_MOVE: append_point(out, 'M', piece->to); break;
    case PIECE_LINE: append_point(out, 'L', piece->to); break;
    case PIECE_CURVE:
        append_point(out, 'C', piece->first);
        append_point(out, ' ', piece->second);
        append_point(out, ' ', piece->to);
        break;
    case PIECE_CLOSE: g_string_append_c(out, 'z'); break;
    case PIECE_CIRCLE: append_circle(out, piece); break;
    case PIECE_DOT:
        append_point(out, 'M', piece->to);
        g_string_append(out, "h0");
        break;
    }
}

static void append_pieces(GString *out, const GArray *pieces)
{
    for (guint i = 0; i < pieces->len; i++) append_piece(out, &g_array_index(pieces, Piece, i));
}

static void append_pen(GString *out, const Pen *pen)
{
    append_colour(out, "stroke", pen->colour);
    append_attribute(out, "stroke-width", pen->width);
    if (pen->round) g_string_append(out, " stroke-linecap=\"round\" stroke-linejoin=\"round\"");
    if (!(pen->dash > 0)) return;
    g_string_append(out, " stroke-dasharray=\"");
    append_number(out, pen->dash, 2);
    g_string_append_c(out, ' ');
    append_number(out, pen->space, 2);
    g_string_append_c(out, '"');
}

/* End the tag of an element without content, with what was to be told of the next one. */
static void end_element(Canvas *canvas, const char *name)
{
    g_string_append_len(canvas->svg, canvas->attributes->str, (gssize)canvas->attributes->len);
    if (canvas->animations->len == 0)
        g_string_append(canvas->svg, "/>\n");
    else
        g_string_append_printf(canvas->svg, ">%s</%s>\n", canvas->animations->str, name);
    g_string_truncate(canvas->attributes, 0);
    g_string_truncate(canvas->animations, 0);
}

static void draw_shape(Canvas *canvas, const Shape *shape)
{
    gboolean circle = shape->pieces->len == 1 && g_array_index(shape->pieces, Piece, 0).kind == PIECE_CIRCLE;
    if (circle) {
        const Piece *only = &g_array_index(shape->pieces, Piece, 0);
        g_string_append(canvas->svg, "<circle");
        append_attribute(canvas->svg, "cx", only->to.x);
        append_attribute(canvas->svg, "cy", only->to.y);
        append_attribute(canvas->svg, "r", only->radius);
    } else {
        g_string_append(canvas->svg, "<path d=\"");
        append_pieces(canvas->svg, shape->pieces);
        g_string_append_c(canvas->svg, '"');
    }
    if (shape->fill) append_colour(canvas->svg, "fill", *shape->fill);
    if (shape->pen) append_pen(canvas->svg, shape->pen);
    end_element(canvas, circle ? "circle" : "path");
}

static void draw_words(Canvas *canvas, const Words *words)
{
    const TextStyle *style = words->style;
    GString *svg = canvas->svg;
    g_string_append(svg, "<text");
    append_attribute(svg, "x", words->x);
    append_attribute(svg, "y", words->base);
    append_attribute(svg, "font-size", style->size);
    if (style->bold) g_string_append(svg, " font-weight=\"bold\"");
    if (words->upwards) {
        g_string_append(svg, " transform=\"rotate(-90 ");
        append_number(svg, words->x, 2);
        g_string_append_c(svg, ' ');
        append_number(svg, words->base, 2);
        g_string_append(svg, ")\"");
    }
    append_colour(svg, "fill", style->colour);
    if (style->halo) {
        append_pen(svg, &(Pen){PLOT_PAPER, BACKEND_HALO, TRUE, 0, 0});
        g_string_append(svg, " paint-order=\"stroke\"");
    }
    g_string_append_printf(svg, "%s>%s", canvas->attributes->str, canvas->animations->str);
    append_escaped(svg, words->text);
    g_string_append(svg, "</text>\n");
    g_string_truncate(canvas->attributes, 0);
    g_string_truncate(canvas->animations, 0);
}

/* Named by what it is: two pictures of one page have the same name for it only where they mean the same. */
static void clip(Canvas *canvas, double x, double y, double width, double height)
{
    static const char *const names[] = {"x", "y", "width", "height"};
    const double values[] = {x, y, width, height};
    g_autoptr(GString) name = g_string_new("clip");
    for (int i = 0; i < 4; i++) {
        g_string_append_c(name, '-');
        append_number(name, values[i], 2);
    }
    g_string_append_printf(canvas->svg, "<clipPath id=\"%s\"><rect", name->str);
    for (int i = 0; i < 4; i++) append_attribute(canvas->svg, names[i], values[i]);
    g_string_append_printf(canvas->svg, "/></clipPath>\n<g clip-path=\"url(#%s)\">\n", name->str);
}

static void unclip(Canvas *canvas)
{
    g_string_append(canvas->svg, "</g>\n");
}

/* ------------------------------------------------------------------------------------------------------------- moving */

/* The keys of a round: from its very beginning to its very end, for it ends with a rest. */
typedef struct Round {
    GString *shares, *values;
} Round;

static void append_value(GString *out, Property property, double value)
{
    if (property == PROPERTY_SHOWN)
        g_string_append(out, value > 0 ? "visible" : "hidden");
    else
        append_number(out, value, 2);
    if (property == PROPERTY_DRAWN) g_string_append(out, " 2"); /* a dash, and a space longer than the line */
}

static void round_add(Round *round, Property property, double share, double value)
{
    const char *between = round->shares->len > 0 ? ";" : "";
    g_string_append(round->shares, between);
    append_number(round->shares, share, 6);
    g_string_append(round->values, between);
    append_value(round->values, property, value);
}

static Round round_of(const Timeline *timeline, Property property, const Key *keys, gsize count)
{
    Round round = {g_string_new(NULL), g_string_new(NULL)};
    if (timeline_share(timeline, keys[0].time) > 0) round_add(&round, property, 0, keys[0].value);
    for (gsize i = 0; i < count; i++) round_add(&round, property, timeline_share(timeline, keys[i].time), keys[i].value);
    round_add(&round, property, 1, keys[count - 1].value);
    return round;
}

static void round_clear(Round *round)
{
    g_string_free(round->shares, TRUE);
    g_string_free(round->values, TRUE);
}

/* What all animations have alike. */
static void append_round(GString *out, const Round *round, const Timeline *timeline)
{
    g_string_append_printf(out, " keyTimes=\"%s\" dur=\"", round->shares->str);
    append_number(out, timeline->seconds + timeline->rest, 3);
    g_string_append(out, "s\" repeatCount=\"indefinite\"/>");
}

static void append_animate(GString *out, const Timeline *timeline, Property property, const Key *keys, gsize count)
{
    static const char *const names[] = {"stroke-width", "r", "visibility", "stroke-dasharray", "opacity"};
    Round round = round_of(timeline, property, keys, count);
    g_string_append_printf(out, "<animate attributeName=\"%s\"%s values=\"%s\"", names[property],
                           property == PROPERTY_SHOWN ? " calcMode=\"discrete\"" : "", round.values->str);
    append_round(out, &round, timeline);
    round_clear(&round);
}

/* What an element has while nothing moves. What is drawn of a line is a dash of it, with its length for a unit. */
static void append_resting(GString *out, Property property, double value)
{
    if (property == PROPERTY_DRAWN) g_string_append(out, " pathLength=\"1\"");
    if (property == PROPERTY_SHOWN && !(value > 0)) g_string_append(out, " visibility=\"hidden\"");
    if (property == PROPERTY_OPACITY) append_attribute(out, "opacity", value);
}

void svg_animate(Canvas *canvas, Property property, const Key *keys, gsize count)
{
    append_animate(canvas->animations, &canvas->timeline, property, keys, count);
    append_resting(canvas->attributes, property, keys[count - 1].value);
}

void svg_layer_begin(Canvas *canvas, Layer layer)
{
    g_string_append_printf(canvas->svg, "<g class=\"%s\">\n", layer == LAYER_STILL ? "still" : "moving");
}

void svg_appear_begin(Canvas *canvas, double time)
{
    const Key keys[] = {{canvas->timeline.from, time <= canvas->timeline.from}, {time, time <= canvas->timeline.to}};
    g_string_append(canvas->svg, "<g class=\"appearing\">");
    append_animate(canvas->svg, &canvas->timeline, PROPERTY_SHOWN, keys, G_N_ELEMENTS(keys));
    g_string_append_c(canvas->svg, '\n');
}

void svg_ride_begin(Canvas *canvas, double from, double to)
{
    const Key keys[] = {{from, 0}, {to, 1}};
    Round round = round_of(&canvas->timeline, PROPERTY_RADIUS, keys, G_N_ELEMENTS(keys)); /* a share of the way is a number like a radius */
    g_string_append(canvas->svg, "<g><animateMotion path=\"");
    append_pieces(canvas->svg, canvas->pieces);
    g_string_append_printf(canvas->svg, "\" calcMode=\"linear\" keyPoints=\"%s\"", round.values->str);
    append_round(canvas->svg, &round, &canvas->timeline);
    g_string_append_c(canvas->svg, '\n');
    round_clear(&round);
}

void svg_group_end(Canvas *canvas)
{
    g_string_append(canvas->svg, "</g>\n");
}

/* ---------------------------------------------------------------------------------------------------------- the file */

/* Where less motion is asked for, the still layer is shown; what knows no style shows both, which then look the same. */
static const char layers[] = "<style>.still{display:none}@media(prefers-reduced-motion:reduce)"
                             "{.still{display:inline}.moving{display:none}.appearing{visibility:visible!important}}</style>\n";

static void append_head(GString *out, const Canvas *canvas)
{
    g_string_append(out, "<svg xmlns=\"http://www.w3.org/2000/svg\"");
    append_attribute(out, "width", canvas->width);
    append_attribute(out, "height", canvas->height);
    g_string_append(out, " viewBox=\"0 0 ");
    append_number(out, canvas->width, 2);
    g_string_append_c(out, ' ');
    append_number(out, canvas->height, 2);
    g_string_append(out, "\" role=\"img\" fill=\"none\" font-family=\"" FONTS "\">\n<title>");
    append_escaped(out, canvas->description);
    g_string_append(out, "</title>\n");
    if (canvas->moves) g_string_append(out, layers);
    g_string_append(out, "<rect width=\"100%\" height=\"100%\"");
    append_colour(out, "fill", PLOT_PAPER);
    g_string_append(out, "/>\n");
}

static gboolean finish(Canvas *canvas, GByteArray *file, GError **error)
{
    cairo_status_t measured = cairo_status(canvas->cr);
    if (measured != CAIRO_STATUS_SUCCESS) return backend_fail_cairo(measured, error);
    g_autoptr(GString) head = g_string_new("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n");
    append_head(head, canvas);
    g_string_append(canvas->svg, "</svg>\n");
    g_byte_array_append(file, (const guint8 *)head->str, (guint)head->len);
    g_byte_array_append(file, (const guint8 *)canvas->svg->str, (guint)canvas->svg->len);
    return TRUE;
}

const Backend backend_svg = {begin, draw_shape, draw_words, clip, unclip, finish};
