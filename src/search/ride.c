/* SPDX-License-Identifier: MIT */
/* Following a ride, one chunk at a time. */
#include "geom/spiral.h"
#include "search/engine.h"
#include "search/sweep.h"

/* A chunk turns by this angle at most: what it can see then fits into a narrow wedge. */
#define CHUNK_ANGLE 0.6

/* ... and the radius at most doubles or halves meanwhile. */
#define CHUNK_GROWTH 0.69314718055994530942

static double chunk_angle(const geom_disc *disc)
{
    double growth = CHUNK_GROWTH * disc->sine;
    return growth < CHUNK_ANGLE * fabs(disc->rate) ? growth / fabs(disc->rate) : CHUNK_ANGLE;
}

geom_ride engine_ride_motion(const disc_engine *engine, const engine_ride *ride, double from, double to)
{
    const geom_disc *disc = engine_disc(engine, ride->disc);
    geom_ride motion = {disc, ride->side, ride->normal + ride->side * spiral_angle(disc, ride->start, from), from, to};
    return motion;
}

/* When a shrinking disc is too small to ride on. */
static double ride_vanishes(const geom_disc *disc)
{
    return disc->rate < 0.0 ? (ENGINE_LEAST_RIDE - disc->radius) / disc->rate : INFINITY;
}

/* The end of the chunk that begins now: by angle, by one lap, by the limit, by the disc itself, by other rides, by other discs. */
static double chunk_end(disc_engine *engine, uint32_t r, int *ended)
{
    const engine_ride *ride = &engine->rides[r];
    const geom_disc *disc = engine_disc(engine, ride->disc);
    double from = ride->now, full = from + spiral_duration(disc, from, chunk_angle(disc));
    double lap = ride->start + spiral_duration(disc, ride->start, GEOM_TURN);
    double to = math_min(math_min(full, lap), math_min(engine->limit, ride_vanishes(disc)));
    if (to > from) to = sweep_cut(engine, r, from, to);
    if (to > from) {
        geom_ride motion = engine_ride_motion(engine, ride, from, to);
        to = math_min(to, index_ride_contact(&engine->view, &motion, ride->disc));
    }
    *ended = !(to >= full) || !(full > from); /* round a pebble too small for time to pass */
    return to;
}

/*
 * When the question is why there is no way: the disc ridden may be the one that covers the goal, and then no leg to the goal is left. The rider
 * has come as near as it can when it passes in front of it.
 */
static tdsp_status ride_explain(disc_engine *engine, uint32_t r, double from, double to, int *done)
{
    geom_ride motion = engine_ride_motion(engine, &engine->rides[r], from, to);
    tdsp_point offset = point_sub(engine->question.goal, motion.disc->center);
    double ahead = angle_positive(motion.side * (math_atan2(offset.y, offset.x) - motion.angle));
    double pass = from + spiral_duration(motion.disc, from, ahead);
    if (!(pass <= to) || point_length(offset) > disc_radius(motion.disc, pass)) return TDSP_OK;
    double normal = ride_angle(&motion, pass);
    engine_leg leg = {r, ENGINE_GOAL, motion.side, 0, pass, normal, disc_heading(motion.disc, motion.side, normal), 0.0, 0.0};
    return engine_arrive(engine, &leg, done);
}

tdsp_status ride_follow(disc_engine *engine, uint32_t r, int *done)
{
    ++engine->chunks;
    ++engine->chunks_followed;
    int ended, first = engine->rides[r].now == engine->rides[r].start;
    double from = engine->rides[r].now, to = chunk_end(engine, r, &ended);
    if (to > from || (first && to == from)) {
        tdsp_status status = engine->question.explain ? ride_explain(engine, r, from, to, done) : TDSP_OK;
        if (status == TDSP_OK && !*done) status = leaves_push(engine, r, from, to, done);
        if (status != TDSP_OK || *done) return status;
    }
    engine_ride *ride = &engine->rides[r];
    if (to > from) ride->now = to;
    if (ended) return TDSP_OK;
    geom_ride motion = engine_ride_motion(engine, ride, to, to);
    ride->bound = engine_bound(engine, disc_boundary(motion.disc, motion.angle, to));
    if (to + ride->bound > engine->limit) return TDSP_OK;
    tdsp_label label = {to, r, 1};
    return tdsp_search_push(engine->open, &label);
}
