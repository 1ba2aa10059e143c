/* SPDX-License-Identifier: MIT */
/* Random chunks among random discs. */
#include "support/chunk.h"

#include <string.h>

#include "geom/spiral.h"
#include "geom/tangent.h"
#include "support/chance.h"
#include "support/cmocka_all.h"

/* Shorter legs than this only join a disc to one that it touches. */
#define NO_LENGTH 1e-9

static double random_rate(uint64_t *chance)
{
    static const double special[] = {0.0, 0.0, 1e-9, 0.5, 0.99, 1.0, 1.3};
    uint64_t pick = chance_below(chance, 14);
    return pick < 7 ? special[pick] : chance_between(chance, 0.0, 0.9);
}

static void fill(chunk_world *w, uint32_t count, uint64_t *chance)
{
    double size = chance_below(chance, 2) ? 0.05 : 0.4, same = chance_below(chance, 2) ? random_rate(chance) : -1.0;
    double scale = chance_between(chance, 0.1, 1.0);
    assert_int_equal(set_reserve(&w->set, &w->memory, count), TDSP_OK);
    w->set.count = count;
    for (uint32_t i = 0; i < count; ++i) {
        tdsp_point place = point_make(chance_between(chance, -2.0, 2.0), chance_between(chance, -2.0, 2.0));
        double radius = chance_below(chance, 12) ? chance_between(chance, 1e-3, size)
                                                 : ldexp(size, -(int)chance_below(chance, 24)); /* a pebble */
        w->set.forward[i] = disc_make(place, radius, scale * (same >= 0.0 ? same : random_rate(chance)));
        w->set.origin[i] = i;
    }
    assert_int_equal(set_prepare(&w->set, &w->memory), TDSP_OK);
    w->rate = w->set.index.nodes[0].rate;
}

/* A chunk as rides are followed: up to 0.6 rad, the radius at most doubled or halved. */
static void choose_chunk(chunk_world *w, double start, int forwards, uint64_t *chance)
{
    for (w->self = 0; w->self + 1 < w->set.count && !disc_ridable(&w->discs[w->self]);) ++w->self;
    const geom_disc *disc = &w->discs[w->self];
    double angle = chance_between(chance, 0.0, 0.6), growth = 0.69 * disc->sine;
    if (growth < angle * fabs(disc->rate)) angle = growth / fabs(disc->rate);
    w->motion.disc = disc;
    w->motion.side = chance_below(chance, 2) ? 1 : -1;
    w->motion.angle = chance_between(chance, -9.0, 9.0);
    w->motion.start = start;
    w->motion.end = start + (chance_below(chance, 16) ? spiral_duration(disc, start, angle) : 0.0);
    w->late = forwards ? w->motion.end : -w->motion.start;
}

static void choose_start(chunk_world *w, double start, int forwards, uint64_t *chance)
{
    w->self = INDEX_NONE;
    w->point = disc_point(point_make(chance_between(chance, -2.0, 2.0), chance_between(chance, -2.0, 2.0)));
    geom_ride motion = {&w->point, 1, 0.0, start, start};
    w->motion = motion;
    w->late = forwards ? start : -start;
}

/* Half of all worlds run backwards in time. */
void chunk_world_make(chunk_world *w, int is_start, uint64_t *chance)
{
    memset(w, 0, sizeof *w);
    w->memory = memory_allocator(NULL);
    fill(w, 2 + (uint32_t)chance_below(chance, CHUNK_MOST - 1), chance);
    assert_int_equal(neighbours_begin(&w->around, &w->memory, &w->set), TDSP_OK);
    int forwards = (int)chance_below(chance, 2);
    double start = chance_between(chance, 0.0, 0.8);
    w->discs = forwards ? w->set.forward : w->set.reverse;
    if (is_start) choose_start(w, forwards ? start : -start, forwards, chance);
    if (!is_start) choose_chunk(w, forwards ? start : -start, forwards, chance);
}

void chunk_world_free(chunk_world *w)
{
    neighbours_free(&w->around, &w->memory);
    set_free(&w->set, &w->memory);
}

/* One that can be ridden from, at a chunk's start. */
static int chunk_world_is_good(const chunk_world *w)
{
    return w->self == INDEX_NONE ||
           (disc_ridable(w->motion.disc) && disc_radius(w->motion.disc, w->motion.start) > 1e-6 && w->motion.end < 1e3);
}

int chunk_sectors(const chunk_world *w)
{
    return w->self == INDEX_NONE ? CHUNK_SECTORS : 1;
}

look_wedge chunk_wedge(const chunk_world *w, int sector)
{
    look_wedge wedge;
    memset(&wedge, 0, sizeof wedge);
    if (w->self != INDEX_NONE) wedge_of_chunk(&wedge, &w->motion, w->late, w->rate);
    double half = GEOM_PI / CHUNK_SECTORS, heading = (2 * sector + 1) * half;
    if (w->self == INDEX_NONE)
        wedge_of_sector(&wedge, &w->motion, heading > GEOM_PI ? heading - GEOM_TURN : heading, half, w->late, w->rate);
    return wedge;
}

static int chunk_leg_solve(const chunk_world *w, uint32_t disc, int to_side, int root, chunk_leg *out)
{
    geom_pair pair = pair_make(w->motion.disc, &w->discs[disc]);
    geom_tangent tangent = tangent_make(&pair, w->motion.side, to_side, root);
    double leave = w->motion.start;
    geom_leg taken;
    if (disc == w->self || !disc_ridable(&w->discs[disc]) || !tangent_possible(&tangent)) return 0;
    if (w->self == INDEX_NONE) {
        double ends[4];
        if (!tangent_domain(&tangent, leave, leave, ends)) return 0;
        taken = (geom_leg){0.0, tangent_heading(&tangent, leave), tangent_length(&tangent, leave)};
    } else {
        if (!tangent_leave(&tangent, w->motion.angle, w->motion.start, w->motion.end, &leave)) return 0;
        taken = tangent_leg(&tangent, ride_angle(&w->motion, leave), leave);
    }
    out->disc = disc;
    out->to_side = to_side;
    out->root = root;
    out->heading = taken.heading;
    out->length = taken.length;
    geom_line line = {disc_boundary(w->motion.disc, taken.normal, leave), point_unit(out->heading), leave, out->length};
    out->line = line;
    return out->length > NO_LENGTH && disc_radius(&w->discs[disc], leave + taken.length) > 0.0; /* backwards in time a disc may be gone by then */
}

int chunk_legs(const chunk_world *w, chunk_leg legs[4 * CHUNK_MOST])
{
    int count = 0;
    for (uint32_t disc = 0; disc < w->set.count; ++disc)
        for (int branch = 0; branch < 4; ++branch)
            count += chunk_leg_solve(w, disc, branch & 1 ? 1 : -1, branch & 2 ? 1 : -1, &legs[count]);
    return count;
}

int chunk_leg_blocked(const chunk_world *w, const chunk_leg *self)
{
    for (uint32_t disc = 0; disc < w->set.count; ++disc)
        if (disc != w->self && disc != self->disc && line_blocked(&self->line, &w->discs[disc])) return 1;
    return 0;
}

geom_line chunk_ray(const chunk_world *w, const look_wedge *wedge, double x, double length)
{
    const geom_disc *disc = w->motion.disc;
    double heading = wedge->heading + w->motion.side * x;
    if (w->self == INDEX_NONE) {
        geom_line from_start = {w->point.center, point_unit(heading), w->motion.start, length};
        return from_start;
    }
    double turn = w->motion.side * (ride_angle(&w->motion, w->motion.end) - w->motion.angle);
    double ridden = fmin(fmax(x + 0.5 * turn, 0.0), turn);
    double leave = fmin(w->motion.start + spiral_duration(disc, w->motion.start, ridden), w->motion.end);
    geom_line ray = {ride_position(&w->motion, leave),
                     point_unit(disc_heading(disc, w->motion.side, w->motion.angle + w->motion.side * ridden)), leave, length};
    return ray;
}

void chunk_each(int count, uint64_t seed, chunk_check check)
{
    uint64_t chance = seed;
    int good = 0;
    for (int k = 0; k < count; ++k) {
        static chunk_world w;
        chunk_world_make(&w, k % 4 == 0, &chance);
        if (chunk_world_is_good(&w)) {
            check(&w, &chance);
            ++good;
        }
        chunk_world_free(&w);
    }
    assert_true(good > count / 2);
}
