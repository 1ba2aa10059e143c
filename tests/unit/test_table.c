/* SPDX-License-Identifier: MIT */
/* Opening a table: what is accepted, what is refused and as what, and that nothing is read outside the bytes. */
#include "support/cmocka_all.h"

#include <stdlib.h>

#include "base/bytes.h"
#include "support/chance.h"
#include "support/golden.h"
#include "support/walk.h"
#include "table/format.h"
#include "table/read.h"
#include "tdsp/table.h"

/* A table of the golden ones in a block of its own size, so that the sanitizer sees a read past its end. */
static unsigned char *golden_bytes(size_t which, size_t *length)
{
    unsigned char *bytes = golden_write(&golden_tables[which], length);
    assert_non_null(bytes);
    return bytes;
}

static void the_header_says_what_the_builder_said(void **state)
{
    (void)state;
    for (size_t which = 0; which < GOLDEN_COUNT; which++) {
        const golden_table *golden = &golden_tables[which];
        const writer_header *header = &golden->header;
        size_t length;
        unsigned char *bytes = golden_bytes(which, &length);
        tdsp_table table;
        tdsp_table_info info;
        assert_int_equal(tdsp_table_open(&table, bytes, length), TDSP_OK);
        assert_int_equal(tdsp_table_get_info(&table, &info), TDSP_OK);
        assert_int_equal(info.version_major, 1);
        assert_int_equal(info.version_minor, which < 4 ? 0 : which == 4 ? 1 : 2);
        assert_int_equal(info.curves, which == 5 ? 3 : 0);
        assert_int_equal(info.gaps, golden->gap_count);
        assert_int_equal(info.guide_length > 0, which == 4);
        assert_int_equal(info.monotone, header->monotone);
        assert_int_equal(info.guarantee, header->guarantee);
        assert_int_equal(info.sampling, header->sampling);
        assert_int_equal(info.rows, golden->row_count);
        assert_int_equal(info.length, length);
        assert_true(info.scene_hash == header->world.scene_hash);
        assert_exact(info.epsilon, header->epsilon);
        assert_exact(info.delta, header->delta);
        assert_exact(info.error, header->error);
        assert_exact(info.time_scale, header->time_scale);
        assert_exact(info.speed, header->world.speed);
        assert_exact(info.source.x, header->world.source.x);
        assert_exact(info.source.y, header->world.source.y);
        assert_exact(info.destination.x, header->world.destination.x);
        assert_exact(info.destination.y, header->world.destination.y);
        assert_exact(info.first_lower, header->first_lower);
        assert_exact(info.first_departure, 0.0);
        assert_exact(info.last_departure, golden->rows[golden->row_count - 1].departure);
        assert_int_equal(info.last_reason, header->last_reason);
        assert_string_equal(info.length_unit, header->world.length_unit ? header->world.length_unit : "");
        assert_string_equal(info.time_unit, header->world.time_unit ? header->world.time_unit : "");
        free(bytes);
    }
}

static void a_table_is_read_at_any_alignment(void **state)
{
    (void)state;
    for (size_t which = 0; which < GOLDEN_COUNT; which++) {
        size_t length;
        unsigned char *bytes = golden_bytes(which, &length);
        for (size_t at = 0; at < 9; at++) {
            unsigned char *moved = malloc(length + at);
            tdsp_table table;
            assert_non_null(moved);
            memcpy(moved + at, bytes, length);
            assert_int_equal(tdsp_table_open(&table, moved + at, length), TDSP_OK);
            assert_null(walk_table(&table));
            free(moved);
        }
        free(bytes);
    }
}

static void a_change_of_any_byte_is_noticed(void **state)
{
    (void)state;
    for (size_t which = 0; which < GOLDEN_COUNT; which++) {
        size_t length;
        unsigned char *bytes = golden_bytes(which, &length);
        tdsp_table table = {0};
        for (size_t i = 0; i < length; i++) {
            for (unsigned change = 1; change < 256; change = change * 2 + 1) {
                bytes[i] ^= (unsigned char)change;
                assert_int_not_equal(tdsp_table_open(&table, bytes, length), TDSP_OK);
                bytes[i] ^= (unsigned char)change;
            }
        }
        assert_null(table.bytes);
        assert_int_equal(tdsp_table_open(&table, bytes, length), TDSP_OK);
        free(bytes);
    }
}

/* One byte changed and the checksums put right: refused, or a table that answers consistently. */
static void a_changed_byte_with_checksums_that_fit_is_refused_or_harmless(void **state)
{
    (void)state;
    size_t accepted = 0, refused = 0;
    for (size_t which = 0; which < GOLDEN_COUNT; which++) {
        size_t length;
        unsigned char *bytes = golden_bytes(which, &length);
        unsigned char *changed = malloc(length);
        assert_non_null(changed);
        for (size_t i = 0; i < length; i++) {
            for (unsigned bit = 0; bit < 8; bit++) {
                tdsp_table table;
                memcpy(changed, bytes, length);
                changed[i] ^= (unsigned char)(1u << bit);
                golden_seal(changed, length);
                if (tdsp_table_open(&table, changed, length) == TDSP_OK) {
                    accepted++;
                    assert_null(walk_table(&table));
                } else refused++;
            }
        }
        free(changed);
        free(bytes);
    }
    assert_true(accepted > 100 && refused > 100);
}

static void a_table_cut_off_at_any_length_or_grown_by_a_byte_is_refused(void **state)
{
    (void)state;
    for (size_t which = 0; which < GOLDEN_COUNT; which++) {
        size_t length;
        unsigned char *bytes = golden_bytes(which, &length);
        tdsp_table table;
        for (size_t cut = 0; cut < length; cut++) {
            unsigned char *shorter = malloc(cut ? cut : 1);
            assert_non_null(shorter);
            memcpy(shorter, bytes, cut);
            assert_int_equal(tdsp_table_open(&table, shorter, cut), cut < 8 ? TDSP_BAD_MAGIC : TDSP_BAD_LENGTH);
            free(shorter);
        }
        unsigned char *longer = calloc(length + 8, 1);
        assert_non_null(longer);
        memcpy(longer, bytes, length);
        for (size_t more = 1; more <= 8; more++) assert_int_equal(tdsp_table_open(&table, longer, length + more), TDSP_BAD_LENGTH);
        free(longer);
        free(bytes);
    }
}

static void each_fault_of_the_frame_has_a_status_of_its_own(void **state)
{
    (void)state;
    size_t length;
    unsigned char *bytes = golden_bytes(0, &length);
    tdsp_table table;
    bytes[0] = '{';
    assert_int_equal(tdsp_table_open(&table, bytes, length), TDSP_BAD_MAGIC);
    bytes[0] = 0x89;
    bytes[FORMAT_AT_MAJOR] = 2;
    golden_seal(bytes, length);
    assert_int_equal(tdsp_table_open(&table, bytes, length), TDSP_BAD_VERSION);
    bytes[FORMAT_AT_MAJOR] = 1;
    golden_seal(bytes, length);
    bytes[FORMAT_HEADER_LENGTH]++;
    assert_int_equal(tdsp_table_open(&table, bytes, length), TDSP_BAD_CHECKSUM);
    bytes[FORMAT_HEADER_LENGTH]--;
    bytes[FORMAT_AT_SCENE_HASH]++;
    assert_int_equal(tdsp_table_open(&table, bytes, length), TDSP_BAD_CHECKSUM);
    assert_int_equal(tdsp_table_open(NULL, bytes, length), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_table_open(&table, NULL, length), TDSP_INVALID_ARGUMENT);
    free(bytes);
}

/* A number of the header, overwritten. */
typedef struct header_fault {
    size_t at;
    char type; /* 'i' u32, 'q' u64, 'm' the largest u64 less the value, 'd' f64 */
    double value;
} header_fault;

static void put_fault(unsigned char *bytes, header_fault fault)
{
    if (fault.type == 'i') bytes_put_u32(bytes + fault.at, (uint32_t)fault.value);
    if (fault.type == 'q') bytes_put_u64(bytes + fault.at, (uint64_t)fault.value);
    if (fault.type == 'm') bytes_put_u64(bytes + fault.at, UINT64_MAX - (uint64_t)fault.value);
    if (fault.type == 'd') bytes_put_f64(bytes + fault.at, fault.value);
}

static const header_fault header_faults[] = {
    {FORMAT_AT_HEADER_LENGTH, 'i', 288}, {FORMAT_AT_HEADER_LENGTH, 'i', 304}, {FORMAT_AT_HEADER_LENGTH, 'i', 4294967288.0},
    {FORMAT_AT_MONOTONE, 'i', 2},        {FORMAT_AT_GUARANTEE, 'i', 3},       {FORMAT_AT_SAMPLING, 'i', 2},
    {FORMAT_AT_SAMPLING, 'i', 1},        {FORMAT_AT_MONOTONE, 'i', 1},        {FORMAT_AT_LAST_REASON, 'i', 0},
    {FORMAT_AT_LAST_REASON, 'i', 4},     {FORMAT_AT_LAST_REASON, 'i', 8},     {FORMAT_AT_LAST_REASON, 'i', 5},
    {FORMAT_AT_EPSILON, 'd', 0},         {FORMAT_AT_EPSILON, 'd', -1},        {FORMAT_AT_EPSILON, 'd', INFINITY},
    {FORMAT_AT_EPSILON, 'd', NAN},       {FORMAT_AT_DELTA, 'd', 1},           {FORMAT_AT_GUARANTEE, 'i', 2},
    {FORMAT_AT_ERROR, 'd', -1},          {FORMAT_AT_ERROR, 'd', NAN},         {FORMAT_AT_TIME_SCALE, 'd', INFINITY},
    {FORMAT_AT_TIME_SCALE, 'd', -1e-300}, {FORMAT_AT_SPEED, 'd', -1},         {FORMAT_AT_SPEED, 'd', NAN},
    {FORMAT_AT_SOURCE, 'd', NAN},        {FORMAT_AT_SOURCE + 8, 'd', INFINITY}, {FORMAT_AT_DESTINATION, 'd', -INFINITY},
    {FORMAT_AT_DESTINATION + 8, 'd', NAN}, {FORMAT_AT_FIRST_DEPARTURE, 'd', 1}, {FORMAT_AT_FIRST_LOWER, 'd', 20.5},
    {FORMAT_AT_FIRST_LOWER, 'd', -1},    {FORMAT_AT_FIRST_LOWER, 'd', NAN},   {FORMAT_AT_LAST_DEPARTURE, 'd', 12},
    {FORMAT_AT_ROWS, 'q', 0},            {FORMAT_AT_ROWS, 'q', 3},            {FORMAT_AT_ROWS, 'q', 5},
    {FORMAT_AT_ROWS, 'q', 2305843009213693952.0}, {FORMAT_AT_ROWS, 'q', 18446744073709549568.0}, {FORMAT_AT_LEGS, 'q', 8},
    {FORMAT_AT_WAYPOINTS, 'q', 0},       {FORMAT_AT_WAYPOINTS, 'q', 12},      {FORMAT_AT_WAYPOINTS, 'q', 576460752303423488.0},
    {FORMAT_AT_ARCS, 'q', 2},            {FORMAT_AT_ARCS, 'q', 4},            {FORMAT_AT_ARCS, 'q', 9223372036854775808.0},
    {FORMAT_AT_OPAQUE_LENGTH, 'q', 1},   {FORMAT_AT_OPAQUE_LENGTH, 'q', 18446744073709549568.0}, {FORMAT_AT_OFFSETS, 'q', 304},
    {FORMAT_AT_OFFSETS, 'q', 0},         {FORMAT_AT_OFFSETS + 56, 'q', 8},    {FORMAT_AT_OFFSETS + 32, 'q', 18446744073709549568.0},
    {FORMAT_AT_JOINT, 'i', 0},           {FORMAT_AT_JOINT, 'i', 2},           {FORMAT_AT_JOINT, 'i', 3},
    {FORMAT_AT_RESERVED, 'i', 1},        {FORMAT_AT_ROWS, 'm', 0},            {FORMAT_AT_ROWS, 'm', 1},
    {FORMAT_AT_WAYPOINTS, 'm', 0},       {FORMAT_AT_ARCS, 'm', 0},            {FORMAT_AT_OPAQUE_LENGTH, 'm', 0},
    {FORMAT_AT_OPAQUE_LENGTH, 'm', 900}, {FORMAT_AT_OPAQUE_LENGTH, 'm', 983}, {FORMAT_AT_OFFSETS + 56, 'm', 7},
};

static void each_value_of_the_header_out_of_its_range_is_refused(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof header_faults / sizeof header_faults[0]; i++) {
        size_t length;
        unsigned char *bytes = golden_bytes(0, &length);
        tdsp_table table;
        put_fault(bytes, header_faults[i]);
        golden_seal(bytes, length);
        if (tdsp_table_open(&table, bytes, length) != TDSP_BAD_TABLE) fail_msg("fault %zu (offset %zu) was not refused", i, header_faults[i].at);
        free(bytes);
    }
}

static void a_unit_without_an_end_or_with_bytes_behind_it_or_not_utf8_is_refused(void **state)
{
    (void)state;
    const char faults[][17] = {"sixteen bytes!!!", "m\0\0\0x\0\0\0\0\0\0\0\0\0\0\0", "\xff\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0"};
    for (size_t i = 0; i < 3; i++) {
        for (size_t at = FORMAT_AT_LENGTH_UNIT; at <= FORMAT_AT_TIME_UNIT; at += FORMAT_UNIT_SIZE) {
            size_t length;
            unsigned char *bytes = golden_bytes(0, &length);
            tdsp_table table;
            memcpy(bytes + at, faults[i], FORMAT_UNIT_SIZE);
            golden_seal(bytes, length);
            assert_int_equal(tdsp_table_open(&table, bytes, length), TDSP_BAD_TABLE);
            free(bytes);
        }
    }
}

/* Number `index` of a section of the gap table, overwritten. */
static void each_number_of_the_body_out_of_order_or_range_is_refused(void **state)
{
    (void)state;
    const struct {
        int section;
        size_t at; /* within the section */
        char type;
        double value;
    } faults[] = {
        {FORMAT_DEPARTURES, 0, 'd', 1},       {FORMAT_DEPARTURES, 8, 'd', 0},       {FORMAT_DEPARTURES, 8, 'd', NAN},
        {FORMAT_DEPARTURES, 16, 'd', 3},      {FORMAT_DEPARTURES, 24, 'd', INFINITY}, {FORMAT_LEFT, 0, 'd', -1},
        {FORMAT_LEFT, 8, 'd', 19},            {FORMAT_LEFT, 16, 'd', NAN},          {FORMAT_LEFT, 24, 'd', 24.25},
        {FORMAT_LEFT, 24, 'd', 1.7976931348623157e308}, {FORMAT_LEFT, 16, 'd', 20.6}, {FORMAT_RIGHT, 0, 'd', -1},
        {FORMAT_RIGHT, 0, 'd', 20.5000001},   {FORMAT_RIGHT, 8, 'd', INFINITY},     {FORMAT_RIGHT, 16, 'd', 20},
        {FORMAT_RIGHT, 24, 'd', 30},          {FORMAT_RIGHT, 24, 'd', NAN},         {FORMAT_FIRST_WAYPOINT, 0, 'i', 1},
        {FORMAT_FIRST_WAYPOINT, 4, 'i', 1},   {FORMAT_FIRST_WAYPOINT, 4, 'i', 3},   {FORMAT_FIRST_WAYPOINT, 8, 'i', 1},
        {FORMAT_FIRST_WAYPOINT, 12, 'i', 4294967295.0}, {FORMAT_FIRST_WAYPOINT, 16, 'i', 12}, {FORMAT_FIRST_WAYPOINT, 20, 'i', 1},
        {FORMAT_WAYPOINTS, 0, 'd', 0.5},      {FORMAT_WAYPOINTS, 8, 'd', NAN},      {FORMAT_WAYPOINTS, 16, 'd', INFINITY},
        {FORMAT_WAYPOINTS, 32, 'd', 20.5},    {FORMAT_WAYPOINTS, 32, 'd', -1},      {FORMAT_WAYPOINTS, 24, 'i', 3},
        {FORMAT_WAYPOINTS, 28, 'i', 3},       {FORMAT_WAYPOINTS, 60, 'i', 0},       {FORMAT_WAYPOINTS, 56, 'i', 0},
        {FORMAT_WAYPOINTS, 124, 'i', 3},      {FORMAT_ARCS, 0, 'd', NAN},           {FORMAT_ARCS, 16, 'd', 0},
        {FORMAT_ARCS, 24, 'd', -1},           {FORMAT_ARCS, 32, 'd', INFINITY},     {FORMAT_ARCS, 40, 'd', NAN},
    };
    for (size_t i = 0; i < sizeof faults / sizeof faults[0]; i++) {
        size_t length;
        unsigned char *bytes = golden_bytes(0, &length);
        size_t section = (size_t)bytes_get_u64(bytes + FORMAT_AT_OFFSETS + 8 * (size_t)faults[i].section);
        tdsp_table table;
        put_fault(bytes, (header_fault){section + faults[i].at, faults[i].type, faults[i].value});
        golden_seal(bytes, length);
        if (tdsp_table_open(&table, bytes, length) != TDSP_BAD_TABLE) fail_msg("fault %zu was not refused", i);
        free(bytes);
    }
}

/* The road table arrives at 5, 6, 9, 9 (left) and 5, 9, 9, 9.5 (right). */
static void arrivals_out_of_order_are_refused_in_a_table_monotone_in_arrival(void **state)
{
    (void)state;
    const struct {
        int section;
        size_t row;
        double value;
    } faults[] = {{FORMAT_LEFT, 1, 7.5}, {FORMAT_LEFT, 2, 3.5}, {FORMAT_LEFT, 3, 2.9}, {FORMAT_RIGHT, 0, 6.5},
                  {FORMAT_RIGHT, 1, 7.5}, {FORMAT_RIGHT, 2, 4.25}, {FORMAT_RIGHT, 3, 2.5}, {FORMAT_RIGHT, 2, INFINITY}};
    for (size_t i = 0; i < sizeof faults / sizeof faults[0]; i++) {
        size_t length;
        unsigned char *bytes = golden_bytes(1, &length);
        tdsp_table table;
        size_t section = (size_t)bytes_get_u64(bytes + FORMAT_AT_OFFSETS + 8 * (size_t)faults[i].section);
        bytes_put_f64(bytes + section + 8 * faults[i].row, faults[i].value);
        golden_seal(bytes, length);
        if (tdsp_table_open(&table, bytes, length) != TDSP_BAD_TABLE) fail_msg("fault %zu was not refused", i);
        free(bytes);
    }
}

static void opaque_offsets_out_of_order_are_refused(void **state)
{
    (void)state;
    const struct {
        size_t entry;
        double value;
    } faults[] = {{0, 1}, {1, 14}, {2, 2}, {3, 1e19}, {4, 12}, {4, 14}};
    for (size_t i = 0; i < sizeof faults / sizeof faults[0]; i++) {
        size_t length;
        unsigned char *bytes = golden_bytes(1, &length);
        tdsp_table table;
        size_t section = (size_t)bytes_get_u64(bytes + FORMAT_AT_OFFSETS + 8 * FORMAT_FIRST_BYTE);
        put_fault(bytes, (header_fault){section + 8 * faults[i].entry, 'q', faults[i].value});
        golden_seal(bytes, length);
        if (tdsp_table_open(&table, bytes, length) != TDSP_BAD_TABLE) fail_msg("fault %zu was not refused", i);
        free(bytes);
    }
}

static void at_a_joint_of_two_waypoints_the_times_must_agree(void **state)
{
    (void)state;
    size_t length;
    unsigned char *bytes = golden_bytes(2, &length);
    tdsp_table table;
    size_t waypoints = (size_t)bytes_get_u64(bytes + FORMAT_AT_OFFSETS + 8 * FORMAT_WAYPOINTS);
    bytes_put_f64(bytes + waypoints + 2 * FORMAT_WAYPOINT_SIZE, 1.25);
    golden_seal(bytes, length);
    assert_int_equal(tdsp_table_open(&table, bytes, length), TDSP_BAD_TABLE);
    free(bytes);
}

/* Where section `i` of a table starts; those that its version does not have are empty and at the end. */
static size_t section_offset(const unsigned char *bytes, size_t length, size_t i)
{
    return i < format_sections(bytes_get_u16(bytes + FORMAT_AT_MINOR)) ? (size_t)bytes_get_u64(bytes + format_at_offset(i)) : length;
}

/* As a writer of 1.3 might do: 24 bytes more of header, and a section of 16 bytes in front of each known one and at the end. */
static unsigned char *as_newer_minor(const unsigned char *old, size_t old_length, size_t *length)
{
    const size_t more_header = 24, more_section = 16, old_header = bytes_get_u32(old + FORMAT_AT_HEADER_LENGTH);
    const size_t header = FORMAT_HEADER_LENGTH_2 + more_header;
    *length = old_length + header - old_header + (FORMAT_SECTIONS_2 + 1) * more_section;
    unsigned char *bytes = malloc(*length);
    assert_non_null(bytes);
    memset(bytes, 0xa5, *length);
    memset(bytes, 0, FORMAT_HEADER_LENGTH_2);
    memcpy(bytes, old, old_header);
    for (size_t i = 0; i < FORMAT_SECTIONS_2; i++) {
        size_t from = section_offset(old, old_length, i);
        size_t to = section_offset(old, old_length, i + 1);
        size_t moved = from + header - old_header + (i + 1) * more_section;
        memcpy(bytes + moved, old + from, to - from);
        bytes_put_u64(bytes + format_at_offset(i), moved);
    }
    bytes_put_u16(bytes + FORMAT_AT_MINOR, FORMAT_MINOR + 1);
    bytes_put_u32(bytes + FORMAT_AT_HEADER_LENGTH, (uint32_t)header);
    bytes_put_u64(bytes + FORMAT_AT_LENGTH, *length);
    golden_seal(bytes, *length);
    return bytes;
}

static void a_newer_minor_version_with_a_longer_header_and_more_sections_is_read(void **state)
{
    (void)state;
    for (size_t which = 0; which < GOLDEN_COUNT; which++) {
        size_t old_length, length;
        unsigned char *old = golden_bytes(which, &old_length);
        unsigned char *bytes = as_newer_minor(old, old_length, &length);
        tdsp_table before, table;
        tdsp_table_info info;
        assert_int_equal(tdsp_table_open(&before, old, old_length), TDSP_OK);
        assert_int_equal(tdsp_table_open(&table, bytes, length), TDSP_OK);
        assert_null(walk_table(&table));
        assert_int_equal(tdsp_table_get_info(&table, &info), TDSP_OK);
        assert_int_equal(info.version_minor, FORMAT_MINOR + 1);
        for (uint64_t row = 0; row < info.rows; row++) {
            tdsp_row a, b;
            assert_int_equal(tdsp_table_row(&before, row, &a), TDSP_OK);
            assert_int_equal(tdsp_table_row(&table, row, &b), TDSP_OK);
            assert_memory_equal(&a, &b, sizeof a);
        }
        bytes_put_u64(bytes + FORMAT_AT_OFFSETS + 8, bytes_get_u64(bytes + FORMAT_AT_OFFSETS));
        golden_seal(bytes, length);
        assert_int_equal(tdsp_table_open(&table, bytes, length), TDSP_BAD_TABLE);
        free(bytes);
        free(old);
    }
}

/* The opaque bytes of the road table are its last section: 13 bytes and three zeros. */
static void a_table_without_the_padding_of_its_last_section_is_refused(void **state)
{
    (void)state;
    for (size_t less = 0; less < 4; less++) {
        size_t length;
        unsigned char *bytes = golden_bytes(1, &length);
        tdsp_table table;
        bytes_put_u64(bytes + FORMAT_AT_LENGTH, length - less);
        golden_seal(bytes, length - less);
        assert_int_equal(tdsp_table_open(&table, bytes, length - less), less ? TDSP_BAD_TABLE : TDSP_OK);
        free(bytes);
    }
}

static void an_offset_outside_of_the_bytes_leads_to_the_header(void **state)
{
    (void)state;
    unsigned char bytes[FORMAT_HEADER_LENGTH];
    const tdsp_table table = {.bytes = bytes, .length = sizeof bytes};
    assert_ptr_equal(table_at(&table, sizeof bytes - 8, 8), bytes + sizeof bytes - 8);
    assert_ptr_equal(table_at(&table, sizeof bytes - 7, 8), bytes);
    assert_ptr_equal(table_at(&table, UINT64_MAX, 8), bytes);
}

static void bytes_that_change_after_opening_lead_no_read_outside(void **state)
{
    (void)state;
    uint64_t chance = 4;
    for (int round = 0; round < 4000; round++) {
        size_t length;
        unsigned char *bytes = golden_bytes((size_t)round % GOLDEN_COUNT, &length);
        tdsp_table table;
        assert_int_equal(tdsp_table_open(&table, bytes, length), TDSP_OK);
        size_t changes = 1 + (size_t)chance_below(&chance, 200);
        for (size_t i = 0; i < changes; i++) bytes[chance_below(&chance, length)] = (unsigned char)chance_u64(&chance);
        (void)walk_table(&table);
        free(bytes);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_header_says_what_the_builder_said),
        cmocka_unit_test(a_table_is_read_at_any_alignment),
        cmocka_unit_test(a_change_of_any_byte_is_noticed),
        cmocka_unit_test(a_changed_byte_with_checksums_that_fit_is_refused_or_harmless),
        cmocka_unit_test(a_table_cut_off_at_any_length_or_grown_by_a_byte_is_refused),
        cmocka_unit_test(each_fault_of_the_frame_has_a_status_of_its_own),
        cmocka_unit_test(each_value_of_the_header_out_of_its_range_is_refused),
        cmocka_unit_test(a_unit_without_an_end_or_with_bytes_behind_it_or_not_utf8_is_refused),
        cmocka_unit_test(each_number_of_the_body_out_of_order_or_range_is_refused),
        cmocka_unit_test(arrivals_out_of_order_are_refused_in_a_table_monotone_in_arrival),
        cmocka_unit_test(opaque_offsets_out_of_order_are_refused),
        cmocka_unit_test(at_a_joint_of_two_waypoints_the_times_must_agree),
        cmocka_unit_test(a_newer_minor_version_with_a_longer_header_and_more_sections_is_read),
        cmocka_unit_test(a_table_without_the_padding_of_its_last_section_is_refused),
        cmocka_unit_test(an_offset_outside_of_the_bytes_leads_to_the_header),
        cmocka_unit_test(bytes_that_change_after_opening_lead_no_read_outside),
    };
    return cmocka_run_group_tests_name("table", tests, NULL, NULL);
}
