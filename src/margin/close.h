/* SPDX-License-Identifier: MIT */
/*
 * What a path comes close to, with the verifier's notion of a touch (tdsp/verify.h): its tolerance is
 *
 *     TDSP_VERIFY_TOLERANCE * J + TDSP_VERIFY_ROUNDING * M
 *
 * J the greater of |sd| and the length of the way, M the largest number that positions are computed from, those of the disc included.
 */
#ifndef MARGIN_CLOSE_H
#define MARGIN_CLOSE_H

#include "margin/touch.h"
#include "tdsp/scene.h"

typedef struct closeness {
    double robot;     /* the robot's radius */
    double tolerance; /* without the disc's part */
    double magnitude; /* M without the disc */
} closeness;

closeness close_scales(const tdsp_scene *scene, const tdsp_leg *legs, size_t count);

/*
 * The fastest disc there that the leg is clear of. Where it touches the disc as that is, that is just the disc's rate; where it is inside by more than the
 * tolerance, it is clear but for the tolerance.
 */
touch close_look(const closeness *scales, const way *leg, const tdsp_disc *disc);

/* Is the leg certainly clear, and more than a touch away, up to its end, when the disc grows at this rate? Cheap. */
int close_is_far(const closeness *scales, const way *leg, const tdsp_disc *disc, double rate);

#endif
