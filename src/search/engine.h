/* SPDX-License-Identifier: MIT */
/*
 * The disc engine: label setting on moving Steiner points, forwards or backwards in time.
 *
 * A label is either a straight leg that would arrive at a disc (or the goal) at its time, not yet tested against the other
 * discs, or a ride that has been followed up to its time and may go on. Taking a leg tests it and starts a ride; taking a ride follows it
 * by one chunk, records what it swept, and pushes every leg that leaves the chunk.
 *
 * Dominance: who passes a place on a boundary earlier can do whatever a later one can, moved earlier. So a leg that arrives where a ride was before is
 * dropped, and a ride ends where another rode before it (sweep.h).
 */
#ifndef SEARCH_ENGINE_H
#define SEARCH_ENGINE_H

#include "scene/scene.h"
#include "search/goals.h"
#include "search/neighbours.h"
#include "search/search.h"

#define ENGINE_NONE 0xffffffffu
#define ENGINE_GOAL 0xfffffffeu /* the disc index of a leg to the goal */

/* Scenes of so few discs are searched whole, before relaxation or a scout would be back. */
#define ENGINE_SMALL 64u

/* A boundary smaller than this is no place to ride: nobody has to go round it. */
#define ENGINE_LEAST_RIDE 1e-15

/* Which way time runs. */
typedef enum engine_direction { ENGINE_FORWARD = 1, ENGINE_REVERSE = -1 } engine_direction;

/* A straight leg from a ride (or the start) to a disc (or the goal). */
typedef struct engine_leg {
    uint32_t ride; /* ENGINE_NONE: from the start */
    uint32_t disc;
    int side;      /* of the ride it begins */
    uint32_t goal; /* to a goal: which of several */
    double leave;  /* time */
    double normal; /* angle of the leave point on the ride's disc */
    double heading;
    double length;
    double bound; /* distance from its arrival to the goal */
} engine_leg;

/* A ride: followed over [start, now]. */
typedef struct engine_ride {
    uint32_t disc;
    int side;
    uint32_t leg;  /* how it began; ENGINE_NONE: a seed */
    uint32_t next; /* the next ride on the same disc */
    double normal; /* angle at the start */
    double start;
    double now;
    double bound; /* distance from its place at `now` to the goal */
} engine_ride;

/* A ride to begin with: a place on a boundary. */
typedef struct engine_seed {
    uint32_t disc;
    int side;
    double normal;
} engine_seed;

/* What is asked: from `start` at `time`, or from the seeds where there are any. */
typedef struct engine_question {
    engine_direction direction;
    tdsp_point start;
    tdsp_point goal;
    double time;       /* in the direction's own time: reversed times are negative */
    double goal_opens; /* the goal counts only from this time on ... */
    double goal_until; /* ... and not after this */
    double limit;      /* nothing later than this matters */
    double weight;     /* of the bounds: 1 asks for the best path, more for a path at most so much longer, found sooner */
    uint64_t patience; /* give up after so many chunks of rides; 0: never */
    int explain;       /* find out whether only the goal's cover stops the robot */
    const engine_seed *seeds;
    int seed_count;
} engine_question;

typedef struct disc_engine {
    const tdsp_scene *scene;
    const disc_set *set; /* of the run; a part of the scene's discs at most */
    tdsp_search *open;
    engine_question question;
    index_view view;
    geom_disc goal; /* as a point */
    goal_set several;
    double rate_max; /* of the set's discs, or a little more */
    double limit;
    neighbourhood *around;         /* of the run's set: one of the next two */
    neighbourhood around_all;      /* kept from run to run */
    neighbourhood around_part;
    label_heap looks; /* what a chunk has still to look at */
    engine_leg *legs;
    size_t leg_count, leg_capacity;
    engine_ride *rides;
    size_t ride_count, ride_capacity;
    uint32_t *heads;  /* first ride on a disc */
    uint32_t *stamps; /* the run in which a head was set */
    uint32_t stamp;
    uint32_t arrived; /* the leg that reached the goal, or ENGINE_NONE */
    int gave_up;
    uint64_t part_patience; /* of questions to a part of the scene's discs */
    uint64_t patience;      /* of the run */
    uint64_t runs;            /* so far */
    uint64_t chunks;          /* of rides followed in the run */
    uint64_t chunks_followed; /* ... and in all runs */
    uint64_t legs_tested;
} disc_engine;

tdsp_status engine_create(disc_engine *engine, const tdsp_scene *scene);
void engine_free(disc_engine *engine);
uint64_t engine_bytes(const disc_engine *engine);

/*
 * Search among the discs of a set, whose indices the question's seeds and all labels use. Afterwards `arrived` names the last leg of
 * the path, or is ENGINE_NONE. A question that asks to explain arrives with a leg that only the goal's cover stopped. Among a part of the scene's discs
 * a question that does not say how patient it is has `part_patience`, and the answer is TDSP_NO_ANSWER when it gave up.
 */
tdsp_status engine_run(disc_engine *engine, const disc_set *set, const engine_question *question);

/*
 * The same for several goals, each with the answer that it would have alone. Bounds are those to a circle around all of them. The question's own goal
 * and its times are not looked at.
 */
tdsp_status engine_run_many(disc_engine *engine, const disc_set *set, const engine_question *question, engine_goal *goals, uint32_t count);

/* After how many chunks a search that only means to find some path across all discs should give up. */
uint64_t engine_patience(const disc_engine *engine);

/*
 * Send scouts ahead: searches among all discs with heavier bounds and little patience. If they find a path the question's limit becomes its arrival, which keeps the
 * search for the best path from looking where it cannot be. *lost is 1 when they found none.
 */
tdsp_status engine_scout(disc_engine *engine, engine_question *question, int *lost);

/* No path arrives earlier than this, after a run that arrived. */
double engine_lower_bound(const disc_engine *engine);

/* The time at which the path found reaches the goal. */
double engine_arrival(const disc_engine *engine);

/* Internal to the engine's files. */

static inline double leg_arrival(const engine_leg *leg)
{
    return leg->leave + leg->length;
}

/* The disc that a ride is on. */
static inline const geom_disc *engine_disc(const disc_engine *engine, uint32_t disc)
{
    return &engine->view.discs[disc];
}

/* The true time of a moment in the run's direction. */
static inline double engine_true_time(const disc_engine *engine, double time)
{
    return engine->view.sign * time;
}

/* No goal is reached from a place in less time. */
static inline double engine_bound(const disc_engine *engine, tdsp_point place)
{
    double bound = point_distance(place, engine->question.goal) - engine->several.spread;
    return bound > 0.0 ? bound : 0.0;
}

/* The leg's motion. */
geom_line engine_leg_motion(const disc_engine *engine, const engine_leg *leg);

/* The disc that a leg leaves; INDEX_NONE for the start. */
uint32_t engine_leg_origin(const disc_engine *engine, const engine_leg *leg);

/* The ride's motion from `from` to `to`. */
geom_ride engine_ride_motion(const disc_engine *engine, const engine_ride *ride, double from, double to);

/* Add a leg and its label, unless it is too late, or ends at the goal and is blocked. Sets *done when that explains everything. */
tdsp_status engine_push_leg(disc_engine *engine, const engine_leg *leg, int *done);

/* Add a leg to the goal that ends the search. */
tdsp_status engine_arrive(disc_engine *engine, const engine_leg *leg, int *done);

/* Follow a ride by one chunk. */
tdsp_status ride_follow(disc_engine *engine, uint32_t ride, int *done);

/* Push the legs that leave a ride over [from, to]. */
tdsp_status leaves_push(disc_engine *engine, uint32_t ride, double from, double to, int *done);

/* Push the legs that leave the start. */
tdsp_status leaves_push_start(disc_engine *engine, int *done);

#endif
