/* SPDX-License-Identifier: MIT */
/* See nearby.h for the invariant. */
#include "verify/nearby.h"

#include "base/math.h"
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
            while (center_along(&discs[i], axis) < pivot) i++;
            while (center_along(&discs[j], axis) > pivot) j--;
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

static nearby_node node_over(const nearby_disc *discs, size_t low, size_t high, double *radius)
{
    nearby_node node = {discs[low].center, discs[low].center, 0.0};
    *radius = 0.0;
    for (size_t i = low; i < high; i++) {
        node.low.x = math_min(node.low.x, discs[i].center.x);
        node.low.y = math_min(node.low.y, discs[i].center.y);
        node.high.x = math_max(node.high.x, discs[i].center.x);
        node.high.y = math_max(node.high.y, discs[i].center.y);
        *radius = math_max(*radius, discs[i].radius);
        node.growth = math_max(node.growth, discs[i].growth);
    }
    return node;
}

static void tree_build(nearby_index *index, size_t node, size_t low, size_t high)
{
    index->nodes[node] = node_over(index->discs, low, high, &index->radii[node]);
    if (2 * node + 2 >= index->node_count) return;
    const nearby_node *over = &index->nodes[node];
    const int axis = over->high.x - over->low.x < over->high.y - over->low.y;
    const size_t middle = low + (high - low) / 2;
    discs_halve(index->discs, low, high, middle, axis);
    tree_build(index, 2 * node + 1, low, middle);
    tree_build(index, 2 * node + 2, middle, high);
}

/* Fill in the largest radii below a node at a time; the tree is built. */
static double radii_of(nearby_index *index, double *radii, double time, size_t node, size_t low, size_t high)
{
    double largest = 0.0;
    if (2 * node + 2 >= index->node_count) {
        for (size_t i = low; i < high; i++) {
            const swell_piece piece = swell_at(index->scene, index->discs[i].index, time);
            largest = math_max(largest, swell_radius(&piece, time));
        }
    } else {
        const size_t middle = low + (high - low) / 2;
        largest = radii_of(index, radii, time, 2 * node + 1, low, middle);
        largest = math_max(largest, radii_of(index, radii, time, 2 * node + 2, middle, high));
    }
    radii[node] = largest;
    return largest;
}

static double step_time(const nearby_index *index, size_t step)
{
    return step + 1 < index->steps ? index->until / (double)index->steps * (double)(step + 1) : index->until;
}

static void radii_build(nearby_index *index)
{
    for (size_t step = 0; step < index->steps; step++)
        radii_of(index, index->radii + step * index->node_count, step_time(index, step), 0, 0, index->count);
    for (size_t node = 0; node < index->node_count; node++) index->nodes[node].growth = 0.0;
}

/* At the first step that is not before `time`, or the last. */
static const double *radii_at(const nearby_index *index, double time)
{
    size_t step = 0;
    while (step + 1 < index->steps && step_time(index, step) < time) step++;
    return index->radii + step * index->node_count;
}

static void discs_inflate(const tdsp_scene *scene, nearby_disc *out)
{
    size_t count;
    const tdsp_disc *discs = tdsp_scene_discs(scene, &count);
    const double robot = tdsp_scene_journey(scene)->radius;
    for (size_t i = 0; i < count; i++)
        out[i] = (nearby_disc){discs[i].center, discs[i].radius + robot, discs[i].growth, (uint32_t)i};
}

static tdsp_status memory_take(nearby_index *index)
{
    size_t leaves = 1;
    while (index->count / leaves > LEAF_DISCS) leaves *= 2;
    index->node_count = 2 * leaves - 1;
    index->discs = memory_array(&index->allocator, index->count, sizeof *index->discs);
    index->nodes = memory_array(&index->allocator, index->node_count, sizeof *index->nodes);
    index->radii = memory_array(&index->allocator, index->steps * index->node_count, sizeof *index->radii);
    return index->discs && index->nodes && index->radii ? TDSP_OK : TDSP_NO_MEMORY;
}

tdsp_status nearby_build(const tdsp_scene *scene, double until, const tdsp_allocator *allocator, nearby_index *out)
{
    const int rates = tdsp_scene_has_rates_only(scene);
    nearby_index index = {
        .allocator = *allocator, .scene = rates ? NULL : scene, .steps = rates ? 1 : NEARBY_STEPS, .until = until};
    tdsp_scene_discs(scene, &index.count);
    if (index.count > 0) {
        if (memory_take(&index) != TDSP_OK) {
            nearby_free(&index);
            return TDSP_NO_MEMORY;
        }
        discs_inflate(scene, index.discs);
        tree_build(&index, 0, 0, index.count);
        if (!rates) radii_build(&index);
    }
    *out = index;
    return TDSP_OK;
}

void nearby_free(nearby_index *index)
{
    memory_free(&index->allocator, index->discs, index->count * sizeof *index->discs);
    memory_free(&index->allocator, index->nodes, index->node_count * sizeof *index->nodes);
    memory_free(&index->allocator, index->radii, index->steps * index->node_count * sizeof *index->radii);
}

/* Where rates change no node has a growth, and its radius is that of a later time. */
static int node_near(const nearby_node *node, double radius, const motion_circle *circle, double time, double limit)
{
    const double dx = math_max(0.0, math_max(node->low.x - circle->center.x, circle->center.x - node->high.x));
    const double dy = math_max(0.0, math_max(node->low.y - circle->center.y, circle->center.y - node->high.y));
    return math_hypot(dx, dy) - circle->radius - radius - node->growth * time < limit;
}

/* What is looked for. */
typedef struct query {
    const motion_circle *circle;
    double time;
    const double *limit;
    nearby_visitor visitor;
    void *ctx;
} query;

static void growing_visit(const query *q, const nearby_disc *discs, size_t count, const tdsp_scene *scene)
{
    for (size_t i = 0; i < count; i++) {
        const swell_piece piece = swell_at(scene, discs[i].index, q->time);
        const double gap = motion_distance(q->circle->center, discs[i].center) - q->circle->radius;
        if (gap - swell_radius(&piece, q->time) < *q->limit) q->visitor(q->ctx, &discs[i]);
    }
}

static void leaf_visit(const query *q, const nearby_disc *discs, size_t count)
{
    const motion_circle *circle = q->circle;
    for (size_t i = 0; i < count; i++) {
        const double gap = motion_distance(circle->center, discs[i].center) - circle->radius;
        if (gap - discs[i].radius - discs[i].growth * q->time < *q->limit) q->visitor(q->ctx, &discs[i]);
    }
}

static void tree_visit(const nearby_index *index, const query *q, const double *radii)
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
        if (!node_near(&index->nodes[node], radii[node], q->circle, q->time, *q->limit)) continue;
        if (2 * node + 2 >= index->node_count) {
            if (index->scene)
                growing_visit(q, index->discs + low, high - low, index->scene);
            else
                leaf_visit(q, index->discs + low, high - low);
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

void nearby_visit(const nearby_index *index, const motion_circle *circle, double time, const double *limit,
                  nearby_visitor visitor, void *ctx)
{
    const query q = {circle, time, limit, visitor, ctx};
    if (index->scene && time > index->until)
        growing_visit(&q, index->discs, index->count, index->scene);
    else
        tree_visit(index, &q, index->scene ? radii_at(index, time) : index->radii);
}
