/* SPDX-License-Identifier: MIT */
/* Memory above the freestanding line: everything goes through the caller's allocator, and may fail. */
#ifndef SCENE_ALLOCATOR_H
#define SCENE_ALLOCATOR_H

#include "tdsp/status.h"
#include "tdsp/types.h"

/* The allocator to keep: a copy of the caller's, or the C library's for NULL. */
tdsp_allocator memory_allocator(const tdsp_allocator *allocator);

/* As realloc with the old size told; new_size 0 frees. NULL on failure, the block then stays. */
void *memory_resize(const tdsp_allocator *allocator, void *block, size_t old_size, size_t new_size);

/* A new block of count * item bytes, or NULL (also on overflow, and for a count of 0). */
void *memory_array(const tdsp_allocator *allocator, size_t count, size_t item);

/* Free a block of that size; NULL is allowed. */
void memory_free(const tdsp_allocator *allocator, void *block, size_t size);

/*
 * Make room for `needed` items of `item` bytes in *block, whose capacity in items is *capacity: grows by halves, so
 * that appending is O(1) amortised. TDSP_NO_MEMORY leaves both as they were.
 */
tdsp_status memory_reserve(const tdsp_allocator *allocator, void **block, size_t *capacity, size_t needed, size_t item);

/* Give back what *block has beyond `count` items. TDSP_NO_MEMORY leaves both as they were. */
tdsp_status memory_shrink(const tdsp_allocator *allocator, void **block, size_t *capacity, size_t count, size_t item);

#endif
