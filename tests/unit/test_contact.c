/* SPDX-License-Identifier: MIT */
/* Straight motions and rides against discs: what is said of the first contact, against dense sampling of the distance. */
#include "support/cmocka_all.h"

#include "geom/contact.h"
#include "geom/spiral.h"
#include "geom/tolerance.h"
#include "support/chance.h"

/* Deeper than this is a collision for certain, also between two samples; shallower may be called a touch. */
#define DEEP 1e-6

typedef double (*clearance_at)(const void *motion, const geom_disc *disc, double at);

typedef struct sampled {
    double least;   /* least clearance */
    double first;   /* the first place with a clearance under -DEEP; infinite when none */
} sampled;

/* The least value beside a sample, by narrowing down on it. */
static double least_near(clearance_at clearance, const void *motion, const geom_disc *disc, double lo, double hi)
{
    for (int step = 0; step < 60; ++step) {
        double a = lo + (hi - lo) / 3.0, b = hi - (hi - lo) / 3.0;
        if (clearance(motion, disc, a) < clearance(motion, disc, b)) {
            hi = b;
        } else {
            lo = a;
        }
    }
    return clearance(motion, disc, 0.5 * (lo + hi));
}

static sampled sample(clearance_at clearance, const void *motion, const geom_disc *disc, double from, double to, int count)
{
    sampled result = {INFINITY, INFINITY};
    double best = from, step = (to - from) / count;
    for (int k = 0; k <= count; ++k) {
        double at = k < count ? from + step * k : to, value = clearance(motion, disc, at);
        if (value < -DEEP && isinf(result.first)) result.first = at;
        if (value >= result.least) continue;
        result.least = value;
        best = at;
    }
    result.least = fmin(result.least, least_near(clearance, motion, disc, fmax(from, best - step), fmin(to, best + step)));
    return result;
}

static double line_clear(const void *motion, const geom_disc *disc, double at)
{
    const geom_line *line = motion;
    return point_distance(point_along(line->from, at, line->heading), disc->center) - disc_radius(disc, line->start + at);
}

static geom_line random_line(uint64_t *chance)
{
    geom_line line = {point_make(chance_between(chance, -4.0, 4.0), chance_between(chance, -4.0, 4.0)),
                      point_unit(chance_between(chance, -3.2, 3.2)), chance_between(chance, 0.0, 1.0), chance_between(chance, 0.0, 6.0)};
    return line;
}

/* Standing, slow, as fast as the robot, faster; for reversed time negative, and then large enough at first. */
static geom_disc random_disc(uint64_t *chance)
{
    static const double special[] = {0.0, 1.0, 1.5, 0.999, 1e-9, 1.0 - 1e-12};
    uint64_t pick = chance_below(chance, 12);
    double rate = pick < 6 ? special[pick] : chance_between(chance, 0.0, 0.98), radius = chance_between(chance, 0.0, 1.5);
    if (chance_below(chance, 2)) return disc_make(point_make(chance_between(chance, -3.0, 3.0), chance_between(chance, -3.0, 3.0)), radius + 3.0 * rate, -rate);
    return disc_make(point_make(chance_between(chance, -3.0, 3.0), chance_between(chance, -3.0, 3.0)), radius, rate);
}

static void a_line_is_blocked_exactly_when_samples_lie_inside(void **state)
{
    (void)state;
    uint64_t chance = 1;
    int blocked = 0, open = 0;
    for (int k = 0; k < 20000; ++k) {
        geom_line line = random_line(&chance);
        geom_disc disc = random_disc(&chance);
        sampled truth = sample(line_clear, &line, &disc, 0.0, line.length, 200);
        if (fabs(truth.least) < 1e-9) continue;
        assert_int_equal(line_blocked(&line, &disc) != 0, truth.least < 0.0);
        *(truth.least < 0.0 ? &blocked : &open) += 1;
    }
    assert_true(blocked > 2000 && open > 2000);
}

static void the_first_contact_of_a_line_is_where_it_enters(void **state)
{
    (void)state;
    uint64_t chance = 2;
    int entered = 0;
    for (int k = 0; k < 10000; ++k) {
        geom_line line = random_line(&chance);
        geom_disc disc = random_disc(&chance);
        sampled truth = sample(line_clear, &line, &disc, 0.0, line.length, 1000);
        double first = line_first_contact(&line, &disc);
        if (fabs(truth.least) > 1e-9) assert_int_equal(isinf(first), truth.least > 0.0);
        assert_true(first <= truth.first);
        if (isinf(first)) continue;
        if (first > 0.0) assert_near(line_clear(&line, &disc, first), 0.0, 1e-9);
        sampled before = sample(line_clear, &line, &disc, 0.0, first, 100);
        if (first > 0.0) assert_true(before.least > -1e-9);
        ++entered;
    }
    assert_true(entered > 1000);
}

static void a_line_that_only_touches_is_free(void **state)
{
    (void)state;
    uint64_t chance = 3;
    for (int k = 0; k < 2000; ++k) {
        /* A tangent motion from first principles: at the touch the heading is at theta from the normal. */
        geom_disc disc = random_disc(&chance);
        if (!disc_ridable(&disc)) continue;
        double touch = chance_between(&chance, 0.0, 1.0), normal = chance_between(&chance, -3.0, 3.0);
        if (disc_radius(&disc, touch) <= 0.0) continue;
        tdsp_point heading = point_unit(disc_heading(&disc, k % 2 ? 1 : -1, normal));
        geom_line line = {point_along(disc_boundary(&disc, normal, touch), -touch, heading), heading, 0.0, 2.0};
        assert_false(line_blocked(&line, &disc));
        assert_true(isinf(line_first_contact(&line, &disc)));
    }
}

static double ride_clear(const void *motion, const geom_disc *disc, double at)
{
    return point_distance(ride_position(motion, at), disc->center) - disc_radius(disc, at);
}

/* A ride of up to two radians, in either direction of time. */
static geom_ride random_ride(uint64_t *chance, geom_disc *disc)
{
    double rate = chance_below(chance, 4) ? chance_between(chance, -0.95, 0.97) : 0.0;
    *disc = disc_make(point_make(0.0, 0.0), chance_between(chance, 0.3, 2.0) + (rate < 0.0 ? 1.0 : 0.0), rate);
    double start = chance_between(chance, 0.0, 0.5), end = start + spiral_duration(disc, start, chance_between(chance, 0.01, 2.0));
    geom_ride ride = {disc, chance_below(chance, 2) ? 1 : -1, chance_between(chance, -3.0, 3.0), start, end};
    return ride;
}

static void check_ride(const geom_ride *ride, const geom_disc *other, int counts[2])
{
    sampled truth = sample(ride_clear, ride, other, ride->start, ride->end, 1500);
    double first = ride_contact(ride, other);
    assert_true(first <= truth.first);
    if (truth.least > 1e-9) assert_true(isinf(first));
    ++counts[isinf(first) != 0];
    if (isinf(first)) return;
    assert_true(first >= ride->start && first <= ride->end);
    if (first == ride->start) {
        assert_true(ride_clear(ride, other, first) < 1e-9);
        return;
    }
    assert_near(ride_clear(ride, other, first), 0.0, 1e-7);
    sampled before = sample(ride_clear, ride, other, ride->start, first, 300);
    assert_true(before.least > -1e-9);
}

static void the_first_contact_of_a_ride_is_where_it_enters(void **state)
{
    (void)state;
    uint64_t chance = 4;
    int counts[2] = {0, 0};
    for (int k = 0; k < 6000; ++k) {
        geom_disc disc, other = random_disc(&chance);
        geom_ride ride = random_ride(&chance, &disc);
        check_ride(&ride, &other, counts);
    }
    assert_true(counts[0] > 600 && counts[1] > 600);
}

/* The rider starts at the corner of two overlapping discs or just beside: the corner then runs after the rider, or away from it. */
static void a_ride_from_a_corner_ends_where_the_corner_catches_up(void **state)
{
    (void)state;
    uint64_t chance = 5;
    int counts[2] = {0, 0};
    for (int k = 0; k < 6000; ++k) {
        geom_disc disc;
        geom_ride ride = random_ride(&chance, &disc);
        double rate = chance_between(&chance, 0.0, 0.97) * (disc.rate < 0.0 ? -1.0 : 1.0), apart = chance_between(&chance, 0.5, 4.0);
        double beside = k % 3 ? pow(10.0, chance_between(&chance, -8.0, -1.0)) : 0.0;
        tdsp_point center = point_along(ride_position(&ride, ride.start), apart, point_unit(chance_between(&chance, -3.0, 3.0)));
        geom_disc other = disc_make(center, apart * (1.0 - beside) - rate * ride.start, rate); /* its boundary passes by the rider */
        check_ride(&ride, &other, counts);
    }
    assert_true(counts[0] > 600 && counts[1] > 600);
}

/* Two discs that meet while the rider rides through the gap: the corner appears at infinite speed. */
static void a_closing_gap_stops_the_rider_in_it(void **state)
{
    (void)state;
    uint64_t chance = 6;
    int counts[2] = {0, 0};
    for (int k = 0; k < 4000; ++k) {
        double rate = chance_between(&chance, 0.05, 0.9), r = chance_between(&chance, 0.5, 2.0), q = chance_between(&chance, 0.5, 2.0);
        double gap = pow(10.0, chance_between(&chance, -9.0, -0.5));
        geom_disc disc = disc_make(point_make(0.0, 0.0), r, chance_between(&chance, 0.0, rate));
        geom_disc other = disc_make(point_make(r + q + gap, 0.0), q, rate);
        double angle = chance_between(&chance, -0.6, 0.0);
        geom_ride ride = {&disc, 1, angle, 0.0, spiral_duration(&disc, 0.0, 0.25)};
        check_ride(&ride, &other, counts);
    }
    assert_true(counts[0] > 400 && counts[1] > 400);
}

static void a_ride_inside_another_disc_is_stopped_at_once(void **state)
{
    (void)state;
    geom_disc disc = disc_make(point_make(0.0, 0.0), 1.0, 0.2), other = disc_make(point_make(0.5, 0.0), 3.0, 0.1);
    geom_ride ride = {&disc, 1, 0.0, 0.0, 1.0};
    assert_exact(ride_contact(&ride, &other), 0.0);
}

static void a_ride_that_passes_a_touching_disc_is_free(void **state)
{
    (void)state;
    /* Disc and neighbour touch from outside for ever: both stand still. */
    geom_disc disc = disc_make(point_make(0.0, 0.0), 1.0, 0.0), other = disc_make(point_make(3.0, 0.0), 2.0, 0.0);
    geom_ride ride = {&disc, 1, -0.5, 0.0, 1.0};
    assert_true(isinf(ride_contact(&ride, &other)));
}

/* Two discs of one rate whose corner is as fast as a robot at time 0, where it is at the angle *corner, with so much room (or the lack of it) between them. */
static void slow_corner(geom_disc *disc, geom_disc *other, double radius, double q, double rate, double room, double *corner)
{
    *disc = disc_make(point_make(0.0, 0.0), radius, rate);
    double turn = 2.0 * disc->theta, apart = sqrt(radius * radius + q * q - 2.0 * radius * q * cos(turn));
    *corner = -atan2(q * sin(turn), radius - q * cos(turn));
    *other = disc_make(point_make(apart + room, 0.0), q, rate);
}

/* The rider reaches the corner in the moment in which it has become slow enough to be escaped. */
static int touches(const geom_disc *disc, const geom_disc *other, double corner, double *time)
{
    double turn = 0.2, begins = disc->radius / disc->rate * expm1(-disc->rate / disc->sine * turn);
    geom_ride ride = {disc, -1, corner + turn, begins, 0.5 * turn};
    return ride_touch(&ride, other, time);
}

static void a_touch_is_found_as_long_as_the_rider_is_let_past_and_no_longer(void **state)
{
    (void)state;
    uint64_t chance = 7;
    for (int k = 0; k < 500; ++k) {
        geom_disc disc, other;
        double corner, time = -1.0, rate = chance_between(&chance, 0.05, 0.5), q = chance_between(&chance, 0.2, 3.0);
        slow_corner(&disc, &other, 1.0, q, rate, 0.0, &corner);
        assert_true(touches(&disc, &other, corner, &time));
        assert_near(time, 0.0, 1e-9);
        slow_corner(&disc, &other, 1.0, q, rate, -1e-9, &corner);
        assert_false(touches(&disc, &other, corner, &time));
        slow_corner(&disc, &other, 1.0, q, rate, 1e-9, &corner);
        assert_false(touches(&disc, &other, corner, &time));
    }
}

static void whoever_comes_over_at_a_touch_rides_on(void **state)
{
    (void)state;
    geom_disc small = disc_make(point_make(0.0, 0.0), 0.01, 0.0), large = disc_make(point_make(1.01, 0.0), 1.0 + 1e-12, 0.0);
    geom_ride over = {&large, 1, GEOM_PI, 0.0, 0.5};
    assert_true(isinf(ride_contact(&over, &small)));
    large.radius = 1.0 + 1e-11;
    assert_exact(ride_contact(&over, &small), 0.0);
}

static void a_rider_who_was_there_before_or_will_not_be_there_touches_nothing(void **state)
{
    (void)state;
    geom_disc disc, other;
    double corner, time, begins = -0.1;
    slow_corner(&disc, &other, 1.0, 1.5, 0.25, 0.0, &corner);
    geom_ride behind = {&disc, -1, corner - 0.5, begins, 0.05}, before = {&disc, -1, corner + 0.5, begins, 0.05};
    assert_false(ride_touch(&behind, &other, &time));
    assert_false(ride_touch(&before, &other, &time));
}

static void a_gap_that_stays_open_or_is_closed_all_the_time_is_not_touched(void **state)
{
    (void)state;
    double corner, time;
    for (int k = 0; k < 4; ++k) {
        geom_disc disc, other;
        slow_corner(&disc, &other, 1.0, 1.5, 0.25, k % 2 ? 0.5 : -0.5, &corner);
        if (k > 1) disc = disc_make(disc.center, disc.radius, -disc.rate), other = disc_make(other.center, other.radius, -other.rate);
        assert_false(touches(&disc, &other, corner, &time));
    }
}

/* Who is stopped where the gap closes ends with nothing left between, and does not touch; nor does who ends there by himself. */
static void a_rider_who_is_stopped_by_the_closing_gap_does_not_touch(void **state)
{
    (void)state;
    int stopped = 0, past = 0, only_on = 0;
    for (int k = 0; k < 2000; ++k) {
        geom_disc disc, other;
        double corner, time, turn = 0.2;
        slow_corner(&disc, &other, 1.0, 1.5, 0.25, -2e-15 * k, &corner);
        geom_ride ride = {&disc, -1, corner + turn, disc.radius / disc.rate * expm1(-disc.rate / disc.sine * turn), 0.5 * turn};
        double first = ride_contact(&ride, &other);
        geom_ride ended = ride;
        ended.end = 0.0;
        if (ride_touch(&ride, &other, &time)) only_on += !ride_touch(&ended, &other, &time);
        else assert_false(ride_touch(&ended, &other, &time));
        if (!isinf(first)) ride.end = first;
        int touch = ride_touch(&ride, &other, &time);
        if (!isinf(first)) assert_false(touch);
        stopped += !isinf(first);
        past += touch;
    }
    assert_true(stopped > 50 && past > 50 && only_on > 0);
}

/* Discs of any size whose corner moves as fast as a rider in a moment of the ride, who is there or nearly: a touch is claimed only at the other's boundary. */
static void a_touch_that_is_claimed_is_one(void **state)
{
    (void)state;
    uint64_t chance = 8;
    int claimed = 0;
    for (int k = 0; k < 20000; ++k) {
        double sign = k % 2 ? 1.0 : -1.0, start = chance_between(&chance, 0.0, 0.5), time;
        geom_disc disc = disc_make(point_make(0.0, 0.0), chance_between(&chance, 0.05, 3.0) + (k % 2 ? 0.0 : 1.5), sign * chance_between(&chance, 0.0, 0.97));
        geom_disc other = disc_make(point_make(0.0, 0.0), chance_between(&chance, 0.01, 5.0), sign * chance_between(&chance, 0.0, 0.97));
        geom_ride ride = {&disc, k % 4 < 2 ? 1 : -1, chance_between(&chance, -3.2, 3.2), start, start + spiral_duration(&disc, start, chance_between(&chance, 0.01, 6.0))};
        double meets = chance_between(&chance, ride.start, ride.end), r = disc_radius(&disc, meets), q = disc_radius(&other, meets);
        other.center.x = sqrt(fmax(r * r + q * q - 2.0 * r * q * cos(disc.theta + other.theta), 0.0));
        double apart = other.center.x, cosine = (apart * apart + r * r - q * q) / (2.0 * apart * r);
        if (!(fabs(cosine) <= 1.0)) continue;
        double off = k % 3 ? pow(10.0, chance_between(&chance, -14.0, -1.0)) * chance_between(&chance, -1.0, 1.0) : 0.0;
        ride.angle = (k % 8 < 4 ? 1.0 : -1.0) * acos(cosine) - ride.side * spiral_angle(&disc, start, meets) + off;
        if (!ride_touch(&ride, &other, &time)) continue;
        claimed++;
        assert_true(time >= ride.start && time <= ride.end);
        assert_near(ride_clear(&ride, &other, time), 0.0, 4.0 * GEOM_CONTACT * (1.0 + disc_radius(&other, time)));
    }
    assert_true(claimed > 1000);
}

/* The least radius with which the ride is stopped, where at its start the disc is up to `most` large. */
static double least_that_stops(const geom_ride *ride, geom_disc *other, double most)
{
    double lo = -other->rate * ride->start, hi = lo + most;
    for (int step = 0; step < 70; ++step) {
        other->radius = 0.5 * (lo + hi);
        *(isinf(ride_contact(ride, other)) ? &lo : &hi) = other->radius;
    }
    return hi;
}

/* Radii on both sides of that one, a double apart. */
static void try_radii_beside(const geom_ride *ride, geom_disc *other, double tolerance)
{
    other->radius = least_that_stops(ride, other, 20.0);
    for (int step = 0; step < 20; ++step) other->radius = nextafter(other->radius, -INFINITY);
    for (int step = 0; step < 40; ++step) {
        other->radius = nextafter(other->radius, INFINITY);
        double first = ride_contact(ride, other);
        if (isinf(first)) continue;
        assert_true(first >= ride->start && first <= ride->end);
        assert_near(ride_clear(ride, other, first), 0.0, tolerance);
    }
}

static void a_ride_that_rounding_alone_decides_is_stopped_where_it_is_nearest_or_not_at_all(void **state)
{
    (void)state;
    uint64_t chance = 9;
    for (int k = 0; k < 150; ++k) {
        geom_disc disc = disc_make(point_make(0.0, 0.0), 1.0, chance_between(&chance, 0.0, 0.9));
        geom_disc other = disc_make(point_make(chance_between(&chance, 2.0, 6.0), 0.0), 0.0, chance_between(&chance, 0.0, 0.9));
        geom_ride ride = {&disc, 1, -chance_between(&chance, 0.1, 1.0), 0.0, 2.0};
        try_radii_beside(&ride, &other, 1e-7);
    }
}

/* Halving a ride between two doubles that follow one another went on for ever where rounding could not decide it. */
static void a_ride_of_one_unit_in_the_last_place_of_time_comes_to_an_end(void **state)
{
    (void)state;
    uint64_t chance = 10;
    for (int k = 0; k < 200; ++k) {
        double begins = pow(10.0, 3 + k % 6), c = chance_between(&chance, 0.0, 0.9);
        geom_disc disc = disc_make(point_make(0.0, 0.0), 1.0 - c * begins, c);
        geom_disc other = disc_make(point_make(chance_between(&chance, 2.0, 6.0), 0.0), 0.0, chance_between(&chance, 0.0, 0.9));
        geom_ride ride = {&disc, 1, -chance_between(&chance, 0.1, 1.0), begins, nextafter(begins, INFINITY)};
        try_radii_beside(&ride, &other, 1e-6 /* radii that are differences of 1e8 and more */);
    }
}

/*
 * A ride that begins in a touch to the bit is decided by no bound on its way from there. From time 0 on it could be halved a thousand times, which is more than there is
 * room for: it is followed to the smallest interval.
 */
static void a_ride_that_begins_in_a_touch_to_the_bit_is_halved_to_the_smallest_interval(void **state)
{
    (void)state;
    geom_disc disc = disc_make(point_make(0.0, 0.0), 1.0, 0.0);
    geom_ride ride = {&disc, 1, 0.0, 0.0, 0.5};
    int met = 0;
    for (int k = 1; k <= 100; ++k) {
        const double distance = k * 0x1p-50;
        geom_disc other = disc_make(point_make(1.0 + distance, 0.0), distance, 0.0);
        for (int step = 0; step < 8; ++step) other.radius = distance + tolerance_touch(other.center, distance + other.radius);
        if (distance - other.radius + tolerance_touch(other.center, distance + other.radius) != 0.0) continue;
        assert_true(isinf(ride_contact(&ride, &other)));
        ++met;
    }
    assert_true(met > 20);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_rider_who_was_there_before_or_will_not_be_there_touches_nothing),
        cmocka_unit_test(a_gap_that_stays_open_or_is_closed_all_the_time_is_not_touched),
        cmocka_unit_test(a_rider_who_is_stopped_by_the_closing_gap_does_not_touch),
        cmocka_unit_test(a_touch_that_is_claimed_is_one),
        cmocka_unit_test(a_ride_that_rounding_alone_decides_is_stopped_where_it_is_nearest_or_not_at_all),
        cmocka_unit_test(a_ride_of_one_unit_in_the_last_place_of_time_comes_to_an_end),
        cmocka_unit_test(a_ride_that_begins_in_a_touch_to_the_bit_is_halved_to_the_smallest_interval),
        cmocka_unit_test(a_touch_is_found_as_long_as_the_rider_is_let_past_and_no_longer),
        cmocka_unit_test(whoever_comes_over_at_a_touch_rides_on),
        cmocka_unit_test(a_line_is_blocked_exactly_when_samples_lie_inside),
        cmocka_unit_test(the_first_contact_of_a_line_is_where_it_enters),
        cmocka_unit_test(a_line_that_only_touches_is_free),
        cmocka_unit_test(the_first_contact_of_a_ride_is_where_it_enters),
        cmocka_unit_test(a_ride_from_a_corner_ends_where_the_corner_catches_up),
        cmocka_unit_test(a_closing_gap_stops_the_rider_in_it),
        cmocka_unit_test(a_ride_inside_another_disc_is_stopped_at_once),
        cmocka_unit_test(a_ride_that_passes_a_touching_disc_is_free),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
