/* SPDX-License-Identifier: MIT */
/* Polynomials by Bernstein coefficients, against their powers. */
#include "support/cmocka_all.h"

#include "support/chance.h"
#include "verify/bernstein.h"

typedef struct powers {
    int degree;
    double c[BERNSTEIN_DEGREE + 1];
} powers;

static powers random_powers(uint64_t *chance, int most)
{
    powers p = {(int)chance_below(chance, (size_t)most + 1), {0}};
    for (int k = 0; k <= p.degree; k++) p.c[k] = chance_between(chance, -1, 1);
    return p;
}

static double value_of(const powers *p, double u)
{
    long double sum = 0;
    for (int k = p->degree; k >= 0; k--) sum = sum * u + p->c[k];
    return (double)sum;
}

static bernstein over(const powers *p, double from, double to)
{
    return bernstein_of_powers(p->c, p->degree, from, to);
}

static void a_polynomial_has_the_same_values_over_any_interval(void **state)
{
    (void)state;
    uint64_t chance = 1;
    for (int i = 0; i < 500; i++) {
        const powers p = random_powers(&chance, BERNSTEIN_DEGREE);
        const double from = chance_unit(&chance), to = chance_between(&chance, from, 1.2);
        const bernstein b = over(&p, from, to);
        assert_int_equal(b.degree, p.degree);
        for (double x = 0; x <= 1; x += 0.125) assert_near(bernstein_value(&b, x), value_of(&p, from + x * (to - from)), 1e-12);
    }
}

static void parts_halves_and_slopes_are_those_of_the_powers(void **state)
{
    (void)state;
    uint64_t chance = 2;
    for (int i = 0; i < 500; i++) {
        const powers p = random_powers(&chance, 8);
        const bernstein whole = over(&p, -1, 2);
        const double from = chance_unit(&chance), to = chance_between(&chance, from, 1);
        const bernstein part = bernstein_part(&whole, from, to), slope = bernstein_slope(&whole);
        bernstein low, high;
        bernstein_halve(&whole, &low, &high);
        for (double x = 0; x <= 1; x += 0.125) {
            const double h = 1e-5, u = 3 * x - 1;
            assert_near(bernstein_value(&part, x), value_of(&p, 3 * (from + x * (to - from)) - 1), 1e-11);
            assert_near(bernstein_value(&low, x), value_of(&p, 1.5 * x - 1), 1e-11);
            assert_near(bernstein_value(&high, x), value_of(&p, 1.5 * x + 0.5), 1e-11);
            assert_near(bernstein_value(&slope, x), 3 * (value_of(&p, u + h) - value_of(&p, u - h)) / (2 * h), 1e-5);
        }
    }
}

static void parts_at_the_ends_are_the_ends(void **state)
{
    (void)state;
    const powers p = {3, {1, -2, 0.5, 4}};
    const bernstein whole = over(&p, 0, 1);
    const bernstein first = bernstein_part(&whole, 0, 0), last = bernstein_part(&whole, 1, 1), all = bernstein_part(&whole, 0, 1);
    for (int k = 0; k <= 3; k++) {
        assert_exact(first.b[k], 1.0);
        assert_near(last.b[k], 3.5, 1e-15);
        assert_exact(all.b[k], whole.b[k]);
    }
}

static void sums_and_products_are_those_of_the_values(void **state)
{
    (void)state;
    uint64_t chance = 3;
    for (int i = 0; i < 500; i++) {
        const powers p = random_powers(&chance, 9), q = random_powers(&chance, 9);
        const bernstein a = over(&p, 0, 1), b = over(&q, 0, 1);
        const bernstein sum = bernstein_sum(&a, &b), less = bernstein_less(&a, &b), product = bernstein_times(&a, &b);
        assert_int_equal(product.degree, p.degree + q.degree);
        for (double x = 0; x <= 1; x += 0.125) {
            const double f = value_of(&p, x), g = value_of(&q, x);
            assert_near(bernstein_value(&sum, x), f + g, 1e-13);
            assert_near(bernstein_value(&less, x), f - g, 1e-13);
            assert_near(bernstein_value(&product, x), f * g, 1e-12);
        }
    }
}

static double greatest_sample(const powers *p)
{
    double greatest = -INFINITY;
    for (int i = 0; i <= 100000; i++) greatest = fmax(greatest, value_of(p, i / 100000.0));
    return greatest;
}

/* Between samples a polynomial of these rises by less than 1e-8: slope 0 in the middle, second derivatives below 400. */
static void the_maximum_is_found_within_the_resolution(void **state)
{
    (void)state;
    uint64_t chance = 4;
    for (int i = 0; i < 60; i++) {
        const powers p = random_powers(&chance, 10);
        const bernstein b = over(&p, 0, 1);
        const double greatest = greatest_sample(&p), resolution = i % 2 ? 1e-3 : 1e-10;
        const double bound = bernstein_maximum(&b, resolution);
        assert_true(bound >= greatest - 1e-15);
        assert_true(bound <= greatest + resolution + 1e-8);
        assert_true(bernstein_least(&b) <= value_of(&p, 0.3) && bernstein_most(&b) >= value_of(&p, 0.3));
        assert_true(bernstein_size(&b) >= fabs(value_of(&p, 0.7)));
    }
}

/* Equal up to rounding everywhere, so that nothing can be told apart by halving. */
static void the_maximum_of_a_constant_ends_at_once(void **state)
{
    (void)state;
    bernstein b = {BERNSTEIN_DEGREE, {0}};
    for (int k = 0; k <= b.degree; k++) b.b[k] = 1 + 1e-16 * (k % 3);
    assert_near(bernstein_maximum(&b, 1e-12), 1, 1e-15);
    assert_near(bernstein_maximum(&b, 1e-300), 1, 1e-15);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_polynomial_has_the_same_values_over_any_interval),
        cmocka_unit_test(parts_halves_and_slopes_are_those_of_the_powers),
        cmocka_unit_test(parts_at_the_ends_are_the_ends),
        cmocka_unit_test(sums_and_products_are_those_of_the_values),
        cmocka_unit_test(the_maximum_is_found_within_the_resolution),
        cmocka_unit_test(the_maximum_of_a_constant_ends_at_once),
    };
    return cmocka_run_group_tests_name("bernstein", tests, NULL, NULL);
}
