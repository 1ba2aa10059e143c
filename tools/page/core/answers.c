/* SPDX-License-Identifier: MIT */
/* Exact answers of a scene's solver. */
#include <math.h>

#include "page.h"

PAGE_EXPORT(scene_arrival) tdsp_status page_scene_arrival(PageScene *page, double departure, double *out)
{
    return tdsp_earliest_arrival(page->solver, departure, out);
}

/* The latest departure, and its arrival. */
PAGE_EXPORT(scene_departure) tdsp_status page_scene_departure(PageScene *page, double arrival, double out[2])
{
    return tdsp_latest_departure(page->solver, arrival, &out[0], &out[1]);
}

/* The legs of the last answer. */
PAGE_EXPORT(scene_path) tdsp_status page_scene_path(const PageScene *page, PageNumbers *out)
{
    size_t count;
    tdsp_status status = tdsp_solver_path(page->solver, NULL, 0, &count);
    if (status != TDSP_OK && status != TDSP_BUFFER_TOO_SMALL) return status;
    tdsp_leg *legs = page_allocate(count * sizeof *legs);
    if (!legs) return TDSP_NO_MEMORY;
    status = tdsp_solver_path(page->solver, legs, count, &count);
    if (status == TDSP_OK) status = page_legs_write(legs, count, out);
    page_release(legs);
    return status;
}

/* departure, arrival, reason, disc, other, time, x, y */
PAGE_EXPORT(scene_last) tdsp_status page_scene_last(PageScene *page, double out[8])
{
    tdsp_last_departure last;
    tdsp_status status = tdsp_solver_last_departure(page->solver, &last);
    if (status != TDSP_OK) return status;
    const double parts[] = {last.departure, last.arrival, last.reason, last.disc, last.other, last.time, last.place.x, last.place.y};
    for (size_t i = 0; i < sizeof parts / sizeof *parts; i++) out[i] = parts[i];
    return TDSP_OK;
}

PAGE_EXPORT(scene_gap) tdsp_status page_scene_gap(PageScene *page, double departure, double out[PAGE_GAP_NUMBERS])
{
    tdsp_gap gap;
    tdsp_status status = tdsp_solver_gap(page->solver, departure, &gap);
    if (status == TDSP_OK) page_gap_write(&gap, out);
    return status;
}

/* Each departure is replaced by its arrival, not a number where there is no way. */
PAGE_EXPORT(scene_samples) tdsp_status page_scene_samples(PageScene *page, double *times, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        double arrival = NAN;
        tdsp_status status = tdsp_earliest_arrival(page->solver, times[i], &arrival);
        if (!tdsp_status_is_answer(status)) return status;
        times[i] = status == TDSP_OK ? arrival : NAN;
    }
    return TDSP_OK;
}
