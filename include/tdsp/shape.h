/* SPDX-License-Identifier: MIT */
/*
 * The shape of A(t), the earliest arrival as a function of the departure: where it jumps, and of which pieces it is made.
 *
 * A jumps where a gap closes on the fastest path (docs/math.md). Between changes of the path's combinatorial form, the discs that it rides and
 * the sides on which it does, A is smooth.
 */
#ifndef TDSP_SHAPE_H
#define TDSP_SHAPE_H

#include "tdsp/build.h"
#include "tdsp/solver.h"
#include "tdsp/status.h"
#include "tdsp/types.h"

#ifdef __cplusplus
extern "C" {
#endif

/** What to look at, and how finely. Initialise with tdsp_shape_options_init(), then set members. */
typedef struct tdsp_shape_options {
    size_t size;       /* sizeof(tdsp_shape_options), set by tdsp_shape_options_init() */
    double from;       /* the first departure looked at; finite, not negative; default 0 */
    double until;      /* the last, not before `from`; later ones than the last possible mean that; default infinity */
    double least;      /* jumps: those of at most this size are left out, a time; 0: a 256th of the rise of T over all; default 0 */
    double resolution; /* envelope: a time; 0: a 1024th of the departures looked at; default 0 */
    tdsp_progress progress; /* may be NULL; told the departure up to which all is known, and the last */
    void *progress_ctx; /* handed to progress */
} tdsp_shape_options;

/** All members to their defaults. Since 0.1. */
TDSP_API void tdsp_shape_options_init(tdsp_shape_options *options);

/** A jump of A, which is one of T: later departures take longer by `size` at least. */
typedef struct tdsp_arrival_jump {
    double departure;     /* t: the last before the jump */
    double travel_before; /* T(t) */
    double travel_after;  /* T(t+), the limit from above */
    double size;          /* travel_after - travel_before */
    tdsp_gap gap;         /* what closes on the path of T(t), when and where: tdsp_solver_gap() */
} tdsp_arrival_jump;

/** Jumps in the order of departure. Immutable: any number of threads may read them. */
typedef struct tdsp_jumps tdsp_jumps;

/**
 * All jumps of A at departures from `from` up to `until` that are larger than `least`.
 *
 * None is missed: T never falls, so a stretch of departures over which it rises by no more than `least` holds none; every other stretch is
 * divided, by A at its middle, or by the latest departure for the arrival in the middle, which is the departure of the jump where that arrival lies
 * inside one. The end of all departures, where T becomes infinite, is no jump (tdsp_solver_last_departure()).
 *
 * @param options  NULL for the defaults; `least` is at least 1e-9 of T(until) where it is not 0
 * @param out      owned by the caller: tdsp_jumps_free(); the scene's allocator is used; untouched on error
 * @return TDSP_OK; the reason why there is no way at `from`; TDSP_INVALID_ARGUMENT; TDSP_NEEDS_HORIZON when nothing ever ends the departures
 *         and `until` is infinite; TDSP_CANCELLED; an error of the solver's
 *
 * Questions to the solver: about 3 (rise of T) / least * log2((until - from) / least) at most, a few for each jump where T is flat elsewhere. Departures
 * and travel times are exact up to a few times the solver's stated error. Its last answer is lost. One thread at a time for a solver. Since 0.1.
 */
TDSP_API tdsp_status tdsp_jumps_find(tdsp_solver *solver, const tdsp_shape_options *options, tdsp_jumps **out);

/** How many; 0 for NULL. O(1). Since 0.1. */
TDSP_API size_t tdsp_jumps_count(const tdsp_jumps *jumps);

/** Number i. TDSP_OK, or TDSP_INVALID_ARGUMENT for NULL and an i out of range. O(1). Since 0.1. */
TDSP_API tdsp_status tdsp_jumps_get(const tdsp_jumps *jumps, size_t i, tdsp_arrival_jump *out);

/** Free them; NULL is allowed. Since 0.1. */
TDSP_API void tdsp_jumps_free(tdsp_jumps *jumps);

/** A ride of a path's combinatorial form. */
typedef struct tdsp_ride {
    uint32_t disc; /* that is ridden */
    int32_t turn; /* +1 counter-clockwise, -1 clockwise */
} tdsp_ride;

/** How a piece ends. */
typedef enum tdsp_change {
    TDSP_CHANGE_END = 0,    /* with the departures looked at */
    TDSP_CHANGE_JUMP = 1,   /* A jumps */
    TDSP_CHANGE_TOUCH = 2,  /* rides begin or end, with no angle turned: A is smooth but for its second derivative */
    TDSP_CHANGE_SWITCH = 3  /* another way has become as fast: A has a kink */
} tdsp_change;

/** Departures whose fastest paths have one combinatorial form: the same rides in the same order. */
typedef struct tdsp_piece {
    double from;        /* the first departure; where the piece before ends */
    double until;       /* the last, at which the change comes */
    double travel_from; /* T(from+); T(from) for the first piece */
    double travel_until; /* T(until) */
    const tdsp_ride *rides; /* in order; lives as long as the envelope. NULL where there is none: a straight line */
    size_t ride_count;     /* how many */
    size_t form;           /* pieces of the same form have the same number; numbered from 0 in order of appearance */
    tdsp_change change;    /* how it ends */
    tdsp_gap gap;          /* a jump's: as in tdsp_arrival_jump */
} tdsp_piece;

/** The pieces of A in order. Immutable: any number of threads may read it. */
typedef struct tdsp_envelope tdsp_envelope;

/**
 * The sequence of the fastest paths' combinatorial forms. A ride counts when it turns by more than 1e-9 radians.
 *
 * What is certain: every piece wider than `resolution` is found, unless T is the same all over it and beyond on both sides. What is likely: a narrower
 * one is found as well where it lies between two different forms, which are told apart down to 1e-10 of A(until) and |sd| / speed; two pieces of the
 * same form that are both within the resolution, with something narrow between them, may be taken for one. The end of a piece is a bisection's; that of
 * a jump is exact (tdsp_jumps_find()). Where two ways stay equally fast, as in a scene that is its own mirror image, either is named, by rounding.
 *
 * @param options  NULL for the defaults
 * @param out      owned by the caller: tdsp_envelope_free(); the scene's allocator is used; untouched on error
 * @return as tdsp_jumps_find()
 *
 * Questions to the solver: (until - from) / resolution where T rises, and about 30 for each piece. Its last answer is lost. One thread at a time for a
 * solver. Since 0.1.
 */
TDSP_API tdsp_status tdsp_envelope_find(tdsp_solver *solver, const tdsp_shape_options *options, tdsp_envelope **out);

/** The number of pieces F, and of different forms among them; 0 for NULL. O(1). Since 0.1. */
TDSP_API size_t tdsp_envelope_pieces(const tdsp_envelope *envelope);
TDSP_API size_t tdsp_envelope_forms(const tdsp_envelope *envelope);

/** The resolution that was used, a time; 0 for NULL. O(1). Since 0.1. */
TDSP_API double tdsp_envelope_resolution(const tdsp_envelope *envelope);

/** Piece i. TDSP_OK, or TDSP_INVALID_ARGUMENT for NULL and an i out of range. O(1). Since 0.1. */
TDSP_API tdsp_status tdsp_envelope_piece(const tdsp_envelope *envelope, size_t i, tdsp_piece *out);

/** Free it; NULL is allowed. Since 0.1. */
TDSP_API void tdsp_envelope_free(tdsp_envelope *envelope);

#ifdef __cplusplus
}
#endif

#endif
