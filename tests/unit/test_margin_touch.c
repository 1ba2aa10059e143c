/* SPDX-License-Identifier: MIT */
/* The fastest disc that a leg stays clear of, against sampling and the verifier. */
#include "support/cmocka_all.h"

#include "margin/touch.h"
#include "support/chance.h"
#include "tdsp/path.h"

static tdsp_leg line(double t0, double t1, tdsp_point from, tdsp_point to)
{
    const tdsp_leg leg = {.kind = TDSP_LEG_LINE, .disc = TDSP_NO_DISC, .start_time = t0, .end_time = t1, .from = from, .to = to};
    return leg;
}

static tdsp_leg arc(double t0, double t1, tdsp_point center, double r0, double r1, double angle, int turn, double sweep)
{
    tdsp_leg leg = {.kind = TDSP_LEG_ARC, .disc = 0, .turn = turn, .start_time = t0, .end_time = t1, .center = center};
    leg.radius_from = r0;
    leg.radius_to = r1;
    leg.angle_from = angle;
    leg.sweep = sweep;
    leg.from = (tdsp_point){center.x + r0 * cos(angle), center.y + r0 * sin(angle)};
    leg.to = (tdsp_point){center.x + r1 * cos(angle + turn * sweep), center.y + r1 * sin(angle + turn * sweep)};
    return leg;
}

/* The least of many samples, made finer around the least. */
static double sampled(const tdsp_leg *leg, tdsp_point center, double radius)
{
    const int samples = 400;
    double low = leg->start_time, high = leg->end_time, least = INFINITY, best = low;
    for (int round = 0; round < 8; round++) {
        for (int i = 0; i <= samples; i++) {
            const double t = low + (high - low) * i / samples;
            const tdsp_point at = tdsp_leg_position(leg, t);
            const double rate = (hypot(at.x - center.x, at.y - center.y) - radius) / t;
            if (!(rate < least)) continue;
            least = rate;
            best = t;
        }
        const double step = 2.0 * (high - low) / samples;
        low = fmax(best - step, leg->start_time);
        high = fmin(best + step, leg->end_time);
    }
    return least;
}

static void check_leg(const tdsp_leg *leg, tdsp_point center, double radius)
{
    const way w = way_of(leg);
    const touch found = touch_of(&w, center, radius, 1e-13);
    const double expected = sampled(leg, center, radius);
    assert_true(found.time >= leg->start_time && found.time <= leg->end_time);
    assert_near(found.rate, expected, 1e-10 * (1.0 + fabs(expected)));
    assert_true(found.rate <= expected + 1e-12 * (1.0 + fabs(expected)));
}

static void random_lines_agree_with_sampling(void **state)
{
    (void)state;
    uint64_t chance = 11;
    for (int i = 0; i < 2000; i++) {
        const tdsp_point from = {chance_between(&chance, -5, 5), chance_between(&chance, -5, 5)};
        const tdsp_point to = {chance_between(&chance, -5, 5), chance_between(&chance, -5, 5)};
        const double start = i % 3 ? chance_between(&chance, 0.1, 20.0) : 1e-3, takes = chance_between(&chance, 0.1, 20.0);
        const tdsp_leg leg = line(start, start + takes, from, to);
        check_leg(&leg, (tdsp_point){chance_between(&chance, -5, 5), chance_between(&chance, -5, 5)},
                  i % 5 ? chance_between(&chance, 0, 4) : 0.0);
    }
}

static void random_arcs_agree_with_sampling(void **state)
{
    (void)state;
    uint64_t chance = 12;
    for (int i = 0; i < 1000; i++) {
        const tdsp_point center = {chance_between(&chance, -5, 5), chance_between(&chance, -5, 5)};
        const double r0 = chance_between(&chance, 0.1, 3.0), r1 = i % 4 ? r0 + chance_between(&chance, 0.0, 2.0) : r0;
        const double start = chance_between(&chance, 0.1, 20.0), takes = chance_between(&chance, 0.1, 20.0);
        const tdsp_leg leg = arc(start, start + takes, center, r0, r1, chance_between(&chance, -3, 3), i % 2 ? 1 : -1,
                                 chance_between(&chance, 0, 5));
        check_leg(&leg, (tdsp_point){chance_between(&chance, -5, 5), chance_between(&chance, -5, 5)},
                  chance_between(&chance, 0, 4));
        check_leg(&leg, center, chance_between(&chance, 0, 4));
    }
}

static void a_line_past_a_disc_has_the_slope_of_the_tangent(void **state)
{
    (void)state;
    const tdsp_leg leg = line(0.0, 20.0, (tdsp_point){-10, 0}, (tdsp_point){10, 0});
    const way w = way_of(&leg);
    const touch found = touch_of(&w, (tdsp_point){0, 3}, 1.0, 1e-13);
    /* (t - 10)^2 + 9 = (1 + W t)^2 has one root t: (10 + W)^2 = 108 (1 - W^2). */
    const double rate = (-20.0 + sqrt(400.0 + 4.0 * 109.0 * 8.0)) / 218.0;
    assert_near(found.rate, rate, 1e-15);
    assert_near(found.time, (10.0 + rate) / (1.0 - rate * rate), 1e-7);
}

static void at_time_zero_only_being_inside_counts(void **state)
{
    (void)state;
    const tdsp_point at = {1, 0};
    const tdsp_leg rest = line(0.0, 0.0, at, at);
    const way w = way_of(&rest);
    assert_near(touch_of(&w, (tdsp_point){0, 0}, 1.0, 1e-13).rate, INFINITY, 0);
    assert_near(touch_of(&w, (tdsp_point){0, 0}, 0.5, 1e-13).rate, INFINITY, 0);
    assert_near(touch_of(&w, (tdsp_point){0, 0}, 1.5, 1e-13).rate, -INFINITY, 0);
}

static void a_robot_at_rest_is_caught_at_the_end(void **state)
{
    (void)state;
    const tdsp_point at = {4, 0};
    const tdsp_leg rest = line(2.0, 6.0, at, at);
    const way w = way_of(&rest);
    const touch found = touch_of(&w, (tdsp_point){0, 0}, 1.0, 1e-13);
    assert_near(found.rate, 0.5, 1e-15);
    assert_near(found.time, 6.0, 0);
}

static void a_ride_on_its_own_disc_has_its_rate(void **state)
{
    (void)state;
    /* Radius 1 + 0.25 t over [4, 8]. */
    const tdsp_leg leg = arc(4.0, 8.0, (tdsp_point){3, -2}, 2.0, 3.0, 0.5, -1, 1.0);
    const way w = way_of(&leg);
    assert_near(touch_of(&w, (tdsp_point){3, -2}, 1.0, 1e-13).rate, 0.25, 1e-15);
}

#define MALFORMED(change)                                                                                                        \
    do {                                                                                                                         \
        tdsp_leg bad = good;                                                                                                     \
        bad.change;                                                                                                              \
        assert_false(way_well_formed(&bad));                                                                                     \
    } while (0)

static void malformed_legs_are_told(void **state)
{
    (void)state;
    const tdsp_leg good = arc(4.0, 8.0, (tdsp_point){3, -2}, 2.0, 3.0, 0.5, -1, 1.0);
    assert_true(way_well_formed(&good));
    MALFORMED(start_time = -1.0);
    MALFORMED(end_time = 3.0);
    MALFORMED(end_time = INFINITY);
    MALFORMED(turn = 0);
    MALFORMED(center.x = NAN);
    MALFORMED(center.y = INFINITY);
    MALFORMED(radius_from = 0.0);
    MALFORMED(radius_from = INFINITY);
    MALFORMED(radius_to = -1.0);
    MALFORMED(angle_from = INFINITY);
    MALFORMED(sweep = NAN);
    MALFORMED(sweep = -0.1);
    MALFORMED(from.x = NAN);
    MALFORMED(from.y = NAN);
    MALFORMED(to.x = INFINITY);
    MALFORMED(kind = 77);
}

/* Around a centre 1e-5 away the distance hardly changes: the parts are halved until that costs too much, and what is left out is within the coarse resolution. */
static void a_ride_that_creeps_along_a_disc_is_bounded_from_below(void **state)
{
    (void)state;
    const tdsp_leg leg = arc(4.0, 8.0, (tdsp_point){0, 0}, 2.0, 3.0, 0.0, 1, 6.0);
    const tdsp_point beside = {1e-5, 0};
    const way w = way_of(&leg);
    const touch found = touch_of(&w, beside, 1.0, 1e-13);
    check_leg(&leg, beside, 1.0);
    assert_near(found.rate, 0.25, 1e-5);
}

/* A radius that gains more than a double holds still makes an arc of finite length. */
static void an_arc_may_begin_next_to_its_centre(void **state)
{
    (void)state;
    const tdsp_leg leg = arc(0.0, 1.0, (tdsp_point){0, 0}, 1e-310, 1.0, 0.0, 1, 1.0);
    assert_near(way_of(&leg).length, hypot(1.0, 1.0 / (310.0 * log(10.0))), 1e-12);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(random_lines_agree_with_sampling),
        cmocka_unit_test(random_arcs_agree_with_sampling),
        cmocka_unit_test(a_line_past_a_disc_has_the_slope_of_the_tangent),
        cmocka_unit_test(at_time_zero_only_being_inside_counts),
        cmocka_unit_test(a_robot_at_rest_is_caught_at_the_end),
        cmocka_unit_test(a_ride_on_its_own_disc_has_its_rate),
        cmocka_unit_test(malformed_legs_are_told),
        cmocka_unit_test(a_ride_that_creeps_along_a_disc_is_bounded_from_below),
        cmocka_unit_test(an_arc_may_begin_next_to_its_centre),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
