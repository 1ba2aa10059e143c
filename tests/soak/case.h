/* SPDX-License-Identifier: MIT */
/*
 * One scene, one departure, one check: what a check asks with, and how it says what is wrong. A check is a function of the case alone, so that it can be
 * put again to a scene that the shrinker made smaller.
 */
#ifndef SOAK_CASE_H
#define SOAK_CASE_H

#include "soak/scene.h"

/*
 * Two answers are the same when they differ by no more than SOAK_SAME of the travel time and the journey's own: ten times TDSP_SOLVER_ERROR, for each
 * is granted that once, and a copy of the scene in other coordinates is rounded itself.
 *
 * Where they differ by more, a touch may have been decided otherwise: what is no deeper than 1e-12 of distance and radius counts as none
 * (src/geom/tolerance.h), and data is rounded. The arrival is then no earlier than among discs smaller by SOAK_TOUCH of distance and radius and by
 * SOAK_ROUNDING of the greatest coordinate and of the way that the robot could go from time 0 on, and no later than among discs as much larger. These are seen from a departure earlier, or later, by
 * SOAK_TOUCH of the times at hand.
 */
#define SOAK_SAME 1e-10
#define SOAK_TOUCH 3e-12
#define SOAK_ROUNDING 1e-15

typedef struct soak_case {
    const soak_scene *scene;
    soak_world world; /* the scene, open */
    double departure;
    double later;   /* another departure, not before */
    uint64_t pick;  /* for the check's own choices */
    double looser;  /* multiplies the three numbers above, for arbiters that know less well; 1 at first */
    double touches; /* 0 where touches excuse nothing, and only the rounding of places and times does; 1 at first */
    int failed;
    char what[160];
    double excess;          /* by how much it is wrong, as a share of the journey's time; infinite where there is no number */
    unsigned long forgiven; /* answers that differed by more than SOAK_SAME, and were told apart by a touch only */
} soak_case;

/* Note what is wrong; only the first time counts. `excess` is a time. */
void soak_fail(soak_case *c, double excess, const char *format, ...) __attribute__((format(printf, 3, 4)));

/* Is the question refused for a time that is too many journeys away? */
int soak_is_far(const soak_world *world, tdsp_status status, double time);

/* A(t): infinite where there is no way, NAN where a radius would shrink before or the departure is too far. Any other status fails. */
double soak_ask(soak_case *c, const soak_world *world, double departure);

/* Is `arrival` not before, or not after, that of the world at the departure, up to what is said above? `from` is the scene of the world. */
void soak_not_before(soak_case *c, const soak_world *world, double departure, double arrival, const char *text);
void soak_not_after(soak_case *c, const soak_world *world, double departure, double arrival, const char *text);
void soak_agrees(soak_case *c, const soak_world *world, double departure, double arrival, const char *text);

/* What two answers may differ by that are the same. */
double soak_slack(const soak_case *c, const soak_world *world, double departure, double arrival);

/* The world among discs smaller (-1) or larger (+1) by what may be a touch, for who leaves then or later, and a time moved by as much. 0 where there is none. */
int soak_open_moved(const soak_case *c, const soak_world *world, double departure, double sign, soak_world *moved);
double soak_step(const soak_case *c, const soak_world *world, double time);

/* A number below `count` from the case's own chance. */
uint64_t soak_pick(soak_case *c, uint64_t count);
double soak_pick_between(soak_case *c, double low, double high);

#endif
