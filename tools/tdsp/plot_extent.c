/* SPDX-License-Identifier: MIT */
/* The part of the plane that a picture shows: the journeys whole, and of the discs what is near enough to matter to them. */
#include "plot_extent.h"

#include <math.h>

#include "tdsp/growth.h"

#define LONG_SIDE 700.0 /* of the frame */
#define LEAST_SHAPE 0.8 /* the shorter side of the frame over the longer one */
#define FAR 0.5         /* discs count for the view up to so many lengths of the journey away */

typedef struct Extent {
    double x_low, x_high, y_low, y_high;
} Extent;

static void extent_add(Extent *extent, tdsp_point at, double around)
{
    extent->x_low = fmin(extent->x_low, at.x - around);
    extent->x_high = fmax(extent->x_high, at.x + around);
    extent->y_low = fmin(extent->y_low, at.y - around);
    extent->y_high = fmax(extent->y_high, at.y + around);
}

static void extent_add_legs(Extent *extent, const GArray *legs)
{
    for (guint i = 0; i < legs->len; i++) {
        const tdsp_leg *leg = &g_array_index(legs, tdsp_leg, i);
        extent_add(extent, leg->from, 0);
        extent_add(extent, leg->to, 0);
        if (leg->kind != TDSP_LEG_LINE && leg->sweep > 0.5) extent_add(extent, leg->center, leg->radius_to);
    }
}

static double larger_side(const Extent *extent)
{
    return fmax(extent->x_high - extent->x_low, extent->y_high - extent->y_low);
}

/* Discs as far as `near` reaches, each no wider than the view it adds to. */
static void extent_add_discs(Extent *extent, const ScenePicture *picture, const Extent *near)
{
    double departure = picture->journeys[0].departure;
    size_t count;
    const tdsp_disc *discs = tdsp_scene_discs(picture->scene->scene, &count);
    for (size_t i = 0; i < count; i++) {
        double radius = discs[i].radius;
        (void)tdsp_scene_disc_at(picture->scene->scene, (uint32_t)i, departure, &radius, NULL);
        tdsp_point low = {fmax(discs[i].center.x - radius, near->x_low), fmax(discs[i].center.y - radius, near->y_low)};
        tdsp_point high = {fmin(discs[i].center.x + radius, near->x_high), fmin(discs[i].center.y + radius, near->y_high)};
        if (low.x > high.x || low.y > high.y) continue;
        extent_add(extent, low, 0);
        extent_add(extent, high, 0);
    }
}

static double first_disc_size(const tdsp_scene *scene)
{
    size_t count;
    const tdsp_disc *discs = tdsp_scene_discs(scene, &count);
    return count > 0 && discs[0].radius > 0 ? discs[0].radius : 1;
}

static Extent extent_of(const ScenePicture *picture)
{
    const tdsp_journey *journey = tdsp_scene_journey(picture->scene->scene);
    Extent extent = {INFINITY, -INFINITY, INFINITY, -INFINITY};
    extent_add(&extent, journey->source, 0);
    extent_add(&extent, journey->destination, 0);
    for (guint i = 0; i < picture->count; i++) extent_add_legs(&extent, picture->journeys[i].legs);
    double side = larger_side(&extent);
    if (!(side > 0)) side = first_disc_size(picture->scene->scene);
    Extent near = extent;
    extent_add(&near, journey->source, FAR * side);
    extent_add(&near, journey->destination, FAR * side);
    extent_add_discs(&extent, picture, &near);
    side = fmax(larger_side(&extent), side);
    double margin = 0.05 * side;
    return (Extent){extent.x_low - margin, extent.x_high + margin, extent.y_low - margin, extent.y_high + margin};
}

static void widen(double *low, double *high, double wanted)
{
    double more = fmax(0, wanted - (*high - *low)) / 2;
    *low -= more;
    *high += more;
}

/* Not too thin. */
Frame plot_extent_frame(const ScenePicture *picture, double left, double top)
{
    Extent extent = extent_of(picture);
    double side = larger_side(&extent);
    widen(&extent.x_low, &extent.x_high, LEAST_SHAPE * side);
    widen(&extent.y_low, &extent.y_high, LEAST_SHAPE * side);
    double scale = LONG_SIDE / side;
    return (Frame){left,
                   top,
                   scale * (extent.x_high - extent.x_low),
                   scale * (extent.y_high - extent.y_low),
                   extent.x_low,
                   extent.x_high,
                   extent.y_low,
                   extent.y_high};
}
