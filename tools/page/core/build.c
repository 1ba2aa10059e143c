/* SPDX-License-Identifier: MIT */
/* Tables, as `tdsp build` makes them: the bytes are the same. */
#include "page.h"

/* What is asked, in this order. */
enum { ASKED_GUARANTEE, ASKED_SAMPLING, ASKED_EPSILON, ASKED_DELTA, ASKED_HORIZON, ASKED_MOST_ROWS, ASKED_EXACT };

static tdsp_build_options options_for(const double *asked)
{
    tdsp_build_options options;
    tdsp_build_options_init(&options);
    options.guarantee = (tdsp_guarantee)asked[ASKED_GUARANTEE];
    options.sampling = (tdsp_sampling)asked[ASKED_SAMPLING];
    options.epsilon = asked[ASKED_EPSILON];
    options.delta = asked[ASKED_DELTA];
    options.horizon = asked[ASKED_HORIZON];
    options.max_rows = (uint32_t)asked[ASKED_MOST_ROWS];
    if (asked[ASKED_EXACT] != 0) options.oracle_share = 0;
    options.progress = page_progress;
    return options;
}

static tdsp_build_world world_of(const PageScene *page, const char *length_unit, const char *time_unit)
{
    const tdsp_journey *journey = tdsp_scene_journey(page->scene);
    return (tdsp_build_world){tdsp_scene_hash(page->scene), journey->speed, journey->source, journey->destination, length_unit, time_unit};
}

static void report_write(const tdsp_build_report *report, double *at)
{
    const double parts[] = {(double)report->rows, (double)report->bytes, (double)report->forward_calls, (double)report->reverse_calls,
                            report->last_departure, report->last_reason, report->oracle_delta, (double)report->rough_calls, (double)report->gaps};
    for (size_t i = 0; i < sizeof parts / sizeof *parts; i++) at[i] = parts[i];
}

/*
 * A table for the scene's own ends: those of the solver must be the same. `bytes` receives a block to release and its length; `report` rows, bytes, calls forward
 * and reverse, last departure, reason, delta of the oracle, rough calls, gaps.
 */
PAGE_EXPORT(scene_build)
tdsp_status page_scene_build(PageScene *page, const double *asked, const char *length_unit, const char *time_unit, void **bytes, size_t *length,
                             double report[9])
{
    tdsp_oracle oracle;
    tdsp_build_report built;
    tdsp_build_options options = options_for(asked);
    options.world = world_of(page, length_unit, time_unit);
    tdsp_status status = tdsp_solver_oracle(page->solver, &oracle);
    if (status == TDSP_OK) status = tdsp_build(&oracle, &options, &page_allocator, bytes, length, &built);
    if (status == TDSP_OK) report_write(&built, report);
    return status;
}
