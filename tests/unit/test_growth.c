/* SPDX-License-Identifier: MIT */
/* Growth given as numbers: what is refused, the pieces, where a radius shrinks, covers, the hash. */
#include "support/cmocka_all.h"

#include <string.h>

#include "scene/scene.h"
#include "support/chance.h"
#include "tdsp/growth.h"
#include "tdsp/solver.h"

#define SEED 20262

static const tdsp_journey journey = {2.0, 0.25, {-3.0, 1.0}, {5.0, -2.0}};

static tdsp_growing_disc polynomial_disc(const double *values, size_t count)
{
    tdsp_growing_disc disc = {{1.0, 2.0}, 0.5, {TDSP_GROWTH_POLYNOMIAL, 0.0, count, values, NULL, NULL, NULL, 0.0}};
    return disc;
}

static tdsp_growing_disc rates_disc(const double *times, const double *rates, size_t count)
{
    tdsp_growing_disc disc = {{1.0, 2.0}, 0.5, {TDSP_GROWTH_RATES, 0.0, count, rates, times, NULL, NULL, 0.0}};
    return disc;
}

static tdsp_growing_disc rate_disc(double rate)
{
    tdsp_growing_disc disc = {{1.0, 2.0}, 0.5, {TDSP_GROWTH_RATE, rate, 0, NULL, NULL, NULL, NULL, 0.0}};
    return disc;
}

static tdsp_scene *scene_of(tdsp_growing_disc disc)
{
    tdsp_scene *scene;
    assert_null(tdsp_growing_disc_check(&disc));
    assert_int_equal(tdsp_scene_create_growing(&journey, &disc, 1, NULL, &scene), TDSP_OK);
    return scene;
}

static void assert_refused(tdsp_growing_disc disc, const char *word)
{
    tdsp_scene *untouched = (tdsp_scene *)&untouched, *scene = untouched;
    const tdsp_growing_disc discs[2] = {rate_disc(0.1), disc};
    const char *text = tdsp_growing_disc_check(&disc);
    if (!text || !strstr(text, word)) fail_msg("%s: %s", word, text ? text : "nothing is wrong");
    assert_int_equal(tdsp_scene_create_growing(&journey, discs, 2, NULL, &scene), TDSP_BAD_SCENE);
    assert_ptr_equal(scene, untouched);
}

static void numbers_out_of_their_range_are_refused(void **state)
{
    (void)state;
    static const double never[] = {NAN, INFINITY, -INFINITY, 1.1e100, -1.1e100};
    const double start[2] = {0.0, 1.0}, some[2] = {0.1, 0.2};
    for (size_t i = 0; i < 5; ++i) {
        const double values[2] = {0.1, never[i]}, times[2] = {0.0, never[i]};
        tdsp_growing_disc disc = rate_disc(0.1);
        disc.center.y = never[i];
        assert_refused(disc, "centre");
        disc = rate_disc(0.1);
        disc.center.x = never[i];
        assert_refused(disc, "centre");
        disc = rate_disc(0.1);
        disc.radius = never[i];
        assert_refused(disc, "radius");
        assert_refused(rate_disc(never[i]), "growth");
        assert_refused(polynomial_disc(values, 2), "coefficient");
        assert_refused(rates_disc(start, values, 2), "rate");
        assert_refused(rates_disc(times, some, 2), "time");
    }
    assert_refused(rate_disc(-1e-9), "growth");
}

static void growth_of_the_wrong_shape_is_refused(void **state)
{
    (void)state;
    const double values[9] = {0.1, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.1};
    const double late[2] = {1.0, 2.0}, back[3] = {0.0, 2.0, 2.0}, start[2] = {0.0, 1.0}, falling[2] = {0.1, -0.1};
    tdsp_growing_disc odd = rate_disc(0.1);
    odd.growth.kind = (tdsp_growth_kind)7;
    assert_refused(odd, "kind");
    assert_refused(polynomial_disc(values, 0), "1 to 8");
    assert_refused(polynomial_disc(values, 9), "1 to 8");
    assert_refused(polynomial_disc(NULL, 2), "1 to 8");
    assert_refused(rates_disc(late, values, 2), "first time");
    assert_refused(rates_disc(back, values, 3), "increase");
    assert_refused(rates_disc(start, falling, 2), "rate");
    assert_refused(rates_disc(start, NULL, 2), "no rates");
    assert_refused(rates_disc(NULL, values, 2), "no times");
    assert_refused(rates_disc(start, values, 0), "no rates");
    assert_refused(rates_disc(start, values, (size_t)0x80000000u), "no rates");
}

static void missing_arguments_are_refused(void **state)
{
    (void)state;
    tdsp_growing_disc disc = rate_disc(0.1);
    tdsp_journey bad = journey;
    tdsp_scene *scene;
    bad.speed = 0.0;
    assert_int_equal(tdsp_scene_create_growing(NULL, &disc, 1, NULL, &scene), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_scene_create_growing(&journey, NULL, 1, NULL, &scene), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_scene_create_growing(&journey, &disc, 1, NULL, NULL), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_scene_create_growing(&journey, &disc, 0x80000000u, NULL, &scene), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_scene_create_growing(&bad, &disc, 1, NULL, &scene), TDSP_BAD_SCENE);
}

static void a_polynomial_that_sinks_at_once_is_refused(void **state)
{
    (void)state;
    const double first[1] = {-0.1}, third[4] = {0.0, 0.0, -1e-9, 5.0};
    assert_refused(polynomial_disc(first, 1), "shrinks from t = 0");
    assert_refused(polynomial_disc(third, 4), "shrinks from t = 0");
}

static void whatever_comes_down_to_one_rate_is_the_same_scene(void **state)
{
    (void)state;
    const double line[3] = {0.1, 0.0, 0.0}, times[3] = {0.0, 1.0, 2.0}, rates[3] = {0.1, 0.1, 0.1};
    const tdsp_growing_disc discs[3] = {rate_disc(0.1), polynomial_disc(line, 3), rates_disc(times, rates, 3)};
    const tdsp_disc plain = {{1.0, 2.0}, 0.5, 0.1};
    tdsp_scene *expected;
    assert_int_equal(tdsp_scene_create(&journey, &plain, 1, NULL, &expected), TDSP_OK);
    for (int k = 0; k < 3; ++k) {
        double radius, rate;
        tdsp_scene *scene = scene_of(discs[k]);
        assert_true(tdsp_scene_has_rates_only(scene));
        assert_true(tdsp_scene_hash(scene) == tdsp_scene_hash(expected));
        assert_memory_equal(tdsp_scene_discs(scene, NULL), &plain, sizeof plain);
        assert_memory_equal(scene->all.forward, expected->all.forward, sizeof *expected->all.forward);
        assert_exact(tdsp_scene_source_free_until(scene, NULL), tdsp_scene_source_free_until(expected, NULL));
        assert_exact(tdsp_scene_valid_until(scene, NULL), INFINITY);
        assert_int_equal(tdsp_scene_disc_at(scene, 0, 3.0, &radius, &rate), TDSP_OK);
        assert_exact(radius, 0.5 + 0.1 * 3.0);
        assert_exact(rate, 0.1);
        tdsp_scene_free(scene);
    }
    tdsp_scene_free(expected);
}

static void assert_disc_at(const tdsp_scene *scene, double time, double radius, double rate)
{
    double found_radius, found_rate;
    assert_int_equal(tdsp_scene_disc_at(scene, 0, time, &found_radius, &found_rate), TDSP_OK);
    assert_near(found_radius, radius, 1e-14 * (1.0 + radius));
    assert_near(found_rate, rate, 1e-14 * (1.0 + rate));
}

static void a_polynomial_has_its_values_at_any_time(void **state)
{
    (void)state;
    const double values[4] = {0.1, 0.0, 0.2, 0.0};
    tdsp_scene *scene = scene_of(polynomial_disc(values, 4));
    uint32_t disc = 5;
    assert_false(tdsp_scene_has_rates_only(scene));
    assert_int_equal(scene_law(scene, 0).count, 1);
    assert_int_equal(scene_law(scene, 0).pieces->degree, 3);
    assert_exact(tdsp_scene_discs(scene, NULL)->growth, 0.1);
    assert_exact(tdsp_scene_valid_until(scene, &disc), INFINITY);
    assert_int_equal(disc, TDSP_NO_DISC);
    for (double t = 0.0; t < 20.0; t += 0.37) assert_disc_at(scene, t, 0.5 + 0.1 * t + 0.2 * t * t * t, 0.1 + 0.6 * t * t);
    tdsp_scene_free(scene);
}

static void rates_hold_from_their_times_on(void **state)
{
    (void)state;
    const double times[5] = {0.0, 1.0, 2.0, 5.0, 6.0}, rates[5] = {0.5, 0.5, 0.0, 2.0, 0.25};
    tdsp_scene *scene = scene_of(rates_disc(times, rates, 5));
    assert_int_equal(scene_law(scene, 0).count, 4);
    assert_disc_at(scene, 0.0, 0.5, 0.5);
    assert_disc_at(scene, 1.5, 1.25, 0.5);
    assert_disc_at(scene, 2.0, 1.5, 0.0);
    assert_disc_at(scene, 4.9, 1.5, 0.0);
    assert_disc_at(scene, 5.0, 1.5, 2.0);
    assert_disc_at(scene, 8.0, 4.0, 0.25);
    tdsp_scene_free(scene);
}

static void a_disc_is_asked_at_a_time_in_range(void **state)
{
    (void)state;
    const double values[2] = {0.1, 0.2};
    double radius;
    tdsp_scene *scene = scene_of(polynomial_disc(values, 2));
    assert_int_equal(tdsp_scene_disc_at(NULL, 0, 0.0, &radius, NULL), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_scene_disc_at(scene, 1, 0.0, &radius, NULL), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_scene_disc_at(scene, 0, -1e-300, &radius, NULL), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_scene_disc_at(scene, 0, INFINITY, &radius, NULL), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_scene_disc_at(scene, 0, NAN, &radius, NULL), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_scene_disc_at(scene, 0, 1.0, NULL, NULL), TDSP_OK);
    tdsp_scene_free(scene);
}

/* Coefficients of a polynomial whose derivative is `scale` times a product of (1 - t / root) and of quadratics that stay over 0. */
static size_t values_of_rate(const double *roots, int count, uint64_t *chance, int lifted, double scale, double *values)
{
    polynomial rate = {0, {scale}};
    for (int i = 0; i < count; ++i) {
        polynomial f = {1, {1.0, -1.0 / roots[i]}};
        rate = polynomial_times(&rate, &f);
    }
    for (int i = 0; i < lifted; ++i) {
        double at = chance_between(chance, -2.0, 2.0), up = chance_between(chance, 0.05, 2.0);
        polynomial f = {2, {1.0, -2.0 * at / (at * at + up), 1.0 / (at * at + up)}};
        rate = polynomial_times(&rate, &f);
    }
    for (int k = 0; k <= rate.degree; ++k) values[k] = rate.c[k] / (k + 1);
    return (size_t)rate.degree + 1;
}

static void the_moment_from_which_a_radius_shrinks_is_found_at_any_scale(void **state)
{
    (void)state;
    uint64_t chance = SEED;
    print_message("seed %d\n", SEED);
    for (int k = 0; k < 3000; ++k) {
        double values[8], roots[3], unit = pow(10.0, chance_between(&chance, -9.0, 9.0)), radius, rate;
        int count = 1 + (int)chance_below(&chance, 3), lifted = (int)chance_below(&chance, 3);
        for (int i = 0; i < count; ++i)
            roots[i] = (i + chance_between(&chance, 0.2, 0.8)) * (i == 1 ? pow(10.0, chance_between(&chance, 0.0, 9.0)) : 1.0);
        if (count == 3) roots[2] = roots[1] * 2.0;
        size_t length = values_of_rate(roots, count, &chance, lifted, chance_between(&chance, 0.1, 3.0), values);
        for (size_t i = 0; i < length; ++i) values[i] *= pow(unit, -1.0 - (double)i);
        uint32_t disc;
        tdsp_scene *scene = scene_of(polynomial_disc(values, length));
        double expected = roots[0] * unit, found = tdsp_scene_valid_until(scene, &disc);
        assert_int_equal(disc, 0);
        assert_near(found, expected, 1e-12 * expected);
        assert_int_equal(tdsp_scene_disc_at(scene, 0, 1.5 * found, &radius, &rate), TDSP_OK);
        assert_exact(rate, 0.0);
        assert_exact(radius, law_piece_jet(scene->pieces, found).radius);
        tdsp_scene_free(scene);
    }
}

static void a_rate_that_touches_zero_does_not_shrink(void **state)
{
    (void)state;
    uint64_t chance = SEED + 1;
    for (int k = 0; k < 3000; ++k) {
        double values[8], roots[4], unit = pow(10.0, chance_between(&chance, -6.0, 6.0));
        int touches = 1 + (int)chance_below(&chance, 2);
        for (int i = 0; i < touches; ++i) roots[2 * i] = roots[2 * i + 1] = i + chance_between(&chance, 0.1, 0.9);
        size_t length =
            values_of_rate(roots, 2 * touches, &chance, (int)chance_below(&chance, 2), chance_between(&chance, 0.1, 3.0), values);
        for (size_t i = 0; i < length; ++i) values[i] *= pow(unit, -1.0 - (double)i);
        tdsp_scene *scene = scene_of(polynomial_disc(values, length));
        assert_exact(tdsp_scene_valid_until(scene, NULL), INFINITY);
        tdsp_scene_free(scene);
    }
}

static void the_first_disc_to_shrink_is_named(void **state)
{
    (void)state;
    const double late[2] = {1.0, -0.001}, soon[2] = {1.0, -0.005};
    const tdsp_growing_disc discs[4] = {rate_disc(1.0), polynomial_disc(late, 2), polynomial_disc(soon, 2),
                                        polynomial_disc(late, 2)};
    tdsp_scene *scene;
    uint32_t disc;
    assert_int_equal(tdsp_scene_create_growing(&journey, discs, 4, NULL, &scene), TDSP_OK);
    assert_near(tdsp_scene_valid_until(scene, &disc), 100.0, 1e-12);
    assert_int_equal(disc, 2);
    tdsp_scene_free(scene);
}

/* The last moment before a place is inside of a disc, by halving; -1 for none. */
static double halved_cover(const tdsp_scene *scene, size_t count, tdsp_point place)
{
    double least = INFINITY;
    for (uint32_t i = 0; i < count; ++i) {
        double lo = 0.0, hi = 1e6, radius, gap = point_distance(place, tdsp_scene_discs(scene, NULL)[i].center) - journey.radius;
        (void)tdsp_scene_disc_at(scene, i, lo, &radius, NULL);
        if (radius > gap) return -1.0;
        (void)tdsp_scene_disc_at(scene, i, hi, &radius, NULL);
        if (radius <= gap) continue;
        for (int k = 0; k < 120; ++k) {
            double middle = 0.5 * (lo + hi);
            (void)tdsp_scene_disc_at(scene, i, middle, &radius, NULL);
            *(radius <= gap ? &lo : &hi) = middle;
        }
        least = fmin(least, lo);
    }
    return least;
}

/* Where a place is covered from the start, any negative time says so. */
static void assert_covered(double found, double expected)
{
    assert_int_equal(found < 0.0, expected < 0.0);
    if (expected >= 0.0) assert_near(found, expected, 1e-12 * (1.0 + expected));
}

static void the_ends_are_covered_when_halving_says_so(void **state)
{
    (void)state;
    uint64_t chance = SEED + 2;
    const double times[3] = {0.0, 1.0, 2.5};
    for (int k = 0; k < 2000; ++k) {
        tdsp_growing_disc discs[5];
        double values[5][8];
        tdsp_scene *scene;
        for (int i = 0; i < 5; ++i) {
            for (int m = 0; m < 8; ++m) values[i][m] = chance_below(&chance, 2) ? chance_between(&chance, 0.0, 0.3) : 0.0;
            uint64_t kind = chance_below(&chance, 3);
            discs[i] = kind == 0   ? rate_disc(values[i][0])
                       : kind == 1 ? rates_disc(times, values[i], 3)
                                   : polynomial_disc(values[i], 1 + chance_below(&chance, 8));
            discs[i].center = point_make(chance_between(&chance, -9.0, 9.0), chance_between(&chance, -9.0, 9.0));
            discs[i].radius = chance_between(&chance, 0.0, 2.0);
        }
        assert_int_equal(tdsp_scene_create_growing(&journey, discs, 5, NULL, &scene), TDSP_OK);
        double source = halved_cover(scene, 5, journey.source), destination = halved_cover(scene, 5, journey.destination);
        uint32_t disc;
        assert_covered(tdsp_scene_source_free_until(scene, &disc), source);
        assert_int_equal(disc == TDSP_NO_DISC, isinf(source));
        assert_covered(tdsp_scene_destination_free_until(scene, NULL), destination);
        tdsp_scene_free(scene);
    }
}

static uint64_t hash_of(tdsp_growing_disc disc)
{
    tdsp_scene *scene = scene_of(disc);
    uint64_t hash = tdsp_scene_hash(scene);
    tdsp_scene_free(scene);
    return hash;
}

static void every_number_of_a_growth_is_in_the_hash(void **state)
{
    (void)state;
    double values[3] = {0.1, 0.2, 0.3}, times[3] = {0.0, 1.0, 2.0};
    uint64_t seen[16];
    size_t count = 0;
    seen[count++] = hash_of(polynomial_disc(values, 3));
    seen[count++] = hash_of(polynomial_disc(values, 2));
    seen[count++] = hash_of(rates_disc(times, values, 3));
    seen[count++] = hash_of(rates_disc(times, values, 2));
    for (int k = 0; k < 3; ++k) {
        values[k] += 0.01;
        seen[count++] = hash_of(polynomial_disc(values, 3));
        seen[count++] = hash_of(rates_disc(times, values, 3));
        if (k > 0) times[k] += 0.01;
        if (k > 0) seen[count++] = hash_of(rates_disc(times, values, 3));
    }
    for (size_t i = 0; i < count; ++i)
        for (size_t k = 0; k < i; ++k) assert_true(seen[i] != seen[k]);
}

static void a_scene_of_pieces_is_framed_but_not_indexed(void **state)
{
    (void)state;
    const double values[2] = {0.1, 0.2};
    tdsp_scene *scene = scene_of(polynomial_disc(values, 2));
    tdsp_solver *solver;
    assert_near(scene->length, hypot(8.0, 3.0), 1e-14);
    assert_int_equal(scene->all.count, 0);
    assert_false(scene_is_still(scene));
    assert_int_equal(tdsp_solver_create_for(scene, TDSP_METHOD_DIFFERENT_SPEEDS, &solver), TDSP_NOT_SUPPORTED);
    assert_int_equal(tdsp_solver_create(scene, &solver), TDSP_OK);
    assert_int_equal(tdsp_solver_method(solver), TDSP_METHOD_GENERAL);
    tdsp_solver_free(solver);
    tdsp_scene_free(scene);
}

static void the_largest_numbers_allowed_make_a_scene(void **state)
{
    (void)state;
    const double values[8] = {1e100, -1e100, 1e100, 1e100, 1e100, 1e100, 1e100, 1e100}, tiny[2] = {1e-100, 1e-300};
    double radius;
    tdsp_scene *scene = scene_of(polynomial_disc(values, 8));
    assert_true(tdsp_scene_valid_until(scene, NULL) > 0.0);
    tdsp_scene_free(scene);
    scene = scene_of(polynomial_disc(tiny, 2));
    assert_exact(tdsp_scene_valid_until(scene, NULL), INFINITY);
    assert_true(isfinite(tdsp_scene_source_free_until(scene, NULL)));
    assert_int_equal(tdsp_scene_disc_at(scene, 0, 1e300, &radius, NULL), TDSP_OK);
    assert_true(radius > 1e100);
    tdsp_scene_free(scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(numbers_out_of_their_range_are_refused),
        cmocka_unit_test(growth_of_the_wrong_shape_is_refused),
        cmocka_unit_test(missing_arguments_are_refused),
        cmocka_unit_test(a_polynomial_that_sinks_at_once_is_refused),
        cmocka_unit_test(whatever_comes_down_to_one_rate_is_the_same_scene),
        cmocka_unit_test(a_polynomial_has_its_values_at_any_time),
        cmocka_unit_test(rates_hold_from_their_times_on),
        cmocka_unit_test(a_disc_is_asked_at_a_time_in_range),
        cmocka_unit_test(the_moment_from_which_a_radius_shrinks_is_found_at_any_scale),
        cmocka_unit_test(a_rate_that_touches_zero_does_not_shrink),
        cmocka_unit_test(the_first_disc_to_shrink_is_named),
        cmocka_unit_test(the_ends_are_covered_when_halving_says_so),
        cmocka_unit_test(every_number_of_a_growth_is_in_the_hash),
        cmocka_unit_test(a_scene_of_pieces_is_framed_but_not_indexed),
        cmocka_unit_test(the_largest_numbers_allowed_make_a_scene),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
