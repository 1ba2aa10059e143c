/* SPDX-License-Identifier: MIT */
/*
 * A new form is written behind the rides of all others and looked for among them: there are few forms, and most questions come from the piece
 * that was met last, so the search begins with the latest.
 */
#include "shape/forms.h"

#include <string.h>

#include "scene/allocator.h"

void forms_begin(shape_forms *self, const tdsp_allocator *allocator)
{
    memset(self, 0, sizeof *self);
    self->allocator = *allocator;
}

void forms_end(shape_forms *self)
{
    memory_free(&self->allocator, self->legs, self->leg_capacity * sizeof *self->legs);
    memory_free(&self->allocator, self->rides, self->ride_capacity * sizeof *self->rides);
    memory_free(&self->allocator, self->forms, self->capacity * sizeof *self->forms);
}

static tdsp_status forms_load_path(shape_forms *self, const tdsp_solver *solver, size_t *count)
{
    tdsp_status status = tdsp_solver_path(solver, self->legs, self->leg_capacity, count);
    if (status != TDSP_BUFFER_TOO_SMALL) return status;
    void *legs = self->legs;
    status = memory_reserve(&self->allocator, &legs, &self->leg_capacity, *count, sizeof *self->legs);
    self->legs = legs;
    return status == TDSP_OK ? tdsp_solver_path(solver, self->legs, self->leg_capacity, count) : status;
}

static tdsp_status forms_append(shape_forms *self, size_t at, const tdsp_leg *ride)
{
    void *rides = self->rides;
    tdsp_status status = memory_reserve(&self->allocator, &rides, &self->ride_capacity, at + 1, sizeof *self->rides);
    self->rides = rides;
    if (status == TDSP_OK) self->rides[at] = (tdsp_ride){ride->disc, ride->turn};
    return status;
}

/* Does the ride go on, on the same disc, while its rate changes? */
static int ride_goes_on(const tdsp_leg *leg, const tdsp_leg *next)
{
    return next->kind != TDSP_LEG_LINE && next->disc == leg->disc && next->turn == leg->turn;
}

/* The rides of the path behind those of all forms. */
static tdsp_status forms_write(shape_forms *self, size_t legs, double least, size_t *count)
{
    tdsp_status status = TDSP_OK;
    *count = 0;
    for (size_t i = 0; i < legs && status == TDSP_OK; ++i) {
        const tdsp_leg *leg = &self->legs[i];
        if (leg->kind == TDSP_LEG_LINE) continue;
        double sweep = leg->sweep;
        for (; i + 1 < legs && ride_goes_on(leg, &self->legs[i + 1]); ++i) sweep += self->legs[i + 1].sweep;
        if (sweep > least) status = forms_append(self, self->ride_count + (*count)++, leg);
    }
    return status;
}

static int form_is(const shape_forms *self, size_t form, size_t count)
{
    if (self->forms[form].count != count || count == 0) return self->forms[form].count == count;
    const tdsp_ride *one = self->rides + self->forms[form].first, *other = self->rides + self->ride_count;
    for (size_t i = 0; i < count; ++i)
        if (one[i].disc != other[i].disc || one[i].turn != other[i].turn) return 0;
    return 1;
}

tdsp_status forms_of_path(shape_forms *self, const tdsp_solver *solver, double sweep, size_t *form)
{
    size_t legs, count;
    tdsp_status status = forms_load_path(self, solver, &legs);
    if (status == TDSP_OK) status = forms_write(self, legs, sweep, &count);
    if (status != TDSP_OK) return status;
    for (size_t i = self->count; i > 0; --i) {
        if (!form_is(self, i - 1, count)) continue;
        *form = i - 1;
        return TDSP_OK;
    }
    void *forms = self->forms;
    status = memory_reserve(&self->allocator, &forms, &self->capacity, self->count + 1, sizeof *self->forms);
    self->forms = forms;
    if (status != TDSP_OK) return status;
    self->forms[self->count] = (shape_form){self->ride_count, count};
    self->ride_count += count;
    *form = self->count++;
    return TDSP_OK;
}
