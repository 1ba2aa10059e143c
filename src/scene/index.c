/* Building the spatial index: its invariant is in index.h. */
#include "scene/index.h"

#define LEAF 4u

/* Rates further apart than this share of the robot's speed are worth a branch of their own. */
#define RATE_SPREAD 0.1

static double key_x(const geom_disc *disc)
{
    return disc->center.x;
}

static double key_y(const geom_disc *disc)
{
    return disc->center.y;
}

static double key_rate(const geom_disc *disc)
{
    return disc->rate;
}

typedef double (*disc_key)(const geom_disc *disc);

static void items_swap(index_items items, uint32_t a, uint32_t b)
{
    geom_disc disc = items.discs[a];
    uint32_t given = items.given[a];
    items.discs[a] = items.discs[b];
    items.given[a] = items.given[b];
    items.discs[b] = disc;
    items.given[b] = given;
}

/* Ties are broken by the given index: the order does not depend on the algorithm's luck. */
static int items_before(index_items items, uint32_t a, uint32_t b, disc_key key)
{
    double ka = key(&items.discs[a]), kb = key(&items.discs[b]);
    return ka < kb || (ka == kb && items.given[a] < items.given[b]);
}

/* Quickselect: the item at `middle` is where sorting by key would put it, smaller ones before it. */
static void items_select(index_items items, uint32_t first, uint32_t last, uint32_t middle, disc_key key)
{
    while (first < last) {
        uint32_t probe = first + (last - first) / 2;
        if (items_before(items, probe, first, key)) items_swap(items, probe, first);
        if (items_before(items, last, first, key)) items_swap(items, last, first);
        if (items_before(items, last, probe, key)) items_swap(items, last, probe);
        items_swap(items, probe, last);
        uint32_t store = first;
        for (uint32_t i = first; i < last; ++i)
            if (items_before(items, i, last, key)) items_swap(items, i, store++);
        items_swap(items, store, last);
        if (store == middle) return;
        if (store < middle) {
            first = store + 1;
        } else {
            last = store - 1;
        }
    }
}

static index_node node_around(index_items items, uint32_t first, uint32_t count)
{
    const geom_disc *disc = &items.discs[first];
    index_node node = {disc->center.x, disc->center.y, disc->center.x, disc->center.y, disc->radius, disc->rate, disc->rate, disc->center, 0.0,
                       first,          count,          0};
    for (uint32_t i = first + 1; i < first + count; ++i) {
        disc = &items.discs[i];
        node.min_x = fmin(node.min_x, disc->center.x);
        node.max_x = fmax(node.max_x, disc->center.x);
        node.min_y = fmin(node.min_y, disc->center.y);
        node.max_y = fmax(node.max_y, disc->center.y);
        node.radius = fmax(node.radius, disc->radius);
        node.rate = fmax(node.rate, disc->rate);
        node.rate_min = fmin(node.rate_min, disc->rate);
    }
    double half_x = 0.5 * (node.max_x - node.min_x), half_y = 0.5 * (node.max_y - node.min_y);
    node.middle = point_make(node.min_x + half_x, node.min_y + half_y);
    node.half = sqrt(half_x * half_x + half_y * half_y);
    return node;
}

static disc_key node_key(const index_node *node)
{
    if (node->rate - node->rate_min > RATE_SPREAD) return key_rate;
    return node->max_x - node->min_x > node->max_y - node->min_y ? key_x : key_y;
}

/* How many of the node's discs go left: half, or those slower than the middle of the rates. */
static uint32_t node_share(index_items items, const index_node *node, disc_key key)
{
    if (key != key_rate) return node->count / 2;
    double middle = 0.5 * (node->rate + node->rate_min);
    uint32_t slow = 0;
    for (uint32_t i = node->first; i < node->first + node->count; ++i) slow += items.discs[i].rate < middle;
    return slow;
}

tdsp_status index_build(scene_index *index, const tdsp_allocator *allocator, index_items items)
{
    struct {
        uint32_t first, count, parent;
    } todo[INDEX_DEPTH];
    int top = 0;
    tdsp_status status = memory_reserve(allocator, (void **)&index->nodes, &index->node_capacity, 2 * (size_t)items.count,
                                        sizeof *index->nodes);
    index->node_count = 0;
    if (status != TDSP_OK || items.count == 0) return status;
    todo[top].first = 0;
    todo[top].count = items.count;
    todo[top++].parent = INDEX_NONE;
    while (top > 0) {
        uint32_t first = todo[--top].first, count = todo[top].count, parent = todo[top].parent;
        uint32_t self = index->node_count++;
        index_node *node = &index->nodes[self];
        *node = node_around(items, first, count);
        if (parent != INDEX_NONE) index->nodes[parent].right = self;
        if (count <= LEAF || top + 2 > INDEX_DEPTH) continue;
        disc_key key = node_key(node);
        uint32_t left = node_share(items, node, key);
        items_select(items, first, first + count - 1, first + left, key);
        node->count = 0;
        todo[top].first = first + left;
        todo[top].count = count - left;
        todo[top++].parent = self;
        todo[top].first = first;
        todo[top].count = left;
        todo[top++].parent = INDEX_NONE;
    }
    return TDSP_OK;
}

void index_free(scene_index *index, const tdsp_allocator *allocator)
{
    memory_free(allocator, index->nodes, index->node_capacity * sizeof *index->nodes);
    index->nodes = NULL;
    index->node_count = 0;
    index->node_capacity = 0;
}
