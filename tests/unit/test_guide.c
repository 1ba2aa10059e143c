/* SPDX-License-Identifier: MIT */
/* Guides: the answers with one are to the bit those without; a wrong one is refused; one that turns wrong later leads no read astray. */
#include "support/cmocka_all.h"

#include <stdlib.h>

#include "base/bytes.h"
#include "support/brink.h"
#include "support/chance.h"
#include "support/sample.h"
#include "support/walk.h"
#include "table/format.h"

/* ------------------------------------------------------------------------------------- with a guide and without */

/* The same table as version 1.0 has it: the guides are the last sections, and what comes before them moves up. */
static unsigned char *without_guides(const unsigned char *bytes, size_t *length)
{
    const size_t less = FORMAT_HEADER_LENGTH_1 - FORMAT_HEADER_LENGTH;
    size_t end = (size_t)bytes_get_u64(bytes + format_at_offset(FORMAT_BY_DEPARTURE));
    unsigned char *out = malloc(end - less);
    assert_non_null(out);
    memcpy(out, bytes, FORMAT_HEADER_LENGTH);
    memcpy(out + FORMAT_HEADER_LENGTH, bytes + FORMAT_HEADER_LENGTH_1, end - FORMAT_HEADER_LENGTH_1);
    for (size_t i = 0; i < FORMAT_SECTIONS; i++)
        bytes_put_u64(out + format_at_offset(i), bytes_get_u64(bytes + format_at_offset(i)) - less);
    *length = end - less;
    bytes_put_u16(out + FORMAT_AT_MINOR, 0);
    bytes_put_u32(out + FORMAT_AT_HEADER_LENGTH, FORMAT_HEADER_LENGTH);
    bytes_put_u64(out + FORMAT_AT_LENGTH, *length);
    golden_seal(out, *length);
    return out;
}

static size_t sample_length(const sample *s)
{
    return (size_t)s->table.length;
}

/* Ways in which departures can lie: each returns the step to the next one. */
typedef double crowding(uint64_t *chance, size_t i, double b);

static double evenly(uint64_t *chance, size_t i, double b)
{
    (void)chance, (void)i, (void)b;
    return 0.25;
}

static double anyhow(uint64_t *chance, size_t i, double b)
{
    (void)i, (void)b;
    return chance_between(chance, 1e-6, 1);
}

static double all_but_one_at_the_start(uint64_t *chance, size_t i, double b)
{
    (void)chance, (void)b;
    return i == 1 ? 1e6 : 1e-3;
}

static double all_but_one_at_the_end(uint64_t *chance, size_t i, double b)
{
    (void)chance, (void)b;
    return i == 1 ? 1e6 : 1e-3;
}

static double ever_longer(uint64_t *chance, size_t i, double b)
{
    (void)chance, (void)i;
    return 0.01 + (b < 1e9 ? b / 16 : 1e9);
}

static double neighbours(uint64_t *chance, size_t i, double b)
{
    return i > 1 && chance_below(chance, 50) ? nextafter(b, INFINITY) - b : 1;
}

static double tiny(uint64_t *chance, size_t i, double b)
{
    (void)chance, (void)i, (void)b;
    return 4.9406564584124654e-324;
}

static crowding *const crowdings[] = {evenly, anyhow, all_but_one_at_the_start, all_but_one_at_the_end, ever_longer, neighbours, tiny};
#define CROWDINGS (sizeof crowdings / sizeof crowdings[0])

/* Departures that a crowding makes, in `rows`; those at the start come from the end of the list of steps. */
static void crowd_rows(uint64_t *chance, crowding *step, writer_row *rows, size_t count)
{
    double b = 0, travel = 3;
    memset(rows, 0, count * sizeof *rows);
    for (size_t i = 0; i < count; i++) {
        size_t nth = step == all_but_one_at_the_start ? count - i : i;
        if (i > 0) b += step(chance, nth, b);
        rows[i].departure = b;
        rows[i].left = rows[i].right = travel;
        if (chance_below(chance, 7) == 0) travel += chance_between(chance, 0, 0.5);
        if (chance_below(chance, 3) == 0) rows[i].right = travel;
    }
    rows[count - 1].right = INFINITY;
}

static sample crowded(uint64_t *chance, crowding *step, size_t count)
{
    sample s = {0};
    size_t length;
    writer_header header = golden_tables[2].header;
    header.last_reason = TDSP_CUT_OFF;
    s.rows = malloc(count * sizeof *s.rows);
    assert_non_null(s.rows);
    crowd_rows(chance, step, s.rows, count);
    s.count = count;
    s.travel = 1;
    s.first_lower = header.first_lower = 2;
    s.bytes = golden_rows(&header, s.rows, count, &length);
    assert_non_null(s.bytes);
    assert_int_equal(tdsp_table_open(&s.table, s.bytes, length), TDSP_OK);
    return s;
}

static void assert_same_answers(const tdsp_table *a, const tdsp_table *b, double time)
{
    uint64_t row_a = 7, row_b = 7;
    double low_a = -1, high_a = -1, low_b = -1, high_b = -1;
    assert_int_equal(tdsp_table_find(a, time, &row_a), tdsp_table_find(b, time, &row_b));
    assert_int_equal(row_a, row_b);
    assert_int_equal(tdsp_table_arrival(a, time, &low_a, &high_a), tdsp_table_arrival(b, time, &low_b, &high_b));
    assert_exact(low_a, low_b);
    assert_exact(high_a, high_b);
    assert_int_equal(tdsp_table_departure(a, time, &low_a, &high_a), tdsp_table_departure(b, time, &low_b, &high_b));
    assert_exact(low_a, low_b);
    assert_exact(high_a, high_b);
}

static void compare_with_and_without(uint64_t *chance, const sample *s)
{
    size_t length;
    unsigned char *old = without_guides(s->bytes, &length);
    tdsp_table table;
    const double far[] = {0, -0.0, -1, NAN, INFINITY, -INFINITY, 1e308, 5e-324};
    assert_int_equal(tdsp_table_open(&table, old, length), TDSP_OK);
    assert_true(table.by_departure.bases == 0);
    assert_null(walk_table(&s->table));
    for (int i = 0; i < 200; i++) {
        double t = sample_departure(chance, s);
        uint64_t row;
        assert_same_answers(&s->table, &table, t);
        assert_same_answers(&s->table, &table, sample_arrival(chance, s));
        if (tdsp_table_find(&s->table, t, &row) == TDSP_OK) assert_int_equal(row, sample_scan_row(s, t));
    }
    for (size_t i = 0; i < sizeof far / sizeof far[0]; i++)
        assert_same_answers(&s->table, &table, far[i]);
    double first = table.by_arrival.first, last = table.by_arrival.last;
    for (int k = 0; k < 50; k++) {
        assert_same_answers(&s->table, &table, last + ldexp(last - first, -k));
        assert_same_answers(&s->table, &table, first - ldexp(last - first, -k));
    }
    free(old);
}

static void answers_with_a_guide_are_those_without_however_departures_crowd(void **state)
{
    (void)state;
    uint64_t chance = 21;
    for (size_t round = 0; round < 20 * CROWDINGS; round++) {
        size_t count = 16 + (size_t)chance_below(&chance, round % 20 < 18 ? 100 : 3000);
        sample s = crowded(&chance, crowdings[round % CROWDINGS], count);
        int has = s.table.by_departure.bases != 0;
        assert_int_equal(has, crowdings[round % CROWDINGS] != tiny);
        if (s.table.by_departure.bases || s.table.by_arrival.bases) compare_with_and_without(&chance, &s);
        sample_free(&s);
    }
}

static void answers_of_a_table_monotone_in_arrival_are_those_without_a_guide(void **state)
{
    (void)state;
    uint64_t chance = 22;
    int with = 0;
    for (int round = 0; round < 60; round++) {
        sample s = sample_random(&chance, 16 + (size_t)chance_below(&chance, 200), 0, round % 3);
        with += s.table.by_arrival.bases != 0;
        compare_with_and_without(&chance, &s);
        sample_free(&s);
    }
    assert_true(with > 0 && with < 60);
}

static void a_large_table_has_the_same_answers_too(void **state)
{
    (void)state;
    uint64_t chance = 23;
    for (size_t which = 0; which < CROWDINGS - 1; which++) {
        sample s = crowded(&chance, crowdings[which], 70000);
        compare_with_and_without(&chance, &s);
        sample_free(&s);
    }
}

static void a_table_of_few_rows_has_no_guide_and_is_of_version_1_0(void **state)
{
    (void)state;
    uint64_t chance = 24;
    for (size_t count = 1; count < 20; count++) {
        sample s = crowded(&chance, evenly, count);
        tdsp_table_info info;
        assert_int_equal(tdsp_table_get_info(&s.table, &info), TDSP_OK);
        assert_int_equal(info.version_minor, count < 16 ? 0 : 1);
        assert_int_equal(info.guide_length > 0, count >= 16);
        sample_free(&s);
    }
}

/* ---------------------------------------------------------------------------------------------------- many at once */

static void assert_batch(const tdsp_table *table, const double *times, size_t count)
{
    static double low[3000], high[3000];
    static uint64_t rows[3000];
    static tdsp_status statuses[3000];
    assert_int_equal(tdsp_table_rows(table, times, count, rows, statuses), TDSP_OK);
    for (size_t i = 0; i < count; i++) {
        uint64_t row = table->rows;
        assert_int_equal(statuses[i], tdsp_table_find(table, times[i], &row));
        assert_int_equal(rows[i], row);
    }
    assert_int_equal(tdsp_table_arrivals(table, times, count, low, high, statuses), TDSP_OK);
    for (size_t i = 0; i < count; i++) {
        double l = INFINITY, h = INFINITY;
        assert_int_equal(statuses[i], tdsp_table_arrival(table, times[i], &l, &h));
        assert_exact(low[i], l);
        assert_exact(high[i], h);
    }
    assert_int_equal(tdsp_table_departures(table, times, count, low, high, statuses), TDSP_OK);
    for (size_t i = 0; i < count; i++) {
        double l = -INFINITY, h = -INFINITY;
        assert_int_equal(statuses[i], tdsp_table_departure(table, times[i], &l, &h));
        assert_exact(low[i], l);
        assert_exact(high[i], h);
    }
    assert_int_equal(tdsp_table_rows(table, times, count, NULL, NULL), TDSP_OK);
}

static void batches_of_any_size_answer_as_single_questions_do(void **state)
{
    (void)state;
    uint64_t chance = 25;
    const size_t counts[] = {0, 1, 2, 31, 32, 33, 64, 65, 3000}, sizes[] = {10, 100, 5000};
    static double times[3000];
    for (size_t size = 0; size < 3; size++) {
        sample s = crowded(&chance, anyhow, sizes[size]);
        for (size_t i = 0; i < 3000; i++)
            times[i] = i % 2 ? sample_departure(&chance, &s) : sample_arrival(&chance, &s);
        times[0] = NAN, times[1] = -1, times[30] = INFINITY, times[33] = -INFINITY, times[40] = 1e300;
        for (size_t i = 0; i < sizeof counts / sizeof counts[0]; i++)
            assert_batch(&s.table, times, counts[i]);
        assert_int_equal(tdsp_table_rows(NULL, times, 1, NULL, NULL), TDSP_INVALID_ARGUMENT);
        assert_int_equal(tdsp_table_rows(&s.table, NULL, 1, NULL, NULL), TDSP_INVALID_ARGUMENT);
        sample_free(&s);
    }
}

static void batches_of_a_table_without_guides_answer_as_single_questions_do(void **state)
{
    (void)state;
    uint64_t chance = 26;
    size_t length;
    static double times[3000];
    sample s = crowded(&chance, anyhow, 5000);
    unsigned char *old = without_guides(s.bytes, &length);
    tdsp_table table;
    for (size_t i = 0; i < 3000; i++) times[i] = i % 2 ? sample_departure(&chance, &s) : sample_arrival(&chance, &s);
    assert_int_equal(tdsp_table_open(&table, old, length), TDSP_OK);
    assert_batch(&table, times, 3000);
    free(old);
    sample_free(&s);
}

/* However little behind the guide's last cell or before its first. */
static void batches_of_times_that_no_cell_has_answer_as_single_questions_do(void **state)
{
    (void)state;
    uint64_t chance = 27;
    static double times[3000];
    for (size_t which = 0; which < CROWDINGS - 1; which++) {
        sample s = crowded(&chance, crowdings[which], 5000);
        double first = s.table.by_arrival.first, last = s.table.by_arrival.last;
        for (size_t i = 0; i < 3000; i++) times[i] = i % 2 ? last + (last - first) * exp2(-0.02 * (double)i) : first - (last - first) * exp2(-0.02 * (double)i);
        assert_batch(&s.table, times, 3000);
        sample_free(&s);
    }
}

static void a_batch_reads_no_time_behind_its_last(void **state)
{
    (void)state;
    uint64_t chance = 28;
    sample s = crowded(&chance, anyhow, 5000);
    double times[17];
    for (size_t i = 0; i < 17; i++) times[i] = sample_departure(&chance, &s);
    brink b = brink_of((const unsigned char *)times, sizeof times);
    assert_batch(&s.table, (const double *)(const void *)b.bytes, 17);
    brink_free(b);
    sample_free(&s);
}

/* ---------------------------------------------------------------------------------------------------- wrong guides */

static void any_change_of_a_guide_is_refused(void **state)
{
    (void)state;
    uint64_t chance = 26;
    for (size_t which = 0; which < 4; which++) {
        sample s = crowded(&chance, crowdings[which], 200);
        size_t length = sample_length(&s);
        tdsp_table table;
        for (size_t i = (size_t)bytes_get_u64(s.bytes + format_at_offset(FORMAT_BY_DEPARTURE)); i < length; i++) {
            unsigned char change = (unsigned char)(1u << chance_below(&chance, 8));
            s.bytes[i] ^= change;
            golden_seal(s.bytes, length);
            assert_int_equal(tdsp_table_open(&table, s.bytes, length), TDSP_BAD_TABLE);
            s.bytes[i] ^= change;
        }
        golden_seal(s.bytes, length);
        assert_int_equal(tdsp_table_open(&table, s.bytes, length), TDSP_OK);
        sample_free(&s);
    }
}

static void a_guide_of_other_cells_or_scale_or_place_is_refused(void **state)
{
    (void)state;
    uint64_t chance = 27;
    const double scales[] = {0, -1, NAN, INFINITY, 5e-324, 1e300};
    const uint64_t cells[] = {0, 1, 600, UINT64_C(0xffffffff), UINT64_C(0x100000000), UINT64_MAX};
    for (size_t section = FORMAT_BY_DEPARTURE; section <= FORMAT_BY_ARRIVAL; section++) {
        for (size_t i = 0; i < 18; i++) {
            sample s = crowded(&chance, evenly, 100);
            unsigned char *place = s.bytes + format_at_offset(section);
            if (i < 6) bytes_put_f64(place + FORMAT_GUIDE_AT_SCALE, scales[i]);
            else if (i < 12) bytes_put_u64(place + FORMAT_GUIDE_AT_CELLS, cells[i - 6]);
            else bytes_put_u64(place, bytes_get_u64(place) + 8 * (i - 11) - 32);
            golden_seal(s.bytes, sample_length(&s));
            int same = i == 15;
            assert_int_equal(tdsp_table_open(&s.table, s.bytes, sample_length(&s)), same ? TDSP_OK : TDSP_BAD_TABLE);
            sample_free(&s);
        }
    }
}

static void a_guide_to_departures_from_minus_0_is_refused(void **state)
{
    (void)state;
    uint64_t chance = 28;
    sample s = crowded(&chance, evenly, 100);
    bytes_put_f64(s.bytes + bytes_get_u64(s.bytes + format_at_offset(FORMAT_DEPARTURES)), -0.0);
    golden_seal(s.bytes, sample_length(&s));
    assert_int_equal(tdsp_table_open(&s.table, s.bytes, sample_length(&s)), TDSP_BAD_TABLE);
    sample_free(&s);
}

static void a_table_without_a_guide_may_start_at_minus_0(void **state)
{
    (void)state;
    uint64_t chance = 29;
    size_t length, count = 40;
    sample s = crowded(&chance, evenly, count);
    unsigned char *old = without_guides(s.bytes, &length);
    tdsp_table table;
    bytes_put_f64(old + bytes_get_u64(old + format_at_offset(FORMAT_DEPARTURES)), -0.0);
    golden_seal(old, length);
    assert_int_equal(tdsp_table_open(&table, old, length), TDSP_OK);
    for (int i = 0; i < 300; i++) {
        uint64_t row = 7;
        double t = sample_departure(&chance, &s);
        if (tdsp_table_find(&table, t, &row) == TDSP_OK) assert_int_equal(row, sample_scan_row(&s, t));
    }
    free(old);
    sample_free(&s);
}

static void guides_that_change_after_opening_lead_no_read_outside(void **state)
{
    (void)state;
    uint64_t chance = 30;
    static double times[300], low[300], high[300];
    for (int round = 0; round < 400; round++) {
        sample s = crowded(&chance, crowdings[round % 4], round % 40 ? 60 : 2500);
        size_t length = sample_length(&s), from = (size_t)bytes_get_u64(s.bytes + format_at_offset(FORMAT_BY_DEPARTURE));
        for (int i = 0; i < 300; i++)
            times[i] = i % 2 ? sample_departure(&chance, &s) : sample_arrival(&chance, &s);
        if (round % 2) from = FORMAT_HEADER_LENGTH_1;
        for (size_t i = 0; i < length / 2; i++)
            s.bytes[from + chance_below(&chance, length - from)] = (unsigned char)(round % 3 ? chance_u64(&chance) : 0xff);
        (void)walk_table(&s.table);
        (void)tdsp_table_arrivals(&s.table, times, 300, low, high, NULL);
        (void)tdsp_table_departures(&s.table, times, 300, low, high, NULL);
        sample_free(&s);
    }
}

/* No opened table has such a view; what keeps its reads inside is there all the same, each for itself. */
static void a_view_that_was_overwritten_is_read_inside_its_bytes(void **state)
{
    (void)state;
    uint64_t chance = 31;
    static double times[300], low[300], high[300];
    const double scales[] = {NAN, -1e9, INFINITY, 1e300, 0, 1};
    for (int round = 0; round < 400; round++) {
        sample s = crowded(&chance, crowdings[round % 4], round % 40 ? 60 : 2500);
        tdsp_table view = s.table;
        tdsp_guide *guide = round % 2 ? &view.by_departure : &view.by_arrival;
        for (int i = 0; i < 300; i++) times[i] = i % 2 ? sample_departure(&chance, &s) : sample_arrival(&chance, &s);
        if (round % 4 < 2) guide->bases = chance_u64(&chance) | 1;
        if (round % 3 == 0) guide->counts = round % 5 ? view.length - chance_below(&chance, 9) : chance_u64(&chance);
        if (round % 7 < 6) guide->scale = scales[round % 7];
        view.waypoints = view.arcs = view.curves = view.gaps = view.first_byte = chance_u64(&chance);
        view.first_waypoint = view.opaque = view.length - chance_below(&chance, 40);
        (void)walk_table(&view);
        (void)tdsp_table_arrivals(&view, times, 300, low, high, NULL);
        (void)tdsp_table_departures(&view, times, 300, low, high, NULL);
        sample_free(&s);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(answers_with_a_guide_are_those_without_however_departures_crowd),
        cmocka_unit_test(answers_of_a_table_monotone_in_arrival_are_those_without_a_guide),
        cmocka_unit_test(a_large_table_has_the_same_answers_too),
        cmocka_unit_test(a_table_of_few_rows_has_no_guide_and_is_of_version_1_0),
        cmocka_unit_test(batches_of_any_size_answer_as_single_questions_do),
        cmocka_unit_test(batches_of_a_table_without_guides_answer_as_single_questions_do),
        cmocka_unit_test(batches_of_times_that_no_cell_has_answer_as_single_questions_do),
        cmocka_unit_test(a_batch_reads_no_time_behind_its_last),
        cmocka_unit_test(any_change_of_a_guide_is_refused),
        cmocka_unit_test(a_guide_of_other_cells_or_scale_or_place_is_refused),
        cmocka_unit_test(a_guide_to_departures_from_minus_0_is_refused),
        cmocka_unit_test(a_table_without_a_guide_may_start_at_minus_0),
        cmocka_unit_test(guides_that_change_after_opening_lead_no_read_outside),
        cmocka_unit_test(a_view_that_was_overwritten_is_read_inside_its_bytes),
    };
    return cmocka_run_group_tests_name("guide", tests, NULL, NULL);
}
