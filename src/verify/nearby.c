/* See nearby.h for the invariant. */
#include "verify/nearby.h"

#include <math.h>

#include "scene/allocator.h"
#include "tdsp/growth.h"
#include "verify/swell.h"

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

/* Fill in the largest radii below a node at a time; the tree is built. */
static double reach_of(nearby_index *index, double *reach, double time, size_t node, size_t low, size_t high)
{
    double largest = 0.0;
    if (2 * node + 2 >= index->node_count) {
        for (size_t i = low; i < high; i++) {
            const swell_piece piece = swell_at(index->scene, index->discs[i].index, time);
            largest = fmax(largest, swell_radius(&piece, time));
        }
    } else {
        const size_t middle = low + (high - low) / 2;
        largest = reach_of(index, reach, time, 2 * node + 1, low, middle);
        largest = fmax(largest, reach_of(index, reach, time, 2 * node + 2, middle, high));
    }
    reach[node] = largest;
    return largest;
}

static tdsp_status reach_build(nearby_index *index)
{
    index->reach = memory_array(&index->allocator, NEARBY_STEPS * index->node_count, sizeof *index->reach);
    if (!index->reach) return TDSP_NO_MEMORY;
    for (size_t step = 0; step < NEARBY_STEPS; step++) {
        const double time = step + 1 < NEARBY_STEPS ? index->until / NEARBY_STEPS * (double)(step + 1) : index->until;
        reach_of(index, index->reach + step * index->node_count, time, 0, 0, index->count);
    }
    return TDSP_OK;
}

/* The largest radii of the nodes at a step that is not before `time`; NULL when there is none. */
static const double *reach_at(const nearby_index *index, double time)
{
    size_t step = 0;
    if (time > index->until) return NULL;
    while (step + 1 < NEARBY_STEPS && index->until / NEARBY_STEPS * (double)(step + 1) < time)
        step++;
    return index->reach + step * index->node_count;
}

static void discs_inflate(const tdsp_scene *scene, nearby_disc *out)
{
    size_t count;
    const tdsp_disc *discs = tdsp_scene_discs(scene, &count);
    const double robot = tdsp_scene_journey(scene)->radius;
    for (size_t i = 0; i < count; i++)
        out[i] = (nearby_disc){discs[i].center, discs[i].radius + robot, discs[i].growth, (uint32_t)i};
}

tdsp_status nearby_build(const tdsp_scene *scene, double until, const tdsp_allocator *allocator, nearby_index *out)
{
    size_t count;
    tdsp_scene_discs(scene, &count);
    nearby_index index = {.count = count, .allocator = *allocator, .until = until};
    if (!tdsp_scene_has_rates_only(scene)) index.scene = scene;
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
        if (index.scene && reach_build(&index) != TDSP_OK) {
            nearby_free(&index);
            return TDSP_NO_MEMORY;
        }
    }
    *out = index;
    return TDSP_OK;
}

void nearby_free(nearby_index *index)
{
    memory_free(&index->allocator, index->discs, index->count * sizeof *index->discs);
    memory_free(&index->allocator, index->nodes, index->node_count * sizeof *index->nodes);
    memory_free(&index->allocator, index->reach, NEARBY_STEPS * index->node_count * sizeof *index->reach);
}

/* What is looked for. */
typedef struct query {
    const nearby_index *index;
    const motion_circle *circle;
    double time;
    const double *limit;
    const double *reach; /* of the nodes; NULL where rates tell, or where none is known */
} query;

static double node_radius(const query *q, size_t node)
{
    if (!q->index->scene) return q->index->nodes[node].radius + q->index->nodes[node].growth * q->time;
    return q->reach ? q->reach[node] : INFINITY;
}

static double disc_radius(const query *q, const nearby_disc *disc)
{
    if (!q->index->scene) return disc->radius + disc->growth * q->time;
    const swell_piece piece = swell_at(q->index->scene, disc->index, q->time);
    return swell_radius(&piece, q->time);
}

static int node_near(const query *q, size_t number)
{
    const nearby_node *node = &q->index->nodes[number];
    const motion_circle *circle = q->circle;
    const double dx = fmax(0.0, fmax(node->low.x - circle->center.x, circle->center.x - node->high.x));
    const double dy = fmax(0.0, fmax(node->low.y - circle->center.y, circle->center.y - node->high.y));
    return hypot(dx, dy) - circle->radius - node_radius(q, number) < *q->limit;
}

static void leaf_visit(const query *q, size_t low, size_t high, nearby_visitor visitor, void *ctx)
{
    const nearby_disc *discs = q->index->discs;
    for (size_t i = low; i < high; i++) {
        const double gap = motion_distance(q->circle->center, discs[i].center) - q->circle->radius;
        if (gap - disc_radius(q, &discs[i]) < *q->limit) visitor(ctx, &discs[i]);
    }
}

void nearby_visit(const nearby_index *index, const motion_circle *circle, double time, const double *limit, nearby_visitor visitor,
                  void *ctx)
{
    const query q = {index, circle, time, limit, index->scene ? reach_at(index, time) : NULL};
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
        if (!node_near(&q, node)) continue;
        if (2 * node + 2 >= index->node_count) {
            leaf_visit(&q, low, high, visitor, ctx);
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
