/* SPDX-License-Identifier: MIT */
/*
 * What the legs of a chunk can meet, nearest first, and what hides it.
 *
 * The chunk starts at p, has length l and headings between u and u'. Whoever leaves it does so from p + d with |d| <= l, where d is itself between u and u', as the way there
 * was. So the line of a leg passes a centre at a distance that differs from that of the same heading's line through p by l sin(u, u') at most, and
 *
 * - a boundary no larger than R is met only by headings whose line through p comes within R + l sin(u, u') of the centre;
 * - a disc that is at least r large all along stops every leg whose line through p comes within r - l sin(u, u'), and which is longer than |O - p| + l. That is a cover
 *   (geom/skyline.h); what is met by longer legs only, and under covers only, is not looked at.
 */
#ifndef GROWTH_AHEAD_H
#define GROWTH_AHEAD_H

#include "geom/skyline.h"
#include "growth/rider.h"

typedef struct ahead_view {
    const growth_chunk *chunk;
    const sight_line *ends; /* the lines at both ends of the chunk */
    tdsp_point middle;      /* between their headings */
    double last;            /* when the chunk ends */
    double length, slide;   /* l, l sin(u, u') */
    skyline sky;
} ahead_view;

ahead_view ahead_look(const growth_chunk *chunk, const sight_line ends[2]);

/* Would a leg to the disc be too late? Its boundary is within the radius of the centre, wherever it is met. */
int ahead_is_too_late(const growth_engine *engine, tdsp_point place, double time, tdsp_point center, double radius);

/* Fill the engine's list with the discs that may be met before its limit, nearest first. TDSP_OK or TDSP_NO_MEMORY. */
tdsp_status ahead_list(growth_engine *engine, const ahead_view *view);

/* Is nothing left to see in the list from this disc on? Or nothing of this one? */
int ahead_ends(ahead_view *view, const growth_ahead *disc);
int ahead_hides(const ahead_view *view, const growth_ahead *disc);

/* From now on the disc hides what is behind it. */
void ahead_cover(ahead_view *view, const growth_ahead *disc, const growth_shape *shape);

#endif
