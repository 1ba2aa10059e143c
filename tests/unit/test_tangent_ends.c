/* SPDX-License-Identifier: MIT */
/* Legs at the very ends of their time, and rides that leave at their very ends. */
#include "support/cmocka_all.h"

#include "geom/spiral.h"
#include "geom/tangent.h"
#include "support/chance.h"

/* Two discs anywhere, in either direction of time. */
static void discs_draw(uint64_t *chance, geom_disc *from, geom_disc *to)
{
    double sign = chance_below(chance, 2) ? 1.0 : -1.0, from_rate = chance_between(chance, 0.0, 0.97), to_rate = chance_below(chance, 4) ? chance_between(chance, 0.0, 0.97) : from_rate;
    double later = sign < 0.0 ? 2.0 : 0.0; /* so that both last for a while */
    *from = disc_make(point_make(0.5, -0.25), chance_between(chance, 0.2, 3.0) + later * from_rate, sign * from_rate);
    *to = disc_make(point_make(chance_between(chance, -4.0, 4.0), chance_between(chance, -4.0, 4.0)), chance_between(chance, 0.0, 3.0) + later * to_rate, sign * to_rate);
}

/* Two discs, and how long they are looked at: so long that legs come and go. */
static double discs_draw_for_long(uint64_t *chance, geom_disc *from, geom_disc *to)
{
    double sign = chance_below(chance, 2) ? 1.0 : -1.0, from_rate = chance_between(chance, 0.0, 0.97), to_rate = chance_between(chance, 0.0, 0.97);
    double until = sign < 0.0 ? 2.0 : 20.0, later = sign < 0.0 ? until : 0.0;
    *from = disc_make(point_make(0.5, -0.25), chance_between(chance, 0.01, 3.0) + later * from_rate, sign * from_rate);
    *to = disc_make(point_make(chance_between(chance, -4.0, 4.0), chance_between(chance, -4.0, 4.0)), chance_between(chance, 0.0, 3.0) + later * to_rate, sign * to_rate);
    return until;
}

static void a_leg_at_an_end_of_its_time_is_no_shorter_than_nothing(void **state)
{
    (void)state;
    uint64_t chance = 1;
    int ends_met = 0, vanishing = 0;
    for (int k = 0; k < 40000; ++k) {
        geom_disc from, to;
        discs_draw(&chance, &from, &to);
        geom_pair pair = pair_make(&from, &to);
        geom_tangent tangent = tangent_make(&pair, k % 2 ? 1 : -1, k % 4 < 2 ? 1 : -1, k % 8 < 4 ? 1 : -1);
        double ends[4];
        int pieces = tangent_domain(&tangent, 0.0, 2.0, ends);
        for (int i = 0; i < 2 * pieces; ++i) {
            double length = tangent_length(&tangent, ends[i]);
            assert_true(length >= 0.0);
            assert_true(ends[i] >= 0.0 && ends[i] <= 2.0);
            ++ends_met;
            vanishing += length == 0.0;
        }
        for (int i = 0; i + 1 < 2 * pieces; ++i) assert_true(ends[i] <= ends[i + 1]);
    }
    assert_true(ends_met > 20000 && vanishing > 1000);
}

static void sides_alike_at_one_rate_keep_their_heading_to_the_bit(void **state)
{
    (void)state;
    uint64_t chance = 2;
    for (int k = 0; k < 1000; ++k) {
        double rate = chance_between(&chance, 0.01, 0.97);
        geom_disc from = disc_make(point_make(0.0, 0.0), chance_between(&chance, 0.1, 1.0), rate), to = disc_make(point_make(5.0, 1.0), chance_between(&chance, 0.1, 1.0), rate);
        geom_pair pair = pair_make(&from, &to);
        geom_tangent tangent = tangent_make(&pair, k % 2 ? 1 : -1, k % 2 ? 1 : -1, 1);
        assert_exact(tangent_heading(&tangent, 1e6), tangent_heading(&tangent, 0.0));
        assert_exact(tangent_length(&tangent, 1e6), tangent_length(&tangent, 0.0));
    }
}

/* A ride of no duration, or one that only begins where the leg ends to exist, at the departure point but for rounding. */
static void a_rider_who_is_there_leaves_even_if_he_rides_no_further(void **state)
{
    (void)state;
    uint64_t chance = 3;
    int left = 0;
    for (int k = 0; k < 20000; ++k) {
        geom_disc from, to;
        discs_draw(&chance, &from, &to);
        geom_pair pair = pair_make(&from, &to);
        int side = k % 2 ? 1 : -1;
        geom_tangent tangent = tangent_make(&pair, side, k % 4 < 2 ? 1 : -1, k % 8 < 4 ? 1 : -1);
        double ends[4], time = chance_between(&chance, 0.0, 2.0), leave = NAN;
        if (!tangent_domain(&tangent, time, time, ends) || tangent_length(&tangent, time) < 1e-3) continue;
        double angle = tangent_heading(&tangent, time) - side * from.theta + chance_between(&chance, -1e-14, 1e-14);
        assert_int_equal(tangent_leave(&tangent, angle, time, time, &leave), 1);
        assert_exact(leave, time);
        ++left;
    }
    assert_true(left > 3000);
}

/* A departure point that stands is met where the rider has turned to it, rounded as that is: also when the ride ends in that very moment. */
static void a_standing_departure_point_is_met_in_the_last_moment_of_a_ride(void **state)
{
    (void)state;
    uint64_t chance = 5;
    int met = 0;
    for (int k = 0; k < 2000; ++k) {
        double rate = chance_between(&chance, 0.0, 0.9), leave, last;
        geom_disc from = disc_make(point_make(0.0, 0.0), chance_between(&chance, 0.1, 1.0), rate), to = disc_make(point_make(5.0, 1.0), chance_between(&chance, 0.1, 1.0), rate);
        geom_pair pair = pair_make(&from, &to);
        geom_tangent tangent = tangent_make(&pair, k % 2 ? 1 : -1, k % 2 ? 1 : -1, 1);
        double angle = chance_between(&chance, -3.0, 3.0);
        if (!tangent_leave(&tangent, angle, 0.25, 40.0, &leave)) continue;
        assert_int_equal(tangent_leave(&tangent, angle, 0.25, leave, &last), 1);
        assert_exact(last, leave);
        ++met;
    }
    assert_true(met > 1000);
}

/* Legs of the second root exist before the gap opens and after it has closed again: whoever meets the departure point only then leaves then. */
static void a_departure_point_is_met_in_the_second_piece_of_its_time_too(void **state)
{
    (void)state;
    uint64_t chance = 6;
    int met = 0;
    for (int k = 0; k < 100000; ++k) {
        geom_disc from, to;
        double until = discs_draw_for_long(&chance, &from, &to);
        geom_pair pair = pair_make(&from, &to);
        int side = k % 2 ? 1 : -1;
        geom_tangent tangent = tangent_make(&pair, side, k % 4 < 2 ? 1 : -1, -1);
        double ends[4], leave = NAN;
        if (tangent_domain(&tangent, 0.0, until, ends) < 2 || ends[3] - ends[2] < 1e-3) continue;
        double time = chance_between(&chance, ends[2], ends[3]);
        double angle = tangent_heading(&tangent, time) - side * from.theta - side * spiral_angle(&from, 0.0, time);
        assert_int_equal(tangent_leave(&tangent, angle, 0.0, until, &leave), 1);
        assert_true(leave <= time + 1e-9);
        if (leave >= ends[2]) assert_near(leave, time, 1e-9);
        met += leave >= ends[2];
    }
    assert_true(met > 10);
}

/* The end that is far away, told from beside the near one: a root of the quadratic, of which the other formula would lose half the digits. */
static void the_end_of_a_legs_time_does_not_depend_on_when_one_asks(void **state)
{
    (void)state;
    uint64_t chance = 7;
    int compared = 0;
    for (int k = 0; k < 40000; ++k) {
        geom_disc from, to;
        double until = discs_draw_for_long(&chance, &from, &to);
        geom_pair pair = pair_make(&from, &to);
        geom_tangent tangent = tangent_make(&pair, k % 2 ? 1 : -1, k % 4 < 2 ? 1 : -1, 1);
        double ends[4], again[4];
        if (tangent_domain(&tangent, 0.0, until, ends) != 1 || ends[0] == 0.0 || ends[1] - ends[0] < 0.1 || ends[1] == until) continue;
        assert_int_equal(tangent_domain(&tangent, ends[0] + 1e-9, until, again), 1);
        assert_near(again[1], ends[1], 1e-12 * until);
        ++compared;
    }
    assert_true(compared > 100);
}

/* The squares of such rates are 0. */
static void legs_of_the_second_root_have_no_time_where_nothing_changes(void **state)
{
    (void)state;
    geom_disc from = disc_make(point_make(0.0, 0.0), 1.0, 0.0), to = disc_make(point_make(5.0, 1.0), 1.0, 1e-170);
    geom_pair pair = pair_make(&from, &to);
    for (int side = -1; side <= 1; side += 2) {
        double ends[4];
        geom_tangent tangent = tangent_make(&pair, side, side, -1);
        assert_true(tangent_possible(&tangent));
        assert_int_equal(tangent_domain(&tangent, 0.0, 2.0, ends), 0);
    }
}

/* A pebble inside of a large disc, on its boundary: where |K| = |D| the ride alone says where its leg leads, on along the boundary, nowhere, or behind it. */
static void a_leg_that_would_arrive_behind_its_rider_is_none(void **state)
{
    (void)state;
    const double pebble = 0x1p-20;
    geom_disc from = disc_make(point_make(0.0, 0.0), pebble, 0.0), to = disc_make(point_make(1.0, 0.0), 1.0 + pebble, 0.0);
    geom_pair pair = pair_make(&from, &to);
    for (int side = -1; side <= 1; side += 2) {
        geom_tangent tangent = tangent_make(&pair, side, side, 1);
        assert_near(tangent_leg(&tangent, -side * 0.5 * GEOM_PI, 0.0).length, 1.0, 1e-15);
        assert_near(tangent_leg(&tangent, 0.0, 0.0).length, 0.0, 1e-15);
        assert_exact(tangent_leg(&tangent, side * 1e-13, 0.0).length, 0.0);
        assert_exact(tangent_leg(&tangent, side * 1e-9, 0.0).length, TANGENT_NONE);
        assert_exact(tangent_leg(&tangent, side * 0.5 * GEOM_PI, 0.0).length, TANGENT_NONE);
    }
}

/* The moment of the leg between concentric discs counts only where the ride has it. */
static void concentric_discs_are_not_left_before_a_ride_or_after_it(void **state)
{
    (void)state;
    uint64_t chance = 4;
    int met = 0;
    for (int k = 0; k < 400; ++k) {
        geom_disc from = disc_make(point_make(1.0, 2.0), chance_between(&chance, 0.5, 2.0), chance_between(&chance, 0.0, 0.9));
        geom_disc to = disc_make(from.center, chance_between(&chance, 0.0, 1.0), chance_between(&chance, 0.0, 0.95));
        geom_pair pair = pair_make(&from, &to);
        geom_tangent tangent = tangent_make(&pair, k % 2 ? 1 : -1, k % 4 < 2 ? 1 : -1, 1);
        double leave, other;
        if (!tangent_leave(&tangent, 0.0, 0.0, 4.0, &leave)) continue;
        assert_true(leave >= 0.0 && leave <= 4.0);
        assert_int_equal(tangent_leave(&tangent, 0.0, 0.5 * leave, leave + 1.0, &other), 1);
        assert_near(other, leave, 1e-12);
        assert_int_equal(tangent_leave(&tangent, 0.0, leave + 1e-9, leave + 1.0, &other), 0);
        assert_int_equal(tangent_leave(&tangent, 0.0, 0.0, leave * (1.0 - 1e-9), &other), 0);
        ++met;
    }
    assert_true(met > 20);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_leg_at_an_end_of_its_time_is_no_shorter_than_nothing),
        cmocka_unit_test(sides_alike_at_one_rate_keep_their_heading_to_the_bit),
        cmocka_unit_test(a_rider_who_is_there_leaves_even_if_he_rides_no_further),
        cmocka_unit_test(a_standing_departure_point_is_met_in_the_last_moment_of_a_ride),
        cmocka_unit_test(a_departure_point_is_met_in_the_second_piece_of_its_time_too),
        cmocka_unit_test(the_end_of_a_legs_time_does_not_depend_on_when_one_asks),
        cmocka_unit_test(legs_of_the_second_root_have_no_time_where_nothing_changes),
        cmocka_unit_test(a_leg_that_would_arrive_behind_its_rider_is_none),
        cmocka_unit_test(concentric_discs_are_not_left_before_a_ride_or_after_it),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
