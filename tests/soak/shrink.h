/* SPDX-License-Identifier: MIT */
/* The shrinker: a scene in which a check fails becomes the smallest and plainest in which the same check still does. */
#ifndef SOAK_SHRINK_H
#define SOAK_SHRINK_H

#include "soak/case.h"

typedef struct soak_failure {
    size_t check;
    double departure, later;
    uint64_t pick;
    char what[160];
    double excess;
} soak_failure;

/* Put a check to a scene: 1 where it fails, and *failure says how; its check, departures and pick are given. */
int soak_fails(const soak_scene *scene, soak_failure *failure);

/* Make the scene smaller for at most so many seconds. */
void soak_shrink(soak_scene *scene, soak_failure *failure, double seconds);

#endif
