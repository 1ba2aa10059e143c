/* SPDX-License-Identifier: MIT */
/* A copy of a path that an oracle lent: legs, bytes, or neither. Its memory is kept for the next one. */
#ifndef BUILD_KEPT_PATH_H
#define BUILD_KEPT_PATH_H

#include <stddef.h>

#include "tdsp/oracle.h"
#include "tdsp/status.h"
#include "tdsp/types.h"

typedef struct kept_path {
    double departure; /* negative when nothing is held */
    tdsp_leg *legs;
    size_t leg_count;
    size_t leg_capacity;
    void *bytes;
    size_t byte_count;
    size_t byte_capacity;
} kept_path;

kept_path kept_path_none(void);

/* TDSP_OK, TDSP_NO_MEMORY (nothing is held then), or TDSP_BAD_ORACLE when the lent path contradicts itself. */
tdsp_status kept_path_copy(kept_path *path, const tdsp_allocator *allocator, const tdsp_oracle_path *lent, double departure);

/* A second copy. As kept_path_copy(). */
tdsp_status kept_path_again(kept_path *path, const tdsp_allocator *allocator, const kept_path *from);

/* Give back the room that the legs do not need: of millions of paths it would be most. TDSP_OK or TDSP_NO_MEMORY (it stays held then). */
tdsp_status kept_path_trim(kept_path *path, const tdsp_allocator *allocator);

void kept_path_swap(kept_path *a, kept_path *b);
void kept_path_release(kept_path *path, const tdsp_allocator *allocator);

#endif
