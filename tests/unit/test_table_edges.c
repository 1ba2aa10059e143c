/* SPDX-License-Identifier: MIT */
/* Tables that break one rule of the format where every other rule is kept: what only that rule refuses. And what is read of a table without guides. */
#include "support/cmocka_all.h"

#include <stdlib.h>

#include "base/bytes.h"
#include "support/brink.h"
#include "support/golden.h"
#include "table/check.h"
#include "table/format.h"
#include "tdsp/table.h"

enum { GAP, ROAD, LOOSE, STILL, CROWD, SWELL, SQUEEZE };

typedef struct edge {
    unsigned char *bytes;
    size_t length;
} edge;

static edge edge_of(size_t which)
{
    edge e;
    e.bytes = golden_write(&golden_tables[which], &e.length);
    assert_non_null(e.bytes);
    return e;
}

static unsigned char *edge_section(edge e, size_t section)
{
    return e.bytes + bytes_get_u64(e.bytes + format_at_offset(section));
}

static tdsp_status edge_open(edge e)
{
    tdsp_table table;
    golden_seal(e.bytes, e.length);
    return tdsp_table_open(&table, e.bytes, e.length);
}

static void assert_refused(edge e)
{
    assert_int_equal(edge_open(e), TDSP_BAD_TABLE);
    free(e.bytes);
}

/* -------------------------------------------------------------------------------------------------------- header, rows */

static void what_must_be_equal_is_not_equal_to_no_number(void **state)
{
    (void)state;
    const size_t places[] = {FORMAT_AT_DELTA, FORMAT_AT_FIRST_DEPARTURE, FORMAT_AT_LAST_DEPARTURE};
    for (size_t i = 0; i < sizeof places / sizeof places[0]; i++) {
        edge e = edge_of(GAP);
        bytes_put_f64(e.bytes + places[i], NAN);
        assert_refused(e);
    }
}

/* The last row leaves so late that it would be in order although it arrives before it leaves. */
static void a_travel_time_below_0_is_refused_though_arrivals_are_in_order(void **state)
{
    (void)state;
    const double lefts[] = {3, -1, 3}, rights[] = {3.5, 3.5, -1};
    for (int i = 0; i < 3; i++) {
        edge e = edge_of(ROAD);
        bytes_put_f64(edge_section(e, FORMAT_DEPARTURES) + 24, 20);
        bytes_put_f64(e.bytes + FORMAT_AT_LAST_DEPARTURE, 20);
        bytes_put_f64(edge_section(e, FORMAT_LEFT) + 24, lefts[i]);
        bytes_put_f64(edge_section(e, FORMAT_RIGHT) + 24, rights[i]);
        assert_int_equal(edge_open(e), i == 0 ? TDSP_OK : TDSP_BAD_TABLE);
        free(e.bytes);
    }
}

/* Rounded outward it may be over the right one, and over what follows too. */
static void a_travel_time_that_falls_is_refused_though_every_right_one_is_below_it(void **state)
{
    (void)state;
    edge e = edge_of(GAP);
    bytes_put_f64(edge_section(e, FORMAT_LEFT) + 8, 20.9);
    assert_refused(e);
}

/* --------------------------------------------------------------------------------------------------------------- paths */

/* The rows of `gap` have the waypoints 0 to 1, 2 to 5, 6 to 10 and 11 to 12. */
static void edge_put_bounds(edge e, const uint32_t bounds[5], uint64_t legs)
{
    for (size_t i = 0; i < 5; i++) bytes_put_u32(edge_section(e, FORMAT_FIRST_WAYPOINT) + 4 * i, bounds[i]);
    bytes_put_u64(e.bytes + FORMAT_AT_LEGS, legs);
}

static void edge_put_time(edge e, size_t waypoint, double time)
{
    bytes_put_f64(edge_section(e, FORMAT_WAYPOINTS) + FORMAT_WAYPOINT_SIZE * waypoint + FORMAT_WAYPOINT_AT_TIME, time);
}

static void a_path_of_one_waypoint_is_refused(void **state)
{
    (void)state;
    const uint32_t bounds[] = {0, 2, 6, 12, 13};
    edge e = edge_of(GAP);
    edge_put_bounds(e, bounds, 9);
    edge_put_time(e, 11, 30.5);
    edge_put_time(e, 12, 12.5);
    assert_refused(e);
}

static void waypoints_before_the_first_path_or_behind_the_last_are_refused(void **state)
{
    (void)state;
    const uint32_t before[] = {1, 2, 6, 11, 13}, behind[] = {0, 2, 6, 11, 11};
    edge e = edge_of(GAP);
    edge_put_bounds(e, before, 8);
    assert_refused(e);
    e = edge_of(GAP);
    edge_put_bounds(e, behind, 8);
    assert_refused(e);
}

/* The third row's path would end before it begins; where it begins, the center of the first arc reads as the departure. */
static void a_path_that_ends_before_it_begins_is_refused(void **state)
{
    (void)state;
    const uint32_t bounds[] = {0, 2, 13, 11, 13};
    edge e = edge_of(GAP);
    edge_put_bounds(e, bounds, 12);
    for (size_t i = 3; i < 11; i++) edge_put_time(e, i, 5);
    edge_put_time(e, 12, 20);
    bytes_put_f64(edge_section(e, FORMAT_ARCS) + FORMAT_ARC_AT_CENTER, 9.75);
    assert_refused(e);
}

static void where_a_leg_ends_and_the_next_has_a_waypoint_of_its_own_no_arc_begins(void **state)
{
    (void)state;
    edge e = edge_of(LOOSE);
    bytes_put_u32(edge_section(e, FORMAT_WAYPOINTS) + FORMAT_WAYPOINT_SIZE + FORMAT_WAYPOINT_AT_ARC, 0);
    assert_refused(e);
}

/* -------------------------------------------------------------------------------------------------------------- curves */

static void every_arc_is_looked_at_not_only_the_first(void **state)
{
    (void)state;
    for (size_t arc = 0; arc < 3; arc++) {
        edge e = edge_of(GAP);
        bytes_put_f64(edge_section(e, FORMAT_ARCS) + FORMAT_ARC_SIZE * arc + FORMAT_ARC_AT_RADIUS_TO, 0);
        assert_refused(e);
    }
}

/* The waypoints that begin the curves begin an arc instead: no leg has a curve then. */
static void curves_that_no_leg_has_are_looked_at_too(void **state)
{
    (void)state;
    const size_t begins[] = {1, 2, 6};
    for (size_t wrong = 0; wrong <= 3; wrong++) {
        edge e = edge_of(SWELL);
        for (size_t i = 0; i < 3; i++) bytes_put_u32(edge_section(e, FORMAT_WAYPOINTS) + FORMAT_WAYPOINT_SIZE * begins[i] + FORMAT_WAYPOINT_AT_ARC, 0);
        if (wrong < 3) bytes_put_f64(edge_section(e, FORMAT_CURVES) + FORMAT_CURVE_SIZE * wrong + FORMAT_ARC_AT_CENTER, NAN);
        assert_int_equal(edge_open(e), wrong < 3 ? TDSP_BAD_TABLE : TDSP_OK);
        free(e.bytes);
    }
}

/* Signs that would cancel where the size of a curve is estimated. */
static void a_radius_below_0_or_a_rate_over_the_speed_is_refused_however_small_the_curve_looks(void **state)
{
    (void)state;
    const struct {
        size_t at;
        double value;
    } faults[] = {{FORMAT_ARC_AT_RADIUS_FROM, -1}, {FORMAT_ARC_AT_RADIUS_TO, -1}, {FORMAT_CURVE_AT_RATE_FROM, 3}, {FORMAT_CURVE_AT_RATE_FROM, -3},
                  {FORMAT_CURVE_AT_RATE_TO, 3},    {FORMAT_CURVE_AT_RATE_TO, -3}};
    for (size_t i = 0; i < sizeof faults / sizeof faults[0]; i++) {
        edge e = edge_of(SWELL);
        bytes_put_f64(edge_section(e, FORMAT_CURVES) + faults[i].at, faults[i].value);
        assert_refused(e);
    }
}

/* -------------------------------------------------------------------------------------------------------------- guides */

/* A guide of one cell says nothing wrong whatever its scale: only the scale itself can be refused. */
static void a_guide_of_one_cell_needs_a_scale_over_0(void **state)
{
    (void)state;
    const double scales[] = {1e-9, 0.0, -0.0, -1e-9, NAN};
    unsigned char guide[16] = {0};
    for (size_t i = 0; i < sizeof scales / sizeof scales[0]; i++) {
        edge e = edge_of(SQUEEZE);
        tdsp_table table;
        assert_int_equal(tdsp_table_open(&table, e.bytes, e.length), TDSP_OK);
        unsigned char *longer = realloc(e.bytes, e.length + sizeof guide);
        assert_non_null(longer);
        bytes_put_u32(guide + 4, (uint32_t)table.rows);
        memcpy(longer + e.length, guide, sizeof guide);
        table.bytes = longer;
        table.length = e.length + sizeof guide;
        table.by_departure = (tdsp_guide){.cells = 1, .scale = scales[i], .last = 6, .bases = e.length, .counts = e.length + 8};
        assert_int_equal(check_guides(&table), i == 0);
        free(longer);
    }
}

/* A later version may have anything behind the departures: here a number below the only one. */
static void a_guide_of_one_row_looks_at_no_row_behind_it(void **state)
{
    (void)state;
    edge e = edge_of(STILL);
    tdsp_table table;
    unsigned char more[32] = {0};
    assert_int_equal(tdsp_table_open(&table, e.bytes, e.length), TDSP_OK);
    unsigned char *longer = realloc(e.bytes, e.length + sizeof more);
    assert_non_null(longer);
    bytes_put_u32(more + 4, 1);
    bytes_put_f64(more + 24, -1.0);
    memcpy(longer + e.length, more, sizeof more);
    table.bytes = longer;
    table.length = e.length + sizeof more;
    table.departures = e.length + 16;
    table.by_departure = (tdsp_guide){.cells = 1, .scale = 1.0, .last = 0, .bases = e.length, .counts = e.length + 8};
    assert_true(check_guides(&table));
    free(longer);
}

/* Two rows in the cells 0 and 1, right before memory that must not be read, and a third cell. */
static void a_guide_that_goes_on_behind_the_last_row_is_refused_without_a_read_behind_it(void **state)
{
    (void)state;
    unsigned char bytes[32] = {0};
    const unsigned char counts[3] = {0, 1, 2};
    bytes_put_u32(bytes + 4, 2);
    memcpy(bytes + 8, counts, sizeof counts);
    bytes_put_f64(bytes + 24, 1.0);
    brink b = brink_of(bytes, sizeof bytes);
    tdsp_table table = {.bytes = b.bytes, .length = sizeof bytes, .rows = 2, .departures = 16};
    for (uint64_t cells = 2; cells <= 3; cells++) {
        table.by_departure = (tdsp_guide){.cells = cells, .scale = 1.0, .last = 1.0, .bases = 0, .counts = 8};
        assert_int_equal(check_guides(&table), cells == 2);
    }
    brink_free(b);
}

/* Its bits are those of a great number. */
static void a_table_of_one_row_at_minus_0_answers_departure_0_only(void **state)
{
    (void)state;
    edge e = edge_of(STILL);
    tdsp_table table;
    uint64_t row;
    bytes_put_f64(edge_section(e, FORMAT_DEPARTURES), -0.0);
    golden_seal(e.bytes, e.length);
    assert_int_equal(tdsp_table_open(&table, e.bytes, e.length), TDSP_OK);
    assert_int_equal(tdsp_table_find(&table, 0.0, &row), TDSP_OK);
    assert_int_equal(tdsp_table_find(&table, 1.0, &row), golden_tables[STILL].header.last_reason);
    free(e.bytes);
}

/* The second block of cells as if it started a row earlier, and each of its cells a row later than that. */
static void a_block_that_does_not_start_where_its_first_cell_does_is_refused(void **state)
{
    (void)state;
    writer_row rows[200];
    memset(rows, 0, sizeof rows);
    for (size_t i = 0; i < 200; i++) rows[i] = (writer_row){0.25 * (double)i, 3, 3, NULL, 0, NULL, 0};
    edge e;
    writer_header header = golden_tables[CROWD].header;
    header.last_reason = TDSP_HORIZON;
    header.first_lower = 3;
    e.bytes = golden_rows(&header, rows, 200, &e.length);
    assert_non_null(e.bytes);
    tdsp_table table;
    assert_int_equal(tdsp_table_open(&table, e.bytes, e.length), TDSP_OK);
    assert_true(table.by_departure.cells > 2 * FORMAT_GUIDE_BLOCK);
    unsigned char *base = e.bytes + table.by_departure.bases + 4;
    bytes_put_u32(base, bytes_get_u32(base) - 1);
    for (size_t i = 0; i < FORMAT_GUIDE_BLOCK; i++) e.bytes[table.by_departure.counts + FORMAT_GUIDE_BLOCK + i]++;
    assert_refused(e);
}

/* Two arrivals beside 8 in one cell, the first over it and the second under it by rounding: in order as far as anybody can say, but not in a binary search. */
static void a_guide_to_arrivals_that_fall_by_a_rounding_within_a_cell_is_refused(void **state)
{
    (void)state;
    writer_row rows[20];
    writer_header header = golden_tables[ROAD].header;
    for (size_t i = 0; i < 20; i++) {
        double departure = 0.5 * (double)i, travel = i < 12 ? 8.0 - departure : 3.0;
        rows[i] = (writer_row){departure, travel, travel, NULL, 0, NULL, 0};
    }
    header.first_lower = 8.0;
    const double unit = 0x1p-51; /* a quarter of a unit in the last place of 8 */
    for (int falls = 0; falls < 2; falls++) {
        edge e;
        e.bytes = golden_rows(&header, rows, 20, &e.length);
        assert_non_null(e.bytes);
        tdsp_table table;
        assert_int_equal(tdsp_table_open(&table, e.bytes, e.length), TDSP_OK);
        assert_true(table.by_arrival.cells > 0);
        bytes_put_f64(e.bytes + table.left + 8 * 10, 3.0 + (falls ? 3.0 : 1.0) * unit);
        bytes_put_f64(e.bytes + table.right + 8 * 10, 3.0 + (falls ? 3.0 : 1.0) * unit);
        bytes_put_f64(e.bytes + table.left + 8 * 11, 2.5 + unit);
        bytes_put_f64(e.bytes + table.right + 8 * 11, 2.5 + unit);
        assert_int_equal(edge_open(e), falls ? TDSP_BAD_TABLE : TDSP_OK);
        free(e.bytes);
    }
}

/* Were the header read as a guide, its first word, which nobody looks at once the table is open, would be a row. */
static void a_table_without_guides_is_not_read_as_if_it_had_some(void **state)
{
    (void)state;
    edge e = edge_of(GAP);
    tdsp_table table;
    uint64_t row;
    double lower, upper, low, high;
    assert_int_equal(tdsp_table_open(&table, e.bytes, e.length), TDSP_OK);
    assert_int_equal(tdsp_table_arrival(&table, 1.0, &lower, &upper), TDSP_OK);
    bytes_put_u32(e.bytes, 1);
    assert_int_equal(tdsp_table_find(&table, 1.0, &row), TDSP_OK);
    assert_int_equal(row, 1);
    assert_int_equal(tdsp_table_rows(&table, (const double[]){1.0}, 1, &row, NULL), TDSP_OK);
    assert_int_equal(row, 1);
    assert_int_equal(tdsp_table_arrival(&table, 1.0, &low, &high), TDSP_OK);
    assert_exact(low, lower);
    assert_exact(high, upper);
    free(e.bytes);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_must_be_equal_is_not_equal_to_no_number),
        cmocka_unit_test(a_travel_time_below_0_is_refused_though_arrivals_are_in_order),
        cmocka_unit_test(a_travel_time_that_falls_is_refused_though_every_right_one_is_below_it),
        cmocka_unit_test(a_path_of_one_waypoint_is_refused),
        cmocka_unit_test(waypoints_before_the_first_path_or_behind_the_last_are_refused),
        cmocka_unit_test(a_path_that_ends_before_it_begins_is_refused),
        cmocka_unit_test(where_a_leg_ends_and_the_next_has_a_waypoint_of_its_own_no_arc_begins),
        cmocka_unit_test(every_arc_is_looked_at_not_only_the_first),
        cmocka_unit_test(curves_that_no_leg_has_are_looked_at_too),
        cmocka_unit_test(a_radius_below_0_or_a_rate_over_the_speed_is_refused_however_small_the_curve_looks),
        cmocka_unit_test(a_guide_of_one_cell_needs_a_scale_over_0),
        cmocka_unit_test(a_guide_of_one_row_looks_at_no_row_behind_it),
        cmocka_unit_test(a_guide_that_goes_on_behind_the_last_row_is_refused_without_a_read_behind_it),
        cmocka_unit_test(a_table_of_one_row_at_minus_0_answers_departure_0_only),
        cmocka_unit_test(a_block_that_does_not_start_where_its_first_cell_does_is_refused),
        cmocka_unit_test(a_guide_to_arrivals_that_fall_by_a_rounding_within_a_cell_is_refused),
        cmocka_unit_test(a_table_without_guides_is_not_read_as_if_it_had_some),
    };
    return cmocka_run_group_tests_name("table_edges", tests, NULL, NULL);
}
