/* SPDX-License-Identifier: MIT */
/* See literal.h. Times are in units of |sd| / speed, lengths in units of |sd|; backwards, times and rates are negated. */
#include "support/literal.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "geom/contact.h"
#include "geom/spiral.h"
#include "geom/tangent.h"
#include "support/cmocka_all.h"
#include "tdsp/search.h"

enum { ARRIVED, LEAVING };

/* Nobody who rides on a disc of less than this gets anywhere. */
#define LEAST_RADIUS 1e-13

/* A departure this little before time 0, in units of the journey, is one at 0. */
#define ROUNDING 1e-9

/* A ride that starts so little past a place has been there. */
#define SAME_ANGLE 1e-12

/* Who passes a place within this share of the times at hand passes it at the same time: on the same side the older ride counts as the earlier one. */
#define SAME_MOMENT 1e-13

/* A ride is looked over in pieces of this angle, over which the radius changes by no more than this factor's logarithm. */
#define PIECE 0.5

/* What a label stands for: a tangent about to be left for (LEAVING), or one just ridden along (ARRIVED). */
typedef struct leg {
    size_t from; /* the start is `count`, the goal `count` + 1 */
    size_t to;
    int side, to_side, root;
    geom_line line;
} leg;

typedef struct ridden {
    size_t on;
    double end;
    geom_ride ride;
} ridden;

typedef struct literal {
    literal_rules rules;
    size_t count;
    geom_disc discs[LITERAL_DISCS + 2]; /* the start and the goal are the last two */
    double start;
    double latest; /* of any use */
    double found;
    leg *legs;
    size_t leg_count, leg_capacity;
    ridden *rides;
    size_t ride_count, ride_capacity;
    unsigned char settled[LITERAL_DISCS + 2][LITERAL_DISCS + 2][8];
    tdsp_search *open;
} literal;

static unsigned char *settled(literal *self, const leg *of)
{
    return &self->settled[of->from][of->to][(of->side > 0) + 2 * (of->to_side > 0) + 4 * (of->root > 0)];
}

static int is_free(const literal *self, const leg *of)
{
    for (size_t k = 0; k < self->count; k++)
        if (k != of->from && k != of->to && line_blocked(&of->line, &self->discs[k])) return 0;
    return 1;
}

static void *grown(void *block, size_t *capacity, size_t count, size_t size)
{
    if (count < *capacity) return block;
    *capacity = 2 * *capacity + 1024;
    block = realloc(block, *capacity * size);
    assert_non_null(block);
    return block;
}

static void push(literal *self, const leg *added, uint32_t kind)
{
    tdsp_label label = {added->line.start + (kind == ARRIVED ? added->line.length : 0.0), (uint32_t)self->leg_count, kind};
    if (!(label.time <= self->latest)) return;
    self->legs = grown(self->legs, &self->leg_capacity, self->leg_count, sizeof *self->legs);
    self->legs[self->leg_count++] = *added;
    assert_int_equal(tdsp_search_push(self->open, &label), TDSP_OK);
}

/* The tangent that is left at a time. */
static leg leg_at(const literal *self, size_t from, size_t to, const geom_tangent *tangent, geom_leg taken, double time)
{
    const geom_line line = {disc_boundary(&self->discs[from], taken.normal, time), point_unit(taken.heading), time, taken.length};
    return (leg){from, to, tangent->side, tangent->to_side, tangent->root, line};
}

static void look_from_start(literal *self)
{
    const geom_disc *start = &self->discs[self->count];
    for (size_t k = 0; k <= self->count + 1; k++) {
        const geom_pair pair = pair_make(start, &self->discs[k]);
        for (int q = -1; q <= (k < self->count ? 1 : -1); q += 2) {
            const geom_tangent tangent = tangent_make(&pair, 1, q, 1);
            double ends[4];
            if (k == self->count || !disc_ridable(&self->discs[k])) continue;
            if (tangent_domain(&tangent, self->start, self->start, ends) == 0) continue;
            const geom_leg taken = {0.0, tangent_heading(&tangent, self->start), tangent_length(&tangent, self->start)};
            const leg added = leg_at(self, self->count, k, &tangent, taken, self->start);
            push(self, &added, LEAVING);
        }
    }
}

/* What a rider passes on one piece of a ride. */
static void look_at_piece(literal *self, size_t on, const geom_ride *piece)
{
    for (size_t k = 0; k <= self->count + 1; k++) {
        if (k == on || k == self->count || !disc_ridable(&self->discs[k])) continue;
        const geom_pair pair = pair_make(piece->disc, &self->discs[k]);
        if (self->rules.no_concentric && pair.distance == 0.0) continue;
        for (int branch = 0; branch < 4; branch++) {
            const int q = branch & 1 ? 1 : -1, root = branch & 2 ? 1 : -1;
            if ((root < 0 && self->rules.first_root_only) || (k > self->count && q != piece->side)) continue;
            const geom_tangent tangent = tangent_make(&pair, piece->side, q, root);
            double leave;
            if (!tangent_possible(&tangent) || !tangent_leave(&tangent, piece->angle, piece->start, piece->end, &leave)) continue;
            const leg added = leg_at(self, on, k, &tangent, tangent_leg(&tangent, ride_angle(piece, leave), leave), leave);
            push(self, &added, LEAVING);
        }
    }
}

/* How far a ride goes: one lap, until another disc is in the way, or until the disc has shrunk to nothing. */
static double ride_end(const literal *self, size_t on, geom_ride ride)
{
    const geom_disc *disc = &self->discs[on];
    ride.end = fmin(ride.start + spiral_duration(disc, ride.start, GEOM_TURN), self->latest);
    if (disc->rate < 0.0) ride.end = fmin(ride.end, (LEAST_RADIUS - disc->radius) / disc->rate);
    for (size_t k = 0; k < self->count && ride.end > ride.start; k++)
        if (k != on) ride.end = fmin(ride.end, ride_contact(&ride, &self->discs[k]));
    return ride.end;
}

/* Was another ride at this place before, and could that rider go straight along the radius to be here now? */
static int is_forgotten(const literal *self, const ridden *other, const geom_ride *late)
{
    double ahead = angle_positive(other->ride.side * (late->angle - other->ride.angle));
    if (ahead > GEOM_TURN - SAME_ANGLE) ahead = 0.0;
    const double passed = other->ride.start + spiral_duration(late->disc, other->ride.start, ahead);
    const double gain = disc_radius(late->disc, late->start) - disc_radius(late->disc, passed);
    const double tie = SAME_MOMENT * (1.0 + fabs(passed));
    if (!(passed <= other->end) || passed > late->start + (late->side == other->ride.side ? tie : -tie)) return 0;
    const tdsp_point outward = point_unit(late->angle);
    const geom_line straight = {disc_boundary(late->disc, late->angle, passed), point_scale(gain > 0.0 ? 1.0 : -1.0, outward),
                                gain > 0.0 ? passed : late->start - fabs(gain), fabs(gain)};
    const leg along = {.from = other->on, .to = other->on, .line = straight};
    return is_free(self, &along);
}

static int ride_is_forgotten(const literal *self, size_t on, const geom_ride *late)
{
    for (size_t i = 0; i < self->ride_count; i++)
        if (self->rides[i].on == on && is_forgotten(self, &self->rides[i], late)) return 1;
    return 0;
}

static void ride(literal *self, size_t on, int side, double normal, double time)
{
    const geom_disc *disc = &self->discs[on];
    if (disc_radius(disc, time) <= LEAST_RADIUS) return;
    const geom_ride all = {disc, side, normal, time, time};
    if (self->rules.settling == LITERAL_NOBODY && ride_is_forgotten(self, on, &all)) return;
    const double end = ride_end(self, on, all);
    self->rides = grown(self->rides, &self->ride_capacity, self->ride_count, sizeof *self->rides);
    self->rides[self->ride_count++] = (ridden){on, end, all};
    const double turn = fmin(PIECE, PIECE * disc->sine / fmax(fabs(disc->rate), 1e-300));
    for (double from = time; from <= end;) {
        const double full = from + spiral_duration(disc, from, turn);
        const geom_ride piece = {disc, side, ride_angle(&all, from), from, fmin(full, end)};
        look_at_piece(self, on, &piece);
        if (!(full > from) || full >= end) return;
        from = full;
    }
}

static tdsp_status expand(void *ctx, const tdsp_label *label, tdsp_search *open, int *done)
{
    literal *self = ctx;
    const leg taken = self->legs[label->id];
    (void)open;
    if (label->kind == ARRIVED && taken.to == self->count + 1) {
        self->found = label->time;
        *done = 1;
    } else if (label->kind == ARRIVED) {
        const double heading = atan2(taken.line.heading.y, taken.line.heading.x);
        ride(self, taken.to, taken.to_side, heading - taken.to_side * self->discs[taken.to].theta, label->time);
    } else if (!*settled(self, &taken)) {
        const int is_open = is_free(self, &taken);
        *settled(self, &taken) = self->rules.settling == LITERAL_FIRST || (self->rules.settling == LITERAL_FREE && is_open);
        if (is_open) push(self, &taken, ARRIVED);
    }
    return TDSP_OK;
}

static tdsp_status begin(void *ctx, const tdsp_label *label, tdsp_search *open, int *done)
{
    literal *self = ctx;
    if (self->leg_count > 0) return expand(ctx, label, open, done);
    self->open = open;
    look_from_start(self);
    return TDSP_OK;
}

static int is_covered(const literal *self, tdsp_point place, double time)
{
    const geom_line stay = {place, {1.0, 0.0}, time, 0.0};
    for (size_t k = 0; k < self->count; k++)
        if (line_blocked(&stay, &self->discs[k])) return 1;
    return 0;
}

static void run(literal *self)
{
    tdsp_search *search;
    const tdsp_search_problem problem = {sizeof problem, self, NULL, begin};
    const tdsp_label start = {self->start, 0, LEAVING};
    self->found = INFINITY;
    if (is_covered(self, self->discs[self->count].center, self->start)) return;
    assert_int_equal(tdsp_search_create(NULL, &search), TDSP_OK);
    assert_int_equal(tdsp_search_run(search, &problem, &start, 1, NULL), TDSP_OK);
    tdsp_search_free(search);
}

/* From `from` at `time` to `to`; the time of arrival. */
static double solve(const tdsp_journey *j, const tdsp_disc *discs, size_t count, int sign, double time, literal_rules rules)
{
    assert_true(count <= LITERAL_DISCS);
    literal *self = calloc(1, sizeof *self);
    assert_non_null(self);
    const double length = point_distance(j->source, j->destination), unit = length / j->speed;
    for (size_t k = 0; k < count; k++) {
        const tdsp_point center = point_scale(1.0 / length, point_sub(discs[k].center, j->source));
        self->discs[k] = disc_make(center, (discs[k].radius + j->radius) / length, sign * discs[k].growth / j->speed);
    }
    const geom_disc source = disc_point(point_make(0.0, 0.0));
    const geom_disc destination = disc_point(point_scale(1.0 / length, point_sub(j->destination, j->source)));
    self->rules = rules;
    self->count = count;
    self->discs[count] = sign > 0 ? source : destination;
    self->discs[count + 1] = sign > 0 ? destination : source;
    self->start = sign * time / unit;
    self->latest = sign > 0 ? INFINITY : ROUNDING;
    run(self);
    const double found = self->found * unit;
    free(self->legs);
    free(self->rides);
    free(self);
    return found;
}

double literal_arrival(const tdsp_journey *journey, const tdsp_disc *discs, size_t count, double departure, literal_rules rules)
{
    return solve(journey, discs, count, 1, departure, rules);
}

double literal_departure(const tdsp_journey *journey, const tdsp_disc *discs, size_t count, double arrival, literal_rules rules)
{
    const double found = solve(journey, discs, count, -1, arrival, rules);
    return isinf(found) ? -1.0 : fmax(-found, 0.0);
}
