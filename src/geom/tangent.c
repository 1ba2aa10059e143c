/* SPDX-License-Identifier: MIT */
/* Straight legs between two moving boundaries: the equations are in tangent.h. */
#include "geom/tangent.h"

#include "geom/bracket.h"
#include "geom/spiral.h"
#include "geom/tolerance.h"

/* Discs whose centres are closer than this share of their radii count as concentric. */
#define CONCENTRIC 1e-15

geom_pair pair_make(const geom_disc *from, const geom_disc *to)
{
    tdsp_point between = point_sub(to->center, from->center);
    geom_pair pair = {from, to, point_length(between), 0.0, math_atan2(between.y, between.x)};
    pair.farthest = pair.distance * (1.0 + GEOM_DOMAIN) + tolerance_place(to->center);
    return pair;
}

geom_tangent tangent_make(const geom_pair *pair, int side, int to_side, int root)
{
    const geom_disc *i = pair->from, *j = pair->to;
    geom_tangent tangent = {i, j, side, to_side, root, pair->distance, pair->farthest, pair->bearing, 0.0, 0.0, 0.0, 0.0};
    tangent.cos_alpha = i->rate * j->rate + side * to_side * i->sine * j->sine;
    tangent.sin_alpha = side * i->sine * j->rate - to_side * i->rate * j->sine;
    if (side == to_side && i->rate == j->rate) {
        tangent.cos_alpha = 1.0;
        tangent.sin_alpha = 0.0;
    }
    tangent.k_start = i->radius * tangent.cos_alpha - j->radius;
    tangent.k_slope = i->rate * tangent.cos_alpha - j->rate;
    return tangent;
}

static int tangent_is_concentric(const geom_tangent *tangent, double time)
{
    return tangent->distance <= CONCENTRIC * (disc_radius(tangent->from, time) + disc_radius(tangent->to, time));
}

static double tangent_k(const geom_tangent *tangent, double time)
{
    return tangent->k_start + tangent->k_slope * time;
}

static double tangent_w(const geom_tangent *tangent, double time)
{
    return -tangent->to_side * disc_radius(tangent->from, time) * tangent->sin_alpha;
}

/* sqrt(|D|^2 - K^2) */
static double tangent_reach(const geom_tangent *tangent, double k)
{
    double squared = (tangent->distance - k) * (tangent->distance + k);
    return squared > 0.0 ? sqrt(squared) : 0.0;
}

int tangent_possible(const geom_tangent *tangent)
{
    return tangent->root > 0 || tangent->to_side * tangent->sin_alpha > 0.0;
}

/* The direction in which the arrival normal is acos(k / |D|) from the centres' line. */
static double tangent_towards(const geom_tangent *tangent, double k, double reach)
{
    return tangent->bearing + tangent->to_side * (tangent->to->theta - tangent->root * math_atan2(reach, k));
}

double tangent_heading(const geom_tangent *tangent, double time)
{
    double k = tangent_k(tangent, time);
    return tangent_towards(tangent, k, tangent_reach(tangent, k));
}

/* (3.4): how far the arrival is ahead of the far centre, less w. */
static double tangent_length_of(const geom_tangent *tangent, double ahead, double w)
{
    double length = (ahead - w) / tangent->to->sine;
    return length > 0.0 ? length : 0.0;
}

double tangent_length(const geom_tangent *tangent, double time)
{
    double reach = tangent_reach(tangent, tangent_k(tangent, time));
    return tangent_length_of(tangent, tangent->root * reach, tangent_w(tangent, time));
}

geom_leg tangent_leg(const geom_tangent *tangent, double angle, double time)
{
    const geom_disc *j = tangent->to;
    double k = tangent_k(tangent, time), reach = tangent_reach(tangent, k), w = tangent_w(tangent, time);
    double turned = tangent->side * tangent->from->theta;
    geom_leg leg = {angle, angle + turned, 0.0};
    if (fabs(w) >= reach || tangent_is_concentric(tangent, time)) {
        double normal = leg.heading - tangent->to_side * tangent->to->theta;
        double along = -tangent->to_side * tangent->distance * math_sin(normal - tangent->bearing) - w;
        double turning = GEOM_TIME * fabs(time) * (1.0 + tangent->distance / disc_radius(tangent->from, time));
        int is_beside = along < -tolerance_touch(j->center, tangent->distance + disc_radius(j, time)) - turning;
        leg.length = is_beside ? TANGENT_NONE : tangent_length_of(tangent, along, 0.0);
        return leg;
    }
    leg.heading = tangent_towards(tangent, k, reach);
    leg.normal = leg.heading - turned;
    leg.length = tangent_length_of(tangent, tangent->root * reach, w);
    return leg;
}

/* The times between t0 and t1 at which |K| <= |D|: *lo > *hi where there are none. With a slope of 0 both ends are infinite, and on one side where |K| > |D|. */
static void domain_of_k(const geom_tangent *tangent, double t0, double t1, double *lo, double *hi)
{
    double limit = tangent->farthest;
    double k0 = tangent_k(tangent, t0);
    double slope = tangent->k_slope;
    *lo = t0;
    *hi = t1;
    double a = t0 + (-limit - k0) / slope, b = t0 + (limit - k0) / slope;
    if (a > b) {
        double swap = a;
        a = b;
        b = swap;
    }
    if (a > *lo) *lo = a;
    if (b < *hi) *hi = b;
}

/*
 * The roots of |D|^2 - K^2 - w^2, between which it is positive; returns 0 when it is positive nowhere, and infinite ends when it
 * is positive everywhere. The quadratic is written about t0. Asked where |K| <= |D| at some time.
 */
static int gap_open(const geom_tangent *tangent, double t0, double *lo, double *hi)
{
    double k0 = tangent_k(tangent, t0), w0 = tangent_w(tangent, t0);
    double k1 = tangent->k_slope;
    double w1 = -tangent->to_side * tangent->from->rate * tangent->sin_alpha;
    double a = k1 * k1 + w1 * w1, b = k0 * k1 + w0 * w1;
    double c = k0 * k0 + w0 * w0 - tangent->farthest * tangent->farthest;
    *lo = -INFINITY;
    *hi = INFINITY;
    if (a == 0.0) return 1; /* neither changes: w is next to nothing, and |K| at most |D| */
    double discriminant = b * b - a * c;
    if (discriminant < 0.0) return 0;
    double q = -(b + (b < 0.0 ? -1.0 : 1.0) * sqrt(discriminant));
    double first = q / a, second = q != 0.0 ? c / q : first;
    *lo = t0 + (first < second ? first : second);
    *hi = t0 + (first < second ? second : first);
    return 1;
}

static int domain_add(double ends[4], int count, double lo, double hi)
{
    if (!(lo <= hi)) return count;
    ends[2 * count] = lo;
    ends[2 * count + 1] = hi;
    return count + 1;
}

int tangent_domain(const geom_tangent *tangent, double t0, double t1, double ends[4])
{
    double lo, hi, open, close;
    domain_of_k(tangent, t0, t1, &lo, &hi);
    if (!(lo <= hi)) return 0;
    int shortens = tangent->to_side * tangent->sin_alpha < 0.0; /* w > 0 */
    if (tangent->root > 0) {
        if (!shortens) return domain_add(ends, 0, lo, hi);
        if (!gap_open(tangent, t0, &open, &close)) return 0;
        return domain_add(ends, 0, open > lo ? open : lo, close < hi ? close : hi);
    }
    if (!tangent_possible(tangent)) return 0;
    if (!gap_open(tangent, t0, &open, &close)) return domain_add(ends, 0, lo, hi);
    int count = domain_add(ends, 0, lo, open < hi ? open : hi);
    return domain_add(ends, count, close > lo ? close : lo, hi);
}

/* The rider and the equation it has to solve: fall(t) = rho h(t), which never rises. */
typedef struct leave_equation {
    const geom_tangent *tangent;
    double t0;
    double turn_start; /* the departure point at `start` */
    double start;      /* begin of the piece */
    double ridden;     /* angle ridden at `start` */
    double fall_start; /* value there, in [0, 2 pi) */
} leave_equation;

/* The rider's angle to the departure point, up to the constant that it has in common for all times. */
static double departure_turn(const geom_tangent *tangent, double k, double reach)
{
    return -tangent->side * tangent->root * tangent->to_side * math_atan2(reach, k);
}

/* The value at a time, and its slope. */
static double leave_value(const leave_equation *equation, double time, double *slope)
{
    const geom_tangent *tangent = equation->tangent;
    double k = tangent_k(tangent, time), reach = tangent_reach(tangent, k);
    double length = tangent->root * reach - tangent_w(tangent, time);
    double moved = departure_turn(tangent, k, reach) - equation->turn_start;
    double ridden = spiral_angle(tangent->from, equation->t0, time) - equation->ridden;
    *slope = -tangent->from->sine * length / (disc_radius(tangent->from, time) * reach);
    return equation->fall_start + tangent->root * (moved - ridden);
}

/* Does the departure point stand still on its circle? So it is between the same sides of discs of the same rate: K is constant, and the second root has no legs. */
static int tangent_stands(const geom_tangent *tangent)
{
    return tangent->side == tangent->to_side && tangent->from->rate == tangent->to->rate;
}

/*
 * Newton inside a bracket: value(lo) >= 0; whether value(hi) <= 0 is asked only when a step leads there. Where the departure point stands nearly
 * still, the time that the rider takes to turn to where it was is nearly the answer. Every eighth step halves what is left, so it ends. Returns 0 when there is none.
 */
static int leave_solve(const leave_equation *equation, double lo, double hi, double *leave)
{
    const double end = hi;
    int is_bracketed = 0;
    const geom_tangent *tangent = equation->tangent;
    double time = tangent->root > 0 ? lo + spiral_duration(tangent->from, lo, equation->fall_start) : 0.5 * (lo + hi);
    *leave = time;
    if (time <= hi && tangent_stands(tangent)) return 1;
    if (!(time < hi)) time = hi;
    for (int step = 0;; ++step) {
        double slope, value = leave_value(equation, time, &slope);
        if (value > 0.0 && time == end) return 0;
        *leave = time;
        if (fabs(value) <= GEOM_ANGLE) return 1;
        if (value > 0.0) {
            lo = time;
        } else {
            hi = time;
            is_bracketed = 1;
        }
        double next = time - value / slope;
        if (!is_bracketed && !(next < end)) next = end;
        else if (!bracket_holds(lo, hi, next) || step % 8 == 7) next = lo + 0.5 * (hi - lo);
        if (next <= lo || (is_bracketed && next >= hi)) return 1;
        time = next;
    }
}

/* Concentric discs: one moment, from every angle; infinite or no number where K never changes. */
static int leave_concentric(const geom_tangent *tangent, double t0, double t1, double *leave)
{
    double time = t0 - tangent_k(tangent, t0) / tangent->k_slope;
    if (!(time >= t0) || !(time <= t1) || tangent_w(tangent, time) >= 0.0) return 0;
    *leave = time;
    return 1;
}

static int leave_in_piece(const geom_tangent *tangent, double angle, double t0, double lo, double hi, double *leave)
{
    const geom_disc *i = tangent->from, *j = tangent->to;
    double k = tangent_k(tangent, lo);
    leave_equation equation = {tangent, t0, departure_turn(tangent, k, tangent_reach(tangent, k)), lo, spiral_angle(i, t0, lo), 0.0};
    double fixed = tangent->bearing + tangent->to_side * j->theta - tangent->side * i->theta - angle;
    double ahead = tangent->side * fixed + equation.turn_start - equation.ridden;
    equation.fall_start = angle_positive(tangent->root * ahead);
    double behind = GEOM_TURN - equation.fall_start;
    if (behind < tolerance_behind(disc_radius(i, t0)) || equation.fall_start <= GEOM_ANGLE) {
        *leave = lo;
        return 1;
    }
    return leave_solve(&equation, lo, hi, leave);
}

int tangent_leave_apart(const geom_tangent *tangent, double angle, double t0, double t1, double *leave)
{
    return leave_in_piece(tangent, angle, t0, t0, t1, leave);
}

int tangent_leave(const geom_tangent *tangent, double angle, double t0, double t1, double *leave)
{
    if (tangent_is_concentric(tangent, t0)) return leave_concentric(tangent, t0, t1, leave);
    double ends[4];
    int pieces = tangent_domain(tangent, t0, t1, ends);
    for (int piece = 0; piece < pieces; ++piece)
        if (leave_in_piece(tangent, angle, t0, ends[2 * piece], ends[2 * piece + 1], leave)) return 1;
    return 0;
}
