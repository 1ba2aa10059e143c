/* SPDX-License-Identifier: MIT */
/*
 * What near discs hide from a rider.
 *
 * Directions are angles from the middle heading of a chunk. A cover says: from any heading in [from, to] of this chunk, the ray runs
 * into one disc within the length `reach`. A leg that leaves inside a cover and is longer than its reach is blocked. Discs are looked at
 * in the order of a lower bound on their legs; once that bound is past a cover's reach the cover hides whatever is still to come,
 * and when such covers fill the chunk nothing more can be seen.
 */
#ifndef GEOM_SKYLINE_H
#define GEOM_SKYLINE_H

typedef struct sky_cover {
    double from;
    double to;
    double reach;
} sky_cover;

/* More covers than this only mean less hiding. */
#define SKY_COVERS 48

typedef struct skyline {
    double from; /* the chunk's headings */
    double to;
    double next; /* the least reach that is not passed */
    sky_cover near[SKY_COVERS]; /* whose reach is not passed yet */
    int near_count;
    sky_cover full[SKY_COVERS]; /* passed: in order, disjoint; the longest reach of each */
    int full_count;
} skyline;

void sky_init(skyline *sky, double from, double to);

/* Add a cover, made a little narrower so that a leg that only touches is never hidden. */
void sky_add(skyline *sky, double from, double to, double reach);

/* Every leg still to come is at least this long. Returns 0 when nothing more can be seen. */
int sky_advance(skyline *sky, double bound);

/* Is every leg of a heading in this window hidden that is at least this long? */
int sky_hides(const skyline *sky, double from, double to, double length);

#endif
