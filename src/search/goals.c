/* SPDX-License-Identifier: MIT */
/* Several goals that share one search: what they hold is in goals.h. */
#include "search/goals.h"

/* The circle around the goals is this share larger than it need be, against rounding. */
#define SLACK 1e-12

static void goals_enclose(goal_set *self)
{
    tdsp_point low = self->goals[0].place, high = low;
    for (uint32_t k = 1; k < self->count; ++k) {
        tdsp_point place = self->goals[k].place;
        low = point_make(math_min(low.x, place.x), math_min(low.y, place.y));
        high = point_make(math_max(high.x, place.x), math_max(high.y, place.y));
    }
    self->middle = point_scale(0.5, point_add(low, high));
    self->spread = 0.0;
    for (uint32_t k = 0; k < self->count; ++k) self->spread = math_max(self->spread, point_distance(self->middle, self->goals[k].place));
    self->spread *= 1.0 + SLACK;
}

static double goal_latest(const engine_goal *goal)
{
    return goal->is_settled ? -INFINITY : math_min(goal->best, goal->until);
}

/* A node's children come after it. */
static void goals_update(goal_set *self)
{
    const scene_index *index = &self->points.index;
    for (uint32_t k = index->node_count; k-- > 0;) {
        const index_node *node = &index->nodes[k];
        double latest = node->count ? -INFINITY : math_max(self->latest[k + 1], self->latest[node->right]);
        for (uint32_t i = node->first; i < node->first + node->count; ++i)
            latest = math_max(latest, goal_latest(&self->goals[self->points.origin[i]]));
        self->latest[k] = latest;
    }
}

tdsp_status goals_begin(goal_set *self, const tdsp_allocator *allocator, engine_goal *goals, uint32_t count)
{
    self->goals = goals;
    self->count = self->open = count;
    tdsp_status status = set_reserve(&self->points, allocator, count);
    if (status != TDSP_OK) return status;
    self->points.count = count;
    for (uint32_t k = 0; k < count; ++k) {
        self->points.forward[k] = disc_point(goals[k].place);
        self->points.origin[k] = k;
        goals[k].best = INFINITY;
        goals[k].leg = GOALS_NONE;
        goals[k].is_settled = 0;
    }
    goals_enclose(self);
    status = set_prepare(&self->points, allocator);
    if (status != TDSP_OK) return status;
    status = memory_reserve(allocator, (void **)&self->latest, &self->latest_capacity, self->points.index.node_count, sizeof *self->latest);
    if (status == TDSP_OK) goals_update(self);
    return status;
}

void goals_forget(goal_set *self)
{
    self->goals = NULL;
    self->count = self->open = 0;
    self->spread = 0.0;
}

void goals_free(goal_set *self, const tdsp_allocator *allocator)
{
    set_free(&self->points, allocator);
    memory_free(allocator, self->latest, self->latest_capacity * sizeof *self->latest);
}

void goals_reach(goal_set *self, uint32_t goal, double time, uint32_t leg)
{
    self->goals[goal].best = time;
    self->goals[goal].leg = leg;
    goals_update(self);
}

void goals_settle(goal_set *self, uint32_t goal)
{
    self->goals[goal].is_settled = 1;
    --self->open;
    goals_update(self);
}

double goals_latest(const goal_set *self)
{
    return self->latest[0];
}
