/* SPDX-License-Identifier: MIT */
/* What has been ridden already: the rule is in sweep.h. */
#include "search/sweep.h"

#include "geom/spiral.h"

/* Rides that start this close behind an angle count as having passed it. */
#define SAME_ANGLE 1e-12

/* Who passes within this share of the times at hand passes at the same time: then the older ride counts as the earlier one. */
#define SAME_MOMENT 1e-13

static int passed_before(double passed, double time, int is_older)
{
    double tie = SAME_MOMENT * (1.0 + fabs(time));
    return passed < time - tie || (is_older && passed <= time + tie);
}

static uint32_t sweep_first(const disc_engine *engine, uint32_t disc)
{
    return engine->stamps[disc] == engine->stamp ? engine->heads[disc] : ENGINE_NONE;
}

void sweep_add(disc_engine *engine, uint32_t ride)
{
    engine_ride *added = &engine->rides[ride];
    added->next = sweep_first(engine, added->disc);
    engine->heads[added->disc] = ride;
    engine->stamps[added->disc] = engine->stamp;
}

/* Could a rider at this angle at time `early` be at it at `late` by going straight along the radius? */
static int sweep_radius_free(disc_engine *engine, uint32_t disc, double normal, double early, double late)
{
    const geom_disc *self = engine_disc(engine, disc);
    double gain = disc_radius(self, late) - disc_radius(self, early);
    if (fabs(self->rate) <= engine->set->rate_min || gain == 0.0) return 1;
    tdsp_point outward = point_unit(normal);
    tdsp_point from = point_along(self->center, disc_radius(self, early), outward);
    geom_line line = {from, point_scale(gain > 0.0 ? 1.0 : -1.0, outward), gain > 0.0 ? early : late - fabs(gain), fabs(gain)};
    ++engine->legs_tested;
    return !index_line_blocked(&engine->view, &line, disc, INDEX_NONE);
}

/* When the ride passed the angle; infinite when it has not. */
static double sweep_passed(const disc_engine *engine, const engine_ride *ride, double normal)
{
    const geom_disc *disc = engine_disc(engine, ride->disc);
    double ahead = angle_positive(ride->side * (normal - ride->normal));
    if (ahead > GEOM_TURN - SAME_ANGLE) ahead = 0.0;
    double time = ride->start + spiral_duration(disc, ride->start, ahead);
    return time <= ride->now ? time : INFINITY;
}

/* Does this ride count for a rider of that side? What stops a robot first is asked among riders of one side only. */
static int sweep_counts(const disc_engine *engine, const engine_ride *ride, int side)
{
    return ride->side == side || !engine->question.explain;
}

int sweep_covers(disc_engine *engine, uint32_t disc, int side, double normal, double time)
{
    for (uint32_t r = sweep_first(engine, disc); r != ENGINE_NONE; r = engine->rides[r].next) {
        const engine_ride *ride = &engine->rides[r];
        if (!sweep_counts(engine, ride, side)) continue;
        double passed = sweep_passed(engine, ride, normal);
        if (passed_before(passed, time, ride->side == side) && sweep_radius_free(engine, disc, normal, passed, time)) return 1;
    }
    return 0;
}

/* Where a ride comes upon a place that another passed before. */
typedef struct sweep_meeting {
    double time;   /* infinite when it does not */
    double normal; /* the place */
    double passed; /* when the other was there */
} sweep_meeting;

/* The other of the same side: where it started, if it did so in time. */
static sweep_meeting sweep_follows(const geom_disc *disc, const engine_ride *other, double ahead, double from, int is_older)
{
    sweep_meeting meeting = {from + spiral_duration(disc, from, ahead), other->normal, other->start};
    if (!passed_before(other->start, meeting.time, is_older)) meeting.time = INFINITY;
    return meeting;
}

/*
 * The other of the other side: they are as far apart as the angle to the other's start, less what both have turned, and meet when both have
 * turned half of it. If the other has not come so far, where it is now.
 */
static sweep_meeting sweep_meets(const geom_disc *disc, const engine_ride *other, double ahead, double from)
{
    double head_start = spiral_angle(disc, from, other->start), turn = 0.5 * (ahead + head_start);
    sweep_meeting meeting = {INFINITY, other->normal, other->start};
    if (!passed_before(other->start, from + spiral_duration(disc, from, ahead), 0)) return meeting;
    meeting.time = meeting.passed = from + spiral_duration(disc, from, turn);
    if (other->now < meeting.time) {
        turn = ahead - spiral_angle(disc, other->start, other->now);
        meeting.time = from + spiral_duration(disc, from, turn);
        meeting.passed = other->now;
    }
    meeting.normal += other->side * (ahead - turn);
    return meeting;
}

double sweep_cut(disc_engine *engine, uint32_t ride, double from, double to)
{
    const engine_ride *self = &engine->rides[ride];
    const geom_disc *disc = engine_disc(engine, self->disc);
    double normal = self->normal + self->side * spiral_angle(disc, self->start, from);
    for (uint32_t r = sweep_first(engine, self->disc); r != ENGINE_NONE; r = engine->rides[r].next) {
        const engine_ride *other = &engine->rides[r];
        int same_side = other->side == self->side, is_older = same_side && r < ride;
        if (r == ride || !sweep_counts(engine, other, self->side)) continue;
        double passed = sweep_passed(engine, other, normal);
        if (passed_before(passed, from, is_older) && sweep_radius_free(engine, self->disc, normal, passed, from)) return from;
        double ahead = angle_positive(self->side * (other->normal - normal));
        sweep_meeting meeting = same_side ? sweep_follows(disc, other, ahead, from, is_older) : sweep_meets(disc, other, ahead, from);
        if (meeting.time < to && sweep_radius_free(engine, self->disc, meeting.normal, meeting.passed, meeting.time)) to = meeting.time;
    }
    return to;
}
