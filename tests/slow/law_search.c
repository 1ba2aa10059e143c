/* SPDX-License-Identifier: MIT */
/* The search of law.h: rides in the order of time plus the straight way left. */
#include <math.h>
#include <stdlib.h>

#include "slow/law_ride.h"
#include "slow/law_world.h"

#define MOST_RIDES 20000
#define SAME_TIME 1e-13
#define NO_MOVE 1e-7 /* where discs touch, a ride and a leg both shorter than this lead nowhere that the ride before does not */
#define TANGENT 1e-6 /* a line that differs by this much from one that touches is not worth following */
#define NOWHERE ((size_t)-1)

static const double pi = 3.14159265358979323846;

typedef struct node {
    law_ride ride;
    size_t from;   /* the ride that was left for this one, NOWHERE for the source */
    double left;   /* when that one was left */
    double bound;  /* time plus the straight way left */
    double end;    /* once explored: until when it goes on; negative before */
    double turned; /* and the angle up to then */
    int open;
} node;

typedef struct search {
    law_world world;
    double departure;
    node *nodes;
    size_t count;
    size_t exploring; /* the ride whose leaves are being told */
    int overflow;
    double best; /* arrival */
    size_t best_from;
    double best_left;
} search;

static void add_ride(search *s, law_ride ride, law_moment at, double left)
{
    const double bound = at.time + hypot(s->world.to_x - at.x, s->world.to_y - at.y);
    if (bound >= s->best || at.time > s->world.until) return;
    if (s->count == MOST_RIDES) {
        s->overflow = 1;
        return;
    }
    s->nodes[s->count++] = (node){ride, s->exploring, left, bound, -1.0, 0.0, 1};
}

static void arrive(search *s, double time, double left)
{
    if (time >= s->best) return;
    s->best = time;
    s->best_from = s->exploring;
    s->best_left = left;
}

static void leave_for_destination(search *s, const law_moment *at)
{
    const double dx = s->world.to_x - at->x, dy = s->world.to_y - at->y, length = hypot(dx, dy);
    if (law_world_line_free(&s->world, at->x, at->y, atan2(dy, dx), at->time, length)) arrive(s, at->time + length, at->time);
}

static void leave_for_spot(search *s, size_t disc, size_t spot, int side, const law_moment *at)
{
    const law_disc *d = &s->world.discs[disc];
    law_landing landing;
    if (!law_world_land(&s->world, disc, &d->spots[spot], at->x, at->y, at->time, 0.0, &landing)) return;
    if (fabs(landing.excess) > TANGENT) return;
    const double length = landing.time - at->time;
    if (s->exploring != NOWHERE && at->time - s->nodes[s->exploring].ride.time < NO_MOVE && length < NO_MOVE) return;
    const double heading = atan2(d->y - at->y, d->x - at->x) - side * landing.aside;
    if (!law_world_line_free(&s->world, at->x, at->y, heading, at->time, length)) return;
    const law_moment there = {at->x + length * cos(heading), at->y + length * sin(heading), landing.time, heading};
    const law_ride ride = {disc, side, atan2(there.y - d->y, there.x - d->x), landing.time};
    add_ride(s, ride, there, at->time);
}

static void on_leave(void *ctx, const law_leave *leave)
{
    search *s = ctx;
    if (leave->target == LAW_DESTINATION)
        leave_for_destination(s, &leave->at);
    else
        leave_for_spot(s, leave->target, leave->spot, leave->side, &leave->at);
}

static int touches(const search *s, size_t disc, const law_spot *spot, const law_moment *at)
{
    if (at->time < spot->from || at->time > spot->to) return 0;
    const slow_jet jet = law_world_jet(&s->world, disc, spot->piece, at->time);
    return jet.radius > 0.0 && fabs(law_world_clearance(&s->world, disc, spot->piece, at->x, at->y, at->time)) <= 1e-12;
}

/* The source: every touching line from it, and every boundary that it lies on. */
static void explore_source(search *s)
{
    const law_moment at = {0.0, 0.0, s->departure, 0.0};
    s->exploring = NOWHERE;
    leave_for_destination(s, &at);
    for (size_t i = 0; i < s->world.count; i++) {
        const law_disc *d = &s->world.discs[i];
        for (size_t k = 0; k < d->spot_count; k++)
            for (int side = -1; side <= 1; side += 2) {
                leave_for_spot(s, i, k, side, &at);
                if (touches(s, i, &d->spots[k], &at)) add_ride(s, (law_ride){i, side, atan2(-d->y, -d->x), at.time}, at, at.time);
            }
    }
}

/* Was `earlier` at the angle where this ride begins, and free to run straight out to its place? */
static int outrun(const search *s, const node *earlier, const node *later)
{
    if (earlier->ride.disc != later->ride.disc || earlier->end < 0.0) return 0;
    const double ahead = law_wrap_positive(earlier->ride.side * (later->ride.angle - earlier->ride.angle));
    const double turned = ahead < 2.0 * pi - 1e-12 ? ahead : 0.0;
    if (turned > earlier->turned) return 0;
    const double time = law_ride_time(&s->world, &earlier->ride, turned, earlier->end), lead = later->ride.time - time;
    if (lead <= SAME_TIME * later->ride.time)
        return lead >= -SAME_TIME * later->ride.time && earlier->ride.side == later->ride.side;
    const law_disc *d = &s->world.discs[later->ride.disc];
    const law_panel *a = law_ride_panel(&s->world, earlier->ride.disc, time),
                    *b = law_ride_panel(&s->world, later->ride.disc, later->ride.time);
    const double radius = law_world_jet(&s->world, earlier->ride.disc, a->piece, time).radius;
    const double length = law_world_jet(&s->world, later->ride.disc, b->piece, later->ride.time).radius - radius;
    const double x = d->x + radius * cos(later->ride.angle), y = d->y + radius * sin(later->ride.angle);
    return length <= lead && law_world_line_free(&s->world, x, y, later->ride.angle, time, length);
}

static int is_outrun(const search *s, const node *later)
{
    for (size_t i = 0; i < s->count; i++)
        if (outrun(s, &s->nodes[i], later)) return 1;
    return 0;
}

/* The destination on the boundary of the ridden disc is reached without a last line. */
static void ride_onto_destination(search *s, const node *n)
{
    const law_disc *d = &s->world.discs[n->ride.disc];
    const double angle = atan2(s->world.to_y - d->y, s->world.to_x - d->x);
    const double turned = law_wrap_positive(n->ride.side * (angle - n->ride.angle));
    if (turned > n->turned + 1e-12) return;
    const double time = law_ride_time(&s->world, &n->ride, turned, n->end);
    const law_panel *p = law_ride_panel(&s->world, n->ride.disc, time);
    const law_moment at = law_ride_at(&s->world, &n->ride, p->piece, time);
    if (hypot(at.x - s->world.to_x, at.y - s->world.to_y) <= 1e-12) arrive(s, time, time);
}

static void explore(search *s, size_t chosen)
{
    s->nodes[chosen].open = 0;
    if (is_outrun(s, &s->nodes[chosen])) return;
    const law_ride ride = s->nodes[chosen].ride;
    const double end = law_ride_end(&s->world, &ride, fmin(s->best, s->world.until));
    s->nodes[chosen].end = end;
    s->nodes[chosen].turned = law_ride_turned(&s->world, &ride, end);
    s->exploring = chosen;
    if (end > ride.time) ride_onto_destination(s, &s->nodes[chosen]);
    law_ride_leaves(&s->world, &ride, end, on_leave, s);
}

static size_t least_open(const search *s)
{
    size_t least = NOWHERE;
    for (size_t i = 0; i < s->count; i++)
        if (s->nodes[i].open && (least == NOWHERE || s->nodes[i].bound < s->nodes[least].bound)) least = i;
    return least;
}

static void search_run(search *s)
{
    if (!law_world_point_free(&s->world, 0.0, 0.0, s->departure)) return;
    if (s->world.to_x == 0.0 && s->world.to_y == 0.0) {
        s->best = s->departure;
        return;
    }
    explore_source(s);
    while (!s->overflow) {
        const size_t chosen = least_open(s);
        if (chosen == NOWHERE || s->nodes[chosen].bound >= s->best) return;
        explore(s, chosen);
    }
}

typedef struct tracing {
    const search *s;
    const tdsp_journey *journey;
    slow_law_place *places;
    size_t capacity, count;
} tracing;

/* Places are told from the destination back. */
static void trace_place(tracing *t, law_moment at, size_t disc, int side)
{
    const law_world *w = &t->s->world;
    const tdsp_point from = t->journey->source;
    if (t->count == t->capacity) return;
    t->places[t->count++] =
        (slow_law_place){{from.x + w->length * at.x, from.y + w->length * at.y}, at.time * w->time, disc, side};
}

static void trace_ride(tracing *t, const law_ride *ride, double end)
{
    const law_world *w = &t->s->world;
    const law_disc *d = &w->discs[ride->disc];
    for (size_t k = d->panel_count; k > 0; k--) {
        const law_panel *p = &d->panels[k - 1];
        const double from = fmax(p->from, ride->time), to = fmin(p->to, end);
        if (from >= to) continue;
        const size_t steps = law_ride_steps(w, ride, from, to);
        for (size_t i = steps; i > 0; i--)
            trace_place(t, law_ride_at(w, ride, p->piece, law_ride_step(from, to, i - 1, steps)), ride->disc, ride->side);
    }
}

static size_t trace(tracing *t)
{
    const search *s = t->s;
    double left = s->best_left;
    trace_place(t, (law_moment){s->world.to_x, s->world.to_y, s->best, 0.0}, SLOW_LAW_LINE, 0);
    for (size_t i = s->best_from; i != NOWHERE; i = s->nodes[i].from) {
        const law_panel *p = law_ride_panel(&s->world, s->nodes[i].ride.disc, left);
        trace_place(t, law_ride_at(&s->world, &s->nodes[i].ride, p->piece, left), SLOW_LAW_LINE, 0);
        if (left > s->nodes[i].ride.time) trace_ride(t, &s->nodes[i].ride, left);
        left = s->nodes[i].left;
    }
    trace_place(t, (law_moment){0.0, 0.0, s->departure, 0.0}, SLOW_LAW_LINE, 0);
    for (size_t i = 0; i < t->count / 2; i++) {
        const slow_law_place kept = t->places[i];
        t->places[i] = t->places[t->count - 1 - i];
        t->places[t->count - 1 - i] = kept;
    }
    return t->count;
}

double slow_law_path(const tdsp_journey *journey, const slow_law_disc *discs, size_t count, double until, double departure,
                     slow_law_place *places, size_t capacity, size_t *place_count)
{
    search *s = calloc(1, sizeof *s);
    double arrival = NAN;
    *place_count = 0;
    if (!s) return NAN;
    s->nodes = malloc(MOST_RIDES * sizeof *s->nodes);
    s->best = INFINITY;
    s->exploring = s->best_from = NOWHERE;
    if (s->nodes && law_world_make(&s->world, journey, discs, count, until)) {
        s->departure = departure / s->world.time;
        search_run(s);
        /* A destination at the source is reached when leaving. */
        const double found = s->best == s->departure ? departure : s->best * s->world.time;
        arrival = s->overflow ? NAN : found;
        tracing t = {s, journey, places, capacity, 0};
        if (arrival < INFINITY && arrival > departure) *place_count = trace(&t);
    }
    law_world_drop(&s->world);
    free(s->nodes);
    free(s);
    return arrival;
}

double slow_law_arrival(const tdsp_journey *journey, const slow_law_disc *discs, size_t count, double until, double departure)
{
    size_t places;
    return slow_law_path(journey, discs, count, until, departure, NULL, 0, &places);
}
