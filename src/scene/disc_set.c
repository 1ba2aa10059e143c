/* SPDX-License-Identifier: MIT */
/* A set of discs, ready to be searched. */
#include "scene/disc_set.h"

#include <string.h>

#include "scene/cover.h"

tdsp_status set_reserve(disc_set *set, const tdsp_allocator *allocator, size_t count)
{
    tdsp_status status = memory_reserve(allocator, (void **)&set->forward, &set->forward_capacity, count, sizeof *set->forward);
    if (status != TDSP_OK) return status;
    return memory_reserve(allocator, (void **)&set->origin, &set->origin_capacity, count, sizeof *set->origin);
}

void set_free(disc_set *set, const tdsp_allocator *allocator)
{
    memory_free(allocator, set->forward, set->forward_capacity * sizeof *set->forward);
    memory_free(allocator, set->reverse, set->reverse_capacity * sizeof *set->reverse);
    memory_free(allocator, set->origin, set->origin_capacity * sizeof *set->origin);
    index_free(&set->index, allocator);
    memset(set, 0, sizeof *set);
}

static index_items set_items(const disc_set *set)
{
    index_items items = {set->forward, set->origin, set->reverse, set->count};
    return items;
}

/* Order and index; makes room for the reverse. */
static tdsp_status set_index(disc_set *set, const tdsp_allocator *allocator)
{
    tdsp_status status =
        memory_reserve(allocator, (void **)&set->reverse, &set->reverse_capacity, set->count, sizeof *set->reverse);
    return status == TDSP_OK ? index_build(&set->index, allocator, set_items(set)) : status;
}

static void set_find_rate_min(disc_set *set)
{
    set->rate_min = INFINITY;
    for (uint32_t i = 0; i < set->count; ++i)
        if (set->forward[i].rate < set->rate_min) set->rate_min = set->forward[i].rate;
}

/* `disc` at this rate. Neighbours often grow alike: then the angles are those of the one before it. */
static geom_disc disc_at_rate(const geom_disc *disc, double rate, const geom_disc *before)
{
    if (!before || before->rate != rate) return disc_make(disc->center, disc->radius, rate);
    geom_disc made = *before;
    made.center = disc->center;
    made.radius = disc->radius;
    return made;
}

static void set_turn(disc_set *set)
{
    for (uint32_t i = 0; i < set->count; ++i)
        set->reverse[i] = disc_at_rate(&set->forward[i], -set->forward[i].rate, i > 0 ? &set->reverse[i - 1] : NULL);
}

tdsp_status set_prepare(disc_set *set, const tdsp_allocator *allocator)
{
    tdsp_status status = set_index(set, allocator);
    if (status != TDSP_OK) return status;
    set_turn(set);
    set_find_rate_min(set);
    return TDSP_OK;
}

tdsp_status set_choose(disc_set *set, const tdsp_allocator *allocator, const disc_set *from, const uint32_t *chosen,
                       uint32_t count)
{
    tdsp_status status = set_reserve(set, allocator, count);
    if (status != TDSP_OK) return status;
    set->count = count;
    for (uint32_t k = 0; k < count; ++k) {
        set->forward[k] = from->forward[chosen[k]];
        set->origin[k] = chosen[k];
    }
    status = set_index(set, allocator);
    if (status != TDSP_OK) return status;
    for (uint32_t k = 0; k < count; ++k) set->reverse[k] = from->reverse[set->origin[k]];
    set_find_rate_min(set);
    return TDSP_OK;
}

/* Leave out what can never matter. */
static tdsp_status set_thin(disc_set *set, const tdsp_allocator *allocator)
{
    uint32_t kept;
    tdsp_status status = cover_drop(&set->index, allocator, set_items(set), &kept);
    if (status != TDSP_OK || kept == set->count) return status;
    set->count = kept;
    return set_index(set, allocator);
}

static tdsp_status set_trim(disc_set *set, const tdsp_allocator *allocator)
{
    size_t disc = sizeof *set->forward;
    tdsp_status status = index_trim(&set->index, allocator);
    if (status == TDSP_OK) status = memory_shrink(allocator, (void **)&set->forward, &set->forward_capacity, set->count, disc);
    if (status == TDSP_OK) status = memory_shrink(allocator, (void **)&set->reverse, &set->reverse_capacity, set->count, disc);
    if (status != TDSP_OK) return status;
    return memory_shrink(allocator, (void **)&set->origin, &set->origin_capacity, set->count, sizeof *set->origin);
}

tdsp_status set_prepare_whole(disc_set *set, const tdsp_allocator *allocator)
{
    tdsp_status status = set_index(set, allocator);
    if (status == TDSP_OK) status = set_thin(set, allocator);
    if (status == TDSP_OK) status = set_trim(set, allocator);
    if (status != TDSP_OK) return status;
    for (uint32_t i = 0; i < set->count; ++i) {
        geom_disc *disc = &set->forward[i];
        *disc = disc_at_rate(disc, disc->rate, i > 0 ? disc - 1 : NULL);
    }
    set_turn(set);
    set_find_rate_min(set);
    return TDSP_OK;
}
