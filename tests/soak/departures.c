/* SPDX-License-Identifier: MIT */
/*
 * Mistakes sit where something changes, so half of the departures are there: at the moment a scene was made for, where the source is covered, after the
 * last departure of all, at a jump; each to the bit, by a bit less or more, or by next to nothing.
 */
#include "soak/departures.h"

#include <math.h>

#include "support/chance.h"

enum { HALVINGS = 70 };

#define LONGEST 3.0 /* journeys */

/* A time, its neighbours, or next to it by some share. */
static double near(uint64_t *chance, double unit, double time)
{
    const double side = chance_below(chance, 2) ? 1.0 : -1.0;
    switch (chance_below(chance, 4)) {
    case 0: return time;
    case 1: return nextafter(time, side * INFINITY);
    default: return time + side * pow(10.0, chance_between(chance, -15.0, -6.0)) * (unit + time);
    }
}

static double travel(const soak_world *world, double departure)
{
    double arrival = INFINITY;
    return tdsp_earliest_arrival(world->solver, departure, &arrival) == TDSP_OK ? arrival - departure : INFINITY;
}

double soak_find_jump(const soak_world *world, double from, double to)
{
    double before = travel(world, from), after = travel(world, to);
    if (!(after > before + 0.01 * world->unit)) return -1.0;
    for (int step = 0; step < HALVINGS; step++) {
        const double middle = 0.5 * (from + to);
        if (!(middle > from && middle < to)) break;
        const double between = travel(world, middle);
        if (between < INFINITY && (isinf(after) || after - between >= between - before)) {
            from = middle;
            before = between;
        } else {
            to = middle;
            after = between;
        }
    }
    return from;
}

static double end_of_departures(const soak_world *world)
{
    tdsp_last_departure last;
    const double source = tdsp_scene_source_free_until(world->scene, NULL);
    if (tdsp_solver_last_departure(world->solver, &last) == TDSP_OK && last.departure >= 0.0) return last.departure;
    return source;
}

size_t soak_departures(const soak_world *world, uint64_t *chance, double departures[SOAK_DEPARTURES])
{
    const double unit = world->unit > 0.0 ? world->unit : 1.0, source = tdsp_scene_source_free_until(world->scene, NULL);
    const double until = source >= 0.0 && source < LONGEST * unit ? source : LONGEST * unit, moment = world->is->moment;
    const int small = world->is->count <= 16;
    size_t count = 0;
    const double any = until * chance_between(chance, 0.0, 1.1);
    departures[count++] = chance_below(chance, 2) ? 0.0 : until * chance_between(chance, 0.0, 0.6);
    if (chance_below(chance, 2)) departures[count++] = any;
    if (moment >= 0.0 && chance_below(chance, 4)) departures[count++] = near(chance, unit, moment);
    if (small && chance_below(chance, 4) == 0)
        departures[count++] = near(chance, unit, chance_below(chance, 2) ? source : end_of_departures(world));
    if (small && chance_below(chance, 3) == 0) {
        const double jump = soak_find_jump(world, 0.0, any);
        if (jump >= 0.0) departures[count++] = near(chance, unit, jump);
    }
    size_t kept = 0;
    for (size_t i = 0; i < count; i++)
        if (departures[i] >= 0.0 && departures[i] < 1e6 * unit) departures[kept++] = departures[i];
    return kept;
}
