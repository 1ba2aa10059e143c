/* SPDX-License-Identifier: MIT */
/*
 * Deadlines and margins: when to leave at the latest and what says so, how much time is to spare, and how much faster everything may grow
 * before a plan fails.
 *
 * Derivations: docs/math/margins.md.
 */
#ifndef TDSP_MARGIN_H
#define TDSP_MARGIN_H

#include "tdsp/scene.h"
#include "tdsp/solver.h"
#include "tdsp/status.h"
#include "tdsp/types.h"

#ifdef __cplusplus
extern "C" {
#endif

/** What stands in the way of leaving later, or of growing faster. */
typedef enum tdsp_limit {
    TDSP_LIMIT_NONE = 0,                /* nothing does */
    TDSP_LIMIT_DEADLINE = 1,            /* the journey takes until the deadline; a moment later one is late by about as much */
    TDSP_LIMIT_GAP = 2,                 /* two discs close a gap: the arrival jumps, or there is no other way */
    TDSP_LIMIT_JUMP = 3,                /* the arrival jumps, and no gap was found that explains it */
    TDSP_LIMIT_SOURCE_COVERED = 4,      /* a disc covers the source */
    TDSP_LIMIT_DESTINATION_COVERED = 5, /* a disc covers the destination */
    TDSP_LIMIT_CUT_OFF = 6,             /* discs close every way, and no single gap was found that explains it */
    TDSP_LIMIT_TOUCH = 7                /* a path touches a disc */
} tdsp_limit;

/** The limit's stable name in lower case, e.g. "source_covered" (the word of the JSON output); "unknown" for any other value. Since 0.1. */
TDSP_API const char *tdsp_limit_name(tdsp_limit limit);

/** A limit and where it shows. */
typedef struct tdsp_witness {
    tdsp_limit limit; /* what it is */
    uint32_t disc;  /* the disc that covers or touches, or the first of the gap; TDSP_NO_DISC without one */
    uint32_t other; /* the second disc of the gap, else TDSP_NO_DISC */
    double time;    /* when: of the cover, of the touch, of passing the gap; the deadline; infinite for TDSP_LIMIT_NONE */
    tdsp_point
        place; /* where: the end of the journey that is covered, or that is reached at the deadline; else where the path is then */
} tdsp_witness;

/** The latest departure for a deadline. */
typedef struct tdsp_deadline_answer {
    double departure;     /* the latest: sup { t : A(t) <= deadline }; infinite when nothing ever ends the departures */
    double arrival;       /* A(departure), at most the deadline */
    tdsp_witness witness; /* what keeps one from leaving later */
    tdsp_status after;    /* right after it: TDSP_OK when there still is a way, which takes too long; else why there is none */
    double
        after_arrival; /* A right after it, for a jump the other side of it; the deadline where A does not jump; infinite without a way */
} tdsp_deadline_answer;

/**
 * To arrive by a deadline, when must the robot leave at the latest, and why not later? As tdsp_latest_departure(), with the reason.
 *
 * @param deadline  not negative; infinity asks for the last departure of all
 * @param out       untouched unless TDSP_OK
 * @return as tdsp_latest_departure(). tdsp_solver_path() hands out the path of the latest departure.
 *
 * Where A is continuous it costs what tdsp_latest_departure() does; at a jump two arrivals and a tdsp_solver_gap() more, at the end of all departures another
 * tdsp_solver_last_departure(). One thread at a time for a solver. Since 0.1.
 */
TDSP_API tdsp_status tdsp_solver_deadline(tdsp_solver *solver, double deadline, tdsp_deadline_answer *out);

/** What a departure has to spare against a deadline. */
typedef struct tdsp_slack {
    tdsp_status status; /* of A(departure): TDSP_OK or why there is no way */
    double arrival;     /* A(departure); infinite without a way */
    double early;       /* deadline - arrival: negative when late, -infinity without a way */
    double
        later; /* how much later one may leave, latest.departure - departure: negative when too late, -infinity when no departure
                                    is in time */
    tdsp_status latest_status; /* TDSP_OK, or why no departure is in time (as tdsp_latest_departure()); `latest` is then zeros */
    tdsp_deadline_answer latest; /* the latest departure, and what keeps one from leaving later */
} tdsp_slack;

/**
 * Slack of a departure against a deadline, which may be infinite.
 *
 * @param departure  finite, not negative
 * @return TDSP_OK when the slack was found, whatever it is; TDSP_INVALID_ARGUMENT, TDSP_NOT_SUPPORTED, TDSP_NO_MEMORY as
 *         tdsp_earliest_arrival(); `out` is then untouched. Cost: tdsp_earliest_arrival() and tdsp_solver_deadline(). Since 0.1.
 */
TDSP_API tdsp_status tdsp_solver_slack(tdsp_solver *solver, double departure, double deadline, tdsp_slack *out);

/**
 * Rates are raised up to this share of the robot's speed and no further; a disc that is as fast or faster keeps its rate. Growth above the robot's speed
 * is another world: such a disc's boundary cannot be ridden and nobody outruns it.
 */
#define TDSP_MARGIN_CAP (1.0 - 1.0 / 1048576.0)

/** How all growth rates are raised by one amount x; a rate V becomes */
typedef enum tdsp_raise {
    TDSP_RAISE_FACTOR = 0, /* x V: discs that stand still stay */
    TDSP_RAISE_ADDED = 1   /* V + x, not below 0: a length per time more for every disc */
} tdsp_raise;

/**
 * The scene with all rates raised: min(x V, cap) or min(max(V + x, 0), cap), cap = TDSP_MARGIN_CAP times the robot's speed; V where V >= cap. Where a
 * disc's rate changes at given times, each of its rates. Growth that bends (polynomials, and laws by callback, which are followed by such) is raised as a whole and
 * without the cap: with R_0 the radius at time 0, to R_0 + x (R(t) - R_0), or to R(t) + x t. Up to tdsp_scene_valid_until() as before.
 *
 * @param amount  x: a factor, not negative; or a length per time of either sign. Infinity raises to the cap
 * @param out     a scene of its own, owned by the caller, with the same allocator; untouched on error
 * @return TDSP_OK; TDSP_INVALID_ARGUMENT; TDSP_NOT_SUPPORTED where growth bends and x is infinite or a negative length per time; TDSP_NO_MEMORY. Cost: that
 *         of making the scene. Since 0.1.
 */
TDSP_API tdsp_status tdsp_scene_raise(const tdsp_scene *scene, tdsp_raise how, double amount, tdsp_scene **out);

/** How far rates may rise. */
typedef struct tdsp_margin {
    double
        most; /* the largest amount that does no harm: a factor (1: none to spare), or a length per time (0: none). Smaller when it
                             fails as it is. Infinite: not even the cap does harm; -infinity: even without any growth it fails */
    tdsp_status
        status; /* TDSP_OK; where `most` is -infinity: of a departure, why there is no way, or TDSP_ARRIVAL_TOO_EARLY when the deadline is too
                             early; of a path, TDSP_BAD_PATH as it enters a disc */
    double arrival; /* of a departure: A in the scene raised by `most` (infinite where that is -infinity); of a path: its end */
    tdsp_witness witness; /* what fails next; the time and place are those in the scene raised by `most` */
    uint32_t scenes;      /* raised scenes that were solved */
} tdsp_margin;

/**
 * How far may all rates rise so that a robot that leaves at `departure`, and plans anew, still arrives by the deadline?
 * sup { x : A_x(departure) <= deadline }, A_x being the arrival in the scene raised by x.
 *
 * @param departure  finite, not negative
 * @param deadline   not negative; infinity: arrive at all
 * @param out        untouched unless TDSP_OK
 * @return TDSP_OK whatever the margin is; TDSP_INVALID_ARGUMENT; TDSP_NOT_SUPPORTED for times too far away (TDSP_SOLVER_ERROR), and for
 *         an added rate where growth bends and the departure fails as it is; TDSP_SHRINKS; TDSP_NO_MEMORY
 *
 * `most` is safe: the search was made in the scene raised by it, and finds that arrival. No amount larger by 1e-12 of itself (for an
 * added rate: of itself plus the fastest rate below the cap) and by the solver's stated error will do. Each raised scene costs a tdsp_scene_create() and one to four
 * searches; ten to twenty are needed. Where growth bends, factors up to 2^20 are
 * looked at, and `most` is infinite when none does harm. Any thread. Since 0.1.
 */
TDSP_API tdsp_status tdsp_departure_margin(const tdsp_scene *scene, tdsp_raise how, double departure, double deadline,
                                           tdsp_margin *out);

/**
 * How far may all rates rise so that this very path, driven at its times, stays clear of every disc?
 *
 * A fastest path touches the discs that it rides on: where one of them grows, there is nothing to spare, and `most` is exactly 1, or 0 for an added
 * rate. There is something to spare where a path touches nothing but discs that stand still (and with an added rate not even those), and for paths that were
 * made to: those of a table moved to an earlier departure, those of a scene raised by tdsp_scene_raise(). A path touches where it comes as close as the
 * verifier's tolerance (tdsp/verify.h).
 *
 * @param legs       as of tdsp_solver_path() or tdsp_table_path(), in order of time, at times not negative
 * @param count      number of legs; 0: a robot that is at the source at `departure`
 * @param departure  looked at where there are no legs only
 * @param out        untouched unless TDSP_OK
 * @return TDSP_OK whatever the margin is; TDSP_INVALID_ARGUMENT; TDSP_BAD_PATH for legs that are not well formed or run backwards in time;
 *         where growth changes, TDSP_NOT_SUPPORTED for an added rate when the path fails as it is, TDSP_SHRINKS, TDSP_NO_MEMORY
 *
 * Only clearance is looked at: whether the legs join, and keep to the top speed, is the verifier's business. Exact on lines up to rounding; on arcs
 * among other discs a lower bound by at most a quarter of the tolerance, as a length at that time. O(legs * discs), no memory. Where growth changes, or legs are
 * curves, the amount is found by halving with the verifier, to 1e-12 of itself and its tolerance: some sixty verifications of raised scenes; amounts are then looked for up
 * to 2^20, of the robot's speed for an added rate, and `most` is infinite when none does harm. Any thread. Since 0.1.
 */
TDSP_API tdsp_status tdsp_path_margin(const tdsp_scene *scene, tdsp_raise how, const tdsp_leg *legs, size_t count,
                                      double departure, tdsp_margin *out);

#ifdef __cplusplus
}
#endif

#endif
