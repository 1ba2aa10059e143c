/* SPDX-License-Identifier: MIT */
/*
 * A binary min-heap of labels.
 *
 * Invariant: slots[(k - 1) / 2] is not after slots[k]. Labels come out in the order of their keys, equal keys in the order in which
 * they went in.
 */
#ifndef SEARCH_HEAP_H
#define SEARCH_HEAP_H

#include "scene/allocator.h"
#include "tdsp/search.h"

typedef struct heap_slot {
    double key;
    uint64_t turn; /* counts the pushes */
    tdsp_label label;
} heap_slot;

typedef struct label_heap {
    heap_slot *slots;
    size_t count;
    size_t capacity;
    uint64_t pushes;
} label_heap;

void heap_init(label_heap *heap);
void heap_free(label_heap *heap, const tdsp_allocator *allocator);
void heap_clear(label_heap *heap);

/* O(log count). TDSP_OK or TDSP_NO_MEMORY. */
tdsp_status heap_push(label_heap *heap, const tdsp_allocator *allocator, double key, tdsp_label label);

/* Takes the first label out; the heap is not empty. O(log count). */
tdsp_label heap_pop(label_heap *heap);

#endif
