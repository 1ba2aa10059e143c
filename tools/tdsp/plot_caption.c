/* SPDX-License-Identifier: MIT */
/* Titles and legends of scenes. */
#include "plot_caption.h"

#include <math.h>

#include "cli.h"
#include "plot_clock.h"
#include "plot_gaps.h"
#include "plot_legend.h"

#define RIGHT 10.0        /* how near the right edge words come */
#define WIDEST_STEP 5e-10 /* a time between ticks as wide as one gets */

/* "leaves at 5 s, arrives at 25 s" */
static char *journey_text(const PictureJourney *journey, const char *unit)
{
    g_autofree char *departure = frame_with_unit(journey->departure, 7, unit);
    g_autofree char *arrival = frame_with_unit(journey->arrival, 7, unit);
    g_autofree char *reason = cli_reason(journey->status);
    if (isfinite(journey->arrival)) return g_strdup_printf("leaves at %s, arrives at %s", departure, arrival);
    return g_strdup_printf("leaves at %s, no path: %s", departure, reason);
}

static char *subtitle_of(const ScenePicture *picture)
{
    const char *time = picture->scene->time_unit, *length = picture->scene->length_unit;
    size_t count;
    tdsp_scene_discs(picture->scene->scene, &count);
    g_autofree char *speed = frame_with_unit(tdsp_scene_journey(picture->scene->scene)->speed, 5, length);
    g_autofree char *discs = g_strdup_printf("%" G_GSIZE_FORMAT " disc%s \xc2\xb7 robot's speed %s%s%s", count, count == 1 ? "" : "s", speed,
                                             *length && *time ? "/" : "", *length ? time : "");
    if (picture->count > 1) return g_steal_pointer(&discs); /* the legend tells when they leave and arrive */
    g_autofree char *journey = journey_text(&picture->journeys[0], time);
    return g_strdup_printf("%s \xc2\xb7 %s", journey, discs);
}

void plot_caption_titles(Canvas *canvas, const Frame *frame, const ScenePicture *picture)
{
    const TextStyle title = {18, TRUE, PLOT_INK, 0, 0, FALSE}, subtitle = {PLOT_TEXT, FALSE, PLOT_GREY, 0, 0, FALSE};
    const char *name = *picture->scene->name ? picture->scene->name : "Scene", *unit = picture->scene->time_unit;
    double right = canvas_width(canvas) - RIGHT, room = right - frame->left;
    g_autofree char *text = subtitle_of(picture);
    g_autofree char *first = journey_text(&picture->journeys[0], unit);
    g_autofree char *description = g_strdup_printf("%s: %s", name, first);
    canvas_describe(canvas, description);
    canvas_text_within(canvas, frame->left, 30, plot_scene_moves(picture) ? room - PLOT_CLOCK_WIDTH : room, &title, name);
    canvas_text_within(canvas, frame->left, 52, room, &subtitle, text);
    if (canvas_timeline(canvas)) plot_clock(canvas, frame->left + frame->width, 30, unit);
}

static gboolean rides(const Route *route)
{
    for (gsize i = 0; i < route->count; i++)
        if (route->legs[i].kind != TDSP_LEG_LINE) return TRUE;
    return FALSE;
}

/* Which of two journeys is which. */
static void legend_journeys(Legend *legend, const ScenePicture *picture)
{
    for (guint i = 0; i < picture->count; i++) {
        const Route route = plot_scene_route(picture, i);
        const Pen pen = plot_route_pen(&route);
        g_autofree char *text = journey_text(&picture->journeys[i], picture->scene->time_unit);
        legend_line(legend, &pen, text);
    }
}

/* What the only path is. */
static void legend_path(Legend *legend, const ScenePicture *picture, double step)
{
    const Route route = plot_scene_route(picture, 0);
    const Pen pen = plot_route_pen(&route);
    g_autofree char *every = frame_with_unit(step, 7, picture->scene->time_unit);
    g_autofree char *text = step > 0 ? g_strdup_printf("path, a tick every %s", every) : g_strdup("path");
    if (route.count > 0) legend_line(legend, &pen, text);
}

static void legend_ridden(Legend *legend, const ScenePicture *picture)
{
    for (guint i = 0; i < picture->count; i++) {
        const Route route = plot_scene_route(picture, i);
        const Pen pen = plot_ridden_pen(&route);
        if (!rides(&route)) continue;
        legend_line(legend, &pen, "ridden disc, as the ride begins");
        return;
    }
}

static void legend_discs(Legend *legend, const ScenePicture *picture)
{
    size_t count;
    tdsp_scene_discs(picture->scene->scene, &count);
    if (count == 0) return;
    legend_disc(legend, PLOT_DISC, PLOT_DISC, "discs at departure");
    if (!isfinite(plot_scene_end(picture))) return;
    legend_disc(legend, PLOT_DISC_LATER, PLOT_DISC_OUTLINE, plot_scene_moves(picture) ? "at the time shown" : "at arrival");
}

double plot_caption_legend(Canvas *canvas, const Frame *frame, const ScenePicture *picture, double y, double step)
{
    Legend legend = legend_new(canvas, frame->left, canvas_width(canvas) - RIGHT, y);
    legend_discs(&legend, picture);
    if (picture->count > 1)
        legend_journeys(&legend, picture);
    else
        legend_path(&legend, picture, step);
    legend_ridden(&legend, picture);
    if (tdsp_jumps_count(picture->jumps) == 0) return legend.y;
    gboolean moves = plot_scene_moves(picture);
    double x = legend_item(&legend, 26, moves ? "gap that closes" : "gap that closes, and the last departure through it");
    plot_gap_mark(canvas, x + 13, legend.y, 0, moves);
    return legend.y;
}

/* It is drawn to be measured. */
gboolean plot_caption_measure(const Frame *frame, const ScenePicture *picture, double width, double *height, GError **error)
{
    g_autoptr(Canvas) paper = canvas_new("legend.svg", width, 1, NULL, error);
    if (!paper) return FALSE;
    *height = plot_caption_legend(paper, frame, picture, 0, WIDEST_STEP);
    return TRUE;
}
