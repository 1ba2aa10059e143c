/* SPDX-License-Identifier: MIT */
/*
 * Scenes of the soak: discs of any law in one array, so that all mixes go through the same checks, and so that a scene can be moved, made tighter
 * or looser, taken apart by the shrinker and written as a scene file.
 */
#ifndef SOAK_SCENE_H
#define SOAK_SCENE_H

#include <stddef.h>
#include <stdint.h>

#include "support/random_growth.h"
#include "tdsp/solver.h"

#define SOAK_MOST_DISCS 512

typedef struct soak_disc {
    tdsp_point center;
    double radius;
    tdsp_growth growth; /* its pointers are set by soak_open() only */
    double values[GROWTH_MOST_VALUES], times[GROWTH_MOST_VALUES];
    grown_parts parts;
} soak_disc;

typedef struct soak_scene {
    const char *mix;
    double moment; /* a departure for which the scene was made; negative without one */
    tdsp_journey journey;
    size_t count;
    soak_disc discs[SOAK_MOST_DISCS];
} soak_scene;

/* A scene that can be asked. */
typedef struct soak_world {
    const soak_scene *is;
    tdsp_scene *scene;
    tdsp_solver *solver;
    double unit; /* |sd| / speed */
} soak_world;

void soak_copy(soak_scene *to, const soak_scene *from);
void soak_add(soak_scene *scene, tdsp_point center, double radius, double rate);

/* From the other generators of random scenes. */
void soak_take_rates(soak_scene *scene, const tdsp_journey *journey, const tdsp_disc *discs, size_t count);
void soak_take_growth(soak_scene *scene, const grown_scene *from);

/* TDSP_OK, or why there is no such scene or solver. */
tdsp_status soak_open(const soak_scene *scene, tdsp_method method, soak_world *world);
void soak_close(soak_world *world);

int soak_has_rates_only(const soak_scene *scene);
int soak_has_laws(const soak_scene *scene);

/* Turned, mirrored before where asked, in other units, moved: as grown_place(). */
void soak_place(soak_scene *scene, const grown_change *change);

/* Are all numbers such as a scene may have? */
int soak_is_within_limits(const soak_scene *scene);

/* By how much radii change, and for whom: a robot that leaves `start` at `departure`. */
typedef struct soak_nudge {
    double share;    /* of what a path to the disc measures */
    double rounding; /* of the largest number in a place at `time` */
    double time;
    tdsp_point start;
    double departure;
} soak_nudge;

/*
 * Every radius, the robot's included, greater by so much, or less where the shares are negative. None falls below 0: what is too small at time 0 to become less by all of it grows
 * less in proportion, so that it is less by all of it from the moment on in which the robot can first meet it.
 */
void soak_inflate(soak_scene *scene, const soak_nudge *nudge);

/* A disc's radius with the robot's, by the definition of its law. */
double soak_radius(const soak_scene *scene, size_t disc, double time);

/* |sd|, and the largest number among places and radii. */
double soak_distance(const soak_scene *scene);
double soak_magnitude(const soak_scene *scene);

#endif
