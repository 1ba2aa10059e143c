/* A set of discs, ready to be searched. */
#include "scene/disc_set.h"

static void set_free_discs(disc_set *set, const tdsp_allocator *allocator)
{
    memory_free(allocator, set->forward, set->capacity * sizeof *set->forward);
    memory_free(allocator, set->reverse, set->capacity * sizeof *set->reverse);
    memory_free(allocator, set->origin, set->capacity * sizeof *set->origin);
    set->forward = set->reverse = NULL;
    set->origin = NULL;
    set->capacity = 0;
    set->count = 0;
}

tdsp_status set_reserve(disc_set *set, const tdsp_allocator *allocator, size_t count)
{
    if (count <= set->capacity) return TDSP_OK;
    set_free_discs(set, allocator);
    set->capacity = count + count / 2;
    set->forward = memory_array(allocator, set->capacity, sizeof *set->forward);
    set->reverse = memory_array(allocator, set->capacity, sizeof *set->reverse);
    set->origin = memory_array(allocator, set->capacity, sizeof *set->origin);
    if (set->forward && set->reverse && set->origin) return TDSP_OK;
    set_free_discs(set, allocator);
    return TDSP_NO_MEMORY;
}

void set_free(disc_set *set, const tdsp_allocator *allocator)
{
    set_free_discs(set, allocator);
    index_free(&set->index, allocator);
}

tdsp_status set_prepare(disc_set *set, const tdsp_allocator *allocator)
{
    index_items items = {set->forward, set->origin, set->count};
    tdsp_status status = index_build(&set->index, allocator, items);
    set->rate_min = INFINITY;
    for (uint32_t i = 0; i < set->count && status == TDSP_OK; ++i) {
        const geom_disc *disc = &set->forward[i];
        set->reverse[i] = disc_make(disc->center, disc->radius, -disc->rate);
        set->rate_min = fmin(set->rate_min, disc->rate);
    }
    return status;
}
