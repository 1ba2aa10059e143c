/* SPDX-License-Identifier: MIT */
/* The library's own mathematics: errors, special values, symmetries, and the bits that every machine must give. */
#include "support/cmocka_all.h"

#include <stdio.h>
#include <stdlib.h>

#include "base/math.h"
#include "support/chance.h"
#include "support/function_errors.h"

#define ARGUMENTS 4000 /* of each range; `make mathematics` takes millions */
#define GOLDEN "tests/golden/mathematics.txt"

static void errors_are_within_their_bounds_in_every_range(void **state)
{
    (void)state;
    for (int i = 0; i < function_count; i++) {
        assert_string_equal(function_cases[i].name, function_references[i].name);
        for (const function_range *range = function_cases[i].ranges; range->name; range++) {
            function_worst worst = function_measure(i, range, ARGUMENTS, 1);
            if (worst.part > 1.0) fail_msg("%s, %s: off by %.4f at %a, %a", function_cases[i].name, range->name, worst.error, worst.x, worst.y);
        }
    }
}

static void compare_special(int function, double x, double y)
{
    double found = function_value(&function_cases[function], x, y);
    function_number wanted = function_true(function, x, y);
    if (function_error(found, wanted) <= function_bound(function, wanted)) return;
    fail_msg("%s of %a, %a: %a, not %La", function_cases[function].name, x, y, found, wanted);
}

/* Zeros with their signs, infinities, NaNs, numbers less than normal, the ends of domains, and all pairs of these. */
static void special_arguments_are_answered_as_the_standard_says(void **state)
{
    (void)state;
    for (int i = 0; i < function_count; i++)
        for (int k = 0; k < 2 * function_special_count; k++) {
            double x = k & 1 ? -function_specials[k / 2] : function_specials[k / 2];
            if (function_cases[i].one) compare_special(i, x, 0.0);
            for (int j = 0; function_cases[i].two && j < 2 * function_special_count; j++)
                compare_special(i, x, j & 1 ? -function_specials[j / 2] : function_specials[j / 2]);
        }
}

/* What an index is made of comes from the bits: each exponent, with its ends and some between. The sanitizers watch the tables. */
static void no_argument_leads_behind_a_table(void **state)
{
    (void)state;
    uint64_t chance = 30;
    for (uint64_t exponent = 0; exponent < 4096; exponent++) {
        for (int k = 0; k < 10; k++) {
            uint64_t part = k == 0 ? 0 : k == 1 ? UINT64_MAX >> 12 : chance_u64(&chance) >> 12;
            double x = math_of_bits(exponent << 52 | part), sine, cosine;
            math_sincos(x, &sine, &cosine);
            if (fabs(x) <= DBL_MAX) assert_true(fabs(sine * sine + cosine * cosine - 1.0) < 1e-15);
            if (x > 0.0 && x <= DBL_MAX) assert_true(fabs(math_log(x)) < 745.2 && math_log1p(x) >= 0.0 && math_log1p(x) < 709.8);
        }
    }
}

static void signs_of_zero_are_kept(void **state)
{
    (void)state;
    assert_exact(math_sin(-0.0), -0.0);
    assert_exact(math_asin(-0.0), -0.0);
    assert_exact(math_log1p(-0.0), -0.0);
    assert_exact(math_expm1(-0.0), -0.0);
    assert_exact(math_atan2(-0.0, 1.0), -0.0);
    assert_exact(math_atan2(0.0, -0.0), 0x1.921fb54442d18p+1);
    assert_exact(math_atan2(-0.0, -0.0), -0x1.921fb54442d18p+1);
    assert_exact(math_hypot(-0.0, -0.0), 0.0);
    assert_exact(math_log(1.0), 0.0);
    assert_exact(math_acos(1.0), 0.0);
    assert_exact(math_log(-0.0), -INFINITY);
}

static void both_is_what_sine_and_cosine_say_and_they_are_odd_and_even(void **state)
{
    (void)state;
    uint64_t chance = 2;
    const function_range all = {"all", 1, 0, -60, 1023};
    for (int i = 0; i < 20 * ARGUMENTS; i++) {
        double x = function_argument(&all, &chance), sine, cosine;
        math_sincos(x, &sine, &cosine);
        assert_exact(math_sin(x), sine);
        assert_exact(math_cos(x), cosine);
        assert_exact(math_sin(-x), -sine);
        assert_exact(math_cos(-x), cosine);
        assert_true(fabs(sine) <= 1.0 && fabs(cosine) <= 1.0);
    }
}

static void angles_turned_over_an_axis_are_to_the_bit_what_they_were(void **state)
{
    (void)state;
    uint64_t chance = 3;
    const function_range all = {"all", 1, 1, -30, 30};
    for (int i = 0; i < 20 * ARGUMENTS; i++) {
        double x = function_argument(&all, &chance), y = function_argument(&all, &chance);
        assert_exact(math_atan2(-y, x), -math_atan2(y, x));
        assert_exact(math_atan2(-y, -x), -math_atan2(y, -x));
        assert_exact(math_asin(-x / 0x1p31), -math_asin(x / 0x1p31));
        assert_exact(math_hypot(x, -y), math_hypot(y, x));
    }
}

/* The double that is nearest to a multiple of a quarter turn, and the doubles next to a half and a whole one. */
static void an_angle_next_to_a_multiple_of_a_quarter_turn_keeps_its_bits(void **state)
{
    (void)state;
    const double nearest = 0x1.6ac5b262ca1ffp+849; /* 6381956970095103 2^797 */
    assert_exact(math_cos(nearest), -0x1.14ae72e6ba22fp-61);
    assert_exact(math_sin(nearest), 1.0);
    assert_exact(math_sin(0x1.921fb54442d18p+1), 0x1.1a62633145c07p-53);
    assert_exact(math_sin(0x1.921fb54442d18p+2), -0x1.1a62633145c07p-52);
}

/* Within 0.012 units of the middle: a term less, or more, gives the other one. */
static void a_result_next_to_the_middle_of_two_doubles_is_the_nearer_one(void **state)
{
    (void)state;
    assert_exact(math_sin(0x1.b175539fda893p-2), 0x1.a4a10e12c7ba3p-2);
    assert_exact(math_log1p(0x1.3ca8a75335d53p+53), 0x1.2798782fe74ap+5);
}

/* Where one formula gives way to another, and between: no step the wrong way. */
static void assert_rises(double (*function)(double), double x, int steps, double direction)
{
    double last = function(x);
    for (int i = 0; i < steps; i++) {
        x = nextafter(x, INFINITY);
        double next = function(x);
        if (direction * (next - last) < 0.0) fail_msg("at %a: %a after %a", x, next, last);
        last = next;
    }
}

static double angle_of_slope(double x)
{
    return math_atan2(x, 1.0);
}

static void functions_rise_where_their_formulas_meet(void **state)
{
    (void)state;
    for (int k = 1; k < 200; k++) {
        double at = k / 128.0;
        if (at < 1.5) assert_rises(math_sin, nextafter(at, 0.0), 3, 1.0);
        if (at < 1.0) assert_rises(math_asin, nextafter(at, 0.0), 2, 1.0);
        assert_rises(math_cos, nextafter(at, 0.0), 3, -1.0);
        assert_rises(angle_of_slope, nextafter(at, 0.0), 3, 1.0);
        assert_rises(math_log, nextafter(at, 0.0), 3, 1.0);
        assert_rises(math_log1p, nextafter(at, 0.0), 3, 1.0);
        assert_rises(math_log1p, nextafter(-at / 2, -1.0), 3, 1.0);
        assert_rises(math_expm1, nextafter(at, 0.0), 3, 1.0);
        assert_rises(math_expm1, nextafter(-at, -2.0), 3, 1.0);
        assert_rises(math_exp, nextafter(at, 0.0), 3, 1.0);
    }
}

static void the_smaller_and_the_larger_number_are_told_also_of_zeros_and_nans(void **state)
{
    (void)state;
    assert_exact(math_min(1.0, 2.0), 1.0);
    assert_exact(math_max(1.0, 2.0), 2.0);
    assert_exact(math_min(NAN, 2.0), 2.0);
    assert_exact(math_min(2.0, NAN), 2.0);
    assert_exact(math_max(2.0, NAN), 2.0);
    assert_exact(math_min(0.0, -0.0), -0.0);
    assert_exact(math_max(0.0, -0.0), -0.0);
    assert_exact(math_min(-INFINITY, INFINITY), -INFINITY);
    assert_true(isnan(math_max(NAN, NAN)));
}

static void the_bits_are_those_recorded(void **state)
{
    (void)state;
    FILE *found = tmpfile(), *recorded = fopen(GOLDEN, "r");
    assert_non_null(found);
    if (!recorded) fail_msg("%s: not found; tests run from the top directory", GOLDEN);
    functions_say(found);
    rewind(found);
    char here[256], there[256];
    while (fgets(there, sizeof there, recorded)) {
        assert_non_null(fgets(here, sizeof here, found));
        assert_string_equal(here, there);
    }
    assert_null(fgets(here, sizeof here, found));
    fclose(recorded);
    fclose(found);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(errors_are_within_their_bounds_in_every_range),
        cmocka_unit_test(special_arguments_are_answered_as_the_standard_says),
        cmocka_unit_test(no_argument_leads_behind_a_table),
        cmocka_unit_test(signs_of_zero_are_kept),
        cmocka_unit_test(both_is_what_sine_and_cosine_say_and_they_are_odd_and_even),
        cmocka_unit_test(angles_turned_over_an_axis_are_to_the_bit_what_they_were),
        cmocka_unit_test(an_angle_next_to_a_multiple_of_a_quarter_turn_keeps_its_bits),
        cmocka_unit_test(a_result_next_to_the_middle_of_two_doubles_is_the_nearer_one),
        cmocka_unit_test(functions_rise_where_their_formulas_meet),
        cmocka_unit_test(the_smaller_and_the_larger_number_are_told_also_of_zeros_and_nans),
        cmocka_unit_test(the_bits_are_those_recorded),
    };
    return cmocka_run_group_tests_name("math", tests, NULL, NULL);
}
