/* SPDX-License-Identifier: MIT */
/* Cheap angles against the C library's: the stated errors, everywhere. */
#include "support/cmocka_all.h"

#include "geom/angle.h"
#include "support/chance.h"

#define ATAN_ERROR 2e-6
#define ASIN_ERROR 5e-5

static void a_cheap_bearing_is_within_its_error_all_round(void **state)
{
    (void)state;
    for (int k = 0; k <= 400000; ++k) {
        double angle = GEOM_PI * (k / 200000.0 - 1.0), length = ldexp(1.0, k % 41 - 20);
        double y = length * sin(angle), x = length * cos(angle);
        assert_near(angle_near(y, x), atan2(y, x), ATAN_ERROR);
    }
}

static void a_bearing_along_an_axis_or_a_diagonal_is_within_its_error(void **state)
{
    (void)state;
    for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x)
            if (x || y) assert_near(angle_near(y, x), atan2(y, x), ATAN_ERROR);
    assert_near(angle_near(0.0, 0.0), 0.0, ATAN_ERROR);
    assert_near(fabs(angle_near(-0.0, -1.0)), GEOM_PI, ATAN_ERROR);
}

static void a_cheap_arc_sine_is_within_its_error_up_to_its_ends(void **state)
{
    (void)state;
    for (int k = -500000; k <= 500000; ++k) assert_near(asin_near(k / 500000.0), asin(k / 500000.0), ASIN_ERROR);
    for (int k = 1; k < 60; ++k) {
        double beside = 1.0 - ldexp(1.0, -k);
        assert_near(asin_near(beside), asin(beside), ASIN_ERROR);
        assert_near(asin_near(-beside), asin(-beside), ASIN_ERROR);
    }
}

static void beyond_its_ends_an_arc_sine_is_a_right_angle(void **state)
{
    (void)state;
    const double over[] = {1.0, 1.0 + 1e-15, 1.5, 1e6, 1e300, INFINITY};
    for (size_t i = 0; i < sizeof over / sizeof *over; ++i) {
        assert_exact(asin_near(over[i]), 0.5 * GEOM_PI);
        assert_exact(asin_near(-over[i]), -0.5 * GEOM_PI);
    }
}

static void no_cheap_angle_is_farther_off_than_all_are_said_to_be(void **state)
{
    (void)state;
    assert_true(ATAN_ERROR + ASIN_ERROR < GEOM_ANGLE_NEAR);
    /* Single precision keeps a bearing within the same bound. */
    uint64_t chance = 1;
    for (int k = 0; k < 100000; ++k) {
        double y = chance_between(&chance, -1.0, 1.0), x = chance_between(&chance, -1.0, 1.0);
        assert_near((float)angle_near(y, x), atan2(y, x), GEOM_ANGLE_NEAR);
    }
}

static void an_angle_within_three_half_turns_is_wrapped_into_one(void **state)
{
    (void)state;
    for (int k = -30000; k <= 30000; ++k) {
        double angle = 3.0 * GEOM_PI * k / 30000.0, wrapped = angle_wrap(angle);
        assert_true(wrapped >= -GEOM_PI && wrapped <= GEOM_PI);
        assert_near(cos(wrapped), cos(angle), 1e-12);
        assert_near(sin(wrapped), sin(angle), 1e-12);
    }
    assert_exact(angle_wrap(GEOM_PI), GEOM_PI);
    assert_exact(angle_wrap(-GEOM_PI), -GEOM_PI);
}

/* Also a multiple of a whole turn that rounding takes for the one before or behind, and what is so little below 0 that a whole turn more is a whole turn. */
static void an_angle_made_positive_is_below_a_whole_turn(void **state)
{
    (void)state;
    for (int k = -30000; k <= 30000; ++k) {
        double angle = 50.0 * GEOM_TURN * k / 30000.0, positive = angle_positive(angle);
        assert_true(positive >= 0.0 && positive < GEOM_TURN);
        assert_near(cos(positive), cos(angle), 1e-12);
        assert_near(sin(positive), sin(angle), 1e-12);
    }
    assert_exact(angle_positive(-1e-17), 0.0);
    assert_exact(angle_positive(GEOM_TURN), 0.0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_cheap_bearing_is_within_its_error_all_round),
        cmocka_unit_test(a_bearing_along_an_axis_or_a_diagonal_is_within_its_error),
        cmocka_unit_test(a_cheap_arc_sine_is_within_its_error_up_to_its_ends),
        cmocka_unit_test(beyond_its_ends_an_arc_sine_is_a_right_angle),
        cmocka_unit_test(no_cheap_angle_is_farther_off_than_all_are_said_to_be),
        cmocka_unit_test(an_angle_within_three_half_turns_is_wrapped_into_one),
        cmocka_unit_test(an_angle_made_positive_is_below_a_whole_turn),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
