/* SPDX-License-Identifier: MIT */
/*
 * The exact oracles among growing discs: earliest arrival, latest departure, and their paths.
 *
 * Method: Maheshwari, Nouri, Sack (arXiv 1808.01984) with the search described in docs/math.md: tangents and
 * logarithmic spirals between moving Steiner points, explored in order of time by a binary heap (A*).
 */
#ifndef TDSP_SOLVER_H
#define TDSP_SOLVER_H

#include "tdsp/oracle.h"
#include "tdsp/scene.h"
#include "tdsp/status.h"
#include "tdsp/types.h"

#ifdef __cplusplus
extern "C" {
#endif

/**
 * The stated error of arrivals, relative to the travel time plus the scene's own time |sd| / speed; the rounding of a departure
 * and an arrival, 2^-52 of each, comes on top, and that of angles: for a ride on a disc of radius R, 2^-50 R / speed. Times over 2^40 times |sd| / speed in a scene where something grows are refused (by the general method: over 2^20 times), and so is every time in a scene
 * with a disc farther away from the journey's middle, or larger, than 1e12 |sd|, unless |sd| is 0.
 *
 * For other ends than the scene's own (tdsp_solver_set_ends()) with a coordinate farther than |sd| from the middle of the scene's journey, that
 * distance takes the place of |sd| in the error: the scene's frame is made for its own journey.
 */
#define TDSP_SOLVER_ERROR 1e-11

/**
 * How fixed-time questions are solved. The first two are Yi's variants, in which tangents and spirals are closed formulas; the third knows any growth
 * law (polynomials are Nouri and Sack's setting) and isolates roots. All give the same answers where they apply.
 */
typedef enum tdsp_method {
    TDSP_METHOD_AUTO = 0,             /* the first of the others that applies */
    TDSP_METHOD_SAME_SPEED = 1,       /* all discs grow at one rate in common */
    TDSP_METHOD_DIFFERENT_SPEEDS = 2, /* each disc grows at a rate of its own */
    TDSP_METHOD_GENERAL = 3           /* discs grow by any laws (tdsp/growth.h) */
} tdsp_method;

/** A workspace for questions to one scene: one for each thread. */
typedef struct tdsp_solver tdsp_solver;

/**
 * Make a solver that asks about the scene's own ends.
 *
 * @param scene  must outlive the solver; its allocator is used
 * @param out    owned by the caller: tdsp_solver_free(); untouched on error
 * @return TDSP_OK, TDSP_INVALID_ARGUMENT, TDSP_NO_MEMORY. Memory: 13 bytes a disc, 4 more once all discs are searched, and what the questions
 * meet on top: some 4 KB for each disc ridden (tdsp_solver_work_done() tells). Since 0.1.
 */
TDSP_API tdsp_status tdsp_solver_create(const tdsp_scene *scene, tdsp_solver **out);

/** As tdsp_solver_create(), with a method of one's choice. TDSP_NOT_SUPPORTED when it does not apply to the scene. Since 0.1. */
TDSP_API tdsp_status tdsp_solver_create_for(const tdsp_scene *scene, tdsp_method method, tdsp_solver **out);

/** The method of a solver, never TDSP_METHOD_AUTO. O(1). Since 0.1. */
TDSP_API tdsp_method tdsp_solver_method(const tdsp_solver *solver);

/** A method's stable name, e.g. "same_speed"; "unknown" for any other value. Never NULL; static storage; any thread. Since 0.1. */
TDSP_API const char *tdsp_method_name(tdsp_method method);

/** Free a solver; NULL is allowed. Since 0.1. */
TDSP_API void tdsp_solver_free(tdsp_solver *solver);

/** The scene that the solver was made for. O(1). Since 0.1. */
TDSP_API const tdsp_scene *tdsp_solver_scene(const tdsp_solver *solver);

/**
 * Ask about other ends from now on: every later question to this solver, and an oracle made from it, is about them. The scene stays as it is
 * prepared; nothing is built anew.
 *
 * @param ends  copied; NULL for the scene's own, which a new solver asks about
 * @return TDSP_OK; TDSP_INVALID_ARGUMENT for a coordinate that is not finite or beyond 1e100; TDSP_NOT_SUPPORTED for one farther than 2^20 |sd|
 *         from the middle of the scene's own journey, s to d (a journey of length 0 takes its unit from the farthest disc)
 *
 * Expected O(log n), for the moments at which the ends are covered. Since 0.1.
 */
TDSP_API tdsp_status tdsp_solver_set_ends(tdsp_solver *solver, const tdsp_ends *ends);

/** The ends asked about. TDSP_OK or TDSP_INVALID_ARGUMENT. O(1). Since 0.1. */
TDSP_API tdsp_status tdsp_solver_ends(const tdsp_solver *solver, tdsp_ends *out);

/**
 * A(t): the earliest arrival at the destination for a robot that leaves the source at `departure`.
 *
 * @param departure  finite, not negative
 * @param arrival    the arrival; infinity when there is no way. Untouched on error (a status that is no answer)
 * @return TDSP_OK; TDSP_SOURCE_COVERED, TDSP_DESTINATION_COVERED or TDSP_CUT_OFF when there is no way;
 *         TDSP_INVALID_ARGUMENT; TDSP_NOT_SUPPORTED for a departure or a disc too many journeys away (TDSP_SOLVER_ERROR); TDSP_SHRINKS when the
 *         answer reaches beyond tdsp_scene_valid_until(); TDSP_NO_MEMORY
 *
 * O(n^2 log n) at worst for discs of one rate. One thread at a time for a solver. Since 0.1.
 */
TDSP_API tdsp_status tdsp_earliest_arrival(tdsp_solver *solver, double departure, double *arrival);

/**
 * A path that is not the best for certain, and how good the best can be: *lower <= A(departure) <= *arrival, with
 *
 *     *arrival - departure <= (1 + delta) (*lower - departure)
 *
 * up to the solver's stated error. Across wide scenes it takes a small part of the time of an exact answer, whose proof costs more than finding it.
 * tdsp_solver_path() hands out the path that arrives at *arrival.
 *
 * @param delta    from 0 (exact) to 1
 * @param arrival  infinity when there is no way; untouched on error
 * @param lower    likewise
 * @return as tdsp_earliest_arrival(); TDSP_INVALID_ARGUMENT also for a delta out of its range
 *
 * O(n^2 log n) at worst, as tdsp_earliest_arrival(). One thread at a time for a solver. Since 0.1.
 */
TDSP_API tdsp_status tdsp_earliest_arrival_within(tdsp_solver *solver, double departure, double delta, double *arrival, double *lower);

/**
 * A^-1(a) = sup { t : A(t) <= a }: the latest departure that arrives at `arrival` or before, exact also where A jumps.
 * An arrival after the last possible one answers the last departure.
 *
 * @param arrival    not negative; infinity asks for the last departure of all
 * @param departure  the latest departure; infinity when `arrival` is infinite and nothing ever ends the departures;
 *                   untouched unless TDSP_OK
 * @param arrives    A(departure), at most `arrival`; may be NULL; untouched unless TDSP_OK
 * @return TDSP_OK; TDSP_ARRIVAL_TOO_EARLY when arrival < A(0); the reason why there is no way at all;
 *         TDSP_INVALID_ARGUMENT; TDSP_NOT_SUPPORTED as above; TDSP_NO_MEMORY. Since 0.1.
 */
TDSP_API tdsp_status tdsp_latest_departure(tdsp_solver *solver, double arrival, double *departure, double *arrives);

/**
 * tdsp_earliest_arrival() and tdsp_latest_departure() for these ends in this one question, with the errors of tdsp_solver_set_ends() besides.
 * The ends that the solver holds stay; tdsp_solver_path() hands out the path of this answer. Since 0.1.
 */
TDSP_API tdsp_status tdsp_earliest_arrival_for(tdsp_solver *solver, const tdsp_ends *ends, double departure, double *arrival);
TDSP_API tdsp_status tdsp_latest_departure_for(tdsp_solver *solver, const tdsp_ends *ends, double arrival, double *departure, double *arrives);

/**
 * A(t) from one source to many destinations: each with the arrival and the status that tdsp_earliest_arrival_for() gives it, up to the stated error. They
 * share one search.
 *
 * @param destinations  `count` places; equal ones, and the source itself, are allowed
 * @param arrivals      receives `count` arrivals; infinity where there is no way
 * @param statuses      receives as many statuses; NULL where it does not matter why there is no way, which costs a search of its own for each
 * @return TDSP_OK when each has an answer, even if none has a way; else as tdsp_earliest_arrival_for(), and the arrays are untouched
 *
 * O(n^2 log n + n^2 count) at worst. There is no path afterwards: ask for one alone. Since 0.1.
 */
TDSP_API tdsp_status tdsp_earliest_arrivals(tdsp_solver *solver, tdsp_point source, double departure, const tdsp_point *destinations, size_t count,
                                            double *arrivals, tdsp_status *statuses);

/**
 * The latest departures from many sources to one destination, as tdsp_latest_departure_for() gives them, up to the stated error. They share the
 * search backwards; each is confirmed by a search forwards of its own.
 *
 * @param departures  receives `count` departures; infinity where the status is not TDSP_OK, or nothing ever ends the departures
 * @param arrives     receives A(departure) of each; may be NULL
 * @param statuses    receives the statuses; may be NULL
 * @return as tdsp_earliest_arrivals(). Since 0.1.
 */
TDSP_API tdsp_status tdsp_latest_departures(tdsp_solver *solver, const tdsp_point *sources, size_t count, tdsp_point destination, double arrival,
                                            double *departures, double *arrives, tdsp_status *statuses);

/** What ends the departures. */
typedef struct tdsp_last_departure {
    double departure;   /* t_last; infinite when nothing ever ends the departures */
    double arrival;     /* A(t_last) */
    tdsp_status reason; /* why there is no way right after it: TDSP_SOURCE_COVERED, TDSP_DESTINATION_COVERED, TDSP_CUT_OFF;
                           TDSP_OK when nothing ever ends the departures */
    uint32_t disc;      /* the disc that covers the end, or the first disc of the gap that closes, or TDSP_NO_DISC */
    uint32_t other;     /* the second disc of the gap, or TDSP_NO_DISC */
    double time;        /* when that happens */
    tdsp_point place;   /* where: the end covered, or the corner of the gap */
} tdsp_last_departure;

/** t_last = sup { t : A(t) < infinity } and its reason. TDSP_OK; the reason why there is no way at all, and `out` is untouched; errors as
 * tdsp_latest_departure(). Since 0.1. */
TDSP_API tdsp_status tdsp_solver_last_departure(tdsp_solver *solver, tdsp_last_departure *out);

/**
 * What closes where A jumps right after `departure`: the place on its path at which two discs touch it at the same moment, one on either hand. Mostly
 * that is a gap event (docs/math/arrival.md, 5.4), and where both discs grow at one rate its time and place are exact.
 *
 * @param departure  as tdsp_jumps_find() or a latest departure tells it; finite, not negative
 * @param out        untouched unless TDSP_OK
 * @return TDSP_OK; TDSP_NO_ANSWER when there is no such place; TDSP_INVALID_ARGUMENT; an error as of tdsp_earliest_arrival()
 *
 * One tdsp_earliest_arrival(), and O(legs * discs) for the look. The path of the last answer is that of A(departure). One thread at a time for a
 * solver. Since 0.1.
 */
TDSP_API tdsp_status tdsp_solver_gap(tdsp_solver *solver, double departure, tdsp_gap *out);

/**
 * The path of the last answer: of A(t), or of A(t) at the latest departure.
 *
 * @param legs      receives the legs; may be NULL when capacity is 0
 * @param capacity  room in `legs`
 * @param count     receives the number of legs, also when the room is too small. 0 legs when source = destination
 * @return TDSP_OK; TDSP_BUFFER_TOO_SMALL; TDSP_NO_ANSWER; TDSP_INVALID_ARGUMENT. O(legs). Since 0.1.
 */
TDSP_API tdsp_status tdsp_solver_path(const tdsp_solver *solver, tdsp_leg *legs, size_t capacity, size_t *count);

/** Work done since the solver was made. */
typedef struct tdsp_solver_work {
    uint64_t forward_searches; /* evaluations of A(t), not counting those among only a part of the discs that was still growing */
    uint64_t reverse_searches; /* searches backwards in time, likewise; gap events included */
    uint64_t rounds;           /* questions put to a part of the discs (docs/math/search.md, 7.5: relaxation) */
    uint64_t labels;           /* labels taken from the heap */
    uint64_t legs_tested;      /* straight legs tested against the discs */
    uint64_t bytes;            /* memory held by the solver now */
} tdsp_solver_work;

/** The counters so far. O(1). Since 0.1. */
TDSP_API tdsp_status tdsp_solver_work_done(const tdsp_solver *solver, tdsp_solver_work *out);

/**
 * The solver as an oracle for the sampler: monotone in travel, with both directions. The oracle borrows the solver, and is about the ends that
 * the solver holds: they must stay while the oracle is used.
 * Since 0.1.
 */
TDSP_API tdsp_status tdsp_solver_oracle(tdsp_solver *solver, tdsp_oracle *out);

#ifdef __cplusplus
}
#endif

#endif
