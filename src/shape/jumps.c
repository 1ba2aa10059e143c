/* SPDX-License-Identifier: MIT */
/*
 * All jumps of A, by division of the departures.
 *
 * T never falls. So a stretch [low, high] holds jumps of T of at most T(high) - T(low+) together, and one that rises by no more than `least` holds
 * none that counts. Any other is divided. Where it is longer than it rises, at the departure in its middle, which halves its length. Where it rises
 * more than it is long, by the latest departure t for the arrival in its middle. Either A(t) is that arrival, and both parts have half the arrivals
 * of the whole; or it is earlier, and then the arrival lies inside a jump at t: that is found, and the parts on both sides of it have
 * less than half of the arrivals each. So the division ends: a stretch whose arrivals are no more than `least` rises by no more.
 */
#include <string.h>

#include "base/math.h"
#include "scene/allocator.h"
#include "shape/asked.h"

/* Of the rise of T: what `least` is where the caller does not say. */
#define DEFAULT_LEAST (1.0 / 256.0)

struct tdsp_jumps {
    tdsp_allocator allocator;
    tdsp_arrival_jump *found;
    size_t count, capacity;
};

/* What is still to be looked at, the earliest on top: a stretch from right after `low` to `high`, or a jump between them. */
typedef struct jump_task {
    shape_point low, high;
    int is_jump;
} jump_task;

typedef struct jump_search {
    asked ask;
    double least;
    jump_task *tasks;
    size_t count, capacity;
    tdsp_jumps *jumps;
} jump_search;

static tdsp_status push_task(jump_search *self, shape_point low, shape_point high, int is_jump)
{
    void *tasks = self->tasks;
    if (!(high.travel - low.travel > self->least)) return TDSP_OK;
    tdsp_status status = memory_reserve(&self->ask.allocator, &tasks, &self->capacity, self->count + 1, sizeof *self->tasks);
    self->tasks = tasks;
    if (status == TDSP_OK) self->tasks[self->count++] = (jump_task){low, high, is_jump};
    return status;
}

static tdsp_status add_jump(jump_search *self, shape_point before, shape_point after)
{
    tdsp_jumps *jumps = self->jumps;
    void *found = jumps->found;
    tdsp_arrival_jump jump = {before.departure, before.travel, after.travel, after.travel - before.travel, {0, 0, 0, {0, 0}}};
    tdsp_status status = asked_gap(&self->ask, before, &jump.gap);
    if (status == TDSP_OK) status = memory_reserve(&jumps->allocator, &found, &jumps->capacity, jumps->count + 1, sizeof jump);
    jumps->found = found;
    if (status == TDSP_OK) jumps->found[jumps->count++] = jump;
    return status;
}

/* The parts, the later first, so that the earlier is on top. A part that is no shorter than the whole is a jump that no double lies within. */
static tdsp_status divide(jump_search *self, const jump_task *whole, shape_point before, shape_point after, int jumps)
{
    int stuck = !jumps && (before.departure <= whole->low.departure || before.departure >= whole->high.departure);
    if (stuck) return push_task(self, whole->low, whole->high, 1);
    tdsp_status status = push_task(self, after, whole->high, 0);
    if (status == TDSP_OK && jumps) status = push_task(self, before, after, 1);
    return status == TDSP_OK ? push_task(self, whole->low, before, 0) : status;
}

static tdsp_status look_at(jump_search *self, const jump_task *task)
{
    shape_point before, after;
    double length = task->high.departure - task->low.departure;
    int jumps = 0;
    if (task->is_jump) return add_jump(self, task->low, task->high);
    tdsp_status status = asked_progress(&self->ask, task->low.departure);
    if (status != TDSP_OK) return status;
    if (length > task->high.travel - task->low.travel) {
        status = asked_travel(&self->ask, task->low.departure + 0.5 * length, &before);
        after = before;
    } else {
        status = asked_middle(&self->ask, task->low, task->high, &before, &after, &jumps);
    }
    return status == TDSP_OK ? divide(self, task, before, after, jumps) : status;
}

static tdsp_status search_all(jump_search *self)
{
    const tdsp_shape_options *options = &self->ask.options;
    double rise = self->ask.last.travel - self->ask.first.travel;
    self->least = options->least > 0.0 ? options->least : math_max(DEFAULT_LEAST * rise, 16.0 * asked_noise(&self->ask, self->ask.last));
    tdsp_status status = push_task(self, self->ask.first, self->ask.last, 0);
    while (status == TDSP_OK && self->count > 0) {
        jump_task task = self->tasks[--self->count];
        status = look_at(self, &task);
    }
    return status;
}

tdsp_status tdsp_jumps_find(tdsp_solver *solver, const tdsp_shape_options *options, tdsp_jumps **out)
{
    jump_search search;
    memset(&search, 0, sizeof search);
    if (!out) return TDSP_INVALID_ARGUMENT;
    tdsp_status status = asked_begin(&search.ask, solver, options);
    if (status != TDSP_OK) return status;
    search.jumps = memory_array(&search.ask.allocator, 1, sizeof *search.jumps);
    if (!search.jumps) return TDSP_NO_MEMORY;
    memset(search.jumps, 0, sizeof *search.jumps);
    search.jumps->allocator = search.ask.allocator;
    status = search_all(&search);
    memory_free(&search.ask.allocator, search.tasks, search.capacity * sizeof *search.tasks);
    if (status == TDSP_OK)
        *out = search.jumps;
    else
        tdsp_jumps_free(search.jumps);
    return status;
}

size_t tdsp_jumps_count(const tdsp_jumps *jumps)
{
    return jumps ? jumps->count : 0;
}

tdsp_status tdsp_jumps_get(const tdsp_jumps *jumps, size_t i, tdsp_arrival_jump *out)
{
    if (!jumps || !out || i >= jumps->count) return TDSP_INVALID_ARGUMENT;
    *out = jumps->found[i];
    return TDSP_OK;
}

void tdsp_jumps_free(tdsp_jumps *jumps)
{
    if (!jumps) return;
    tdsp_allocator allocator = jumps->allocator;
    memory_free(&allocator, jumps->found, jumps->capacity * sizeof *jumps->found);
    memory_free(&allocator, jumps, sizeof *jumps);
}
