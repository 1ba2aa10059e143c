/* SPDX-License-Identifier: MIT */
/* The two ways of placing rows. Each adds the rows of the whole domain; the writer is left with all but the last, which is held. */
#ifndef BUILD_SAMPLER_H
#define BUILD_SAMPLER_H

#include "build/domain.h"
#include "build/invert.h"
#include "build/probe.h"
#include "build/rows.h"

typedef struct sampler {
    const tdsp_build_options *options;
    tdsp_monotone monotone;
    probe probe;
    domain domain;
    rows rows;
    uint64_t gaps; /* jumps at rows of which the oracle said what closes */
} sampler;

/* Each row as late as the guarantee allows. */
tdsp_status sampler_adaptive(sampler *s);

/* Algorithm 1 of arXiv 1808.01984: A(0) > 0, s->probe.by_arrival, guarantee arrival. */
tdsp_status sampler_geometric(sampler *s);

/* The row that a sample makes, its value being at least `lower_after` right after it. */
row sampler_row(const sampler *s, const sample *at, double lower_after);

/*
 * The goal of an adaptive row that starts after `departure` from the certified bound `lower`, `ceiling` being that of the first value it must
 * cover.
 */
inversion sampler_goal(const sampler *s, double departure, double ceiling, double lower);

/* Make sure that p->path is that of the sample: one that an earlier row came by is asked again. */
tdsp_status sampler_recall_path(probe *p, sample *s, double cap);

/* The last row, and its right side. */
tdsp_status sampler_finish(sampler *s);

/* Ask what closes at each jump of a row, once all rows are written; *count receives how many were told. */
tdsp_status sampler_ask_gaps(sampler *s, uint64_t *count);

#endif
