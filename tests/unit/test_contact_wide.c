/* SPDX-License-Identifier: MIT */
/*
 * Rides on discs that grow or shrink manyfold and more than once around, against the same rides in short pieces; touches at every place of a ride, in both
 * directions of time; who is let past though he begins inside; and what a touch of a line is.
 */
#include "support/cmocka_all.h"

#include "geom/contact.h"
#include "geom/spiral.h"
#include "geom/tolerance.h"
#include "support/chance.h"

/* ----------------------------------------------------------------------------------------------------- where a ride ends */

static double any_size(uint64_t *chance, double lowest, double highest)
{
    return pow(10.0, chance_between(chance, lowest, highest));
}

/* Up to ten radians; the radius shrinks to a 30th or grows to the 1000-fold at most. */
static geom_ride wide_ride(uint64_t *chance, geom_disc *disc)
{
    double rate = chance_between(chance, -0.97, 0.97), radius = any_size(chance, -2.0, 1.0), turn = any_size(chance, -1.0, 1.0);
    *disc = disc_make(point_make(0.0, 0.0), radius, rate);
    double most = log(rate < 0.0 ? 30.0 : 1000.0) * disc->sine / fabs(rate);
    geom_ride ride = {disc, chance_below(chance, 2) ? 1 : -1, chance_between(chance, -3.2, 3.2), 0.0, spiral_duration(disc, 0.0, fmin(turn, most))};
    return ride;
}

/* A disc whose boundary is met during the ride or nearly so, across or along it. */
static geom_disc disc_met(uint64_t *chance, const geom_ride *ride)
{
    double met = spiral_duration(ride->disc, 0.0, chance_unit(chance) * spiral_angle(ride->disc, 0.0, ride->end));
    double own = disc_radius(ride->disc, met), apart = own * any_size(chance, -1.5, 1.5), deep = chance_below(chance, 2) ? 0.0 : any_size(chance, -6.0, 0.0);
    double rate = chance_between(chance, 0.0, 0.97) * (ride->disc->rate < 0.0 ? -1.0 : 1.0);
    geom_disc other = disc_make(point_make(0.0, 0.0), 0.0, rate);
    double heading = disc_heading(ride->disc, ride->side, ride_angle(ride, met)), beside = chance_below(chance, 2) ? other.theta : chance_between(chance, 0.0, GEOM_PI);
    other.center = point_along(ride_position(ride, met), -apart, point_unit(heading + (chance_below(chance, 2) ? beside : -beside)));
    other.radius = apart * (1.0 + (chance_below(chance, 2) ? deep : -0.5 * deep)) - rate * met;
    return other;
}

static double contact_in_pieces(const geom_ride *ride, geom_disc other, double larger)
{
    geom_ride piece = *ride;
    other.radius += larger;
    for (piece.end = ride->start; piece.end < ride->end;) {
        piece.start = piece.end;
        piece.angle = ride_angle(ride, piece.start);
        piece.end = fmin(ride->end, piece.start + spiral_duration(ride->disc, piece.start, 0.2));
        double first = ride_contact(&piece, &other);
        if (!isinf(first)) return first;
    }
    return INFINITY;
}

static double ride_clear(const geom_ride *ride, const geom_disc *disc, double at)
{
    return point_distance(ride_position(ride, at), disc->center) - disc_radius(disc, at);
}

/* Between those of a disc a little larger and one a little smaller; where it enters, its place is known to a few roundings. */
static int check_pieces(const geom_ride *ride, const geom_disc *other)
{
    double first = ride_contact(ride, other), beside = 1e-8 * point_length(other->center);
    assert_true(first <= contact_in_pieces(ride, *other, -beside));
    assert_true(first >= contact_in_pieces(ride, *other, beside));
    if (isinf(first)) return 0;
    assert_true(first >= ride->start && first <= ride->end);
    double sizes = disc_radius(ride->disc, first) + point_length(other->center) + disc_radius(other, first);
    if (first > ride->start) assert_near(ride_clear(ride, other, first), 0.0, 1e-11 * sizes);
    return 1;
}

static void a_ride_ends_where_its_pieces_do_however_much_the_disc_grows_or_shrinks(void **state)
{
    (void)state;
    uint64_t chance = 1;
    int ended = 0, free = 0;
    for (int k = 0; k < 30000; ++k) {
        geom_disc disc;
        geom_ride ride = wide_ride(&chance, &disc);
        geom_disc other = disc_met(&chance, &ride);
        *(check_pieces(&ride, &other) ? &ended : &free) += 1;
    }
    assert_true(ended > 10000 && free > 3000);
}

/* The disc ridden shrinks so far that bounds by its first radius would not see what the rider runs into at its last. */
static void a_contact_after_the_radius_shrank_is_not_missed(void **state)
{
    (void)state;
    const struct {
        double radius, rate, angle, end;
        double x, y, other, other_rate;
    } rides[] = {{3.85, -0.743, 1.95, 5.18, -0.932, -2.26, 5.74, -0.683},
                 {0.0684, -0.515, -1.68, 0.131, 0.0448, 0.58, 0.57, 0.0},
                 {0.0317, -0.756, 1.29, 0.0419, -0.000305, -0.000613, 0.00755, -0.184},
                 {0.485, -0.626, -1.06, 0.773, 0.132, 1.23, 1.61, -0.583}};
    for (size_t i = 0; i < sizeof rides / sizeof *rides; ++i) {
        geom_disc disc = disc_make(point_make(0.0, 0.0), rides[i].radius, rides[i].rate);
        geom_disc other = disc_make(point_make(rides[i].x, rides[i].y), rides[i].other, rides[i].other_rate);
        for (int side = -1; side <= 1; side += 2) {
            geom_ride ride = {&disc, side, rides[i].angle, 0.0, rides[i].end};
            (void)check_pieces(&ride, &other);
        }
    }
}

/* ------------------------------------------------------------------------------------------------------------- touches */

/* A ride and a disc on the other side of its way (or on the same one) that it touches, leaving it, at the moment `met`. */
typedef struct touch {
    geom_disc disc, other;
    geom_ride ride;
    double met;
} touch;

static void touch_draw_at(uint64_t *chance, int is_on_other_side, double rate, double other_rate, touch *out)
{
    double own = any_size(chance, -1.0, 0.5), radius = own * any_size(chance, -1.5, is_on_other_side ? 1.0 : -0.5), normal = chance_between(chance, -3.2, 3.2);
    int side = chance_below(chance, 2) ? 1 : -1;
    out->disc = disc_make(point_make(0.0, 0.0), own, rate);
    out->other = disc_make(point_make(0.0, 0.0), radius, other_rate);
    double heading = normal + side * out->disc.theta, other_normal = heading + (is_on_other_side ? side : -side) * out->other.theta;
    out->other.center = point_along(point_scale(own, point_unit(normal)), -radius, point_unit(other_normal));
    /* Some of what is forgiven, either way. */
    out->other.radius += chance_between(chance, -0.4, 0.4) * 2e-12 * radius;
    double before = -spiral_duration(&out->disc, 0.0, chance_below(chance, 3) ? chance_between(chance, 0.0, 1.5) : 0.0);
    out->ride.disc = &out->disc;
    out->ride.side = side;
    out->ride.start = before;
    out->ride.end = chance_below(chance, 3) ? spiral_duration(&out->disc, 0.0, chance_between(chance, 0.0, 0.3)) : 0.0;
    out->ride.angle = normal - side * spiral_angle(&out->disc, out->ride.start, 0.0);
    out->met = 0.0;
}

static void touch_draw(uint64_t *chance, int is_on_other_side, touch *out)
{
    double sign = chance_below(chance, 2) ? 1.0 : -1.0, rate = sign * chance_between(chance, 0.0, 0.97);
    touch_draw_at(chance, is_on_other_side, rate, sign * chance_between(chance, 0.0, 0.97), out);
}

static void touch_draw_fast(uint64_t *chance, touch *out)
{
    double sign = chance_below(chance, 2) ? 1.0 : -1.0, rate = sign * (1.0 - any_size(chance, -5.0, -0.1));
    touch_draw_at(chance, 1, rate, sign * (1.0 - any_size(chance, -5.0, -0.1)), out);
}

/* Discs that are there all the time, and a rider who does not end inside the other for another reason. */
static int touch_is_sound(const touch *t)
{
    double smallest = fmin(t->disc.radius + t->disc.rate * t->ride.start, t->disc.radius + t->disc.rate * t->ride.end);
    double other = fmin(t->other.radius + t->other.rate * t->ride.start, t->other.radius + t->other.rate * t->ride.end);
    return smallest > 1e-3 && other > 1e-3 && t->ride.end > t->ride.start && (t->ride.end <= t->met || ride_clear(&t->ride, &t->other, t->ride.end) > 1e-6);
}

static void a_touch_is_found_at_the_begin_of_a_ride_at_its_end_and_between(void **state)
{
    (void)state;
    uint64_t chance = 2;
    int found[3] = {0, 0, 0};
    for (int k = 0; k < 20000; ++k) {
        touch t;
        double time = NAN;
        touch_draw(&chance, 1, &t);
        if (!touch_is_sound(&t)) continue;
        assert_int_equal(ride_touch(&t.ride, &t.other, &time), 1);
        assert_true(time >= t.ride.start && time <= t.ride.end);
        assert_near(time, t.met, 1e-11 * (1.0 + t.ride.end - t.ride.start));
        ++found[t.ride.start == t.met ? 0 : t.ride.end == t.met ? 1 : 2];
    }
    assert_true(found[0] > 1000 && found[1] > 1000 && found[2] > 1000);
}

static void a_touch_just_before_a_ride_or_just_after_it_is_none(void **state)
{
    (void)state;
    uint64_t chance = 3;
    int tried = 0;
    for (int k = 0; k < 5000; ++k) {
        touch t;
        double time;
        touch_draw(&chance, 1, &t);
        if (!touch_is_sound(&t) || (t.ride.start < t.met && t.ride.end > t.met)) continue;
        double beside = 1e-7 * (t.ride.end - t.ride.start), from = t.ride.start == t.met ? beside : t.ride.start, to = t.ride.end == t.met ? -beside : t.ride.end;
        geom_ride ride = {&t.disc, t.ride.side, ride_angle(&t.ride, from), from, to};
        assert_int_equal(ride_touch(&ride, &t.other, &time), 0);
        ++tried;
    }
    assert_true(tried > 1000);
}

/* Among discs that stand the gap is closed all the time: only where the rider is decides. */
static void a_touch_of_standing_discs_is_one_of_the_ride_that_passes_it(void **state)
{
    (void)state;
    const struct {
        double from, to; /* normals, of a touch at 0 */
        int touches;
    } rides[] = {{-0.3, 0.3, 1}, {-0.3, 0.0, 1}, {0.0, 0.3, 1}, {-0.3, -1e-7, 0}, {1e-7, 0.3, 0}};
    geom_disc disc = disc_make(point_make(0.0, 0.0), 1.0, 0.0), other = disc_make(point_make(1.5, 0.0), 0.5, 0.0);
    for (size_t i = 0; i < sizeof rides / sizeof *rides; ++i)
        for (int side = -1; side <= 1; side += 2) {
            double time;
            geom_ride ride = {&disc, side, side * rides[i].from, rides[i].from, rides[i].to};
            assert_int_equal(ride_touch(&ride, &other, &time), rides[i].touches);
        }
}

/* How fast the rider approaches the other disc's boundary, times the distance. */
static double approach(const geom_ride *ride, const geom_disc *other, double time)
{
    tdsp_point offset = point_sub(ride_position(ride, time), other->center), heading = point_unit(disc_heading(ride->disc, ride->side, ride_angle(ride, time)));
    return point_dot(offset, heading) - disc_radius(other, time) * other->rate;
}

/* Among discs nearly as fast as the robot, where a touch takes long: it is told to the digits that the rider's place has. */
static void a_touch_is_told_where_the_rider_is_nearest(void **state)
{
    (void)state;
    uint64_t chance = 5;
    int told = 0;
    for (int k = 0; k < 20000; ++k) {
        touch t;
        double time;
        touch_draw_fast(&chance, &t);
        if (!touch_is_sound(&t) || !ride_touch(&t.ride, &t.other, &time) || time == t.ride.start || time == t.ride.end) continue;
        assert_near(approach(&t.ride, &t.other, time), 0.0, 1e-14 * (t.disc.radius + t.other.radius));
        ++told;
    }
    assert_true(told > 1000);
}

/* Both discs are to the same side of the rider there: nobody changes over. */
static void a_disc_inside_the_one_ridden_that_reaches_its_boundary_is_not_touched(void **state)
{
    (void)state;
    uint64_t chance = 4;
    int tried = 0;
    for (int k = 0; k < 20000; ++k) {
        touch t;
        double time;
        touch_draw(&chance, 0, &t);
        if (!touch_is_sound(&t)) continue;
        assert_int_equal(ride_touch(&t.ride, &t.other, &time), 0);
        ++tried;
    }
    assert_true(tried > 1000);
}

/* ------------------------------------------------------------------------------------------------------ who begins inside */

/* On a disc of radius 1 that stands, half a unit of 1e-12 inside of one of radius 0.1, whose outward normal is so far from the heading. */
static double contact_from_inside(double from_heading)
{
    geom_disc disc = disc_make(point_make(0.0, 0.0), 1.0, 0.0), other = disc_make(point_make(0.0, 0.0), 0.1, 0.0);
    geom_ride ride = {&disc, 1, 0.0, 0.0, 0.5};
    other.center = point_along(point_make(1.0, 0.0), -(other.radius - 0.5e-12), point_unit(0.5 * GEOM_PI + from_heading));
    return ride_contact(&ride, &other);
}

static void who_begins_inside_by_a_touch_may_move_out_or_along_but_not_in(void **state)
{
    (void)state;
    for (int side = -1; side <= 1; side += 2) {
        assert_true(isinf(contact_from_inside(side * 0.25 * GEOM_PI)));
        assert_true(isinf(contact_from_inside(side * 0.5 * GEOM_PI)));
        assert_true(isinf(contact_from_inside(side * (0.5 * GEOM_PI + 1e-7))));
        assert_exact(contact_from_inside(side * 0.75 * GEOM_PI), 0.0);
    }
}

/* --------------------------------------------------------------------------------------------------------------- lines */

/* A robot nearly as fast as the boundary before it, which it does not reach: what is in by less than a touch of such sizes is a touch to the end, where the disc is small. */
/* On a pebble that grows: the least time looked at is many turns there, so that no bound decides it, and where the rider is at its end does. */
static void a_ride_on_a_pebble_counts_by_where_it_is_after_the_least_time_looked_at(void **state)
{
    (void)state;
    const double least = 0x1p-30, gap = 3e-10;
    int stopped = 0, free = 0;
    for (int k = 0; k < 800; ++k) {
        geom_disc pebble = disc_make(point_make(0.0, 0.0), 1e-12, k < 400 ? 0.5 : 0.999), other = disc_make(point_make(1.0 + gap, 0.0), 1.0, 0.0);
        geom_ride ride = {&pebble, k % 2 ? 1 : -1, k * (GEOM_TURN / 400.0), 0.0, 1.0};
        double first = ride_contact(&ride, &other), nearest = INFINITY;
        for (double time = least; time <= 1.0; time *= 1.01) nearest = fmin(nearest, ride_clear(&ride, &other, time));
        if (ride_clear(&ride, &other, least) < -0.5 * gap) {
            assert_true(first <= least);
            ++stopped;
        } else if (nearest > 0.5 * gap) {
            assert_true(isinf(first));
            ++free;
        }
    }
    assert_true(stopped > 20 && free > 20);
}

static void a_line_is_judged_where_it_is_deepest_in_space_and_time(void **state)
{
    (void)state;
    const geom_disc disc = disc_make(point_make(0.0, 0.0), 1.0, -(1.0 - 1e-12));
    const geom_line line = {point_make(1.0 - 2e-13, 0.0), point_make(-1.0, 0.0), 0.0, 0.99};
    assert_false(line_blocked(&line, &disc));
}

/* The boundary follows so closely that what was deep for a disc that small is a touch once it has grown. */
static void a_line_that_begins_inside_is_stopped_there_whatever_comes_later(void **state)
{
    (void)state;
    const geom_disc disc = disc_make(point_make(0.0, 0.0), 0.001, 1.0 - 1e-12);
    const geom_line line = {point_make(0.001 - 1e-14, 0.0), point_make(1.0, 0.0), 0.0, 1.0};
    assert_exact(line_first_contact(&line, &disc), 0.0);
}

/* Standing, growing and shrinking discs ahead, the fastest faster than the robot. */
static void a_line_from_outside_meets_a_disc_where_their_boundaries_meet(void **state)
{
    (void)state;
    const double rates[] = {0.0, 0.25, -0.25, 1.0, 3.0};
    for (size_t i = 0; i < 5; ++i) {
        const geom_disc disc = disc_make(point_make(5.0, 0.0), 2.0, rates[i]);
        const geom_line line = {point_make(0.0, 0.0), point_make(1.0, 0.0), 0.0, 8.0};
        assert_true(line_blocked(&line, &disc));
        assert_near(line_first_contact(&line, &disc), 3.0 / (1.0 + rates[i]), 1e-11);
    }
}

/* --------------------------------------------------------------------------------------------------------------- discs */

static void a_disc_that_has_shrunk_to_nothing_stays_nothing(void **state)
{
    (void)state;
    const geom_disc disc = disc_make(point_make(0.0, 0.0), 1.0, -0.5);
    assert_exact(disc_radius(&disc, 1.0), 0.5);
    assert_exact(disc_radius(&disc, 2.0), 0.0);
    assert_exact(disc_radius(&disc, 3.0), 0.0);
}

static void a_boundary_as_fast_as_the_robot_or_faster_runs_along_its_normal(void **state)
{
    (void)state;
    const double rates[] = {1.0, 1.5, INFINITY};
    for (size_t i = 0; i < 3; ++i) {
        const geom_disc grows = disc_make(point_make(0.0, 0.0), 1.0, rates[i]), shrinks = disc_make(point_make(0.0, 0.0), 1.0, -rates[i]);
        assert_exact(grows.sine, 0.0);
        assert_exact(grows.theta, 0.0);
        assert_exact(shrinks.sine, 0.0);
        assert_near(shrinks.theta, GEOM_PI, 1e-15);
        assert_false(disc_ridable(&grows));
    }
}

static void a_touch_is_a_share_of_the_sizes_and_of_great_ones_so_much_of_a_journey(void **state)
{
    (void)state;
    const tdsp_point origin = {0.0, 0.0}, far = {-3.0, 4.0};
    assert_near(tolerance_touch(origin, 1.0), 1e-12 + 4e-15, 1e-27);
    assert_near(tolerance_touch(origin, 1e6), 5e-10 + 2e-8 + 4e-15, 1e-23);
    assert_near(tolerance_touch(far, 1.0), 1e-12 + 8 * 4e-15, 1e-27);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_ride_ends_where_its_pieces_do_however_much_the_disc_grows_or_shrinks),
        cmocka_unit_test(a_contact_after_the_radius_shrank_is_not_missed),
        cmocka_unit_test(a_touch_is_found_at_the_begin_of_a_ride_at_its_end_and_between),
        cmocka_unit_test(a_touch_just_before_a_ride_or_just_after_it_is_none),
        cmocka_unit_test(a_touch_of_standing_discs_is_one_of_the_ride_that_passes_it),
        cmocka_unit_test(a_touch_is_told_where_the_rider_is_nearest),
        cmocka_unit_test(a_disc_inside_the_one_ridden_that_reaches_its_boundary_is_not_touched),
        cmocka_unit_test(who_begins_inside_by_a_touch_may_move_out_or_along_but_not_in),
        cmocka_unit_test(a_ride_on_a_pebble_counts_by_where_it_is_after_the_least_time_looked_at),
        cmocka_unit_test(a_line_is_judged_where_it_is_deepest_in_space_and_time),
        cmocka_unit_test(a_line_that_begins_inside_is_stopped_there_whatever_comes_later),
        cmocka_unit_test(a_line_from_outside_meets_a_disc_where_their_boundaries_meet),
        cmocka_unit_test(a_disc_that_has_shrunk_to_nothing_stays_nothing),
        cmocka_unit_test(a_boundary_as_fast_as_the_robot_or_faster_runs_along_its_normal),
        cmocka_unit_test(a_touch_is_a_share_of_the_sizes_and_of_great_ones_so_much_of_a_journey),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
