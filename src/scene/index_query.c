/*
 * Asking the spatial index. Every question has a region, tested against nodes from the root down: what lies under a node that does not
 * meet it is never looked at.
 */
#include "scene/index.h"

/* Regions are this much larger than they need be, against rounding. */
#define SLACK (1.0 + 1e-9)
#define SLACK_LENGTH 1e-12

double index_node_distance(const index_node *node, tdsp_point place)
{
    double dx = fmax(fmax(node->min_x - place.x, place.x - node->max_x), 0.0);
    double dy = fmax(fmax(node->min_y - place.y, place.y - node->max_y), 0.0);
    return sqrt(dx * dx + dy * dy);
}

typedef int (*region_meets)(const void *region, const index_node *node);

/* A walk over the leaves that meet a region: the stack holds right children still to visit. */
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

/* The next leaf, or NULL. */
static inline const index_node *walk_leaf(index_walk *walk, region_meets meets, const void *region)
{
    while (walk->next != INDEX_NONE) {
        const index_node *node = &walk->index->nodes[walk->next];
        int met = meets(region, node);
        if (met && !node->count) {
            walk->later[walk->top++] = node->right;
            ++walk->next;
            continue;
        }
        walk->next = walk->top ? walk->later[--walk->top] : INDEX_NONE;
        if (met) return node;
    }
    return NULL;
}

/* What may come near a straight motion. */
typedef struct line_region {
    tdsp_point from;
    tdsp_point heading;
    double min_x, min_y, max_x, max_y;
    double late; /* the true time at which radii are largest */
} line_region;

static line_region region_of_line(const index_view *view, const geom_line *line)
{
    tdsp_point from = line->from, to = point_along(line->from, line->length, line->heading);
    line_region region = {from, line->heading, fmin(from.x, to.x), fmin(from.y, to.y), fmax(from.x, to.x), fmax(from.y, to.y),
                          fmax(view->sign * line->start, view->sign * (line->start + line->length))};
    return region;
}

/* The segment against the node's box, grown by its reach. */
static int line_region_meets(const void *ctx, const index_node *node)
{
    const line_region *region = ctx;
    double reach = index_node_reach(node, region->late) * SLACK + SLACK_LENGTH;
    if (region->min_x > node->max_x + reach || region->max_x < node->min_x - reach) return 0;
    if (region->min_y > node->max_y + reach || region->max_y < node->min_y - reach) return 0;
    double across = fabs(point_cross(region->heading, point_sub(node->middle, region->from)));
    double half_x = 0.5 * (node->max_x - node->min_x), half_y = 0.5 * (node->max_y - node->min_y);
    return across <= reach + fabs(region->heading.y) * half_x + fabs(region->heading.x) * half_y;
}

void index_line_visit(const index_view *view, const geom_line *line, uint32_t skip, uint32_t other_skip, index_visit visit, void *ctx)
{
    line_region region = region_of_line(view, line);
    index_walk walk;
    walk_start(&walk, view->index);
    for (const index_node *leaf; (leaf = walk_leaf(&walk, line_region_meets, &region)) != NULL;)
        for (uint32_t k = leaf->first; k < leaf->first + leaf->count; ++k)
            if (k != skip && k != other_skip && line_blocked(line, &view->discs[k]) && !visit(ctx, k)) return;
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
    line_region region = region_of_line(view, line);
    uint32_t first = INDEX_NONE;
    index_walk walk;
    *length = INFINITY;
    walk_start(&walk, view->index);
    for (const index_node *leaf; (leaf = walk_leaf(&walk, line_region_meets, &region)) != NULL;) {
        for (uint32_t k = leaf->first; k < leaf->first + leaf->count; ++k) {
            double after = k == skip ? INFINITY : line_first_contact(line, &view->discs[k]);
            if (after >= *length) continue;
            *length = after;
            first = k;
        }
    }
    return first;
}

/* What may come within `margin` of a place. */
typedef struct near_region {
    tdsp_point place;
    double margin;
    double late; /* the true time at which radii are largest */
} near_region;

static int near_region_meets(const void *ctx, const index_node *node)
{
    const near_region *region = ctx;
    return index_node_distance(node, region->place) <= region->margin + index_node_reach(node, region->late);
}

/* A ride stays within half its duration of its middle. */
static near_region region_of_ride(const index_view *view, const geom_ride *ride)
{
    double half = 0.5 * (ride->end - ride->start);
    near_region region = {ride_position(ride, ride->start + half), half * SLACK + SLACK_LENGTH,
                          fmax(view->sign * ride->start, view->sign * ride->end)};
    return region;
}

/* When the ride enters a disc near it; infinite for one that stays out of its region. */
static double region_contact(const near_region *region, const geom_ride *ride, const geom_disc *disc)
{
    double radius = fmax(disc_radius(disc, ride->start), disc_radius(disc, ride->end));
    if (point_distance(region->place, disc->center) > region->margin + radius) return INFINITY;
    return ride_contact(ride, disc);
}

double index_ride_contact(const index_view *view, const geom_ride *ride, uint32_t self)
{
    near_region region = region_of_ride(view, ride);
    geom_ride free = *ride; /* as far as is known */
    double first = INFINITY;
    index_walk walk;
    walk_start(&walk, view->index);
    for (const index_node *leaf; (leaf = walk_leaf(&walk, near_region_meets, &region)) != NULL;) {
        for (uint32_t k = leaf->first; k < leaf->first + leaf->count; ++k) {
            double contact = k == self ? INFINITY : region_contact(&region, &free, &view->discs[k]);
            if (contact < first) first = free.end = contact;
            if (first <= ride->start) return first;
        }
    }
    return first;
}

void index_ride_visit(const index_view *view, const geom_ride *ride, uint32_t self, index_visit visit, void *ctx)
{
    near_region region = region_of_ride(view, ride);
    index_walk walk;
    walk_start(&walk, view->index);
    for (const index_node *leaf; (leaf = walk_leaf(&walk, near_region_meets, &region)) != NULL;)
        for (uint32_t k = leaf->first; k < leaf->first + leaf->count; ++k)
            if (k != self && !isinf(region_contact(&region, ride, &view->discs[k])) && !visit(ctx, k)) return;
}

void index_near(const index_view *view, tdsp_point place, double margin, double true_time, index_visit visit, void *ctx)
{
    near_region region = {place, margin, true_time};
    index_walk walk;
    walk_start(&walk, view->index);
    for (const index_node *leaf; (leaf = walk_leaf(&walk, near_region_meets, &region)) != NULL;)
        for (uint32_t k = leaf->first; k < leaf->first + leaf->count; ++k)
            if (!visit(ctx, k)) return;
}
