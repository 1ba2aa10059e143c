/* SPDX-License-Identifier: MIT */
/*
 * Asking the spatial index. Every question has a region, tested against nodes from the root down: what lies under a node that does not
 * meet it is never looked at.
 */
#include "scene/index.h"

/* Regions are this much larger than they need be, against rounding. */
#define SLACK (1.0 + 1e-9)
#define SLACK_LENGTH 1e-12
#define SLACK_PLACE 1e-15 /* of the coordinates */

/* A walk over the nodes that meet a region: the stack holds right children still to visit. */
typedef struct index_walk {
    const index_node *nodes;
    uint32_t next;
    int top;
    uint32_t later[INDEX_DEPTH];
} index_walk;

static void walk_start(index_walk *walk, const scene_index *index)
{
    walk->nodes = index->nodes;
    walk->next = index->node_count ? 0 : INDEX_NONE;
    walk->top = 0;
}

/* On from this node: to its children, or where it does not meet the region, or has none, past it. Returns whether it is a leaf that does. */
static inline int walk_on(index_walk *walk, const index_node *node, int meets)
{
    if (meets && !node->count) {
        walk->later[walk->top++] = node->right;
        ++walk->next;
        return 0;
    }
    walk->next = walk->top ? walk->later[--walk->top] : INDEX_NONE;
    return meets;
}

/* What may come near a straight motion: the box around it, and its line. */
typedef struct line_region {
    tdsp_point from;
    tdsp_point heading;
    tdsp_point slope; /* |heading|, by coordinates */
    tdsp_point middle;
    tdsp_point half; /* of the box's sides */
    double late;     /* the true time at which radii are largest, and a little more */
    double moment;   /* the same in the view's time, to the bit */
    double slack;
} line_region;

/* Only the first part of the motion matters. */
static void line_region_cut(line_region *region, double length)
{
    region->middle = point_along(region->from, 0.5 * length, region->heading);
    region->half = point_scale(0.5 * length, region->slope);
}

static line_region region_of_line(const index_view *view, const geom_line *line)
{
    double start = view->sign * line->start, end = view->sign * (line->start + line->length), late = start > end ? start : end;
    line_region region = {.from = line->from, .heading = line->heading, .late = late * SLACK, .moment = view->sign * late};
    region.slope = point_make(fabs(line->heading.x), fabs(line->heading.y));
    region.slack = SLACK_LENGTH + SLACK_PLACE * (fabs(line->from.x) + fabs(line->from.y) + line->length);
    line_region_cut(&region, line->length);
    return region;
}

/* The segment against the node's box, grown by its reach. */
static inline int line_meets_node(const line_region *region, const index_node *node)
{
    double reach = index_node_reach(node, region->late) + region->slack;
    if (fabs(node->middle.x - region->middle.x) > region->half.x + node->half_x + reach) return 0;
    if (fabs(node->middle.y - region->middle.y) > region->half.y + node->half_y + reach) return 0;
    double across = fabs(point_cross(region->heading, point_sub(node->middle, region->from)));
    return across <= reach + region->slope.y * node->half_x + region->slope.x * node->half_y;
}

/* The segment's line against the disc as large as it gets: what does not meet it is not entered. */
static inline int line_meets_disc(const line_region *region, const geom_disc *disc)
{
    double across = fabs(point_cross(region->heading, point_sub(disc->center, region->from)));
    return across <= disc_radius(disc, region->moment) * SLACK + region->slack;
}

/* The next leaf that the segment meets, or NULL. */
static const index_node *line_leaf(index_walk *walk, const line_region *region)
{
    while (walk->next != INDEX_NONE) {
        const index_node *node = &walk->nodes[walk->next];
        if (walk_on(walk, node, line_meets_node(region, node))) return node;
    }
    return NULL;
}

void index_line_visit(const index_view *view, const geom_line *line, uint32_t skip, uint32_t other_skip, index_visit visit,
                      void *ctx)
{
    line_region region = region_of_line(view, line);
    index_walk walk;
    walk_start(&walk, view->index);
    for (const index_node *leaf; (leaf = line_leaf(&walk, &region)) != NULL;) {
        for (uint32_t k = leaf->first; k < leaf->first + leaf->count; ++k) {
            const geom_disc *disc = &view->discs[k];
            if (k == skip || k == other_skip || !line_meets_disc(&region, disc)) continue;
            if (line_blocked(line, disc) && !visit(ctx, k)) return;
        }
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
    line_region region = region_of_line(view, line);
    uint32_t first = INDEX_NONE;
    index_walk walk;
    *length = INFINITY;
    walk_start(&walk, view->index);
    for (const index_node *leaf; (leaf = line_leaf(&walk, &region)) != NULL;) {
        for (uint32_t k = leaf->first; k < leaf->first + leaf->count; ++k) {
            if (k == skip || !line_meets_disc(&region, &view->discs[k])) continue;
            double after = line_first_contact(line, &view->discs[k]);
            if (after >= *length) continue;
            *length = after;
            first = k;
            line_region_cut(&region, after);
        }
    }
    return first;
}

/* What may come within `margin` of a place. */
typedef struct near_region {
    tdsp_point place;
    double margin;
    double late;   /* the true time at which radii are largest */
    double moment; /* the same in the view's time */
} near_region;

/* The next leaf that may come near, or NULL. */
static const index_node *near_leaf(index_walk *walk, const near_region *region)
{
    while (walk->next != INDEX_NONE) {
        const index_node *node = &walk->nodes[walk->next];
        double near = (region->margin + index_node_reach(node, region->late)) * SLACK + SLACK_LENGTH;
        double dx = fabs(region->place.x - node->middle.x) - node->half_x,
               dy = fabs(region->place.y - node->middle.y) - node->half_y;
        int meets = dx <= near && dy <= near && (dx <= 0.0 || dy <= 0.0 || dx * dx + dy * dy <= near * near);
        if (walk_on(walk, node, meets)) return node;
    }
    return NULL;
}

/* A ride stays within half its duration of its middle. */
static near_region region_of_ride(const index_view *view, const geom_ride *ride)
{
    double half = 0.5 * (ride->end - ride->start), start = view->sign * ride->start, end = view->sign * ride->end;
    double late = start > end ? start : end;
    near_region region = {ride_position(ride, ride->start + half), half * SLACK + SLACK_LENGTH, late, view->sign * late};
    return region;
}

/* When the ride enters a disc near it; infinite for one that stays out of its region. */
static inline double region_contact(const near_region *region, const geom_ride *ride, const geom_disc *disc)
{
    double near = region->margin + disc_radius(disc, region->moment);
    tdsp_point offset = point_sub(region->place, disc->center);
    return point_dot(offset, offset) > near * near * SLACK ? INFINITY : ride_contact(ride, disc);
}

double index_ride_contact(const index_view *view, const geom_ride *ride, uint32_t self)
{
    near_region region = region_of_ride(view, ride);
    geom_ride free = *ride; /* as far as is known */
    double first = INFINITY;
    index_walk walk;
    walk_start(&walk, view->index);
    for (const index_node *leaf; (leaf = near_leaf(&walk, &region)) != NULL;) {
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
    for (const index_node *leaf; (leaf = near_leaf(&walk, &region)) != NULL;)
        for (uint32_t k = leaf->first; k < leaf->first + leaf->count; ++k)
            if (k != self && !isinf(region_contact(&region, ride, &view->discs[k])) && !visit(ctx, k)) return;
}

void index_near(const index_view *view, tdsp_point place, double margin, double true_time, index_visit visit, void *ctx)
{
    near_region region = {place, margin, true_time, view->sign * true_time};
    index_walk walk;
    walk_start(&walk, view->index);
    for (const index_node *leaf; (leaf = near_leaf(&walk, &region)) != NULL;)
        for (uint32_t k = leaf->first; k < leaf->first + leaf->count; ++k)
            if (!visit(ctx, k)) return;
}
