/* SPDX-License-Identifier: MIT */
/* The argument is in reach.h. */
#include "growth/reach.h"

/* Steps that a window is cut into. */
#define STEPS 8

/* Discs are larger by this share, and by this length; distances are that of the journey. */
#define SLACK 1e-9

/* The line above a law in a window of true time. */
static geom_disc reach_disc(const growth_shape *shape, double from, double until)
{
    double step = (until - from) / STEPS, first = shape_radius(shape, from), last = shape_radius(shape, until);
    double rate = step > 0.0 ? math_max((last - first) / (until - from), 0.0) : 0.0, radius = math_max(last - rate * (until - step), 0.0);
    for (int k = 1; k < STEPS; ++k) radius = math_max(radius, shape_radius(shape, from + k * step) - rate * (from + (k - 1) * step));
    return disc_make(shape->center, radius * (1.0 + SLACK) + SLACK, rate * (1.0 + SLACK));
}

static tdsp_status reach_reserve(growth_reach *reach, const tdsp_allocator *allocator, uint32_t count)
{
    tdsp_status status = memory_reserve(allocator, (void **)&reach->discs, &reach->disc_capacity, count, sizeof *reach->discs);
    if (status == TDSP_OK) status = memory_reserve(allocator, (void **)&reach->spare, &reach->spare_capacity, count, sizeof *reach->spare);
    if (status == TDSP_OK) status = memory_reserve(allocator, (void **)&reach->given, &reach->given_capacity, count, sizeof *reach->given);
    return status == TDSP_OK ? memory_reserve(allocator, (void **)&reach->largest, &reach->largest_capacity, count, sizeof *reach->largest) : status;
}

tdsp_status reach_build(growth_reach *reach, const tdsp_allocator *allocator, const reach_question *question)
{
    tdsp_status status = reach_reserve(reach, allocator, question->count);
    reach->count = 0;
    if (status != TDSP_OK) return status;
    for (uint32_t i = 0; i < question->count; ++i) {
        reach->given[i] = question->members[i];
        reach->discs[i] = reach_disc(&question->shapes[question->members[i]], question->from, question->until);
    }
    index_items items = {reach->discs, reach->given, reach->spare, question->count};
    status = index_build(&reach->index, allocator, items);
    if (status != TDSP_OK) return status;
    reach->count = question->count;
    reach->sign = question->sign;
    reach->from = question->from;
    reach->until = question->until;
    for (uint32_t i = 0; i < reach->count && reach->sign < 0.0; ++i) {
        geom_disc *disc = &reach->discs[i];
        *disc = disc_make(disc->center, disc->radius, -disc->rate);
    }
    return TDSP_OK;
}

void reach_limit(growth_reach *reach, tdsp_point goal, double limit)
{
    for (uint32_t i = 0; i < reach->count; ++i) {
        const geom_disc *disc = &reach->discs[i];
        double largest = disc_radius(disc, reach->sign * reach->until);
        if (reach->sign > 0.0 && limit > reach->until) largest = INFINITY;
        if (reach->sign > 0.0 && limit <= reach->until) {
            largest = disc_radius(disc, limit);
            /* Who meets it has the way to the goal before him. */
            largest = disc_radius(disc, limit - math_max(point_distance(disc->center, goal) - largest, 0.0));
        }
        reach->largest[i] = largest;
    }
}

void reach_free(growth_reach *reach, const tdsp_allocator *allocator)
{
    index_free(&reach->index, allocator);
    memory_free(allocator, reach->discs, reach->disc_capacity * sizeof *reach->discs);
    memory_free(allocator, reach->spare, reach->spare_capacity * sizeof *reach->spare);
    memory_free(allocator, reach->given, reach->given_capacity * sizeof *reach->given);
    memory_free(allocator, reach->largest, reach->largest_capacity * sizeof *reach->largest);
}

size_t reach_bytes(const growth_reach *reach)
{
    return index_bytes(&reach->index) + reach->disc_capacity * sizeof *reach->discs + reach->spare_capacity * sizeof *reach->spare +
           reach->given_capacity * sizeof *reach->given + reach->largest_capacity * sizeof *reach->largest;
}

static int is_within_window(const growth_reach *reach, double from, double to)
{
    double first = reach->sign > 0.0 ? from : -to, last = reach->sign > 0.0 ? to : -from;
    return first >= reach->from && last <= reach->until;
}

/* From the index's numbers to the shapes'. */
typedef struct reach_caller {
    const growth_reach *reach;
    reach_visit visit;
    void *ctx;
} reach_caller;

static int visit_given(void *ctx, uint32_t disc)
{
    const reach_caller *caller = ctx;
    return caller->visit(caller->ctx, caller->reach->given[disc]);
}

static void visit_all(reach_caller *caller)
{
    for (uint32_t i = 0; i < caller->reach->count; ++i)
        if (!visit_given(caller, i)) return;
}

void reach_line(const growth_reach *reach, const sight_line *line, double end, reach_visit visit, void *ctx)
{
    reach_caller caller = {reach, visit, ctx};
    index_view view = {&reach->index, reach->discs, reach->sign};
    geom_line motion = {line->from, line->unit, line->start, math_max(end - line->start, 0.0)};
    if (is_within_window(reach, line->start, end))
        index_line_visit(&view, &motion, INDEX_NONE, INDEX_NONE, visit_given, &caller);
    else
        visit_all(&caller);
}

void reach_near(const growth_reach *reach, tdsp_point place, double margin, double from, double to, reach_visit visit, void *ctx)
{
    reach_caller caller = {reach, visit, ctx};
    index_view view = {&reach->index, reach->discs, reach->sign};
    if (is_within_window(reach, from, to))
        index_near(&view, place, margin, reach->sign > 0.0 ? to : -from, visit_given, &caller);
    else
        visit_all(&caller);
}
