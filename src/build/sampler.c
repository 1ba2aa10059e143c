/* What both ways of sampling share. */
#include "build/sampler.h"

#include <math.h>

row sampler_row(const sampler *s, const sample *at, double lower_after)
{
    double waited = s->probe.by_arrival ? at->departure : 0;
    double right = fmax(fmax(lower_after, at->lower) - waited, 0);
    return (row){at->departure, fmax(at->upper - waited, 0), right};
}

tdsp_status sampler_finish(sampler *s)
{
    const sample *last = &s->domain.last;
    row end = sampler_row(s, last, s->domain.right);
    if (last->departure > s->rows.held.departure) {
        tdsp_status status = rows_add(&s->rows, &end, &s->domain.last_path);
        if (status != TDSP_OK) return status;
    }
    rows_raise_right(&s->rows, end.right);
    return rows_end(&s->rows);
}

tdsp_status sampler_recall_path(probe *p, sample *s, double cap)
{
    if (p->path.departure == s->departure) return TDSP_OK;
    sample again;
    tdsp_status status = probe_roughly(p, s->departure, &again);
    if (status == TDSP_OK && !(again.upper <= cap)) status = probe_forward(p, s->departure, &again);
    if (status != TDSP_OK) return status;
    if (!(again.upper <= cap)) return TDSP_BAD_ORACLE;
    s->upper = fmax(s->upper, again.upper);
    return probe_keep_path(p, &again);
}
