/* SPDX-License-Identifier: MIT */
/*
 * Riding: the robot moves with R' outward and sqrt(1 - R'^2) along the boundary, so d(angle) / dt = sqrt(1 - R'^2) / R whatever the ride.
 * The integral is tabulated for each disc: panels so short that eight points of Gauss integrate each to rounding. Where R' reaches 1, and
 * where R begins at 0, the panels shrink with the distance from there. A ride is looked at in steps: parts of panels with little turn.
 *
 * Meeting another disc: within a step the ride is short against everything, so that the clearance falls to its least and rises again at
 * most once: its slope tells.
 */
#include "slow/law_ride.h"

#include <math.h>
#include <stdlib.h>

#define MOST_TURN 0.04
#define MOST_GROWTH 0.02
#define SHORTEST 1e-14
#define SMALLEST 1e-12 /* a disc below this radius is ridden by nobody */

static const double pi = 3.14159265358979323846;

static double turn_rate(slow_jet j)
{
    return sqrt(fmax(0.0, (1.0 - j.rate) * (1.0 + j.rate))) / j.radius;
}

static double turn_over(const law_world *world, size_t disc, size_t piece, double from, double to)
{
    static const double places[4] = {0.1834346424956498, 0.5255324099163290, 0.7966664774136267, 0.9602898564975363};
    static const double weights[4] = {0.3626837833783620, 0.3137066458778873, 0.2223810344533745, 0.1012285362903763};
    const double middle = 0.5 * (from + to), half = 0.5 * (to - from);
    double sum = 0.0;
    for (int i = 0; i < 4; i++) {
        sum += weights[i] * turn_rate(law_world_jet(world, disc, piece, middle - half * places[i]));
        sum += weights[i] * turn_rate(law_world_jet(world, disc, piece, middle + half * places[i]));
    }
    return half * sum;
}

/* ---------------------------------------------------------------------------------------------------------------- panels */

static int short_enough(const law_world *world, size_t disc, size_t piece, double from, double to)
{
    const slow_jet a = law_world_jet(world, disc, piece, from), b = law_world_jet(world, disc, piece, to);
    if (to - from <= SHORTEST * (1.0 + to) || b.radius < SMALLEST) return 1;
    if (!(a.radius > 0.0) || b.radius - a.radius > MOST_GROWTH * a.radius) return 0;
    const double slow_a = 1.0 - a.rate, slow_b = 1.0 - b.rate, middle = 0.5 * (from + to);
    if (fmax(slow_a, slow_b) > 1.2 * fmin(slow_a, slow_b)) return 0;
    const double whole = turn_over(world, disc, piece, from, to);
    const double halves = turn_over(world, disc, piece, from, middle) + turn_over(world, disc, piece, middle, to);
    return fabs(whole - halves) <= 1e-14 * (1e-2 + whole + whole / a.radius);
}

static int add_panels(law_world *world, size_t disc, size_t piece, double from, double to)
{
    law_disc *d = &world->discs[disc];
    const double middle = 0.5 * (from + to);
    if (!short_enough(world, disc, piece, from, to) && middle > from && middle < to)
        return add_panels(world, disc, piece, from, middle) && add_panels(world, disc, piece, middle, to);
    if (d->panel_count == LAW_PANELS) return 0;
    d->panels[d->panel_count++] = (law_panel){from, to, piece, 0.0};
    return 1;
}

/* Counted back from the end: at the begin, where R may be 0, the turns are without bound, and would drown what comes later. */
static void count_turns(law_world *world, size_t disc)
{
    double turned = 0.0;
    for (size_t k = world->discs[disc].panel_count; k > 0; k--) {
        law_panel *p = &world->discs[disc].panels[k - 1];
        const double radius = law_world_jet(world, disc, p->piece, p->to).radius;
        if (radius >= SMALLEST && p->to - p->from > SHORTEST * (1.0 + p->to))
            turned -= turn_over(world, disc, p->piece, p->from, p->to);
        p->turned = turned;
    }
}

int law_ride_prepare(law_world *world, size_t disc)
{
    law_disc *d = &world->discs[disc];
    d->panels = malloc(LAW_PANELS * sizeof *d->panels);
    if (!d->panels) return 0;
    for (size_t i = 0; i < d->stretch_count; i++) {
        const law_stretch *s = &d->stretches[i];
        if (s->ridable && !s->empty && !add_panels(world, disc, s->piece, s->from, s->to)) return 0;
    }
    count_turns(world, disc);
    return 1;
}

/* The last panel that begins at the time or before; the first where none does. */
static size_t panel_at(const law_disc *d, double time)
{
    size_t low = 0, high = d->panel_count;
    while (high - low > 1) {
        const size_t middle = (low + high) / 2;
        if (d->panels[middle].from <= time)
            low = middle;
        else
            high = middle;
    }
    return low;
}

static double turned_at(const law_world *world, size_t disc, double time)
{
    const law_disc *d = &world->discs[disc];
    if (d->panel_count == 0) return 0.0;
    const law_panel *p = &d->panels[panel_at(d, time)];
    const double to = fmin(time, p->to);
    if (to - p->from <= SHORTEST * (1.0 + p->to)) return p->turned;
    return p->turned + turn_over(world, disc, p->piece, p->from, to);
}

const law_panel *law_ride_panel(const law_world *world, size_t disc, double time)
{
    return &world->discs[disc].panels[panel_at(&world->discs[disc], time)];
}

/* ----------------------------------------------------------------------------------------------------------------- rides */

law_moment law_ride_at(const law_world *world, const law_ride *ride, size_t piece, double time)
{
    const law_disc *d = &world->discs[ride->disc];
    const slow_jet j = law_world_jet(world, ride->disc, piece, time);
    const double angle = ride->angle + ride->side * law_ride_turned(world, ride, time);
    const double along = sqrt(fmax(0.0, (1.0 - j.rate) * (1.0 + j.rate)));
    return (law_moment){d->x + j.radius * cos(angle), d->y + j.radius * sin(angle), time,
                        angle + ride->side * atan2(along, fmin(j.rate, 1.0))};
}

double law_ride_turned(const law_world *world, const law_ride *ride, double time)
{
    if (time <= ride->time) return 0.0;
    return turned_at(world, ride->disc, time) - turned_at(world, ride->disc, ride->time);
}

double law_ride_time(const law_world *world, const law_ride *ride, double turned, double end)
{
    double low = ride->time, high = end;
    for (int i = 0; i < 100 && high - low > 1e-16 * (1.0 + high); i++) {
        const double middle = 0.5 * (low + high);
        if (law_ride_turned(world, ride, middle) < turned)
            low = middle;
        else
            high = middle;
    }
    return high;
}

/* ------------------------------------------------------------------------------------------------------ meeting others */

/* One panel of the ride and one stretch of another disc. */
typedef struct meeting {
    const law_world *world;
    const law_ride *ride;
    size_t piece; /* of the disc ridden */
    size_t other, other_piece;
} meeting;

static int met_at(const meeting *m, double time)
{
    const law_moment at = law_ride_at(m->world, m->ride, m->piece, time);
    return !law_world_clear(m->world, m->other, m->other_piece, at.x, at.y, time);
}

/* How fast the clearance changes. */
static double slope_at(const meeting *m, double time)
{
    const law_disc *d = &m->world->discs[m->other];
    const law_moment at = law_ride_at(m->world, m->ride, m->piece, time);
    const double dx = at.x - d->x, dy = at.y - d->y, distance = hypot(dx, dy);
    const double away = distance > 0.0 ? (dx * cos(at.heading) + dy * sin(at.heading)) / distance : 1.0;
    return away - law_world_jet(m->world, m->other, m->other_piece, time).rate;
}

/* Not met at a, met at b: the last moment before. */
static double first_between(const meeting *m, double a, double b)
{
    for (int i = 0; i < 60; i++) {
        const double middle = 0.5 * (a + b);
        if (met_at(m, middle))
            b = middle;
        else
            a = middle;
    }
    return a;
}

static double least_between(const meeting *m, double a, double b)
{
    for (int i = 0; i < 60; i++) {
        const double middle = 0.5 * (a + b);
        if (slope_at(m, middle) < 0.0)
            a = middle;
        else
            b = middle;
    }
    return a;
}

/* The first moment in [a, b] at which the other disc is met, or infinity. */
static double meets(const meeting *m, double a, double b)
{
    if (met_at(m, a)) return a;
    if (met_at(m, b)) return first_between(m, a, b);
    if (!(slope_at(m, a) < 0.0 && slope_at(m, b) > 0.0)) return INFINITY;
    const double least = least_between(m, a, b);
    return met_at(m, least) ? first_between(m, a, least) : INFINITY;
}

static double step_meets(const law_world *world, const law_ride *ride, const law_panel *panel, double from, double to)
{
    double met = INFINITY;
    for (size_t i = 0; i < world->count; i++) {
        const law_disc *other = &world->discs[i];
        for (size_t k = 0; i != ride->disc && k < other->stretch_count; k++) {
            const law_stretch *s = &other->stretches[k];
            if (s->empty || s->from > to || s->to < from) continue;
            const meeting m = {world, ride, panel->piece, i, s->piece};
            met = fmin(met, meets(&m, fmax(from, s->from), fmin(to, s->to)));
        }
    }
    return met;
}

/* Where the panels from the ride's begin on have a gap, or once round has been turned. */
static double rideable_end(const law_world *world, const law_ride *ride, double limit)
{
    const law_disc *d = &world->discs[ride->disc];
    if (d->panel_count == 0) return ride->time;
    size_t k = panel_at(d, ride->time);
    if (!(d->panels[k].from <= ride->time && d->panels[k].to > ride->time)) return ride->time;
    while (k + 1 < d->panel_count && d->panels[k].to == d->panels[k + 1].from && d->panels[k].to < limit) k++;
    const double end = fmin(limit, d->panels[k].to);
    return law_ride_turned(world, ride, end) <= 2.0 * pi ? end : law_ride_time(world, ride, 2.0 * pi, end);
}

double law_ride_end(const law_world *world, const law_ride *ride, double limit)
{
    const law_disc *d = &world->discs[ride->disc];
    const double end = rideable_end(world, ride, limit);
    if (end <= ride->time) return ride->time;
    for (size_t k = panel_at(d, ride->time); k < d->panel_count && d->panels[k].from < end; k++) {
        const double from = fmax(d->panels[k].from, ride->time), to = fmin(d->panels[k].to, end);
        const size_t steps = law_ride_steps(world, ride, from, to);
        for (size_t i = 0; i < steps; i++) {
            const double met =
                step_meets(world, ride, &d->panels[k], law_ride_step(from, to, i, steps), law_ride_step(from, to, i + 1, steps));
            if (met < INFINITY) return met;
        }
    }
    return end;
}

size_t law_ride_steps(const law_world *world, const law_ride *ride, double from, double to)
{
    const double turned = law_ride_turned(world, ride, to) - law_ride_turned(world, ride, from);
    return 1 + (size_t)(turned / MOST_TURN);
}

double law_ride_step(double from, double to, size_t i, size_t steps)
{
    return i < steps ? from + (to - from) * (double)i / (double)steps : to;
}
