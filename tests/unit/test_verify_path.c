/* SPDX-License-Identifier: MIT */
/* The verifier of paths against sampling, and against paths with one thing wrong. */
#include "support/cmocka_all.h"
#include "support/tight.h"

#include <stdlib.h>

#include "support/chance.h"
#include "tdsp/path.h"
#include "tdsp/verify.h"

#define PI 3.14159265358979323846

static const tdsp_journey gap_journey = {1.0, 0.0, {-10.0, 0.0}, {10.0, 0.0}};
static const tdsp_disc gap_discs[2] = {{{0.0, 3.0}, 1.0, 0.1}, {{0.0, -3.0}, 1.0, 0.1}};

static tdsp_leg line(double start, double end, tdsp_point from, tdsp_point to)
{
    return (tdsp_leg){.disc = TDSP_NO_DISC, .start_time = start, .end_time = end, .from = from, .to = to};
}

static tdsp_point polar(tdsp_point center, double radius, double angle)
{
    return (tdsp_point){center.x + radius * cos(angle), center.y + radius * sin(angle)};
}

static tdsp_leg arc(double start, double end, tdsp_point center, double from, double to, double angle, int turn, double sweep)
{
    tdsp_leg leg = line(start, end, polar(center, from, angle), polar(center, to, angle + turn * sweep));
    leg.kind = TDSP_LEG_ARC;
    leg.disc = 0;
    leg.turn = turn;
    leg.center = center;
    leg.radius_from = from;
    leg.radius_to = to;
    leg.angle_from = angle;
    leg.sweep = sweep;
    return leg;
}

/* The arc of a ride on a disc by a robot of speed 1. */
static tdsp_leg ride(const tdsp_disc *disc, double start, double end, double angle, int turn)
{
    const double from = disc->radius + disc->growth * start, to = disc->radius + disc->growth * end, c = disc->growth;
    const double sweep = sqrt(1.0 - c * c) * (c > 0.0 ? log1p(c * (end - start) / from) / c : (end - start) / from);
    return arc(start, end, disc->center, from, to, angle, turn, sweep);
}

static tdsp_verdict verdict_of(const tdsp_journey *journey, const tdsp_disc *discs, size_t discs_count, const tdsp_leg *legs,
                               size_t count)
{
    tdsp_scene *scene;
    tdsp_verdict verdict;
    assert_int_equal(tdsp_scene_create(journey, discs, discs_count, NULL, &scene), TDSP_OK);
    const double departure = count ? fmax(0.0, legs[0].start_time) : 0.0, arrival = count ? legs[count - 1].end_time : 0.0;
    assert_int_equal(tdsp_verify_path(scene, legs, count, departure, isfinite(arrival) ? arrival : 0.0, &verdict), TDSP_OK);
    tdsp_scene_free(scene);
    return verdict;
}

static tdsp_verdict verdict_of_ride(const tdsp_disc *disc, const tdsp_leg *leg)
{
    const tdsp_journey journey = {1.0, 0.0, leg->from, leg->to};
    return verdict_of(&journey, disc, 1, leg, 1);
}

static void a_line_through_an_open_gap_is_accepted_until_the_gap_is_lost(void **state)
{
    (void)state;
    /* The corner of the two discs slows down to speed 1 when its discs have the radius 3 / sqrt(0.99). */
    const double radius = 3.0 / sqrt(0.99), last = (radius - 1.0) / 0.1 - 10.0 - 0.1 * radius;
    for (int late = 0; late < 2; late++) {
        const double departure = last + (late ? 1e-6 : 0.0);
        const tdsp_leg leg = line(departure, departure + 20.0, gap_journey.source, gap_journey.destination);
        const tdsp_verdict verdict = verdict_of(&gap_journey, gap_discs, 2, &leg, 1);
        assert_int_equal(verdict.problems, late ? TDSP_PROBLEM_CLEARANCE : 0);
        assert_near(verdict.min_clearance, late ? -1e-7 : 0.0, 1e-9);
        assert_near(verdict.time, 10.0 * (radius - 1.0), 1e-5);
    }
}

/* The least clearance by sampling, then by golden section around the best sample. */
static double clearance_at(const tdsp_leg *leg, const tdsp_disc *disc, double time)
{
    const tdsp_point at = tdsp_leg_position(leg, time);
    return hypot(at.x - disc->center.x, at.y - disc->center.y) - disc->radius - disc->growth * time;
}

static double sampled_clearance(const tdsp_leg *leg, const tdsp_disc *disc, int samples)
{
    double best = INFINITY, at = leg->start_time;
    const double step = (leg->end_time - leg->start_time) / samples;
    for (int i = 0; i <= samples; i++) {
        const double time = leg->start_time + i * step, f = clearance_at(leg, disc, time);
        if (f < best) {
            best = f;
            at = time;
        }
    }
    double low = fmax(leg->start_time, at - step), high = fmin(leg->end_time, at + step);
    for (int i = 0; i < 80; i++) {
        const double left = low + 0.382 * (high - low), right = low + 0.618 * (high - low);
        const double f = clearance_at(leg, disc, left), g = clearance_at(leg, disc, right);
        best = fmin(best, fmin(f, g));
        if (f < g)
            high = right;
        else
            low = left;
    }
    return best;
}

static tdsp_disc random_disc(uint64_t *chance)
{
    static const double rates[] = {0.0, 0.05, 0.4, 0.99, 1.0, 2.0};
    const tdsp_point center = {chance_between(chance, -3.0, 3.0), chance_between(chance, -3.0, 3.0)};
    const double radius = chance_below(chance, 4) ? chance_between(chance, 0.0, 1.0) : 0.0;
    return (tdsp_disc){center, radius, rates[chance_below(chance, 6)]};
}

static void assert_clearance_is_the_sampled_one(const tdsp_leg *leg, uint64_t *chance, int samples)
{
    tdsp_disc discs[20];
    double expected = INFINITY;
    const size_t count = 1 + (size_t)chance_below(chance, 20);
    for (size_t i = 0; i < count; i++) {
        discs[i] = random_disc(chance);
        expected = fmin(expected, sampled_clearance(leg, &discs[i], samples));
    }
    const tdsp_journey journey = {1.0, 0.0, leg->from, leg->to};
    const tdsp_verdict verdict = verdict_of(&journey, discs, count, leg, 1);
    assert_true(verdict.min_clearance <= expected + 1e-13);
    assert_near(verdict.min_clearance, expected, 0.002 * verdict.tolerance);
}

static void the_clearance_of_a_line_is_the_sampled_one(void **state)
{
    (void)state;
    uint64_t chance = 1;
    for (int i = 0; i < 1000; i++) {
        const tdsp_point from = {chance_between(&chance, -3.0, 3.0), chance_between(&chance, -3.0, 3.0)};
        const tdsp_point to = {chance_between(&chance, -3.0, 3.0), chance_between(&chance, -3.0, 3.0)};
        const double start = chance_between(&chance, 0.0, 2.0), way = hypot(to.x - from.x, to.y - from.y);
        const tdsp_leg leg = line(start, start + way * (i % 3 ? 1.0 : 1.7), from, to);
        assert_clearance_is_the_sampled_one(&leg, &chance, 100);
    }
}

static void the_clearance_of_an_arc_is_the_sampled_one(void **state)
{
    (void)state;
    uint64_t chance = 2;
    for (int i = 0; i < 1000; i++) {
        const tdsp_point center = {chance_between(&chance, -1.0, 1.0), chance_between(&chance, -1.0, 1.0)};
        const double from = chance_between(&chance, 0.01, 2.0), sweep = chance_between(&chance, 0.0, i % 10 ? 4.0 : 20.0);
        const double to = i % 5 ? from * chance_between(&chance, 1.0, 3.0) : from;
        const double way = hypot(to - from, sweep * from * (to > from ? (to / from - 1.0) / log(to / from) : 1.0));
        const double start = chance_between(&chance, 0.0, 1.0);
        const tdsp_leg leg = arc(start, start + way, center, from, to, chance_between(&chance, -PI, PI), i % 2 ? 1 : -1, sweep);
        assert_clearance_is_the_sampled_one(&leg, &chance, 1500);
    }
}

static void a_ride_on_a_disc_has_clearance_0(void **state)
{
    (void)state;
    static const double rates[] = {0.0, 1e-12, 0.1, 0.9, 0.9999};
    for (size_t i = 0; i < 5; i++) {
        const tdsp_disc disc = {{3.0, -2.0}, 0.7, rates[i]};
        const tdsp_leg leg = ride(&disc, 1.0, 2.5, 0.4, i % 2 ? 1 : -1);
        const tdsp_verdict verdict = verdict_of_ride(&disc, &leg);
        assert_int_equal(verdict.problems, 0);
        assert_near(verdict.min_clearance, 0.0, 1e-14);
    }
}

static void a_ride_moved_earlier_is_accepted_and_moved_later_it_is_not(void **state)
{
    (void)state;
    const tdsp_disc disc = {{3.0, -2.0}, 0.7, 0.2};
    const tdsp_leg leg = ride(&disc, 1.0, 2.5, 0.4, 1);
    const tdsp_leg early = tdsp_leg_shifted(&leg, -0.25), late = tdsp_leg_shifted(&leg, 0.25);
    tdsp_verdict verdict = verdict_of_ride(&disc, &early);
    assert_int_equal(verdict.problems, 0);
    assert_near(verdict.min_clearance, 0.05, 1e-12);
    verdict = verdict_of_ride(&disc, &late);
    assert_int_equal(verdict.problems, TDSP_PROBLEM_CLEARANCE);
    assert_near(verdict.min_clearance, -0.05, 1e-12);
}

static void a_ride_that_grazes_another_disc_from_inside_a_gap_is_judged_at_the_graze(void **state)
{
    (void)state;
    const tdsp_disc ridden = {{0.0, 0.0}, 1.0, 0.1};
    const tdsp_leg leg = ride(&ridden, 0.0, 2.0, -1.0, 1);
    for (int deep = -1; deep <= 1; deep += 2) {
        tdsp_disc discs[2] = {ridden, {{2.5, 0.1}, 0.0, 0.3}};
        discs[1].radius = sampled_clearance(&leg, &discs[1], 10000) + deep * 1e-7;
        const tdsp_journey journey = {1.0, 0.0, leg.from, leg.to};
        const tdsp_verdict verdict = verdict_of(&journey, discs, 2, &leg, 1);
        assert_int_equal(verdict.problems, deep > 0 ? TDSP_PROBLEM_CLEARANCE : 0);
        if (deep > 0) assert_near(verdict.min_clearance, -1e-7, 1e-10);
    }
}

static void creeping_along_a_disc_around_nearly_the_same_centre_is_bounded_and_accepted(void **state)
{
    (void)state;
    const tdsp_disc ridden = {{0.0, 0.0}, 1.0, 0.1};
    for (double away = 1e-16; away < 1e-6; away *= 10.0) {
        tdsp_disc discs[2] = {ridden, ridden};
        discs[1].center.x = away;
        discs[1].radius -= away;
        const tdsp_leg leg = ride(&ridden, 0.0, 6.0, 0.0, 1);
        const tdsp_journey journey = {1.0, 0.0, leg.from, leg.to};
        const tdsp_verdict verdict = verdict_of(&journey, discs, 2, &leg, 1);
        assert_int_equal(verdict.problems, 0);
        assert_true(verdict.min_clearance >= -0.25 * verdict.tolerance - 1e-14);
    }
}

/* A good path of three legs that each test spoils: around the unit disc at the origin, at rest. */
static const tdsp_disc round_disc = {{0.0, 0.0}, 1.0, 0.0};
static const tdsp_journey round_journey = {1.0, 0.0, {-2.0, 1.0}, {2.0, -1.0}};

static void good_path(tdsp_leg legs[3])
{
    const double begin = 0.5 * PI, way = 0.5 * PI;
    legs[0] = line(0.0, 2.0, round_journey.source, (tdsp_point){0.0, 1.0});
    legs[1] = arc(2.0, 2.0 + way, round_disc.center, 1.0, 1.0, begin, -1, way);
    legs[2] = line(2.0 + way, 2.0 + way + hypot(1.0, 1.0), (tdsp_point){1.0, 0.0}, round_journey.destination);
}

static uint32_t problems_of(const tdsp_leg *legs, size_t *leg)
{
    const tdsp_verdict verdict = verdict_of(&round_journey, &round_disc, 1, legs, 3);
    *leg = verdict.leg;
    return verdict.problems;
}

#define assert_problems(expected, where)                                                                                         \
    do {                                                                                                                         \
        size_t leg;                                                                                                              \
        assert_int_equal(problems_of(legs, &leg), (expected));                                                                   \
        assert_int_equal(leg, (where));                                                                                          \
    } while (0)

static void a_path_without_fault_has_no_problem(void **state)
{
    (void)state;
    tdsp_leg legs[3];
    good_path(legs);
    size_t leg;
    assert_int_equal(problems_of(legs, &leg), 0);
}

static void wrong_ends_and_joins_are_told_apart(void **state)
{
    (void)state;
    tdsp_leg legs[3];
    good_path(legs);
    legs[0].from.y += 1e-7;
    assert_problems(TDSP_PROBLEM_START, 0);
    good_path(legs);
    legs[2].to.x -= 1e-7;
    assert_problems(TDSP_PROBLEM_END, 2);
    good_path(legs);
    legs[2].start_time += 1e-7;
    legs[2].end_time += 1e-7;
    assert_problems(TDSP_PROBLEM_JOIN, 2);
}

static void too_fast_a_line_or_arc_is_found(void **state)
{
    (void)state;
    tdsp_leg legs[3];
    good_path(legs);
    legs[2].end_time -= 1e-7;
    assert_problems(TDSP_PROBLEM_SPEED, 2);
    good_path(legs);
    legs[1].end_time -= 1e-7;
    legs[2].start_time -= 1e-7;
    assert_problems(TDSP_PROBLEM_SPEED, 1);
    const tdsp_disc disc = {{0.0, 0.0}, 1.0, 0.5};
    tdsp_leg fast = ride(&disc, 0.0, 1.0, 0.0, 1);
    assert_int_equal(verdict_of_ride(&disc, &fast).problems, 0);
    fast = arc(0.0, 1.0, fast.center, fast.radius_from, fast.radius_to, 0.0, 1, fast.sweep * (1.0 + 1e-7));
    assert_int_equal(verdict_of_ride(&disc, &fast).problems, TDSP_PROBLEM_SPEED);
}

static void a_slow_line_is_no_problem(void **state)
{
    (void)state;
    tdsp_leg legs[3];
    good_path(legs);
    legs[2].end_time += 1.0;
    size_t leg;
    assert_int_equal(problems_of(legs, &leg), 0);
}

#define MEANS_NOTHING(change, where)                                                                                             \
    do {                                                                                                                         \
        good_path(legs);                                                                                                         \
        legs[where].change;                                                                                                      \
        assert_problems(TDSP_PROBLEM_LEG, where);                                                                                \
    } while (0)

static void legs_that_mean_nothing_are_found(void **state)
{
    (void)state;
    tdsp_leg legs[3];
    const double nothing[] = {NAN, INFINITY, -INFINITY};
    for (size_t i = 0; i < 3; i++) {
        MEANS_NOTHING(radius_to = nothing[i], 1);
        MEANS_NOTHING(radius_from = nothing[i], 1);
        MEANS_NOTHING(center.x = nothing[i], 1);
        MEANS_NOTHING(center.y = nothing[i], 1);
        MEANS_NOTHING(angle_from = nothing[i], 1);
        MEANS_NOTHING(sweep = nothing[i], 1);
        MEANS_NOTHING(from.x = nothing[i], 0);
        MEANS_NOTHING(to.y = nothing[i], 2);
        MEANS_NOTHING(start_time = nothing[i], 1);
        MEANS_NOTHING(end_time = nothing[i], 1);
    }
    MEANS_NOTHING(kind = 7, 0);
    MEANS_NOTHING(turn = 0, 1);
    MEANS_NOTHING(sweep = -1.0, 1);
    MEANS_NOTHING(radius_from = 0.0, 1);
    MEANS_NOTHING(radius_to = 0.0, 1);
    MEANS_NOTHING(end_time = legs[1].start_time - 1.0, 1);
}

static void an_arc_belongs_to_the_disc_it_names_and_to_its_centre(void **state)
{
    (void)state;
    tdsp_leg legs[3];
    good_path(legs);
    legs[1].disc = 1;
    assert_problems(TDSP_PROBLEM_LEG, 1);
    good_path(legs);
    legs[1].center.x += 1e-7;
    assert_problems(TDSP_PROBLEM_LEG, 1);
    good_path(legs);
    legs[1].sweep -= 1e-7;
    assert_problems(TDSP_PROBLEM_LEG, 1);
}

static void cutting_the_corner_of_an_arc_is_found_and_measured(void **state)
{
    (void)state;
    const tdsp_leg legs[2] = {line(0.0, hypot(2.0, 0.5), round_journey.source, (tdsp_point){0.0, 0.5}),
                              line(hypot(2.0, 0.5), 2.0 * hypot(2.0, 0.5), (tdsp_point){0.0, 0.5}, (tdsp_point){2.0, 0.0})};
    const tdsp_journey journey = {1.0, 0.0, {-2.0, 1.0}, {2.0, 0.0}};
    const tdsp_verdict verdict = verdict_of(&journey, &round_disc, 1, legs, 2);
    assert_int_equal(verdict.problems, TDSP_PROBLEM_CLEARANCE);
    assert_int_equal(verdict.leg, 1);
    assert_int_equal(verdict.disc, 0);
    assert_near(verdict.min_clearance, 1.0 / hypot(2.0, 0.5) - 1.0, 1e-12);
}

static void the_radius_of_the_robot_counts(void **state)
{
    (void)state;
    const tdsp_journey journey = {1.0, 0.25, {-2.0, 1.5}, {2.0, 1.5}};
    const tdsp_leg leg = line(0.0, 4.0, journey.source, journey.destination);
    assert_near(verdict_of(&journey, &round_disc, 1, &leg, 1).min_clearance, 0.25, 1e-15);
}

static void no_legs_are_a_path_only_to_where_one_is(void **state)
{
    (void)state;
    const tdsp_journey still = {1.0, 0.0, {2.0, 0.0}, {2.0, 0.0}}, inside = {1.0, 0.0, {0.5, 0.0}, {0.5, 0.0}};
    assert_int_equal(verdict_of(&still, &round_disc, 1, NULL, 0).problems, 0);
    assert_near(verdict_of(&still, &round_disc, 1, NULL, 0).min_clearance, 1.0, 0.0);
    assert_int_equal(verdict_of(&inside, &round_disc, 1, NULL, 0).problems, TDSP_PROBLEM_CLEARANCE);
    assert_int_equal(verdict_of(&round_journey, &round_disc, 1, NULL, 0).problems, TDSP_PROBLEM_END);
}

static void without_discs_the_clearance_is_infinite(void **state)
{
    (void)state;
    const tdsp_leg leg = line(0.0, 20.0, gap_journey.source, gap_journey.destination);
    const tdsp_verdict verdict = verdict_of(&gap_journey, NULL, 0, &leg, 1);
    assert_int_equal(verdict.problems, 0);
    assert_int_equal(verdict.disc, TDSP_NO_DISC);
    assert_true(verdict.min_clearance == INFINITY);
}

static void many_discs_give_what_each_gives_alone(void **state)
{
    (void)state;
    enum { COUNT = 3000 };
    static tdsp_disc discs[COUNT];
    uint64_t chance = 3;
    for (size_t i = 0; i < COUNT; i++) {
        const tdsp_point place = {floor(chance_between(&chance, -9.0, 9.0)), chance_between(&chance, -9.0, 9.0)};
        discs[i] = (tdsp_disc){place, chance_between(&chance, 0.0, 0.02), chance_between(&chance, 0.0, 0.01)};
    }
    for (int trial = 0; trial < 20; trial++) {
        const tdsp_point from = {chance_between(&chance, -9.0, 9.0), chance_between(&chance, -9.0, 9.0)};
        const tdsp_leg leg = line(0.0, 1.0, from, (tdsp_point){from.x + 0.6, from.y - 0.8});
        double expected = INFINITY;
        for (size_t i = 0; i < COUNT; i++) expected = fmin(expected, sampled_clearance(&leg, &discs[i], 4));
        const tdsp_journey journey = {1.0, 0.0, leg.from, leg.to};
        assert_near(verdict_of(&journey, discs, COUNT, &leg, 1).min_clearance, expected, 1e-12);
    }
}

static void arguments_out_of_range_are_refused(void **state)
{
    (void)state;
    tdsp_scene *scene;
    tdsp_verdict verdict;
    const tdsp_leg leg = line(0.0, 20.0, gap_journey.source, gap_journey.destination);
    const tdsp_ends nowhere = {{NAN, 0.0}, {0.0, 0.0}};
    assert_int_equal(tdsp_scene_create(&gap_journey, gap_discs, 2, NULL, &scene), TDSP_OK);
    assert_int_equal(tdsp_verify_path(NULL, &leg, 1, 0.0, 20.0, &verdict), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_verify_path(scene, NULL, 1, 0.0, 20.0, &verdict), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_verify_path(scene, &leg, 1, -1.0, 20.0, &verdict), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_verify_path(scene, &leg, 1, NAN, 20.0, &verdict), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_verify_path(scene, &leg, 1, 0.0, INFINITY, &verdict), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_verify_path(scene, &leg, 1, 0.0, 20.0, NULL), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_verify_path_for(scene, &nowhere, &leg, 1, 0.0, 20.0, &verdict), TDSP_INVALID_ARGUMENT);
    tdsp_scene_free(scene);
}

static void a_refused_allocation_is_an_error_and_leaks_nothing(void **state)
{
    (void)state;
    tight_heap heap = {.and_after = 1};
    const tdsp_allocator allocator = tight_allocator(&heap);
    tdsp_scene *scene;
    tdsp_verdict verdict;
    const tdsp_leg leg = line(0.0, 20.0, gap_journey.source, gap_journey.destination);
    assert_int_equal(tdsp_scene_create(&gap_journey, gap_discs, 2, &allocator, &scene), TDSP_OK);
    const size_t before = heap.blocks;
    for (size_t refuse = 1;; refuse++) {
        heap.calls = 0;
        heap.refuse = refuse;
        const tdsp_status status = tdsp_verify_path(scene, &leg, 1, 0.0, 20.0, &verdict);
        assert_int_equal(heap.blocks, before);
        if (status == TDSP_OK) break;
        assert_int_equal(status, TDSP_NO_MEMORY);
    }
    tdsp_scene_free(scene);
    assert_int_equal(heap.blocks, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_line_through_an_open_gap_is_accepted_until_the_gap_is_lost),
        cmocka_unit_test(the_clearance_of_a_line_is_the_sampled_one),
        cmocka_unit_test(the_clearance_of_an_arc_is_the_sampled_one),
        cmocka_unit_test(a_ride_on_a_disc_has_clearance_0),
        cmocka_unit_test(a_ride_moved_earlier_is_accepted_and_moved_later_it_is_not),
        cmocka_unit_test(a_ride_that_grazes_another_disc_from_inside_a_gap_is_judged_at_the_graze),
        cmocka_unit_test(creeping_along_a_disc_around_nearly_the_same_centre_is_bounded_and_accepted),
        cmocka_unit_test(a_path_without_fault_has_no_problem),
        cmocka_unit_test(wrong_ends_and_joins_are_told_apart),
        cmocka_unit_test(too_fast_a_line_or_arc_is_found),
        cmocka_unit_test(a_slow_line_is_no_problem),
        cmocka_unit_test(legs_that_mean_nothing_are_found),
        cmocka_unit_test(an_arc_belongs_to_the_disc_it_names_and_to_its_centre),
        cmocka_unit_test(cutting_the_corner_of_an_arc_is_found_and_measured),
        cmocka_unit_test(the_radius_of_the_robot_counts),
        cmocka_unit_test(no_legs_are_a_path_only_to_where_one_is),
        cmocka_unit_test(without_discs_the_clearance_is_infinite),
        cmocka_unit_test(many_discs_give_what_each_gives_alone),
        cmocka_unit_test(arguments_out_of_range_are_refused),
        cmocka_unit_test(a_refused_allocation_is_an_error_and_leaks_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
