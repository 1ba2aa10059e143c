/* SPDX-License-Identifier: MIT */
/* Copies of paths. An oracle's path lives until its next call; a row is written when the next row is known. */
#include "build/kept_path.h"

#include <stdint.h>
#include <string.h>

#include "scene/allocator.h"

#define MAX_BYTES 0x7fffffffu

kept_path kept_path_none(void)
{
    return (kept_path){.departure = -1};
}

static tdsp_status check(const tdsp_oracle_path *lent)
{
    int bad_legs = lent->leg_count > 0 && (!lent->legs || lent->leg_count > SIZE_MAX / sizeof *lent->legs);
    int bad_bytes = lent->byte_count > 0 && (!lent->bytes || lent->byte_count > MAX_BYTES);
    return bad_legs || bad_bytes ? TDSP_BAD_ORACLE : TDSP_OK;
}

static tdsp_status reserve_bytes(kept_path *path, const tdsp_allocator *allocator, size_t needed)
{
    return memory_reserve(allocator, &path->bytes, &path->byte_capacity, needed, 1);
}

static tdsp_status reserve_legs(kept_path *path, const tdsp_allocator *allocator, size_t needed)
{
    void *block = path->legs;
    tdsp_status status = memory_reserve(allocator, &block, &path->leg_capacity, needed, sizeof *path->legs);
    path->legs = block;
    return status;
}

tdsp_status kept_path_copy(kept_path *path, const tdsp_allocator *allocator, const tdsp_oracle_path *lent, double departure)
{
    path->departure = -1;
    tdsp_status status = check(lent);
    if (status == TDSP_OK) status = reserve_legs(path, allocator, lent->leg_count);
    if (status == TDSP_OK) status = reserve_bytes(path, allocator, lent->byte_count);
    if (status != TDSP_OK) return status;
    if (lent->leg_count) memcpy(path->legs, lent->legs, lent->leg_count * sizeof *lent->legs);
    if (lent->byte_count) memcpy(path->bytes, lent->bytes, lent->byte_count);
    path->leg_count = lent->leg_count;
    path->byte_count = lent->byte_count;
    path->departure = departure;
    return TDSP_OK;
}

tdsp_status kept_path_again(kept_path *path, const tdsp_allocator *allocator, const kept_path *from)
{
    tdsp_oracle_path lent = {from->legs, from->leg_count, from->bytes, from->byte_count};
    return kept_path_copy(path, allocator, &lent, from->departure);
}

tdsp_status kept_path_trim(kept_path *path, const tdsp_allocator *allocator)
{
    const size_t held = path->leg_capacity * sizeof *path->legs, needed = path->leg_count * sizeof *path->legs;
    if (path->leg_count == 0 || needed == held) return TDSP_OK;
    tdsp_leg *legs = memory_resize(allocator, path->legs, held, needed);
    if (!legs) return TDSP_NO_MEMORY;
    path->legs = legs;
    path->leg_capacity = path->leg_count;
    return TDSP_OK;
}

void kept_path_swap(kept_path *a, kept_path *b)
{
    kept_path held = *a;
    *a = *b;
    *b = held;
}

void kept_path_release(kept_path *path, const tdsp_allocator *allocator)
{
    memory_free(allocator, path->legs, path->leg_capacity * sizeof *path->legs);
    memory_free(allocator, path->bytes, path->byte_capacity);
    *path = kept_path_none();
}
