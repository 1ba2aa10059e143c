/* SPDX-License-Identifier: MIT */
/* Memory: sizes that overflow, growth, and what a failure leaves. */
#include "support/cmocka_all.h"

#include <string.h>

#include "scene/allocator.h"
#include "support/tight.h"

static void no_allocator_means_the_c_librarys(void **state)
{
    (void)state;
    tdsp_allocator memory = memory_allocator(NULL);
    char *block = memory_resize(&memory, NULL, 0, 10);
    assert_non_null(block);
    strcpy(block, "nine here");
    char *moved = memory_resize(&memory, block, 10, 100000);
    if (!moved) memory_free(&memory, block, 10);
    assert_non_null(moved);
    assert_string_equal(moved, "nine here");
    assert_null(memory_resize(&memory, moved, 100000, 0));
}

static void an_allocator_is_copied(void **state)
{
    (void)state;
    tight_heap heap = {0};
    tdsp_allocator given = tight_allocator(&heap), kept = memory_allocator(&given);
    memset(&given, 0, sizeof given);
    memory_free(&kept, memory_array(&kept, 3, 8), 24);
    assert_int_equal(heap.calls, 1);
    assert_int_equal(heap.held, 0);
}

static void an_array_that_overflows_or_holds_nothing_is_refused_without_asking(void **state)
{
    (void)state;
    tight_heap heap = {0};
    tdsp_allocator memory = tight_allocator(&heap);
    assert_null(memory_array(&memory, SIZE_MAX / 8 + 1, 8));
    assert_null(memory_array(&memory, SIZE_MAX, SIZE_MAX));
    assert_null(memory_array(&memory, 0, 8));
    assert_int_equal(heap.calls, 0);
}

static void freeing_nothing_is_allowed(void **state)
{
    (void)state;
    tight_heap heap = {0};
    tdsp_allocator memory = tight_allocator(&heap);
    memory_free(&memory, NULL, 100);
    assert_int_equal(heap.held, 0);
}

static void reserving_grows_by_halves_and_keeps_what_is_there(void **state)
{
    (void)state;
    tight_heap heap = {0};
    tdsp_allocator memory = tight_allocator(&heap);
    uint32_t *items = NULL;
    size_t capacity = 0;
    for (uint32_t i = 0; i < 100000; ++i) {
        assert_int_equal(memory_reserve(&memory, (void **)&items, &capacity, i + 1, sizeof *items), TDSP_OK);
        assert_true(capacity > i);
        assert_int_equal(heap.held, capacity * sizeof *items);
        items[i] = i;
    }
    for (uint32_t i = 0; i < 100000; ++i) assert_int_equal(items[i], i);
    assert_true(heap.calls < 40);
    memory_free(&memory, items, capacity * sizeof *items);
    assert_int_equal(heap.held, 0);
}

static void a_reservation_that_fails_changes_nothing(void **state)
{
    (void)state;
    tight_heap heap = {0};
    tdsp_allocator memory = tight_allocator(&heap);
    uint32_t *items = NULL;
    size_t capacity = 0;
    assert_int_equal(memory_reserve(&memory, (void **)&items, &capacity, 5, sizeof *items), TDSP_OK);
    uint32_t *before = items;
    size_t room = capacity;
    items[4] = 44;
    heap.refuse = heap.calls + 1;
    assert_int_equal(memory_reserve(&memory, (void **)&items, &capacity, room + 1, sizeof *items), TDSP_NO_MEMORY);
    assert_int_equal(memory_reserve(&memory, (void **)&items, &capacity, SIZE_MAX / 2, sizeof *items), TDSP_NO_MEMORY);
    assert_ptr_equal(items, before);
    assert_int_equal(capacity, room);
    assert_int_equal(items[4], 44);
    memory_free(&memory, items, capacity * sizeof *items);
    assert_int_equal(heap.held, 0);
}

static void room_enough_asks_for_nothing(void **state)
{
    (void)state;
    tight_heap heap = {0};
    tdsp_allocator memory = tight_allocator(&heap);
    void *items = NULL;
    size_t capacity = 0;
    assert_int_equal(memory_reserve(&memory, &items, &capacity, 0, 8), TDSP_OK);
    assert_null(items);
    assert_int_equal(heap.calls, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(no_allocator_means_the_c_librarys),
        cmocka_unit_test(an_allocator_is_copied),
        cmocka_unit_test(an_array_that_overflows_or_holds_nothing_is_refused_without_asking),
        cmocka_unit_test(freeing_nothing_is_allowed),
        cmocka_unit_test(reserving_grows_by_halves_and_keeps_what_is_there),
        cmocka_unit_test(a_reservation_that_fails_changes_nothing),
        cmocka_unit_test(room_enough_asks_for_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
