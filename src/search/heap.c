/* SPDX-License-Identifier: MIT */
/* A binary min-heap of labels: the invariant is in heap.h. */
#include "search/heap.h"

void heap_init(label_heap *heap)
{
    heap->slots = NULL;
    heap->count = heap->capacity = 0;
    heap->pushes = 0;
}

void heap_free(label_heap *heap, const tdsp_allocator *allocator)
{
    memory_free(allocator, heap->slots, heap->capacity * sizeof *heap->slots);
    heap_init(heap);
}

void heap_clear(label_heap *heap)
{
    heap->count = 0;
    heap->pushes = 0;
}

static int slot_before(const heap_slot *a, const heap_slot *b)
{
    return a->key < b->key || (a->key == b->key && a->turn < b->turn);
}

tdsp_status heap_push(label_heap *heap, const tdsp_allocator *allocator, double key, tdsp_label label)
{
    tdsp_status status = memory_reserve(allocator, (void **)&heap->slots, &heap->capacity, heap->count + 1, sizeof *heap->slots);
    if (status != TDSP_OK) return status;
    heap_slot slot = {key, heap->pushes++, label};
    size_t hole = heap->count++;
    while (hole > 0 && slot_before(&slot, &heap->slots[(hole - 1) / 2])) {
        heap->slots[hole] = heap->slots[(hole - 1) / 2];
        hole = (hole - 1) / 2;
    }
    heap->slots[hole] = slot;
    return TDSP_OK;
}

tdsp_label heap_pop(label_heap *heap)
{
    tdsp_label first = heap->slots[0].label;
    heap_slot last = heap->slots[--heap->count];
    size_t hole = 0;
    for (size_t child = 1; child < heap->count; child = 2 * hole + 1) {
        if (child + 1 < heap->count && slot_before(&heap->slots[child + 1], &heap->slots[child])) ++child;
        if (!slot_before(&heap->slots[child], &last)) break;
        heap->slots[hole] = heap->slots[child];
        hole = child;
    }
    heap->slots[hole] = last;
    return first;
}
