/* SPDX-License-Identifier: MIT */
/*
 * Discs that can never matter.
 *
 * While a disc k grows at least as fast as disc i, the part of i's boundary that k covers only grows. A disc whose whole boundary
 * is covered by such discs at time 0 is enclosed by them for good: no robot outside can ever touch it.
 */
#ifndef SCENE_COVER_H
#define SCENE_COVER_H

#include "scene/index.h"

/* Move the items that can matter to the front, in their order; *kept receives how many. The index is over all the items. */
tdsp_status cover_drop(const scene_index *index, const tdsp_allocator *allocator, index_items items, uint32_t *kept);

#endif
