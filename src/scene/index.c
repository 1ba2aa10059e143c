/* The spatial index: its invariant is in index.h. */
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

double index_node_distance(const index_node *node, tdsp_point place)
{
    double dx = fmax(fmax(node->min_x - place.x, place.x - node->max_x), 0.0);
    double dy = fmax(fmax(node->min_y - place.y, place.y - node->max_y), 0.0);
    return sqrt(dx * dx + dy * dy);
}

/* A walk over the nodes that may matter: the stack holds right children still to visit. */
typedef struct index_walk {
    const scene_index *index;
    uint32_t next;
    int top;
    uint32_t later[INDEX_DEPTH];
} index_walk;

static void walk_start(index_walk *walk, const scene_index *index)
{
    walk->index = index;
    walk->next = index->node_count ? 0 : INDEX_NONE;
    walk->top = 0;
}

static const index_node *walk_node(const index_walk *walk)
{
    return walk->next == INDEX_NONE ? NULL : &walk->index->nodes[walk->next];
}

static void walk_skip(index_walk *walk)
{
    walk->next = walk->top ? walk->later[--walk->top] : INDEX_NONE;
}

/* Into an inner node's left child; past a leaf. */
static void walk_enter(index_walk *walk)
{
    const index_node *node = &walk->index->nodes[walk->next];
    if (node->count) {
        walk_skip(walk);
        return;
    }
    walk->later[walk->top++] = node->right;
    ++walk->next;
}

/* Can a straight motion meet anything below the node? The segment against the node's box, grown by its reach. */
static int node_meets_line(const index_node *node, const index_view *view, const geom_line *line)
{
    double late = fmax(view->sign * line->start, view->sign * (line->start + line->length));
    double reach = index_node_reach(node, late) * (1.0 + 1e-9) + 1e-12;
    tdsp_point to = point_along(line->from, line->length, line->heading);
    if (fmin(line->from.x, to.x) > node->max_x + reach || fmax(line->from.x, to.x) < node->min_x - reach) return 0;
    if (fmin(line->from.y, to.y) > node->max_y + reach || fmax(line->from.y, to.y) < node->min_y - reach) return 0;
    tdsp_point middle = point_make(0.5 * (node->min_x + node->max_x), 0.5 * (node->min_y + node->max_y));
    double across = fabs(point_cross(line->heading, point_sub(middle, line->from)));
    double half_x = 0.5 * (node->max_x - node->min_x), half_y = 0.5 * (node->max_y - node->min_y);
    return across <= reach + fabs(line->heading.y) * half_x + fabs(line->heading.x) * half_y;
}

void index_line_visit(const index_view *view, const geom_line *line, uint32_t skip, uint32_t other_skip, index_visit visit, void *ctx)
{
    index_walk walk;
    walk_start(&walk, view->index);
    for (const index_node *node; (node = walk_node(&walk)) != NULL;) {
        if (!node_meets_line(node, view, line)) {
            walk_skip(&walk);
            continue;
        }
        for (uint32_t k = node->first; k < node->first + node->count; ++k)
            if (k != skip && k != other_skip && line_blocked(line, &view->discs[k]) && !visit(ctx, k)) return;
        walk_enter(&walk);
    }
}

static int visit_blocked(void *ctx, uint32_t disc)
{
    (void)disc;
    *(int *)ctx = 1;
    return 0;
}

int index_line_blocked(const index_view *view, const geom_line *line, uint32_t skip, uint32_t other_skip)
{
    int blocked = 0;
    index_line_visit(view, line, skip, other_skip, visit_blocked, &blocked);
    return blocked;
}

uint32_t index_line_first(const index_view *view, const geom_line *line, uint32_t skip, double *length)
{
    uint32_t first = INDEX_NONE;
    index_walk walk;
    *length = INFINITY;
    walk_start(&walk, view->index);
    for (const index_node *node; (node = walk_node(&walk)) != NULL;) {
        if (!node_meets_line(node, view, line)) {
            walk_skip(&walk);
            continue;
        }
        for (uint32_t k = node->first; k < node->first + node->count; ++k) {
            double after = k == skip ? INFINITY : line_first_contact(line, &view->discs[k]);
            if (after < *length) {
                *length = after;
                first = k;
            }
        }
        walk_enter(&walk);
    }
    return first;
}

/* A ride stays within half its duration of its middle. */
typedef struct ride_reach {
    tdsp_point middle;
    double margin;
    double late; /* the true time at which radii are largest */
} ride_reach;

static ride_reach reach_of_ride(const index_view *view, const geom_ride *ride)
{
    double half = 0.5 * (ride->end - ride->start);
    ride_reach reach = {ride_position(ride, ride->start + half), half * (1.0 + 1e-9) + 1e-12,
                        fmax(view->sign * ride->start, view->sign * ride->end)};
    return reach;
}

static int reach_meets_disc(const ride_reach *reach, const geom_ride *ride, const geom_disc *disc)
{
    double radius = fmax(disc_radius(disc, ride->start), disc_radius(disc, ride->end));
    return point_distance(reach->middle, disc->center) <= reach->margin + radius;
}

double index_ride_contact(const index_view *view, const geom_ride *ride, uint32_t self)
{
    geom_ride part = *ride;
    ride_reach reach = reach_of_ride(view, ride);
    double first = INFINITY;
    index_walk walk;
    walk_start(&walk, view->index);
    for (const index_node *node; (node = walk_node(&walk)) != NULL;) {
        if (index_node_distance(node, reach.middle) > reach.margin + index_node_reach(node, reach.late)) {
            walk_skip(&walk);
            continue;
        }
        for (uint32_t k = node->first; k < node->first + node->count; ++k) {
            if (k == self || !reach_meets_disc(&reach, ride, &view->discs[k])) continue;
            double contact = ride_contact(&part, &view->discs[k]);
            if (contact < first) first = part.end = contact;
            if (first <= ride->start) return first;
        }
        walk_enter(&walk);
    }
    return first;
}

void index_ride_visit(const index_view *view, const geom_ride *ride, uint32_t self, index_visit visit, void *ctx)
{
    ride_reach reach = reach_of_ride(view, ride);
    index_walk walk;
    walk_start(&walk, view->index);
    for (const index_node *node; (node = walk_node(&walk)) != NULL;) {
        if (index_node_distance(node, reach.middle) > reach.margin + index_node_reach(node, reach.late)) {
            walk_skip(&walk);
            continue;
        }
        for (uint32_t k = node->first; k < node->first + node->count; ++k) {
            const geom_disc *other = &view->discs[k];
            if (k == self || !reach_meets_disc(&reach, ride, other)) continue;
            if (!isinf(ride_contact(ride, other)) && !visit(ctx, k)) return;
        }
        walk_enter(&walk);
    }
}

void index_near(const index_view *view, tdsp_point place, double margin, double true_time, index_visit visit, void *ctx)
{
    index_walk walk;
    walk_start(&walk, view->index);
    for (const index_node *node; (node = walk_node(&walk)) != NULL;) {
        if (index_node_distance(node, place) > margin + index_node_reach(node, true_time)) {
            walk_skip(&walk);
            continue;
        }
        for (uint32_t k = node->first; k < node->first + node->count; ++k)
            if (!visit(ctx, k)) return;
        walk_enter(&walk);
    }
}
