/* SPDX-License-Identifier: MIT */
/* Memory above the freestanding line. The only place that names the C library's heap. */
#include "scene/allocator.h"

#include <stdlib.h>

static void *library_resize(void *ctx, void *block, size_t old_size, size_t new_size)
{
    (void)ctx;
    (void)old_size;
    if (new_size == 0) {
        free(block);
        return NULL;
    }
    return realloc(block, new_size);
}

tdsp_allocator memory_allocator(const tdsp_allocator *allocator)
{
    static const tdsp_allocator library = {NULL, library_resize};
    return allocator ? *allocator : library;
}

void *memory_resize(const tdsp_allocator *allocator, void *block, size_t old_size, size_t new_size)
{
    return allocator->resize(allocator->ctx, block, old_size, new_size);
}

void *memory_array(const tdsp_allocator *allocator, size_t count, size_t item)
{
    if (count == 0 || count > SIZE_MAX / item) return NULL;
    return memory_resize(allocator, NULL, 0, count * item);
}

void memory_free(const tdsp_allocator *allocator, void *block, size_t size)
{
    if (block) memory_resize(allocator, block, size, 0);
}

tdsp_status memory_reserve(const tdsp_allocator *allocator, void **block, size_t *capacity, size_t needed, size_t item)
{
    if (needed <= *capacity) return TDSP_OK;
    size_t grown = *capacity + *capacity / 2;
    if (grown < 16) grown = 16;
    if (grown < needed) grown = needed;
    if (grown > SIZE_MAX / item) return TDSP_NO_MEMORY;
    void *moved = memory_resize(allocator, *block, *capacity * item, grown * item);
    if (!moved) return TDSP_NO_MEMORY;
    *block = moved;
    *capacity = grown;
    return TDSP_OK;
}

tdsp_status memory_shrink(const tdsp_allocator *allocator, void **block, size_t *capacity, size_t count, size_t item)
{
    if (count >= *capacity) return TDSP_OK;
    void *moved = memory_resize(allocator, *block, *capacity * item, count * item);
    if (!moved && count > 0) return TDSP_NO_MEMORY;
    *block = moved;
    *capacity = count;
    return TDSP_OK;
}
