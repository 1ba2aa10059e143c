/* SPDX-License-Identifier: MIT */
/*
 * What a rider can see while it rides one chunk: the wedge that its tangent ray sweeps.
 *
 * Directions are measured from the heading in the middle of the chunk, in the rider's own sense, so that the rider's heading goes from -half_angle
 * to +half_angle. In these terms the leg to a disc at the bearing b and the distance D, to the rider's own side of it or to the other, is headed
 *
 *     b + asin(k) - lean       k = (R_i cos(alpha) - R_j) / D, alpha of the own side
 *     b - asin(k) + lean       alpha of the other side,        lean = asin(c_j)
 *
 * (docs/math/search.md, 7.4). k is linear in time, so its values at the chunk's ends bound each heading: a leg leaves the chunk only where these bounds meet
 * the wedge. Between the two headings every ray runs into the disc; that is what the skyline is told.
 */
#ifndef SEARCH_WEDGE_H
#define SEARCH_WEDGE_H

#include "geom/contact.h"
#include "search/neighbours.h"
#include "geom/skyline.h"

typedef struct look_wedge {
    geom_ride motion;  /* the chunk; on a point of no duration for a start */
    tdsp_point middle; /* of the chunk */
    double heading;    /* there, as an angle in [-pi, pi] */
    double half_angle;
    double half_length;
    double radius[2]; /* of the disc ridden, at the chunk's ends */
    double widest;    /* the larger of the two */
    double late;      /* the true time at which radii are largest */
    double rate;      /* the largest of any disc */
    double lean;      /* the largest |lean| of any disc, or a little more */
    double longest;   /* every longer leg is too late */
    skyline sky;
} look_wedge;

/* The bounds of a heading; from > to where there is no leg. */
typedef struct wedge_range {
    double from;
    double to;
} wedge_range;

/* How a disc stands in the wedge. */
typedef struct wedge_sight {
    wedge_range same;  /* the heading of the leg to the rider's own side of it ... */
    wedge_range other; /* ... and to the other */
    double shortest;   /* no leg to it is shorter */
    int is_apart;      /* from the disc ridden, all the time */
} wedge_sight;

/* The wedge of a chunk. `late` and `rate` as in the struct; nothing is known to be too late. */
void wedge_of_chunk(look_wedge *self, const geom_ride *motion, double late, double rate);

/* The sector of this half angle about a heading, seen from a start. The ride is on a point and takes no time. */
void wedge_of_sector(look_wedge *self, const geom_ride *motion, double heading, double half_angle, double late, double rate);

/* From now on legs are too late that cannot be at the goal by the limit. */
void wedge_set_limit(look_wedge *self, tdsp_point goal, double limit);

/* The direction of a bearing in the wedge's terms, in [-pi, pi]. */
double wedge_direction(const look_wedge *self, double bearing);

/* No leg to a disc with this gap (neighbours.h) is shorter. */
double wedge_shortest(const look_wedge *self, double gap);

/* Which discs of a block may be seen: *seen receives their places in the block, in order of their gaps; returns how many. */
int wedge_look_at_block(const look_wedge *self, const neighbour_block *block, int seen[NEIGHBOUR_BLOCK]);

/* Look at a disc that can be ridden, whose centre is at this distance and bearing from the ridden one's. Returns 0 when none of its legs matters. */
int wedge_look_at_disc(const look_wedge *self, const geom_disc *disc, double distance, double bearing, wedge_sight *sight);

/* May what is within `reach` of a place, of no larger rate than `rate`, be seen? *shortest is a bound on the legs to it. */
int wedge_look_at_place(const look_wedge *self, tdsp_point place, double reach, double rate, double *shortest);

/* May a leg to the disc leave with a heading in this range? */
int wedge_shows(const look_wedge *self, const wedge_range *range, double shortest);

/* Tell the skyline what the disc hides. */
void wedge_cover(look_wedge *self, const geom_disc *disc, const wedge_sight *sight);

#endif
