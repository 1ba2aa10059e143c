/* SPDX-License-Identifier: MIT */
/* Who asks: the oracle that was given, or the workers' oracles where the caller has threads to run them. */
#ifndef BUILD_CREW_H
#define BUILD_CREW_H

#include "build/sampler.h"

typedef struct crew {
    sampler *sampler;
    probe *probes; /* one a worker */
    size_t count;
} crew;

/* TDSP_OK or TDSP_NO_MEMORY. End it in any case. */
tdsp_status crew_begin(crew *c, sampler *s);

/* Adds the workers' calls to those of the sampler. */
void crew_end(crew *c);

/* Is there only the oracle that was given? */
int crew_is_alone(const crew *c);

/* The probe of a worker, or NULL for one that was never hired. */
probe *crew_probe(const crew *c, size_t worker);

/* Run task(ctx, i, worker) for each i < count: in order when alone, else as the caller sees fit. TDSP_OK or TDSP_CANCELLED. */
tdsp_status crew_run(const crew *c, tdsp_task task, void *ctx, size_t count);

#endif
