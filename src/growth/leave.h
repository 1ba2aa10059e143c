/* SPDX-License-Identifier: MIT */
/*
 * The legs that leave a chunk of a ride, each found.
 *
 * A robot that leaves at the parameter w goes straight. Let e(w) be the signed distance of a disc's centre from its line, and m(w) the least F of its motion over one of the
 * disc's runs (sight.h). As the place of leaving moves along the heading, only the heading's turning changes the line, and by the theorem of the envelope
 *
 *     dm/dw = 2 L e dH/dw,    L the way to the nearest point.
 *
 * The heading H turns one way on a chunk, so between the roots of e the least F rises or falls for good: there is a tangent exactly where m has other
 * signs at the two ends, and one only. (Where the nearest point is the place of leaving itself m is the rider's own clearance, which is not
 * negative; so no root hides there.) The roots of e are the moments at which the robot heads for, or straight away from, the centre: the angle between heading and centre
 * passes 0 and pi one way only, so that on a part of the chunk too short to walk round the centre there is one where the signs of e differ, and none where they do not.
 *
 * The goal is met where e of the goal is 0.
 */
#ifndef GROWTH_LEAVE_H
#define GROWTH_LEAVE_H

#include "growth/ride.h"

/* Push the legs that leave a chunk, whose ride has this index. TDSP_OK or TDSP_NO_MEMORY. */
tdsp_status leave_chunk(growth_engine *engine, const growth_chunk *chunk, uint32_t ride);

/*
 * Push the leg of no length that changes over, at a moment of the chunk, to a disc on the other side that is touched there. Whoever is let past a closing gap may also change
 * over, or rounding would leave a way that neither world has, the one with the gap and the one without.
 */
tdsp_status leave_touch(growth_engine *engine, const growth_chunk *chunk, uint32_t ride, const ride_change *change);

/* Push the legs that leave the start. */
tdsp_status leave_start(growth_engine *engine);

#endif
