/* SPDX-License-Identifier: MIT */
/* See stretch.h for the bounds. */
#include "verify/stretch.h"

#include "base/math.h"
#include "verify/curve.h"

#define CHEAP_EVALUATIONS 2000
#define MOST_EVALUATIONS 20000 /* a leg that goes around and around is judged by what is known then */
#define MOST_HALVINGS 60
#define NEARLY_AROUND 1e-5 /* centres apart by less, of the least radius, count as one: a motion around one creeps along the other's disc */

typedef struct part {
    double a, b;      /* elapsed time */
    double fa, fb;    /* f there */
    bernstein radius; /* of the disc, over the part */
} part;

static double stretch_time(const stretch *s, double elapsed)
{
    return elapsed >= s->m->duration ? s->m->leg.end_time : s->m->leg.start_time + elapsed;
}

static double stretch_evaluate(const stretch *s, double elapsed)
{
    const double time = stretch_time(s, elapsed);
    const double f = motion_distance(s->center, motion_position(s->m, elapsed)) - swell_radius(&s->piece, time);
    clearance *least = s->least;
    if (f < least->found) {
        least->found = f;
        least->time = time;
        least->radius = swell_magnitude(&s->piece, time);
        least->disc = s->disc;
        least->leg = s->leg;
    }
    return f;
}

static bernstein stretch_radius(const stretch *s, double from, double to)
{
    return swell_over(&s->piece, stretch_time(s, from), stretch_time(s, to));
}

/* The bound by the bending of f; -infinity where the part may pass the centre. */
static double part_bent_bound(const stretch *s, const part *q, const bernstein *slope)
{
    const double span = q->b - q->a, speed = s->m->speed;
    const double radii = q->radius.b[0] + q->radius.b[q->radius.degree];
    const double near = 0.5 * (q->fa + q->fb + radii - speed * span);
    if (!(near > 0.0)) return -INFINITY;
    const bernstein bend = bernstein_slope(slope);
    const double bent = (speed * speed / near + motion_bend(s->m, q->a, q->b)) * span * span - bernstein_least(&bend);
    return math_min(q->fa, q->fb) - math_max(0.0, bent) / 8.0;
}

/* The larger of the two lower bounds on f over a part. */
static double part_bound(const stretch *s, const part *q)
{
    const bernstein slope = bernstein_slope(&q->radius);
    const double way = s->m->speed * (q->b - q->a);
    const double fall = way + bernstein_most(&slope), rise = way - bernstein_least(&slope);
    if (rise <= 0.0) return q->fb;
    const double first = (q->fa * rise + q->fb * fall - fall * rise) / (fall + rise);
    return math_min(math_min(q->fa, q->fb), math_max(first, part_bent_bound(s, q, &slope)));
}

/* May the part hold anything lower, by more than the resolution, than was found? If not, what its bound says is kept. */
static int part_is_open(const stretch *s, double a, double b, double bound, int evaluations, int depth)
{
    clearance *least = s->least;
    const double resolution = evaluations < CHEAP_EVALUATIONS ? least->fine : least->coarse;
    const double middle = a + 0.5 * (b - a);
    const int divisible = middle > a && middle < b && depth < MOST_HALVINGS && evaluations < MOST_EVALUATIONS;
    if (bound < least->found - resolution && divisible) return 1;
    least->bound = math_min(least->bound, bound);
    return 0;
}

static void part_clear(const stretch *s, const part *q, int *evaluations, int depth)
{
    if (!part_is_open(s, q->a, q->b, part_bound(s, q), *evaluations, depth)) return;
    const double middle = q->a + 0.5 * (q->b - q->a);
    const double f = stretch_evaluate(s, middle);
    part halves[2] = {{q->a, middle, q->fa, f, {0}}, {middle, q->b, f, q->fb, {0}}};
    bernstein_halve(&q->radius, &halves[0].radius, &halves[1].radius);
    const int first = q->fb < q->fa;
    ++*evaluations;
    part_clear(s, &halves[first], evaluations, depth + 1);
    part_clear(s, &halves[!first], evaluations, depth + 1);
}

static void stretch_beside(const stretch *s, double from, double to)
{
    int evaluations = 0;
    const double start = stretch_evaluate(s, from), end = stretch_evaluate(s, to); /* in order: the first of equal ones is told */
    const part whole = {from, to, start, end, stretch_radius(s, from, to)};
    part_clear(s, &whole, &evaluations, 0);
}

typedef struct around_part {
    double a, b;         /* elapsed time */
    double from, to;     /* there: how much farther the disc's centre is than the motion's own */
    bernstein above;     /* r - R over the part */
} around_part;

/* The centres, how far they are apart, and how fast the distances to them change in comparison at most; infinite near them. */
typedef struct around {
    const stretch *s;
    double apart, drift;
    int evaluations;
} around;

static double around_bound(const around *self, const around_part *q)
{
    const double drift = self->drift < INFINITY ? 0.5 * (q->from + q->to - self->drift * (q->b - q->a)) : -INFINITY;
    return bernstein_least(&q->above) + math_max(-self->apart, drift);
}

static void around_clear(around *self, const around_part *q, int depth)
{
    if (!part_is_open(self->s, q->a, q->b, around_bound(self, q), self->evaluations, depth)) return;
    const double middle = q->a + 0.5 * (q->b - q->a);
    around_part halves[2] = {{q->a, middle, q->from, 0.0, {0}}, {middle, q->b, 0.0, q->to, {0}}};
    bernstein_halve(&q->above, &halves[0].above, &halves[1].above);
    halves[0].to = halves[1].from = stretch_evaluate(self->s, middle) - halves[1].above.b[0];
    ++self->evaluations;
    around_clear(self, &halves[0], depth + 1);
    around_clear(self, &halves[1], depth + 1);
}

static bernstein stretch_distance(const stretch *s, double from, double to)
{
    if (s->m->leg.kind == TDSP_LEG_CURVE) return curve_distance(s->m, motion_share(s->m, from), motion_share(s->m, to));
    return (bernstein){1, {motion_radius(s->m, from), motion_radius(s->m, to)}};
}

static void stretch_around(const stretch *s, double apart, double from, double to)
{
    const bernstein radius = stretch_radius(s, from, to), distance = stretch_distance(s, from, to);
    const double near = bernstein_least(&distance) - 0.5 * apart;
    around self = {s, apart, near > 0.0 ? s->m->speed * apart / near : INFINITY, 0};
    around_part whole = {from, to, 0.0, 0.0, bernstein_less(&distance, &radius)};
    whole.from = stretch_evaluate(s, from) - whole.above.b[0];
    whole.to = stretch_evaluate(s, to) - whole.above.b[whole.above.degree];
    around_clear(&self, &whole, 0);
}

static void stretch_past(const stretch *s, double from, double to)
{
    const double nearest = motion_nearest(s->m, s->center, s->piece.c[1]);
    stretch_evaluate(s, from);
    stretch_evaluate(s, to);
    if (nearest > from && nearest < to) stretch_evaluate(s, nearest);
}

int stretch_is_around(const motion *m, tdsp_point center, double fine)
{
    if (m->leg.kind == TDSP_LEG_LINE) return 0;
    return motion_distance(center, m->leg.center) <= math_max(fine, NEARLY_AROUND * math_min(m->leg.radius_from, m->leg.radius_to));
}

void stretch_clear(const stretch *s, double from, double to)
{
    if (s->m->leg.kind == TDSP_LEG_LINE && s->piece.degree <= 1)
        stretch_past(s, from, to);
    else if (stretch_is_around(s->m, s->center, s->least->fine))
        stretch_around(s, motion_distance(s->center, s->m->leg.center), from, to);
    else
        stretch_beside(s, from, to);
}
