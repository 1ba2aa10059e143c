/* SPDX-License-Identifier: MIT */
/* Positions along a path. */
#include "support/cmocka_all.h"

#include <float.h>

#include "support/chance.h"
#include "support/curve.h"
#include "tdsp/path.h"

#define PI 3.14159265358979323846

static tdsp_leg line(double t0, double t1, tdsp_point from, tdsp_point to)
{
    tdsp_leg leg = {.kind = TDSP_LEG_LINE, .disc = TDSP_NO_DISC, .start_time = t0, .end_time = t1, .from = from, .to = to};
    return leg;
}

static tdsp_point polar(tdsp_point center, double r, double angle)
{
    tdsp_point p = {center.x + r * cos(angle), center.y + r * sin(angle)};
    return p;
}

/* An arc whose ends fit its centre, radii and angles. */
static tdsp_leg arc(double t0, double t1, tdsp_point center, double r0, double r1, double angle, int turn, double sweep)
{
    tdsp_leg leg = {.kind = TDSP_LEG_ARC,
                    .disc = 2,
                    .turn = turn,
                    .start_time = t0,
                    .end_time = t1,
                    .center = center,
                    .radius_from = r0,
                    .radius_to = r1,
                    .angle_from = angle,
                    .sweep = sweep};
    leg.from = polar(center, r0, angle);
    leg.to = polar(center, r1, angle + turn * sweep);
    return leg;
}

static void assert_place(tdsp_point actual, tdsp_point expected, double tolerance)
{
    assert_near(actual.x, expected.x, tolerance);
    assert_near(actual.y, expected.y, tolerance);
}

static void assert_same_place(tdsp_point actual, tdsp_point expected)
{
    assert_exact(actual.x, expected.x);
    assert_exact(actual.y, expected.y);
}

/* The last but one grows at one rate, the last not at all. */
static const curve_law laws[] = {
    {{1, 0.1, 0.02}}, {{0.8, 0, 0.1, -0.01}}, {{2, 0.3, -0.05, 0.02, 0.002}}, {{1, 0.25}}, {{1.5, 0}}};
enum { LAWS = sizeof laws / sizeof laws[0] };

static void both_ends_of_a_leg_are_exact_and_hold_outside_it(void **state)
{
    (void)state;
    tdsp_leg legs[] = {line(0.1, 0.7, (tdsp_point){0.3, -0.1}, (tdsp_point){1.1, 1e9}),
                       arc(0.1, 0.7, (tdsp_point){1, 2}, 0.3, 0.7, 0.123, -1, 2.5),
                       curve_leg(&laws[0], (tdsp_point){1, 2}, 1.5, 0.1, 0.7, 0.123, -1)};
    for (size_t i = 0; i < 3; i++) {
        assert_same_place(tdsp_leg_position(&legs[i], 0.1), legs[i].from);
        assert_same_place(tdsp_leg_position(&legs[i], 0.7), legs[i].to);
        assert_same_place(tdsp_leg_position(&legs[i], -5), legs[i].from);
        assert_same_place(tdsp_leg_position(&legs[i], 5), legs[i].to);
    }
}

static void a_line_is_uniform_motion(void **state)
{
    (void)state;
    tdsp_leg leg = line(2, 6, (tdsp_point){-4, 1}, (tdsp_point){4, 3});
    assert_same_place(tdsp_leg_position(&leg, 3), (tdsp_point){-2, 1.5});
    assert_same_place(tdsp_leg_position(&leg, 4), (tdsp_point){0, 2});
}

static void a_line_between_the_ends_of_the_range_does_not_overflow(void **state)
{
    (void)state;
    tdsp_leg leg = line(0, 1, (tdsp_point){-DBL_MAX, 0}, (tdsp_point){DBL_MAX, 0});
    assert_same_place(tdsp_leg_position(&leg, 0.5), (tdsp_point){0, 0});
}

static void a_spiral_keeps_the_angle_between_its_motion_and_the_radius(void **state)
{
    (void)state;
    double speed = 1.5, growth = 0.4, r0 = 0.5, t1 = 2.5;
    double r1 = r0 + growth * t1;
    double side = sqrt(speed * speed - growth * growth);
    tdsp_leg leg = arc(0, t1, (tdsp_point){-3, 7}, r0, r1, 1, 1, side / growth * log(r1 / r0));
    for (double t = 0.01; t < t1 - 0.01; t += 0.07) {
        double h = 1e-5;
        tdsp_point a = tdsp_leg_position(&leg, t - h);
        tdsp_point b = tdsp_leg_position(&leg, t + h);
        tdsp_point at = tdsp_leg_position(&leg, t);
        assert_near(hypot(b.x - a.x, b.y - a.y) / (2 * h), speed, 1e-8);
        assert_near(hypot(at.x + 3, at.y - 7), r0 + growth * t, 1e-14);
    }
}

static void a_circle_turns_uniformly_in_either_direction(void **state)
{
    (void)state;
    for (int turn = -1; turn <= 1; turn += 2) {
        tdsp_leg leg = arc(0, 4, (tdsp_point){1, 1}, 2, 2, PI / 6, turn, PI);
        assert_place(tdsp_leg_position(&leg, 1), polar(leg.center, 2, PI / 6 + turn * PI / 4), 1e-15);
        assert_place(tdsp_leg_position(&leg, 2), polar(leg.center, 2, PI / 6 + turn * PI / 2), 1e-15);
    }
}

/* The angle's share is x (1 + g (1 - x) / 2 - ...): the reference by long double logarithms. */
static void nearly_equal_radii_lose_no_accuracy(void **state)
{
    (void)state;
    for (int exponent = -320; exponent <= -2; exponent++) {
        double g = pow(10, exponent);
        double r1 = 1 + g;
        g = r1 - 1;
        tdsp_leg leg = arc(0, 1, (tdsp_point){0, 0}, 1, r1, 0, 1, 3);
        for (double x = 0.125; x < 1; x += 0.125) {
            long double share = g == 0 ? (long double)x : log1pl((long double)g * x) / log1pl((long double)g);
            assert_place(tdsp_leg_position(&leg, x), polar(leg.center, 1 + g * x, (double)(3 * share)), 4e-15);
        }
    }
}

static void no_valid_arc_gives_a_position_that_is_not_a_number(void **state)
{
    (void)state;
    const double radii[] = {4.9406564584124654e-324, 1e-310,   DBL_MIN,    1e-200, 1e-8,  1,
                            1 + DBL_EPSILON,         1 + 1e-8, 1 + 1.1e-8, 2,      1e150, 1e300};
    const size_t count = sizeof radii / sizeof radii[0];
    for (size_t i = 0; i < count; i++) {
        for (size_t j = 0; j < count; j++) {
            tdsp_leg leg = arc(0, 1, (tdsp_point){0, 0}, radii[i], radii[j], 0, 1, 1);
            for (double x = 0; x <= 1; x += 1.0 / 64) {
                tdsp_point p = tdsp_leg_position(&leg, x);
                assert_true(isfinite(p.x) && isfinite(p.y));
            }
        }
    }
}

/* From a denormal radius to a large one the ratio of the radii overflows, their logarithms do not. */
static void radii_whose_ratio_overflows_lose_no_accuracy(void **state)
{
    (void)state;
    double r0 = 1e-320, r1 = 1e10;
    tdsp_leg leg = arc(0, 1, (tdsp_point){0, 0}, r0, r1, 0, 1, 3);
    for (double x = 0.125; x < 1; x += 0.125) {
        double r = r1 * x;
        double share = (log(r) - log(r0)) / (log(r1) - log(r0));
        assert_place(tdsp_leg_position(&leg, x), polar(leg.center, r, 3 * share), 1e-14 * r1);
    }
}

/* The greatest distance between a curve and the ride that it stands for. */
static double curve_error(const curve_law *law, double start, double end, int turn)
{
    const tdsp_point center = {3, -1};
    tdsp_leg leg = curve_leg(law, center, 1.5, start, end, 1, turn);
    double worst = 0;
    for (int i = 1; i < 16; i++) {
        double t = start + (end - start) * i / 16;
        tdsp_point at = tdsp_leg_position(&leg, t),
                   truth = curve_law_place(law, center, t, 1 + turn * curve_law_turned(law, 1.5, start, t));
        worst = fmax(worst, hypot(at.x - truth.x, at.y - truth.y));
    }
    return worst;
}

static void a_short_curve_is_the_ride_on_a_disc_whose_rate_changes(void **state)
{
    (void)state;
    for (int turn = -1; turn <= 1; turn += 2)
        for (size_t i = 0; i < LAWS; i++)
            for (double t = 0; t < 3; t += 0.25) assert_true(curve_error(&laws[i], t, t + 0.01, turn) < 4e-15);
}

static void a_curve_of_half_the_length_is_64_times_as_close(void **state)
{
    (void)state;
    for (size_t i = 0; i < LAWS - 1; i++) {
        double coarse = curve_error(&laws[i], 0.5, 0.9, 1), fine = curve_error(&laws[i], 0.6, 0.8, 1);
        assert_true(coarse > 1e-11 && coarse < 1e-4);
        assert_true(fine < coarse / 40 && fine > coarse / 100);
    }
}

static void a_curve_on_a_disc_that_does_not_grow_is_a_circle(void **state)
{
    (void)state;
    tdsp_leg curve = curve_leg(&laws[LAWS - 1], (tdsp_point){1, 2}, 0.7, 1, 5, 0.3, 1);
    tdsp_leg circle = arc(1, 5, (tdsp_point){1, 2}, 1.5, 1.5, 0.3, 1, curve.sweep);
    for (double t = 1; t <= 5; t += 0.0625) assert_place(tdsp_leg_position(&curve, t), tdsp_leg_position(&circle, t), 1e-15);
}

/* Distance and angle turned of a curve, at a place that is less than half a turn from its start. */
static void curve_polar(const tdsp_leg *leg, double time, double *distance, double *turned)
{
    tdsp_point at = tdsp_leg_position(leg, time);
    double x = at.x - leg->center.x, y = at.y - leg->center.y;
    *distance = hypot(x, y);
    *turned = leg->turn * remainder(atan2(y, x) - leg->angle_from, 2 * PI);
}

/* One-sided differences, off by f5 h^4 / 5 and f5 h^3 5 / 6: the fifth derivatives of the curves below are some thousands, the step is 2^-9. */
static double slope_at(const double f[5], double h)
{
    return (-25 * f[0] + 48 * f[1] - 36 * f[2] + 16 * f[3] - 3 * f[4]) / (12 * h);
}

static double bend_at(const double f[5], double h)
{
    return (35 * f[0] - 104 * f[1] + 114 * f[2] - 56 * f[3] + 11 * f[4]) / (12 * h * h);
}

static void assert_end(const tdsp_leg *leg, double time, double h, double radius, double rate, double bend)
{
    double w = sqrt(leg->speed * leg->speed - rate * rate) / radius;
    double spin = -rate * bend / (w * radius * radius) - rate * w / radius;
    double distance[5], turned[5];
    for (int i = 0; i < 5; i++) curve_polar(leg, time + i * h, &distance[i], &turned[i]);
    assert_near(slope_at(distance, h), rate, 1e-8);
    assert_near(bend_at(distance, h), bend, 2e-5);
    assert_near(slope_at(turned, h), w, 1e-8);
    assert_near(bend_at(turned, h), spin, 2e-5);
}

static void a_curve_has_the_given_values_and_derivatives_at_both_ends(void **state)
{
    (void)state;
    uint64_t chance = 5;
    for (int i = 0; i < 100; i++) {
        tdsp_leg leg = {
            .kind = TDSP_LEG_CURVE, .turn = i % 2 ? 1 : -1, .start_time = 2, .end_time = 3, .center = {5, 6}, .speed = 1.2};
        leg.radius_from = chance_between(&chance, 1, 2);
        leg.radius_to = chance_between(&chance, 1, 2);
        leg.angle_from = chance_between(&chance, -3, 3);
        leg.sweep = chance_between(&chance, 0.5, 1);
        leg.rate_from = chance_between(&chance, -0.5, 1.1);
        leg.rate_to = chance_between(&chance, -0.5, 1.1);
        leg.bend_from = chance_between(&chance, -1, 1);
        leg.bend_to = chance_between(&chance, -1, 1);
        leg.from = polar(leg.center, leg.radius_from, leg.angle_from);
        leg.to = polar(leg.center, leg.radius_to, leg.angle_from + leg.turn * leg.sweep);
        assert_end(&leg, 2, 0x1p-9, leg.radius_from, leg.rate_from, leg.bend_from);
        assert_end(&leg, 3, -0x1p-9, leg.radius_to, leg.rate_to, leg.bend_to);
    }
}

static void a_leg_without_duration_has_two_places(void **state)
{
    (void)state;
    tdsp_leg leg = line(1, 1, (tdsp_point){0, 0}, (tdsp_point){1e-17, 0});
    assert_same_place(tdsp_leg_position(&leg, 1), leg.from);
    assert_same_place(tdsp_leg_position(&leg, nextafter(1, 2)), leg.to);
}

static void a_shifted_leg_is_at_the_same_place_later(void **state)
{
    (void)state;
    tdsp_leg leg = arc(1, 3, (tdsp_point){0, 1}, 1, 2, 0, 1, 1);
    tdsp_leg late = tdsp_leg_shifted(&leg, 8);
    assert_exact(late.start_time, 9.0);
    assert_exact(late.end_time, 11.0);
    for (double t = 1; t <= 3; t += 0.125) assert_same_place(tdsp_leg_position(&late, t + 8), tdsp_leg_position(&leg, t));
    leg = curve_leg(&laws[1], (tdsp_point){0, 1}, 1.5, 1, 3, 0, 1);
    late = tdsp_leg_shifted(&leg, 8);
    for (double t = 1; t <= 3; t += 0.125) assert_same_place(tdsp_leg_position(&late, t + 8), tdsp_leg_position(&leg, t));
}

/* A chain of random lines and arcs, each starting where the one before ends. */
static size_t random_path(uint64_t *chance, tdsp_leg *legs, size_t count)
{
    double time = chance_between(chance, 0, 10);
    tdsp_point at = {chance_between(chance, -5, 5), chance_between(chance, -5, 5)};
    for (size_t i = 0; i < count; i++) {
        double end = chance_below(chance, 8) ? time + chance_between(chance, 0, 2) : time;
        if (chance_below(chance, 2) && end > time) {
            double angle = chance_between(chance, -3, 3), r0 = chance_between(chance, 0.1, 2);
            tdsp_point center = {at.x - r0 * cos(angle), at.y - r0 * sin(angle)};
            legs[i] = arc(time, end, center, r0, r0 + chance_between(chance, 0, 1), angle, chance_below(chance, 2) ? 1 : -1,
                          chance_between(chance, 0, 3));
            legs[i].from = at;
        } else {
            tdsp_point to = {at.x + (end - time) * chance_between(chance, -2, 2), at.y};
            legs[i] = line(time, end, at, to);
        }
        at = legs[i].to;
        time = end;
    }
    return count;
}

static void positions_along_a_path_are_those_of_its_legs_and_continuous(void **state)
{
    (void)state;
    uint64_t chance = 3;
    tdsp_leg legs[40];
    for (int round = 0; round < 300; round++) {
        size_t count = random_path(&chance, legs, 1 + chance_below(&chance, 40));
        double start = legs[0].start_time, end = legs[count - 1].end_time, step = (end - start) / 1000 + 1e-9;
        tdsp_point before = legs[0].from;
        for (double t = start - 5 * step; t < end + 5 * step; t += step) {
            tdsp_point at;
            assert_int_equal(tdsp_path_position(legs, count, t, &at), TDSP_OK);
            assert_true(hypot(at.x - before.x, at.y - before.y) < 1000 * step);
            before = at;
            for (size_t i = 0; i < count; i++) {
                if (t > legs[i].start_time && t < legs[i].end_time) assert_same_place(at, tdsp_leg_position(&legs[i], t));
            }
        }
        assert_place(before, legs[count - 1].to, 0);
    }
}

static void a_joint_of_two_legs_is_where_the_second_starts(void **state)
{
    (void)state;
    tdsp_leg legs[] = {line(0, 1, (tdsp_point){0, 0}, (tdsp_point){1, 0}), line(1, 2, (tdsp_point){1, 0}, (tdsp_point){1, 1})};
    tdsp_point at;
    assert_int_equal(tdsp_path_position(legs, 2, 1, &at), TDSP_OK);
    assert_same_place(at, (tdsp_point){1, 0});
}

static void a_path_without_legs_or_a_time_that_is_not_finite_is_refused(void **state)
{
    (void)state;
    tdsp_leg leg = line(0, 1, (tdsp_point){0, 0}, (tdsp_point){1, 0});
    tdsp_point at = {7, 7};
    assert_int_equal(tdsp_path_position(NULL, 1, 0, &at), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_path_position(&leg, 0, 0, &at), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_path_position(&leg, 1, NAN, &at), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_path_position(&leg, 1, INFINITY, &at), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_path_position(&leg, 1, 0, NULL), TDSP_INVALID_ARGUMENT);
    assert_same_place(at, (tdsp_point){7, 7});
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(both_ends_of_a_leg_are_exact_and_hold_outside_it),
        cmocka_unit_test(a_line_is_uniform_motion),
        cmocka_unit_test(a_line_between_the_ends_of_the_range_does_not_overflow),
        cmocka_unit_test(a_spiral_keeps_the_angle_between_its_motion_and_the_radius),
        cmocka_unit_test(a_circle_turns_uniformly_in_either_direction),
        cmocka_unit_test(nearly_equal_radii_lose_no_accuracy),
        cmocka_unit_test(no_valid_arc_gives_a_position_that_is_not_a_number),
        cmocka_unit_test(radii_whose_ratio_overflows_lose_no_accuracy),
        cmocka_unit_test(a_short_curve_is_the_ride_on_a_disc_whose_rate_changes),
        cmocka_unit_test(a_curve_of_half_the_length_is_64_times_as_close),
        cmocka_unit_test(a_curve_on_a_disc_that_does_not_grow_is_a_circle),
        cmocka_unit_test(a_curve_has_the_given_values_and_derivatives_at_both_ends),
        cmocka_unit_test(a_leg_without_duration_has_two_places),
        cmocka_unit_test(a_shifted_leg_is_at_the_same_place_later),
        cmocka_unit_test(positions_along_a_path_are_those_of_its_legs_and_continuous),
        cmocka_unit_test(a_joint_of_two_legs_is_where_the_second_starts),
        cmocka_unit_test(a_path_without_legs_or_a_time_that_is_not_finite_is_refused),
    };
    return cmocka_run_group_tests_name("path", tests, NULL, NULL);
}
