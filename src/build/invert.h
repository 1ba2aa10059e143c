/*
 * Inverting a non-decreasing value by forward calls: the last departure at which its ceiling is under a cap.
 */
#ifndef BUILD_INVERT_H
#define BUILD_INVERT_H

#include "build/probe.h"
#include "build/trail.h"

typedef struct inversion {
    double cap;         /* a departure belongs to the row while its sample's ceiling is not over this */
    double slack;       /* stop when the ceiling is no farther under the cap than this ... */
    double anchor;      /* ... and than the way from this departure; -INFINITY to waive */
    double room;        /* from the ceiling where the row starts to the cap: a row that has used less than half of it goes on */
    double width;       /* stop when the bracket is no wider; 0 for neighbouring doubles */
    double after;       /* a row must end later than this, unless the bracket closes there */
    double seed;        /* a departure to try first, near a jump; NaN for none */
    unsigned reversals; /* how often oracle->latest_departure may be asked */
} inversion;

/* `low` fits under the cap, `high` does not. At the end either they are neighbouring doubles, or low is within the slack. */
typedef struct bracket {
    sample low;
    sample high;
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
