/* SPDX-License-Identifier: MIT */
/*
 * Straight legs between moving boundaries, from first principles: for a rider who leaves disc i in its own direction, where does the straight line
 * meet disc j along j's own direction? That asks for a length L and an error `miss`, both explicit, and a leg is where `miss` is zero. No formula of
 * the tangent is used.
 */
#include "support/cmocka_all.h"

#include "geom/contact.h"
#include "geom/spiral.h"
#include "geom/tangent.h"
#include "support/chance.h"

typedef struct branch {
    geom_disc i, j;
    int side, to_side;
} branch;

typedef struct trial {
    double length;
    double radius; /* of j at the arrival, before it is cut off at 0 */
    double miss;   /* distance between j's tangent point for this heading and the line */
} trial;

/* Leave i at the normal `angle` at `time`. Along the heading, j's tangent point is met after `length`; across it, by `miss` beside. */
static trial trial_leave(const branch *b, double angle, double time)
{
    tdsp_point u = point_unit(angle + b->side * b->i.theta);
    tdsp_point to_center = point_sub(b->j.center, disc_boundary(&b->i, angle, time));
    double along = point_dot(u, to_center), left = point_cross(u, to_center);
    double r = b->j.radius + b->j.rate * time, c = b->j.rate, s = b->j.sine;
    trial result;
    result.length = (along + c * r) / (s * s); /* along j's heading the robot is R_j(t + L) c ahead of the centre */
    result.radius = r + c * result.length;
    result.miss = left - b->to_side * s * result.radius;
    return result;
}

static int trial_is_leg(trial t)
{
    return t.length > 0.0 && t.radius > 0.0;
}

/* Rates for both directions of time, with what is special among them. */
static double random_rate(uint64_t *chance)
{
    static const double special[] = {0.0, 1e-12, 0.1, 0.1, 0.5, 0.9, 0.99};
    uint64_t pick = chance_below(chance, 14);
    return pick < 7 ? special[pick] : chance_between(chance, 0.0, 0.97);
}

/* Two discs: apart, overlapping, nested; a point as target; rates alike or nearly so. */
static branch random_branch(uint64_t *chance, int sign)
{
    double ri = chance_between(chance, 0.2, 3.0), rj = chance_between(chance, 0.0, 3.0);
    double vi = random_rate(chance), vj = random_rate(chance);
    if (chance_below(chance, 6) == 0) vj = vi;
    if (chance_below(chance, 8) == 0) vj = vi * (1.0 + chance_between(chance, -1e-9, 1e-9));
    if (chance_below(chance, 6) == 0) rj = vj = 0.0;
    tdsp_point where = point_make(chance_between(chance, -4.0, 4.0), chance_between(chance, -4.0, 4.0));
    branch b = {disc_make(point_make(0.5, -0.25), ri, sign * vi), disc_make(where, rj, sign * vj), 1, 1};
    if (sign < 0) b.i.radius += 2.0 * vi, b.j.radius += 2.0 * vj; /* so that both last for a while */
    return b;
}

static void each_branch(branch *b, uint64_t *chance, void (*check)(branch *b, uint64_t *chance))
{
    for (b->side = -1; b->side <= 1; b->side += 2)
        for (b->to_side = -1; b->to_side <= 1; b->to_side += 2) check(b, chance);
}

static void each_random_branch(int pairs, uint64_t seed, void (*check)(branch *b, uint64_t *chance))
{
    uint64_t chance = seed;
    for (int k = 0; k < pairs; ++k) {
        branch b = random_branch(&chance, k % 2 ? 1 : -1);
        each_branch(&b, &chance, check);
    }
}

static int domain_has(const double ends[4], int pieces, double time, double margin)
{
    for (int k = 0; k < pieces; ++k)
        if (time > ends[2 * k] - margin && time < ends[2 * k + 1] + margin) return 1;
    return 0;
}

static size_t legs_seen[2][2][2][2]; /* direction of time, sides alike, root, rates alike */

static void check_legs(branch *b, uint64_t *chance)
{
    geom_pair pair = pair_make(&b->i, &b->j);
    for (int root = -1; root <= 1; root += 2) {
        geom_tangent tangent = tangent_make(&pair, b->side, b->to_side, root);
        double ends[4];
        int pieces = tangent_domain(&tangent, 0.0, 2.0, ends);
        if (!tangent_possible(&tangent)) assert_int_equal(pieces, 0);
        for (int k = 0; k < 20 && pieces; ++k) {
            int piece = (int)chance_below(chance, (size_t)pieces);
            double time = chance_between(chance, ends[2 * piece], ends[2 * piece + 1]);
            double heading = tangent_heading(&tangent, time), length = tangent_length(&tangent, time);
            trial t = trial_leave(b, heading - b->side * b->i.theta, time);
            assert_true(length >= 0.0);
            assert_near(t.miss, 0.0, 1e-8 / b->j.sine);
            assert_near(t.length, length, 1e-7 / (b->j.sine * b->j.sine) * (1.0 + length));
            ++legs_seen[b->i.rate < 0.0 || b->j.rate < 0.0][b->side == b->to_side][root > 0][b->i.rate == b->j.rate];
        }
    }
}

static void every_leg_touches_both_discs_tangentially_and_in_time(void **state)
{
    (void)state;
    each_random_branch(4000, 1, check_legs);
    for (int reverse = 0; reverse < 2; ++reverse)
        for (int alike = 0; alike < 2; ++alike) {
            assert_true(legs_seen[reverse][alike][1][0] > 100);
            assert_true(legs_seen[reverse][alike][1][1] > 100);
            assert_int_equal(legs_seen[reverse][alike][0][0] > 100, alike || reverse);
        }
}

static const int around = 1440;

/* All legs at one moment by sampling every normal: their headings. Returns -1 where two are too close, or one is too short, to tell. */
static int sampled_legs(const branch *b, double time, double headings[8])
{
    int count = 0;
    trial before = trial_leave(b, 0.0, time);
    for (int k = 1; k <= around; ++k) {
        double lo = GEOM_TURN * (k - 1) / around, hi = GEOM_TURN * k / around;
        trial after = trial_leave(b, hi, time);
        if (fabs(after.miss) < 1e-4 && (fabs(after.length) < 0.05 || fabs(after.radius) < 0.05)) return -1;
        if ((before.miss < 0.0) == (after.miss < 0.0)) {
            if (fabs(after.miss) < 1e-4) return -1;
            before = after;
            continue;
        }
        for (int step = 0; step < 60; ++step) {
            double middle = 0.5 * (lo + hi);
            *((trial_leave(b, middle, time).miss < 0.0) == (before.miss < 0.0) ? &lo : &hi) = middle;
        }
        trial leg = trial_leave(b, lo, time);
        if (fabs(leg.length) < 1e-3 || fabs(leg.radius) < 1e-3) return -1;
        if (trial_is_leg(leg) && count < 8) headings[count++] = lo + b->side * b->i.theta;
        before = after;
    }
    return count;
}

static double angle_between(double a, double b)
{
    double apart = angle_positive(a - b);
    return fmin(apart, GEOM_TURN - apart);
}

static size_t moments_compared;

static void check_all_found(branch *b, uint64_t *chance)
{
    geom_pair pair = pair_make(&b->i, &b->j);
    double time = chance_between(chance, 0.0, 2.0), headings[8], ends[4];
    int expected = sampled_legs(b, time, headings), found = 0;
    if (expected < 0 || pair.distance < 1e-3) return;
    for (int root = -1; root <= 1; root += 2) {
        geom_tangent tangent = tangent_make(&pair, b->side, b->to_side, root);
        int pieces = tangent_domain(&tangent, 0.0, 2.0, ends);
        if (!domain_has(ends, pieces, time, 0.0) || !trial_is_leg(trial_leave(b, tangent_heading(&tangent, time) - b->side * b->i.theta, time)))
            continue;
        double nearest = INFINITY;
        for (int k = 0; k < expected; ++k) nearest = fmin(nearest, angle_between(headings[k], tangent_heading(&tangent, time)));
        assert_true(nearest < 1e-6);
        ++found;
    }
    assert_int_equal(found, expected);
    ++moments_compared;
}

static void no_leg_is_missing_at_any_moment(void **state)
{
    (void)state;
    each_random_branch(1500, 2, check_all_found);
    assert_true(moments_compared > 3000);
}

/* A rider's `miss` over a ride. */
static trial trial_ride(const branch *b, double angle, double t0, double time)
{
    return trial_leave(b, angle + b->side * spiral_angle(&b->i, t0, time), time);
}

enum { MOST_ROOTS = 6 };

static const int along_count = 600;

/* When a rider can leave, by sampling. -1 where that is too close to call. */
static int sampled_leaves(const branch *b, double angle, double t0, double t1, double leaves[MOST_ROOTS])
{
    int count = 0;
    trial before = trial_ride(b, angle, t0, t0);
    if (fabs(before.miss) < 1e-6) return -1;
    for (int k = 1; k <= along_count; ++k) {
        double lo = t0 + (t1 - t0) * (k - 1) / along_count, hi = t0 + (t1 - t0) * k / along_count;
        trial after = trial_ride(b, angle, t0, hi);
        if (fabs(after.miss) < 1e-6) return -1;
        if ((before.miss < 0.0) != (after.miss < 0.0)) {
            for (int step = 0; step < 60; ++step) {
                double middle = 0.5 * (lo + hi);
                *((trial_ride(b, angle, t0, middle).miss < 0.0) == (before.miss < 0.0) ? &lo : &hi) = middle;
            }
            trial leg = trial_ride(b, angle, t0, lo);
            if (fabs(leg.length) < 1e-3 || fabs(leg.radius) < 1e-3) return -1;
            if (trial_is_leg(leg) && count < MOST_ROOTS) leaves[count++] = lo;
        }
        before = after;
    }
    return count;
}

static size_t rides_compared, leaves_compared;

static void check_leaves(branch *b, uint64_t *chance)
{
    geom_pair pair = pair_make(&b->i, &b->j);
    double t0 = chance_between(chance, 0.0, 1.5), t1 = t0 + chance_between(chance, 0.0, 2.0), leaves[MOST_ROOTS];
    double angle = chance_between(chance, -GEOM_PI, GEOM_PI);
    if (disc_radius(&b->i, t0) < 0.1 || disc_radius(&b->i, t1) < 0.1 || pair.distance < 1e-3) return;
    if (spiral_angle(&b->i, t0, t1) > 2.0) return;
    int expected = sampled_leaves(b, angle, t0, t1, leaves), found = 0;
    if (expected < 0) return;
    for (int root = -1; root <= 1; root += 2) {
        geom_tangent tangent = tangent_make(&pair, b->side, b->to_side, root);
        double leave = NAN, nearest = INFINITY;
        if (!tangent_possible(&tangent) || !tangent_leave(&tangent, angle, t0, t1, &leave)) continue;
        assert_true(leave >= t0 && leave <= t1);
        if (!trial_is_leg(trial_ride(b, angle, t0, leave))) continue;
        for (int k = 0; k < expected; ++k) nearest = fmin(nearest, fabs(leave - leaves[k]));
        assert_true(nearest < 1e-7);
        ++found;
    }
    assert_int_equal(found, expected);
    ++rides_compared;
    leaves_compared += (size_t)expected;
}

static void a_rider_finds_every_moment_to_leave(void **state)
{
    (void)state;
    each_random_branch(8000, 3, check_leaves);
    assert_true(rides_compared > 10000);
    assert_true(leaves_compared > 500);
}

static void concentric_discs_are_left_at_one_moment_from_every_angle(void **state)
{
    (void)state;
    uint64_t chance = 4;
    int legs = 0;
    for (int k = 0; k < 400; ++k) {
        double vi = chance_between(&chance, 0.0, 0.9), vj = chance_between(&chance, 0.0, 0.95), angle = chance_between(&chance, -3.0, 3.0);
        branch b = {disc_make(point_make(1.0, 2.0), chance_between(&chance, 0.5, 2.0), vi),
                    disc_make(point_make(1.0, 2.0), chance_between(&chance, 0.0, 1.0), vj), k % 2 ? 1 : -1, k % 4 < 2 ? 1 : -1};
        geom_pair pair = pair_make(&b.i, &b.j);
        geom_tangent tangent = tangent_make(&pair, b.side, b.to_side, 1);
        double leave, sum;
        if (!tangent_leave(&tangent, angle, 0.0, 4.0, &leave)) continue;
        for (sum = 0.0; sum < 1.0; sum += 0.25) {
            trial t = trial_leave(&b, angle + sum * GEOM_TURN, leave);
            assert_near(t.miss, 0.0, 1e-9 / b.j.sine);
            assert_true(t.length > 0.0);
        }
        ++legs;
    }
    assert_true(legs > 20);
}

static void concentric_discs_of_one_rate_have_no_leg(void **state)
{
    (void)state;
    geom_disc i = disc_make(point_make(1.0, 2.0), 1.0, 0.5), j = disc_make(point_make(1.0, 2.0), 2.0, 0.5);
    geom_pair pair = pair_make(&i, &j);
    for (int side = -1; side <= 1; side += 2) {
        geom_tangent tangent = tangent_make(&pair, side, side, 1);
        double leave;
        assert_false(tangent_leave(&tangent, 0.0, 0.0, 10.0, &leave));
    }
}

static void same_rate_and_side_keep_heading_and_length_for_ever(void **state)
{
    (void)state;
    geom_disc i = disc_make(point_make(0.0, 0.0), 1.0, 0.3), j = disc_make(point_make(6.0, 2.0), 2.0, 0.3);
    geom_pair pair = pair_make(&i, &j);
    geom_tangent tangent = tangent_make(&pair, 1, 1, 1);
    double heading = tangent_heading(&tangent, 0.0), length = tangent_length(&tangent, 0.0);
    for (double time = 0.5; time < 5.0; time += 0.5) {
        assert_near(tangent_heading(&tangent, time), heading, 1e-15);
        assert_near(tangent_length(&tangent, time), length, 1e-14);
    }
}

static void a_rider_who_starts_at_the_departure_point_leaves_at_once(void **state)
{
    (void)state;
    uint64_t chance = 5;
    for (int k = 0; k < 500; ++k) {
        geom_disc i = disc_make(point_make(0.0, 0.0), chance_between(&chance, 0.2, 1.0), chance_between(&chance, 0.0, 0.9));
        geom_disc j = disc_make(point_make(5.0, 1.0), chance_between(&chance, 0.2, 1.0), chance_between(&chance, 0.0, 0.9));
        geom_pair pair = pair_make(&i, &j);
        geom_tangent tangent = tangent_make(&pair, 1, k % 2 ? 1 : -1, 1);
        double angle = tangent_heading(&tangent, 0.25) - i.theta, leave = NAN;
        assert_int_equal(tangent_leave(&tangent, angle, 0.25, 0.3, &leave), 1);
        assert_near(leave, 0.25, 1e-10);
    }
}

/*
 * Just before one disc swallows another |k| is 1 but for rounding: sqrt(|D|^2 - K^2) was wrong by 1e-8 there, and with it the arrival. The tangent from the point that the
 * rider leaves, L = sqrt(|O_j - P|^2 - R_j^2) / sin(theta_j), is not.
 */
static void a_leg_that_leaves_as_its_disc_is_swallowed_has_the_length_of_the_tangent(void **state)
{
    (void)state;
    const geom_disc i = disc_make(point_make(0.75, 0.0), 0.125, 0.0056967725160056715), j = disc_make(point_make(0.25, 0.5), 0.125, 0.125);
    const geom_pair pair = pair_make(&i, &j);
    const geom_tangent tangent = tangent_make(&pair, 1, 1, 1);
    double ends[4];
    assert_int_equal(tangent_domain(&tangent, 5.0, 7.0, ends), 1);
    for (double before = 1e-3; before > 1e-17; before *= 0.7) {
        const double met = ends[1] - before, start = met - 1e-3;
        const double angle = tangent_heading(&tangent, met) - i.theta - spiral_angle(&i, start, met);
        const geom_ride ride = {&i, 1, angle, start, ends[1]};
        double leave;
        const int leaves = tangent_leave(&tangent, angle, start, ends[1], &leave);
        assert_true(leaves || before < 1e-14); /* then rounding may have it that the rider comes too late */
        if (!leaves) continue;
        const geom_leg leg = tangent_leg(&tangent, ride_angle(&ride, leave), leave);
        const double away = point_distance(disc_boundary(&i, leg.normal, leave), j.center), radius = disc_radius(&j, leave);
        const double expected = sqrt((away - radius) * (away + radius)) / j.sine;
        /* In the slack of the domain's end the legs taken are those of the very end. */
        assert_near(leg.length, expected, before > 1e-12 ? 1e-13 : 1e-11);
    }
}

/* Between concentric discs every angle will do; on a pebble far from the leg's end the ride knows the angle better than the tangent. */
static void the_normal_of_a_departure_is_the_riders_own_where_the_tangent_knows_less(void **state)
{
    (void)state;
    geom_disc i = disc_make(point_make(1.0, 2.0), 1.0, 0.5), j = disc_make(point_make(1.0, 2.0), 0.5, 0.75);
    geom_pair nested = pair_make(&i, &j);
    geom_tangent tangent = tangent_make(&nested, 1, -1, 1);
    assert_exact(tangent_leg(&tangent, 0.625, 0.0).normal, 0.625);
    i = disc_make(point_make(0.0, 0.0), 1.0, 0.5), j = disc_make(point_make(1e-16, 0.0), 1.0, 0.5); /* the same but for rounding */
    geom_pair twins = pair_make(&i, &j);
    tangent = tangent_make(&twins, 1, 1, 1);
    assert_exact(tangent_leg(&tangent, 0.625, 0.0).normal, 0.625);
    assert_near(tangent_leg(&tangent, 0.625, 0.0).length, 0.0, 1e-15);
    i = disc_make(point_make(1.0, 2.0), 1.0, 0.5), j = disc_make(point_make(3.0, 2.0), 0.5, 0.75);
    geom_pair apart = pair_make(&i, &j);
    tangent = tangent_make(&apart, 1, 1, 1);
    assert_near(tangent_leg(&tangent, 0.625, 0.0).normal, tangent_heading(&tangent, 0.0) - i.theta, 1e-15);
    i = disc_make(point_make(0.0, 0.0), 2.0, 0.0), j = disc_make(point_make(2.0, 0.0), 0.0, 0.0);
    geom_pair touching = pair_make(&i, &j);
    tangent = tangent_make(&touching, 1, 1, 1);
    assert_exact(tangent_leg(&tangent, 0.625, 0.0).normal, 0.625);
}

/* Rates whose squares are zero: the discs stand still as far as anybody can tell, and their cross legs with them. */
static void discs_that_grow_by_next_to_nothing_have_the_legs_of_discs_that_stand(void **state)
{
    (void)state;
    for (int apart = 0; apart < 2; ++apart) {
        geom_disc i = disc_make(point_make(0.0, 0.0), 1.0, 1e-200), j = disc_make(point_make(apart ? 3.0 : 0.5, 0.0), 0.5, 3e-200);
        geom_pair pair = pair_make(&i, &j);
        for (int side = -1; side <= 1; side += 2) {
            geom_tangent tangent = tangent_make(&pair, side, -side, 1);
            double ends[4];
            assert_int_equal(tangent_domain(&tangent, 0.0, 2.0, ends), apart);
            if (!apart) continue;
            assert_exact(ends[0], 0.0);
            assert_exact(ends[1], 2.0);
            assert_near(tangent_length(&tangent, 1.0), sqrt(9.0 - 2.25), 1e-14);
        }
    }
}

/* Two points at one place that begin to grow: the leg has no length, and only then. */
static void two_points_at_one_place_have_a_leg_at_one_moment(void **state)
{
    (void)state;
    geom_disc i = disc_make(point_make(1.0, 1.0), 0.0, 0.1), j = disc_make(point_make(1.0, 1.0), 0.0, 0.3);
    geom_pair pair = pair_make(&i, &j);
    for (int side = -1; side <= 1; side += 2)
        for (int to_side = -1; to_side <= 1; to_side += 2) {
            geom_tangent tangent = tangent_make(&pair, side, to_side, 1);
            double ends[4];
            int pieces = tangent_domain(&tangent, 0.0, 2.0, ends);
            if (!pieces) continue;
            assert_int_equal(pieces, 1);
            assert_exact(ends[0], 0.0);
            assert_near(ends[1], 0.0, 1e-12); /* the domain's slack at the rates at hand */
        }
}

/* With a disc that stands K, w and their sum of squares less |D|^2 can all be told to the bit: here the leg of the second root vanishes at the very begin, and comes back. */
static void a_leg_may_vanish_in_the_moment_at_which_the_search_begins(void **state)
{
    (void)state;
    geom_disc i = disc_make(point_make(0.0, 0.0), 1.0, 0.0), j = disc_make(point_make(0.0, 0.0), 0.0, 0.6);
    j.radius = j.sine; /* K = 0, w = -0.6 */
    double lo = 0.5, hi = 0.7, ends[4];
    geom_tangent tangent;
    do {
        j.center.x = 0.5 * (lo + hi);
        geom_pair pair = pair_make(&i, &j);
        tangent = tangent_make(&pair, 1, 1, -1);
        *(tangent.farthest < 0.6 ? &lo : &hi) = j.center.x;
    } while (tangent.farthest != 0.6 && nextafter(lo, hi) < hi);
    assert_exact(tangent.farthest, 0.6);
    assert_int_equal(tangent_domain(&tangent, 0.0, 0.5, ends), 2);
    assert_exact(ends[0], 0.0);
    assert_exact(ends[1], 0.0);
    assert_exact(ends[2], 0.0);
    assert_exact(ends[3], 0.5);
}

/* Where |k| = 1 a departure point moves by more in one double of time than an angle may be wrong: the two on both sides are all there is. */
static void a_rider_leaves_at_the_nearest_double_where_the_departure_point_races(void **state)
{
    (void)state;
    uint64_t chance = 6;
    int left = 0;
    for (int k = 0; k < 12000; ++k) {
        branch b = random_branch(&chance, k % 2 ? 1 : -1);
        const double late = pow(10.0, k / 16 % 7); /* the doubles of time are ever farther apart */
        b.i.radius -= late * b.i.rate;
        b.j.radius -= late * b.j.rate;
        geom_pair pair = pair_make(&b.i, &b.j);
        b.side = k % 4 < 2 ? 1 : -1;
        b.to_side = k % 8 < 4 ? 1 : -1;
        geom_tangent tangent = tangent_make(&pair, b.side, b.to_side, k % 16 < 8 ? 1 : -1);
        double ends[4], leave;
        if (!tangent_domain(&tangent, late, late + 2.0, ends) || ends[1] >= late + 2.0 || ends[1] <= ends[0]) continue;
        double time = ends[1] - (ends[1] - ends[0]) * pow(10.0, chance_between(&chance, -16.0, -8.0));
        double normal = tangent_heading(&tangent, time) - b.side * b.i.theta;
        double angle = normal - b.side * spiral_angle(&b.i, ends[0], time);
        if (!tangent_leave(&tangent, angle, ends[0], ends[1], &leave)) continue;
        assert_true(leave >= ends[0] && leave <= ends[1]);
        ++left;
    }
    assert_true(left > 100);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_leg_touches_both_discs_tangentially_and_in_time),
        cmocka_unit_test(no_leg_is_missing_at_any_moment),
        cmocka_unit_test(a_rider_finds_every_moment_to_leave),
        cmocka_unit_test(concentric_discs_are_left_at_one_moment_from_every_angle),
        cmocka_unit_test(concentric_discs_of_one_rate_have_no_leg),
        cmocka_unit_test(same_rate_and_side_keep_heading_and_length_for_ever),
        cmocka_unit_test(a_leg_that_leaves_as_its_disc_is_swallowed_has_the_length_of_the_tangent),
        cmocka_unit_test(a_rider_who_starts_at_the_departure_point_leaves_at_once),
        cmocka_unit_test(the_normal_of_a_departure_is_the_riders_own_where_the_tangent_knows_less),
        cmocka_unit_test(discs_that_grow_by_next_to_nothing_have_the_legs_of_discs_that_stand),
        cmocka_unit_test(two_points_at_one_place_have_a_leg_at_one_moment),
        cmocka_unit_test(a_leg_may_vanish_in_the_moment_at_which_the_search_begins),
        cmocka_unit_test(a_rider_leaves_at_the_nearest_double_where_the_departure_point_races),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
