/* SPDX-License-Identifier: MIT */
/* The canvas: cairo's surfaces, kept in memory until the picture is whole. */
#include "plot_canvas.h"

#include <cairo-svg.h>
#include <string.h>

#include "cli.h"
#include "file_out.h"

#define PIXELS 2.0        /* of a PNG, for each point */
#define DIGIT_HEIGHT 0.73 /* of the usual sans-serif, as a share of its size */

static gboolean is_svg(const char *path)
{
    g_autofree char *lower = g_ascii_strdown(path, -1);
    return g_str_has_suffix(lower, ".svg");
}

gboolean canvas_check_name(const char *path, GError **error)
{
    g_autofree char *lower = g_ascii_strdown(path, -1);
    if (g_str_has_suffix(lower, ".svg") || g_str_has_suffix(lower, ".png")) return TRUE;
    return cli_fail(error, CLI_USAGE, "%s: the name must end in .svg or .png, which says what to draw", path);
}

static cairo_status_t append(void *bytes, const unsigned char *data, unsigned int length)
{
    g_byte_array_append(bytes, data, length);
    return CAIRO_STATUS_SUCCESS;
}

static gboolean fail_cairo(cairo_status_t status, GError **error)
{
    return cli_fail(error, CLI_SYSTEM, "cannot draw: %s", cairo_status_to_string(status));
}

void canvas_colour(cairo_t *cr, guint32 rgb)
{
    cairo_set_source_rgb(cr, (rgb >> 16) / 255.0, (rgb >> 8 & 0xff) / 255.0, (rgb & 0xff) / 255.0);
}

gboolean canvas_begin(Canvas *canvas, const char *path, double width, double height, GError **error)
{
    Canvas made = {.width = width, .height = height};
    if (is_svg(path)) {
        made.svg = g_byte_array_new();
        made.surface = cairo_svg_surface_create_for_stream(append, made.svg, width, height);
    } else {
        made.surface = cairo_image_surface_create(CAIRO_FORMAT_RGB24, (int)(width * PIXELS), (int)(height * PIXELS));
    }
    made.cr = cairo_create(made.surface);
    if (!made.svg) cairo_scale(made.cr, PIXELS, PIXELS);
    canvas_colour(made.cr, PLOT_PAPER);
    cairo_paint(made.cr);
    *canvas = made;
    cairo_status_t status = cairo_status(made.cr);
    return status == CAIRO_STATUS_SUCCESS ? TRUE : fail_cairo(status, error);
}

gboolean canvas_write(Canvas *canvas, const char *path, GError **error)
{
    g_autoptr(GByteArray) png = g_byte_array_new();
    cairo_status_t status = cairo_status(canvas->cr);
    if (status == CAIRO_STATUS_SUCCESS && !canvas->svg) status = cairo_surface_write_to_png_stream(canvas->surface, append, png);
    cairo_surface_finish(canvas->surface);
    if (status == CAIRO_STATUS_SUCCESS) status = cairo_surface_status(canvas->surface);
    if (status != CAIRO_STATUS_SUCCESS) return fail_cairo(status, error);
    const GByteArray *picture = canvas->svg ? canvas->svg : png;
    return file_out_write(path, picture->data, picture->len, error);
}

void canvas_clear(Canvas *canvas)
{
    g_clear_pointer(&canvas->cr, cairo_destroy);
    g_clear_pointer(&canvas->surface, cairo_surface_destroy);
    g_clear_pointer(&canvas->svg, g_byte_array_unref);
}

static void choose_font(cairo_t *cr, const TextStyle *style)
{
    cairo_select_font_face(cr, "sans-serif", CAIRO_FONT_SLANT_NORMAL,
                           style->bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(cr, style->size);
}

double canvas_text_width(cairo_t *cr, const TextStyle *style, const char *text)
{
    cairo_text_extents_t extents;
    choose_font(cr, style);
    cairo_text_extents(cr, text, &extents);
    return extents.x_advance;
}

void canvas_text(cairo_t *cr, double x, double y, const TextStyle *style, const char *text)
{
    double left = x - style->across * canvas_text_width(cr, style, text);
    double base = y + style->up * DIGIT_HEIGHT * style->size;
    if (style->halo) {
        cairo_move_to(cr, left, base);
        cairo_text_path(cr, text);
        canvas_colour(cr, PLOT_PAPER);
        cairo_set_line_width(cr, 3.5);
        cairo_set_line_join(cr, CAIRO_LINE_JOIN_ROUND);
        cairo_stroke(cr);
    }
    cairo_move_to(cr, left, base);
    canvas_colour(cr, style->colour);
    cairo_show_text(cr, text);
    cairo_new_path(cr);
}

void canvas_text_within(cairo_t *cr, double x, double y, double width, const TextStyle *style, const char *text)
{
    TextStyle fitting = *style;
    double needed = canvas_text_width(cr, style, text);
    if (needed > width) fitting.size *= width / needed;
    canvas_text(cr, x, y, &fitting, text);
}

void canvas_text_upwards(cairo_t *cr, double x, double y, const TextStyle *style, const char *text)
{
    cairo_save(cr);
    cairo_translate(cr, x, y);
    cairo_rotate(cr, -G_PI / 2);
    canvas_text(cr, 0, 0, style, text);
    cairo_restore(cr);
}
