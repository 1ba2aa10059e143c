/* SPDX-License-Identifier: MIT */
/*
 * The discs around a disc, in rings: looked up once, kept for as long as the set of discs stays the same.
 *
 * A disc's gap is the distance from the ring's centre to its boundary at time 0. The ring of radius r holds the discs whose gaps are at most r and
 * larger than the radius of the ring before it, so rings depend on no question, and at the true time t no disc outside the ring of radius r is
 * nearer than r - rate * t, for the largest rate of the set. Discs stand in blocks of single-precision columns: one pass over a block tells which
 * of its discs may matter, without touching the discs themselves.
 */
#ifndef SEARCH_NEIGHBOURS_H
#define SEARCH_NEIGHBOURS_H

#include "scene/disc_set.h"

#define NEIGHBOUR_BLOCK 16
#define NEIGHBOUR_RINGS 12

/* A rider needs no more rings once there are so many discs in them. */
#define NEIGHBOURS_MOST 48u

/* Unused places at a block's end hold INDEX_NONE and are out of reach, but of radii that no float holds. */
typedef struct neighbour_block {
    float distance[NEIGHBOUR_BLOCK]; /* of the centres */
    float bearing[NEIGHBOUR_BLOCK];  /* within GEOM_ANGLE_NEAR */
    float gap[NEIGHBOUR_BLOCK];
    uint32_t disc[NEIGHBOUR_BLOCK];
} neighbour_block;

typedef struct neighbour_ring {
    uint32_t first; /* block */
    uint32_t count; /* discs */
    double radius;
} neighbour_ring;

/* What stands around one place. */
typedef struct neighbour_rings {
    tdsp_point center;
    double own;    /* radius of the disc in the middle, at time 0 */
    double inner;  /* radius of the first ring */
    uint32_t self; /* the disc in the middle, or INDEX_NONE */
    uint32_t disc_count;
    uint32_t ring_count;
    neighbour_ring rings[NEIGHBOUR_RINGS];
} neighbour_rings;

typedef struct neighbourhood {
    const disc_set *set;
    neighbour_block *blocks;
    size_t block_count, block_capacity;
    neighbour_rings *rings;
    size_t rings_count, rings_capacity;
    uint32_t *places; /* for each disc: where its rings are, plus 1; 0: not looked up */
    size_t place_capacity;
    uint32_t points[2]; /* the same for the last two points, the newer one first */
    uint32_t point_count; /* points looked up so far */
} neighbourhood;

/* Forget everything, and begin with these discs. TDSP_OK or TDSP_NO_MEMORY. O(discs). */
tdsp_status neighbours_begin(neighbourhood *self, const tdsp_allocator *allocator, const disc_set *set);
void neighbours_free(neighbourhood *self, const tdsp_allocator *allocator);
uint64_t neighbours_bytes(const neighbourhood *self);

/* The rings around a disc of the set, as a place in self->rings; there may be none yet. */
tdsp_status neighbours_of_disc(neighbourhood *self, const tdsp_allocator *allocator, uint32_t disc, uint32_t *place);

/* The same around any point. Those of the last two points are remembered. */
tdsp_status neighbours_of_point(neighbourhood *self, const tdsp_allocator *allocator, tdsp_point point, uint32_t *place);

/* Do the rings of points that are asked about no more take up much room next to the discs? */
int neighbours_crowded(const neighbourhood *self);

/* Look up one more ring, if they hold fewer than `most` discs; *added is 0 when there are enough of them. Expected O(log n + discs in it). */
tdsp_status neighbours_widen(neighbourhood *self, const tdsp_allocator *allocator, uint32_t place, uint32_t most, int *added);

/* Do the rings hold every disc? */
int neighbours_complete(const neighbourhood *self, uint32_t place);

#endif
