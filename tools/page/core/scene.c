/* SPDX-License-Identifier: MIT */
/*
 * Scenes from numbers: speed, radius, source, destination; then of each disc centre, radius, kind of growth (tdsp_growth_kind), count, that many values and,
 * where rates change at times, as many times.
 */
#include "page.h"

#define JOURNEY_NUMBERS 6

static tdsp_journey journey_read(const double *at)
{
    return (tdsp_journey){.speed = at[0], .radius = at[1], .source = {at[2], at[3]}, .destination = {at[4], at[5]}};
}

/* Behind the disc. The growth borrows the numbers. */
static const double *disc_read(const double *at, tdsp_growing_disc *out)
{
    size_t count = (size_t)at[4];
    const double *values = at + 5;
    *out = (tdsp_growing_disc){.center = {at[0], at[1]}, .radius = at[2], .growth = {.kind = (tdsp_growth_kind)at[3], .count = count}};
    if (out->growth.kind == TDSP_GROWTH_RATE) out->growth.rate = values[0];
    out->growth.values = values;
    out->growth.times = values + count;
    return values + (out->growth.kind == TDSP_GROWTH_RATES ? 2 * count : count);
}

PAGE_EXPORT(journey_check) const char *page_journey_check(const double *numbers)
{
    tdsp_journey journey = journey_read(numbers);
    return tdsp_journey_check(&journey);
}

/* What is wrong with where a disc is and how large; then, how it grows. NULL: nothing. */
PAGE_EXPORT(disc_check) const char *page_disc_check(const double *numbers)
{
    tdsp_disc disc = {.center = {numbers[0], numbers[1]}, .radius = numbers[2]};
    return tdsp_disc_check(&disc);
}

PAGE_EXPORT(growth_check) const char *page_growth_check(const double *numbers)
{
    tdsp_growing_disc disc;
    disc_read(numbers, &disc);
    return tdsp_growing_disc_check(&disc);
}

PAGE_EXPORT(scene_free) void page_scene_free(PageScene *page)
{
    if (!page) return;
    tdsp_solver_free(page->solver);
    tdsp_scene_free(page->scene);
    page_release(page);
}

static tdsp_status create(const double *numbers, tdsp_growing_disc *discs, size_t count, PageScene *page)
{
    tdsp_journey journey = journey_read(numbers);
    const double *at = numbers + JOURNEY_NUMBERS;
    for (size_t i = 0; i < count; i++) at = disc_read(at, &discs[i]);
    tdsp_status status = tdsp_scene_create_growing(&journey, discs, count, &page_allocator, &page->scene);
    return status == TDSP_OK ? tdsp_solver_create(page->scene, &page->solver) : status;
}

PAGE_EXPORT(scene_create) tdsp_status page_scene_create(const double *numbers, size_t count, PageScene **out)
{
    tdsp_status status = TDSP_NO_MEMORY;
    PageScene *page = page_allocate(sizeof *page);
    tdsp_growing_disc *discs = count <= SIZE_MAX / sizeof *discs ? page_allocate(count * sizeof *discs) : NULL;
    if (page) *page = (PageScene){NULL, NULL};
    if (page && discs) status = create(numbers, discs, count, page);
    page_release(discs);
    if (status == TDSP_OK) {
        *out = page;
    } else {
        page_scene_free(page);
    }
    return status;
}

PAGE_EXPORT(scene_set_ends) tdsp_status page_scene_set_ends(PageScene *page, double source_x, double source_y, double destination_x, double destination_y)
{
    tdsp_ends ends = {{source_x, source_y}, {destination_x, destination_y}};
    return tdsp_solver_set_ends(page->solver, &ends);
}

/* Of the scene between the solver's ends. */
PAGE_EXPORT(scene_hash) uint64_t page_scene_hash(const PageScene *page)
{
    tdsp_ends ends;
    return tdsp_solver_ends(page->solver, &ends) == TDSP_OK ? tdsp_scene_hash_for(page->scene, &ends) : 0;
}

/* Until when no radius shrinks, and the disc that does first. */
PAGE_EXPORT(scene_valid_until) double page_scene_valid_until(const PageScene *page, uint32_t *disc)
{
    return tdsp_scene_valid_until(page->scene, disc);
}

PAGE_EXPORT(scene_radius) tdsp_status page_scene_radius(const PageScene *page, uint32_t disc, double time, double *out)
{
    return tdsp_scene_disc_at(page->scene, disc, time, out, NULL);
}

PAGE_EXPORT(scene_radii) tdsp_status page_scene_radii(const PageScene *page, double time, double *out, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        tdsp_status status = tdsp_scene_disc_at(page->scene, (uint32_t)i, time, &out[i], NULL);
        if (status != TDSP_OK) return status;
    }
    return TDSP_OK;
}
