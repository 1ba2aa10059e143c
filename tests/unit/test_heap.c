/* SPDX-License-Identifier: MIT */
/* The heap of labels against sorting. */
#include "support/cmocka_all.h"

#include <stdlib.h>

#include "search/heap.h"
#include "support/chance.h"
#include "support/tight.h"

enum { MOST = 3000 };

typedef struct entry {
    double key;
    uint32_t turn;
} entry;

static int entry_order(const void *a, const void *b)
{
    const entry *x = a, *y = b;
    if (x->key != y->key) return x->key < y->key ? -1 : 1;
    return x->turn < y->turn ? -1 : 1;
}

static entry random_entry(uint64_t *chance, uint32_t turn)
{
    static const double special[] = {INFINITY, -INFINITY, 0.0, -0.0, 1e-300};
    uint64_t pick = chance_below(chance, 20);
    entry made = {pick < 5 ? special[pick] : (double)chance_below(chance, 50) - 25.0, turn}; /* many ties */
    return made;
}

static void push(label_heap *heap, const tdsp_allocator *memory, entry e)
{
    tdsp_label label = {-e.key, e.turn, 7};
    assert_int_equal(heap_push(heap, memory, e.key, label), TDSP_OK);
}

static void labels_come_out_sorted_and_equal_keys_in_the_order_of_their_pushes(void **state)
{
    (void)state;
    static entry entries[MOST];
    uint64_t chance = 1;
    tdsp_allocator memory = memory_allocator(NULL);
    label_heap heap;
    heap_init(&heap);
    for (uint32_t count = 0; count < MOST; count = count * 2 + 1) {
        for (uint32_t i = 0; i < count; ++i) push(&heap, &memory, entries[i] = random_entry(&chance, i));
        qsort(entries, count, sizeof entries[0], entry_order);
        for (uint32_t i = 0; i < count; ++i) {
            tdsp_label label = heap_pop(&heap);
            assert_int_equal(label.id, entries[i].turn);
            assert_int_equal(label.kind, 7);
            assert_true(label.time == -entries[i].key);
        }
        assert_int_equal(heap.count, 0);
    }
    heap_free(&heap, &memory);
}

/* The first of the entries left, by looking at all. */
static uint32_t take_first(entry *entries, uint32_t *count)
{
    uint32_t first = 0;
    for (uint32_t i = 1; i < *count; ++i)
        if (entry_order(&entries[i], &entries[first]) < 0) first = i;
    uint32_t turn = entries[first].turn;
    entries[first] = entries[--*count];
    return turn;
}

static void pushes_and_pops_may_be_mixed(void **state)
{
    (void)state;
    static entry entries[MOST];
    uint64_t chance = 2;
    uint32_t count = 0, turn = 0;
    tdsp_allocator memory = memory_allocator(NULL);
    label_heap heap;
    heap_init(&heap);
    for (int k = 0; k < 20000; ++k) {
        if (count < MOST && (count == 0 || chance_below(&chance, 100) < (k % 2000 < 1000 ? 60u : 40u))) {
            push(&heap, &memory, entries[count++] = random_entry(&chance, turn++));
        } else {
            assert_int_equal(heap_pop(&heap).id, take_first(entries, &count));
        }
        assert_int_equal(heap.count, count);
    }
    heap_free(&heap, &memory);
}

static void clearing_keeps_the_memory_and_starts_the_order_afresh(void **state)
{
    (void)state;
    tight_heap counter = {0};
    tdsp_allocator memory = tight_allocator(&counter);
    label_heap heap;
    heap_init(&heap);
    for (uint32_t i = 0; i < 100; ++i) push(&heap, &memory, (entry){1.0, i});
    heap_clear(&heap);
    size_t calls = counter.calls;
    for (uint32_t i = 0; i < 100; ++i) push(&heap, &memory, (entry){1.0, i});
    assert_int_equal(counter.calls, calls);
    for (uint32_t i = 0; i < 100; ++i) assert_int_equal(heap_pop(&heap).id, i);
    heap_free(&heap, &memory);
    assert_int_equal(counter.held, 0);
}

static void a_push_without_memory_leaves_the_heap_as_it_was(void **state)
{
    (void)state;
    tight_heap counter = {0};
    tdsp_allocator memory = tight_allocator(&counter);
    label_heap heap;
    tdsp_label label = {0.0, 99, 0};
    heap_init(&heap);
    counter.refuse = 1;
    assert_int_equal(heap_push(&heap, &memory, 0.0, label), TDSP_NO_MEMORY);
    uint32_t count = 0;
    for (; count < 16 || heap.count < heap.capacity; ++count) push(&heap, &memory, (entry){(double)(count % 5), count});
    counter.refuse = counter.calls + 1;
    assert_int_equal(heap_push(&heap, &memory, -1.0, label), TDSP_NO_MEMORY);
    assert_int_equal(heap.count, count);
    assert_int_equal(heap_pop(&heap).id, 0);
    assert_int_equal(heap_pop(&heap).id, 5);
    heap_free(&heap, &memory);
    assert_int_equal(counter.blocks, 0);
    assert_int_equal(counter.held, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(labels_come_out_sorted_and_equal_keys_in_the_order_of_their_pushes),
        cmocka_unit_test(pushes_and_pops_may_be_mixed),
        cmocka_unit_test(clearing_keeps_the_memory_and_starts_the_order_afresh),
        cmocka_unit_test(a_push_without_memory_leaves_the_heap_as_it_was),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
