/* SPDX-License-Identifier: MIT */
/* A solver as jumps and envelopes ask it: travel times with their errors, and the departures that are looked at. */
#ifndef SHAPE_ASKED_H
#define SHAPE_ASKED_H

#include "tdsp/shape.h"

/* A departure and its travel time. */
typedef struct shape_point {
    double departure;
    double travel;
} shape_point;

typedef struct asked {
    tdsp_solver *solver;
    tdsp_shape_options options; /* `until` is finite */
    tdsp_allocator allocator;
    double scale;      /* the solver's time scale */
    shape_point first; /* the ends of what is looked at; T(from) */
    shape_point last;
} asked;

/* Checks the options, finds the ends and asks about both. Statuses as tdsp_jumps_find(). */
tdsp_status asked_begin(asked *self, tdsp_solver *solver, const tdsp_shape_options *options);

/* T at a departure that has a way. */
tdsp_status asked_travel(asked *self, double departure, shape_point *out);

/* Travel times that differ by no more may be equal. */
double asked_noise(const asked *self, shape_point at);

/* TDSP_CANCELLED when the caller says so; `settled` is the departure up to which all is known. */
tdsp_status asked_progress(const asked *self, double settled);

/*
 * The departure right before which T passes the middle of what it rises by from `low` to `high`. Where it jumps over the middle there, *before is the last
 * departure of the jump and *after one so near behind it that its T stands for T(before+), and 1 is returned in *jumps. Elsewhere *before lies on the
 * curve, and *after is the same. Both lie from `low` to `high`.
 */
tdsp_status asked_middle(asked *self, shape_point low, shape_point high, shape_point *before, shape_point *after, int *jumps);

/* What closes at the jump after a departure; its discs are TDSP_NO_DISC where that is not found. */
tdsp_status asked_gap(asked *self, shape_point before, tdsp_gap *out);

#endif
