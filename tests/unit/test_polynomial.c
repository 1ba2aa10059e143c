/* SPDX-License-Identifier: MIT */
/* Roots of polynomials whose roots are known: products of factors. */
#include "support/cmocka_all.h"

#include <float.h>

#include "geom/polynomial.h"
#include "support/chance.h"

#define SEED 20260
#define MOST POLYNOMIAL_DEGREE

static polynomial factor(double root)
{
    polynomial p = {1, {-root, 1.0}};
    return p;
}

static polynomial of_roots(const double *roots, int count)
{
    polynomial p = {0, {1.0}};
    for (int i = 0; i < count; ++i) {
        polynomial f = factor(roots[i]);
        p = polynomial_times(&p, &f);
    }
    return p;
}

/* How far round-off of the coefficients and of Horner's scheme can move a simple root. */
static double uncertainty(const polynomial *p, double root)
{
    polynomial slope = polynomial_derivative(p);
    double size = 0.0;
    for (int k = p->degree; k >= 0; --k) size = size * fabs(root) + fabs(p->c[k]);
    return 8.0 * (p->degree + 1) * DBL_EPSILON * size / fabs(polynomial_value(&slope, root)) + DBL_EPSILON * fabs(root);
}

static void assert_roots(const polynomial *p, double from, double to, const double *expected, int count)
{
    double found[MOST];
    assert_int_equal(polynomial_roots(p, from, to, found), count);
    for (int i = 0; i < count; ++i) assert_near(found[i], expected[i], uncertainty(p, expected[i]));
}

/* `count` roots in (from, to) in order, no two and no end closer than a third of what they would have side by side. */
static void draw_roots(uint64_t *chance, double from, double to, int count, double *roots)
{
    double step = (to - from) / count;
    for (int i = 0; i < count; ++i) roots[i] = from + step * (i + chance_between(chance, 1.0 / 6.0, 5.0 / 6.0));
}

/* A factor without real roots. */
static polynomial draw_lifted(uint64_t *chance)
{
    double at = chance_between(chance, -2.0, 2.0), up = chance_between(chance, 0.05, 2.0);
    polynomial p = {2, {at * at + up, -2.0 * at, 1.0}};
    return p;
}

static void every_root_of_a_product_is_found(void **state)
{
    (void)state;
    uint64_t chance = SEED;
    print_message("seed %d\n", SEED);
    for (int k = 0; k < 20000; ++k) {
        double roots[MOST];
        int count = (int)chance_below(&chance, 9), lifted = (int)chance_below(&chance, 4);
        draw_roots(&chance, -1.0, 1.0, count, roots);
        polynomial p = of_roots(roots, count);
        for (int i = 0; i < lifted; ++i) {
            polynomial f = draw_lifted(&chance);
            p = polynomial_times(&p, &f);
        }
        assert_roots(&p, -1.0, 1.0, roots, count);
        if (count) assert_roots(&p, -1.0, roots[count - 1] - 1e-3, roots, count - 1);
        if (count) assert_roots(&p, roots[0] + 1e-3, 1.0, roots + 1, count - 1);
    }
}

static void wilkinsons_roots_are_all_found(void **state)
{
    (void)state;
    double roots[MOST];
    for (int count = 1; count <= MOST; ++count) {
        for (int i = 0; i < count; ++i) roots[i] = i + 1.0;
        polynomial p = of_roots(roots, count);
        assert_roots(&p, 0.0, count + 1.0, roots, count);
    }
}

static void roots_in_a_cluster_are_told_apart(void **state)
{
    (void)state;
    for (int count = 2; count <= 5; ++count)
        for (double apart = 1e-1; apart > 1e-9; apart *= 0.1) {
            double roots[MOST];
            for (int i = 0; i < count; ++i) roots[i] = apart * (i + 0.3);
            roots[count] = 0.77;
            polynomial p = of_roots(roots, count + 1);
            assert_roots(&p, 0.0, 1.0, roots, count + 1);
        }
}

static void a_root_of_odd_order_is_found_and_one_of_even_order_changes_nothing(void **state)
{
    (void)state;
    for (int order = 1; order <= 9; ++order) {
        double roots[MOST], found[MOST], away = pow(256.0 * DBL_EPSILON, 1.0 / order);
        for (int i = 0; i < order; ++i) roots[i] = 0.3;
        polynomial p = of_roots(roots, order);
        int count = polynomial_roots(&p, 0.0, 1.0, found);
        assert_int_equal(count % 2, order % 2);
        for (int i = 0; i < count; ++i) assert_near(found[i], 0.3, away);
    }
}

static void a_root_where_the_interval_is_halved_is_found_once(void **state)
{
    (void)state;
    const double roots[] = {0.125, 0.25, 0.375, 0.5, 0.75, 0.875};
    for (int mask = 1; mask < 64; ++mask) {
        double some[6];
        int count = 0;
        for (int i = 0; i < 6; ++i)
            if (mask >> i & 1) some[count++] = roots[i];
        polynomial p = of_roots(some, count);
        assert_roots(&p, 0.0, 1.0, some, count);
        assert_roots(&p, -1.0, 1.0, some, count);
        assert_roots(&p, -7.0, 9.0, some, count);
    }
}

static void zeros_at_the_ends_are_no_changes(void **state)
{
    (void)state;
    const double roots[] = {0.0, 0.375, 1.0}; /* exact coefficients: else the last root may fall inside */
    polynomial p = of_roots(roots, 3);
    assert_roots(&p, 0.0, 1.0, roots + 1, 1);
}

static void neither_scale_nor_unit_moves_a_root(void **state)
{
    (void)state;
    const double roots[] = {0.11, 0.3, 0.31, 0.8};
    polynomial p = of_roots(roots, 4);
    for (int unit = -60; unit <= 60; unit += 7)
        for (int power = -700; power <= 700; power += 100) {
            polynomial scaled = p;
            double expected[4];
            for (int k = 0; k <= 4; ++k) scaled.c[k] = ldexp(p.c[k], power - k * unit);
            for (int i = 0; i < 4; ++i) expected[i] = ldexp(roots[i], unit);
            assert_roots(&scaled, 0.0, ldexp(1.0, unit), expected, 4);
        }
}

static void a_root_near_zero_in_a_wide_interval_is_found(void **state)
{
    (void)state;
    double found[MOST];
    for (double near = 1e-2; near > 1e-15; near *= 0.1) {
        const double roots[] = {near, 0.5};
        polynomial p = of_roots(roots, 2);
        assert_roots(&p, 0.0, 1.0, roots, 2);
    }
    polynomial line = factor(1e-300);
    assert_int_equal(polynomial_roots(&line, 0.0, 1e300, found), 1);
    assert_true(found[0] >= 0.0 && found[0] <= 1e280);
}

static void the_first_root_is_found_at_any_distance_and_beside_any_other(void **state)
{
    (void)state;
    for (int near = -200; near <= 200; near += 8)
        for (int apart = 1; apart <= 300; apart += 13) {
            const double roots[] = {0.75, 0.75 * ldexp(1.0, apart)};
            polynomial p = of_roots(roots, 2);
            for (int k = 0; k <= 2; ++k) p.c[k] = ldexp(p.c[k], -near * k);
            assert_near(polynomial_first_root(&p), ldexp(0.75, near), ldexp(1e-15, near));
        }
    for (int power = -100; power <= 100; ++power) { /* where two intervals meet */
        const double roots[] = {ldexp(1.0, power), ldexp(3.0, power)};
        polynomial p = of_roots(roots, 2);
        assert_exact(polynomial_first_root(&p), roots[0]);
    }
}

static void a_first_root_counts_only_over_zero_and_where_the_sign_changes(void **state)
{
    (void)state;
    const double roots[] = {-3.0, -1.0, 0.0, 0.5, 0.5, 2.0};
    polynomial p = of_roots(roots, 6), none = of_roots(roots, 3), touch = of_roots(roots, 5), power = {5, {0.0, 0.0, 0.0, 0.0, 0.0, 2.0}}, zero = {3, {0.0}};
    double first = polynomial_first_root(&p);
    assert_true(fabs(first - 2.0) < 1e-14 || fabs(first - 0.5) < 1e-7);
    assert_exact(polynomial_first_root(&none), INFINITY);
    assert_true(isinf(polynomial_first_root(&touch)) || fabs(polynomial_first_root(&touch) - 0.5) < 1e-7);
    assert_exact(polynomial_first_root(&power), INFINITY);
    assert_exact(polynomial_first_root(&zero), INFINITY);
}

/* Intervals for the first root end at powers of two: here at 512, and at 32, where the middle of the interval before is a root of order 2. */
static void a_first_root_where_two_intervals_meet_is_found_whatever_stands_before(void **state)
{
    (void)state;
    const polynomial simple = {3, {-512.0, 1.0, -512.0, 1.0}}, doubled = {5, {-9248.0, 1377.0, -9314.0, 1378.0, -66.0, 1.0}};
    assert_exact(polynomial_first_root(&simple), 512.0);
    assert_exact(polynomial_first_root(&doubled), 32.0);
}

static void a_first_root_beyond_all_doubles_is_none(void **state)
{
    (void)state;
    const polynomial far = {1, {-1e300, 1e-300}}, near = {1, {-1e-300, 1e300}};
    assert_exact(polynomial_first_root(&far), INFINITY);
    assert_exact(polynomial_first_root(&near), INFINITY);
}

/* Beside 3, a third of it rounds to 1. */
static void nothing_is_found_where_a_line_rounds_to_zero_all_the_way(void **state)
{
    (void)state;
    const polynomial line = {1, {-1.0, 1.0 / 3.0}};
    double found[MOST];
    assert_int_equal(polynomial_roots(&line, 3.0, nextafter(3.0, 4.0), found), 0);
}

/* (3 x - 1)^2 in exact numbers: halving never tells its two roots apart. */
static void a_double_root_that_no_halving_meets_is_given_up_in_the_end(void **state)
{
    (void)state;
    const polynomial p = {2, {1.0, -6.0, 9.0}};
    double found[MOST];
    int count = polynomial_roots(&p, 0.0, 1.0, found);
    assert_true(count == 0 || count == 2);
    for (int i = 0; i < count; ++i) assert_near(found[i], 1.0 / 3.0, 1e-7);
}

static void leading_zeros_do_not_matter(void **state)
{
    (void)state;
    const double roots[] = {0.25, 0.6};
    polynomial p = of_roots(roots, 2);
    double least = polynomial_least(&p, 0.5, 0.7);
    p.degree = MOST;
    assert_roots(&p, 0.0, 1.0, roots, 2);
    assert_exact(polynomial_least(&p, 0.5, 0.7), least);
}

static void nothing_is_found_where_there_is_nothing(void **state)
{
    (void)state;
    double found[MOST];
    polynomial zero = {4, {0.0}}, one = {3, {1.0}}, line = factor(0.5);
    assert_int_equal(polynomial_roots(&zero, 0.0, 1.0, found), 0);
    assert_int_equal(polynomial_roots(&one, 0.0, 1.0, found), 0);
    assert_int_equal(polynomial_roots(&line, 1.0, 0.0, found), 0);
    assert_int_equal(polynomial_roots(&line, 0.5, 0.5, found), 0);
    assert_int_equal(polynomial_roots(&line, NAN, 1.0, found), 0);
    assert_exact(polynomial_least(&zero, 0.0, 1.0), 0.0);
}

static void the_least_is_a_bound_and_a_tight_one_on_short_intervals(void **state)
{
    (void)state;
    uint64_t chance = SEED + 1;
    for (int k = 0; k < 3000; ++k) {
        polynomial p = {(int)chance_below(&chance, MOST + 1), {0.0}};
        for (int i = 0; i <= p.degree; ++i) p.c[i] = chance_between(&chance, -1.0, 1.0);
        double from = chance_between(&chance, -1.5, 1.5), width = pow(10.0, chance_between(&chance, -6.0, 0.0)), sampled = INFINITY, size = 0.0;
        for (int i = 0; i <= 100; ++i) sampled = fmin(sampled, polynomial_value(&p, from + width * i / 100.0));
        for (int i = p.degree; i >= 0; --i) size = size * (fabs(from) + width) + fabs(p.c[i]);
        double least = polynomial_least(&p, from, from + width);
        assert_true(least <= sampled);
        if (width < 1e-4) assert_near(least, sampled, 1e3 * size * width * width + 1e-12 * size + 0.05 * width * p.degree * size);
    }
}

static void products_and_derivatives_agree_with_values(void **state)
{
    (void)state;
    uint64_t chance = SEED + 2;
    for (int k = 0; k < 1000; ++k) {
        polynomial p = {(int)chance_below(&chance, 10), {0.0}}, q = {(int)chance_below(&chance, 9), {0.0}};
        for (int i = 0; i <= p.degree; ++i) p.c[i] = chance_between(&chance, -1.0, 1.0);
        for (int i = 0; i <= q.degree; ++i) q.c[i] = chance_between(&chance, -1.0, 1.0);
        double x = chance_between(&chance, -1.0, 1.0), h = 1e-6;
        polynomial product = polynomial_times(&p, &q), slope = polynomial_derivative(&p);
        assert_near(polynomial_value(&product, x), polynomial_value(&p, x) * polynomial_value(&q, x), 1e-13);
        assert_near(polynomial_value(&slope, x), (polynomial_value(&p, x + h) - polynomial_value(&p, x - h)) / (2.0 * h), 1e-8);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_root_of_a_product_is_found),
        cmocka_unit_test(wilkinsons_roots_are_all_found),
        cmocka_unit_test(roots_in_a_cluster_are_told_apart),
        cmocka_unit_test(a_root_of_odd_order_is_found_and_one_of_even_order_changes_nothing),
        cmocka_unit_test(a_root_where_the_interval_is_halved_is_found_once),
        cmocka_unit_test(zeros_at_the_ends_are_no_changes),
        cmocka_unit_test(neither_scale_nor_unit_moves_a_root),
        cmocka_unit_test(a_root_near_zero_in_a_wide_interval_is_found),
        cmocka_unit_test(the_first_root_is_found_at_any_distance_and_beside_any_other),
        cmocka_unit_test(a_first_root_counts_only_over_zero_and_where_the_sign_changes),
        cmocka_unit_test(a_first_root_where_two_intervals_meet_is_found_whatever_stands_before),
        cmocka_unit_test(a_first_root_beyond_all_doubles_is_none),
        cmocka_unit_test(nothing_is_found_where_a_line_rounds_to_zero_all_the_way),
        cmocka_unit_test(a_double_root_that_no_halving_meets_is_given_up_in_the_end),
        cmocka_unit_test(leading_zeros_do_not_matter),
        cmocka_unit_test(nothing_is_found_where_there_is_nothing),
        cmocka_unit_test(the_least_is_a_bound_and_a_tight_one_on_short_intervals),
        cmocka_unit_test(products_and_derivatives_agree_with_values),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
