/* SPDX-License-Identifier: MIT */
/*
 * Building the spatial index: its invariant is in index.h.
 *
 * First the order, from the top down, over keys of 16 bytes: each branch is halved where its widest coordinate has its middle. That is one
 * pass over the branch, makes branches that are wide in no direction, and leaves few discs after few levels unless clusters are nested
 * in clusters. Below DEPTH_BY_PLACE levels branches are halved by number instead: O(n log n) expected for any scene. Then the discs
 * are moved. Last the boxes, from the bottom up.
 */
#include "scene/index.h"

#include <float.h>
#include <string.h>

/* Below this depth branches are halved by number: 31 more levels reach single discs. */
#define DEPTH_BY_PLACE 40u

/* Rates above this are not told apart: they are hopeless to outrun, and floats end somewhere. */
#define FASTEST 1e6

/* Boxes are wider than their discs by this share of the coordinates, against rounding. */
#define BOX_SLACK 1e-15

/* The least float that is not less; for x >= 0. */
static float float_above(double x)
{
    float near = x < (double)FLT_MAX ? (float)x : FLT_MAX;
    uint32_t bits;
    if ((double)near >= x || near >= FLT_MAX) return near;
    memcpy(&bits, &near, sizeof bits);
    ++bits;
    memcpy(&near, &bits, sizeof near);
    return near;
}

static double least(double a, double b)
{
    return a < b ? a : b;
}

static double most(double a, double b)
{
    return a > b ? a : b;
}

static index_key key_of(const geom_disc *disc, uint32_t place)
{
    double reach = disc->radius + least(disc->rate, FASTEST);
    index_key key = {{(float)disc->center.x, (float)disc->center.y, (float)reach}, place};
    return key;
}

/* The widest of a range's coordinates, and its middle. */
typedef struct key_cut {
    int axis;
    float middle; /* some keys are below it, some are not; NaN where all are equal */
} key_cut;

static key_cut cut_find(const index_key *keys, uint32_t count)
{
    float low[3], high[3], widest = 0.0f;
    key_cut cut = {0, NAN};
    for (int axis = 0; axis < 3; ++axis) low[axis] = high[axis] = keys[0].place[axis];
    for (uint32_t i = 1; i < count; ++i) {
        for (int axis = 0; axis < 3; ++axis) {
            float place = keys[i].place[axis];
            low[axis] = place < low[axis] ? place : low[axis];
            high[axis] = place > high[axis] ? place : high[axis];
        }
    }
    for (int axis = 0; axis < 3; ++axis) {
        if (!(high[axis] - low[axis] > widest)) continue;
        widest = high[axis] - low[axis];
        cut.axis = axis;
        cut.middle = low[axis] + 0.5f * widest;
        if (!(cut.middle > low[axis])) cut.middle = high[axis];
    }
    return cut;
}

/* Puts the keys below the cut first; returns how many. */
static uint32_t cut_apply(index_key *keys, uint32_t count, key_cut cut)
{
    uint32_t below = 0;
    for (uint32_t i = 0; i < count; ++i) {
        index_key key = keys[i];
        keys[i] = keys[below];
        keys[below] = key;
        below += key.place[cut.axis] < cut.middle;
    }
    return below;
}

/* Hoare's selection: afterwards no key before the middle is larger, and none behind it smaller, than the one there. */
static uint32_t keys_halve(index_key *keys, uint32_t count, int axis)
{
    int64_t first = 0, last = (int64_t)count - 1, middle = count / 2;
    while (first < last) {
        float pivot = keys[middle].place[axis];
        int64_t i = first, j = last;
        while (i <= j) {
            while (keys[i].place[axis] < pivot) ++i;
            while (keys[j].place[axis] > pivot) --j;
            if (i > j) break;
            index_key key = keys[i];
            keys[i++] = keys[j];
            keys[j--] = key;
        }
        if (j < middle) first = i;
        if (i > middle) last = j;
    }
    return (uint32_t)middle;
}

static uint32_t keys_divide(index_key *keys, uint32_t count, uint32_t depth)
{
    key_cut cut = cut_find(keys, count);
    if (isnan(cut.middle)) return count / 2;
    return depth < DEPTH_BY_PLACE ? cut_apply(keys, count, cut) : keys_halve(keys, count, cut.axis);
}

/* A range of keys that waits for its node. */
typedef struct index_branch {
    uint32_t first, count, depth;
    uint32_t parent; /* whose right child it is */
} index_branch;

static tdsp_status index_add_node(scene_index *index, const tdsp_allocator *allocator, const index_branch *branch)
{
    tdsp_status status = memory_reserve(allocator, (void **)&index->nodes, &index->node_capacity, (size_t)index->node_count + 1,
                                        sizeof *index->nodes);
    if (status != TDSP_OK) return status;
    if (branch->parent != INDEX_NONE) index->nodes[branch->parent].right = index->node_count;
    index_node *node = &index->nodes[index->node_count++];
    memset(node, 0, sizeof *node);
    node->first = branch->first;
    node->count = branch->count <= INDEX_LEAF ? branch->count : 0;
    return TDSP_OK;
}

/* Order the keys, and lay out the nodes over them. */
static tdsp_status index_divide(scene_index *index, const tdsp_allocator *allocator, uint32_t count)
{
    index_branch todo[INDEX_DEPTH];
    int top = 0;
    index_branch root = {0, count, 0, INDEX_NONE};
    todo[top++] = root;
    index->node_count = 0;
    while (top > 0) {
        index_branch branch = todo[--top];
        uint32_t self = index->node_count;
        tdsp_status status = index_add_node(index, allocator, &branch);
        if (status != TDSP_OK) return status;
        if (branch.count <= INDEX_LEAF) continue;
        uint32_t left = keys_divide(index->keys + branch.first, branch.count, branch.depth);
        index_branch before = {branch.first, left, branch.depth + 1, INDEX_NONE};
        index_branch after = {branch.first + left, branch.count - left, branch.depth + 1, self};
        todo[top++] = after;
        todo[top++] = before;
    }
    return TDSP_OK;
}

/* Bring the items into the order of the keys, by way of the spare discs. */
static void items_move(index_items items, index_key *keys)
{
    for (uint32_t i = 0; i < items.count; ++i) {
        uint32_t from = keys[i].disc;
        items.spare[i] = items.discs[from];
        keys[i].disc = items.given[from];
    }
    memcpy(items.discs, items.spare, items.count * sizeof *items.discs);
    for (uint32_t i = 0; i < items.count; ++i) items.given[i] = keys[i].disc;
}

/* The box between two corners. */
static void node_set_box(index_node *node, tdsp_point low, tdsp_point high)
{
    double half_x = 0.5 * (high.x - low.x), half_y = 0.5 * (high.y - low.y);
    node->middle = point_make(low.x + half_x, low.y + half_y);
    node->half_x = float_above(half_x + BOX_SLACK * (fabs(node->middle.x) + half_x));
    node->half_y = float_above(half_y + BOX_SLACK * (fabs(node->middle.y) + half_y));
}

/* The circle: around parts at these distances, but no larger than around the box. */
static void node_set_circle(index_node *node, double half)
{
    double x = node->half_x, y = node->half_y;
    node->half = float_above((1.0 + BOX_SLACK) *
                             least(half + BOX_SLACK * (fabs(node->middle.x) + fabs(node->middle.y)), sqrt(x * x + y * y)));
}

static void node_bound_discs(index_node *node, const geom_disc *discs)
{
    tdsp_point low = discs[0].center, high = low;
    double rate = 0.0, half = 0.0;
    for (uint32_t i = 0; i < node->count; ++i) {
        tdsp_point center = discs[i].center;
        double radius =
            discs[i].rate < (double)FLT_MAX ? discs[i].radius : (double)FLT_MAX; /* a rate that no float tells: everywhere */
        low = point_make(least(low.x, center.x - radius), least(low.y, center.y - radius));
        high = point_make(most(high.x, center.x + radius), most(high.y, center.y + radius));
        rate = most(rate, discs[i].rate);
    }
    node_set_box(node, low, high);
    for (uint32_t i = 0; i < node->count; ++i) half = most(half, point_distance(discs[i].center, node->middle) + discs[i].radius);
    node_set_circle(node, half);
    node->rate = float_above(rate);
}

static void node_bound_children(index_node *node, const index_node *a, const index_node *b)
{
    tdsp_point low = point_make(least(a->middle.x - a->half_x, b->middle.x - b->half_x),
                                least(a->middle.y - a->half_y, b->middle.y - b->half_y));
    tdsp_point high = point_make(most(a->middle.x + a->half_x, b->middle.x + b->half_x),
                                 most(a->middle.y + a->half_y, b->middle.y + b->half_y));
    node_set_box(node, low, high);
    node_set_circle(node,
                    most(point_distance(a->middle, node->middle) + a->half, point_distance(b->middle, node->middle) + b->half));
    node->rate = a->rate > b->rate ? a->rate : b->rate;
}

/* Children stand behind their parents: backwards, they are bounded first. */
static void index_bound(scene_index *index, const geom_disc *discs)
{
    for (uint32_t k = index->node_count; k-- > 0;) {
        index_node *node = &index->nodes[k];
        if (node->count) {
            node_bound_discs(node, discs + node->first);
        } else {
            node_bound_children(node, &index->nodes[k + 1], &index->nodes[node->right]);
        }
    }
}

tdsp_status index_build(scene_index *index, const tdsp_allocator *allocator, index_items items)
{
    index->node_count = 0;
    if (items.count == 0) return TDSP_OK;
    tdsp_status status = memory_reserve(allocator, (void **)&index->keys, &index->key_capacity, items.count, sizeof *index->keys);
    if (status == TDSP_OK)
        status =
            memory_reserve(allocator, (void **)&index->nodes, &index->node_capacity, items.count / 2 + 1, sizeof *index->nodes);
    if (status != TDSP_OK) return status;
    for (uint32_t i = 0; i < items.count; ++i) index->keys[i] = key_of(&items.discs[i], i);
    status = index_divide(index, allocator, items.count);
    if (status != TDSP_OK) {
        index->node_count = 0;
        return status;
    }
    items_move(items, index->keys);
    index_bound(index, items.discs);
    return TDSP_OK;
}

tdsp_status index_trim(scene_index *index, const tdsp_allocator *allocator)
{
    memory_free(allocator, index->keys, index->key_capacity * sizeof *index->keys);
    index->keys = NULL;
    index->key_capacity = 0;
    return memory_shrink(allocator, (void **)&index->nodes, &index->node_capacity, index->node_count, sizeof *index->nodes);
}

void index_free(scene_index *index, const tdsp_allocator *allocator)
{
    memory_free(allocator, index->nodes, index->node_capacity * sizeof *index->nodes);
    memory_free(allocator, index->keys, index->key_capacity * sizeof *index->keys);
    memset(index, 0, sizeof *index);
}
