/* SPDX-License-Identifier: MIT */
/* See clearance.h for the bounds. */
#include "verify/clearance.h"

#include "base/math.h"
#include "verify/stretch.h"

#define CHEAP_EVALUATIONS 2000
#define STACK_PARTS 64 /* a part shorter than 2^-63 of the arc is below the resolution */

typedef struct pass {
    clearance *least;
    const motion *m;
    size_t leg;
    const tdsp_scene *scene; /* NULL where every disc grows at one rate */
} pass;

typedef struct part {
    double a, b;   /* elapsed time */
    double fa, fb; /* f there */
} part;

static double disc_radius(const nearby_disc *disc, double time)
{
    return disc->radius + disc->growth * time;
}

/* The first of equal ones stays: evaluate in order of time, in statements of their own, or the compiler chooses which it is. */
static double pass_evaluate(pass *p, const nearby_disc *disc, double elapsed)
{
    clearance *least = p->least;
    const double time = elapsed >= p->m->duration ? p->m->leg.end_time : p->m->leg.start_time + elapsed;
    const double radius = disc_radius(disc, time);
    const double f = motion_distance(disc->center, motion_position(p->m, elapsed)) - radius;
    if (f < least->found) {
        least->found = f;
        least->time = time;
        least->radius = radius;
        least->disc = disc->index;
        least->leg = p->leg;
    }
    return f;
}

static void line_clear(pass *p, const nearby_disc *disc)
{
    const motion *m = p->m;
    pass_evaluate(p, disc, 0.0);
    pass_evaluate(p, disc, m->duration);
    const double elapsed = motion_nearest(m, disc->center, disc->growth);
    if (elapsed > 0.0 && elapsed < m->duration) pass_evaluate(p, disc, elapsed);
}

/* The bound by the bending of f; -infinity where the part may pass the centre. */
static double part_bent_bound(const motion *m, const nearby_disc *disc, const part *q)
{
    const double span = q->b - q->a;
    const double radii = disc_radius(disc, m->leg.start_time + q->a) + disc_radius(disc, m->leg.start_time + q->b);
    const double near = 0.5 * (q->fa + q->fb + radii - m->speed * span);
    if (!(near > 0.0)) return -INFINITY;
    const double bend = m->tangential / math_min(motion_radius(m, q->a), motion_radius(m, q->b));
    return math_min(q->fa, q->fb) - m->speed * (m->speed / near + bend) * span * span / 8.0;
}

/* The larger of the two lower bounds on f over a part. */
static double part_bound(const motion *m, const nearby_disc *disc, const part *q)
{
    const double span = q->b - q->a, fall = m->speed + disc->growth, rise = m->speed - disc->growth;
    if (rise <= 0.0) return q->fb;
    const double first = (q->fa * rise + q->fb * fall - fall * rise * span) / (fall + rise);
    return math_min(math_min(q->fa, q->fb), math_max(first, part_bent_bound(m, disc, q)));
}

/* Keep what a part's bound says of the whole when nothing lower than the resolution is left to find in it. */
static int part_settled(const pass *p, const nearby_disc *disc, const part *q, double resolution)
{
    const double bound = part_bound(p->m, disc, q);
    const double middle = q->a + 0.5 * (q->b - q->a);
    if (bound < p->least->found - resolution && middle > q->a && middle < q->b) return 0;
    p->least->bound = math_min(p->least->bound, bound);
    return 1;
}

static void arc_clear(pass *p, const nearby_disc *disc)
{
    part stack[STACK_PARTS];
    size_t open = 0;
    const double whole = p->m->duration, start = pass_evaluate(p, disc, 0.0), end = pass_evaluate(p, disc, whole);
    stack[open++] = (part){0.0, whole, start, end};
    for (int evaluations = 0; open > 0; evaluations++) {
        const part q = stack[--open];
        if (part_settled(p, disc, &q, evaluations < CHEAP_EVALUATIONS ? p->least->fine : p->least->coarse)) continue;
        const double middle = q.a + 0.5 * (q.b - q.a);
        const double f = pass_evaluate(p, disc, middle);
        const part halves[2] = {{q.a, middle, q.fa, f}, {middle, q.b, f, q.fb}};
        const int lower_first = q.fa < q.fb;
        if (open + 2 > STACK_PARTS) {
            p->least->bound = math_min(p->least->bound, part_bound(p->m, disc, &q));
            continue;
        }
        stack[open++] = halves[lower_first];
        stack[open++] = halves[!lower_first];
    }
}

/* Piece by piece of the disc's growth. */
static void growing_clear(pass *p, const nearby_disc *disc)
{
    const motion *m = p->m;
    stretch s = {.least = p->least, .m = m, .leg = p->leg, .center = disc->center, .disc = disc->index};
    double from = m->leg.start_time, to;
    do {
        s.piece = p->scene ? swell_at(p->scene, disc->index, from) : swell_of_rate(disc->radius, disc->growth);
        to = math_min(s.piece.end, m->leg.end_time);
        stretch_clear(&s, from - m->leg.start_time, to < m->leg.end_time ? to - m->leg.start_time : m->duration);
        from = to;
    } while (to < m->leg.end_time);
}

static void disc_clear(void *ctx, const nearby_disc *disc)
{
    pass *p = ctx;
    const motion *m = p->m;
    if (m->leg.kind == TDSP_LEG_CURVE || stretch_is_around(m, disc->center, p->least->fine) || (p->scene && !swell_is_rate(p->scene, disc->index)))
        growing_clear(p, disc);
    else if (m->leg.kind == TDSP_LEG_LINE)
        line_clear(p, disc);
    else
        arc_clear(p, disc);
}

void clearance_of_leg(clearance *least, const motion *m, size_t leg, const nearby_index *index)
{
    const motion_circle circle = motion_bound(m);
    pass p = {least, m, leg, index->scene};
    nearby_visit(index, &circle, m->leg.end_time, &least->found, disc_clear, &p);
}
