/* SPDX-License-Identifier: MIT */
/* The base: bytes, sizes, outward rounding, hashes, text. */
#include "support/cmocka_all.h"

#include <float.h>

#include "base/bytes.h"
#include "base/hash.h"
#include "base/round.h"
#include "base/sizes.h"
#include "base/text.h"
#include "support/chance.h"

static void numbers_are_little_endian_at_any_alignment(void **state)
{
    (void)state;
    for (size_t at = 0; at < 8; at++) {
        unsigned char b[24] = {0};
        bytes_put_u16(b + at, 0x0102);
        assert_int_equal(b[at], 0x02);
        assert_int_equal(b[at + 1], 0x01);
        assert_int_equal(bytes_get_u16(b + at), 0x0102);
        bytes_put_u32(b + at, 0xfffefdfcu);
        assert_int_equal(b[at], 0xfc);
        assert_int_equal(b[at + 3], 0xff);
        assert_int_equal(bytes_get_u32(b + at), 0xfffefdfcu);
        bytes_put_u64(b + at, UINT64_C(0xf1e2d3c4b5a69788));
        assert_int_equal(b[at], 0x88);
        assert_int_equal(b[at + 7], 0xf1);
        assert_true(bytes_get_u64(b + at) == UINT64_C(0xf1e2d3c4b5a69788));
    }
}

static void doubles_travel_as_their_ieee_bits(void **state)
{
    (void)state;
    const double values[] = {0.0, -0.0, 1.0, -2.5, 0.1, DBL_MIN, DBL_MAX, 4.9406564584124654e-324, INFINITY, -INFINITY, NAN};
    unsigned char b[9];
    bytes_put_f64(b + 1, -2.5);
    assert_int_equal(b[8], 0xc0);
    assert_int_equal(b[7], 0x04);
    assert_int_equal(b[6] | b[5] | b[4] | b[3] | b[2] | b[1], 0);
    for (size_t i = 0; i < sizeof values / sizeof values[0]; i++) {
        bytes_put_f64(b + 1, values[i]);
        assert_exact(bytes_get_f64(b + 1), values[i]);
    }
}

static void sizes_that_do_not_fit_are_refused(void **state)
{
    (void)state;
    uint64_t out = 7;
    assert_true(sizes_add(UINT64_MAX - 1, 1, &out) && out == UINT64_MAX);
    assert_false(sizes_add(UINT64_MAX, 1, &out));
    assert_true(sizes_multiply(UINT64_C(1) << 32, UINT64_C(0xffffffff), &out) && out == UINT64_C(0xffffffff00000000));
    assert_false(sizes_multiply(UINT64_C(1) << 32, UINT64_C(1) << 32, &out));
    assert_true(sizes_multiply(0, UINT64_MAX, &out) && out == 0);
    assert_true(sizes_align8(0, &out) && out == 0);
    assert_true(sizes_align8(9, &out) && out == 16);
    assert_true(sizes_align8(UINT64_MAX - 7, &out) && out == UINT64_MAX - 7);
    assert_false(sizes_align8(UINT64_MAX - 6, &out));
}

static void the_next_double_is_the_one_of_the_c_library(void **state)
{
    (void)state;
    uint64_t chance = 1;
    const double values[] = {0.0, -0.0, 1.0, -1.0, 4.9406564584124654e-324, -4.9406564584124654e-324, DBL_MIN, DBL_MAX, -DBL_MAX};
    for (size_t i = 0; i < sizeof values / sizeof values[0]; i++) {
        assert_true(round_next_up(values[i]) == nextafter(values[i], INFINITY));
        assert_true(round_next_down(values[i]) == nextafter(values[i], -INFINITY));
    }
    for (int i = 0; i < 10000; i++) {
        double x = ldexp(chance_between(&chance, -1, 1), (int)chance_below(&chance, 600) - 300);
        assert_exact(round_next_up(x), nextafter(x, INFINITY));
        assert_exact(round_next_down(x), nextafter(x, -INFINITY));
    }
    assert_true(round_next_up(INFINITY) == INFINITY && round_next_up(-INFINITY) == -INFINITY);
    assert_true(isnan(round_next_up(NAN)));
}

/* Long double holds the sum of two doubles of like size exactly on x86; elsewhere TwoSum's error must make up the difference. */
static void rounded_sums_enclose_the_sum_and_move_only_where_it_is_inexact(void **state)
{
    (void)state;
    uint64_t chance = 2;
    for (int i = 0; i < 100000; i++) {
        double a = chance_between(&chance, -100, 100);
        double b = ldexp(chance_between(&chance, -1, 1), (int)chance_below(&chance, 8));
        double s = a + b;
        double e = round_sum_error(a, b, s);
        double up = round_add_up(a, b);
        double down = round_add_down(a, b);
        if ((long double)a + b - s != (long double)e && sizeof(long double) > sizeof(double)) fail();
        assert_exact(up, e > 0 ? nextafter(s, INFINITY) : s);
        assert_exact(down, e < 0 ? nextafter(s, -INFINITY) : s);
        if (e == 0) assert_exact(up, down);
        assert_true(round_sum_at_most(a, b, up) && round_sum_at_most(a, b, INFINITY));
        assert_int_equal(round_sum_at_most(a, b, down), up == down);
        assert_false(round_sum_at_most(a, b, nextafter(down, -INFINITY)));
    }
}

static void a_sum_that_is_exact_is_not_moved(void **state)
{
    (void)state;
    assert_exact(round_add_up(1.5, 2.25), 3.75);
    assert_exact(round_add_down(1.5, 2.25), 3.75);
    assert_exact(round_subtract_up(10, 0.5), 9.5);
    assert_exact(round_subtract_down(10, 0.5), 9.5);
}

static void a_sum_that_is_not_exact_is_moved_one_step_outward(void **state)
{
    (void)state;
    assert_exact(round_add_up(1, 1e-30), nextafter(1, 2));
    assert_exact(round_add_down(1, 1e-30), 1.0);
    assert_exact(round_add_up(1, -1e-30), 1.0);
    assert_exact(round_add_down(1, -1e-30), nextafter(1, 0));
}

static void an_infinite_sum_stays_infinite(void **state)
{
    (void)state;
    assert_true(round_add_up(1, INFINITY) == INFINITY && round_add_down(1, INFINITY) == INFINITY);
    assert_true(round_add_down(DBL_MAX, DBL_MAX) == INFINITY);
    assert_true(round_subtract_up(1, INFINITY) == -INFINITY);
    assert_true(round_sum_at_most(1, INFINITY, INFINITY) && !round_sum_at_most(1, INFINITY, DBL_MAX));
    assert_false(round_sum_at_most(1, 1, NAN));
}

static void fnv1a_has_its_published_values(void **state)
{
    (void)state;
    assert_true(hash_fnv1a(HASH_FNV1A_SEED, "", 0) == UINT64_C(0xcbf29ce484222325));
    assert_true(hash_fnv1a(HASH_FNV1A_SEED, "a", 1) == UINT64_C(0xaf63dc4c8601ec8c));
    assert_true(hash_fnv1a(HASH_FNV1A_SEED, "foobar", 6) == UINT64_C(0x85944171f73967e8));
    assert_true(hash_fnv1a(hash_fnv1a(HASH_FNV1A_SEED, "foo", 3), "bar", 3) == UINT64_C(0x85944171f73967e8));
}

static void a_double_is_hashed_as_8_little_endian_bytes_and_minus_zero_as_zero(void **state)
{
    (void)state;
    const unsigned char one[8] = {0, 0, 0, 0, 0, 0, 0xf0, 0x3f};
    assert_true(hash_double(HASH_FNV1A_SEED, 1.0) == hash_fnv1a(HASH_FNV1A_SEED, one, 8));
    assert_true(hash_double(HASH_FNV1A_SEED, -0.0) == hash_double(HASH_FNV1A_SEED, 0.0));
    assert_true(hash_double(HASH_FNV1A_SEED, -1.0) != hash_double(HASH_FNV1A_SEED, 1.0));
    assert_true(hash_double(HASH_FNV1A_SEED, NAN) != hash_double(HASH_FNV1A_SEED, 0.0));
}

static void crc32c_has_its_published_values(void **state)
{
    (void)state;
    unsigned char bytes[32] = {0};
    assert_int_equal(hash_crc32c(0, "", 0, 0), 0);
    assert_int_equal(hash_crc32c(0, "123456789", 0, 9), 0xe3069283u);
    assert_int_equal(hash_crc32c(0, bytes, 0, 32), 0x8a9136aau);
    memset(bytes, 0xff, 32);
    assert_int_equal(hash_crc32c(0, bytes, 0, 32), 0x62a8ab43u);
    for (unsigned i = 0; i < 32; i++) bytes[i] = (unsigned char)i;
    assert_int_equal(hash_crc32c(0, bytes, 0, 32), 0x46dd794eu);
}

static void crc32c_goes_on_where_it_stopped(void **state)
{
    (void)state;
    for (size_t cut = 0; cut <= 9; cut++) {
        assert_int_equal(hash_crc32c(hash_crc32c(0, "123456789", 0, cut), "123456789", cut, 9), 0xe3069283u);
    }
}

static int is_utf8(const char *text)
{
    return text_is_utf8((const unsigned char *)text, 0, strlen(text));
}

static void a_character_that_the_end_cuts_off_is_none_even_if_the_rest_stands_behind(void **state)
{
    (void)state;
    const char *whole[] = {"m\xc3\xa9", "m\xe2\x82\xac", "m\xf0\x9f\x98\x80"};
    for (size_t i = 0; i < 3; i++) {
        const unsigned char *p = (const unsigned char *)whole[i];
        for (size_t length = 0; length <= i + 2; length++) {
            assert_int_equal(text_utf8_length(p + 1, 0, length), length == i + 2 ? length : 0);
            assert_int_equal(text_utf8_length(p, 1, 1 + length), length == i + 2 ? length : 0);
        }
    }
}

static void text_is_utf8_as_the_standard_has_it(void **state)
{
    (void)state;
    const char *good[] = {"", "m", "\xce\xbcs", "\xe2\x82\xac", "\xed\x9f\xbf", "\xee\x80\x80", "\xf0\x90\x80\x80", "\xf4\x8f\xbf\xbf"};
    const char *bad[] = {"\x80",             "\xff",         "\xc0\xaf",     "\xc1\xbf",         "\xce",     "\xe0\x9f\xbf",
                         "\xed\xa0\x80",     "\xe2\x82",     "\xe2\x28\xa1", "\xf0\x8f\xbf\xbf", "\xf5\x80", "\xf4\x90\x80\x80",
                         "\xf0\x90\x80\x28", "ok then \xbf", "\xe2\x82m",     "ok \xe2\x82"};
    for (size_t i = 0; i < sizeof good / sizeof good[0]; i++) assert_true(is_utf8(good[i]));
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) assert_false(is_utf8(bad[i]));
    assert_int_equal(text_utf8_length((const unsigned char *)"", 0, 0), 0);
    assert_true(text_is_utf8(NULL, 0, 0));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(numbers_are_little_endian_at_any_alignment),
        cmocka_unit_test(doubles_travel_as_their_ieee_bits),
        cmocka_unit_test(sizes_that_do_not_fit_are_refused),
        cmocka_unit_test(the_next_double_is_the_one_of_the_c_library),
        cmocka_unit_test(rounded_sums_enclose_the_sum_and_move_only_where_it_is_inexact),
        cmocka_unit_test(a_sum_that_is_exact_is_not_moved),
        cmocka_unit_test(a_sum_that_is_not_exact_is_moved_one_step_outward),
        cmocka_unit_test(an_infinite_sum_stays_infinite),
        cmocka_unit_test(fnv1a_has_its_published_values),
        cmocka_unit_test(a_double_is_hashed_as_8_little_endian_bytes_and_minus_zero_as_zero),
        cmocka_unit_test(crc32c_has_its_published_values),
        cmocka_unit_test(crc32c_goes_on_where_it_stopped),
        cmocka_unit_test(a_character_that_the_end_cuts_off_is_none_even_if_the_rest_stands_behind),
        cmocka_unit_test(text_is_utf8_as_the_standard_has_it),
    };
    return cmocka_run_group_tests_name("bytes", tests, NULL, NULL);
}
