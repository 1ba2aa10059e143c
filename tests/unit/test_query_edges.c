/* SPDX-License-Identifier: MIT */
/* Look-ups at the edge: numbers that rounding moves, paths of no legs, and bytes that change after opening. */
#include "support/cmocka_all.h"

#include <stdlib.h>

#include "base/bytes.h"
#include "support/brink.h"
#include "support/chance.h"
#include "support/golden.h"
#include "support/walk.h"
#include "table/format.h"
#include "tdsp/table.h"

enum { GAP, ROAD, LOOSE, STILL, CROWD, SWELL, SQUEEZE };

/* Golden table `gap` is monotone in travel; its rows have the waypoints 0 to 1, 2 to 5, 6 to 10 and 11 to 12. */
typedef struct edge {
    unsigned char *bytes;
    size_t length;
    tdsp_table table;
} edge;

static edge edge_of(size_t which)
{
    edge e;
    e.bytes = golden_write(&golden_tables[which], &e.length);
    assert_non_null(e.bytes);
    return e;
}

static void edge_open(edge *e)
{
    golden_seal(e->bytes, e->length);
    assert_int_equal(tdsp_table_open(&e->table, e->bytes, e->length), TDSP_OK);
}

static void edge_put(edge *e, size_t section, size_t row, double value)
{
    bytes_put_f64(e->bytes + bytes_get_u64(e->bytes + format_at_offset(section)) + 8 * row, value);
}

static void edge_put_time(edge *e, size_t waypoint, double time)
{
    bytes_put_f64(e->bytes + bytes_get_u64(e->bytes + format_at_offset(FORMAT_WAYPOINTS)) + FORMAT_WAYPOINT_SIZE * waypoint + FORMAT_WAYPOINT_AT_TIME, time);
}

/* -------------------------------------------------------------------------------------------------------------- paths */

/* Taken away from this time and added again, half a unit in its last place would be lost. */
static void at_its_own_departure_a_path_has_the_times_that_are_stored(void **state)
{
    (void)state;
    const double departure = 0x1p-50, time = 12.5 + 0x1p-49;
    edge e = edge_of(GAP);
    tdsp_leg leg;
    edge_put(&e, FORMAT_DEPARTURES, 1, departure);
    edge_put_time(&e, 2, departure);
    edge_put_time(&e, 3, time);
    edge_put_time(&e, 5, 20.5);
    edge_open(&e);
    assert_true(departure + (time - departure) != time);
    assert_int_equal(tdsp_table_leg(&e.table, departure, 0, &leg), TDSP_OK);
    assert_exact(leg.start_time, departure);
    assert_exact(leg.end_time, time);
    free(e.bytes);
}

/* What is stored ends with a sum rounded up; leaving earlier, the sum is below 32, where doubles are twice as dense, and exact. */
static void a_path_that_leaves_earlier_ends_by_the_certified_arrival(void **state)
{
    (void)state;
    const double left = 24.75 + 0x1p-48, end = 37.25 + 0x1p-47;
    edge e = edge_of(GAP);
    tdsp_leg leg;
    double upper;
    edge_put(&e, FORMAT_DEPARTURES, 2, 5);
    edge_put_time(&e, 6, 5);
    edge_put_time(&e, 10, 25.75);
    edge_put(&e, FORMAT_LEFT, 3, left);
    edge_put_time(&e, 12, end);
    edge_open(&e);
    assert_int_equal(tdsp_table_arrival(&e.table, 6, NULL, &upper), TDSP_OK);
    assert_true(6 + (end - 12.5) > upper);
    assert_int_equal(tdsp_table_leg(&e.table, 6, 0, &leg), TDSP_OK);
    assert_exact(leg.end_time, upper);
    free(e.bytes);
}

static void a_path_of_no_legs_needs_no_room(void **state)
{
    (void)state;
    edge e = edge_of(STILL);
    size_t count = 7;
    edge_open(&e);
    assert_int_equal(tdsp_table_path(&e.table, 0, NULL, 0, &count), TDSP_OK);
    assert_int_equal(count, 0);
    free(e.bytes);
}

/* --------------------------------------------------------------------------------------------------------- departures */

static tdsp_table open_rows(writer_header header, const writer_row *rows, size_t count, brink *b)
{
    size_t length;
    tdsp_table table;
    unsigned char *bytes = golden_rows(&header, rows, count, &length);
    assert_non_null(bytes);
    *b = brink_of(bytes, length);
    free(bytes);
    assert_int_equal(tdsp_table_open(&table, b->bytes, length), TDSP_OK);
    return table;
}

/* All arrive at 8, and are said to arrive a quarter of a unit in its last place later when one leaves just after: as far as sums of doubles go, at 8. */
static void departures_are_bounded_by_the_last_row_that_may_be_followed_however_many_lie_between(void **state)
{
    (void)state;
    for (size_t count = 1; count <= 40; count++) {
        writer_row rows[42];
        brink b;
        double departure, upper;
        memset(rows, 0, sizeof rows);
        rows[0].left = rows[0].right = 8;
        for (size_t i = 1; i <= count; i++) {
            rows[i].departure = 4 + (double)i / 32;
            rows[i].left = 8 - rows[i].departure;
            rows[i].right = rows[i].left + 0x1p-51;
        }
        rows[count + 1] = (writer_row){7, 3, 3.5, NULL, 0, NULL, 0};
        tdsp_table table = open_rows(golden_tables[ROAD].header, rows, count + 2, &b);
        assert_int_equal(tdsp_table_departure(&table, 8, &departure, &upper), TDSP_OK);
        assert_exact(departure, rows[count].departure);
        assert_exact(upper, rows[1].departure);
        brink_free(b);
    }
}

/* Where nothing is known to arrive in time after the first row, and nothing to be late up to the horizon. */
static void departures_up_to_a_horizon_are_bounded_without_a_read_behind_it(void **state)
{
    (void)state;
    for (size_t count = 1; count <= 40; count++) {
        writer_row rows[41];
        writer_header header = golden_tables[LOOSE].header;
        brink b;
        double departure, upper;
        memset(rows, 0, sizeof rows);
        header.last_reason = TDSP_HORIZON;
        for (size_t i = 0; i <= count; i++) {
            rows[i].departure = (double)i / 16;
            rows[i].left = i > 0 ? 20 : 8;
            rows[i].right = 8;
        }
        tdsp_table table = open_rows(header, rows, count + 1, &b);
        assert_int_equal(tdsp_table_departure(&table, 12, &departure, &upper), TDSP_OK);
        assert_exact(departure, 0);
        assert_exact(upper, 4);
        brink_free(b);
    }
}

/* ------------------------------------------------------------------------------------------------------ changed bytes */

#define TIMES 40

static void ask_everything(const tdsp_table *table)
{
    double times[TIMES], low[TIMES], high[TIMES];
    uint64_t rows[TIMES];
    (void)walk_table(table);
    for (size_t i = 0; i < TIMES; i++) times[i] = table->by_arrival.last * (double)i / (TIMES - 2);
    for (size_t i = 0; i < TIMES; i++) {
        (void)tdsp_table_find(table, times[i], rows);
        (void)tdsp_table_departure(table, times[i], low, high);
    }
    (void)tdsp_table_rows(table, times, TIMES, rows, NULL);
    (void)tdsp_table_arrivals(table, times, TIMES, low, high, NULL);
    (void)tdsp_table_departures(table, times, TIMES, low, high, NULL);
}

/* The last departures become 0 after opening: nothing is as late as what is asked for but what stands behind them, which is travel times. */
static void of_changed_departures_no_row_is_found_that_is_none(void **state)
{
    (void)state;
    for (size_t changed = 1; changed < 20; changed++) {
        writer_row rows[20];
        brink b;
        uint64_t row;
        for (size_t i = 0; i < 20; i++) rows[i] = (writer_row){0.5 * (double)i, 1000, i < 19 ? 1000 : INFINITY, NULL, 0, NULL, 0};
        tdsp_table table = open_rows(golden_tables[CROWD].header, rows, 20, &b);
        assert_true(table.by_departure.cells > 20);
        memset(b.bytes + table.departures + 8 * (20 - changed), 0, 8 * changed);
        for (size_t i = 1; i < 20; i++) {
            assert_int_equal(tdsp_table_find(&table, rows[i].departure, &row), TDSP_OK);
            assert_in_range(row, 0, 19);
        }
        brink_free(b);
    }
}

/* Of ones, of zeros, of small numbers, and by chance; behind the header, or in one section only. */
static void change(uint64_t *chance, const tdsp_table *table, unsigned char *bytes, int trial)
{
    size_t from = bytes_get_u32(bytes + FORMAT_AT_HEADER_LENGTH), end = (size_t)table->length;
    if (trial % 2) from += (size_t)chance_below(chance, end - from), end = from + (size_t)chance_below(chance, end - from) + 1;
    for (size_t i = from; i < end; i++) {
        const unsigned char by[] = {0xff, 0, (unsigned char)(i % 8 == 0), (unsigned char)chance_u64(chance)};
        bytes[i] = by[trial / 2 % 4];
    }
}

/* The table ends where the memory does. */
static void no_question_about_changed_bytes_reads_behind_them(void **state)
{
    (void)state;
    uint64_t chance = 29;
    for (size_t which = 0; which < GOLDEN_COUNT; which++) {
        for (int trial = 0; trial < 400; trial++) {
            edge e = edge_of(which);
            tdsp_table table;
            brink b = brink_of(e.bytes, e.length);
            assert_int_equal(tdsp_table_open(&table, b.bytes, e.length), TDSP_OK);
            change(&chance, &table, b.bytes, trial);
            ask_everything(&table);
            brink_free(b);
            free(e.bytes);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(at_its_own_departure_a_path_has_the_times_that_are_stored),
        cmocka_unit_test(a_path_that_leaves_earlier_ends_by_the_certified_arrival),
        cmocka_unit_test(a_path_of_no_legs_needs_no_room),
        cmocka_unit_test(departures_are_bounded_by_the_last_row_that_may_be_followed_however_many_lie_between),
        cmocka_unit_test(departures_up_to_a_horizon_are_bounded_without_a_read_behind_it),
        cmocka_unit_test(of_changed_departures_no_row_is_found_that_is_none),
        cmocka_unit_test(no_question_about_changed_bytes_reads_behind_them),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
