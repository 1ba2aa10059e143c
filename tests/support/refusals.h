/* SPDX-License-Identifier: MIT */
/* A question asked with a heap that refuses its first call, then its second, and so on. */
#ifndef SUPPORT_REFUSALS_H
#define SUPPORT_REFUSALS_H

#include "support/toy_tables.h"

/*
 * What is asked: it makes all that it needs with `memory`, frees it again, and checks that outputs are untouched unless TDSP_OK or an answer comes back.
 */
typedef tdsp_status (*refusable)(const tdsp_allocator *memory, void *ctx);

/*
 * Ask until nothing is refused any more; TDSP_NO_MEMORY must come back each time before, and nothing may be held after it. Of the first 128 calls each is
 * refused, of later ones less and less of them. `expected` is what comes back in the end. Returns how many calls it takes.
 */
size_t refuse_each(refusable ask, void *ctx, tdsp_status expected);

#endif
