/* SPDX-License-Identifier: MIT */
/*
 * Geometry of one point and one disc; nothing here knows two discs.
 *
 * Tangent from a point: a robot leaves P at speed 1 in the direction u and reaches the disc after the length L tangentially:
 * its own motion along the outward normal n is the boundary's, u . n = c (the disc's rate). With D = O - P, R the radius at
 * the start, D = L u - (R + c L) n. Squared, with u . n = c and s^2 = 1 - c^2: |D|^2 = L^2 - 2 c L (R + c L) + (R + c L)^2 =
 * s^2 L^2 + R^2. So L = sqrt(|D|^2 - R^2) / s. Seen along u the centre lies L - c (R + c L) ahead and s (R + c L) aside.
 *
 * Ride: the robot moves with c outward and s along the boundary, so d(angle) = s dt / R and dR = c dt: R = R0 exp(turned c /
 * s).
 */
#include "slow/slow_world.h"

#include <tgmath.h>

slow_real slow_wrap(slow_real angle)
{
    const slow_real wrapped = remainder(angle, 2.0 * SLOW_PI);
    return wrapped <= -SLOW_PI ? wrapped + 2.0 * SLOW_PI : wrapped;
}

slow_real slow_wrap_positive(slow_real angle)
{
    const slow_real wrapped = fmod(angle, 2.0 * SLOW_PI);
    return wrapped < 0.0 ? wrapped + 2.0 * SLOW_PI : wrapped;
}

void slow_world_make(slow_world *world, const tdsp_journey *journey, const tdsp_disc *discs, size_t count)
{
    const slow_real from_x = journey->source.x, from_y = journey->source.y;
    const slow_real way_x = journey->destination.x - from_x, way_y = journey->destination.y - from_y;
    slow_real length = hypot(way_x, way_y);
    if (length == 0.0) length = 1.0;
    world->origin = journey->source;
    world->length = length;
    world->time = length / journey->speed;
    world->to_x = way_x / length;
    world->to_y = way_y / length;
    world->count = count;
    for (size_t i = 0; i < count; i++) {
        world->discs[i].x = (discs[i].center.x - from_x) / length;
        world->discs[i].y = (discs[i].center.y - from_y) / length;
        world->discs[i].radius = ((slow_real)discs[i].radius + journey->radius) / length;
        world->discs[i].rate = (slow_real)discs[i].growth / journey->speed;
    }
}

slow_real slow_radius(const slow_disc *disc, slow_real time)
{
    return disc->radius + disc->rate * time;
}

slow_real slow_clearance(const slow_disc *disc, slow_real x, slow_real y, slow_real time)
{
    return hypot(x - disc->x, y - disc->y) - slow_radius(disc, time);
}

slow_real slow_slack(const slow_disc *disc, slow_real x, slow_real y, slow_real time)
{
    return SLOW_ROUNDING + SLOW_TOUCH * (fabs(x) + fabs(y) + fabs(disc->x) + fabs(disc->y) + slow_radius(disc, time));
}

static int disc_clear(const slow_disc *disc, slow_real x, slow_real y, slow_real time)
{
    return slow_clearance(disc, x, y, time) >= -slow_slack(disc, x, y, time);
}

int slow_point_free(const slow_world *world, slow_real x, slow_real y, slow_real time)
{
    for (size_t i = 0; i < world->count; i++)
        if (!disc_clear(&world->discs[i], x, y, time)) return 0;
    return 1;
}

/* The clearance is convex along a line; it is least where the distance grows as fast as the radius. */
static int disc_off_line(const slow_disc *disc, slow_real x, slow_real y, slow_real heading, slow_real time, slow_real length)
{
    const slow_real ux = cos(heading), uy = sin(heading), dx = disc->x - x, dy = disc->y - y, c = disc->rate;
    if (!disc_clear(disc, x, y, time)) return 0;
    if (!disc_clear(disc, x + length * ux, y + length * uy, time + length)) return 0;
    if (c >= 1.0) return 1;
    const slow_real foot = dx * ux + dy * uy, aside = fabs(dx * uy - dy * ux);
    const slow_real least = foot + aside * c / sqrt((1.0 - c) * (1.0 + c));
    if (least <= 0.0 || least >= length) return 1;
    return disc_clear(disc, x + least * ux, y + least * uy, time + least);
}

int slow_line_free(const slow_world *world, slow_real x, slow_real y, slow_real heading, slow_real time, slow_real length)
{
    for (size_t i = 0; i < world->count; i++)
        if (!disc_off_line(&world->discs[i], x, y, heading, time, length)) return 0;
    return 1;
}

int slow_tangent(const slow_disc *disc, int side, slow_real x, slow_real y, slow_real time, slow_real *heading, slow_real *length)
{
    const slow_real c = disc->rate, radius = slow_radius(disc, time), dx = disc->x - x, dy = disc->y - y, d = hypot(dx, dy);
    if (c >= 1.0 || (c == 0.0 && radius == 0.0)) return 0;
    if (d < radius - slow_slack(disc, x, y, time)) return 0;
    const slow_real s = sqrt((1.0 - c) * (1.0 + c));
    const slow_real far = d > radius ? sqrt((d - radius) * (d + radius)) / s : 0.0;
    const slow_real reached = radius + c * far;
    *length = far;
    *heading = atan2(dy, dx) - side * atan2(s * reached, far - c * reached);
    return 1;
}

slow_moment slow_ride_at(const slow_world *world, const slow_ride *ride, slow_real turned)
{
    const slow_disc *disc = &world->discs[ride->disc];
    const slow_real c = disc->rate, s = sqrt((1.0 - c) * (1.0 + c)), start = slow_radius(disc, ride->time);
    const slow_real angle = ride->angle + ride->side * turned;
    const slow_real elapsed = c == 0.0 ? start * turned : start * expm1(turned * c / s) / c;
    const slow_real radius = start + c * elapsed;
    return (slow_moment){disc->x + radius * cos(angle), disc->y + radius * sin(angle), ride->time + elapsed,
                         angle + ride->side * atan2(s, c)};
}

slow_real slow_ride_turned(const slow_world *world, const slow_ride *ride, slow_real time)
{
    const slow_disc *disc = &world->discs[ride->disc];
    const slow_real c = disc->rate, s = sqrt((1.0 - c) * (1.0 + c)), start = slow_radius(disc, ride->time);
    const slow_real elapsed = time - ride->time;
    if (elapsed <= 0.0) return 0.0;
    return c == 0.0 ? elapsed / start : log1p(c * elapsed / start) * s / c;
}
