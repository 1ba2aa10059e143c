/* SPDX-License-Identifier: MIT */
/*
 * A set of discs in the frame, ready to be searched: both directions of time, and an index. `forward[k]` and `reverse[k]` are
 * the same disc, in the order of the index; `origin[k]` is its place where it came from.
 */
#ifndef SCENE_DISC_SET_H
#define SCENE_DISC_SET_H

#include "scene/index.h"

typedef struct disc_set {
    geom_disc *forward;
    geom_disc *reverse;
    uint32_t *origin;
    uint32_t count;
    size_t forward_capacity, reverse_capacity, origin_capacity;
    double rate_min;
    scene_index index;
} disc_set;

/* Room to fill in `count` discs. TDSP_OK or TDSP_NO_MEMORY. */
tdsp_status set_reserve(disc_set *set, const tdsp_allocator *allocator, size_t count);
void set_free(disc_set *set, const tdsp_allocator *allocator);

/* After `forward`, `origin` and `count` were filled: order, index, and reverse. TDSP_OK or TDSP_NO_MEMORY. */
tdsp_status set_prepare(disc_set *set, const tdsp_allocator *allocator);

/*
 * The same after all but the angles of `forward` were filled, and for good: without the discs that can never matter, and without room
 * for more.
 */
tdsp_status set_prepare_whole(disc_set *set, const tdsp_allocator *allocator);

/* Some of another set's discs, prepared: origin[k] is then the place in that set. TDSP_OK or TDSP_NO_MEMORY. */
tdsp_status set_choose(disc_set *set, const tdsp_allocator *allocator, const disc_set *from, const uint32_t *chosen,
                       uint32_t count);

static inline size_t set_bytes(const disc_set *set)
{
    size_t discs = (set->forward_capacity + set->reverse_capacity) * sizeof(geom_disc);
    return discs + set->origin_capacity * sizeof(uint32_t) + index_bytes(&set->index);
}

#endif
