/* SPDX-License-Identifier: MIT */
/* Parts of the builder by themselves: rows as the last gate before a table, guesses from little, and gaps and paths that contradict themselves. */
#include "support/cmocka_all.h"

#include "build/gap_list.h"
#include "build/rows.h"
#include "build/sampler.h"
#include "build/trail.h"
#include "build/writer.h"
#include "scene/allocator.h"
#include "support/golden.h"

/* ---------------------------------------------------------------------------------------------------------------------------- rows */

static tdsp_status add_after(tdsp_monotone monotone, row first, row next)
{
    tdsp_build_options options;
    tdsp_allocator memory = memory_allocator(NULL);
    kept_path path = kept_path_none();
    rows r;
    tdsp_build_options_init(&options);
    options.epsilon = 0.1;
    options.guarantee = TDSP_GUARANTEE_ARRIVAL;
    assert_int_equal(rows_begin(&r, &options, monotone, &memory), TDSP_OK);
    assert_int_equal(rows_add(&r, &first, &path), TDSP_OK);
    tdsp_status status = rows_add(&r, &next, &path);
    assert_int_equal(r.count, status == TDSP_OK ? 2 : 1);
    rows_release(&r);
    kept_path_release(&path, &memory);
    return status;
}

static void no_row_gets_into_a_table_that_breaks_the_guarantee(void **state)
{
    (void)state;
    const row first = {5.0, 10.0, 12.0};
    assert_int_equal(add_after(TDSP_MONOTONE_TRAVEL, first, (row){6.0, 13.0, 13.0}), TDSP_OK);
    assert_int_equal(add_after(TDSP_MONOTONE_TRAVEL, first, (row){5.0, 13.0, 13.0}), TDSP_BAD_ORACLE);  /* no later */
    assert_int_equal(add_after(TDSP_MONOTONE_TRAVEL, first, (row){NAN, 13.0, 13.0}), TDSP_BAD_ORACLE);
    assert_int_equal(add_after(TDSP_MONOTONE_TRAVEL, first, (row){6.0, 11.0, 13.0}), TDSP_BAD_ORACLE);  /* its upper end is under the lower one */
    assert_int_equal(add_after(TDSP_MONOTONE_TRAVEL, first, (row){6.0, 13.71, 14.0}), TDSP_BAD_ORACLE); /* 12 + 0.1 (5 + 12) is allowed */
    assert_int_equal(add_after(TDSP_MONOTONE_TRAVEL, first, (row){6.0, 13.69, 14.0}), TDSP_OK);
    assert_int_equal(add_after(TDSP_MONOTONE_ARRIVAL, first, (row){7.0, 10.5, 11.0}), TDSP_OK); /* arrivals: 17, then 17.5 */
    assert_int_equal(add_after(TDSP_MONOTONE_ARRIVAL, first, (row){7.0, 9.5, 11.0}), TDSP_BAD_ORACLE);
    assert_int_equal(add_after(TDSP_MONOTONE_ARRIVAL, first, (row){7.0, 12.0, 13.0}), TDSP_BAD_ORACLE);
}

/* --------------------------------------------------------------------------------------------------------------------------- trail */

static sample sample_at(double departure, double value)
{
    return (sample){departure, value, value, value, value, value, TDSP_OK};
}

static void nothing_is_guessed_from_a_point_or_none(void **state)
{
    (void)state;
    const sample first = sample_at(0.0, 3.0), last = sample_at(10.0, 8.0), none = sample_at(4.0, INFINITY);
    trail t = trail_begin(&first, &last);
    assert_true(isnan(trail_predict(&t, 4.0)));
    trail_restart(&t, &none);
    assert_true(isnan(trail_predict(&t, 4.0)));
    const sample after = sample_at(5.0, 5.0), then = sample_at(6.0, 5.5);
    trail_note(&t, &after);
    assert_true(isnan(trail_predict(&t, 6.0)));
    trail_note(&t, &none); /* no way there: nothing to learn */
    trail_note(&t, &then);
    assert_near(trail_predict(&t, 6.0), 7.0, 1e-12);
    trail_restart(&t, &then); /* its pace is still the best guess */
    assert_near(trail_predict(&t, 6.0), 7.0, 1e-12);
}

static void a_trail_forgets_a_sample_in_the_middle_and_neither_the_nearest_nor_the_end(void **state)
{
    (void)state;
    const sample first = sample_at(0.0, 3.0), last = sample_at(1000.0, 1003.0);
    trail t = trail_begin(&first, &last);
    for (int i = 999; i > 500; i--) {
        const sample nearer = sample_at(i, 3.0 + i);
        trail_push_ahead(&t, &nearer);
        assert_true(t.ahead_count <= TRAIL_AHEAD);
        assert_exact(t.ahead[t.ahead_count - 1].departure, i);
        assert_exact(t.ahead[0].departure, 1000.0);
        for (size_t k = 1; k < t.ahead_count; k++) assert_true(t.ahead[k].departure < t.ahead[k - 1].departure);
    }
}

/* ----------------------------------------------------------------------------------------------------------- paths, gaps and the writer */

/* An oracle whose answers get later each time. */
static tdsp_status later_and_later(void *ctx, double departure, double *arrival)
{
    double *travel = ctx;
    *arrival = departure + (*travel += 1.0);
    return TDSP_OK;
}

static void a_path_that_is_worse_when_it_is_asked_for_again_is_refused(void **state)
{
    (void)state;
    double travel = 3.0;
    tdsp_oracle oracle;
    tdsp_allocator memory = memory_allocator(NULL);
    tdsp_oracle_init(&oracle);
    oracle.ctx = &travel;
    oracle.earliest_arrival = later_and_later;
    probe p = probe_over(&oracle, &memory, 0);
    sample s;
    assert_int_equal(probe_forward(&p, 5.0, &s), TDSP_OK);
    assert_int_equal(sampler_recall_path(&p, &s, 4.5), TDSP_BAD_ORACLE);
    assert_int_equal(sampler_recall_path(&p, &s, 7.5), TDSP_OK);
    assert_true(s.upper >= 7.0 && s.upper < 7.1);
    probe_release(&p);
}

static void paths_that_contradict_themselves_are_refused(void **state)
{
    (void)state;
    char byte = 0;
    const tdsp_leg leg = {.kind = TDSP_LEG_LINE};
    const tdsp_oracle_path bad[] = {{NULL, 1, NULL, 0}, {&leg, SIZE_MAX, NULL, 0}, {NULL, 0, NULL, 1}, {NULL, 0, &byte, 0x80000000u}};
    tdsp_allocator memory = memory_allocator(NULL);
    kept_path path = kept_path_none();
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) assert_int_equal(kept_path_copy(&path, &memory, &bad[i], 1.0), TDSP_BAD_ORACLE);
    assert_true(path.departure < 0.0);
    kept_path_release(&path, &memory);
}

static void gaps_of_no_place_or_time_or_disc_are_refused(void **state)
{
    (void)state;
    const tdsp_gap good = {1, 2, 3.0, {4.0, 5.0}};
    tdsp_allocator memory = memory_allocator(NULL);
    gap_list list = {0};
    for (int i = 0; i < 4; i++) {
        tdsp_gap bad = good;
        if (i == 0) bad.first = TDSP_NO_DISC;
        if (i == 1) bad.time = NAN;
        if (i == 2) bad.place.x = INFINITY;
        if (i == 3) bad.place.y = NAN;
        assert_int_equal(gap_list_add(&list, &memory, 0, &bad), TDSP_BAD_ORACLE);
    }
    assert_int_equal(gap_list_add(&list, &memory, 7, &good), TDSP_OK);
    assert_int_equal(gap_list_add(&list, &memory, 7, &good), TDSP_INVALID_ARGUMENT);
    assert_int_equal(list.count, 1);
    gap_list_free(&list, &memory);
}

static void a_writer_wants_somewhere_to_write_to(void **state)
{
    (void)state;
    void *bytes = NULL;
    size_t length;
    writer *w = golden_fill(&golden_tables[3], NULL);
    assert_non_null(w);
    assert_int_equal(writer_finish(NULL, &golden_tables[3].header, &bytes, &length), TDSP_INVALID_ARGUMENT);
    assert_int_equal(writer_finish(w, &golden_tables[3].header, &bytes, NULL), TDSP_INVALID_ARGUMENT);
    assert_null(bytes);
    writer_free(w);
}

/* Legs that join in one coordinate only take two waypoints a joint, as others that do not join. */
static void legs_that_do_not_join_in_one_coordinate_are_kept_as_they_are(void **state)
{
    (void)state;
    for (int axis = 0; axis < 2; axis++) {
        tdsp_leg legs[2] = {{.kind = TDSP_LEG_LINE, .disc = TDSP_NO_DISC, .end_time = 1, .to = {1, 0}},
                            {.kind = TDSP_LEG_LINE, .disc = TDSP_NO_DISC, .start_time = 1, .end_time = 2, .from = {1, 0}, .to = {2, 0}}};
        *(axis ? &legs[1].from.y : &legs[1].from.x) += 1e-12;
        const writer_row only = {0, 2, INFINITY, legs, 2, NULL, 0};
        writer *w;
        void *bytes;
        size_t length;
        tdsp_table table;
        tdsp_leg out;
        assert_int_equal(writer_create(NULL, &w), TDSP_OK);
        assert_int_equal(writer_add(w, &only), TDSP_OK);
        assert_int_equal(writer_finish(w, &golden_tables[2].header, &bytes, &length), TDSP_OK);
        assert_int_equal(tdsp_table_open(&table, bytes, length), TDSP_OK);
        assert_int_equal(table.waypoint_count, 4);
        assert_int_equal(tdsp_table_row_leg(&table, 0, 1, &out), TDSP_OK);
        assert_exact(out.from.x, legs[1].from.x);
        assert_exact(out.from.y, legs[1].from.y);
        tdsp_bytes_free(NULL, bytes, length);
        writer_free(w);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(no_row_gets_into_a_table_that_breaks_the_guarantee),
        cmocka_unit_test(nothing_is_guessed_from_a_point_or_none),
        cmocka_unit_test(a_trail_forgets_a_sample_in_the_middle_and_neither_the_nearest_nor_the_end),
        cmocka_unit_test(a_path_that_is_worse_when_it_is_asked_for_again_is_refused),
        cmocka_unit_test(paths_that_contradict_themselves_are_refused),
        cmocka_unit_test(gaps_of_no_place_or_time_or_disc_are_refused),
        cmocka_unit_test(a_writer_wants_somewhere_to_write_to),
        cmocka_unit_test(legs_that_do_not_join_in_one_coordinate_are_kept_as_they_are),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
