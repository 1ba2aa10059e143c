/* SPDX-License-Identifier: MIT */
/*
 * The ends of a journey among a scene's discs, and when they are covered.
 *
 * No disc below a node of the index covers a place before it has grown as far as the node's box is away. So the index is walked nearer side first,
 * and what cannot be earlier than the cover known so far is left alone. Discs that the index leaves out are enclosed by others for good: they
 * cover nothing first.
 */
#include "scene/scene.h"

/* Bounds are this much looser than they need be, against the rounding of the frame's coordinates. */
#define SLACK 1e-9
#define SLACK_LENGTH 1e-12

/* No end is farther from the middle of the scene's own journey, in the frame. */
#define FARTHEST 1048576.0 /* 2^20 */

/* The last moment at which a disc does not cover a place, negative where it always does. */
static double disc_free_until(const tdsp_disc *disc, double robot_radius, tdsp_point place)
{
    double gap = math_hypot(place.x - disc->center.x, place.y - disc->center.y) - (disc->radius + robot_radius);
    if (disc->growth > 0.0) return gap / disc->growth;
    return gap < 0.0 ? -1.0 : INFINITY;
}

/* Does it certainly not cover the place before this time? Without hypot(), for the many that are far away. */
static int disc_is_late(const tdsp_disc *disc, double robot_radius, tdsp_point place, double time)
{
    double reach = disc->radius + robot_radius + (disc->growth > 0.0 ? disc->growth * time : 0.0);
    tdsp_point offset = point_sub(place, disc->center);
    return point_dot(offset, offset) > reach * reach * (1.0 + SLACK);
}

/* Before this time, in the user's units, no disc below the node covers the place. */
static double node_free_until(const tdsp_scene *scene, const index_node *node, tdsp_point place)
{
    double away = index_node_distance(node, place) - SLACK_LENGTH * (1.0 + fabs(place.x) + fabs(place.y));
    if (away <= 0.0) return -INFINITY;
    return node->rate > 0.0f ? away / node->rate * (1.0 - SLACK) * scene->time : INFINITY;
}

static void cover_by_leaf(const tdsp_scene *scene, const index_node *leaf, tdsp_point place, scene_cover *cover)
{
    for (uint32_t k = leaf->first; k < leaf->first + leaf->count; ++k) {
        uint32_t given = scene->all.origin[k];
        const tdsp_disc *disc = &scene->discs[given];
        if (disc_is_late(disc, scene->journey.radius, place, cover->time)) continue;
        double until = disc_free_until(disc, scene->journey.radius, place);
        if (until == INFINITY || until > cover->time || (until == cover->time && given >= cover->disc)) continue;
        cover->time = until;
        cover->disc = given;
    }
}

typedef struct cover_look {
    uint32_t node;
    double from; /* the bound on its covers */
} cover_look;

scene_cover scene_cover_of(const tdsp_scene *scene, tdsp_point place)
{
    const tdsp_point framed = scene_frame_point(scene, place);
    const index_node *nodes = scene->all.index.nodes;
    scene_cover cover = {INFINITY, TDSP_NO_DISC};
    cover_look later[INDEX_DEPTH];
    int top = 0;
    if (scene->pieces) return scene_law_cover(scene, place);
    if (scene->all.count > 0) later[top++] = (cover_look){0, -INFINITY};
    while (top > 0) {
        cover_look look = later[--top];
        const index_node *node = &nodes[look.node];
        if (look.from >= cover.time) continue;
        if (node->count) {
            cover_by_leaf(scene, node, place, &cover);
            continue;
        }
        cover_look left = {look.node + 1, node_free_until(scene, &nodes[look.node + 1], framed)};
        cover_look right = {node->right, node_free_until(scene, &nodes[node->right], framed)};
        later[top++] = left.from < right.from ? right : left;
        later[top++] = left.from < right.from ? left : right;
    }
    return cover;
}

double tdsp_scene_free_until(const tdsp_scene *scene, tdsp_point place, uint32_t *disc)
{
    scene_cover cover = scene_cover_of(scene, place);
    if (disc) *disc = cover.disc;
    return cover.time;
}

static double farthest_coordinate(tdsp_point a, tdsp_point b)
{
    return math_max(math_max(fabs(a.x), fabs(a.y)), math_max(fabs(b.x), fabs(b.y)));
}

tdsp_status scene_ends_make(const tdsp_scene *scene, const tdsp_ends *given, scene_ends *out)
{
    tdsp_journey journey = scene->journey;
    journey.source = given->source;
    journey.destination = given->destination;
    if (tdsp_journey_check(&journey)) return TDSP_INVALID_ARGUMENT;
    scene_ends ends = {*given, scene_frame_point(scene, given->source), scene_frame_point(scene, given->destination),
                       {0.0, 0}, {0.0, 0}, 0.0};
    double farthest = farthest_coordinate(ends.source, ends.destination);
    if (!(farthest <= FARTHEST)) return TDSP_NOT_SUPPORTED;
    ends.time = scene->time * math_max(1.0, farthest);
    ends.source_cover = scene_cover_of(scene, given->source);
    ends.destination_cover = scene_cover_of(scene, given->destination);
    *out = ends;
    return TDSP_OK;
}
