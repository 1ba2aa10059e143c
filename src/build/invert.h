/* SPDX-License-Identifier: MIT */
/*
 * Inverting a non-decreasing value by forward calls: the last departure at which its ceiling is under a cap.
 */
#ifndef BUILD_INVERT_H
#define BUILD_INVERT_H

#include "build/probe.h"
#include "build/trail.h"

typedef struct inversion {
    double cap;    /* a departure belongs to the row while its sample's ceiling is not over this */
    double slack;  /* stop when the ceiling is no farther under the cap than this ... */
    double anchor; /* ... and than the way from this departure; -INFINITY to waive */
    double room;   /* from the ceiling where the row starts to the cap: a row that has used less than half of it goes on */
    double width;  /* stop when the bracket is no wider; 0 for neighbouring doubles */
    double after;  /* a row must end later than this, unless the bracket closes there */
    double
        give; /* how far the bound right after a jump may lie under the value that shows the jump; 0: settle each jump to doubles */
    double seed; /* a departure to try first, which the oracle answered to `asked`; NaN for none */
    double asked;
    int seed_is_known; /* `answer` is the sample at the seed, and the oracle still has its path */
    sample answer;
    int suspected; /* a jump is: ask backwards before anything else */
    unsigned reversals; /* how often oracle->latest_departure may be asked */
} inversion;

/*
 * `low` fits under the cap, `high` does not. At the end either low is within the slack, or the value jumps right after it, which
 * neighbouring doubles show or a reverse call.
 */
typedef struct bracket {
    sample low;
    sample high;
    double after; /* when inverted: a certified lower bound of the value right after low; no value after low lies under it */
    int jumps;    /* when inverted: the value jumps right after low, and at high it is hardly more than `after` */
} bracket;

int sample_fits(const sample *s, double cap);
int bracket_is_closed(const bracket *b);

/*
 * Narrow the bracket. On the way the trail learns, and the path of each new `low` is kept in p->path. high must be the trail's nearest
 * sample ahead, and stays so.
 *
 * At most about 200 calls on any monotone function (halving at least every third call, by the doubles' own spacing over far ranges).
 */
tdsp_status invert(probe *p, const inversion *goal, trail *t, bracket *b);

#endif
