/*
 * The closing gap that a path is the last to pass, found from the path alone.
 *
 * Whoever is the last to pass a gap touches both discs at one moment, one on either side (docs/math.md, 5.4). A path that touches two discs on
 * different sides at the same time passes a gap that closes behind it.
 */
#ifndef MARGIN_WITNESS_H
#define MARGIN_WITNESS_H

#include "tdsp/margin.h"

/* TDSP_OK with *out, its limit TDSP_LIMIT_GAP, or TDSP_LIMIT_NONE when there is none, or where rates change; TDSP_NO_MEMORY. */
tdsp_status witness_gap(const tdsp_scene *scene, const tdsp_leg *legs, size_t count, tdsp_witness *out);

#endif
