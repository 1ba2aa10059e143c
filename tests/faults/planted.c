/* SPDX-License-Identifier: MIT */
/* Faults planted on purpose, to be found by inject.h, and what looks like one and is none: check_planted.py runs it. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <stdlib.h>
#include <string.h>

#include "scene/allocator.h"

typedef struct pair {
    char *first;
    char *second;
} pair;

static pair *kept; /* by a global alone */

static void *planted_block(size_t size)
{
    const tdsp_allocator allocator = memory_allocator(NULL);
    return memory_array(&allocator, size, 1);
}

static void planted_free(void *block, size_t size)
{
    const tdsp_allocator allocator = memory_allocator(NULL);
    memory_free(&allocator, block, size);
}

static void pair_free(pair *p)
{
    planted_free(p->first, 100);
    planted_free(p->second, 200);
}

static int pair_make(pair *p)
{
    p->first = planted_block(100);
    p->second = p->first ? planted_block(200) : NULL;
    return p->second != NULL;
}

static void finds_a_block_that_is_lost_when_the_next_one_fails(void **state)
{
    pair p;
    (void)state;
    int made = pair_make(&p);
    if (!made) memset(&p, 0, sizeof p);
    assert_true(made);
    pair_free(&p);
}

static void finds_a_block_that_only_a_lost_one_points_to(void **state)
{
    pair *p = planted_block(sizeof *p);
    (void)state;
    assert_non_null(p);
    int made = pair_make(p);
    if (!made) p = NULL;
    assert_true(made);
    pair_free(p);
    planted_free(p, sizeof *p);
}

static void finds_a_write_to_what_was_not_given(void **state)
{
    char *block = planted_block(10);
    (void)state;
    block[3] = 1;
    planted_free(block, 10);
}

static void finds_a_block_that_is_freed_twice(void **state)
{
    pair p;
    (void)state;
    int made = pair_make(&p);
    if (!made && p.first) {
        planted_free(p.first, 100);
        planted_free(p.first, 100);
    }
    assert_true(made);
    pair_free(&p);
}

static void finds_a_block_that_is_read_when_it_has_been_freed(void **state)
{
    pair p;
    (void)state;
    int made = pair_make(&p);
    if (!made && p.first) {
        memset(p.first, 1, 100);
        planted_free(p.first, 100);
        assert_int_equal(p.first[50], 1);
    }
    assert_true(made);
    pair_free(&p);
}

static void finds_one_that_never_gives_up(void **state)
{
    volatile char *block = planted_block(10);
    (void)state;
    for (volatile int again = 1; !block && again;) continue;
    planted_free((char *)block, 10);
}

static void passes_what_frames_still_point_to(void **state)
{
    pair p, *on_the_heap = planted_block(sizeof *on_the_heap);
    (void)state;
    assert_non_null(on_the_heap);
    assert_true(pair_make(&p));
    assert_true(pair_make(on_the_heap));
    pair_free(on_the_heap);
    planted_free(on_the_heap, sizeof *on_the_heap);
    pair_free(&p);
}

static void passes_what_a_global_points_to(void **state)
{
    (void)state;
    kept = planted_block(sizeof *kept);
    assert_non_null(kept);
    assert_true(pair_make(kept));
    pair_free(kept);
    planted_free(kept, sizeof *kept);
}

static void passes_when_a_victim_leaves_nothing_changed(void **state)
{
    static int of_the_program;
    int *on_the_heap = planted_block(sizeof *on_the_heap);
    (void)state;
    assert_non_null(on_the_heap);
    *on_the_heap = 0;
    for (int i = 0; i < 5; i++) {
        char *block = planted_block(100);
        assert_int_equal(++of_the_program, i + 1);
        assert_int_equal(++*on_the_heap, i + 1);
        planted_free(block, 100);
    }
    planted_free(on_the_heap, sizeof *on_the_heap);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(finds_a_block_that_is_lost_when_the_next_one_fails),
        cmocka_unit_test(finds_a_block_that_only_a_lost_one_points_to),
        cmocka_unit_test(finds_a_write_to_what_was_not_given),
        cmocka_unit_test(finds_a_block_that_is_freed_twice),
        cmocka_unit_test(finds_a_block_that_is_read_when_it_has_been_freed),
        cmocka_unit_test(finds_one_that_never_gives_up),
        cmocka_unit_test(passes_what_frames_still_point_to),
        cmocka_unit_test(passes_what_a_global_points_to),
        cmocka_unit_test(passes_when_a_victim_leaves_nothing_changed),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
