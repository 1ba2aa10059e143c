/* SPDX-License-Identifier: MIT */
/*
 * Moving along a path: pure functions on an array of legs. No heap, no stdio, no state; firmware may use them.
 */
#ifndef TDSP_PATH_H
#define TDSP_PATH_H

#include "tdsp/status.h"
#include "tdsp/types.h"

#ifdef __cplusplus
extern "C" {
#endif

/**
 * Where the robot is at a time.
 *
 * @param legs   the path's legs in order of time, each starting when the one before ends
 * @param count  number of legs, at least 1
 * @param time   before the first leg the answer is its start, after the last leg its end
 * @param out    the position; untouched on error
 * @return TDSP_OK; TDSP_INVALID_ARGUMENT for NULL, count 0 or a time that is not finite
 *
 * O(log count). Any thread. Since 0.1.
 */
TDSP_API tdsp_status tdsp_path_position(const tdsp_leg *legs, size_t count, double time, tdsp_point *out);

/** The same on one leg, `time` clamped to the leg. O(1). Since 0.1. */
TDSP_API tdsp_point tdsp_leg_position(const tdsp_leg *leg, double time);

/** The leg moved in time by `delay` (negative: earlier). Positions stay. O(1). Since 0.1. */
TDSP_API tdsp_leg tdsp_leg_shifted(const tdsp_leg *leg, double delay);

#ifdef __cplusplus
}
#endif

#endif
