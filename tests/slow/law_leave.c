/* SPDX-License-Identifier: MIT */
/*
 * Where a ride can be left: the miss is the angle from the robot's own direction to that of the line to a target. A leave is a change of
 * its sign along the ride; at a kink where the rate falls it is one along the directions between the two tangents. An interval over which
 * the miss moves much, or bends towards zero between its samples, is looked at more closely.
 */
#include <math.h>

#include "slow/law_ride.h"

#define STEEP 0.2      /* radians of miss over one interval */
#define NEAR_ZERO 1e-9 /* a miss that counts as none at an end or at a bend */
#define DEEPEST 40

static const double pi = 3.14159265358979323846;

/* What a ride is watched for, along one panel or one kink. */
typedef struct watch {
    const law_world *world;
    const law_ride *ride;
    size_t piece;
    int fan;           /* a kink: places are directions, at `corner` */
    law_moment corner; /* where and when */
    law_leave leave;   /* the target */
    double hint;
    law_visitor visitor;
    void *ctx;
} watch;

/* The miss at a place: a time of the ride, or a direction at the kink. */
typedef struct miss {
    double place;
    double angle; /* NAN where the target is over */
} miss;

static law_moment moment_at(const watch *w, double place)
{
    if (!w->fan) return law_ride_at(w->world, w->ride, w->piece, place);
    law_moment at = w->corner;
    at.heading = place;
    return at;
}

static miss miss_at(watch *w, double place)
{
    const law_moment at = moment_at(w, place);
    if (w->leave.target == LAW_DESTINATION)
        return (miss){place, law_wrap(at.heading - atan2(w->world->to_y - at.y, w->world->to_x - at.x))};
    const law_disc *d = &w->world->discs[w->leave.target];
    law_landing landing;
    /* From the stretch that is being ridden to itself leads no line but the ride. */
    if (w->leave.target == w->ride->disc && d->spots[w->leave.spot].from <= at.time) return (miss){place, NAN};
    if (!law_world_land(w->world, w->leave.target, &d->spots[w->leave.spot], at.x, at.y, at.time, w->hint, &landing))
        return (miss){place, NAN};
    w->hint = landing.time;
    const double center = atan2(d->y - at.y, d->x - at.x);
    return (miss){place, law_wrap(at.heading - (center - w->leave.side * landing.aside))};
}

static void tell(watch *w, double place)
{
    w->leave.at = moment_at(w, place);
    w->visitor(w->ctx, &w->leave);
}

static int changes_sign(miss a, miss b)
{
    return (a.angle < 0.0) != (b.angle < 0.0) && fabs(a.angle) + fabs(b.angle) < pi;
}

static void halve_to_zero(watch *w, miss a, miss b)
{
    for (int i = 0; i < 80; i++) {
        const double middle = 0.5 * (a.place + b.place);
        if (middle <= fmin(a.place, b.place) || middle >= fmax(a.place, b.place)) break;
        const miss m = miss_at(w, middle);
        if (isnan(m.angle)) break;
        if (changes_sign(a, m))
            b = m;
        else
            a = m;
    }
    tell(w, fabs(a.angle) < fabs(b.angle) ? a.place : b.place);
}

static void watch_interval(watch *w, miss a, miss b, int depth)
{
    if (isnan(a.angle)) return;
    const int steep = isnan(b.angle) || fabs(law_wrap(b.angle - a.angle)) > STEEP;
    if (steep && depth > 0) {
        const miss m = miss_at(w, 0.5 * (a.place + b.place));
        watch_interval(w, a, m, depth - 1);
        watch_interval(w, m, b, depth - 1);
    } else if (!isnan(b.angle) && changes_sign(a, b)) {
        halve_to_zero(w, a, b);
    }
}

/* The miss came closest to zero at m: follow it there (golden section); it may cross twice or just touch. */
static void watch_bend(watch *w, miss a, miss m, miss b)
{
    const double share = 0.3819660112501051;
    const miss begin = a, end = b;
    for (int i = 0; i < 70; i++) {
        const int left = m.place - a.place > b.place - m.place;
        const miss trial = miss_at(w, left ? m.place - share * (m.place - a.place) : m.place + share * (b.place - m.place));
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
    if (fabs(m.angle) < NEAR_ZERO) tell(w, m.place);
}

static int bends_to_zero(miss a, miss m, miss b)
{
    if (isnan(a.angle) || isnan(m.angle) || isnan(b.angle)) return 0;
    if ((a.angle < 0.0) != (m.angle < 0.0) || (b.angle < 0.0) != (m.angle < 0.0)) return 0;
    return fabs(m.angle) < STEEP && fabs(m.angle) <= fabs(a.angle) && fabs(m.angle) <= fabs(b.angle);
}

/* Three samples in a row, and the interval between the last two. */
static void watch_sample(watch *w, miss last[2], double place)
{
    const miss next = miss_at(w, place);
    watch_interval(w, last[1], next, DEEPEST);
    if (bends_to_zero(last[0], last[1], next)) watch_bend(w, last[0], last[1], next);
    last[0] = last[1];
    last[1] = next;
}

/* Over the ride's panels: those of one piece join without a jump of the rate. */
static void watch_ride(watch *w, double end)
{
    const law_disc *d = &w->world->discs[w->ride->disc];
    miss last[2] = {{0.0, NAN}, {0.0, NAN}};
    int begun = 0;
    w->fan = 0;
    w->hint = 0.0;
    for (size_t k = 0; k < d->panel_count && d->panels[k].from < end; k++) {
        const double from = fmax(d->panels[k].from, w->ride->time), to = fmin(d->panels[k].to, end);
        if (to <= w->ride->time) continue;
        if (!begun || d->panels[k].piece != w->piece) {
            w->piece = d->panels[k].piece;
            last[0].angle = NAN;
            last[1] = miss_at(w, from);
            if (fabs(last[1].angle) < NEAR_ZERO) tell(w, from);
            begun = 1;
        }
        const size_t steps = law_ride_steps(w->world, w->ride, from, to);
        for (size_t i = 1; i <= steps; i++) watch_sample(w, last, law_ride_step(from, to, i, steps));
    }
    if (begun && fabs(last[1].angle) < NEAR_ZERO) tell(w, last[1].place);
}

/* At each kink from the ride's begin to its end. */
static void watch_kinks(watch *w, double end)
{
    const law_disc *d = &w->world->discs[w->ride->disc];
    w->fan = 1;
    w->hint = 0.0;
    for (size_t k = 0; k < d->spot_count; k++) {
        const law_spot *s = &d->spots[k];
        if (!s->kink || s->from < w->ride->time || s->from > end) continue;
        w->corner = law_ride_at(w->world, w->ride, s->piece, s->from);
        const double radial = w->corner.heading - w->ride->side * acos(s->slow);
        const miss fast = miss_at(w, radial + w->ride->side * acos(s->fast)),
                   slow = miss_at(w, radial + w->ride->side * acos(s->slow));
        if (!isnan(fast.angle) && !isnan(slow.angle) && changes_sign(fast, slow)) halve_to_zero(w, fast, slow);
        if (fabs(fast.angle) < NEAR_ZERO) tell(w, fast.place);
        if (fabs(slow.angle) < NEAR_ZERO) tell(w, slow.place);
    }
}

static void watch_target(watch *w, double end)
{
    watch_ride(w, end);
    watch_kinks(w, end);
}

void law_ride_leaves(const law_world *world, const law_ride *ride, double end, law_visitor visitor, void *ctx)
{
    watch w = {.world = world, .ride = ride, .visitor = visitor, .ctx = ctx};
    w.leave.target = LAW_DESTINATION;
    watch_target(&w, end);
    for (size_t i = 0; i < world->count; i++)
        for (w.leave.spot = 0; w.leave.spot < world->discs[i].spot_count; w.leave.spot++)
            for (int side = -1; side <= 1; side += 2) {
                w.leave.target = i;
                w.leave.side = side;
                if (i != ride->disc || side == ride->side) watch_target(&w, end);
            }
}
