/* SPDX-License-Identifier: MIT */
/* Who runs into whom: the equations are in contact.h and at ride_contact(). */
#include "geom/contact.h"

#include "geom/angle.h"
#include "geom/bracket.h"
#include "geom/spiral.h"
#include "geom/tolerance.h"

/* Clearance at the length `at`, with the touch forgiven. */
static double line_clearance(const geom_line *line, const geom_disc *disc, double at)
{
    tdsp_point offset = point_sub(point_along(line->from, at, line->heading), disc->center);
    double distance = point_length(offset), radius = disc_radius(disc, line->start + at);
    return distance - radius + tolerance_touch(disc->center, distance + radius);
}

/* The length at which |x - O|^2 - R^2 is least, inside the motion. */
static double line_vertex(const geom_line *line, const geom_disc *disc)
{
    tdsp_point offset = point_sub(line->from, disc->center);
    double slope = point_dot(offset, line->heading) - disc_radius(disc, line->start) * disc->rate;
    double bend = (1.0 - disc->rate) * (1.0 + disc->rate);
    if (slope >= 0.0 || bend <= 0.0) return 0.0;
    double vertex = -slope / bend;
    return vertex < line->length ? vertex : line->length;
}

int line_blocked(const geom_line *line, const geom_disc *disc)
{
    if (!disc_ridable(disc) && line_clearance(line, disc, line->length) < 0.0) return 1;
    return line_clearance(line, disc, line_vertex(line, disc)) < 0.0;
}

double line_first_contact(const geom_line *line, const geom_disc *disc)
{
    if (line_clearance(line, disc, 0.0) < 0.0) return 0.0;
    double inside = line_vertex(line, disc);
    if (line_clearance(line, disc, inside) >= 0.0) inside = line->length;
    if (line_clearance(line, disc, inside) >= 0.0) return INFINITY;
    double outside = 0.0; /* clearance crosses zero once on the way to the vertex, or to the end */
    for (int step = 0; step < 60; ++step) {
        double middle = 0.5 * (outside + inside);
        if (line_clearance(line, disc, middle) < 0.0) {
            inside = middle;
        } else {
            outside = middle;
        }
    }
    return outside;
}

double ride_angle(const geom_ride *ride, double time)
{
    return ride->angle + ride->side * spiral_angle(ride->disc, ride->start, time);
}

tdsp_point ride_position(const geom_ride *ride, double time)
{
    return disc_boundary(ride->disc, ride_angle(ride, time), time);
}

/*
 * Along a ride let z be the rider seen from the other disc's centre, u its heading. Then
 *
 *     F   = |z|^2 - R_k^2,    F' = 2 (z . u - R_k c_k),    F'' = 2 (1 - c_k^2) + 2 s sin(theta) / R  z . u_perp
 *
 * and |F'' - 2 (1 - c_k^2)| <= 2 sin(theta) |z| / R bounds F on an interval from either end. Intervals that cannot
 * be decided are halved, first the earlier one: the first contact is found, and none is missed that is deeper than the
 * smallest interval squared.
 */
typedef struct contact_state {
    double time;
    double value; /* F, with the touch forgiven, and the grace given */
    double slope; /* F' */
    double reach; /* |z| */
} contact_state;

static contact_state contact_at(const geom_ride *ride, const geom_disc *other, double time, double grace)
{
    double angle = ride_angle(ride, time);
    tdsp_point offset = point_sub(disc_boundary(ride->disc, angle, time), other->center);
    tdsp_point heading = point_unit(disc_heading(ride->disc, ride->side, angle));
    double radius = disc_radius(other, time), distance = point_length(offset);
    double gap = distance - radius + tolerance_touch(other->center, distance + radius);
    contact_state state = {time, gap * (distance + radius) + grace, 2.0 * (point_dot(offset, heading) - radius * other->rate), distance};
    return state;
}

/* The range of F'' between two states. */
static void contact_bend(const geom_ride *ride, const geom_disc *other, contact_state a, contact_state b, double *least,
                         double *most)
{
    double span = b.time - a.time;
    double reach = (a.reach < b.reach ? a.reach : b.reach) + span;
    double r0 = disc_radius(ride->disc, a.time), r1 = disc_radius(ride->disc, b.time);
    double swing = 2.0 * ride->disc->sine * reach / (r0 < r1 ? r0 : r1);
    double base = 2.0 * (1.0 - other->rate * other->rate);
    *least = base - swing;
    *most = base + swing;
}

/* Is F certainly positive all the way, given that it is not negative at a? A concave parabola from each end, each least at the ends of its half. */
static int contact_free(contact_state a, contact_state b, double least)
{
    double half = 0.5 * (b.time - a.time);
    double bend = 0.5 * (least < 0.0 ? least : 0.0) * half * half;
    return a.value + a.slope * half + bend > 0.0 && b.value > 0.0 && b.value - b.slope * half + bend > 0.0;
}

/* A contact known this well, as a share of the times at hand, is known as well as can be. */
#define CONTACT_TIME 1e-15

/*
 * F falls through zero once between a and b. Newton's step from a lands near the zero, on either side; after a step that stayed outside twice the next one
 * is tried, which lands inside and brings b near as well. Every eighth step halves, and what is left is more than four units in the last place: so it ends, and the middle lies inside.
 */
static double contact_solve(const geom_ride *ride, const geom_disc *other, contact_state a, contact_state b, double grace)
{
    double enough = CONTACT_TIME * (fabs(b.time) + (b.time - a.time));
    int stayed_outside = 0;
    for (int step = 0; b.time - a.time > enough; ++step) {
        double newton = -a.value / a.slope, time = a.time + (stayed_outside ? 2.0 * newton + 0.5 * enough : newton);
        if (!bracket_holds(a.time, b.time, time) || step % 8 == 7) time = 0.5 * (a.time + b.time);
        contact_state state = contact_at(ride, other, time, grace);
        stayed_outside = state.value >= 0.0;
        if (stayed_outside) {
            a = state;
        } else {
            b = state;
        }
    }
    return a.time;
}

/*
 * Seen from the centre of the disc ridden, the other disc is within the angle w of its bearing at the rider's distance, cos(w) = (D^2 + R^2 - R_k^2) / (2 D R).
 * Is the rider certainly farther from that bearing all the time?
 */
static int contact_impossible(const geom_ride *ride, const geom_disc *other)
{
    const geom_disc *disc = ride->disc;
    tdsp_point between = point_sub(other->center, disc->center);
    double r0 = disc_radius(disc, ride->start), r1 = disc_radius(disc, ride->end), low = r0 < r1 ? r0 : r1, high = r0 < r1 ? r1 : r0;
    double k0 = disc_radius(other, ride->start), k1 = disc_radius(other, ride->end), large = k0 < k1 ? k1 : k0;
    double distance = point_length(between);
    if (large >= distance) return 0;
    double cosine = (distance - large) * (distance + large) / (2.0 * distance * high) + low / (2.0 * distance);
    double window = 0.5 * GEOM_PI - asin_near(cosine) + 2.0 * GEOM_ANGLE_NEAR;
    double ahead = angle_positive(ride->side * (angle_near(between.y, between.x) - ride->angle));
    double turn = ride->side * (ride_angle(ride, ride->end) - ride->angle);
    return cosine > 1.0 + GEOM_ANGLE_NEAR || (ahead - turn > window && GEOM_TURN - ahead > window);
}

/*
 * How much more is forgiven to a ride that begins inside the other disc. One that came over from there at a touch (ride_touch()) was forgiven in proportion to the disc that
 * it rides now, twice its radius or a little more, and moves outwards. INFINITY when it is in deeper, or moves inwards.
 */
static double contact_grace(const geom_ride *ride, const geom_disc *other, contact_state start)
{
    double forgiven = 1.25 * tolerance_touch(ride->disc->center, 2.0 * disc_radius(ride->disc, start.time)) * (start.reach + disc_radius(other, start.time));
    int outwards = start.slope >= 0.0 || start.slope * start.slope <= (1.0 - other->rate * other->rate) * forgiven;
    return outwards && start.value >= -forgiven ? 2.0 * forgiven : INFINITY;
}

/*
 * The smallest interval, as a share of the ride, or of so many journeys where the ride is longer: around a vast disc it is, and what stands in its way is as small as ever. Halving 60
 * times makes less; rounding may add to that where an interval has only a few doubles.
 */
#define CONTACT_SMALLEST 1e-9
#define CONTACT_LONG 1e3
#define CONTACT_DEPTH 64

double ride_contact(const geom_ride *ride, const geom_disc *other)
{
    if (contact_impossible(ride, other)) return INFINITY;
    contact_state later[CONTACT_DEPTH]; /* the ends of the intervals still to do, the next one on top */
    double whole = ride->end - ride->start, smallest = math_max(math_min(whole, CONTACT_LONG) * CONTACT_SMALLEST, whole * 0x1p-60), grace = 0.0;
    int top = 0;
    contact_state a = contact_at(ride, other, ride->start, 0.0);
    if (a.value < 0.0) {
        grace = contact_grace(ride, other, a);
        if (isinf(grace)) return ride->start;
        a.value += grace;
    }
    later[top++] = contact_at(ride, other, ride->end, grace);
    while (top > 0) {
        contact_state b = later[top - 1];
        double least, most;
        contact_bend(ride, other, a, b, &least, &most);
        if (contact_free(a, b, least)) {
            a = b;
            --top;
            continue;
        }
        double span = b.time - a.time;
        int falls = a.slope + (most > 0.0 ? most * span : 0.0) < 0.0;
        if (b.value < 0.0 && falls) return contact_solve(ride, other, a, b, grace);
        double middle = a.time + 0.5 * span;
        if (span <= smallest || !bracket_holds(a.time, b.time, middle)) {
            if (b.value < 0.0) return a.time;
            a = b;
            --top;
            continue;
        }
        later[top++] = contact_at(ride, other, middle, grace);
    }
    return INFINITY;
}

/*
 * Where boundaries cross, with normals that are theta_i + theta_k apart, their corner is as fast as a robot and runs along both of them:
 *
 *     g = D^2 - R_i^2 - R_k^2 + 2 R_i R_k cos(theta_i + theta_k) = 0
 *
 * Before that a corner at the rider's heels is left behind by changing over to the other disc; who is overtaken is caught between the two. g falls as the discs grow.
 */
static double touch_gap(const geom_ride *ride, const geom_disc *other, double time)
{
    const geom_disc *disc = ride->disc;
    double cosine = disc->rate * other->rate - disc->sine * other->sine;
    double own = disc_radius(disc, time), radius = disc_radius(other, time), distance = point_distance(disc->center, other->center);
    return distance * distance - own * own - radius * radius + 2.0 * own * radius * cosine;
}

/* A corner that misses g = 0 by more than this share of the sizes times the touch is none: |g| <= 2 R_k D eta for a clearance of eta R_k. */
#define TOUCH_GAP 8.0

/* The time at which |g| is least, if that is little enough. */
static int touch_moment(const geom_ride *ride, const geom_disc *other, double *time)
{
    double from = ride->start, to = ride->end, a = touch_gap(ride, other, from), b = touch_gap(ride, other, to);
    double s0 = disc_radius(ride->disc, from) + disc_radius(other, from), s1 = disc_radius(ride->disc, to) + disc_radius(other, to);
    double sizes = math_max(s0, s1), near = TOUCH_GAP * sizes * tolerance_touch(other->center, sizes);
    if (math_min(a, b) > near || math_max(a, b) < -near) return 0;
    *time = fabs(a) < fabs(b) ? from : to;
    if ((a > 0.0) == (b > 0.0)) return 1;
    for (int step = 0; step < 60; ++step) {
        *time = 0.5 * (from + to);
        double middle = touch_gap(ride, other, *time);
        if ((middle > 0.0) == (a > 0.0))
            from = *time;
        else
            to = *time;
    }
    return 1;
}

/* When the rider is where the corner is at the moment given. */
static double touch_meets(const geom_ride *ride, const geom_disc *other, double moment)
{
    const geom_disc *disc = ride->disc;
    tdsp_point between = point_sub(other->center, disc->center);
    double cosine = disc->rate * other->rate - disc->sine * other->sine, sine = disc->sine * other->rate + disc->rate * other->sine;
    double own = disc_radius(disc, moment), turned = math_atan2(own * sine, own * cosine - disc_radius(other, moment));
    double corner = math_atan2(between.y, between.x) - ride->side * (disc->theta + other->theta - turned);
    double ahead = angle_positive(ride->side * (corner - ride_angle(ride, moment)));
    return moment + (ahead > GEOM_PI ? ahead - GEOM_TURN : ahead) * own / disc->sine;
}

/* The part of F'' there that tells the sides: over 0 where the other disc lies on the other side of the way, below where on the same. */
static double contact_swing_at(const geom_ride *ride, const geom_disc *other, double time)
{
    double angle = ride_angle(ride, time), radius = disc_radius(ride->disc, time);
    tdsp_point offset = point_sub(disc_boundary(ride->disc, angle, time), other->center);
    tdsp_point heading = point_unit(disc_heading(ride->disc, ride->side, angle));
    return ride->side * ride->disc->sine / radius * point_cross(heading, offset);
}

/* How far outside of the ride a touch may seem to be, as a share of its time. */
#define TOUCH_EDGE 1e-9

/* Newton's steps to where F is least; they begin beside it. */
#define TOUCH_STEPS 8

/*
 * Rounding of F, as a share of what is forgiven. A ride that ends with no more left was stopped by the other disc there, so the gap is closed; one that was not stopped
 * may seem to be in deeper by as much.
 */
#define TOUCH_SAME 1e-3

int ride_touch(const geom_ride *ride, const geom_disc *other, double *time)
{
    double moment;
    if (!touch_moment(ride, other, &moment)) return 0;
    double at = touch_meets(ride, other, moment), edge = TOUCH_EDGE * (ride->end - ride->start);
    if (!(at >= ride->start - edge && at <= ride->end + edge)) return 0;
    for (int step = 0; step < TOUCH_STEPS; ++step) {
        double swing = contact_swing_at(ride, other, at);
        if (!(swing > 0.0)) return 0;
        at -= contact_at(ride, other, at, 0.0).slope / (2.0 * (1.0 - other->rate * other->rate) + 2.0 * swing);
    }
    *time = math_min(math_max(at, ride->start), ride->end);
    contact_state state = contact_at(ride, other, *time, 0.0), end = contact_at(ride, other, ride->end, 0.0);
    double sizes = state.reach + disc_radius(other, *time), forgiven = tolerance_touch(other->center, sizes) * sizes;
    return state.value >= -TOUCH_SAME * forgiven && state.value <= 2.0 * forgiven && end.value > TOUCH_SAME * forgiven;
}
