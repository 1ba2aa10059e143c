/* SPDX-License-Identifier: MIT */
/* Opening again what was accepted before: the same view, at once; and nothing that could lead a read astray. */
#include "support/cmocka_all.h"

#include <stdlib.h>

#include "base/bytes.h"
#include "support/brink.h"
#include "support/chance.h"
#include "support/sample.h"
#include "support/walk.h"
#include "table/format.h"
#include "table/guide.h"

enum { GAP, ROAD, LOOSE, STILL, CROWD, SWELL, SQUEEZE };

static unsigned char *written(size_t which, size_t *length)
{
    unsigned char *bytes = golden_write(&golden_tables[which], length);
    assert_non_null(bytes);
    return bytes;
}

static void a_table_opened_again_is_the_table_opened(void **state)
{
    (void)state;
    for (size_t which = 0; which < GOLDEN_COUNT; which++) {
        size_t length;
        unsigned char *bytes = written(which, &length);
        tdsp_table first, again;
        memset(&first, 0, sizeof first);
        memset(&again, 0, sizeof again);
        assert_int_equal(tdsp_table_open(&first, bytes, length), TDSP_OK);
        assert_int_equal(tdsp_table_reopen(&again, bytes, length), TDSP_OK);
        assert_memory_equal(&first, &again, sizeof first);
        assert_null(walk_table(&again));
        free(bytes);
    }
}

static void assert_refused(const void *bytes, size_t length, tdsp_status status)
{
    tdsp_table table, before;
    memset(&table, 0x5a, sizeof table);
    before = table;
    assert_int_equal(tdsp_table_reopen(&table, bytes, length), status);
    assert_memory_equal(&table, &before, sizeof table);
}

static void what_is_no_table_of_that_length_is_refused(void **state)
{
    (void)state;
    size_t length;
    tdsp_table table;
    unsigned char *bytes = written(0, &length);
    assert_int_equal(tdsp_table_reopen(NULL, bytes, length), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_table_reopen(&table, NULL, length), TDSP_INVALID_ARGUMENT);
    assert_refused(bytes, 7, TDSP_BAD_MAGIC);
    assert_refused(bytes, 10, TDSP_BAD_LENGTH);
    assert_refused(bytes, length - 8, TDSP_BAD_LENGTH);
    bytes[8]++;
    assert_refused(bytes, length, TDSP_BAD_VERSION);
    free(bytes);
}

/* So many more that their size is, as far as 64 bits go, the one it was. */
static void a_number_whose_size_wraps_around_is_refused(void **state)
{
    (void)state;
    const struct {
        size_t which, at;
        uint64_t more;
    } faults[] = {{CROWD, FORMAT_AT_ROWS, UINT64_C(1) << 61},
                  {GAP, FORMAT_AT_WAYPOINTS, UINT64_C(1) << 59},
                  {SQUEEZE, format_at_offset(FORMAT_GAPS) + FORMAT_FURTHER_AT_COUNT, UINT64_C(1) << 61}};
    for (size_t i = 0; i < sizeof faults / sizeof faults[0]; i++) {
        size_t length;
        unsigned char *bytes = written(faults[i].which, &length);
        bytes_put_u64(bytes + faults[i].at, bytes_get_u64(bytes + faults[i].at) + faults[i].more);
        assert_refused(bytes, length, TDSP_BAD_TABLE);
        free(bytes);
    }
}

/* A header and nothing behind it: even the first row would be read outside. */
static void a_table_of_no_rows_is_refused(void **state)
{
    (void)state;
    size_t length;
    unsigned char *bytes = written(STILL, &length);
    assert_int_equal(bytes_get_u32(bytes + FORMAT_AT_HEADER_LENGTH), FORMAT_HEADER_LENGTH);
    brink b = brink_of(bytes, FORMAT_HEADER_LENGTH);
    bytes_put_u64(b.bytes + FORMAT_AT_LENGTH, FORMAT_HEADER_LENGTH);
    bytes_put_u64(b.bytes + FORMAT_AT_ROWS, 0);
    for (size_t section = 0; section < FORMAT_SECTIONS; section++) bytes_put_u64(b.bytes + format_at_offset(section), FORMAT_HEADER_LENGTH);
    assert_refused(b.bytes, FORMAT_HEADER_LENGTH, TDSP_BAD_TABLE);
    brink_free(b);
    free(bytes);
}

/* It says its length truly, and ends where the memory does. */
static void a_table_shorter_than_a_header_is_refused_by_its_length(void **state)
{
    (void)state;
    size_t length;
    unsigned char *bytes = written(STILL, &length);
    for (size_t less = FORMAT_AT_HEADER_LENGTH; less < FORMAT_HEADER_LENGTH; less++) {
        brink b = brink_of(bytes, less);
        if (less >= FORMAT_AT_LENGTH + 8) bytes_put_u64(b.bytes + FORMAT_AT_LENGTH, less);
        assert_refused(b.bytes, less, TDSP_BAD_LENGTH);
        brink_free(b);
    }
    free(bytes);
}

/* Eight bytes before the end of all numbers: what is there ends among the first bytes again. */
static void a_section_whose_end_wraps_around_is_refused(void **state)
{
    (void)state;
    for (size_t section = 0; section < FORMAT_SECTIONS_2; section++) {
        size_t length;
        unsigned char *bytes = written(section == FORMAT_CURVES ? SWELL : SQUEEZE, &length);
        bytes_put_u16(bytes + FORMAT_AT_MINOR, FORMAT_MINOR + 1);
        bytes_put_u64(bytes + format_at_offset(section), UINT64_MAX - 7);
        assert_refused(bytes, length, TDSP_BAD_TABLE);
        free(bytes);
    }
}

/* As many cells as there are bytes, and with their blocks more than that, so placed that they end where the bytes do. */
static void a_section_larger_than_the_bytes_is_refused_wherever_it_ends(void **state)
{
    (void)state;
    size_t length;
    unsigned char *bytes = written(SWELL, &length);
    const size_t guide = format_at_offset(FORMAT_BY_DEPARTURE);
    bytes_put_u16(bytes + FORMAT_AT_MINOR, FORMAT_MINOR + 1);
    for (size_t section = FORMAT_BY_ARRIVAL; section < FORMAT_SECTIONS_2; section++) bytes_put_u64(bytes + format_at_offset(section), length);
    bytes_put_u64(bytes + format_at_offset(FORMAT_CURVES) + FORMAT_FURTHER_AT_COUNT, 0);
    bytes_put_u64(bytes + guide + FORMAT_GUIDE_AT_CELLS, length);
    bytes_put_u64(bytes + guide, (uint64_t)0 - (guide_size(length) - length) / 8 * 8 - 8);
    assert_refused(bytes, length, TDSP_BAD_TABLE);
    bytes_put_u64(bytes + guide + FORMAT_GUIDE_AT_CELLS, 0);
    bytes_put_u64(bytes + guide, length);
    assert_int_equal(tdsp_table_reopen(&(tdsp_table){0}, bytes, length), TDSP_OK);
    free(bytes);
}

/* The opaque bytes are the last section: 13, and three that fill it up, which are not there. */
static void padding_is_not_looked_for_behind_the_bytes(void **state)
{
    (void)state;
    size_t length;
    unsigned char *bytes = written(ROAD, &length);
    brink b = brink_of(bytes, length - 3);
    bytes_put_u64(b.bytes + FORMAT_AT_LENGTH, length - 3);
    assert_refused(b.bytes, length - 3, TDSP_BAD_TABLE);
    brink_free(b);
    free(bytes);
}

/* Sums are not looked at; every place is. Walking what opens is for the sanitizers to watch: the block ends where the table does. */
static void no_changed_byte_leads_a_read_outside(void **state)
{
    (void)state;
    uint64_t chance = 31;
    size_t opened = 0;
    for (size_t trial = 0; trial < 4000; trial++) {
        size_t length;
        tdsp_table table;
        unsigned char *bytes = written(trial % GOLDEN_COUNT, &length);
        for (size_t i = 0; i < 1 + chance_below(&chance, 3); i++) bytes[chance_below(&chance, i % 2 == 0 && length > 344 ? 344 : length)] = (unsigned char)chance_u64(&chance);
        if (tdsp_table_reopen(&table, bytes, length) == TDSP_OK) {
            opened++;
            (void)walk_table(&table);
        }
        free(bytes);
    }
    assert_in_range(opened, 100, 3900);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_table_opened_again_is_the_table_opened),
        cmocka_unit_test(what_is_no_table_of_that_length_is_refused),
        cmocka_unit_test(a_number_whose_size_wraps_around_is_refused),
        cmocka_unit_test(a_table_of_no_rows_is_refused),
        cmocka_unit_test(a_table_shorter_than_a_header_is_refused_by_its_length),
        cmocka_unit_test(a_section_whose_end_wraps_around_is_refused),
        cmocka_unit_test(a_section_larger_than_the_bytes_is_refused_wherever_it_ends),
        cmocka_unit_test(padding_is_not_looked_for_behind_the_bytes),
        cmocka_unit_test(no_changed_byte_leads_a_read_outside),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
