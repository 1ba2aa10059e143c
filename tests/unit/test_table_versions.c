/* SPDX-License-Identifier: MIT */
/* What a later minor version may put where, and a version that is known may not. */
#include "support/cmocka_all.h"

#include <stdlib.h>

#include "base/bytes.h"
#include "support/golden.h"
#include "support/walk.h"
#include "table/format.h"
#include "tdsp/table.h"

enum { GAP, ROAD, LOOSE, STILL, CROWD, SWELL, SQUEEZE };

static const uint64_t nothing[FORMAT_SECTIONS_2];

/* The table as a later version may have it: `more` bytes more in its header and, unless it is NULL, eight more behind each section, a number for each. */
static unsigned char *with_room(size_t which, size_t more, const uint64_t behind[FORMAT_SECTIONS_2], size_t *length)
{
    unsigned char *old = golden_write(&golden_tables[which], length);
    assert_non_null(old);
    assert_int_equal(bytes_get_u16(old + FORMAT_AT_MINOR), FORMAT_MINOR);
    size_t at = FORMAT_HEADER_LENGTH_2, end = *length, room = behind ? 8 : 0;
    *length = end + more + room * FORMAT_SECTIONS_2;
    unsigned char *bytes = calloc(*length, 1);
    assert_non_null(bytes);
    memcpy(bytes, old, at);
    for (size_t i = 0; i < FORMAT_SECTIONS_2; i++) {
        size_t next = i + 1 < FORMAT_SECTIONS_2 ? (size_t)bytes_get_u64(old + format_at_offset(i + 1)) : end;
        size_t moved = more + room * i;
        memcpy(bytes + at + moved, old + at, next - at);
        if (behind) bytes_put_u64(bytes + next + moved, behind[i]);
        bytes_put_u64(bytes + format_at_offset(i), at + moved);
        at = next;
    }
    bytes_put_u16(bytes + FORMAT_AT_MINOR, FORMAT_MINOR + 1);
    bytes_put_u32(bytes + FORMAT_AT_HEADER_LENGTH, (uint32_t)(FORMAT_HEADER_LENGTH_2 + more));
    bytes_put_u64(bytes + FORMAT_AT_LENGTH, *length);
    golden_seal(bytes, *length);
    free(old);
    return bytes;
}

static tdsp_status open_sealed(unsigned char *bytes, size_t length)
{
    tdsp_table table;
    golden_seal(bytes, length);
    return tdsp_table_open(&table, bytes, length);
}

static void assert_same_jumps(const tdsp_table *a, const tdsp_table *b)
{
    const double times[] = {0, 0.5, 1.5, 2.5, 1e9};
    for (size_t i = 0; i < sizeof times / sizeof times[0]; i++) {
        tdsp_jump one, other;
        memset(&one, 0, sizeof one);
        memset(&other, 0, sizeof other);
        assert_int_equal(tdsp_table_next_jump(a, times[i], &one), tdsp_table_next_jump(b, times[i], &other));
        assert_memory_equal(&one, &other, sizeof one);
        assert_int_equal(tdsp_table_previous_jump(a, times[i], &one), tdsp_table_previous_jump(b, times[i], &other));
        assert_memory_equal(&one, &other, sizeof one);
    }
}

static void assert_same_tables(const tdsp_table *a, const tdsp_table *b)
{
    assert_int_equal(a->rows, b->rows);
    for (uint64_t i = 0; i < a->rows; i++) {
        tdsp_row row, same;
        assert_int_equal(tdsp_table_row(a, i, &row), TDSP_OK);
        assert_int_equal(tdsp_table_row(b, i, &same), TDSP_OK);
        assert_memory_equal(&row, &same, sizeof row);
    }
    assert_same_jumps(a, b);
    assert_null(walk_table(b));
}

/* Numbers that would be a row, a jump, or a gap of each row, were they read as such. */
static void a_later_version_may_put_anything_behind_any_section(void **state)
{
    (void)state;
    uint64_t behind[FORMAT_SECTIONS_2];
    for (size_t which = SWELL; which <= SQUEEZE; which++) {
        for (uint64_t k = 0; k < 8; k++) {
            for (size_t i = 0; i < FORMAT_SECTIONS_2; i++) {
                double number = 1e6 * (double)(i + 1);
                behind[i] = k;
                if (k == 7) memcpy(&behind[i], &number, 8);
            }
            size_t length, room_length;
            unsigned char *bytes = golden_write(&golden_tables[which], &length), *roomy = with_room(which, 0, behind, &room_length);
            tdsp_table table, told;
            assert_int_equal(tdsp_table_open(&table, bytes, length), TDSP_OK);
            assert_int_equal(tdsp_table_open(&told, roomy, room_length), TDSP_OK);
            assert_same_tables(&table, &told);
            free(bytes);
            free(roomy);
        }
    }
}

/* Without what is behind the last section, so that it is only what lies between them. */
static void only_a_later_version_may_leave_room_between_sections(void **state)
{
    (void)state;
    for (size_t which = SWELL; which <= SQUEEZE; which++) {
        size_t length;
        unsigned char *bytes = with_room(which, 0, nothing, &length);
        length -= 8;
        bytes_put_u64(bytes + FORMAT_AT_LENGTH, length);
        assert_int_equal(open_sealed(bytes, length), TDSP_OK);
        bytes_put_u16(bytes + FORMAT_AT_MINOR, FORMAT_MINOR);
        assert_int_equal(open_sealed(bytes, length), TDSP_BAD_TABLE);
        free(bytes);
    }
}

/* All sections lie behind the longest of these headers. */
static void only_a_later_version_may_have_a_longer_header_and_that_of_whole_words(void **state)
{
    (void)state;
    for (uint32_t more = 0; more <= 16; more += 4) {
        size_t length;
        unsigned char *bytes = with_room(SQUEEZE, 16, nothing, &length);
        bytes_put_u32(bytes + FORMAT_AT_HEADER_LENGTH, FORMAT_HEADER_LENGTH_2 + more);
        assert_int_equal(open_sealed(bytes, length), more % 8 == 0 ? TDSP_OK : TDSP_BAD_TABLE);
        free(bytes);
    }
    for (size_t more = 0; more <= 8; more += 8) {
        size_t length;
        unsigned char *bytes = with_room(SQUEEZE, more, NULL, &length);
        assert_int_equal(open_sealed(bytes, length), TDSP_OK);
        bytes_put_u16(bytes + FORMAT_AT_MINOR, FORMAT_MINOR);
        assert_int_equal(open_sealed(bytes, length), more == 0 ? TDSP_OK : TDSP_BAD_TABLE);
        free(bytes);
    }
}

/* A section of nothing, which has room for more behind it. */
static void a_section_lies_at_a_whole_word_though_it_holds_nothing(void **state)
{
    (void)state;
    for (uint64_t askew = 0; askew <= 8; askew += 4) {
        size_t length, at = format_at_offset(FORMAT_BY_ARRIVAL);
        unsigned char *bytes = with_room(SQUEEZE, 0, nothing, &length);
        bytes_put_u64(bytes + at, bytes_get_u64(bytes + at) + askew);
        assert_int_equal(open_sealed(bytes, length), askew % 8 == 0 ? TDSP_OK : TDSP_BAD_TABLE);
        free(bytes);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_later_version_may_put_anything_behind_any_section),
        cmocka_unit_test(only_a_later_version_may_leave_room_between_sections),
        cmocka_unit_test(only_a_later_version_may_have_a_longer_header_and_that_of_whole_words),
        cmocka_unit_test(a_section_lies_at_a_whole_word_though_it_holds_nothing),
    };
    return cmocka_run_group_tests_name("table_versions", tests, NULL, NULL);
}
