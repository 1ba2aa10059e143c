/* SPDX-License-Identifier: MIT */
/*
 * A chunk of a ride, or a start, among random discs, in either direction of time: what a rider could see, by solving for every leg there is.
 */
#ifndef SUPPORT_CHUNK_H
#define SUPPORT_CHUNK_H

#include "search/wedge.h"

#define CHUNK_MOST 90 /* discs */

/* A start looks about in so many sectors. */
#define CHUNK_SECTORS 6

/* A disc that is ridden, or a start, among others, in one direction of time. */
typedef struct chunk_world {
    tdsp_allocator memory;
    disc_set set;
    neighbourhood around;
    const geom_disc *discs; /* in the direction of time */
    geom_disc point;        /* the start */
    uint32_t self;          /* the disc ridden, or INDEX_NONE */
    geom_ride motion;
    double late;
    double rate; /* the largest, or a little more */
} chunk_world;

typedef struct chunk_leg {
    uint32_t disc;
    int to_side;
    int root;
    double heading;
    double length;
    geom_line line;
} chunk_leg;

/* A start in every fourth world, else a chunk as rides are followed: up to 0.6 rad, the radius at most doubled or halved. */
typedef void (*chunk_check)(chunk_world *w, uint64_t *chance);
void chunk_each(int count, uint64_t seed, chunk_check check);

/* One world, which may have nothing to ride on. */
void chunk_world_make(chunk_world *w, int is_start, uint64_t *chance);
void chunk_world_free(chunk_world *w);

/* The chunk's wedge, or that of one of the sectors about the start. */
look_wedge chunk_wedge(const chunk_world *w, int sector);
int chunk_sectors(const chunk_world *w);

/* All legs that leave, blocked or not; returns how many. */
int chunk_legs(const chunk_world *w, chunk_leg legs[4 * CHUNK_MOST]);
int chunk_leg_blocked(const chunk_world *w, const chunk_leg *self);

/* The ray of the wedge's direction x. */
geom_line chunk_ray(const chunk_world *w, const look_wedge *wedge, double x, double length);

#endif
