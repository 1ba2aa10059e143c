/* SPDX-License-Identifier: MIT */
/* The domain of departures: from 0 to the last one, and why it ends there. */
#ifndef BUILD_DOMAIN_H
#define BUILD_DOMAIN_H

#include "build/kept_path.h"
#include "build/probe.h"

typedef struct domain {
    sample first; /* at 0 */
    sample last;
    double right;       /* a lower bound of the value right after it; infinite when there is no way any more */
    tdsp_status reason; /* why the domain ends: TDSP_HORIZON or why there is no way */
    kept_path first_path;
    kept_path last_path;
} domain;

/*
 * Find it. The horizon may be infinite. TDSP_OK; the reason why there is no way at 0; TDSP_NEEDS_HORIZON; errors of the probe. Release in any
 * case.
 */
tdsp_status domain_find(domain *d, probe *p, double horizon);
void domain_release(domain *d, const tdsp_allocator *allocator);

#endif
