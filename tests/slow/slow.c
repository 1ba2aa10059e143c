/* SPDX-License-Identifier: MIT */
/* The search of slow.h: rides in the order of time plus the straight way left. */
#include "slow/slow.h"

#include <stdlib.h>
#include <tgmath.h>

#include "slow/slow_ride.h"
#include "slow/slow_world.h"

#define MOST_RIDES 40000
#define SAME_TIME (450.0 * SLOW_EPSILON)  /* 1e-13 for a double */
#define SAME_ANGLE (4500.0 * SLOW_EPSILON) /* 1e-12 */
/* Where discs touch, a ride and a leg both shorter than this lead nowhere that the ride before does not: 1e-7. */
#define NO_MOVE (4.5e8 * SLOW_EPSILON)
#define NOWHERE ((size_t)-1)

typedef struct node {
    slow_ride ride;
    size_t from;   /* the ride that was left for this one, NOWHERE for the source */
    slow_real turned; /* how far that one had turned */
    slow_real bound;  /* time plus the straight way left */
    slow_real end;    /* once explored: how far it is free; negative before */
} node;

typedef struct search {
    slow_world world;
    slow_real departure;
    node *nodes;
    size_t count;
    size_t *heap; /* open nodes, least bound first */
    size_t open;
    size_t exploring; /* the ride whose leaves are being told */
    int overflow;
    slow_real last; /* nobody arrives later, for the destination is covered */
    slow_real best; /* arrival */
    size_t best_from;
    slow_real best_turned;
} search;

static void heap_add(search *s, size_t added)
{
    size_t at = s->open++;
    while (at > 0 && s->nodes[s->heap[(at - 1) / 2]].bound > s->nodes[added].bound) {
        s->heap[at] = s->heap[(at - 1) / 2];
        at = (at - 1) / 2;
    }
    s->heap[at] = added;
}

static size_t heap_take(search *s)
{
    const size_t taken = s->heap[0], moved = s->heap[--s->open];
    size_t at = 0;
    for (;;) {
        size_t child = 2 * at + 1;
        if (child >= s->open) break;
        if (child + 1 < s->open && s->nodes[s->heap[child + 1]].bound < s->nodes[s->heap[child]].bound) child++;
        if (s->nodes[s->heap[child]].bound >= s->nodes[moved].bound) break;
        s->heap[at] = s->heap[child];
        at = child;
    }
    s->heap[at] = moved;
    return taken;
}

static void add_ride(search *s, slow_ride ride, slow_real turned)
{
    const slow_moment at = slow_ride_at(&s->world, &ride, 0.0);
    const slow_real bound = ride.time + hypot(s->world.to_x - at.x, s->world.to_y - at.y);
    if (bound >= s->best || slow_radius(&s->world.discs[ride.disc], ride.time) <= 0.0) return;
    if (s->count == MOST_RIDES) {
        s->overflow = 1;
        return;
    }
    s->nodes[s->count] = (node){ride, s->exploring, turned, bound, -1.0};
    heap_add(s, s->count++);
}

static void arrive(search *s, slow_real time, slow_real turned)
{
    if (time >= s->best) return;
    s->best = time;
    s->best_from = s->exploring;
    s->best_turned = turned;
}

static void leave_for_destination(search *s, slow_real x, slow_real y, slow_real time, slow_real turned)
{
    const slow_real dx = s->world.to_x - x, dy = s->world.to_y - y, length = hypot(dx, dy);
    if (slow_line_free(&s->world, x, y, atan2(dy, dx), time, length)) arrive(s, time + length, turned);
}

static void leave_for_disc(search *s, size_t disc, int side, slow_real x, slow_real y, slow_real time, slow_real turned)
{
    const slow_disc *target = &s->world.discs[disc];
    slow_real heading, length;
    if (!slow_tangent(target, side, x, y, time, &heading, &length)) return;
    if (s->exploring != NOWHERE && turned < NO_MOVE && length < NO_MOVE) return;
    if (!slow_line_free(&s->world, x, y, heading, time, length)) return;
    const slow_real rest = sqrt((1.0 - target->rate) * (1.0 + target->rate));
    add_ride(s, (slow_ride){disc, side, heading - side * atan2(rest, target->rate), time + length}, turned);
}

static void on_leave(void *ctx, const slow_leave *leave)
{
    search *s = ctx;
    const slow_ride ride = s->nodes[s->exploring].ride;
    const slow_moment at = slow_ride_at(&s->world, &ride, leave->turned);
    if (leave->target == SLOW_DESTINATION)
        leave_for_destination(s, at.x, at.y, at.time, leave->turned);
    else
        leave_for_disc(s, leave->target, leave->side, at.x, at.y, at.time, leave->turned);
}

/* The source: every tangent from it, and every boundary that it lies on. */
static void explore_source(search *s)
{
    const slow_world *world = &s->world;
    s->exploring = NOWHERE;
    leave_for_destination(s, 0.0, 0.0, s->departure, 0.0);
    for (size_t i = 0; i < world->count; i++) {
        const slow_disc *disc = &world->discs[i];
        const int touches = fabs(slow_clearance(disc, 0.0, 0.0, s->departure)) <= slow_slack(disc, 0.0, 0.0, s->departure);
        for (int side = -1; side <= 1; side += 2) {
            leave_for_disc(s, i, side, 0.0, 0.0, s->departure, 0.0);
            if (touches && disc->rate < 1.0) add_ride(s, (slow_ride){i, side, atan2(-disc->y, -disc->x), s->departure}, 0.0);
        }
    }
}

/* Was `earlier` at the angle where this ride begins, and free to run straight out to its place? */
static int outrun(const search *s, const node *earlier, const node *later)
{
    if (earlier->ride.disc != later->ride.disc || earlier->end < 0.0) return 0;
    const slow_real ahead = earlier->ride.side * (later->ride.angle - earlier->ride.angle);
    const slow_real turned = slow_wrap_positive(ahead) < 2.0 * SLOW_PI - SAME_ANGLE ? slow_wrap_positive(ahead) : 0.0;
    if (turned > earlier->end) return 0;
    const slow_moment at = slow_ride_at(&s->world, &earlier->ride, turned);
    const slow_real lead = later->ride.time - at.time;
    if (lead <= SAME_TIME * later->ride.time)
        return lead >= -SAME_TIME * later->ride.time && earlier->ride.side == later->ride.side;
    const slow_real length = lead * s->world.discs[later->ride.disc].rate;
    return slow_line_free(&s->world, at.x, at.y, later->ride.angle, at.time, length);
}

static int is_outrun(const search *s, const node *later)
{
    for (size_t i = 0; i < s->count; i++)
        if (outrun(s, &s->nodes[i], later)) return 1;
    return 0;
}

/* The destination on the boundary of the ridden disc is reached without a last line. */
static void ride_onto_destination(search *s, const slow_ride *ride, slow_real end)
{
    const slow_disc *disc = &s->world.discs[ride->disc];
    const slow_real angle = atan2(s->world.to_y - disc->y, s->world.to_x - disc->x);
    const slow_real turned = slow_wrap_positive(ride->side * (angle - ride->angle));
    if (turned > end + SAME_ANGLE) return;
    const slow_moment at = slow_ride_at(&s->world, ride, turned);
    if (hypot(at.x - s->world.to_x, at.y - s->world.to_y) <= slow_slack(disc, at.x, at.y, at.time)) arrive(s, at.time, turned);
}

static void explore(search *s, size_t chosen)
{
    const slow_ride ride = s->nodes[chosen].ride;
    if (is_outrun(s, &s->nodes[chosen])) return;
    /* Nobody who turns once round, or who is later than the best arrival or the last, does anything of use. */
    slow_real limit = 2.0 * SLOW_PI;
    const slow_real latest = fmin(s->best, s->last);
    if (latest < INFINITY) limit = fmin(limit, slow_ride_turned(&s->world, &ride, latest));
    const slow_real end = slow_ride_free(&s->world, &ride, limit);
    s->nodes[chosen].end = end;
    s->exploring = chosen;
    ride_onto_destination(s, &ride, end);
    slow_ride_leaves(&s->world, &ride, end, on_leave, s);
}

/* When the destination is covered, and a little later: a touch is none. */
static slow_real last_arrival(const slow_world *world)
{
    slow_real last = INFINITY;
    for (size_t i = 0; i < world->count; i++) {
        const slow_disc *disc = &world->discs[i];
        if (disc->rate > 0.0) last = fmin(last, slow_clearance(disc, world->to_x, world->to_y, 0.0) / disc->rate);
    }
    return last + 1e-6 * (1.0 + fabs(last));
}

static int search_begin(search *s, const tdsp_journey *journey, const tdsp_disc *discs, size_t count, slow_real departure)
{
    s->nodes = NULL;
    s->heap = NULL;
    if (count > SLOW_DISCS) return 0;
    slow_world_make(&s->world, journey, discs, count);
    s->departure = departure / s->world.time;
    s->nodes = malloc(MOST_RIDES * sizeof *s->nodes);
    s->heap = malloc(MOST_RIDES * sizeof *s->heap);
    s->count = s->open = 0;
    s->exploring = s->best_from = NOWHERE;
    s->last = last_arrival(&s->world);
    s->best = INFINITY;
    s->best_turned = 0.0;
    s->overflow = 0;
    return s->nodes && s->heap;
}

static void search_run(search *s)
{
    if (!slow_point_free(&s->world, 0.0, 0.0, s->departure)) return;
    if (s->world.to_x == 0.0 && s->world.to_y == 0.0) {
        s->best = s->departure;
        return;
    }
    explore_source(s);
    while (s->open > 0 && !s->overflow) {
        const size_t chosen = heap_take(s);
        if (s->nodes[chosen].bound >= s->best) return;
        explore(s, chosen);
    }
}

static tdsp_point user_point(const slow_world *world, slow_real x, slow_real y)
{
    return (tdsp_point){(double)(world->origin.x + world->length * x), (double)(world->origin.y + world->length * y)};
}

static tdsp_leg line_leg(const slow_world *world, slow_moment from, slow_moment to)
{
    return (tdsp_leg){.kind = TDSP_LEG_LINE,
                      .disc = TDSP_NO_DISC,
                      .start_time = (double)(from.time * world->time),
                      .end_time = (double)(to.time * world->time),
                      .from = user_point(world, from.x, from.y),
                      .to = user_point(world, to.x, to.y)};
}

static tdsp_leg ride_leg(const slow_world *world, const slow_ride *ride, slow_real turned)
{
    const slow_moment from = slow_ride_at(world, ride, 0.0), to = slow_ride_at(world, ride, turned);
    const slow_disc *disc = &world->discs[ride->disc];
    tdsp_leg leg = line_leg(world, from, to);
    leg.kind = TDSP_LEG_ARC;
    leg.disc = (uint32_t)ride->disc;
    leg.turn = ride->side;
    leg.center = user_point(world, disc->x, disc->y);
    leg.radius_from = (double)(slow_radius(disc, from.time) * world->length);
    leg.radius_to = (double)(slow_radius(disc, to.time) * world->length);
    leg.angle_from = (double)ride->angle;
    leg.sweep = (double)turned;
    return leg;
}

/* The legs from the destination back to the source, then turned round. */
static size_t trace(const search *s, tdsp_leg *legs, size_t capacity)
{
    slow_moment next = {s->world.to_x, s->world.to_y, s->best, 0.0};
    slow_real turned = s->best_turned;
    size_t count = 0;
    for (size_t i = s->best_from;; i = s->nodes[i].from) {
        const slow_moment left =
            i == NOWHERE ? (slow_moment){0.0, 0.0, s->departure, 0.0} : slow_ride_at(&s->world, &s->nodes[i].ride, turned);
        if (count + 2 > capacity) return 0;
        if (next.time > left.time) legs[count++] = line_leg(&s->world, left, next);
        if (i == NOWHERE) break;
        if (turned > 0.0) legs[count++] = ride_leg(&s->world, &s->nodes[i].ride, turned);
        next = slow_ride_at(&s->world, &s->nodes[i].ride, 0.0);
        turned = s->nodes[i].turned;
    }
    for (size_t i = 0; i < count / 2; i++) {
        const tdsp_leg kept = legs[i];
        legs[i] = legs[count - 1 - i];
        legs[count - 1 - i] = kept;
    }
    return count;
}

slow_real slow_path(const tdsp_journey *journey, const tdsp_disc *discs, size_t count, slow_real departure, tdsp_leg *legs,
                 size_t capacity, size_t *leg_count)
{
    search s;
    slow_real arrival = NAN;
    *leg_count = 0;
    if (search_begin(&s, journey, discs, count, departure)) {
        search_run(&s);
        /* A destination at the source is reached when leaving. */
        const slow_real found = s.best == s.departure ? departure : s.best * s.world.time;
        arrival = s.overflow ? NAN : found;
        if (arrival < INFINITY && arrival > departure) *leg_count = trace(&s, legs, capacity);
    }
    free(s.nodes);
    free(s.heap);
    return arrival;
}

slow_real slow_arrival(const tdsp_journey *journey, const tdsp_disc *discs, size_t count, slow_real departure)
{
    size_t legs;
    return slow_path(journey, discs, count, departure, NULL, 0, &legs);
}

slow_real slow_departure(const tdsp_journey *journey, const tdsp_disc *discs, size_t count, slow_real arrival)
{
    slow_real low = 0.0, high = arrival;
    slow_real at = slow_arrival(journey, discs, count, low);
    if (isnan(at)) return NAN;
    if (!(at <= arrival)) return -1.0;
    while (high - low > SAME_TIME * arrival) {
        const slow_real middle = 0.5 * (low + high);
        if (middle <= low || middle >= high) break;
        at = slow_arrival(journey, discs, count, middle);
        if (isnan(at)) return NAN;
        if (at <= arrival)
            low = middle;
        else
            high = middle;
    }
    return low;
}
