/* SPDX-License-Identifier: MIT */
/*
 * The margin of a fixed path among discs whose rates change: by halving on the amount, with the verifier for the judge.
 *
 * Discs raised further are larger at every time, so a path that enters one at an amount enters it at every larger one. A path that touches is as close as the verifier's
 * tolerance: where the amount found has not let the disc in the way grow by more than that, there is nothing to spare.
 */
#ifndef MARGIN_PATH_HALVING_H
#define MARGIN_PATH_HALVING_H

#include "tdsp/margin.h"

/* As tdsp_path_margin(), for legs that are well formed. Some sixty verifications. */
tdsp_status halving_margin(const tdsp_scene *scene, tdsp_raise how, const tdsp_leg *legs, size_t count, double departure, tdsp_margin *out);

#endif
