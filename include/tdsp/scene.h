/* SPDX-License-Identifier: MIT */
/*
 * Scenes: a robot, a source, a destination, and discs that grow. Build one, prepare it, share it.
 *
 * A prepared scene never changes and may be used by any number of threads, each with a solver of its own
 * (tdsp/solver.h).
 */
#ifndef TDSP_SCENE_H
#define TDSP_SCENE_H

#include "tdsp/status.h"
#include "tdsp/types.h"

#ifdef __cplusplus
extern "C" {
#endif

/** A prepared scene. It never changes: any number of threads may use it. */
typedef struct tdsp_scene tdsp_scene;

/** The robot and the ends of its journey. */
typedef struct tdsp_journey {
    double speed;           /* the robot's top speed, over 0, finite */
    double radius;          /* the robot's radius, not negative: every disc is inflated by it */
    tdsp_point source;      /* finite */
    tdsp_point destination; /* finite; may equal the source */
} tdsp_journey;

/** A source and a destination among the discs of a scene. */
typedef struct tdsp_ends {
    tdsp_point source;      /* where the journey begins */
    tdsp_point destination; /* where it ends */
} tdsp_ends;

/**
 * Make a prepared scene from arrays. The arrays are copied.
 *
 * @param journey    robot and ends
 * @param discs      `count` discs, in any order; a disc's index is its place in this array. NULL when count is 0
 * @param count      at most 2^31 - 1
 * @param allocator  NULL for the C library's
 * @param out        the scene, owned by the caller: tdsp_scene_free(); untouched on error
 * @return TDSP_OK; TDSP_INVALID_ARGUMENT for NULL; TDSP_BAD_SCENE for a number out of its range (which one:
 *         tdsp_journey_check(), tdsp_disc_check()); TDSP_NO_MEMORY
 *
 * O(n log n) expected: half a second for a million discs that are not in each other's way. The scene holds about 155 bytes for each
 * of its discs, 32 of them the copy; a disc that others enclose for good costs the copy only. While it is made, up to 190. Since 0.1.
 */
TDSP_API tdsp_status tdsp_scene_create(const tdsp_journey *journey, const tdsp_disc *discs, size_t count,
                                       const tdsp_allocator *allocator, tdsp_scene **out);

/** Free a scene; NULL is allowed. No solver may use it any more. Since 0.1. */
TDSP_API void tdsp_scene_free(tdsp_scene *scene);

/** NULL when the values are in range, else a static sentence that says what is wrong. Since 0.1. */
TDSP_API const char *tdsp_journey_check(const tdsp_journey *journey);
TDSP_API const char *tdsp_disc_check(const tdsp_disc *disc);

/** The scene's parts as they were given; the array lives as long as the scene. O(1). Since 0.1. */
TDSP_API const tdsp_journey *tdsp_scene_journey(const tdsp_scene *scene);
TDSP_API const tdsp_disc *tdsp_scene_discs(const tdsp_scene *scene, size_t *count);

/**
 * 64-bit FNV-1a hash of the scene's doubles in order (speed, robot radius, source, destination, then centre, radius and growth
 * of each disc; each as 8 little-endian bytes, -0 as 0). Where a disc's rate changes (tdsp/growth.h) each disc's are centre, number of
 * pieces, and start, degree and coefficients of each piece. A table carries it. O(n). Since 0.1.
 */
TDSP_API uint64_t tdsp_scene_hash(const tdsp_scene *scene);

/** The hash of the same scene with these ends in the place of its own; NULL: its own. O(n). Since 0.1. */
TDSP_API uint64_t tdsp_scene_hash_for(const tdsp_scene *scene, const tdsp_ends *ends);

/**
 * The last moment at which the source (destination) is not inside a disc; infinite when it never is covered, negative when
 * it is covered at time 0. `disc`, where not NULL, receives the disc that covers it first, or TDSP_NO_DISC. O(1). Since 0.1.
 */
TDSP_API double tdsp_scene_source_free_until(const tdsp_scene *scene, uint32_t *disc);
TDSP_API double tdsp_scene_destination_free_until(const tdsp_scene *scene, uint32_t *disc);

/** The same of any place, finite and not beyond 1e100. Expected O(log n); O(n) where a rate changes with time. Since 0.1. */
TDSP_API double tdsp_scene_free_until(const tdsp_scene *scene, tdsp_point place, uint32_t *disc);

#ifdef __cplusplus
}
#endif

#endif
