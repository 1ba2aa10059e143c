/* SPDX-License-Identifier: MIT */
/*
 * The engine for discs whose rates change: label setting, forwards or backwards in time, by the same moves as the disc engine for constant rates
 * (src/search/engine.h) and with nothing in closed form but what the laws allow.
 *
 * A label is a straight leg that would arrive at a disc or the goal at its time, not yet tested against the discs, or a ride followed up to its time. Taking a
 * leg tests it and starts a ride; taking a ride follows it by one chunk and pushes every leg that leaves the chunk. A leg is pushed for each root of one
 * equation (leave.h), each isolated by a sign. Places that another rider passed earlier are dropped (wake.h).
 */
#ifndef GROWTH_ENGINE_H
#define GROWTH_ENGINE_H

#include "growth/reach.h"
#include "tdsp/search.h"

#define GROWTH_NONE 0xffffffffu
#define GROWTH_GOAL 0xfffffffeu

/* A moment on a run: a time on a span, or, where the rate falls at the span's end, an angle between heading and normal in the fan there. */
typedef struct growth_moment {
    uint32_t span;
    int in_fan;
    double time;
    double theta; /* of the fan */
} growth_moment;

/* A straight leg from a ride (or the start) to a disc (or the goal). */
typedef struct growth_leg {
    uint32_t ride; /* GROWTH_NONE: from the start */
    growth_moment leave;
    sight_line line;
    double arrive;
    uint32_t disc; /* where it arrives; GROWTH_GOAL */
    uint32_t run;  /* of that disc's */
    int side;      /* of the ride it begins */
    growth_moment land;
    double bound; /* distance from its arrival to the goal */
} growth_leg;

/* A ride: followed from `start` to `now`. */
typedef struct growth_ride {
    uint32_t disc;
    uint32_t run;
    int side;
    uint32_t leg;  /* how it began */
    uint32_t next; /* the next ride on the same disc */
    growth_moment start, now;
    double normal; /* angle at the start */
    double bound;
    int is_over;
} growth_ride;

/* A disc that legs of a chunk may meet (ahead.h). */
typedef struct growth_ahead {
    uint32_t place;   /* in the reach */
    double distance;  /* of its centre from where the chunk starts */
    double nearest;   /* no leg to it is shorter */
    double direction; /* of its centre, from the middle heading, */
    double window;    /* and how far to either side headings may be that meet it */
} growth_ahead;

typedef struct growth_question {
    double sign; /* of time: 1 forwards, -1 backwards */
    tdsp_point start, goal;
    double time;       /* in the direction of travel */
    double goal_until; /* the goal counts up to this time */
    double limit;      /* nothing later than this matters */
    double weight;     /* of the bounds: 1 finds the best path, more some path sooner */
    int explain;       /* ends as soon as a robot on its way to the goal is stopped by a disc that covers it by then */
} growth_question;

typedef struct growth_engine {
    tdsp_allocator allocator;
    growth_shape *shapes;
    uint32_t shape_count;
    uint32_t *members; /* the shapes of the run */
    uint32_t member_count;
    growth_reach reach; /* of the members */
    tdsp_search *open;
    growth_question question;
    double limit;
    growth_leg *legs;
    size_t leg_count, leg_capacity;
    growth_ride *rides;
    size_t ride_count, ride_capacity;
    growth_ahead *ahead;
    size_t ahead_count, ahead_capacity;
    uint32_t *heads;  /* the first ride on a disc, or GROWTH_NONE */
    uint32_t arrived; /* the leg that reached the goal, or GROWTH_NONE */
    int is_explained;
    double latest;    /* no disc was looked at after this */
    uint64_t labels, legs_tested; /* so far */
} growth_engine;

/* Search among the engine's members. TDSP_OK, whether it arrived or not, or TDSP_NO_MEMORY. */
tdsp_status growth_run(growth_engine *engine, const growth_question *question);

static inline const growth_shape *engine_shape(const growth_engine *engine, uint32_t disc)
{
    return &engine->shapes[disc];
}

/* Add a leg and its label, unless it is too late. Legs to the goal are tested here. */
tdsp_status growth_push_leg(growth_engine *engine, const growth_leg *leg);

/* Is the leg's motion stopped by one of the members? *hit: by which, and when. */
typedef struct growth_hit {
    uint32_t disc;
    double time;
} growth_hit;

int growth_leg_is_blocked(growth_engine *engine, const growth_leg *leg, growth_hit *hit);

/* A straight motion that touches no disc at its ends. */
int growth_line_is_blocked(growth_engine *engine, const sight_line *line, double end, uint32_t except);

#endif
