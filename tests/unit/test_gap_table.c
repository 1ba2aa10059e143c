/* SPDX-License-Identifier: MIT */
/* What closes at jumps, in tables: read, refused when it is wrong, asked of an oracle that knows, and written. */
#include "support/cmocka_all.h"
#include "support/tight.h"

#include <stdlib.h>

#include "base/bytes.h"
#include "support/golden.h"
#include "support/toy_tables.h"
#include "support/world.h"
#include "table/format.h"

static unsigned char *squeeze_bytes(size_t *length)
{
    unsigned char *bytes = golden_write(&golden_tables[6], length);
    assert_non_null(bytes);
    return bytes;
}

static void a_jump_comes_with_its_gap_where_the_table_says_it(void **state)
{
    (void)state;
    size_t length;
    unsigned char *bytes = squeeze_bytes(&length);
    tdsp_table table;
    tdsp_table_info info;
    tdsp_jump jump;
    assert_int_equal(tdsp_table_open(&table, bytes, length), TDSP_OK);
    assert_int_equal(tdsp_table_get_info(&table, &info), TDSP_OK);
    assert_int_equal(info.gaps, 2);
    assert_int_equal(tdsp_table_next_jump(&table, 0.0, &jump), TDSP_OK);
    assert_int_equal(jump.gap.first, 3);
    assert_int_equal(jump.gap.second, 7);
    assert_exact(jump.gap.time, 2.5);
    assert_exact(jump.gap.place.x, 0.25);
    assert_exact(jump.gap.place.y, -1.0);
    assert_int_equal(tdsp_table_next_jump(&table, 0.5, &jump), TDSP_OK);
    assert_int_equal(jump.row, 1);
    assert_int_equal(jump.gap.first, TDSP_NO_DISC);
    assert_int_equal(jump.gap.second, TDSP_NO_DISC);
    assert_exact(jump.gap.time, 0.0);
    assert_int_equal(tdsp_table_previous_jump(&table, 6.0, &jump), TDSP_OK);
    assert_int_equal(jump.row, 2);
    assert_int_equal(jump.gap.second, 4000000000u);
    free(bytes);
}

static void a_table_that_does_not_say_it_has_jumps_without_gaps(void **state)
{
    (void)state;
    size_t length;
    unsigned char *bytes = golden_write(&golden_tables[0], &length);
    tdsp_table table;
    tdsp_jump jump;
    assert_int_equal(tdsp_table_open(&table, bytes, length), TDSP_OK);
    assert_int_equal(tdsp_table_next_jump(&table, 0.0, &jump), TDSP_OK);
    assert_int_equal(jump.gap.first, TDSP_NO_DISC);
    free(bytes);
}

static size_t gaps_at(const unsigned char *bytes)
{
    return (size_t)bytes_get_u64(bytes + format_at_offset(FORMAT_GAPS));
}

/* A later version may put anything behind the last gap, such as what looks like the gap of a jump that comes without. */
static void what_stands_behind_the_last_gap_is_no_gap(void **state)
{
    (void)state;
    size_t length;
    unsigned char *bytes = squeeze_bytes(&length);
    tdsp_table table;
    tdsp_jump jump;
    bytes_put_u16(bytes + FORMAT_AT_MINOR, FORMAT_MINOR + 1);
    bytes_put_u64(bytes + format_at_offset(FORMAT_GAPS) + FORMAT_FURTHER_AT_COUNT, 1);
    golden_seal(bytes, length);
    assert_int_equal(tdsp_table_open(&table, bytes, length), TDSP_OK);
    assert_int_equal(tdsp_table_previous_jump(&table, 6.0, &jump), TDSP_OK);
    assert_int_equal(jump.row, 2);
    assert_int_equal(jump.gap.first, TDSP_NO_DISC);
    free(bytes);
}

static void refused(size_t at, uint64_t value)
{
    size_t length;
    unsigned char *bytes = squeeze_bytes(&length);
    tdsp_table table;
    bytes_put_u64(bytes + at, value);
    golden_seal(bytes, length);
    if (tdsp_table_open(&table, bytes, length) != TDSP_BAD_TABLE) fail_msg("%zu: %llu was not refused", at, (unsigned long long)value);
    free(bytes);
}

static void wrong_gaps_are_refused(void **state)
{
    (void)state;
    const uint64_t nan = UINT64_C(0x7ff8000000000000), infinity = UINT64_C(0x7ff0000000000000);
    const size_t header = format_at_offset(FORMAT_GAPS);
    size_t length;
    unsigned char *bytes = squeeze_bytes(&length);
    const size_t at = gaps_at(bytes), second = at + FORMAT_GAP_SIZE;
    free(bytes);
    refused(header, 0);
    refused(header, at + 8);
    refused(header + FORMAT_FURTHER_AT_COUNT, 1);
    refused(header + FORMAT_FURTHER_AT_COUNT, 3);
    refused(header + FORMAT_FURTHER_AT_COUNT, UINT64_MAX / FORMAT_GAP_SIZE + 1);
    refused(at + FORMAT_GAP_AT_ROW, 2);  /* as the one after */
    refused(at + FORMAT_GAP_AT_ROW, 3);  /* after it */
    refused(second + FORMAT_GAP_AT_ROW, 4); /* no row */
    refused(second + FORMAT_GAP_AT_ROW, UINT64_MAX);
    refused(at + FORMAT_GAP_AT_FIRST, UINT64_C(0x00000007ffffffff)); /* nobody */
    refused(at + FORMAT_GAP_AT_TIME, nan);
    refused(at + FORMAT_GAP_AT_TIME, infinity);
    refused(second + FORMAT_GAP_AT_PLACE, nan);
    refused(second + FORMAT_GAP_AT_PLACE + 8, infinity);
}

static void the_writer_takes_gaps_in_order_and_of_rows_that_it_has(void **state)
{
    (void)state;
    const tdsp_gap good = {0, 1, 0, {0, 0}}, nobody = {TDSP_NO_DISC, 1, 0, {0, 0}}, never = {0, 1, INFINITY, {0, 0}}, nowhere = {0, 1, 0, {0, NAN}};
    writer *w = golden_fill(&golden_tables[0], NULL);
    assert_non_null(w);
    assert_int_equal(writer_count(w), 4);
    assert_exact(writer_row_at(w, 2).departure, 9.75);
    assert_int_equal(writer_add_gap(w, 4, &good), TDSP_INVALID_ARGUMENT);
    assert_int_equal(writer_add_gap(w, 2, &nobody), TDSP_BAD_ORACLE);
    assert_int_equal(writer_add_gap(w, 2, &never), TDSP_BAD_ORACLE);
    assert_int_equal(writer_add_gap(w, 2, &nowhere), TDSP_BAD_ORACLE);
    assert_int_equal(writer_add_gap(w, 2, &good), TDSP_OK);
    assert_int_equal(writer_add_gap(w, 2, &good), TDSP_INVALID_ARGUMENT);
    assert_int_equal(writer_add_gap(w, 1, &good), TDSP_INVALID_ARGUMENT);
    writer_free(w);
}

/* A toy world that jumps at 3 and 7, and an oracle that knows what closes at 7 only. */
typedef struct teller {
    tdsp_oracle sound;
    size_t asked;
    tdsp_status fails;
} teller;

static tdsp_status tell_arrival(void *ctx, double departure, double *arrival)
{
    teller *t = ctx;
    return t->sound.earliest_arrival(t->sound.ctx, departure, arrival);
}

static tdsp_status tell_gap(void *ctx, double departure, double before, double after, tdsp_gap *out)
{
    teller *t = ctx;
    assert_true(after > before);
    ++t->asked;
    if (t->fails != TDSP_OK) return t->fails;
    if (departure < 5) return TDSP_NO_ANSWER;
    *out = (tdsp_gap){11, 12, departure + 1, {before, after}};
    return TDSP_OK;
}

static const toy_piece steps[] = {{3, 5, 0, 0}, {7, 8, 0, 0}, {9, 12, 0, 0}};

static tdsp_oracle telling(teller *t, toy *steady, tdsp_status fails)
{
    tdsp_oracle oracle;
    *steady = toy_over(steps, 3, 0);
    *t = (teller){toy_oracle(steady, 1), 0, fails};
    tdsp_oracle_init(&oracle);
    oracle.ctx = t;
    oracle.earliest_arrival = tell_arrival;
    oracle.jump_gap = tell_gap;
    return oracle;
}

static void the_sampler_asks_about_each_jump_and_keeps_what_it_is_told(void **state)
{
    (void)state;
    teller t;
    toy steady;
    tdsp_oracle oracle = telling(&t, &steady, TDSP_OK);
    tdsp_build_options options;
    tdsp_jump jump;
    tdsp_build_options_init(&options);
    toy_table built = toy_build(&oracle, &options);
    assert_int_equal(t.asked, 2);
    assert_int_equal(built.report.gaps, 1);
    assert_int_equal(tdsp_table_next_jump(&built.table, 0, &jump), TDSP_OK);
    assert_int_equal(jump.gap.first, TDSP_NO_DISC);
    assert_int_equal(tdsp_table_next_jump(&built.table, 4, &jump), TDSP_OK);
    assert_exact(jump.departure, 7.0);
    assert_int_equal(jump.gap.first, 11);
    assert_exact(jump.gap.time, 8.0);
    assert_exact(jump.gap.place.x, jump.before);
    assert_exact(jump.gap.place.y, jump.after);
    toy_table_free(&built);
}

static void without_the_callback_the_bytes_are_as_ever(void **state)
{
    (void)state;
    teller t;
    toy steady;
    tdsp_oracle telling_one = telling(&t, &steady, TDSP_NO_ANSWER), silent = telling_one;
    tdsp_build_options options;
    tdsp_build_options_init(&options);
    silent.jump_gap = NULL;
    toy_table one = toy_build(&telling_one, &options), other = toy_build(&silent, &options);
    assert_int_equal(t.asked, 2);
    assert_int_equal(one.length, other.length);
    assert_memory_equal(one.bytes, other.bytes, one.length);
    assert_int_equal(one.report.gaps, 0);
    toy_table_free(&one);
    toy_table_free(&other);
}

static void a_callback_that_fails_ends_the_build(void **state)
{
    (void)state;
    teller t;
    toy steady;
    tdsp_oracle oracle = telling(&t, &steady, TDSP_FAILED);
    tdsp_build_options options;
    void *bytes;
    size_t length;
    tdsp_build_options_init(&options);
    assert_int_equal(tdsp_build(&oracle, &options, NULL, &bytes, &length, NULL), TDSP_FAILED);
}

static void every_allocation_may_fail_with_gaps_too(void **state)
{
    (void)state;
    tdsp_build_options options;
    tdsp_status status = TDSP_NO_MEMORY;
    tdsp_build_options_init(&options);
    for (size_t refuse = 1; status != TDSP_OK; refuse++) {
        teller t;
        toy steady;
        tight_heap heap = {.refuse = refuse};
        tdsp_oracle oracle = telling(&t, &steady, TDSP_OK);
        tdsp_allocator memory = tight_allocator(&heap);
        void *bytes = NULL;
        size_t length;
        status = tdsp_build(&oracle, &options, &memory, &bytes, &length, NULL);
        if (status == TDSP_OK) tdsp_bytes_free(&memory, bytes, length);
        assert_true(status == TDSP_OK || status == TDSP_NO_MEMORY);
        assert_int_equal(heap.blocks, 0);
    }
}

static void a_table_of_a_scene_says_which_discs_close(void **state)
{
    (void)state;
    const tdsp_journey across = {1.0, 0.0, {-10.0, 0.0}, {10.0, 0.0}};
    const tdsp_disc gate[] = {{{0.0, 3.0}, 1.0, 0.1}, {{0.0, -3.0}, 1.0, 0.1}};
    world w = world_make(across, gate, 2);
    tdsp_oracle oracle;
    tdsp_build_options options;
    tdsp_jump jump;
    assert_int_equal(tdsp_solver_oracle(w.solver, &oracle), TDSP_OK);
    tdsp_build_options_init(&options);
    toy_table built = toy_build(&oracle, &options);
    assert_int_equal(built.report.gaps, 1);
    assert_int_equal(tdsp_table_next_jump(&built.table, 0, &jump), TDSP_OK);
    assert_int_equal(jump.gap.first, 0);
    assert_int_equal(jump.gap.second, 1);
    assert_near(jump.gap.time, (3.0 / sqrt(0.99) - 1.0) / 0.1, 1e-8);
    assert_near(jump.gap.place.x, 0.3 / sqrt(0.99), 1e-8);
    toy_table_free(&built);
    world_free(w);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_jump_comes_with_its_gap_where_the_table_says_it),
        cmocka_unit_test(a_table_that_does_not_say_it_has_jumps_without_gaps),
        cmocka_unit_test(what_stands_behind_the_last_gap_is_no_gap),
        cmocka_unit_test(wrong_gaps_are_refused),
        cmocka_unit_test(the_writer_takes_gaps_in_order_and_of_rows_that_it_has),
        cmocka_unit_test(the_sampler_asks_about_each_jump_and_keeps_what_it_is_told),
        cmocka_unit_test(without_the_callback_the_bytes_are_as_ever),
        cmocka_unit_test(a_callback_that_fails_ends_the_build),
        cmocka_unit_test(every_allocation_may_fail_with_gaps_too),
        cmocka_unit_test(a_table_of_a_scene_says_which_discs_close),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
