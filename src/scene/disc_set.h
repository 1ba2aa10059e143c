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
    size_t capacity;
    double rate_min;
    scene_index index;
} disc_set;

/* Room for `count` discs; what the set held may be lost. TDSP_OK or TDSP_NO_MEMORY (the set is then empty). */
tdsp_status set_reserve(disc_set *set, const tdsp_allocator *allocator, size_t count);
void set_free(disc_set *set, const tdsp_allocator *allocator);

/* After `forward`, `origin` and `count` were filled: order, index, and reverse. TDSP_OK or TDSP_NO_MEMORY. */
tdsp_status set_prepare(disc_set *set, const tdsp_allocator *allocator);

static inline size_t set_bytes(const disc_set *set)
{
    return set->capacity * (2 * sizeof(geom_disc) + sizeof(uint32_t)) + set->index.node_capacity * sizeof(index_node);
}

#endif
