/* SPDX-License-Identifier: MIT */
/* See case.h. */
#include "soak/case.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>

#include "support/chance.h"

/* Times over so many journeys are refused, says tdsp/solver.h. */
static double most_journeys(const soak_world *world)
{
    return tdsp_solver_method(world->solver) == TDSP_METHOD_GENERAL ? 0x1p20 : 0x1p40;
}

void soak_fail(soak_case *c, double excess, const char *format, ...)
{
    va_list list;
    if (c->failed) return;
    c->failed = 1;
    c->excess = c->world.unit > 0.0 ? excess / c->world.unit : INFINITY;
    va_start(list, format);
    (void)vsnprintf(c->what, sizeof c->what, format, list);
    va_end(list);
}

int soak_is_far(const soak_world *world, tdsp_status status, double time)
{
    return status == TDSP_NOT_SUPPORTED && time > 0.5 * most_journeys(world) * world->unit;
}

double soak_ask(soak_case *c, const soak_world *world, double departure)
{
    double arrival = -1.0;
    const tdsp_status status = tdsp_earliest_arrival(world->solver, departure, &arrival);
    if (status == TDSP_SHRINKS || soak_is_far(world, status, departure)) return NAN;
    if (!tdsp_status_is_answer(status)) {
        soak_fail(c, INFINITY, "status %s at departure %.17g", tdsp_status_name(status), departure);
        return NAN;
    }
    if ((status == TDSP_OK) != (arrival < INFINITY) || !(arrival >= departure))
        soak_fail(c, INFINITY, "arrival %.17g with status %s at departure %.17g", arrival, tdsp_status_name(status), departure);
    return arrival;
}

double soak_slack(const soak_case *c, const soak_world *world, double departure, double arrival)
{
    const double travel = arrival < INFINITY ? arrival - departure : 0.0;
    return c->looser * SOAK_SAME * (world->unit + travel) + 1e-15 * (departure + travel) +
           SOAK_ROUNDING * soak_magnitude(world->is) / world->is->journey.speed;
}

double soak_step(const soak_case *c, const soak_world *world, double time)
{
    return c->looser * SOAK_TOUCH * (world->unit + time);
}

int soak_open_moved(const soak_case *c, const soak_world *world, double departure, double sign, soak_world *moved)
{
    static soak_scene scenes[2]; /* one for each sign: both may be open */
    soak_scene *scene = &scenes[sign > 0.0];
    tdsp_ends ends;
    if (tdsp_solver_ends(world->solver, &ends) != TDSP_OK) return 0;
    const soak_nudge nudge = {sign * c->looser * c->touches * SOAK_TOUCH, sign * c->looser * SOAK_ROUNDING, c->later, ends.source, departure};
    soak_copy(scene, world->is);
    soak_inflate(scene, &nudge);
    return soak_open(scene, TDSP_METHOD_AUTO, moved) == TDSP_OK && tdsp_solver_set_ends(moved->solver, &ends) == TDSP_OK;
}

/* A(t) among the discs moved by what may be a touch. */
static double ask_moved(soak_case *c, const soak_world *world, double departure, double sign)
{
    soak_world moved;
    const double then = fmax(0.0, departure + sign * soak_step(c, world, departure));
    if (!soak_open_moved(c, world, then, sign, &moved)) return NAN;
    const double found = soak_ask(c, &moved, then);
    soak_close(&moved);
    return found;
}

/* Greater than zero: `low` is over `high` by more than the slack, for which NAN is no reason. */
static double exceeds(const soak_case *c, const soak_world *world, double departure, double low, double high)
{
    if (isnan(low) || isnan(high) || low <= high) return 0.0;
    return fmax(0.0, low - high - soak_slack(c, world, departure, fmin(low, high)));
}

void soak_not_before(soak_case *c, const soak_world *world, double departure, double arrival, const char *text)
{
    const double expected = soak_ask(c, world, departure);
    if (!(exceeds(c, world, departure, expected, arrival) > 0.0)) return;
    const double bound = ask_moved(c, world, departure, -1.0), excess = exceeds(c, world, departure, bound, arrival);
    c->forgiven++;
    if (excess > 0.0)
        soak_fail(c, excess, "%s: %.17g, earlier than %.17g, at departure %.17g", text, arrival, expected, departure);
}

void soak_not_after(soak_case *c, const soak_world *world, double departure, double arrival, const char *text)
{
    const double expected = soak_ask(c, world, departure);
    if (!(exceeds(c, world, departure, arrival, expected) > 0.0)) return;
    const double bound = ask_moved(c, world, departure, 1.0), excess = exceeds(c, world, departure, arrival, bound);
    c->forgiven++;
    if (excess > 0.0) soak_fail(c, excess, "%s: %.17g, later than %.17g, at departure %.17g", text, arrival, expected, departure);
}

void soak_agrees(soak_case *c, const soak_world *world, double departure, double arrival, const char *text)
{
    soak_not_before(c, world, departure, arrival, text);
    soak_not_after(c, world, departure, arrival, text);
}

uint64_t soak_pick(soak_case *c, uint64_t count)
{
    return chance_below(&c->pick, count);
}

double soak_pick_between(soak_case *c, double low, double high)
{
    return chance_between(&c->pick, low, high);
}
