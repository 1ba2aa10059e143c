/* SPDX-License-Identifier: MIT */
/*
 * The verifier: checks a path against the discs, and a table against its scene, by means that share no code with
 * the search.
 */
#ifndef TDSP_VERIFY_H
#define TDSP_VERIFY_H

#include "tdsp/scene.h"
#include "tdsp/status.h"
#include "tdsp/table.h"
#include "tdsp/types.h"

#ifdef __cplusplus
extern "C" {
#endif

/** What may be wrong with a path; a verdict's problems are a sum of these. */
#define TDSP_PROBLEM_START 1u      /* does not start at the source at the departure */
#define TDSP_PROBLEM_END 2u        /* does not end at the destination at the arrival */
#define TDSP_PROBLEM_JOIN 4u       /* legs do not join in place or time */
#define TDSP_PROBLEM_SPEED 8u      /* faster than the robot */
#define TDSP_PROBLEM_CLEARANCE 16u /* enters a disc by more than the tolerance */
#define TDSP_PROBLEM_LEG 32u       /* a leg is not well formed: not finite, time runs backwards, an arc or curve off its centre or its disc's */

/**
 * What is rounding and no mistake: the tolerance, a length, is
 *     TDSP_VERIFY_TOLERANCE * J + TDSP_VERIFY_ROUNDING * M
 * with the journey J the greater of |sd| and the length of the way, and the magnitude M the largest of: the coordinates of
 * both ends, of the legs and the arcs' centres; the arcs' radii; speed times the largest time; the coordinates of the disc with the least
 * clearance, and what its radius is the sum of. It is granted to the clearance, to each join, to both ends (in time: divided by the speed)
 * and to the ends of an arc. A leg may be longer than speed times duration by the share 1e-9, by TDSP_VERIFY_ROUNDING * M and by 1e-11 of the way that the robot
 * can go from departure to arrival (a rider who changes over from one disc to another that it touches is beside the second by as much as still is a touch); a curve counts
 * as long as it would be at its greatest speed.
 */
#define TDSP_VERIFY_TOLERANCE 1e-9
#define TDSP_VERIFY_ROUNDING 1e-13 /* the share of the magnitude M in the tolerance: TDSP_VERIFY_TOLERANCE */

/** What a check of a path found. */
typedef struct tdsp_verdict {
    uint32_t problems;    /* 0: the path is good */
    double min_clearance; /* a lower bound on the clearance to the inflated discs over the whole motion: below the least one by at most a
                             quarter of the tolerance, and by a thousandth of it but for legs that creep along a disc they do not
                             ride, or go around a hundred thousand times where rates change; infinite without discs, -infinity when a leg is not finite or runs backwards */
    double time;          /* when it is least */
    uint32_t disc;        /* to which disc; TDSP_NO_DISC without discs */
    size_t leg;           /* on which leg, or the first leg with a problem */
    double tolerance;     /* the tolerance that was used, a length */
} tdsp_verdict;

/**
 * Check a path: well formed, starts and ends right, joins, keeps to the top speed, and stays clear of every disc over its
 * whole motion, by rigorous bounds between samples.
 *
 * @param departure, arrival  what the path claims
 * @return TDSP_OK when the check was done (the verdict says how it went); TDSP_SHRINKS when the path goes on after
 *         tdsp_scene_valid_until() by more than TDSP_SOLVER_ERROR of it (the verdict is then untouched); TDSP_INVALID_ARGUMENT; TDSP_NO_MEMORY
 *
 * O(n log n + (log n + near discs) legs) time, O(n) memory meanwhile; where rates change, each near disc counts as often as a piece of its law begins during the leg. Any
 * thread. Since 0.1.
 */
TDSP_API tdsp_status tdsp_verify_path(const tdsp_scene *scene, const tdsp_leg *legs, size_t count, double departure,
                                      double arrival, tdsp_verdict *out);

/** The same for a path between these ends; NULL: the scene's own. Since 0.1. */
TDSP_API tdsp_status tdsp_verify_path_for(const tdsp_scene *scene, const tdsp_ends *ends, const tdsp_leg *legs, size_t count,
                                          double departure, double arrival, tdsp_verdict *out);

/** What may be wrong with a table besides its bytes. */
typedef struct tdsp_table_verdict {
    int ok;                  /* 1: nothing of what follows is wrong; else 0 */
    int stale;               /* built for another scene */
    uint64_t bad_order;      /* rows whose departures or travel times are out of order */
    uint64_t bad_ratio;      /* rows that break the guarantee */
    uint64_t bad_paths;      /* rows whose path was rejected */
    uint64_t first_bad_row;  /* the first row with any problem; UINT64_MAX when none */
    tdsp_verdict worst;      /* the verdict of the path with the least clearance, or of the first rejected one */
} tdsp_table_verdict;

/**
 * Check an opened table against its scene: the hash, the order of rows, the guarantee of each interval (8 roundings
 * granted), and each row's path: it leaves at b_i and arrives at b_i + left_i or before. A row without legs is a path only
 * where the source is the destination. Errors as tdsp_verify_path(). Since 0.1.
 */
TDSP_API tdsp_status tdsp_verify_table(const tdsp_scene *scene, const tdsp_table *table, tdsp_table_verdict *out);

/** The same for a table between these ends, whose hash is tdsp_scene_hash_for(); NULL: the scene's own. Since 0.1. */
TDSP_API tdsp_status tdsp_verify_table_for(const tdsp_scene *scene, const tdsp_ends *ends, const tdsp_table *table,
                                           tdsp_table_verdict *out);

#ifdef __cplusplus
}
#endif

#endif
