/* SPDX-License-Identifier: MIT */
/* What the linker puts before the allocator's functions. */
#include "faults/memory.h"

#include <stddef.h>
#include <stdint.h>

#include "scene/allocator.h"

void *__real_memory_resize(const tdsp_allocator *allocator, void *block, size_t old_size, size_t new_size);
void *__real_memory_array(const tdsp_allocator *allocator, size_t count, size_t item);
tdsp_status __real_memory_reserve(const tdsp_allocator *allocator, void **block, size_t *capacity, size_t needed, size_t item);
tdsp_status __real_memory_shrink(const tdsp_allocator *allocator, void **block, size_t *capacity, size_t count, size_t item);

void *__wrap_memory_resize(const tdsp_allocator *allocator, void *block, size_t old_size, size_t new_size);
void *__wrap_memory_array(const tdsp_allocator *allocator, size_t count, size_t item);
tdsp_status __wrap_memory_reserve(const tdsp_allocator *allocator, void **block, size_t *capacity, size_t needed, size_t item);
tdsp_status __wrap_memory_shrink(const tdsp_allocator *allocator, void **block, size_t *capacity, size_t count, size_t item);

void *__wrap_memory_resize(const tdsp_allocator *allocator, void *block, size_t old_size, size_t new_size)
{
    if (new_size > 0 && memory_must_fail()) return NULL;
    return __real_memory_resize(allocator, block, old_size, new_size);
}

void *__wrap_memory_array(const tdsp_allocator *allocator, size_t count, size_t item)
{
    if (count > 0 && count <= SIZE_MAX / item && memory_must_fail()) return NULL;
    return __real_memory_array(allocator, count, item);
}

tdsp_status __wrap_memory_reserve(const tdsp_allocator *allocator, void **block, size_t *capacity, size_t needed, size_t item)
{
    if (needed > *capacity && memory_must_fail()) return TDSP_NO_MEMORY;
    return __real_memory_reserve(allocator, block, capacity, needed, item);
}

tdsp_status __wrap_memory_shrink(const tdsp_allocator *allocator, void **block, size_t *capacity, size_t count, size_t item)
{
    if (count < *capacity && count > 0 && memory_must_fail()) return TDSP_NO_MEMORY;
    return __real_memory_shrink(allocator, block, capacity, count, item);
}
