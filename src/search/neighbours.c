/* SPDX-License-Identifier: MIT */
/* Rings of neighbours: what they hold is in neighbours.h. */
#include "search/neighbours.h"

#include <string.h>

#include "geom/angle.h"

/* Each ring reaches farther from its disc than the one before it by this factor. */
#define WIDER 1.5

/* The first ring, in spacings of the discs about the place: it holds some ten of them where they stand evenly. */
#define FIRST_RING 0.5

/* ... but is never smaller than this share of the whole set. */
#define LEAST_RING 1e-6

/* The rings of so many points, and of one more for so many discs, are kept: 320 bytes a disc at most, and some megabyte. */
#define MOST_POINTS 256u
#define DISCS_A_POINT 16u

tdsp_status neighbours_begin(neighbourhood *self, const tdsp_allocator *allocator, const disc_set *set)
{
    tdsp_status status = memory_reserve(allocator, (void **)&self->places, &self->place_capacity, set->count, sizeof *self->places);
    if (status != TDSP_OK) return status;
    if (set->count) memset(self->places, 0, set->count * sizeof *self->places);
    self->set = set;
    self->block_count = self->rings_count = 0;
    self->points[0] = self->points[1] = self->point_count = 0;
    return TDSP_OK;
}

void neighbours_free(neighbourhood *self, const tdsp_allocator *allocator)
{
    memory_free(allocator, self->blocks, self->block_capacity * sizeof *self->blocks);
    memory_free(allocator, self->rings, self->rings_capacity * sizeof *self->rings);
    memory_free(allocator, self->places, self->place_capacity * sizeof *self->places);
    memset(self, 0, sizeof *self);
}

uint64_t neighbours_bytes(const neighbourhood *self)
{
    return self->block_capacity * sizeof *self->blocks + self->rings_capacity * sizeof *self->rings + self->place_capacity * sizeof *self->places;
}

/* How far apart discs stand about a place: half the diagonal of the index node two levels over the leaf next to it. */
static double spacing_at(const scene_index *index, tdsp_point place)
{
    const index_node *nodes = index->nodes;
    uint32_t at = 0;
    double grandparent = nodes[0].half, parent = nodes[0].half;
    while (!nodes[at].count) {
        uint32_t left = at + 1, right = nodes[at].right;
        tdsp_point to_left = point_sub(nodes[left].middle, place), to_right = point_sub(nodes[right].middle, place);
        grandparent = parent;
        parent = nodes[at].half;
        at = point_dot(to_left, to_left) <= point_dot(to_right, to_right) ? left : right;
    }
    double least = LEAST_RING * nodes[0].half;
    return grandparent > least ? grandparent : least;
}

static tdsp_status rings_add(neighbourhood *self, const tdsp_allocator *allocator, tdsp_point center, double own, uint32_t disc, uint32_t *place)
{
    tdsp_status status = memory_reserve(allocator, (void **)&self->rings, &self->rings_capacity, self->rings_count + 1, sizeof *self->rings);
    if (status != TDSP_OK) return status;
    neighbour_rings *rings = &self->rings[self->rings_count];
    rings->center = center;
    rings->own = own;
    rings->inner = own + (self->set->count ? FIRST_RING * spacing_at(&self->set->index, center) : 0.0);
    rings->self = disc;
    rings->disc_count = rings->ring_count = 0;
    *place = (uint32_t)self->rings_count++;
    return TDSP_OK;
}

tdsp_status neighbours_of_disc(neighbourhood *self, const tdsp_allocator *allocator, uint32_t disc, uint32_t *place)
{
    const geom_disc *middle = &self->set->forward[disc];
    *place = self->places[disc] - 1;
    if (self->places[disc]) return TDSP_OK;
    tdsp_status status = rings_add(self, allocator, middle->center, middle->radius, disc, place);
    if (status == TDSP_OK) self->places[disc] = *place + 1;
    return status;
}

tdsp_status neighbours_of_point(neighbourhood *self, const tdsp_allocator *allocator, tdsp_point point, uint32_t *place)
{
    for (int i = 0; i < 2; ++i) {
        *place = self->points[i] - 1;
        if (self->points[i] && point_distance(self->rings[*place].center, point) == 0.0) return TDSP_OK;
    }
    tdsp_status status = rings_add(self, allocator, point, 0.0, INDEX_NONE, place);
    if (status != TDSP_OK) return status;
    self->points[1] = self->points[0];
    self->points[0] = *place + 1;
    ++self->point_count;
    return TDSP_OK;
}

int neighbours_crowded(const neighbourhood *self)
{
    return self->point_count > MOST_POINTS + self->set->count / DISCS_A_POINT;
}

int neighbours_complete(const neighbourhood *self, uint32_t place)
{
    const neighbour_rings *rings = &self->rings[place];
    return rings->disc_count + (rings->self != INDEX_NONE) == self->set->count;
}

static tdsp_status block_begin(neighbourhood *self, const tdsp_allocator *allocator)
{
    tdsp_status status = memory_reserve(allocator, (void **)&self->blocks, &self->block_capacity, self->block_count + 1, sizeof *self->blocks);
    if (status != TDSP_OK) return status;
    neighbour_block *block = &self->blocks[self->block_count++];
    for (int i = 0; i < NEIGHBOUR_BLOCK; ++i) {
        block->distance[i] = 1.0f;
        block->bearing[i] = 0.0f;
        block->gap[i] = 1e30f;
        block->disc[i] = INDEX_NONE;
    }
    return TDSP_OK;
}

/* Put the discs of a leaf whose gaps are in (inner, ring->radius] into the ring. */
static tdsp_status ring_take(neighbourhood *self, const tdsp_allocator *allocator, const neighbour_rings *rings, neighbour_ring *ring, double inner,
                             const index_node *leaf)
{
    for (uint32_t k = leaf->first; k < leaf->first + leaf->count; ++k) {
        const geom_disc *disc = &self->set->forward[k];
        tdsp_point offset = point_sub(disc->center, rings->center);
        double distance = point_length(offset), gap = distance - disc->radius;
        if (gap > ring->radius || gap <= inner || k == rings->self) continue;
        uint32_t at = ring->count++ % NEIGHBOUR_BLOCK;
        tdsp_status status = at == 0 ? block_begin(self, allocator) : TDSP_OK;
        if (status != TDSP_OK) return status;
        neighbour_block *block = &self->blocks[self->block_count - 1];
        block->distance[at] = (float)distance;
        block->bearing[at] = (float)angle_near(offset.y, offset.x);
        block->gap[at] = (float)gap;
        block->disc[at] = k;
    }
    return TDSP_OK;
}

/* Are the gaps of all discs below the node certainly at most `radius`? */
static int node_within(const index_node *node, tdsp_point center, double radius)
{
    double spare = radius - node->half;
    tdsp_point offset = point_sub(node->middle, center);
    return spare > 0.0 && point_dot(offset, offset) < spare * spare * (1.0 - 1e-12);
}

/* Everything between `inner` and the ring's radius. */
static tdsp_status ring_fill(neighbourhood *self, const tdsp_allocator *allocator, const neighbour_rings *rings, neighbour_ring *ring, double inner)
{
    const index_node *nodes = self->set->index.nodes;
    uint32_t later[INDEX_DEPTH], at = 0;
    tdsp_status status = TDSP_OK;
    for (int top = 0; status == TDSP_OK;) {
        const index_node *node = &nodes[at];
        int met = index_node_distance(node, rings->center) <= ring->radius && !node_within(node, rings->center, inner);
        if (met && !node->count) {
            later[top++] = node->right;
            ++at;
            continue;
        }
        if (met) status = ring_take(self, allocator, rings, ring, inner, node);
        if (top == 0) break;
        at = later[--top];
    }
    return status;
}

tdsp_status neighbours_widen(neighbourhood *self, const tdsp_allocator *allocator, uint32_t place, uint32_t most, int *added)
{
    neighbour_rings *rings = &self->rings[place];
    *added = 0;
    if (rings->ring_count == NEIGHBOUR_RINGS || rings->disc_count >= most || neighbours_complete(self, place)) return TDSP_OK;
    double inner = rings->ring_count ? rings->rings[rings->ring_count - 1].radius : -INFINITY;
    neighbour_ring *ring = &rings->rings[rings->ring_count];
    ring->radius = rings->ring_count ? rings->own + WIDER * (inner - rings->own) : rings->inner;
    ring->first = (uint32_t)self->block_count;
    ring->count = 0;
    tdsp_status status = ring_fill(self, allocator, rings, ring, inner);
    if (status != TDSP_OK) return status;
    rings->disc_count += ring->count;
    ++rings->ring_count;
    *added = 1;
    return TDSP_OK;
}
