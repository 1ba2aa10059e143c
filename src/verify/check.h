/* SPDX-License-Identifier: MIT */
/* The check of one path, for callers that check many against one scene: the index is built once. */
#ifndef VERIFY_CHECK_H
#define VERIFY_CHECK_H

#include <stddef.h>

#include "tdsp/verify.h"
#include "verify/nearby.h"

/* The scene's robot between these ends; NULL: the scene's own. */
tdsp_journey check_journey(const tdsp_scene *scene, const tdsp_ends *ends);

/*
 * Does the scene's description hold up to this time? A solver's answer may lie after tdsp_scene_valid_until() by its rounding; the radius that would
 * shrink stays from then on, so that the path can be checked that far.
 */
int check_is_described(const tdsp_scene *scene, double time);

/* As tdsp_verify_path() for this journey, with good arguments. Takes no memory. */
tdsp_verdict check_path(const tdsp_scene *scene, const tdsp_journey *journey, const nearby_index *index, const tdsp_leg *legs, size_t count,
                        double departure, double arrival);

#endif
