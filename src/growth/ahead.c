/* SPDX-License-Identifier: MIT */
/* The argument is in ahead.h. */
#include "growth/ahead.h"

#include <stdlib.h>

/* A disc hides a little less than it covers, so that tolerances do not count; one that is smaller than LEAST_COVER nothing. */
#define COVER_SHARE (1.0 - 1e-6)
#define LEAST_COVER 1e-6

/* With ends farther apart, which takes a step of rounding, nothing is known of what is between. */
#define MOST_TURN 1.0

static double turn_between(tdsp_point a, tdsp_point b)
{
    return math_atan2(point_cross(a, b), point_dot(a, b));
}

ahead_view ahead_look(const growth_chunk *chunk, const sight_line ends[2])
{
    double turn = fabs(turn_between(ends[0].unit, ends[1].unit));
    ahead_view view = {.chunk = chunk, .ends = ends, .middle = point_add(ends[0].unit, ends[1].unit), .last = ends[1].start};
    view.length = chunk->base.in_fan ? 0.0 : chunk->to - chunk->from;
    view.slide = turn < MOST_TURN ? view.length * math_sin(turn) : INFINITY;
    sky_init(&view.sky, -0.5 * turn, 0.5 * turn);
    return view;
}

int ahead_is_too_late(const growth_engine *engine, tdsp_point place, double time, tdsp_point center, double radius)
{
    return time + point_distance(place, center) + point_distance(center, engine->question.goal) - 2.0 * radius > engine->limit;
}

/* Does no line of the chunk's come so near to a centre, this far away? Half planes left of the right end, right of the left end and ahead of both hold all lines. */
static int is_out_of_sight(const ahead_view *view, tdsp_point to, double radius)
{
    double side = view->chunk->ride->side, room = radius + view->slide;
    if (isinf(view->slide)) return 0;
    return side * point_cross(view->ends[0].unit, to) < -room || side * point_cross(view->ends[1].unit, to) > room ||
           point_dot(view->middle, to) < -2.0 * (radius + view->length);
}

/* Half the angle under which a circle is seen. */
static double half_angle(double radius, double distance)
{
    return radius < distance ? math_asin(radius / distance) : GEOM_PI;
}

/* How long a leg to the disc is at least: its boundary comes towards the robot no faster than the disc above it grows, as far as that is known. */
static double least_length(const ahead_view *view, const growth_reach *reach, uint32_t place, double distance)
{
    const geom_disc *disc = &reach->discs[place];
    double gap = distance - view->length, known = reach->sign > 0.0 ? reach->until - view->last : INFINITY;
    double now = math_max(disc_radius(disc, view->ends[0].start), disc_radius(disc, view->last));
    return math_max(gap - reach->largest[place], math_min((gap - now) / (1.0 + math_max(disc->rate, 0.0)), known));
}

static growth_ahead ahead_make(const ahead_view *view, const growth_reach *reach, uint32_t place, tdsp_point to)
{
    double distance = point_length(to);
    growth_ahead disc = {place, distance, least_length(view, reach, place, distance), turn_between(view->middle, to), GEOM_PI};
    if (distance - view->length > reach->largest[place]) disc.window = half_angle(reach->largest[place] + view->slide, distance);
    return disc;
}

static int is_nearer(const void *a, const void *b)
{
    const growth_ahead *first = a, *second = b;
    if (first->nearest != second->nearest) return first->nearest < second->nearest ? -1 : 1;
    return (first->place > second->place) - (first->place < second->place);
}

tdsp_status ahead_list(growth_engine *engine, const ahead_view *view)
{
    const growth_reach *reach = &engine->reach;
    const sight_line *first = &view->ends[0];
    tdsp_status status = memory_reserve(&engine->allocator, (void **)&engine->ahead, &engine->ahead_capacity, reach->count, sizeof *engine->ahead);
    engine->ahead_count = 0;
    if (status != TDSP_OK) return status;
    for (uint32_t i = 0; i < reach->count; ++i) {
        tdsp_point center = reach->discs[i].center, to = point_sub(center, first->from);
        double radius = reach->largest[i];
        if (is_out_of_sight(view, to, radius) || ahead_is_too_late(engine, first->from, first->start, center, radius)) continue;
        engine->ahead[engine->ahead_count++] = ahead_make(view, reach, i, to);
    }
    if (engine->ahead_count > 1) qsort(engine->ahead, engine->ahead_count, sizeof *engine->ahead, is_nearer);
    return TDSP_OK;
}

int ahead_ends(ahead_view *view, const growth_ahead *disc)
{
    return !sky_advance(&view->sky, disc->nearest);
}

int ahead_hides(const ahead_view *view, const growth_ahead *disc)
{
    return sky_hides(&view->sky, disc->direction - disc->window, disc->direction + disc->window, disc->nearest);
}

void ahead_cover(ahead_view *view, const growth_ahead *disc, const growth_shape *shape)
{
    double reach = disc->distance + view->length, least = view->chunk->sign > 0.0 ? view->ends[0].start : -(view->last + reach);
    if (least < 0.0) return;
    double radius = shape_radius(shape, least), room = radius * COVER_SHARE - view->slide;
    double ahead = (disc->distance - room) * (disc->distance + room);
    if (!(room > 0.0) || !(radius > LEAST_COVER) || !(disc->distance > room) || !(ahead > view->length * view->length)) return;
    double half = half_angle(room, disc->distance);
    sky_add(&view->sky, math_max(disc->direction - half, view->sky.from), math_min(disc->direction + half, view->sky.to), reach);
}
