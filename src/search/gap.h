/* SPDX-License-Identifier: MIT */
/*
 * Gap events: where a closing gap lets a robot out at the last moment.
 *
 * When two discs meet, the corner between them starts at infinite speed and slows down. A robot that has just slipped through runs
 * ahead of it; the last one to escape is touched by the corner at the moment when the corner is as slow as the robot. Then
 *
 *     |D|^2 = R_i^2 + R_j^2 - 2 R_i R_j cos(theta_i + theta_j)
 *
 * and the corner lies on disc i at the normal n_i = D / (R_i - R_j exp(i s (theta_i + theta_j))), made unit, with the robot's heading
 * n_i turned by s theta_i: disc i on its left for s = +1, disc j on the other side. Derivation: docs/math/arrival.md, 5.4.
 */
#ifndef SEARCH_GAP_H
#define SEARCH_GAP_H

#include "search/solver.h"

typedef struct gap_event {
    double time; /* in the frame, true time */
    tdsp_point place;
    uint32_t first, second; /* the discs i < j of the set */
    int side;               /* s, for the first */
    double normal[2];       /* of the corner on either disc */
    double departure;       /* a bound on, or once `solved` the value of, the latest departure through it; the frame's time */
    int solved;
} gap_event;

/*
 * The events that a robot could pass when it leaves after `departure` and arrives by `arrival` (the frame's times) as far as straight
 * lines tell, and whose corner no other disc of the set covers, into solver->gaps.
 */
tdsp_status gap_collect(tdsp_solver *solver, const disc_set *set, double departure, double arrival);

#endif
