/* SPDX-License-Identifier: MIT */
/* The verifier where rates change, and on curves: against sampling, against rides that are right, and against rides with one thing wrong. */
#include "support/cmocka_all.h"

#include "support/chance.h"
#include "support/curve.h"
#include "tdsp/growth.h"
#include "tdsp/path.h"
#include "tdsp/verify.h"

/* ------------------------------------------------------------------------------------------------ growth, evaluated by the test */

enum { PIECES = 4 };

/* Polynomial, rates, or a law: R = radius + rise (1 - exp(-t / late)) after a start, with a kink there. */
typedef struct grown {
    tdsp_growth_kind kind;
    tdsp_point center;
    double radius;
    double values[TDSP_GROWTH_DEGREE];
    double times[PIECES];
    size_t count;
    double start, rise, late;
} grown;

static double grown_radius(const grown *g, double t)
{
    double radius = g->radius, power = 1;
    for (size_t k = 0; k < g->count && g->kind == TDSP_GROWTH_POLYNOMIAL; k++) radius += g->values[k] * (power *= t);
    for (size_t k = 0; k < g->count && g->kind == TDSP_GROWTH_RATES; k++) {
        const double end = k + 1 < g->count ? g->times[k + 1] : INFINITY;
        radius += g->values[k] * fmax(0, fmin(t, end) - g->times[k]);
    }
    if (g->kind == TDSP_GROWTH_LAW && t > g->start) radius -= g->rise * expm1(-(t - g->start) / g->late);
    return radius;
}

static void grown_law(void *ctx, double t, double *radius, double *rate)
{
    const grown *g = ctx;
    *radius = grown_radius(g, t);
    *rate = t >= g->start ? g->rise / g->late * exp(-(t - g->start) / g->late) : 0;
}

static tdsp_growing_disc grown_disc(grown *g)
{
    tdsp_growing_disc disc = {g->center, g->radius, {.kind = g->kind, .count = g->count, .values = g->values, .times = g->times}};
    if (g->kind != TDSP_GROWTH_LAW) return disc;
    disc.growth =
        (tdsp_growth){.kind = g->kind, .count = g->start > 0, .times = &g->start, .law = grown_law, .ctx = g, .until = 20};
    return disc;
}

static grown random_grown(uint64_t *chance)
{
    static const double sizes[] = {0.3, 0.1, 0.02, 0.005, 0.002, 0.0005, 0.0001, 0.00002};
    grown g = {.center = {chance_between(chance, -3, 3), chance_between(chance, -3, 3)}};
    g.kind = (tdsp_growth_kind)(1 + chance_below(chance, 3));
    g.radius = chance_below(chance, 4) ? chance_between(chance, 0, 1) : 0;
    g.count = 1 + (size_t)chance_below(chance, g.kind == TDSP_GROWTH_RATES ? PIECES : TDSP_GROWTH_DEGREE);
    for (size_t k = 0; k < g.count; k++) {
        g.values[k] = chance_between(chance, 0, g.kind == TDSP_GROWTH_RATES ? 1.2 : sizes[k]);
        if (k < PIECES) g.times[k] = k ? g.times[k - 1] + chance_between(chance, 0.1, 2) : 0;
    }
    g.start = chance_below(chance, 2) ? chance_between(chance, 0.1, 4) : 0;
    g.rise = chance_between(chance, 0, 2);
    g.late = chance_between(chance, 0.2, 4);
    return g;
}

static tdsp_scene *scene_of(const tdsp_journey *journey, grown *all, size_t count)
{
    tdsp_growing_disc discs[64];
    tdsp_scene *scene = NULL;
    for (size_t i = 0; i < count; i++) discs[i] = grown_disc(&all[i]);
    assert_int_equal(tdsp_scene_create_growing(journey, discs, count, NULL, &scene), TDSP_OK);
    return scene;
}

static tdsp_verdict verdict_in(const tdsp_scene *scene, const tdsp_leg *legs, size_t count)
{
    tdsp_verdict verdict;
    assert_int_equal(tdsp_verify_path(scene, legs, count, legs[0].start_time, legs[count - 1].end_time, &verdict), TDSP_OK);
    return verdict;
}

static tdsp_verdict verdict_of(grown *all, size_t discs, double speed, const tdsp_leg *legs, size_t count)
{
    const tdsp_journey journey = {speed, 0, legs[0].from, legs[count - 1].to};
    tdsp_scene *scene = scene_of(&journey, all, discs);
    const tdsp_verdict verdict = verdict_in(scene, legs, count);
    tdsp_scene_free(scene);
    return verdict;
}

/* ------------------------------------------------------------------------------------------------------- against sampling */

static double clearance_at(const tdsp_leg *leg, const grown *g, double time)
{
    const tdsp_point at = tdsp_leg_position(leg, time);
    return hypot(at.x - g->center.x, at.y - g->center.y) - grown_radius(g, time);
}

/* Golden section in a sample's surroundings. */
static double refined(const tdsp_leg *leg, const grown *g, double low, double high)
{
    double best = INFINITY;
    for (int i = 0; i < 60; i++) {
        const double left = low + 0.382 * (high - low), right = low + 0.618 * (high - low);
        const double f = clearance_at(leg, g, left), h = clearance_at(leg, g, right);
        best = fmin(best, fmin(f, h));
        if (f < h)
            high = right;
        else
            low = left;
    }
    return best;
}

/* All the samples that are nearly the least are looked at closely. */
static double sampled_clearance(const tdsp_leg *leg, const grown *g, int samples)
{
    const double step = (leg->end_time - leg->start_time) / samples;
    double best = INFINITY;
    for (int i = 0; i <= samples; i++)
        best = fmin(best, clearance_at(leg, g, i < samples ? leg->start_time + i * step : leg->end_time));
    const double near = best + step * step;
    for (int i = 0; i <= samples; i++) {
        const double time = leg->start_time + i * step;
        if (clearance_at(leg, g, time) <= near)
            best = fmin(best, refined(leg, g, fmax(leg->start_time, time - step), fmin(leg->end_time, time + step)));
    }
    return best;
}

static tdsp_leg random_line(uint64_t *chance)
{
    const tdsp_point from = {chance_between(chance, -3, 3), chance_between(chance, -3, 3)};
    const tdsp_point to = {chance_between(chance, -3, 3), chance_between(chance, -3, 3)};
    const double start = chance_between(chance, 0, 4);
    return (tdsp_leg){.disc = TDSP_NO_DISC,
                      .start_time = start,
                      .end_time = start + hypot(to.x - from.x, to.y - from.y),
                      .from = from,
                      .to = to};
}

static tdsp_leg random_arc(uint64_t *chance)
{
    const double start = chance_between(chance, 0, 4), angle = chance_between(chance, -3, 3),
                 sweep = chance_between(chance, 0, 3);
    tdsp_leg leg = {
        .kind = TDSP_LEG_ARC, .turn = chance_below(chance, 2) ? 1 : -1, .start_time = start, .angle_from = angle, .sweep = sweep};
    leg.center = (tdsp_point){chance_between(chance, -2, 2), chance_between(chance, -2, 2)};
    leg.radius_from = chance_between(chance, 0.3, 1.5);
    leg.radius_to = leg.radius_from + (chance_below(chance, 2) ? chance_between(chance, 0, 1) : 0);
    leg.end_time = start + leg.radius_to * sweep + leg.radius_to - leg.radius_from + 0.1;
    const double to = angle + leg.turn * sweep;
    leg.from = (tdsp_point){leg.center.x + leg.radius_from * cos(angle), leg.center.y + leg.radius_from * sin(angle)};
    leg.to = (tdsp_point){leg.center.x + leg.radius_to * cos(to), leg.center.y + leg.radius_to * sin(to)};
    return leg;
}

static const curve_law laws[] = {{{1, 0.1, 0.02}}, {{0.8, 0, 0.1, -0.01}}, {{1.2, 0.3, -0.05, 0.02}}, {{1, 0.25}}};
enum { LAWS = sizeof laws / sizeof laws[0] };

static tdsp_leg random_curve(uint64_t *chance)
{
    const tdsp_point center = {chance_between(chance, -2, 2), chance_between(chance, -2, 2)};
    const double start = chance_between(chance, 0, 3), end = start + chance_between(chance, 0.01, 1);
    return curve_leg(&laws[chance_below(chance, LAWS)], center, 1.5, start, end, chance_between(chance, -3, 3),
                     chance_below(chance, 2) ? 1 : -1);
}

static void assert_clearance_is_the_sampled_one(tdsp_leg (*random_leg)(uint64_t *), int rounds, int samples)
{
    uint64_t chance = 11;
    for (int i = 0; i < rounds; i++) {
        const tdsp_leg leg = random_leg(&chance);
        grown all[6];
        double expected = INFINITY;
        const size_t count = 1 + (size_t)chance_below(&chance, 6);
        for (size_t k = 0; k < count; k++) {
            all[k] = random_grown(&chance);
            if (chance_below(&chance, 5) == 0) all[k].center = leg.center; /* as when it is the disc ridden */
            expected = fmin(expected, sampled_clearance(&leg, &all[k], samples));
        }
        const tdsp_verdict verdict = verdict_of(all, count, 1.5, &leg, 1);
        assert_true(verdict.min_clearance <= expected + 1e-12);
        assert_near(verdict.min_clearance, expected, 0.002 * verdict.tolerance + 1e-12);
    }
}

static void the_clearance_of_a_line_is_the_sampled_one(void **state)
{
    (void)state;
    assert_clearance_is_the_sampled_one(random_line, 300, 1000);
}

static void the_clearance_of_an_arc_is_the_sampled_one(void **state)
{
    (void)state;
    assert_clearance_is_the_sampled_one(random_arc, 200, 1000);
}

static void the_clearance_of_a_curve_is_the_sampled_one(void **state)
{
    (void)state;
    assert_clearance_is_the_sampled_one(random_curve, 200, 1000);
}

/* ---------------------------------------------------------------------------------------------------------------- rides */

enum { RIDE = 24 };

static const tdsp_point ride_center = {4, -3};

/* Disc 0 as the test's laws have it. */
static grown ridden(const curve_law *law)
{
    grown g = {.kind = TDSP_GROWTH_POLYNOMIAL, .center = ride_center, .radius = law->c[0], .count = 4};
    for (size_t k = 0; k < 4; k++) g.values[k] = law->c[k + 1];
    return g;
}

static void make_ride(const curve_law *law, int turn, tdsp_leg legs[RIDE])
{
    curve_legs(law, ride_center, 1.5, 0.5, 2, 1, turn, legs, RIDE);
}

static uint32_t problems_of(const curve_law *law, const tdsp_leg legs[RIDE])
{
    grown disc = ridden(law);
    return verdict_of(&disc, 1, 1.5, legs, RIDE).problems;
}

static void a_ride_on_a_disc_whose_rate_changes_is_accepted_and_touches_it(void **state)
{
    (void)state;
    for (int turn = -1; turn <= 1; turn += 2)
        for (size_t i = 0; i < LAWS; i++) {
            tdsp_leg legs[RIDE];
            grown disc = ridden(&laws[i]);
            make_ride(&laws[i], turn, legs);
            const tdsp_verdict verdict = verdict_of(&disc, 1, 1.5, legs, RIDE);
            assert_int_equal(verdict.problems, 0);
            assert_near(verdict.min_clearance, 0, 1e-12);
        }
}

static void a_ride_into_the_disc_by_a_millionth_is_rejected(void **state)
{
    (void)state;
    for (size_t i = 0; i < LAWS; i++)
        for (int outside = 0; outside < 2; outside++) {
            tdsp_leg legs[RIDE];
            grown disc = ridden(&laws[i]);
            make_ride(&laws[i], 1, legs);
            disc.radius += outside ? -1e-6 : 1e-6;
            const tdsp_verdict verdict = verdict_of(&disc, 1, 1.5, legs, RIDE);
            assert_int_equal(verdict.problems, outside ? 0 : TDSP_PROBLEM_CLEARANCE);
            assert_near(verdict.min_clearance, outside ? 1e-6 : -1e-6, 1e-12);
        }
}

static void a_ride_moved_earlier_is_accepted_and_moved_later_it_is_not(void **state)
{
    (void)state;
    for (int late = 0; late < 2; late++) {
        tdsp_leg legs[RIDE];
        make_ride(&laws[0], 1, legs);
        for (int i = 0; i < RIDE; i++) legs[i] = tdsp_leg_shifted(&legs[i], late ? 0.25 : -0.25);
        assert_int_equal(problems_of(&laws[0], legs), late ? TDSP_PROBLEM_CLEARANCE : 0);
    }
}

static void a_robot_too_slow_for_the_ride_by_a_millionth_is_told_so(void **state)
{
    (void)state;
    for (size_t i = 0; i < LAWS; i++) {
        tdsp_leg legs[RIDE];
        grown disc = ridden(&laws[i]);
        make_ride(&laws[i], -1, legs);
        assert_int_equal(verdict_of(&disc, 1, 1.5 * (1 - 1e-6), legs, RIDE).problems, TDSP_PROBLEM_SPEED);
        assert_int_equal(verdict_of(&disc, 1, 1.5 * (1 + 1e-6), legs, RIDE).problems, 0);
    }
}

/* Each changed number spoils a curve in some way: it leaves its places, enters the disc, or is too fast. */
static void a_curve_with_a_wrong_number_is_rejected(void **state)
{
    (void)state;
    for (int number = 0; number < 10; number++)
        for (int sign = -1; sign <= 1; sign += 2) {
            tdsp_leg legs[RIDE];
            make_ride(&laws[0], 1, legs);
            tdsp_leg *leg = &legs[7];
            double *const numbers[] = {&leg->radius_from, &leg->radius_to, &leg->rate_from, &leg->rate_to,    &leg->bend_from,
                                       &leg->bend_to,     &leg->sweep,     &leg->speed,     &leg->angle_from, &leg->center.x};
            *numbers[number] += sign * (number == 4 || number == 5 ? 1e-3 : 1e-5);
            if (problems_of(&laws[0], legs) == 0) fail_msg("number %d changed by %d was accepted", number, sign);
        }
}

static void a_curve_that_means_nothing_is_found(void **state)
{
    (void)state;
    for (int fault = 0; fault < 12; fault++) {
        tdsp_leg legs[RIDE];
        make_ride(&laws[0], 1, legs);
        switch (fault) {
        case 0: legs[3].rate_from = NAN; break;
        case 1: legs[3].rate_to = INFINITY; break;
        case 2: legs[3].bend_from = INFINITY; break;
        case 3: legs[3].bend_to = NAN; break;
        case 4: legs[3].speed = NAN; break;
        case 5: legs[3].speed = legs[3].rate_from; break;
        case 6: legs[3].rate_to = -1.5; break;
        case 7: legs[3].radius_from = 0; break;
        case 8: legs[3].turn = 0; break;
        case 9: legs[3].sweep = -1; break;
        case 10: legs[3].bend_to = 1e308, legs[3].radius_to = 1e-300; break;
        default: legs[3].disc = 1; break;
        }
        if (problems_of(&laws[0], legs) != TDSP_PROBLEM_LEG) fail_msg("fault %d is not a leg's", fault);
    }
}

/* Far beyond what any robot does, but numbers. */
static void a_curve_of_absurd_bends_is_too_fast_and_nothing_worse(void **state)
{
    (void)state;
    tdsp_leg legs[RIDE];
    make_ride(&laws[0], 1, legs);
    legs[3].bend_from = 1e200;
    const uint32_t problems = problems_of(&laws[0], legs);
    assert_int_equal(problems & TDSP_PROBLEM_SPEED, TDSP_PROBLEM_SPEED);
}

/* Rates 0.1 until 1, 0.6 until 2, 0.3 from then on. */
static const double steps_times[] = {0, 1, 2}, steps_rates[] = {0.1, 0.6, 0.3};

static grown steps_disc(void)
{
    grown g = {.kind = TDSP_GROWTH_RATES, .center = ride_center, .radius = 1, .count = 3};
    memcpy(g.values, steps_rates, sizeof steps_rates);
    memcpy(g.times, steps_times, sizeof steps_times);
    return g;
}

static tdsp_leg arc_between(const grown *g, double start, double end, double angle)
{
    const double from = grown_radius(g, start), to = grown_radius(g, end), rate = (to - from) / (end - start);
    tdsp_leg leg = {.kind = TDSP_LEG_ARC,
                    .turn = 1,
                    .start_time = start,
                    .end_time = end,
                    .center = g->center,
                    .radius_from = from,
                    .radius_to = to,
                    .angle_from = angle};
    leg.sweep = sqrt(2.25 - rate * rate) / rate * log(to / from);
    leg.from = (tdsp_point){g->center.x + from * cos(angle), g->center.y + from * sin(angle)};
    leg.to = (tdsp_point){g->center.x + to * cos(angle + leg.sweep), g->center.y + to * sin(angle + leg.sweep)};
    return leg;
}

static void arcs_on_a_disc_whose_rate_jumps_are_accepted_and_one_across_a_jump_is_not(void **state)
{
    (void)state;
    grown disc = steps_disc();
    const double times[] = {0.5, 1, 2, 2.5};
    tdsp_leg legs[3];
    double angle = 2;
    for (int i = 0; i < 3; i++) {
        legs[i] = arc_between(&disc, times[i], times[i + 1], angle);
        angle += legs[i].sweep;
    }
    const tdsp_verdict good = verdict_of(&disc, 1, 1.5, legs, 3);
    assert_int_equal(good.problems, 0);
    assert_near(good.min_clearance, 0, 1e-12);
    const tdsp_leg across = arc_between(&disc, 1.5, 2.5, 2); /* the mean rate is too little for the first half */
    const tdsp_verdict bad = verdict_of(&disc, 1, 1.5, &across, 1);
    assert_int_equal(bad.problems, TDSP_PROBLEM_CLEARANCE);
    assert_near(bad.min_clearance, -0.5 * (0.6 - 0.45), 1e-12);
    assert_near(bad.time, 2, 1e-12);
}

/* Passing at distance h at time t, the clearance is least about then; the gap is what is left of h. */
static void a_line_past_a_disc_that_grows_faster_and_faster_is_judged_to_a_millionth(void **state)
{
    (void)state;
    grown disc = {.kind = TDSP_GROWTH_POLYNOMIAL, .radius = 0.1, .values = {0, 0, 0.004}, .count = 3};
    tdsp_leg line = {.disc = TDSP_NO_DISC, .end_time = 10, .from = {-5, 0}, .to = {5, 0}};
    const double least = sampled_clearance(&line, &disc, 10000);
    for (int inside = 0; inside < 2; inside++) {
        disc.center.y = 0; /* found by halving: the height at which the line just touches */
        double low = 0.1, high = 9;
        for (int i = 0; i < 100; i++) {
            disc.center.y = 0.5 * (low + high);
            if (sampled_clearance(&line, &disc, 200) < 0)
                low = disc.center.y;
            else
                high = disc.center.y;
        }
        disc.center.y = high + (inside ? -1e-6 : 1e-6);
        const tdsp_verdict verdict = verdict_of(&disc, 1, 1, &line, 1);
        assert_int_equal(verdict.problems, inside ? TDSP_PROBLEM_CLEARANCE : 0);
        assert_near(verdict.min_clearance, inside ? -1e-6 : 1e-6, 1e-6);
    }
    assert_true(least < 0);
}

static void a_curve_among_discs_of_one_rate_is_verified_too(void **state)
{
    (void)state;
    tdsp_leg legs[RIDE];
    make_ride(&laws[3], 1, legs); /* R = 1 + t / 4 */
    const tdsp_disc discs[2] = {{ride_center, 1, 0.25}, {{6, -1}, 0.1, 0.02}};
    const tdsp_journey journey = {1.5, 0, legs[0].from, legs[RIDE - 1].to};
    for (size_t count = 1; count <= 2; count++) {
        tdsp_scene *scene;
        assert_int_equal(tdsp_scene_create(&journey, discs, count, NULL, &scene), TDSP_OK);
        const tdsp_verdict verdict = verdict_in(scene, legs, RIDE);
        assert_int_equal(verdict.problems, 0);
        assert_near(verdict.min_clearance, 0, 1e-12);
        tdsp_scene_free(scene);
    }
}

static void many_growing_discs_give_what_each_gives_alone(void **state)
{
    (void)state;
    enum { COUNT = 2000 };
    static grown all[COUNT];
    static tdsp_growing_disc discs[COUNT];
    uint64_t chance = 3;
    for (size_t i = 0; i < COUNT; i++) {
        all[i] = random_grown(&chance);
        all[i].center = (tdsp_point){20 * all[i].center.x, 20 * all[i].center.y};
        discs[i] = grown_disc(&all[i]);
    }
    for (int trial = 0; trial < 20; trial++) {
        const tdsp_point from = {chance_between(&chance, -60, 60), chance_between(&chance, -60, 60)};
        const double start = chance_between(&chance, 0, 5);
        const tdsp_leg leg = {
            .disc = TDSP_NO_DISC, .start_time = start, .end_time = start + 1, .from = from, .to = {from.x + 0.6, from.y - 0.8}};
        double expected = INFINITY;
        for (size_t i = 0; i < COUNT; i++) expected = fmin(expected, sampled_clearance(&leg, &all[i], 64));
        const tdsp_journey journey = {1, 0, leg.from, leg.to};
        tdsp_scene *scene;
        assert_int_equal(tdsp_scene_create_growing(&journey, discs, COUNT, NULL, &scene), TDSP_OK);
        assert_near(verdict_in(scene, &leg, 1).min_clearance, expected, 1e-10);
        tdsp_scene_free(scene);
    }
}

static void the_robot_s_radius_counts_where_rates_change(void **state)
{
    (void)state;
    grown disc = {.kind = TDSP_GROWTH_POLYNOMIAL, .radius = 1, .values = {0, 0.01}, .count = 2};
    const tdsp_journey journey = {1, 0.25, {-2, 3}, {2, 3}};
    const tdsp_leg line = {.disc = TDSP_NO_DISC, .end_time = 4, .from = {-2, 3}, .to = {2, 3}};
    tdsp_scene *scene = scene_of(&journey, &disc, 1);
    grown larger = disc;
    larger.radius += 0.25;
    assert_near(verdict_in(scene, &line, 1).min_clearance, sampled_clearance(&line, &larger, 1000), 1e-11);
    tdsp_scene_free(scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_clearance_of_a_line_is_the_sampled_one),
        cmocka_unit_test(the_clearance_of_an_arc_is_the_sampled_one),
        cmocka_unit_test(the_clearance_of_a_curve_is_the_sampled_one),
        cmocka_unit_test(a_ride_on_a_disc_whose_rate_changes_is_accepted_and_touches_it),
        cmocka_unit_test(a_ride_into_the_disc_by_a_millionth_is_rejected),
        cmocka_unit_test(a_ride_moved_earlier_is_accepted_and_moved_later_it_is_not),
        cmocka_unit_test(a_robot_too_slow_for_the_ride_by_a_millionth_is_told_so),
        cmocka_unit_test(a_curve_with_a_wrong_number_is_rejected),
        cmocka_unit_test(a_curve_that_means_nothing_is_found),
        cmocka_unit_test(a_curve_of_absurd_bends_is_too_fast_and_nothing_worse),
        cmocka_unit_test(arcs_on_a_disc_whose_rate_jumps_are_accepted_and_one_across_a_jump_is_not),
        cmocka_unit_test(a_line_past_a_disc_that_grows_faster_and_faster_is_judged_to_a_millionth),
        cmocka_unit_test(a_curve_among_discs_of_one_rate_is_verified_too),
        cmocka_unit_test(many_growing_discs_give_what_each_gives_alone),
        cmocka_unit_test(the_robot_s_radius_counts_where_rates_change),
    };
    return cmocka_run_group_tests_name("verify_growing", tests, NULL, NULL);
}
