/* SPDX-License-Identifier: MIT */
/* Polynomials of extreme sizes, with terms that are not there, and where memory begins and ends. */
#include "support/cmocka_all.h"

#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <unistd.h>

#include "geom/polynomial.h"

static double only_root(const polynomial *p, double from, double to)
{
    double roots[POLYNOMIAL_DEGREE];
    assert_int_equal(polynomial_roots(p, from, to, roots), 1);
    return roots[0];
}

/* As small as doubles are: 2^-1038 x^2 - 2^-1040. */
static void a_term_that_is_missing_does_not_hide_how_small_the_others_are(void **state)
{
    (void)state;
    const polynomial p = {2, {-0x1p-1040, 0.0, 0x1p-1038}};
    assert_near(only_root(&p, 0.0, 1.0), 0.5, 1e-15);
}

/* Scaled by the last term the others would be over all doubles. */
static void a_last_term_far_below_the_others_does_not_scale_them(void **state)
{
    (void)state;
    const polynomial p = {2, {-0x1p1000, 0x1p1000, 0x1p-1000}};
    assert_near(only_root(&p, 0.0, 2.0), 1.0, 1e-15);
}

static void a_first_root_does_not_depend_on_terms_that_are_zero(void **state)
{
    (void)state;
    const polynomial leading[] = {{2, {-0x1p60, 1.0, 0.0}}, {3, {-0x1p60, 1.0, 0.0, 0.0}}}, lacking = {4, {-0x1p40, 0.0, 0.0, 0.0, 1.0}};
    const polynomial lowest[] = {{2, {0.0, -0x1p-60, 1.0}}, {3, {0.0, 0.0, -0x1p-60, 1.0}}};
    for (int i = 0; i < 2; ++i) {
        assert_near(polynomial_first_root(&leading[i]), 0x1p60, 0x1p10);
        assert_near(polynomial_first_root(&lowest[i]), 0x1p-60, 0x1p-110);
    }
    assert_near(polynomial_first_root(&lacking), 0x1p10, 0x1p-40);
}

/* (x - 2^-60) (x - 2^-61): an interval is halved 47 times, and what is closer to its end is one sign. */
static void roots_far_smaller_than_the_interval_are_not_told_apart(void **state)
{
    (void)state;
    double roots[POLYNOMIAL_DEGREE];
    const polynomial p = {2, {0x1p-121, -0x3p-61, 1.0}};
    assert_int_equal(polynomial_roots(&p, 0.0, 1.0, roots), 0);
    assert_int_equal(polynomial_roots(&p, 0.0, 0x1p-20, roots), 2);
}

/* One term says that roots are at most 2^6, the other knows better. */
static void a_first_root_is_looked_for_as_far_as_any_term_says(void **state)
{
    (void)state;
    const polynomial p = {2, {-0x1p60, 1.0, 1.0}};
    assert_near(polynomial_first_root(&p), 0x1p30 - 0.5, 1e-6);
}

/* The bound on roots from below is rounded down, or this one, at 2^(-11/18), would lie below it. */
static void a_first_root_just_over_its_bound_is_found(void **state)
{
    (void)state;
    const polynomial p = {18, {-1.0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0x1p11}};
    assert_near(polynomial_first_root(&p), pow(2.0, -11.0 / 18.0), 1e-15);
}

/* (x - 1) (x + 1.25): intervals meet at 1, and no interval before the one that ends there tells the sign. */
static void a_first_root_at_the_end_of_the_first_interval_is_found(void **state)
{
    (void)state;
    const polynomial p = {2, {-1.25, 0.25, 1.0}};
    assert_exact(polynomial_first_root(&p), 1.0);
}

static void a_first_root_counts_between_two_to_the_minus_1000_and_the_1000(void **state)
{
    (void)state;
    for (int power = -1060; power <= 1020; power += 20) {
        const polynomial p = {1, {-1.5 * ldexp(1.0, power), 1.0}};
        double root = polynomial_first_root(&p);
        if (power >= -1000 && power < 1000) assert_near(root, 1.5 * ldexp(1.0, power), ldexp(1e-15, power));
        if (power < -1000 || power > 1010) assert_exact(root, INFINITY);
    }
}

static void the_derivative_of_a_constant_is_a_constant(void **state)
{
    (void)state;
    const polynomial one = {0, {1.0}}, slope = polynomial_derivative(&one);
    assert_int_equal(slope.degree, 0);
    assert_exact(slope.c[0], 0.0);
}

static void the_least_of_nothing_is_0_whatever_was_asked_before(void **state)
{
    (void)state;
    const polynomial below = {0, {-1.0}}, zero = {0, {0.0}};
    for (int k = 0; k < 3; ++k) {
        assert_true(polynomial_least(&below, 0.0, 1.0) < -0.5);
        assert_exact(polynomial_least(&zero, 0.0, 1.0), 0.0);
    }
}

/* A polynomial that is zero in all its bytes, between pages that must not be read. */
static void of_a_polynomial_of_zeros_nothing_is_read_but_itself(void **state)
{
    (void)state;
    const size_t page = (size_t)sysconf(_SC_PAGESIZE);
    unsigned char *pages;
    double roots[POLYNOMIAL_DEGREE];
    assert_int_equal(posix_memalign((void **)&pages, page, 3 * page), 0);
    memset(pages, 0, 3 * page);
    assert_int_equal(mprotect(pages, page, PROT_NONE) | mprotect(pages + 2 * page, page, PROT_NONE), 0);
    const unsigned char *places[] = {pages + page, pages + 2 * page - sizeof(polynomial)};
    for (int i = 0; i < 2; ++i) {
        const polynomial *zero = (const polynomial *)places[i];
        assert_int_equal(polynomial_roots(zero, 0.0, 1.0, roots), 0);
        assert_exact(polynomial_first_root(zero), INFINITY);
        assert_exact(polynomial_least(zero, 0.0, 1.0), 0.0);
    }
    assert_int_equal(mprotect(pages, 3 * page, PROT_READ | PROT_WRITE), 0);
    free(pages);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_term_that_is_missing_does_not_hide_how_small_the_others_are),
        cmocka_unit_test(a_last_term_far_below_the_others_does_not_scale_them),
        cmocka_unit_test(a_first_root_does_not_depend_on_terms_that_are_zero),
        cmocka_unit_test(roots_far_smaller_than_the_interval_are_not_told_apart),
        cmocka_unit_test(a_first_root_is_looked_for_as_far_as_any_term_says),
        cmocka_unit_test(a_first_root_just_over_its_bound_is_found),
        cmocka_unit_test(a_first_root_at_the_end_of_the_first_interval_is_found),
        cmocka_unit_test(a_first_root_counts_between_two_to_the_minus_1000_and_the_1000),
        cmocka_unit_test(the_derivative_of_a_constant_is_a_constant),
        cmocka_unit_test(the_least_of_nothing_is_0_whatever_was_asked_before),
        cmocka_unit_test(of_a_polynomial_of_zeros_nothing_is_read_but_itself),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
