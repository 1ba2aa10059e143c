/* SPDX-License-Identifier: MIT */
/* Legs into a table: what one must be, and where its numbers go (docs/format.md, section 5). The sampler knows no more of paths than this. */
#ifndef BUILD_LEG_H
#define BUILD_LEG_H

#include "tdsp/types.h"

/* Are its numbers finite and in their range, its times in order, and all members zero that its kind does not have? */
int leg_is_good(const tdsp_leg *leg);

/* Where the next waypoint, arc and curve go, and their numbers. */
typedef struct leg_cursor {
    unsigned char *waypoint;
    unsigned char *arc;
    unsigned char *curve;
    uint32_t waypoints;
    uint32_t arcs;
    uint32_t curves;
} leg_cursor;

/* Write a good leg, and the waypoint at its end where it shares none with the next. */
void leg_put(leg_cursor *at, const tdsp_leg *leg, int with_end);

void leg_put_point(unsigned char *p, tdsp_point point);

#endif
