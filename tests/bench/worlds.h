/* SPDX-License-Identifier: MIT */
/*
 * The generated worlds that are measured: the kinds of `tdsp generate`, and two in which there is no path. The same kind,
 * count, span and seed give the same world.
 *
 * sealed  `random` with a closed ring of three spacings' radius around the destination: a proof needs the ring, whatever n
 * fenced  `random` with the destination in the middle and a closed ring around it half as wide as the scene, whose number of
 *         discs grows like sqrt(n)
 *
 * far     the journey crosses the whole scene, from corner to corner
 * near    it is a fixed number of mean spacings long, in the middle of the scene: what n adds is far away
 *
 * Growth is relative to the journey in both spans: a radius gains the kind's own share of a spacing while the robot goes
 * straight from end to end.
 */
#ifndef BENCH_WORLDS_H
#define BENCH_WORLDS_H

#include "tdsp/generate.h"

#define WORLD_NEAR_SPACINGS 20.0 /* from source to destination */
#define WORLD_NEAR_LEAST 1000    /* discs; with fewer the near journey would not fit into the scene */

typedef struct World {
    const char *kind;
    guint discs;
    gboolean near;
    guint64 seed;
} World;

/* Fill `out`, whose discs are the caller's to free; NULL, or what is wrong with the request. */
const char *world_make(const World *world, Generated *out);

#endif
