/* SPDX-License-Identifier: MIT */
/*
 * What closes at jumps. Asked when the rows are placed, of the oracle that was given and of nobody else: so the bytes do not depend on who found a
 * row, and no other call is under way.
 */
#include "build/sampler.h"

#include "query/jump.h"

static tdsp_status ask_gap(sampler *s, size_t i, const writer_row *at, uint64_t *count)
{
    const tdsp_oracle *oracle = s->probe.oracle;
    tdsp_gap gap;
    tdsp_status status = probe_report_progress(&s->probe);
    if (status == TDSP_OK) status = oracle->jump_gap(oracle->ctx, at->departure, at->left, at->right, &gap);
    if (status == TDSP_NO_ANSWER) return TDSP_OK;
    if (status == TDSP_OK) status = writer_add_gap(s->rows.writer, i, &gap);
    if (status == TDSP_OK) ++*count;
    return status;
}

tdsp_status sampler_ask_gaps(sampler *s, uint64_t *count)
{
    const tdsp_oracle *oracle = s->probe.oracle;
    tdsp_status status = TDSP_OK;
    *count = 0;
    for (size_t i = 0; oracle->jump_gap && i < writer_count(s->rows.writer) && status == TDSP_OK; i++) {
        writer_row at = writer_row_at(s->rows.writer, i);
        if (jump_between(at.departure, at.left, at.right, oracle->error, oracle->time_scale)) status = ask_gap(s, i, &at, count);
    }
    return status;
}
