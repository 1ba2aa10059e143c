/* SPDX-License-Identifier: MIT */
/* Look-ups in floats: every float is taken exactly, and what comes out contains what comes out in doubles, and hardly more. */
#include "support/cmocka_all.h"

#include <float.h>

#include "query/single.h"
#include "support/chance.h"
#include "support/sample.h"

#define ULPS 4

/* --------------------------------------------------------------------------------------------------- one by one */

static void every_float_is_widened_exactly(void **state)
{
    (void)state;
    uint64_t chance = 11;
    for (uint32_t bits = 0; bits < 2 * SINGLE_MIN; bits += 1 + bits / 512) assert_exact(single_widen(single_of(bits)), (double)single_of(bits));
    for (int i = 0; i < 100000; i++) {
        float x = single_of((uint32_t)(chance_u64(&chance) % (SINGLE_MAX + UINT32_C(1))));
        assert_exact(single_widen(x), (double)x);
    }
    assert_exact(single_widen(-0.0F), 0.0);
    assert_exact(single_widen(INFINITY), INFINITY);
}

static void what_is_no_departure_stays_none(void **state)
{
    (void)state;
    const float none[] = {NAN, -NAN, -1.0F, -FLT_MIN, -1e-45F, -INFINITY};
    for (size_t i = 0; i < sizeof none / sizeof none[0]; i++) assert_true(single_widen(none[i]) < 0);
}

static void assert_narrowed(double x)
{
    float down = single_of(single_narrow(x, 0)), up = single_of(single_narrow(x, 1));
    assert_true((double)down <= x && x <= (double)up);
    if ((double)down < x) assert_exact(nextafterf(down, INFINITY) >= FLT_MIN ? nextafterf(down, INFINITY) : FLT_MIN, up);
    else assert_exact(down, up);
}

static void a_double_becomes_the_floats_on_both_sides(void **state)
{
    (void)state;
    uint64_t chance = 12;
    const double edges[] = {0, -0.0, 5e-324, 1e-310, FLT_MIN / 2, nextafter(FLT_MIN, 0), FLT_MIN, nextafter(FLT_MIN, 1), 1, nextafter(1, 0), nextafter(1, 2), 0.1,
                            nextafter(FLT_MAX, 0), FLT_MAX, nextafter(FLT_MAX, INFINITY), 1e300, DBL_MAX};
    for (size_t i = 0; i < sizeof edges / sizeof edges[0]; i++) assert_narrowed(edges[i]);
    for (int i = 0; i < 100000; i++) assert_narrowed(ldexp(chance_unit(&chance), (int)chance_below(&chance, 280) - 140));
}

static void assert_summed(float a, float b)
{
    double sum = (double)a + (double)b;
    uint32_t x = single_bits(a), y = single_bits(b);
    assert_true(single_hard_sum(x, y, 0) == single_soft_sum(x, y, 0) && single_hard_sum(x, y, 1) == single_soft_sum(x, y, 1));
    float down = single_of(single_add(single_bits(a), (double)b, 0)), up = single_of(single_add(single_bits(a), (double)b, 1));
    assert_true((double)down <= sum && sum <= (double)up);
    assert_true(down == up || nextafterf(down, INFINITY) == up);
}

/* A sum of two floats less than 29 bits apart is exact in doubles; one further apart is told from it by its side. */
static void a_sum_of_floats_is_between_neighbours(void **state)
{
    (void)state;
    uint64_t chance = 13;
    const float edges[] = {0, FLT_MIN, 1, 1.5F, 1.9999999F, 16777215, 16777216, 0.1F, FLT_MAX, FLT_MAX / 2, 3};
    for (size_t i = 0; i < sizeof edges / sizeof edges[0]; i++)
        for (size_t k = 0; k < sizeof edges / sizeof edges[0]; k++) assert_summed(edges[i], edges[k]);
    for (int i = 0; i < 200000; i++) {
        uint32_t high = 64 + (uint32_t)chance_below(&chance, 180), low = high - (uint32_t)chance_below(&chance, 40);
        assert_summed(single_of(high << 23 | (uint32_t)(chance_u64(&chance) >> 41)), single_of(low << 23 | (uint32_t)(chance_u64(&chance) >> 41)));
    }
    assert_exact(single_of(single_add(SINGLE_MAX, 1e300, 1)), INFINITY);
    assert_exact(single_of(single_add(SINGLE_MIN - 1, 0, 1)), FLT_MIN);
    assert_exact(single_of(single_add(SINGLE_MIN - 1, 0, 0)), 0);
}

/* -------------------------------------------------------------------------------------------------------- tables */

/* x, and so many floats on from it. */
static float moved(double x, float towards)
{
    float y = (float)x;
    for (int i = 0; i < ULPS + 1; i++) y = nextafterf(y, towards);
    return y;
}

static void assert_contains(const tdsp_table *table, float departure)
{
    double lower = 7, upper = 7;
    float low = 7, high = 7, same;
    tdsp_status status = tdsp_table_arrival(table, (double)departure, &lower, &upper);
    assert_int_equal(tdsp_table_arrival_float(table, departure, &low, &high), status);
    if (status != TDSP_OK) {
        assert_true(low == 7 && high == 7);
        return;
    }
    assert_true((double)low <= lower && upper <= (double)high);
    assert_true(low >= moved(lower, 0) || lower < 2 * (double)FLT_MIN);
    assert_true(high <= moved(upper, INFINITY) || upper < 2 * (double)FLT_MIN);
    assert_int_equal(tdsp_table_arrival_float(table, departure, &same, NULL), TDSP_OK);
    assert_true(same == low);
    assert_int_equal(tdsp_table_arrival_float(table, departure, NULL, &same), TDSP_OK);
    assert_true(same == high);
}

static void floats_contain_the_certified_interval_and_hardly_more(void **state)
{
    (void)state;
    uint64_t chance = 14;
    for (int trial = 0; trial < 200; trial++) {
        sample s = sample_random(&chance, 1 + chance_below(&chance, 60), trial % 2, trial % 3 == 0);
        for (int i = 0; i < 100; i++) assert_contains(&s.table, (float)sample_departure(&chance, &s));
        sample_free(&s);
    }
}

static void golden_tables_answer_in_floats_what_they_answer_in_doubles(void **state)
{
    (void)state;
    const float special[] = {0, -0.0F, -1, NAN, INFINITY, -INFINITY, FLT_MAX, FLT_MIN, FLT_MIN / 2, 1e-45F};
    for (size_t which = 0; which < GOLDEN_COUNT; which++) {
        sample s = sample_golden(which);
        for (size_t i = 0; i < sizeof special / sizeof special[0]; i++) assert_contains(&s.table, special[i]);
        for (float t = 0; t < 80; t += 0.125F) assert_contains(&s.table, t);
        sample_free(&s);
    }
}

/* An upper end may be past the greatest float, a lower one is cut to it, and a departure below the least normal float counts. */
static void times_that_no_float_holds_are_outward_too(void **state)
{
    (void)state;
    writer_header header = golden_tables[3].header;
    const writer_row rows[] = {{0, 1e300, 1e300, NULL, 0, NULL, 0}, {1e-40, 1e300, 1e300, NULL, 0, NULL, 0}, {1e38, 1e301, 1e301, NULL, 0, NULL, 0}};
    size_t length;
    sample s = {0};
    float low, high;
    s.bytes = golden_rows(&header, rows, 3, &length);
    assert_int_equal(tdsp_table_open(&s.table, s.bytes, length), TDSP_OK);
    assert_int_equal(tdsp_table_arrival_float(&s.table, 1, &low, &high), TDSP_OK);
    assert_exact(low, FLT_MAX);
    assert_exact(high, INFINITY);
    assert_contains(&s.table, 1e-41F);
    assert_contains(&s.table, 2e-40F);
    sample_free(&s);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_float_is_widened_exactly),
        cmocka_unit_test(what_is_no_departure_stays_none),
        cmocka_unit_test(a_double_becomes_the_floats_on_both_sides),
        cmocka_unit_test(a_sum_of_floats_is_between_neighbours),
        cmocka_unit_test(floats_contain_the_certified_interval_and_hardly_more),
        cmocka_unit_test(golden_tables_answer_in_floats_what_they_answer_in_doubles),
        cmocka_unit_test(times_that_no_float_holds_are_outward_too),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
