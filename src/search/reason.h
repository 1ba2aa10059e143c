/* SPDX-License-Identifier: MIT */
/*
 * Why there is no way.
 *
 * The way to the destination counts as open when only the destination's cover stops the robot: when, among the discs as they are at the
 * last moment t_d at which the destination is free, a robot that stays at the source until then still finds a way to it; or when
 * a robot that travels meanwhile is stopped for the first time by a disc that by then covers the destination; or when the last robot of all arrives at t_d, so
 * that nothing but the cover ended the departures. Otherwise, and always where the destination is walled in (enclosure.h), discs close every way.
 *
 * The third is not within the second: who leaves just after the last robot may be overtaken on its last steps by the disc that covers the destination a little later.
 */
#ifndef SEARCH_REASON_H
#define SEARCH_REASON_H

#include "search/solver.h"

/* *reason becomes TDSP_DESTINATION_COVERED or TDSP_CUT_OFF, for a departure that is free but has no way. */
tdsp_status reason_find(tdsp_solver *solver, double departure, tdsp_status *reason);

#endif
