/* SPDX-License-Identifier: MIT */
/* Curves in tables: what is refused of their numbers, and that what is accepted can be evaluated. */
#include "support/cmocka_all.h"

#include <float.h>
#include <stdlib.h>

#include "base/bytes.h"
#include "support/chance.h"
#include "support/curve.h"
#include "support/golden.h"
#include "table/format.h"
#include "tdsp/path.h"
#include "tdsp/table.h"

enum { SWELL = 5 };

static unsigned char *swell_bytes(size_t *length)
{
    unsigned char *bytes = golden_write(&golden_tables[SWELL], length);
    assert_non_null(bytes);
    return bytes;
}

static size_t section_of(const unsigned char *bytes, size_t section)
{
    return (size_t)bytes_get_u64(bytes + format_at_offset(section));
}

static void each_number_of_a_curve_out_of_range_is_refused(void **state)
{
    (void)state;
    const struct {
        size_t at;
        double value;
    } faults[] = {{0, NAN},      {8, INFINITY}, {16, 0},        {16, -1},  {16, NAN},  {16, DBL_MAX}, {24, 0},    {24, -INFINITY},
                  {32, NAN},     {40, INFINITY}, {48, 2},       {48, -2},  {48, NAN},  {56, 2.5},     {64, NAN},  {64, INFINITY},
                  {72, DBL_MAX}, {72, -INFINITY}, {80, 0.375},  {80, 0},   {80, -2},   {80, NAN},     {80, INFINITY}};
    for (size_t i = 0; i < sizeof faults / sizeof faults[0]; i++) {
        size_t length;
        unsigned char *bytes = swell_bytes(&length);
        tdsp_table table;
        bytes_put_f64(bytes + section_of(bytes, FORMAT_CURVES) + faults[i].at, faults[i].value);
        golden_seal(bytes, length);
        if (tdsp_table_open(&table, bytes, length) != TDSP_BAD_TABLE) fail_msg("fault %zu was not refused", i);
        free(bytes);
    }
}

/* There are an arc and three curves. */
static void a_curve_that_is_not_there_is_refused(void **state)
{
    (void)state;
    for (uint32_t number = 0; number < 8; number++) {
        size_t length;
        unsigned char *bytes = swell_bytes(&length);
        tdsp_table table;
        bytes_put_u32(bytes + section_of(bytes, FORMAT_WAYPOINTS) + FORMAT_WAYPOINT_SIZE + FORMAT_WAYPOINT_AT_ARC, number);
        golden_seal(bytes, length);
        assert_int_equal(tdsp_table_open(&table, bytes, length), number < 4 ? TDSP_OK : TDSP_BAD_TABLE);
        free(bytes);
    }
}

static void a_wrong_place_or_number_of_curves_is_refused(void **state)
{
    (void)state;
    const size_t at = format_at_offset(FORMAT_CURVES);
    const struct {
        size_t at;
        uint64_t value;
    } faults[] = {{at, 0},     {at, 760},   {at, 784},        {at, UINT64_MAX - 7},
                  {at + 8, 0}, {at + 8, 2}, {at + 8, 4},      {at + 8, UINT64_MAX},
                  {at + 8, UINT64_MAX / FORMAT_CURVE_SIZE + 1}, {FORMAT_AT_ARCS, 0}, {FORMAT_AT_ARCS, 2}, {FORMAT_AT_ARCS, UINT32_MAX - 2}};
    for (size_t i = 0; i < sizeof faults / sizeof faults[0]; i++) {
        size_t length;
        unsigned char *bytes = swell_bytes(&length);
        tdsp_table table;
        assert_int_equal(bytes_get_u64(bytes + at), 776);
        bytes_put_u64(bytes + faults[i].at, faults[i].value);
        golden_seal(bytes, length);
        if (tdsp_table_open(&table, bytes, length) != TDSP_BAD_TABLE) fail_msg("fault %zu was not refused", i);
        free(bytes);
    }
}

/* The duration makes a bend too large, in a curve that alone is in range. */
static void a_curve_too_long_for_its_bends_is_refused(void **state)
{
    (void)state;
    for (int excess = 0; excess < 2; excess++) {
        size_t length;
        unsigned char *bytes = swell_bytes(&length);
        tdsp_table table;
        bytes_put_f64(bytes + section_of(bytes, FORMAT_CURVES) + FORMAT_CURVE_SIZE + FORMAT_CURVE_AT_BEND_TO, excess ? 0x1p999 : 0x1p997);
        golden_seal(bytes, length);
        assert_int_equal(tdsp_table_open(&table, bytes, length), excess ? TDSP_BAD_TABLE : TDSP_OK);
        free(bytes);
    }
}

static double any_size(uint64_t *chance)
{
    double value = ldexp(chance_between(chance, 0.5, 1), (int)chance_below(chance, 2200) - 1100);
    return chance_below(chance, 3) ? value : chance_between(chance, 0, 2);
}

static double any_below(uint64_t *chance, double most)
{
    double share = chance_below(chance, 2) ? 1 - DBL_EPSILON / 2 : chance_between(chance, 0, 1);
    return chance_below(chance, 2) ? share * most : -share * most;
}

/* A curve of any numbers; about a quarter of them are accepted. */
static tdsp_leg any_curve(uint64_t *chance)
{
    tdsp_leg leg = {.kind = TDSP_LEG_CURVE, .turn = chance_below(chance, 2) ? 1 : -1, .end_time = any_size(chance)};
    leg.radius_from = any_size(chance);
    leg.radius_to = any_size(chance);
    leg.angle_from = chance_between(chance, -4, 4);
    leg.sweep = any_size(chance);
    leg.speed = any_size(chance);
    leg.rate_from = any_below(chance, leg.speed);
    leg.rate_to = any_below(chance, leg.speed);
    leg.bend_from = any_size(chance);
    leg.bend_to = -any_size(chance);
    return leg;
}

static unsigned char *table_of(const tdsp_leg *leg, size_t *length)
{
    const writer_row row = {0, leg->end_time, INFINITY, leg, 1, NULL, 0};
    return golden_rows(&golden_tables[SWELL].header, &row, 1, length);
}

static void every_curve_that_is_accepted_has_places_that_are_numbers_and_those_of_its_leg(void **state)
{
    (void)state;
    uint64_t chance = 8;
    int accepted = 0;
    for (int i = 0; i < 20000; i++) {
        tdsp_leg leg = any_curve(&chance);
        size_t length;
        tdsp_table table;
        if (leg.end_time < 12 || !isfinite(leg.end_time)) leg.end_time = 12;
        unsigned char *bytes = table_of(&leg, &length);
        if (!bytes) continue;
        accepted++;
        assert_int_equal(tdsp_table_open(&table, bytes, length), TDSP_OK);
        tdsp_leg read;
        assert_int_equal(tdsp_table_leg(&table, 0, 0, &read), TDSP_OK);
        for (double x = 0; x <= 1; x += 0.125) {
            tdsp_point at, expected = tdsp_leg_position(&read, x * leg.end_time);
            assert_int_equal(tdsp_table_position(&table, 0, x * leg.end_time, &at), TDSP_OK);
            assert_exact(at.x, expected.x);
            assert_exact(at.y, expected.y);
            if (!isfinite(at.x) || !isfinite(at.y)) fail_msg("curve %d has no place at %g", i, x);
        }
        free(bytes);
    }
    assert_true(accepted > 1000 && accepted < 19000);
}

/* Between rows the path is moved earlier: the curve stays the same motion. */
static void a_ride_in_a_table_is_where_the_disc_is_and_moves_earlier_with_its_path(void **state)
{
    (void)state;
    const curve_law law = {{1, 0.1, 0.02}};
    const tdsp_point center = {4, -3};
    tdsp_leg legs[40];
    curve_legs(&law, center, 1.5, 1, 3, -2, -1, legs, 40);
    const writer_row rows[] = {{0, 2, 2, NULL, 0, NULL, 0}, {1, 2, INFINITY, legs, 40, NULL, 0}};
    writer_header header = golden_tables[SWELL].header;
    header.first_lower = 2;
    size_t length;
    unsigned char *bytes = golden_rows(&header, rows, 2, &length);
    tdsp_table table;
    assert_non_null(bytes);
    assert_int_equal(tdsp_table_open(&table, bytes, length), TDSP_OK);
    for (double t = 1; t <= 3; t += 0.03125) {
        tdsp_point at, early, truth = curve_law_place(&law, center, t, -2 - curve_law_turned(&law, 1.5, 1, t));
        assert_int_equal(tdsp_table_position(&table, 1, t, &at), TDSP_OK);
        assert_int_equal(tdsp_table_position(&table, 0.25, t - 0.75, &early), TDSP_OK);
        assert_near(hypot(at.x - truth.x, at.y - truth.y), 0, 1e-12);
        assert_near(hypot(at.x - early.x, at.y - early.y), 0, 1e-13);
    }
    free(bytes);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(each_number_of_a_curve_out_of_range_is_refused),
        cmocka_unit_test(a_curve_that_is_not_there_is_refused),
        cmocka_unit_test(a_wrong_place_or_number_of_curves_is_refused),
        cmocka_unit_test(a_curve_too_long_for_its_bends_is_refused),
        cmocka_unit_test(every_curve_that_is_accepted_has_places_that_are_numbers_and_those_of_its_leg),
        cmocka_unit_test(a_ride_in_a_table_is_where_the_disc_is_and_moves_earlier_with_its_path),
    };
    return cmocka_run_group_tests_name("curve_table", tests, NULL, NULL);
}
