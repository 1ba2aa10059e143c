/* SPDX-License-Identifier: MIT */
/* The combinatorial forms of paths, each kept once and known by a number. */
#ifndef SHAPE_FORMS_H
#define SHAPE_FORMS_H

#include "tdsp/shape.h"

typedef struct shape_form {
    size_t first; /* of its rides */
    size_t count;
} shape_form;

typedef struct shape_forms {
    tdsp_allocator allocator;
    tdsp_leg *legs; /* of the path at hand */
    size_t leg_capacity;
    tdsp_ride *rides; /* of all forms */
    size_t ride_count, ride_capacity;
    shape_form *forms;
    size_t count, capacity;
} shape_forms;

void forms_begin(shape_forms *self, const tdsp_allocator *allocator);
void forms_end(shape_forms *self);

/* The number of the form of the solver's last path: its rides that turn by more than `sweep`, neighbours on one disc and side taken together. */
tdsp_status forms_of_path(shape_forms *self, const tdsp_solver *solver, double sweep, size_t *form);

#endif
