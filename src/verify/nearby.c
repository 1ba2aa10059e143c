/* See nearby.h for the invariant. */
#include "verify/nearby.h"

#include <math.h>

#include "scene/allocator.h"

#define LEAF_DISCS 8u
#define STACK_NODES 64 /* two for each level: the discs number less than 2^31 */

static double center_along(const nearby_disc *disc, int axis)
{
    return axis == 0 ? disc->center.x : disc->center.y;
}

static void disc_swap(nearby_disc *a, nearby_disc *b)
{
    const nearby_disc kept = *a;
    *a = *b;
    *b = kept;
}

/* Hoare's selection: afterwards none below `middle` lies beyond any from `middle` on. */
static void discs_halve(nearby_disc *discs, size_t low, size_t high, size_t middle, int axis)
{
    while (high - low > 1) {
        const double pivot = center_along(&discs[low + (high - low) / 2], axis);
        size_t i = low, j = high - 1;
        for (;;) {
            while (center_along(&discs[i], axis) < pivot)
                i++;
            while (center_along(&discs[j], axis) > pivot)
                j--;
            if (i >= j) break;
            disc_swap(&discs[i++], &discs[j--]);
        }
        if (middle < i)
            high = i;
        else if (middle > j)
            low = j + 1;
        else
            return;
    }
}

static nearby_node node_over(const nearby_disc *discs, size_t low, size_t high)
{
    nearby_node node = {discs[low].center, discs[low].center, 0.0, 0.0};
    for (size_t i = low; i < high; i++) {
        node.low.x = fmin(node.low.x, discs[i].center.x);
        node.low.y = fmin(node.low.y, discs[i].center.y);
        node.high.x = fmax(node.high.x, discs[i].center.x);
        node.high.y = fmax(node.high.y, discs[i].center.y);
        node.radius = fmax(node.radius, discs[i].radius);
        node.growth = fmax(node.growth, discs[i].growth);
    }
    return node;
}

static void tree_build(nearby_index *index, size_t node, size_t low, size_t high)
{
    index->nodes[node] = node_over(index->discs, low, high);
    if (2 * node + 2 >= index->node_count) return;
    const nearby_node *over = &index->nodes[node];
    const int axis = over->high.x - over->low.x < over->high.y - over->low.y;
    const size_t middle = low + (high - low) / 2;
    discs_halve(index->discs, low, high, middle, axis);
    tree_build(index, 2 * node + 1, low, middle);
    tree_build(index, 2 * node + 2, middle, high);
}

static void discs_inflate(const tdsp_scene *scene, nearby_disc *out)
{
    size_t count;
    const tdsp_disc *discs = tdsp_scene_discs(scene, &count);
    const double robot = tdsp_scene_journey(scene)->radius;
    for (size_t i = 0; i < count; i++)
        out[i] = (nearby_disc){discs[i].center, discs[i].radius + robot, discs[i].growth, (uint32_t)i};
}

tdsp_status nearby_build(const tdsp_scene *scene, const tdsp_allocator *allocator, nearby_index *out)
{
    size_t count;
    tdsp_scene_discs(scene, &count);
    nearby_index index = {NULL, NULL, count, 0, *allocator};
    if (count > 0) {
        size_t leaves = 1;
        while (count / leaves > LEAF_DISCS)
            leaves *= 2;
        index.node_count = 2 * leaves - 1;
        index.discs = memory_array(allocator, count, sizeof *index.discs);
        index.nodes = memory_array(allocator, index.node_count, sizeof *index.nodes);
        if (!index.discs || !index.nodes) {
            nearby_free(&index);
            return TDSP_NO_MEMORY;
        }
        discs_inflate(scene, index.discs);
        tree_build(&index, 0, 0, count);
    }
    *out = index;
    return TDSP_OK;
}

void nearby_free(nearby_index *index)
{
    memory_free(&index->allocator, index->discs, index->count * sizeof *index->discs);
    memory_free(&index->allocator, index->nodes, index->node_count * sizeof *index->nodes);
}

static int node_near(const nearby_node *node, const motion_circle *circle, double time, double limit)
{
    const double dx = fmax(0.0, fmax(node->low.x - circle->center.x, circle->center.x - node->high.x));
    const double dy = fmax(0.0, fmax(node->low.y - circle->center.y, circle->center.y - node->high.y));
    return hypot(dx, dy) - circle->radius - node->radius - node->growth * time < limit;
}

static void leaf_visit(const nearby_disc *discs, size_t count, const motion_circle *circle, double time, const double *limit,
                       nearby_visitor visitor, void *ctx)
{
    for (size_t i = 0; i < count; i++) {
        const double gap = motion_distance(circle->center, discs[i].center) - circle->radius;
        if (gap - discs[i].radius - discs[i].growth * time < *limit) visitor(ctx, &discs[i]);
    }
}

void nearby_visit(const nearby_index *index, const motion_circle *circle, double time, const double *limit,
                  nearby_visitor visitor, void *ctx)
{
    struct {
        size_t node, low, high;
    } stack[STACK_NODES];
    size_t open = 0;
    if (index->count > 0) {
        stack[open].node = stack[open].low = 0;
        stack[open++].high = index->count;
    }
    while (open > 0) {
        const size_t node = stack[--open].node, low = stack[open].low, high = stack[open].high;
        if (!node_near(&index->nodes[node], circle, time, *limit)) continue;
        if (2 * node + 2 >= index->node_count) {
            leaf_visit(index->discs + low, high - low, circle, time, limit, visitor, ctx);
            continue;
        }
        const size_t middle = low + (high - low) / 2;
        stack[open].node = 2 * node + 1;
        stack[open].low = low;
        stack[open++].high = middle;
        stack[open].node = 2 * node + 2;
        stack[open].low = middle;
        stack[open++].high = high;
    }
}
