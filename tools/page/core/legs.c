/* SPDX-License-Identifier: MIT */
/* Legs and gaps as numbers, and what is asked of legs alone. */
#include "page.h"

static double *write_point(tdsp_point point, double *at)
{
    *at++ = point.x;
    *at++ = point.y;
    return at;
}

static tdsp_point read_point(const double *at)
{
    return (tdsp_point){at[0], at[1]};
}

double *page_leg_write(const tdsp_leg *leg, double *at)
{
    const double head[] = {leg->kind, leg->disc, leg->turn, leg->start_time, leg->end_time};
    const double tail[] = {leg->radius_from, leg->radius_to, leg->angle_from, leg->sweep, leg->rate_from,
                           leg->rate_to,     leg->bend_from, leg->bend_to,    leg->speed};
    for (size_t i = 0; i < sizeof head / sizeof *head; i++) *at++ = head[i];
    at = write_point(leg->center, write_point(leg->to, write_point(leg->from, at)));
    for (size_t i = 0; i < sizeof tail / sizeof *tail; i++) *at++ = tail[i];
    return at;
}

static tdsp_leg leg_read(const double *at)
{
    return (tdsp_leg){.kind = (uint32_t)at[0],
                      .disc = (uint32_t)at[1],
                      .turn = (int32_t)at[2],
                      .start_time = at[3],
                      .end_time = at[4],
                      .from = read_point(at + 5),
                      .to = read_point(at + 7),
                      .center = read_point(at + 9),
                      .radius_from = at[11],
                      .radius_to = at[12],
                      .angle_from = at[13],
                      .sweep = at[14],
                      .rate_from = at[15],
                      .rate_to = at[16],
                      .bend_from = at[17],
                      .bend_to = at[18],
                      .speed = at[19]};
}

double *page_gap_write(const tdsp_gap *gap, double *at)
{
    *at++ = gap->first;
    *at++ = gap->second;
    *at++ = gap->time;
    return write_point(gap->place, at);
}

tdsp_status page_legs_write(const tdsp_leg *legs, size_t count, PageNumbers *out)
{
    tdsp_status status = page_numbers(count * PAGE_LEG_NUMBERS, out);
    if (status != TDSP_OK) return status;
    double *at = out->at;
    for (size_t i = 0; i < count; i++) at = page_leg_write(&legs[i], at);
    return TDSP_OK;
}

PAGE_EXPORT(leg_position) void page_leg_position(const double *leg, double time, double out[2])
{
    tdsp_leg read = leg_read(leg);
    write_point(tdsp_leg_position(&read, time), out);
}

/* The verdict on a path between the solver's ends: problems, least clearance, time, disc, leg, tolerance. */
PAGE_EXPORT(scene_verify)
tdsp_status page_scene_verify(const PageScene *page, const double *numbers, size_t count, double departure, double arrival, double out[6])
{
    tdsp_ends ends;
    tdsp_verdict verdict;
    tdsp_leg *legs = page_allocate(count * sizeof *legs);
    if (!legs) return TDSP_NO_MEMORY;
    for (size_t i = 0; i < count; i++) legs[i] = leg_read(numbers + i * PAGE_LEG_NUMBERS);
    tdsp_status status = tdsp_solver_ends(page->solver, &ends);
    if (status == TDSP_OK) status = tdsp_verify_path_for(page->scene, &ends, legs, count, departure, arrival, &verdict);
    page_release(legs);
    if (status != TDSP_OK) return status;
    const double parts[] = {verdict.problems, verdict.min_clearance, verdict.time, verdict.disc, (double)verdict.leg, verdict.tolerance};
    for (size_t i = 0; i < sizeof parts / sizeof *parts; i++) out[i] = parts[i];
    return TDSP_OK;
}
