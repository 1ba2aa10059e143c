/* SPDX-License-Identifier: MIT */
/*
 * Several goals that share one search.
 *
 * A search in the order of time settles them one after the other, each with the answer that it would have alone. They stand in an index of their own, whose
 * nodes know until when a goal below them can still be reached earlier than it is: what no goal waits for is not looked at.
 */
#ifndef SEARCH_GOALS_H
#define SEARCH_GOALS_H

#include "scene/disc_set.h"

/* One of them. What the asker fills in comes first, what the search finds after it. */
typedef struct engine_goal {
    tdsp_point place;
    double opens;   /* it counts only from this time on ... */
    double until;   /* ... and not after this */
    double best;    /* when it is reached; infinite as long as it is not */
    uint32_t leg;   /* that reaches it, or GOALS_NONE */
    int is_settled; /* nothing earlier is left */
} engine_goal;

#define GOALS_NONE 0xffffffffu

typedef struct goal_set {
    engine_goal *goals; /* the asker's; NULL: there is one goal only, the question's own */
    uint32_t count;
    uint32_t open;     /* not settled */
    tdsp_point middle; /* of a circle around all ... */
    double spread;     /* ... of this radius; 0 for one */
    disc_set points;   /* the places, with an index; origin: the goal */
    double *latest;    /* for each node of the index */
    size_t latest_capacity;
} goal_set;

/* Begin with these goals, at least one. TDSP_OK or TDSP_NO_MEMORY. O(count log count) expected. */
tdsp_status goals_begin(goal_set *self, const tdsp_allocator *allocator, engine_goal *goals, uint32_t count);

/* From now on there is one goal only. */
void goals_forget(goal_set *self);

void goals_free(goal_set *self, const tdsp_allocator *allocator);

/* A goal was reached by a leg, or is settled. O(count). */
void goals_reach(goal_set *self, uint32_t goal, double time, uint32_t leg);
void goals_settle(goal_set *self, uint32_t goal);

/* No goal can be reached earlier than it is after this time. */
double goals_latest(const goal_set *self);

#endif
