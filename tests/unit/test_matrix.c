/* SPDX-License-Identifier: MIT */
/* Matrices: what is built comes out again, and nothing else is let in. */
#include "support/cmocka_all.h"

#include <stdlib.h>

#include "base/bytes.h"
#include "base/hash.h"
#include "support/matrix_walk.h"
#include "support/tight.h"
#include "support/world.h"
#include "table/format.h"
#include "table/matrix.h"
#include "tdsp/build.h"

static const tdsp_journey across = {1.0, 0.0, {-10.0, 0.0}, {10.0, 0.0}};
static const tdsp_disc discs[2] = {{{0.0, 3.0}, 1.0, 0.1}, {{0.0, -3.0}, 1.0, 0.1}};
static const tdsp_matrix_end sources[3] = {{{-10.0, 0.0}, "gate", 4}, {{0.0, 3.5}, NULL, 0}, {{-9.0, 4.0}, "\xc3\xa9", 2}};
static const tdsp_matrix_end destinations[2] = {{{10.0, 0.0}, "A", 1}, {{-10.0, 0.0}, NULL, 0}};

static tdsp_status oracle_for(void *ctx, size_t i, size_t j, size_t worker, tdsp_oracle *oracle, uint64_t *hash)
{
    const world *w = ctx;
    const tdsp_ends ends = {sources[i].place, destinations[j].place};
    assert_int_equal(worker, 0);
    assert_int_equal(tdsp_solver_set_ends(w->solver, &ends), TDSP_OK);
    *hash = tdsp_scene_hash_for(w->scene, &ends);
    return tdsp_solver_oracle(w->solver, oracle);
}

typedef struct built {
    world w;
    unsigned char *bytes;
    size_t length;
    tdsp_matrix_report report;
} built;

static tdsp_matrix_plan plan_for(world *w)
{
    return (tdsp_matrix_plan){sources, 3, destinations, 2, oracle_for, w};
}

static tdsp_build_options options_for(void)
{
    tdsp_build_options options;
    tdsp_build_options_init(&options);
    options.epsilon = 0.1;
    options.world.speed = 1.0;
    return options;
}

static void build(built *out)
{
    void *bytes;
    tdsp_build_options options = options_for();
    out->w = world_make(across, discs, 2);
    const tdsp_matrix_plan plan = plan_for(&out->w);
    assert_int_equal(tdsp_matrix_build(&plan, &options, NULL, &bytes, &out->length, &out->report), TDSP_OK);
    out->bytes = bytes;
}

static void drop(built *b)
{
    tdsp_bytes_free(NULL, b->bytes, b->length);
    world_free(b->w);
}

static void what_was_built_comes_out_again(void **state)
{
    (void)state;
    built b;
    tdsp_matrix matrix;
    tdsp_matrix_end end;
    tdsp_table table;
    uint64_t rows, columns;
    build(&b);
    assert_int_equal(tdsp_matrix_open(&matrix, b.bytes, b.length), TDSP_OK);
    assert_int_equal(tdsp_matrix_size(&matrix, &rows, &columns), TDSP_OK);
    assert_int_equal(rows, 3);
    assert_int_equal(columns, 2);
    assert_int_equal(b.report.tables, 4);
    assert_int_equal(b.report.source, 3);
    assert_int_equal(b.report.bytes, b.length);
    for (uint64_t i = 0; i < 3; ++i) {
        assert_int_equal(tdsp_matrix_source(&matrix, i, &end), TDSP_OK);
        assert_memory_equal(&end.place, &sources[i].place, sizeof end.place);
        assert_int_equal(end.name_length, sources[i].name_length);
        if (end.name_length) assert_memory_equal(end.name, sources[i].name, end.name_length);
        for (uint64_t j = 0; j < 2; ++j) {
            tdsp_status status = tdsp_matrix_table(&matrix, i, j, &table);
            assert_int_equal(status, i == 1 ? TDSP_SOURCE_COVERED : TDSP_OK);
            if (status != TDSP_OK) continue;
            double exact, lower, upper;
            const tdsp_ends ends = {sources[i].place, destinations[j].place};
            assert_int_equal(tdsp_earliest_arrival_for(b.w.solver, &ends, 4.0, &exact), TDSP_OK);
            assert_int_equal(tdsp_table_arrival(&table, 4.0, &lower, &upper), TDSP_OK);
            assert_true(lower <= exact && exact <= upper);
        }
    }
    assert_int_equal(tdsp_matrix_destination(&matrix, 1, &end), TDSP_OK);
    assert_int_equal(end.name_length, 0);
    assert_null(matrix_walk(&matrix));
    drop(&b);
}

static void pairs_that_are_not_there_are_refused(void **state)
{
    (void)state;
    built b;
    tdsp_matrix matrix;
    tdsp_matrix_end end;
    tdsp_table table;
    build(&b);
    assert_int_equal(tdsp_matrix_open(&matrix, b.bytes, b.length), TDSP_OK);
    assert_int_equal(tdsp_matrix_table(&matrix, 3, 0, &table), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_matrix_table(&matrix, 0, 2, &table), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_matrix_table(&matrix, UINT64_MAX, 0, &table), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_matrix_table(&matrix, 0, 0, NULL), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_matrix_source(&matrix, 3, &end), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_matrix_destination(&matrix, 2, &end), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_matrix_size(NULL, NULL, NULL), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_matrix_open(NULL, b.bytes, b.length), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_matrix_open(&matrix, NULL, b.length), TDSP_INVALID_ARGUMENT);
    drop(&b);
}

/* Bytes of exactly this length, so that a read past the end is seen by the sanitizer. */
static tdsp_status open_copy(const unsigned char *bytes, size_t length, int seal)
{
    unsigned char *copy = malloc(length + 1);
    tdsp_matrix matrix;
    assert_non_null(copy);
    memcpy(copy + 1, bytes, length);
    if (seal) matrix_seal(copy + 1, length);
    tdsp_status status = tdsp_matrix_open(&matrix, copy + 1, length);
    if (status == TDSP_OK) assert_null(matrix_walk(&matrix));
    free(copy);
    return status;
}

static void any_changed_or_missing_byte_is_noticed(void **state)
{
    (void)state;
    built b;
    build(&b);
    assert_int_equal(open_copy(b.bytes, b.length, 0), TDSP_OK);
    for (size_t i = 0; i < b.length; i += i < 512 ? 1 : 37) {
        b.bytes[i] ^= 0x10;
        assert_int_not_equal(open_copy(b.bytes, b.length, 0), TDSP_OK);
        b.bytes[i] ^= 0x10;
        assert_int_not_equal(open_copy(b.bytes, i, 0), TDSP_OK);
    }
    drop(&b);
}

/* No other size or offset will do; of places, names and pairs some will, and everything in them holds together then. */
static void numbers_that_contradict_each_other_are_noticed_behind_good_checksums(void **state)
{
    (void)state;
    static const uint64_t values[] = {
        0, 1, 7, 8, 0x7fffffff, 0xffffffff, 0x100000000, UINT64_MAX, UINT64_MAX - 7, 0x7ff0000000000000};
    built b;
    build(&b);
    size_t tables = (size_t)bytes_get_u64(b.bytes + MATRIX_AT_TABLES);
    for (size_t at = MATRIX_AT_SOURCES; at < tables; at += 8) {
        uint64_t before = bytes_get_u64(b.bytes + at);
        for (size_t k = 0; k < sizeof values / sizeof *values; ++k) {
            bytes_put_u64(b.bytes + at, values[k]);
            tdsp_status status = open_copy(b.bytes, b.length, 1);
            if (values[k] != before && at < MATRIX_HEADER_LENGTH) assert_int_equal(status, TDSP_BAD_TABLE);
        }
        bytes_put_u64(b.bytes + at, before);
    }
    bytes_put_u16(b.bytes + MATRIX_AT_MAJOR, 2);
    assert_int_equal(open_copy(b.bytes, b.length, 1), TDSP_BAD_VERSION);
    bytes_put_u16(b.bytes + MATRIX_AT_MAJOR, 1);
    bytes_put_u16(b.bytes + MATRIX_AT_MINOR, 9);
    assert_int_equal(open_copy(b.bytes, b.length, 1), TDSP_OK);
    drop(&b);
}

/* The places of two sources are one, and so are their tables. */
static void a_table_that_two_pairs_share_is_refused(void **state)
{
    (void)state;
    built b;
    build(&b);
    unsigned char *points = b.bytes + bytes_get_u64(b.bytes + MATRIX_AT_POINTS), *pairs = b.bytes + bytes_get_u64(b.bytes + MATRIX_AT_PAIRS);
    memcpy(points + 2 * MATRIX_POINT_SIZE, points, MATRIX_POINT_SIZE);
    memcpy(pairs + 4 * MATRIX_PAIR_SIZE, pairs, 2 * MATRIX_PAIR_SIZE);
    bytes_put_u16(b.bytes + MATRIX_AT_MINOR, MATRIX_MINOR + 1);
    assert_int_equal(open_copy(b.bytes, b.length, 1), TDSP_BAD_TABLE);
    drop(&b);
}

/* So long that in 64 bits it ends where the matrix begins, which its own header says as well. */
static void a_table_whose_end_wraps_around_is_refused(void **state)
{
    (void)state;
    built b;
    build(&b);
    unsigned char *pair = b.bytes + bytes_get_u64(b.bytes + MATRIX_AT_PAIRS);
    uint64_t offset = bytes_get_u64(pair + MATRIX_PAIR_AT_OFFSET);
    unsigned char *table = b.bytes + offset;
    bytes_put_u64(pair + MATRIX_PAIR_AT_LENGTH, UINT64_MAX - offset + 1);
    bytes_put_u64(table + FORMAT_AT_LENGTH, UINT64_MAX - offset + 1);
    uint32_t crc = hash_crc32c(0, table, 0, FORMAT_AT_HEADER_CRC);
    crc = hash_crc32c(crc, table, FORMAT_AFTER_HEADER_CRC, bytes_get_u32(table + FORMAT_AT_HEADER_LENGTH));
    bytes_put_u32(table + FORMAT_AT_HEADER_CRC, crc);
    assert_int_equal(open_copy(b.bytes, b.length, 1), TDSP_BAD_TABLE);
    drop(&b);
}

static void an_end_that_only_an_overwritten_view_has_is_read_from_the_header(void **state)
{
    (void)state;
    built b;
    tdsp_matrix matrix;
    tdsp_matrix_end end;
    build(&b);
    assert_int_equal(tdsp_matrix_open(&matrix, b.bytes, b.length), TDSP_OK);
    matrix.sources = UINT64_MAX;
    assert_int_equal(tdsp_matrix_source(&matrix, UINT64_C(1) << 40, &end), TDSP_OK);
    assert_memory_equal(&end.place.x, b.bytes, sizeof end.place.x);
    drop(&b);
}

static tdsp_status failing_oracle(void *ctx, size_t i, size_t j, size_t worker, tdsp_oracle *oracle, uint64_t *hash)
{
    tdsp_status status = oracle_for(ctx, i, j, worker, oracle, hash);
    return i == 2 && j == 1 ? TDSP_FAILED : status;
}

static int cancel(void *ctx, double done, double all)
{
    (void)ctx;
    assert_exact(all, 6.0);
    return done >= 3.0;
}

static void a_pair_that_fails_is_named_and_what_cannot_be_built_is_refused(void **state)
{
    (void)state;
    world w = world_make(across, discs, 2);
    tdsp_build_options options = options_for();
    tdsp_matrix_plan plan = plan_for(&w);
    tdsp_matrix_report report;
    void *bytes = NULL;
    size_t length = 0;
    plan.oracle_for = failing_oracle;
    assert_int_equal(tdsp_matrix_build(&plan, &options, NULL, &bytes, &length, &report), TDSP_FAILED);
    assert_int_equal(report.source, 2);
    assert_int_equal(report.destination, 1);
    plan.oracle_for = oracle_for;
    options.progress = cancel;
    assert_int_equal(tdsp_matrix_build(&plan, &options, NULL, &bytes, &length, NULL), TDSP_CANCELLED);
    options.progress = NULL;
    plan.source_count = 0;
    assert_int_equal(tdsp_matrix_build(&plan, &options, NULL, &bytes, &length, NULL), TDSP_INVALID_ARGUMENT);
    const tdsp_matrix_end bad[2] = {{{NAN, 0.0}, NULL, 0}, {{0.0, 0.0}, "\xff", 1}};
    for (int k = 0; k < 2; ++k) {
        plan = plan_for(&w);
        plan.destinations = &bad[k];
        plan.destination_count = 1;
        assert_int_equal(tdsp_matrix_build(&plan, &options, NULL, &bytes, &length, NULL), TDSP_INVALID_ARGUMENT);
    }
    plan = plan_for(&w);
    options.epsilon = 0.0;
    assert_int_equal(tdsp_matrix_build(&plan, &options, NULL, &bytes, &length, NULL), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_matrix_build(NULL, &options, NULL, &bytes, &length, NULL), TDSP_INVALID_ARGUMENT);
    assert_null(bytes);
    world_free(w);
}

#define NO_PLAN(change)                                                                                                          \
    do {                                                                                                                         \
        tdsp_matrix_plan bad = plan_for(&w);                                                                                     \
        bad.change;                                                                                                              \
        assert_int_equal(tdsp_matrix_build(&bad, &options, NULL, &bytes, &length, NULL), TDSP_INVALID_ARGUMENT);                 \
    } while (0)

static void arguments_that_are_missing_or_absurd_are_refused(void **state)
{
    (void)state;
    world w = world_make(across, discs, 2);
    const tdsp_matrix_end nowhere = {{0.0, INFINITY}, NULL, 0}, nameless = {{0.0, 0.0}, NULL, 3};
    tdsp_build_options options = options_for(), odd = options, crewed = options;
    const tdsp_matrix_plan plan = plan_for(&w);
    const tdsp_oracle worker = {0};
    void *bytes = NULL;
    size_t length = 0;
    NO_PLAN(oracle_for = NULL);
    NO_PLAN(sources = NULL);
    NO_PLAN(destination_count = 0);
    NO_PLAN(destination_count = SIZE_MAX);
    NO_PLAN(destinations = &nowhere);
    NO_PLAN(destinations = &nameless);
    odd.size = 3;
    crewed.workers = &worker;
    assert_int_equal(tdsp_matrix_build(&plan, NULL, NULL, &bytes, &length, NULL), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_matrix_build(&plan, &odd, NULL, &bytes, &length, NULL), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_matrix_build(&plan, &crewed, NULL, &bytes, &length, NULL), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_matrix_build(&plan, &options, NULL, NULL, &length, NULL), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_matrix_build(&plan, &options, NULL, &bytes, NULL, NULL), TDSP_INVALID_ARGUMENT);
    assert_null(bytes);
    world_free(w);
}

static void a_failing_allocation_is_reported_and_leaves_no_block(void **state)
{
    (void)state;
    world w = world_make(across, discs, 2);
    tight_heap heap = {0};
    tdsp_allocator memory = tight_allocator(&heap);
    tdsp_build_options options = options_for();
    const tdsp_matrix_plan plan = plan_for(&w);
    tdsp_status status = TDSP_NO_MEMORY;
    void *bytes = NULL;
    size_t length = 0;
    options.epsilon = 1.0;
    for (size_t refuse = 1; status == TDSP_NO_MEMORY; ++refuse) {
        heap.refuse = heap.calls + refuse;
        status = tdsp_matrix_build(&plan, &options, &memory, &bytes, &length, NULL);
        heap.refuse = 0;
        if (status == TDSP_NO_MEMORY) assert_int_equal(heap.blocks, 0);
    }
    assert_int_equal(status, TDSP_OK);
    tdsp_bytes_free(&memory, bytes, length);
    assert_int_equal(heap.blocks, 0);
    world_free(w);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_was_built_comes_out_again),
        cmocka_unit_test(pairs_that_are_not_there_are_refused),
        cmocka_unit_test(any_changed_or_missing_byte_is_noticed),
        cmocka_unit_test(numbers_that_contradict_each_other_are_noticed_behind_good_checksums),
        cmocka_unit_test(a_table_that_two_pairs_share_is_refused),
        cmocka_unit_test(a_table_whose_end_wraps_around_is_refused),
        cmocka_unit_test(an_end_that_only_an_overwritten_view_has_is_read_from_the_header),
        cmocka_unit_test(a_pair_that_fails_is_named_and_what_cannot_be_built_is_refused),
        cmocka_unit_test(arguments_that_are_missing_or_absurd_are_refused),
        cmocka_unit_test(a_failing_allocation_is_reported_and_leaves_no_block),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
