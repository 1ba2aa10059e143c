/* SPDX-License-Identifier: MIT */
/* The least slope: the derivation is in touch.h. */
#include "margin/touch.h"

#include "base/math.h"
#include "tdsp/path.h"

#define CHEAP_EVALUATIONS 2000
#define COARSE 250.0   /* times the resolution, when an arc and a disc cost more than that */
#define STACK_PARTS 64 /* a part shorter than 2^-63 of the arc is below the resolution */

typedef struct touch_search {
    const way *leg;
    tdsp_point center;
    double radius;
    double resolution; /* a length */
    touch found;
    double bound; /* of the parts that were given up */
} touch_search;

typedef struct part {
    double a, b;   /* times */
    double da, db; /* distances from the centre */
} part;

/* excess / time, and what that means at time 0. */
static double slope(double excess, double time)
{
    if (time > 0.0) return excess / time;
    return excess >= 0.0 ? INFINITY : -INFINITY;
}

/* Evaluate g; returns the distance. */
static double touch_at(touch_search *search, double time)
{
    const double distance = way_distance(search->center, tdsp_leg_position(search->leg->leg, time));
    const double rate = slope(distance - search->radius, time);
    if (rate < search->found.rate) search->found = (touch){rate, time};
    return distance;
}

/* When the line's tangent from (0, R) touches; negative where there is none. */
static double line_tangent(const touch_search *search)
{
    const tdsp_leg *leg = search->leg->leg;
    const double length = search->leg->length, w = search->leg->speed, R = search->radius;
    const double ux = (leg->to.x - leg->from.x) / length, uy = (leg->to.y - leg->from.y) / length;
    const double dx = leg->from.x - search->center.x, dy = leg->from.y - search->center.y;
    const double m = dx * ux + dy * uy - w * leg->start_time, h = fabs(ux * dy - uy * dx);
    const double Q = m * m + h * h;
    if (!(Q > R * R)) return -1.0;
    const double E = sqrt(Q - R * R);
    return Q * E / (w * (R * h - m * E));
}

static void touch_line(touch_search *search)
{
    const tdsp_leg *leg = search->leg->leg;
    if (!(search->leg->speed > 0.0)) return;
    const double time = line_tangent(search);
    if (time > leg->start_time && time < leg->end_time) touch_at(search, time);
}

static double part_bent_bound(const touch_search *search, const part *q, double near)
{
    const way *leg = search->leg;
    const double span = q->b - q->a, radius = math_min(way_radius(leg, q->a), way_radius(leg, q->b));
    if (!(near > 0.0)) return -INFINITY;
    const double sag = leg->speed * (leg->speed / near + leg->across / radius) * span * span / 8.0 + search->radius;
    return math_min(slope(q->da - sag, q->a), slope(q->db - sag, q->b));
}

/* A lower bound on g over a part. */
static double part_bound(const touch_search *search, const part *q)
{
    const double near = 0.5 * (q->da + q->db - search->leg->speed * (q->b - q->a)), excess = near - search->radius;
    return math_max(math_min(slope(excess, q->a), slope(excess, q->b)), part_bent_bound(search, q, near));
}

/* Is nothing lower than the resolution left to find in a part? Then its bound is kept. */
static int part_settled(touch_search *search, const part *q, double resolution)
{
    const double bound = part_bound(search, q), middle = q->a + 0.5 * (q->b - q->a);
    if (bound < search->found.rate - resolution / q->b && middle > q->a && middle < q->b) return 0;
    search->bound = math_min(search->bound, bound);
    return 1;
}

static void touch_arc(touch_search *search)
{
    const tdsp_leg *leg = search->leg->leg;
    part stack[STACK_PARTS];
    size_t open = 0;
    stack[open++] =
        (part){leg->start_time, leg->end_time, way_distance(search->center, leg->from), way_distance(search->center, leg->to)};
    for (int evaluations = 0; open > 0; evaluations++) {
        const part q = stack[--open];
        const double resolution = evaluations < CHEAP_EVALUATIONS ? search->resolution : COARSE * search->resolution;
        if (part_settled(search, &q, resolution)) continue;
        if (open + 2 > STACK_PARTS) {
            search->bound = math_min(search->bound, part_bound(search, &q));
            continue;
        }
        const double middle = q.a + 0.5 * (q.b - q.a), d = touch_at(search, middle);
        const part halves[2] = {{q.a, middle, q.da, d}, {middle, q.b, d, q.db}};
        const int lower_first = slope(q.da - search->radius, q.a) < slope(q.db - search->radius, q.b);
        stack[open++] = halves[lower_first];
        stack[open++] = halves[!lower_first];
    }
}

/* Around the common centre the distance is linear; each distance differs from that by no more than the centres do. */
static void touch_concentric(touch_search *search, double apart)
{
    const tdsp_leg *leg = search->leg->leg;
    search->bound = math_min(slope(leg->radius_from - search->radius - apart, leg->start_time),
                         slope(leg->radius_to - search->radius - apart, leg->end_time));
}

touch touch_of(const way *leg, tdsp_point center, double radius, double resolution)
{
    touch_search search = {leg, center, radius, resolution, {INFINITY, leg->leg->start_time}, INFINITY};
    const double apart = leg->leg->kind == TDSP_LEG_ARC ? way_distance(center, leg->leg->center) : INFINITY;
    touch_at(&search, leg->leg->start_time);
    touch_at(&search, leg->leg->end_time);
    if (leg->leg->kind == TDSP_LEG_LINE) {
        touch_line(&search);
    } else if (apart <= resolution) {
        touch_concentric(&search, apart);
    } else {
        touch_arc(&search);
    }
    search.found.rate = math_min(search.found.rate, search.bound);
    return search.found;
}
