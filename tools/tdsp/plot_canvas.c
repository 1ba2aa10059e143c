/* SPDX-License-Identifier: MIT */
/*
 * The canvas: shapes in the making, the places of texts, and which back end draws. Texts are measured the same way for all of them, without
 * fitting letters to pixels, so that a picture has one layout whatever it becomes.
 */
#include <string.h>

#include "cli.h"
#include "file_out.h"
#include "plot_backend.h"

#define DIGIT_HEIGHT 0.73 /* of the usual sans-serif, as a share of its size */

double timeline_share(const Timeline *timeline, double time)
{
    double share = (time - timeline->from) / (timeline->to - timeline->from);
    return CLAMP(share, 0, 1) * timeline->seconds / (timeline->seconds + timeline->rest);
}

static gboolean ends_in(const char *path, const char *ending)
{
    g_autofree char *lower = g_ascii_strdown(path, -1);
    return g_str_has_suffix(lower, ending);
}

gboolean canvas_check_name(const char *path, gboolean moving, GError **error)
{
    if (ends_in(path, ".svg")) return TRUE;
    if (moving) return cli_fail(error, CLI_USAGE, "%s: a moving picture is an SVG, so the name must end in .svg (browsers play it)", path);
    if (ends_in(path, ".png")) return TRUE;
    if (ends_in(path, ".gif")) return cli_fail(error, CLI_USAGE, "%s: a moving picture is an SVG: -o FILE.svg --animate (browsers play it)", path);
    return cli_fail(error, CLI_USAGE, "%s: the name must end in .svg or .png, which says what to draw", path);
}

gboolean backend_fail_cairo(cairo_status_t status, GError **error)
{
    return cli_fail(error, CLI_SYSTEM, "cannot draw: %s", cairo_status_to_string(status));
}

/* The surface of a PNG, or one pixel to measure texts on. */
static void make_surface(Canvas *canvas, gboolean png)
{
    cairo_font_options_t *options = cairo_font_options_create();
    int width = png ? (int)(canvas->width * BACKEND_SCALE) : 1, height = png ? (int)(canvas->height * BACKEND_SCALE) : 1;
    canvas->surface = cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height);
    canvas->cr = cairo_create(canvas->surface);
    cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
    cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
    cairo_set_font_options(canvas->cr, options);
    cairo_font_options_destroy(options);
}

Canvas *canvas_new(const char *path, double width, double height, const Timeline *timeline, GError **error)
{
    gboolean png = !ends_in(path, ".svg");
    Canvas *canvas = g_new0(Canvas, 1);
    *canvas = (Canvas){.backend = png ? &backend_png : &backend_svg, .path = g_strdup(path), .width = width, .height = height, .moves = timeline != NULL};
    if (timeline) canvas->timeline = *timeline;
    canvas->pieces = g_array_new(FALSE, FALSE, sizeof(Piece));
    canvas->description = g_strdup("");
    make_surface(canvas, png);
    cairo_status_t status = cairo_status(canvas->cr);
    if (status != CAIRO_STATUS_SUCCESS) {
        backend_fail_cairo(status, error);
        canvas_free(canvas);
        return NULL;
    }
    canvas->backend->begin(canvas);
    return canvas;
}

gboolean canvas_write(Canvas *canvas, GError **error)
{
    g_autoptr(GByteArray) file = g_byte_array_new();
    return canvas->backend->finish(canvas, file, error) && file_out_write(canvas->path, file->data, file->len, error);
}

void canvas_free(Canvas *canvas)
{
    g_clear_pointer(&canvas->cr, cairo_destroy);
    g_clear_pointer(&canvas->surface, cairo_surface_destroy);
    g_clear_pointer(&canvas->pieces, g_array_unref);
    GString *const texts[] = {canvas->svg, canvas->attributes, canvas->animations};
    for (gsize i = 0; i < G_N_ELEMENTS(texts); i++)
        if (texts[i]) g_string_free(texts[i], TRUE);
    g_free(canvas->description);
    g_free(canvas->path);
    g_free(canvas);
}

double canvas_width(const Canvas *canvas)
{
    return canvas->width;
}

double canvas_height(const Canvas *canvas)
{
    return canvas->height;
}

const Timeline *canvas_timeline(const Canvas *canvas)
{
    return canvas->moves ? &canvas->timeline : NULL;
}

/* ------------------------------------------------------------------------------------------------------------- shapes */

static void add(Canvas *canvas, const Piece *piece)
{
    g_array_append_vals(canvas->pieces, piece, 1);
}

void canvas_move_to(Canvas *canvas, double x, double y)
{
    add(canvas, &(Piece){.kind = PIECE_MOVE, .to = {x, y}});
}

void canvas_line_to(Canvas *canvas, double x, double y)
{
    add(canvas, &(Piece){.kind = canvas->pieces->len > 0 ? PIECE_LINE : PIECE_MOVE, .to = {x, y}});
}

void canvas_curve_to(Canvas *canvas, tdsp_point first, tdsp_point second, tdsp_point to)
{
    add(canvas, &(Piece){.kind = PIECE_CURVE, .to = to, .first = first, .second = second});
}

void canvas_close(Canvas *canvas)
{
    add(canvas, &(Piece){.kind = PIECE_CLOSE});
}

void canvas_circle(Canvas *canvas, double x, double y, double radius)
{
    add(canvas, &(Piece){.kind = PIECE_CIRCLE, .to = {x, y}, .radius = radius});
}

void canvas_dot(Canvas *canvas, double x, double y)
{
    add(canvas, &(Piece){.kind = PIECE_DOT, .to = {x, y}});
}

void canvas_rectangle(Canvas *canvas, double x, double y, double width, double height)
{
    canvas_move_to(canvas, x, y);
    canvas_line_to(canvas, x + width, y);
    canvas_line_to(canvas, x + width, y + height);
    canvas_line_to(canvas, x, y + height);
    canvas_close(canvas);
}

static void draw(Canvas *canvas, const guint32 *fill, const Pen *pen)
{
    if (canvas->pieces->len > 0) canvas->backend->shape(canvas, &(Shape){canvas->pieces, fill, pen});
    g_array_set_size(canvas->pieces, 0);
}

void canvas_fill(Canvas *canvas, guint32 colour)
{
    draw(canvas, &colour, NULL);
}

void canvas_stroke(Canvas *canvas, const Pen *pen)
{
    draw(canvas, NULL, pen);
}

void canvas_fill_and_stroke(Canvas *canvas, guint32 colour, const Pen *pen)
{
    draw(canvas, &colour, pen);
}

void canvas_clip(Canvas *canvas, double x, double y, double width, double height)
{
    canvas->backend->clip(canvas, x, y, width, height);
}

void canvas_unclip(Canvas *canvas)
{
    canvas->backend->unclip(canvas);
}

/* --------------------------------------------------------------------------------------------------------------- text */

void backend_choose_font(cairo_t *cr, const TextStyle *style)
{
    cairo_select_font_face(cr, "sans-serif", CAIRO_FONT_SLANT_NORMAL,
                           style->bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(cr, style->size);
}

/* Names in files may have bytes and characters that are none for fonts, nor for XML. */
static char *printable(const char *text)
{
    g_autofree char *valid = g_utf8_make_valid(text, -1);
    GString *shown = g_string_sized_new(strlen(valid));
    for (const char *at = valid; *at; at = g_utf8_next_char(at)) {
        gunichar character = g_utf8_get_char(at);
        g_string_append_unichar(shown, g_unichar_isprint(character) ? character : 0xfffd);
    }
    return g_string_free(shown, FALSE);
}

double canvas_text_width(const Canvas *canvas, const TextStyle *style, const char *text)
{
    cairo_text_extents_t extents;
    g_autofree char *shown = printable(text);
    backend_choose_font(canvas->cr, style);
    cairo_text_extents(canvas->cr, shown, &extents);
    return extents.x_advance;
}

void canvas_text(Canvas *canvas, double x, double y, const TextStyle *style, const char *text)
{
    g_autofree char *shown = printable(text);
    double width = style->across > 0 ? canvas_text_width(canvas, style, shown) : 0;
    canvas->backend->words(canvas, &(Words){x - style->across * width, y + style->up * DIGIT_HEIGHT * style->size, FALSE, style, shown});
}

void canvas_text_within(Canvas *canvas, double x, double y, double width, const TextStyle *style, const char *text)
{
    TextStyle fitting = *style;
    double needed = canvas_text_width(canvas, style, text);
    if (needed > width) fitting.size *= width / needed;
    canvas_text(canvas, x, y, &fitting, text);
}

void canvas_text_upwards(Canvas *canvas, double x, double y, const TextStyle *style, const char *text)
{
    g_autofree char *shown = printable(text);
    double width = canvas_text_width(canvas, style, shown);
    canvas->backend->words(canvas, &(Words){x + style->up * DIGIT_HEIGHT * style->size, y + style->across * width, TRUE, style, shown});
}

void canvas_describe(Canvas *canvas, const char *text)
{
    g_free(canvas->description);
    canvas->description = printable(text);
}

/* ------------------------------------------------------------------------------------------------------------- moving */

void canvas_layer_begin(Canvas *canvas, Layer layer)
{
    if (canvas->moves) svg_layer_begin(canvas, layer);
}

void canvas_layer_end(Canvas *canvas)
{
    if (canvas->moves) svg_group_end(canvas);
}

void canvas_appear_begin(Canvas *canvas, double time)
{
    if (canvas->moves) svg_appear_begin(canvas, time);
}

void canvas_appear_end(Canvas *canvas)
{
    if (canvas->moves) svg_group_end(canvas);
}

void canvas_animate(Canvas *canvas, Property property, const Key *keys, gsize count)
{
    svg_animate(canvas, property, keys, count);
}

void canvas_ride_begin(Canvas *canvas, double from, double to)
{
    svg_ride_begin(canvas, from, to);
    g_array_set_size(canvas->pieces, 0);
}

void canvas_ride_end(Canvas *canvas)
{
    svg_group_end(canvas);
}
