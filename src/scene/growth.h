/* SPDX-License-Identifier: MIT */
/*
 * What a user says of a disc's growth, as pieces of polynomials.
 *
 * Every function returns NULL, or a static sentence that says what is wrong; where the list's status is not TDSP_OK, that is what is wrong.
 */
#ifndef SCENE_GROWTH_H
#define SCENE_GROWTH_H

#include "scene/pieces.h"
#include "tdsp/growth.h"

/* No number of a scene may be larger: squares and products of lengths then stay far from overflow. */
#define GROWTH_LARGEST 1e100

/* Does the growth, if it is in its range, come down to one rate without a law being called? */
int growth_is_rate(const tdsp_growth *growth, double *rate);

/* Append the pieces of a disc. *shrinks receives the moment from which the radius would shrink, and stays as it is instead; else infinite. */
const char *growth_add(const tdsp_growing_disc *disc, piece_list *list, double *shrinks);

/* The rate of a piece, raised by more than its round-off and by nothing that could be measured: what must not be negative. */
polynomial growth_rate_raised(const law_piece *piece);

/* The part of it that follows a law by callback: follow.c. */
const char *growth_follow(const tdsp_growing_disc *disc, piece_list *list);

#endif
