/* SPDX-License-Identifier: MIT */
/* The verifier on rides beside a twin of the disc that is ridden: nearly the same centre, nearly the same boundary, touched all the way or not. */
#include "support/cmocka_all.h"

#include <float.h>
#include <math.h>
#include <stdio.h>

#include "support/chance.h"
#include "support/curve.h"
#include "tdsp/growth.h"
#include "tdsp/path.h"
#include "tdsp/verify.h"

#define SEED 8101
#define ROUNDS 300
#define SAMPLES 4000
#define END 5.0

enum { MOST_LEGS = 64 };

typedef struct world {
    curve_law law;
    tdsp_point center, twin;
    double more; /* the twin is larger by */
    tdsp_leg legs[MOST_LEGS];
    size_t count;
} world;

static double twin_clearance(const world *w, const tdsp_leg *leg, double time)
{
    const tdsp_point at = tdsp_leg_position(leg, time);
    return hypot(at.x - w->twin.x, at.y - w->twin.y) - curve_law_at(&w->law, time, 0) - w->more;
}

/* The disc that is ridden is touched all the way, which is a clearance of 0. */
static double sampled_clearance(const world *w)
{
    double least = 0.0;
    for (size_t i = 0; i < w->count; i++)
        for (int k = 0; k <= SAMPLES; k++) {
            const tdsp_leg *leg = &w->legs[i];
            least = fmin(least, twin_clearance(w, leg, leg->start_time + (leg->end_time - leg->start_time) * k / SAMPLES));
        }
    return least;
}

/* Where the law is straight, as discs whose rate is another one from after the ride on, or of one rate for ever. */
static tdsp_scene *scene_of(const world *w, int of_rates)
{
    const tdsp_journey journey = {1.0, 0.0, w->legs[0].from, w->legs[w->count - 1].to};
    const double times[2] = {0.0, 2.0 * END}, rates[2] = {w->law.c[1], 2.0 * w->law.c[1]};
    const tdsp_growth bends = {.kind = TDSP_GROWTH_POLYNOMIAL, .values = w->law.c + 1, .count = 4};
    const tdsp_growth grows = w->law.c[2] > 0.0 ? bends : (tdsp_growth){.kind = TDSP_GROWTH_RATES, .values = rates, .times = times, .count = 2};
    const tdsp_growing_disc growing[2] = {{w->center, w->law.c[0], grows}, {w->twin, w->law.c[0] + w->more, grows}};
    const tdsp_disc plain[2] = {{w->center, w->law.c[0], w->law.c[1]}, {w->twin, w->law.c[0] + w->more, w->law.c[1]}};
    tdsp_scene *scene = NULL;
    assert_int_equal(of_rates ? tdsp_scene_create(&journey, plain, 2, NULL, &scene) : tdsp_scene_create_growing(&journey, growing, 2, NULL, &scene), TDSP_OK);
    return scene;
}

static tdsp_verdict verdict_of(const world *w, int of_rates)
{
    tdsp_scene *scene = scene_of(w, of_rates);
    tdsp_verdict verdict;
    assert_int_equal(tdsp_verify_path(scene, w->legs, w->count, 0.0, END, &verdict), TDSP_OK);
    tdsp_scene_free(scene);
    return verdict;
}

static void ride_as_arc(world *w, double angle, int turn)
{
    const double c = w->law.c[1], to = w->law.c[0] + c * END, sweep = sqrt(1.0 - c * c) * log1p(c * END / w->law.c[0]) / c, left = angle + turn * sweep;
    w->legs[0] = (tdsp_leg){.kind = TDSP_LEG_ARC, .disc = 0, .turn = turn, .end_time = END, .center = w->center, .radius_from = w->law.c[0], .radius_to = to,
                            .angle_from = angle, .sweep = sweep};
    w->legs[0].from = curve_law_place(&w->law, w->center, 0.0, angle);
    w->legs[0].to = curve_law_place(&w->law, w->center, END, left);
    w->count = 1;
}

/* A twin at a distance of 1e-13 to 1e-2, on whose inside the ride begins, or ends, or neither. */
static world random_world(uint64_t *chance, double bend)
{
    world w = {.law = {{chance_between(chance, 0.5, 3.0), chance_between(chance, 0.01, 0.2), bend * chance_between(chance, 0.001, 0.03)}}};
    const double apart = pow(10.0, chance_between(chance, -13.0, -2.0)), direction = chance_between(chance, -4.0, 4.0);
    w.center = (tdsp_point){chance_between(chance, -5.0, 5.0), chance_between(chance, -5.0, 5.0)};
    w.twin = (tdsp_point){w.center.x + apart * cos(direction), w.center.y + apart * sin(direction)};
    w.more = apart * chance_between(chance, -2.0, 2.0);
    const double angle = chance_between(chance, -3.0, 3.0);
    const int turn = chance_below(chance, 2) ? 1 : -1;
    if (bend > 0.0) {
        w.count = MOST_LEGS;
        curve_legs(&w.law, w.center, 1.0, 0.0, END, angle, turn, w.legs, MOST_LEGS);
    } else {
        ride_as_arc(&w, angle, turn);
    }
    return w;
}

/* Told is what was found, sampled or halved; what is judged may be lower by a quarter of the tolerance. */
static void assert_judged(const world *w, int of_rates)
{
    const tdsp_verdict verdict = verdict_of(w, of_rates);
    const double least = sampled_clearance(w), step = END / (double)w->count / SAMPLES;
    const double apart = hypot(w->twin.x - w->center.x, w->twin.y - w->center.y), blur = apart * step * step * 4.0 + 1e-13;
    if (!(verdict.min_clearance <= least + blur && verdict.min_clearance >= least - blur - 0.26 * verdict.tolerance))
        fail_msg("apart %g, larger by %g: least %.17g, told %.17g, tolerance %g", apart, w->more, least, verdict.min_clearance, verdict.tolerance);
    if (least < -1.01 * verdict.tolerance) assert_int_equal(verdict.problems, TDSP_PROBLEM_CLEARANCE);
    if (least > -0.7 * verdict.tolerance) assert_int_equal(verdict.problems, 0);
}

static void a_ride_beside_the_twin_of_its_disc_is_judged_as_sampled(void **state)
{
    (void)state;
    uint64_t chance = SEED;
    print_message("seed %d\n", SEED);
    for (int i = 0; i < ROUNDS; i++) {
        const world w = random_world(&chance, 0.0);
        assert_judged(&w, 0);
        assert_judged(&w, 1);
    }
}

static void a_ride_in_curves_beside_the_twin_of_its_disc_is_judged_as_sampled(void **state)
{
    (void)state;
    uint64_t chance = SEED + 1;
    print_message("seed %d\n", SEED + 1);
    for (int i = 0; i < ROUNDS / 10; i++) {
        const world w = random_world(&chance, 1.0);
        assert_judged(&w, 0);
    }
}

/* Where work was bounded before all of a leg had been looked at, what was left of it counted as far inside. */
static void a_long_ride_that_touches_a_twin_all_the_way_is_accepted(void **state)
{
    (void)state;
    for (double apart = 1e-13; apart < 1e-6; apart *= 10.0) {
        world w = {.law = {{1.0, 0.1}}, .twin = {apart, 0.0}, .more = -apart};
        ride_as_arc(&w, 0.0, 1);
        for (int of_rates = 0; of_rates < 2; of_rates++) {
            const tdsp_verdict verdict = verdict_of(&w, of_rates);
            assert_int_equal(verdict.problems, 0);
            assert_near(verdict.min_clearance, 0.0, 1e-13 + 0.26 * verdict.tolerance);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_ride_beside_the_twin_of_its_disc_is_judged_as_sampled),
        cmocka_unit_test(a_ride_in_curves_beside_the_twin_of_its_disc_is_judged_as_sampled),
        cmocka_unit_test(a_long_ride_that_touches_a_twin_all_the_way_is_accepted),
    };
    return cmocka_run_group_tests_name("verify_around", tests, NULL, NULL);
}
