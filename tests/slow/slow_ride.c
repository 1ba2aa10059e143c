/* SPDX-License-Identifier: MIT */
/*
 * Sampling a ride.
 *
 * Free: between two samples the clearance to another disc can fall at most as fast as the robot and that disc approach, and
 * its second derivative is at most 1 / (distance between the robot and the centre) plus the rate at which the ride turns, so
 * that between its ends it sags by no more than an eighth of that times the square of the time; where neither excludes a
 * collision the interval is halved.
 *
 * Leaves: the miss is the angle from the tangent of the moment to the robot's own direction. A leave is a change of its
 * sign; an interval over which the miss moves much, or bends towards zero between its samples, is looked at more closely.
 */
#include "slow/slow_ride.h"

#include <tgmath.h>

#define SAMPLES_A_TURN 240.0
#define GROWTH_A_STEP 0.02 /* of the radius */
#define MOST_STEPS 20000.0
#define STEEP 0.2      /* radians of miss over one interval */
#define NEAR_ZERO (4.5e6 * SLOW_EPSILON) /* a miss that counts as none at an end or at a bend: 1e-9 for a double */
#define DEEPEST 48

static size_t ride_steps(const slow_world *world, const slow_ride *ride, slow_real end)
{
    const slow_real c = world->discs[ride->disc].rate, s = sqrt((1.0 - c) * (1.0 + c));
    slow_real steps = ceil(SAMPLES_A_TURN * end / (2.0 * SLOW_PI)) + ceil(end * c / s / GROWTH_A_STEP) + 4.0;
    return (size_t)(steps < MOST_STEPS ? steps : MOST_STEPS);
}

typedef struct ride_sample {
    slow_real turned;
    slow_moment at;
    slow_real clearance;
} ride_sample;

static ride_sample sample(const slow_world *world, const slow_ride *ride, const slow_disc *other, slow_real turned)
{
    ride_sample taken = {turned, slow_ride_at(world, ride, turned), 0.0};
    taken.clearance = slow_clearance(other, taken.at.x, taken.at.y, taken.at.time);
    return taken;
}

static int collides(const slow_disc *other, const ride_sample *at)
{
    return at->clearance < -slow_slack(other, at->at.x, at->at.y, at->at.time);
}

/* Can `other` not be met between two samples that are free of it? */
static int surely_free(const slow_world *world, const slow_ride *ride, const slow_disc *other, const ride_sample *a,
                       const ride_sample *b)
{
    const slow_disc *own = &world->discs[ride->disc];
    const slow_real span = b->at.time - a->at.time, slack = slow_slack(other, a->at.x, a->at.y, a->at.time);
    const slow_real s = sqrt((1.0 - own->rate) * (1.0 + own->rate));
    if (a->clearance - (1.0 + other->rate) * span > 0.0) return 1;
    const slow_real centers = a->clearance + b->clearance + slow_radius(other, a->at.time) + slow_radius(other, b->at.time);
    const slow_real near = 0.5 * (centers - span); /* no point between is closer to the other's centre */
    if (near <= 0.0) return 0;
    const slow_real bend = 1.0 / near + s / slow_radius(own, a->at.time);
    return fmin(a->clearance, b->clearance) - bend * span * span / 8.0 >= -1.5 * slack;
}

/* The first place in (a, b] where `other` is met, or infinity. */
static slow_real first_collision(const slow_world *world, const slow_ride *ride, const slow_disc *other, ride_sample a,
                              ride_sample b, int depth)
{
    if (collides(other, &a)) return a.turned;
    if (!collides(other, &b) && (surely_free(world, ride, other, &a, &b) || depth == 0)) return INFINITY;
    if (depth == 0) return a.turned;
    const ride_sample middle = sample(world, ride, other, 0.5 * (a.turned + b.turned));
    const slow_real early = first_collision(world, ride, other, a, middle, depth - 1);
    return early < INFINITY ? early : first_collision(world, ride, other, middle, b, depth - 1);
}

/* Around one centre the faster disc passes the slower one at one moment, everywhere at once. */
static slow_real concentric_collision(const slow_world *world, const slow_ride *ride, const slow_disc *other, slow_real limit)
{
    const slow_disc *own = &world->discs[ride->disc];
    const slow_real gap = slow_radius(own, ride->time) - slow_radius(other, ride->time), closing = other->rate - own->rate;
    const slow_real slack = SLOW_TOUCH * (1.0 + slow_radius(own, ride->time));
    if (gap < -slack) return 0.0;
    if (closing <= 0.0) return limit;
    return fmin(limit, slow_ride_turned(world, ride, ride->time + (fmax(gap, 0.0) + slack) / closing));
}

static slow_real free_of_disc(const slow_world *world, const slow_ride *ride, const slow_disc *other, slow_real limit)
{
    const slow_disc *own = &world->discs[ride->disc];
    if (own->x == other->x && own->y == other->y) return concentric_collision(world, ride, other, limit);
    const size_t steps = ride_steps(world, ride, limit);
    ride_sample before = sample(world, ride, other, 0.0);
    for (size_t i = 1; i <= steps; i++) {
        const ride_sample next = sample(world, ride, other, limit * (slow_real)i / (slow_real)steps);
        const slow_real met = first_collision(world, ride, other, before, next, DEEPEST);
        if (met < INFINITY) return met;
        before = next;
    }
    return limit;
}

slow_real slow_ride_free(const slow_world *world, const slow_ride *ride, slow_real limit)
{
    for (size_t i = 0; i < world->count && limit > 0.0; i++)
        if (i != ride->disc) limit = free_of_disc(world, ride, &world->discs[i], limit);
    return limit;
}

/* What a ride is watched for: one target on one side. */
typedef struct watch {
    const slow_world *world;
    const slow_ride *ride;
    slow_leave leave;
    slow_visitor visitor;
    void *ctx;
} watch;

typedef struct miss {
    slow_real turned;
    slow_real angle; /* NAN where there is no tangent */
} miss;

static miss miss_at(const watch *w, slow_real turned)
{
    const slow_moment at = slow_ride_at(w->world, w->ride, turned);
    slow_real heading, length;
    if (w->leave.target == SLOW_DESTINATION)
        heading = atan2(w->world->to_y - at.y, w->world->to_x - at.x);
    else if (!slow_tangent(&w->world->discs[w->leave.target], w->leave.side, at.x, at.y, at.time, &heading, &length))
        return (miss){turned, NAN};
    return (miss){turned, slow_wrap(at.heading - heading)};
}

static void tell(watch *w, slow_real turned)
{
    w->leave.turned = turned;
    w->visitor(w->ctx, &w->leave);
}

static int changes_sign(miss a, miss b)
{
    return (a.angle < 0.0) != (b.angle < 0.0) && fabs(a.angle) + fabs(b.angle) < SLOW_PI;
}

static void halve_to_zero(watch *w, miss a, miss b)
{
    for (int i = 0; i < 80; i++) {
        const slow_real middle = 0.5 * (a.turned + b.turned);
        if (middle <= a.turned || middle >= b.turned) break;
        const miss m = miss_at(w, middle);
        if (isnan(m.angle)) break;
        if (changes_sign(a, m))
            b = m;
        else
            a = m;
    }
    tell(w, fabs(a.angle) < fabs(b.angle) ? a.turned : b.turned);
}

static void watch_interval(watch *w, miss a, miss b, int depth)
{
    if (isnan(a.angle) && isnan(b.angle)) return;
    const int steep = isnan(a.angle) || isnan(b.angle) || fabs(slow_wrap(b.angle - a.angle)) > STEEP;
    if (steep && depth > 0) {
        const miss m = miss_at(w, 0.5 * (a.turned + b.turned));
        watch_interval(w, a, m, depth - 1);
        watch_interval(w, m, b, depth - 1);
    } else if (!steep && changes_sign(a, b)) {
        halve_to_zero(w, a, b);
    }
}

/* The miss came closest to zero at m: follow it there (golden section); it may cross twice or just touch. */
static void watch_bend(watch *w, miss a, miss m, miss b)
{
    const slow_real share = 0.3819660112501051;
    const miss begin = a, end = b;
    for (int i = 0; i < 70; i++) {
        const int left = m.turned - a.turned > b.turned - m.turned;
        const miss trial = miss_at(w, left ? m.turned - share * (m.turned - a.turned) : m.turned + share * (b.turned - m.turned));
        if (isnan(trial.angle)) return;
        if (changes_sign(m, trial)) {
            halve_to_zero(w, begin, trial);
            halve_to_zero(w, trial, end);
            return;
        }
        if (fabs(trial.angle) < fabs(m.angle)) {
            if (left)
                b = m;
            else
                a = m;
            m = trial;
        } else if (left) {
            a = trial;
        } else {
            b = trial;
        }
    }
    if (fabs(m.angle) < NEAR_ZERO) tell(w, m.turned);
}

static int bends_to_zero(miss a, miss m, miss b)
{
    if ((a.angle < 0.0) != (m.angle < 0.0) || (b.angle < 0.0) != (m.angle < 0.0)) return 0;
    return fabs(m.angle) < STEEP && fabs(m.angle) <= fabs(a.angle) && fabs(m.angle) <= fabs(b.angle);
}

static void watch_ride(watch *w, slow_real end)
{
    const size_t steps = ride_steps(w->world, w->ride, end);
    miss first = miss_at(w, 0.0), before = {0.0, NAN}, now = first;
    if (fabs(first.angle) < NEAR_ZERO) tell(w, 0.0);
    if (end <= 0.0) return;
    for (size_t i = 1; i <= steps; i++) {
        const miss next = miss_at(w, end * (slow_real)i / (slow_real)steps);
        watch_interval(w, now, next, DEEPEST);
        if (!isnan(before.angle) && bends_to_zero(before, now, next)) watch_bend(w, before, now, next);
        before = now;
        now = next;
    }
    if (fabs(now.angle) < NEAR_ZERO) tell(w, end);
}

void slow_ride_leaves(const slow_world *world, const slow_ride *ride, slow_real end, slow_visitor visitor, void *ctx)
{
    watch w = {world, ride, {0.0, SLOW_DESTINATION, 0}, visitor, ctx};
    watch_ride(&w, end);
    for (size_t i = 0; i < world->count; i++) {
        if (i == ride->disc) continue;
        for (int side = -1; side <= 1; side += 2) {
            w.leave = (slow_leave){0.0, i, side};
            watch_ride(&w, end);
        }
    }
}
