/* SPDX-License-Identifier: MIT */
/* Sums rounded outward: in doubles and in whole numbers they are those of base/round.h, to the bit. */
#include "support/cmocka_all.h"

#include <float.h>

#include "base/round.h"
#include "query/outward.h"
#include "support/chance.h"

static void assert_sums(double a, double b)
{
    double up = round_add_up(a, b), down = round_add_down(a, b);
    assert_exact(outward_hard_up(a, b), up);
    assert_exact(outward_hard_down(a, b), down);
    assert_exact(outward_soft_sum(a, b, 1), up);
    assert_exact(outward_soft_sum(a, b, 0), down);
}

static double from_bits(uint64_t bits)
{
    double x;
    memcpy(&x, &bits, sizeof x);
    return x;
}

static void sums_in_whole_numbers_are_those_in_doubles_at_every_edge(void **state)
{
    (void)state;
    const double edges[] = {0, from_bits(1), from_bits(2), 0.5 * DBL_MIN, nextafter(DBL_MIN, 0), DBL_MIN, nextafter(DBL_MIN, 1), 1e-300, DBL_EPSILON,
                            DBL_EPSILON / 2, nextafter(1, 0), 1, nextafter(1, 2), 1.5, nextafter(2, 0), 2, 0.1, 3, 1e15, 9007199254740991.0,
                            9007199254740992.0, 9007199254740993.0, 1e300, DBL_MAX / 4};
    const size_t count = sizeof edges / sizeof edges[0];
    for (size_t i = 0; i < count; i++)
        for (size_t k = 0; k < count; k++) assert_sums(edges[i], edges[k]);
}

/* Exponents apart by 0 to 70: whole, cut and lost parts; and significands whose sum is all ones, or carries. */
static void sums_in_whole_numbers_are_those_in_doubles_at_random(void **state)
{
    (void)state;
    uint64_t chance = 20241;
    for (int i = 0; i < 200000; i++) {
        uint64_t exponent = 200 + chance_below(&chance, 1500), apart = chance_below(&chance, 71);
        uint64_t a = chance_u64(&chance) >> 12, b = chance_u64(&chance) >> 12;
        if (i % 3 == 0) b &= ~(UINT64_MAX << chance_below(&chance, 52)) << chance_below(&chance, 12) & (UINT64_MAX >> 12);
        if (i % 5 == 0) a = UINT64_MAX >> 12;
        assert_sums(from_bits(exponent << 52 | a), from_bits((exponent - apart) << 52 | b));
    }
}

static void sums_near_the_least_doubles_are_exact(void **state)
{
    (void)state;
    uint64_t chance = 7;
    for (int i = 0; i < 50000; i++) assert_sums(from_bits(chance_u64(&chance) >> (10 + i % 50)), from_bits(chance_u64(&chance) >> (10 + i % 37)));
}

static void a_zero_may_have_a_sign(void **state)
{
    (void)state;
    assert_exact(outward_soft_sum(-0.0, 2.5, 1), 2.5);
    assert_exact(outward_soft_sum(2.5, -0.0, 0), 2.5);
    assert_exact(outward_soft_sum(-0.0, -0.0, 1), 0.0);
}

static void what_the_machine_takes_is_one_of_them(void **state)
{
    (void)state;
    assert_exact(outward_add_up(0.1, 0.2), 0.30000000000000004);
    assert_exact(outward_add_down(0.1, 0.2), nextafter(0.30000000000000004, 0));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sums_in_whole_numbers_are_those_in_doubles_at_every_edge),
        cmocka_unit_test(sums_in_whole_numbers_are_those_in_doubles_at_random),
        cmocka_unit_test(sums_near_the_least_doubles_are_exact),
        cmocka_unit_test(a_zero_may_have_a_sign),
        cmocka_unit_test(what_the_machine_takes_is_one_of_them),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
